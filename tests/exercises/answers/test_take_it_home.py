"""Lesson 29: answers that were handed in by strangers, and what each must get."""

import numpy as np
import pytest

from tests.exercises.hand_in import assert_told


def all_read(x, P, z, H, R):
    S = H @ P @ H.T + R
    K = P @ H.T @ np.linalg.inv(S)
    return x + K @ np.nan_to_num(z - H @ x), P - K @ S @ K.T


def spread(x, P, z, H, R):
    seen = ~np.isnan(z)
    h = H[seen]
    S = h @ P @ h.T + R[seen, seen]
    K = P @ h.T @ np.linalg.inv(S)
    return x + K @ (z[seen] - h @ x), P - K @ S @ K.T


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("use_what_is_there", all_read, "the mean is pulled towards H x", "if R is not diagonal"),
    ("use_what_is_there", spread, "The block of R is `R[np.ix_(seen, seen)]`", "several sizes"),
    ("own_start", "B", 'several are handed in as a set, such as {"X", "Y"}'),
]


@pytest.mark.parametrize("row", TOLD)
def test_told(row):
    name, answer, *words = row
    assert_told(f"take_it_home.{name}", answer, *words)
