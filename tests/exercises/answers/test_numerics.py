"""Lesson 12: answers that were handed in by strangers, and what each must get."""

import numpy as np
import pytest

from tests.exercises.hand_in import assert_right, assert_told


def with_trace(measure):
    return lambda one, two: min(one @ one.T, two @ two.T, key=measure)


RIGHT = [
    ("posterior", with_trace(np.linalg.det)),
    ("posterior", with_trace(np.linalg.norm)),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("average_nees", lambda P, K, R, claim: ((1 - K**2) * P + K**2 * R) / claim, "You squared the K alone"),
    ("posterior", with_trace(lambda P: P[0, 0]), "the first state only"),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right(name, answer):
    assert_right(f"numerics.{name}", answer)


@pytest.mark.parametrize(("name", "answer", "words"), TOLD)
def test_told(name, answer, words):
    assert_told(f"numerics.{name}", answer, words)
