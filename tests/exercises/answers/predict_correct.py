"""Lesson 3: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def old_innovation(x, P, z, F, H, Q, R):
    ahead = F @ P @ F.T + Q
    K = ahead @ H.T @ np.linalg.inv(H @ ahead @ H.T + R)
    return F @ x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ ahead


F, K, means = np.array([[1.0, 1.0], [0.0, 1.0]]), np.array([[0.8], [0.1]]), np.arange(5.0)

eye = np.eye

inv = np.linalg.inv


def predicts_again(x, P, z, H, R):
    x, P = F @ x, F @ P @ F.T
    K = P @ H.T @ inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (eye(len(x)) - K @ H) @ P


def a_known_gain(x, P, z, H, R):
    return x + K @ (z - H @ x), (eye(len(x)) - K @ H) @ P


def turned_over(x, P, z, H, R):
    K = P @ H.T @ (1 / (H @ P @ H.T + R))
    return x + K @ (z - H @ x), (eye(len(x)) - K @ H) @ P


def step(x, P, z, F, H, Q, R, identity=None, times=1):
    x, P = F @ x, F @ P @ F.T + times * Q
    K = P @ H.T @ inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), ((np.eye(len(x)) if identity is None else identity) - K @ H) @ P


def fixed_size(x, P, z, F, H, Q, R):
    return step(x, P, z, F, H, Q, R, np.eye(2))


def two_steps():
    F, P = np.array([[1, 1], [0, 1]]), np.array([[2, 1], [1, 3]])
    for _ in range(2):
        P = F @ P @ F.T + np.diag([4, 1])
    return P.tolist()


def variances(x, P, z, H, R):
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), np.diag(np.diag((np.eye(len(x)) - K @ H) @ P))


def P_first(x, P, z, H, R):
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    P = (np.eye(len(x)) - K @ H) @ P
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), P


def first_reading(x, P, z, H, R):
    h = H[:1]
    K = P @ h.T / (h @ P @ h.T + R[:1, :1])
    return x + K @ (z[:1] - h @ x), (np.eye(len(x)) - K @ h) @ P


def Q_last(x, P, z, F, H, Q, R):
    x, P = F @ x, F @ P @ F.T
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P + Q


def Q_inside(x, P, z, F, H, Q, R):
    x, P = F @ x, F @ P @ F.T
    K = P @ H.T @ np.linalg.inv(H @ (P + Q) @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


def corrected(x, P, z, H, R, R_gain=1, expected=None):
    K = P @ H.T @ inv(H @ P @ H.T + R_gain * R)
    return x + K @ (z - (H @ x if expected is None else expected)), (np.eye(len(x)) - K @ H) @ P


def without_H(x, P, z, H, R):
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    x_new = x + K @ (z - H @ x)
    P_new = (np.eye(len(x)) - K) @ P
    return x_new, P_new


def from_the_first_entry(x, P, z, H, R):
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - x[0]), (np.eye(len(x)) - K @ H) @ P


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("correct", from_the_first_entry, "you took x[0] away from z"),
    ("misprints", old_innovation, "with x_pred = F @ x", "must be F @ x"),
    ("printed_position", "ABD", "turns it into a step of 4 m"),
    ("printed_position", "AD", "only 0.5 m is wanted"),
    ("speedometer", 66, "Only K₁ times the innovation of 3 m/s is to be added"),
    ("correct", predicts_again, "reads `F`, which is a name of the notebook"),
    ("correct", a_known_gain, "reads `K`, which is a name of the notebook"),
    ("correct", turned_over, "`1 / …` turns over each entry"),
    ("misprints", fixed_size, "`np.eye(2)` has a fixed size"),
    ("misprints", lambda *a: step(*a, times=2), "Q is added twice"),
    ("predicted_covariance", [[16, 7], [7, 4]], "with dt² = 4"),
    ("printed_position", "ABCD", "A and B and C and D together end at"),
    ("predicted_covariance", two_steps(), "what two steps of 1 s make"),
    ("correct", variances, "the corners of (I − K H) P are gone"),
    ("correct", P_first, "made of the *new* P"),
    ("correct", first_reading, "the first number of z alone"),
    ("speedometer", 60 + 6 / np.sqrt(20 * 4) * 3, "0.671 is the correlation"),
    ("speedometer", 60 + 6 / 5 * (13 - 60), "It is also 60 + K₁ · (13 − 60)"),
    ("misprints", Q_last, "is added after the correction"),
    ("misprints", Q_inside, "in the inverse of line three only"),
    ("correct", lambda x, P, z, H, R: corrected(x, P, z, H, R, expected=x[: len(z)]), "you took x away from z"),
    ("correct", lambda x, P, z, H, R: corrected(x, P, z, H, R, R_gain=1e-13), "R is missing in your gain"),
    ("correct", without_H, "H must come first", "raised an error"),
    ("printed_position", ({"A", "B", "C"}, {"A", "C"}), "Letters are wanted"),
]
