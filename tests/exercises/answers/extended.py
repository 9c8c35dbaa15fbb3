"""Lesson 14: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def drawn_anew(mean, P0, normal):
    return np.random.default_rng().multivariate_normal(mean, P0, len(normal))


RIGHT = [
    ("winner", "the LKF"),
    ("true_starts", lambda mean, P0, normal: mean - normal * np.sqrt(np.diag(P0))),
    ("true_starts", lambda mean, P0, normal: mean + normal @ np.linalg.cholesky(P0)),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("both_humps", (4.4, 11), "11 is the distance of each hump from zero", "11.05"),
    ("both_humps", (4.4, 11.05), "11.05 is √(11² + 1)", "half their distance"),
    ("winner", "UKF", "is not one of the two", "among the choices"),
    ("winner", "no difference in the median run", "In it the bad runs count"),
    ("winner", "neither", "There was a difference"),
    ("winner", "UKF", "The unscented filter is not one of the two"),
    ("winner", 2, "A word is wanted"),
    ("true_starts", lambda mean, P0, normal: mean + normal * np.sqrt(P0), "is a matrix"),
    ("both_humps", (4.4, np.sqrt(0.58)), "with squared weights"),
    ("true_starts", lambda mean, P0, n: mean * (1 + np.sqrt(np.diag(P0)) * n), "multiplied the scatter by the mean"),
    ("true_starts", drawn_anew, "Use those in `normal`"),
    ("both_humps", (4.4, 11), "half their distance from each other"),
    ("both_humps", (4.4, 9.8), "add 1, then the root"),
    ("mended_prediction", lambda x, P, u: (x, P * u), ""),
]
