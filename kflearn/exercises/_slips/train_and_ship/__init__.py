"""Lesson 11: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.train_and_ship import data_sheet, report, running_average, start_variance, two_point_start

__all__ = ["data_sheet", "report", "running_average", "start_variance", "two_point_start"]
