"""Lesson 28: what several exercises' wrong answers are made of."""

CONSTANT_GAIN, SLOW_GAIN = 0.2207, 0.15
