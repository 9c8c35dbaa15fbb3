"""Lesson 19: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.ball_in_a_video import coast, first_velocity, gravity, true_radius

__all__ = ["coast", "first_velocity", "gravity", "true_radius"]
