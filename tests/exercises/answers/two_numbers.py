"""Lesson 2: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np
from scipy.stats import chi2

F, K, means = np.array([[1.0, 1.0], [0.0, 1.0]]), np.array([[0.8], [0.1]]), np.arange(5.0)


def from_the_first(x, y):
    dx, dy = x - np.asarray(x)[0], y - np.asarray(y)[0]
    return np.array([[np.mean(dx * dx), np.mean(dx * dy)], [np.mean(dx * dy), np.mean(dy * dy)]])


def corner_alone(x, y):
    c = np.mean((x - x.mean()) * (y - y.mean()))
    return np.array([[np.mean(x * x), c], [c, np.mean(y * y)]])


def between_the_shares(share):
    return np.interp(share, [0, 0.395, 0.864, 0.949, 0.989], [0, 1, 2, 2.45, 3])


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("scale_for", lambda share: 0.0, "does not depend on share", "stretched"),
    ("table_length", 1.8, "one variance less the corner"),
    ("table_of", lambda x, y: np.cov(means, means), "does not depend on x and y"),
    ("scale_for", lambda share: np.sqrt(2 * np.log(1 - share)), "The result is NaN"),
    ("scale_for", lambda share: np.sqrt(2 * np.log(1 - share) + 0j), "The result is complex", "stretched"),
    ("told_speed", 12.0, "adds 0.667 m/s for each of the 3 m"),
    ("scale_for", lambda share: 2.45 * np.sqrt(share), "was expected"),
    ("scale_for", lambda share: 2.45 * share / 0.95, "k is not proportional to the share"),
    ("table_of", from_the_first, "distances from the first pair"),
    ("table_of", corner_alone, "On the diagonal stand the means of x² and y²"),
    ("table_length", 3 * np.sqrt(1 - 0.8), "what one reading does not share"),
    ("table_length", np.sqrt(18) * (1 - 0.8), "a fifth of the σ of independent readings"),
    ("table_length", np.sqrt(0.8 * (9 + 9)), "twice the corner, 7.2"),
    ("told_speed", 10 + 6 / 13 * 63, "with the whole position"),
    ("scale_for", lambda share: np.sqrt(-2 * np.log((1 - share) / 2)), "(1 − share)/2 outside"),
    ("scale_for", lambda share: chi2.ppf(share, 2) / 2, "That is k²/2"),
    ("scale_for", between_the_shares, "as if straight lines joined"),
]
