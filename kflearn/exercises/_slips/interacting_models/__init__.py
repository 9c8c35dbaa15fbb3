"""Lesson 18: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.interacting_models import blended_sigma, mended_start, transition, wrong_push

__all__ = ["blended_sigma", "mended_start", "transition", "wrong_push"]
