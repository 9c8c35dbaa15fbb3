"""Lesson 9: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.readings_that_lie import agreeing, gated_step, is_refused, steps_shut

__all__ = ["agreeing", "gated_step", "is_refused", "steps_shut"]
