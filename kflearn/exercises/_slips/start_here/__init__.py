"""Lesson 0: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.start_here import (
    data_sheet,
    readings_needed,
    root_mean_square,
    three_readings,
    update_mean,
)

__all__ = ["data_sheet", "readings_needed", "root_mean_square", "three_readings", "update_mean"]
