"""Lesson 22: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.adaptive import matrix_R, mixture_cov, moved_or_noisy, weigh, window_needed

__all__ = ["matrix_R", "mixture_cov", "moved_or_noisy", "weigh", "window_needed"]
