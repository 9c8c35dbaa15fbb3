"""Lesson 12: wrong answers to its exercises, a module each."""

from kflearn.exercises._slips.numerics import average_nees, orders_of_the_root, posterior

__all__ = ["average_nees", "orders_of_the_root", "posterior"]
