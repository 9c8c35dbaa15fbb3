"""Lesson 7: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.is_the_filter_honest import draw_start, interval, mystery, nees, share_inside

__all__ = ["draw_start", "interval", "mystery", "nees", "share_inside"]
