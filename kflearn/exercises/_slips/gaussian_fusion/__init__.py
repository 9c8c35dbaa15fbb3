"""Lesson 4: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.gaussian_fusion import common_cause, fuse, published_claim, readings_needed, third_opinion

__all__ = ["common_cause", "fuse", "published_claim", "readings_needed", "third_opinion"]
