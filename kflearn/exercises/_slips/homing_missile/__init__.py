"""Lesson 16: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.homing_missile import false_range, figures, left_over, memory, start_sigma

__all__ = ["false_range", "figures", "left_over", "memory", "start_sigma"]
