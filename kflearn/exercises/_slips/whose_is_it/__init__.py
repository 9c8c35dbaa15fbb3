"""Lesson 26: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.whose_is_it import false_in_gate, weights, zeros

__all__ = ["false_in_gate", "weights", "zeros"]
