"""Lesson 1: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.newton_to_state_space import held_push, impossible, motion, overwritten, three_sensors

__all__ = ["held_push", "impossible", "motion", "overwritten", "three_sensors"]
