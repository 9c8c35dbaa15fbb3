"""What wrong answers to exercises of several lessons are made of."""

import numpy as np


def table(a, b, c, d):
    """A matrix (2, 2)."""
    return np.array([[a, b], [c, d]])
