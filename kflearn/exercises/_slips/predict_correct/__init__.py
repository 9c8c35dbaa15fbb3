"""Lesson 3: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.predict_correct import (
    correct,
    misprints,
    predicted_covariance,
    printed_position,
    speedometer,
)

__all__ = ["correct", "misprints", "predicted_covariance", "printed_position", "speedometer"]
