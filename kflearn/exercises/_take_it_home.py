"""Wrong answers to exercises of lesson 29, each with the sentence that it gets."""

import itertools

import numpy as np

from kflearn.exercises._turns import in_turn


def half_readings():
    """Inputs for a correction: two or three numbers, of which some, none or all are missing; their errors have something in common."""
    gaps = itertools.cycle(([False, True], [True, False, False], [False, False], [True, True], [False, True, True]))

    def make(rng, n):
        missing = np.array(next(gaps))
        m = len(missing)
        root, noise = rng.integers(-2, 3, (n, n)) / 2, rng.integers(-2, 3, (m, m)) / 2
        z = np.where(missing, np.nan, rng.integers(-9, 10, m) / 2)
        H = rng.integers(-2, 3, (m, n)) + 0.5
        return rng.integers(-9, 10, n) / 2, root @ root.T + np.eye(n), z, H, noise @ noise.T + np.eye(m)

    return in_turn(make, 2, 3)
