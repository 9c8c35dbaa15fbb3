"""Lesson 6: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def detrended(readings):
    k = np.arange(len(readings))
    return np.var(readings - np.polyval(np.polyfit(k, readings, 9), k))


def sigma_of_a_ratio():
    q = 0.1 / 0.5
    return np.sqrt((np.sqrt(q**2 + 4 * q) - q) / 2 * 0.25)


RIGHT = [
    ("R_with_drift", lambda r: np.mean(abs(np.diff(r))) ** 2 * np.pi / 4),
    ("R_with_drift", lambda r: (1.4826 * np.median(abs(np.diff(r)))) ** 2 / 2),
    ("steady_sigma", 0.213),
    ("R_with_drift", lambda r: np.mean(np.diff(r, n=2) ** 2) / 6),
    ("R_with_drift", lambda r: np.var(np.diff(r, 2)) / 6),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("which_knob", "A, then C", "C is enough"),
    ("R_with_drift", lambda z: np.mean(np.diff(z) ** 2), "Halve it", "Nearly"),
    ("steady_sigma", 0.301, "Either K is not divided by 2"),
    ("data_sheets", [0.09, 6.25, 0.0208], "in another order"),
    ("data_sheets", [2.5, 0.09, 0.0625], "(b) is right. In (a) the sheet gives σ"),
    ("which_knob", {"C", "E"}, "C is enough"),
    ("R_with_drift", detrended, "You took a polynomial away"),
    ("which_knob", "none", "One of the five is right"),
    ("steady_sigma", 0.05**0.5, "√(QR)"),
    ("data_sheets", [56.2, 0.09, 0.0208], "56.2 is (3 · 2.5)²"),
    ("data_sheets", [6.25, 0.12, 0.0208], "0.12 is 0.6²/3"),
    ("data_sheets", [3, 0.04, 0.0208], "as if 0.6 °C were 3σ"),
    ("data_sheets", [6.25, 0.2, 0.0208], "halve the 0.6 °C first"),
    ("steady_sigma", sigma_of_a_ratio(), "the ratio of two σ"),
    ("steady_sigma", np.sqrt((0.01 + np.sqrt(0.0101)) / 2 + 0.25), "the σ of the innovation"),
    ("data_sheets", [6.25, 0.09, 0.0], "would make a rounded reading exact"),
    ("R_with_drift", lambda z: np.mean(np.abs(np.diff(np.square(z)))) / 2, "differences of *squares*"),
    ("steady_sigma", np.sqrt(0.0452 + 0.01), "That is σ before a reading"),
    ("which_knob", 9, "answer with a letter"),
    ("which_knob", {"A", "E"}, "One letter is enough, and it is none of these"),
    ("R_with_drift", lambda r: np.mean(np.diff(r)) ** 2 / 2, "You took the mean first"),
]
