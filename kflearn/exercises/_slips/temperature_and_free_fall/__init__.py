"""Lesson 10: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.temperature_and_free_fall import honest_report, mended_step, noise, room_filter, suspect

__all__ = ["honest_report", "mended_step", "noise", "room_filter", "suspect"]
