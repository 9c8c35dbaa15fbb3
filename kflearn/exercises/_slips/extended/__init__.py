"""Lesson 14: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.extended import both_humps, mended_prediction, true_starts, winner

__all__ = ["both_humps", "mended_prediction", "true_starts", "winner"]
