"""Lesson 2: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.two_numbers import scale_for, table_length, table_of, told_speed

__all__ = ["scale_for", "table_length", "table_of", "told_speed"]
