"""Lesson 12: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def with_trace(measure):
    return lambda one, two: min(one @ one.T, two @ two.T, key=measure)


RIGHT = [
    ("posterior", with_trace(np.linalg.det)),
    ("posterior", with_trace(np.linalg.norm)),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("average_nees", lambda P, K, R, claim: ((1 - K**2) * P + K**2 * R) / claim, "You squared the K alone"),
    ("posterior", with_trace(lambda P: P[0, 0]), "the first state only"),
    ("posterior", lambda one, two: sorted([one @ one.T, two @ two.T], key=np.trace), "but it is a list of 2 items"),
]
