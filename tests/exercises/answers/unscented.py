"""Lesson 17: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def symmetric_root(mean, P, Q, scale):
    w, V = np.linalg.eigh(scale * (P + Q))
    L = (V * np.sqrt(w)) @ V.T
    return np.vstack([mean, mean + L, mean - L])


def with_the_weights_of_the_covariance():
    Wm = np.array([2 / 3, 1 / 6, 1 / 6])
    Wc = Wm + np.array([1 - 1**2 + 2, 0, 0])
    return Wc @ (100 * np.sin(np.radians(np.array([90, 90 + 30 * np.sqrt(3), 90 - 30 * np.sqrt(3)]))))


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("three_points", 96, "gives the centre the weight 0.896"),
    ("three_points", 40, "between the smallest and the largest image"),
    ("three_points", 100 - 87.2, "how far the mean sinks"),
    ("three_points", 100 * np.cos(np.pi / 2), "along the x-axis"),
    ("declared_kappa", (1, 10), "that would be right for n = 2"),
    ("declared_kappa", (-5, -8), "which is λ itself"),
    ("declared_kappa", (-1, 9), "3 for α = 1 and 3.25 for α = ½"),
    ("start_nees", 700, "More than 6 would mean"),
    ("start_nees", 0.5, "the sum is at most 0.06"),
    ("start_nees", 0.035, "between 0.04 and 0.06"),
    ("declared_kappa", (-1, -4), "−4 is λ/α²"),
    ("declared_kappa", (-3, 6), "6 would be right for n = 6"),
    ("redrawn", symmetric_root, "the symmetric root"),
    ("redrawn", lambda m, P, Q, s: np.linalg.cholesky(s * (P - Q)), "You took Q off P"),
    ("start_nees", 0.0599, "quotient of the two sums of variances"),
    ("start_nees", 0.06, "0.06 is six times 1/100"),
    ("three_points", with_the_weights_of_the_covariance(), "the weights of the covariance, Wc"),
]
