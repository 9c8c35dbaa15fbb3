"""Lesson 8: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.bearing_of_a_sound import is_a_covariance, offset, right_prediction, right_update, wrap

__all__ = ["is_a_covariance", "offset", "right_prediction", "right_update", "wrap"]
