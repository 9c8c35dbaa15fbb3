"""Lesson 21: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.consider_filter import economical, first_covariance, honest_average, inflated, late_row

__all__ = ["economical", "first_covariance", "honest_average", "inflated", "late_row"]
