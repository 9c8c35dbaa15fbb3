"""Lesson 23: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def Q_first(x, P, F, Q, x_next, P_next):
    P_minus = F @ (P + Q) @ F.T
    G = P @ F.T @ np.linalg.inv(P_minus)
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_minus) @ G.T


def stars(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    mean = x + G @ (x_next - F @ x)
    cov = P + G**2 * (P_next - P_pred)
    return mean, cov


def more_certain(P, P_back):
    if np.linalg.det(P) < np.linalg.det(P_back):
        return P
    return P_back


def after_the_fusion(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back)
    m = V * (x / P + x_back / P_back)
    V_new = 1 / (1 / V - 1 / R)
    return m - V_new / R * z, V_new


def one_correction_undone(x, P, x_back, P_back, z, R):
    V = 1 / (1 / P + 1 / P_back)
    mean = V * (x / P + x_back / P_back)
    return mean - V / R * (z - mean), V + V**2 / R


inv = np.linalg.inv


def P_next_in_the_gain(x, P, F, Q, x_next, P_next):
    ahead = F @ P @ F.T + Q
    G = P @ F.T @ inv(P_next)
    return x + G @ (x_next - F @ x), P + G @ (P_next - ahead) @ G.T


def R_off_P_back(x, P, x_back, P_back, z, R):
    Pb = P_back - R
    information = 1 / P + 1 / Pb
    return (x / P + x_back / Pb) / information, 1 / information


def no_Q_in_the_gain(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ inv(F @ P @ F.T)
    return x + G @ (x_next - F @ x), P + G @ (P_next - F @ P @ F.T - Q) @ G.T


RIGHT = [
    ("smoothed_cov", lambda P, P_back: P @ inv(P + P_back) @ P_back),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("smoothed_cov", lambda P, back: np.linalg.inv(np.linalg.inv(P) + back), "Both are inverted"),
    (
        "smoothed_cov",
        lambda P, back: 2 * np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(back)),
        "mean of the two inverses",
    ),
    ("real_gap", "none", "About two standard errors are a weak sign", "among the choices"),
    ("one_step_back", (6 + 0.75 * (4 - 6), 2 + 0.75**2 * (3 - 4)), "begins with N(6, 2)"),
    ("step_back", Q_first, "as if P⁻ were F (P + Q) Fᵀ"),
    ("step_back", stars, "the square of an entry of G"),
    ("smoothed_cov", more_certain, "whichever of the two has the smaller determinant"),
    ("count_once", after_the_fusion, "the fused mean keeps its old weights"),
    ("count_once", one_correction_undone, "as if z were undone with the gain V/R"),
    ("one_step_back", (4.8, 2.9), "moved by 0.4 times 6 − 4"),
    ("one_step_back", (5.5, 2.6), "Your variance is 3 and -0.4 more"),
    ("real_gap", -0.032, "That is the difference in ppm"),
    ("real_gap", 0.39 / 0.43, "The ratio is right"),
    ("real_gap", "none", "One of the three is right"),
    ("one_step_back", (5.5, 0.75), "known exactly"),
    ("step_back", P_next_in_the_gain, "divides by P_next"),
    ("smoothed_cov", lambda P, P_back: P @ P_back @ inv(P + P_back), "The order counts"),
    ("count_once", R_off_P_back, "You subtracted R from P_back"),
    ("step_back", no_Q_in_the_gain, "Your gain is F⁻¹"),
    ("one_step_back", (6, 1), "right for G = 1"),
    ("smoothed_cov", lambda P, B: 1 / (1 / P + 1 / B), "entry by entry"),
    ("real_gap", 7.4, "About 7 % is the difference"),
    ("real_gap", "a little smaller, by less than a tenth", "A letter alone is wanted", "not among"),
    (
        "count_once",
        lambda x, P, x_back, P_back, z, R: (
            (x / P + x_back * (1 / P_back - 1 / R)) / (1 / P + 1 / P_back - 1 / R),
            1 / (1 / P + 1 / P_back - 1 / R),
        ),
        "It keeps its full weight",
    ),
]
