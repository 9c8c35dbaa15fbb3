"""Lesson 24: what several exercises' wrong answers are made of."""

import numpy as np


def bridged(z):
    """Straight lines in the gaps."""
    k, seen = np.arange(len(z)), ~np.isnan(z)
    return np.interp(k, k[seen], z[seen])
