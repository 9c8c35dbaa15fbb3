"""Lesson 20: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.error_state_navigation import all_bias, dark_time, goes_back, mended_fix

__all__ = ["all_bias", "dark_time", "goes_back", "mended_fix"]
