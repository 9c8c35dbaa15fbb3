"""Lesson 0: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

F, K, means = np.array([[1.0, 1.0], [0.0, 1.0]]), np.array([[0.8], [0.1]]), np.arange(5.0)


RIGHT = [
    ("three_readings", 62.9999999),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("data_sheet", 1.73, "6/√12"),
    ("three_readings", 61 + 62 + 66 / 3, "Put brackets around the sum"),
    ("three_readings", 62.3, "add up to 186.9 m"),
    ("readings_needed", 70, "2/√n is 0.239 m"),
    ("data_sheet", 7, "σ is its root, 2.65 m"),
    ("root_mean_square", lambda e: np.sqrt(np.sum(e**2) / 5000), "follows how many numbers come in"),
    ("root_mean_square", lambda e: np.sqrt(np.mean(means**2)), "does not depend on error"),
    ("readings_needed", 3, "The square of 8 is wanted"),
    ("readings_needed", 16, "2²/0.25 takes the 0.25 m for a variance"),
    ("three_readings", 63.75, "counts as much as the other two"),
    ("three_readings", np.sqrt(np.mean(np.array([61, 62, 66]) ** 2)), "the root of the mean square"),
    ("three_readings", (61 * 62 * 66) ** (1 / 3), "the geometric mean"),
    ("readings_needed", np.log2(2 / 0.25), "Three halvings lead from 2 m to 0.25 m"),
    ("root_mean_square", lambda error: np.mean(np.square(error)) ** 1 / 2, "half of the mean square"),
    ("readings_needed", (4 / 0.25) ** 2, "the variance, 2² = 4, where σ"),
    ("three_readings", 62.9, "too low"),
    ("three_readings", 63.1, "too high"),
    ("three_readings", 62.99, "too low"),
    ("data_sheet", 81, "is the square of what is wanted. Is there a square too many"),
    ("readings_needed", int((2 / 0.25) ** 2) + 1, "n − 1 belongs to a variance"),
    ("readings_needed", None, "`print(…)` shows a value and returns None"),
]
