"""Lesson 28: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.history import behind, exponential_weights, mended, newest_ten, undisturbed

__all__ = ["behind", "exponential_weights", "mended", "newest_ten", "undisturbed"]
