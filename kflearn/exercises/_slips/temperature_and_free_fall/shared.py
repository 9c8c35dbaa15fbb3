"""Lesson 10: what several exercises' wrong answers are made of."""

import numpy as np


def step(x, P, reading, Q, R):
    """One step of the random walk's filter: the estimate, its variance, its predicted variance."""
    predicted = P + Q
    K = predicted / (predicted + R)
    return x + K * (reading - x), (1 - K) * predicted, predicted


def loop(x, P, z, Q, R):
    """The random walk's filter from a given start."""
    for reading in z:
        x, P, _ = step(x, P, reading, Q, R)
    return x, P


def started(x, P, readings, gain="R", stop=None):
    """The room's filter from some start over some of the readings."""

    def last(z, Q, R):
        level, var = {"z0": z[0], "0": 0.0, "mean": np.mean(z), "last": z[-1]}[x], P(Q, R)
        for reading in z[{"rest": 1, "all": 0, "two": 2}[readings] :][:stop]:
            var = var + Q
            K = {"R": var / (var + R), "Q": var / (var + Q), "σ": var**0.5 / (var**0.5 + R**0.5)}[gain]
            level, var = level + K * (reading - level), (1 - K) * var
        return level, var

    return last
