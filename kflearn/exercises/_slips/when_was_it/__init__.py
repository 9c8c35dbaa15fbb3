"""Lesson 25: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.when_was_it import behind, clock_offset, which_step

__all__ = ["behind", "clock_offset", "which_step"]
