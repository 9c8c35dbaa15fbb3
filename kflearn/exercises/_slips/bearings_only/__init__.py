"""Lesson 15: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.bearings_only import bearing_variance, mended_bearing, review, twin_velocity

__all__ = ["bearing_variance", "mended_bearing", "review", "twin_velocity"]
