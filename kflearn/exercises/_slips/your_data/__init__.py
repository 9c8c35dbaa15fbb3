"""Lesson 27: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.your_data import clock, interval_of_R, milliseconds_for_seconds, variance_at_rest

__all__ = ["clock", "interval_of_R", "milliseconds_for_seconds", "variance_at_rest"]
