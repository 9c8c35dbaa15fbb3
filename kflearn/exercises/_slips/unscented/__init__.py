"""Lesson 17: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.unscented import declared_kappa, redrawn, start_nees, three_points

__all__ = ["declared_kappa", "redrawn", "start_nees", "three_points"]
