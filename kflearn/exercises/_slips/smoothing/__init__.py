"""Lesson 23: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.smoothing import count_once, one_step_back, real_gap, smoothed_cov, step_back

__all__ = ["count_once", "one_step_back", "real_gap", "smoothed_cov", "step_back"]
