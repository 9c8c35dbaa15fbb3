"""Lesson 13: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.linearised_and_extended import (
    into_the_plane,
    linearised_correction,
    mended_slope,
    widest_belief,
)

__all__ = ["into_the_plane", "linearised_correction", "mended_slope", "widest_belief"]
