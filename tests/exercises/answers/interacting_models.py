"""Lesson 18: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def two_seconds(stays, T):
    T = 2
    q = T / np.asarray(stays, float)
    return np.diag(1 - q) + (1 - np.eye(len(stays))) * q[:, None] / (len(stays) - 1)


def samples_for_runs(z, T):
    speed = (z[:, 1] - z[:, 0]) / T
    return z[0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def between_runs(z, T):
    speed = np.diff(z[:, 1], axis=0, prepend=z[:1, 0]) / T
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


RIGHT = [
    ("wrong_push", "no effect"),
]


def as_a_belief(z, T):
    speed = (z[:, 1] - z[:, 0]) / T
    state = np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)
    return state, np.kron(np.eye(2), [[1e4, 5e3], [5e3, 5e3]])


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("mended_start", as_a_belief, "should be an array of shape", "fixed size"),
    ("wrong_push", "twice as large", "By no factor", "among the choices"),
    ("blended_sigma", 20, "wider than each of the two"),
    ("blended_sigma", 56, "900 m² and 2236 m² more"),
    ("wrong_push", "a little smaller", "Not even a little"),
    ("wrong_push", "smaller in turns, larger on the straight", "does not depend on turns"),
    ("blended_sigma", np.sqrt(4100), "3200 m² is the sum of the two squared distances"),
    ("transition", two_seconds, "right for readings every 2 s"),
    ("mended_start", samples_for_runs, "`z[0]` is run 1"),
    ("wrong_push", "bigger", "Mending does no harm"),
    ("mended_start", between_runs, "second reading of the run *before* is subtracted"),
    ("wrong_push", "the error becomes smaller", "One might expect", "not among"),
]
