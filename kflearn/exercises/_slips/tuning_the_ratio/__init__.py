"""Lesson 6: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.tuning_the_ratio import R_with_drift, data_sheets, steady_sigma, three_sigma, which_knob

__all__ = ["R_with_drift", "data_sheets", "steady_sigma", "three_sigma", "which_knob"]
