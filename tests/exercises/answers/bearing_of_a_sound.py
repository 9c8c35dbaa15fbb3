"""Lesson 8: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def symmetric_first(P, Q, dt):
    F = np.array([[1, dt], [0, 1]])
    return F @ (P + P.T) / 2 @ F.T + Q


def two_states(P):
    alike = abs(P[0, 1] - P[1, 0]) < 1e-8
    return alike and P[0, 0] >= 0 and P[1, 1] >= 0 and P[0, 0] * P[1, 1] >= P[0, 1] ** 2


eig = np.linalg.eigvalsh


def cholesky(P):
    try:
        np.linalg.cholesky(P)
    except np.linalg.LinAlgError:
        return False
    return np.allclose(P, P.T)


def entry_by_entry(P, Q, dt):
    return np.array([[P[0, 0] + dt * P[1, 0], P[0, 1] + dt * P[1, 1]], [dt * P[1, 0], P[1, 1]]]) + Q


def without_a_corner(P, Q, dt):
    F = np.array([[1, dt], [0, 1]])
    M = F @ P @ F.T
    M[1, 0] = dt * P[1, 1]
    return M + Q


def overwritten(P, Q, dt):
    M = np.array(P, dtype=float)
    M[0, 1] += dt * M[1, 1]
    M[1, 0] += dt * M[1, 1]
    M[0, 0] += dt * (M[0, 1] + M[1, 0]) + dt**2 * M[1, 1]
    return M + Q


def one_matrix(P):
    return not np.allclose(P, [[1.03, 0.7], [0.02, 0.51]])


def turns_by_hand(d):
    return (d + 1980) - 360 * int((d + 1980) / 360) - 180


def symmetric(P, Q, dt):
    a = P[0, 0] + 2 * dt * P[0, 1] + dt**2 * P[1, 1]
    return np.array([[a, P[0, 1] + dt * P[1, 1]], [P[1, 0] + dt * P[1, 1], P[1, 1]]]) + Q


def corner_mended(P, Q, dt):
    return np.array(
        [
            [P[0, 0] + dt * P[1, 0] + Q[0, 0], P[0, 1] + P[1, 1] + Q[0, 1]],
            [P[1, 0] + P[1, 1] + Q[1, 0], P[1, 1] + Q[1, 1]],
        ]
    )


def second_column(P, K):
    return P * np.array([[1 - K[0], 1 - K[0]], [1 - K[1], 1 - K[0]]])


RIGHT = [
    ("is_a_covariance", lambda P: (abs(P - P.T) <= 1e-9).all() and (eig(P) >= 0).all()),
    ("is_a_covariance", lambda P: np.allclose(P, P.T) and np.linalg.eigvals(P).min() > -1e-9),
    ("is_a_covariance", lambda P: cholesky(P + 1e-9 * np.eye(len(P)))),
    ("wrap", lambda d: np.degrees(np.angle(np.exp(1j * np.radians(d))))),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("wrap", lambda d: (d + 180) % 180 - 180, "the result is never above 0"),
    ("wrap", lambda d: [int((d + 180) % 360 - 180)], "For `difference = 1129.5` the result is 49"),
    ("right_prediction", symmetric_first, "but you made P, or the result, symmetric", "and then"),
    ("is_a_covariance", two_states, "of which only the first two states are symmetric", "had to"),
    ("wrap", lambda d: np.degrees(np.arctan2(np.sin(d), np.cos(d))), "taken for radians"),
    ("wrap", lambda d: np.clip(d, -180, 180), "You cut the difference off"),
    ("offset", lambda x1, K, dt: dt * x1 * (1 / K - K), "1/K − 1"),
    ("right_prediction", entry_by_entry, "The lower left is still as published"),
    ("right_update", lambda P, K: (1 - np.outer(K, [1, 0])) @ P, "full of ones"),
    ("right_update", lambda P, K: (np.eye(2) - K * np.array([1, 0])) @ P, "entry by entry"),
    ("is_a_covariance", cholesky, "You refuse diag(1, 0)"),
    ("is_a_covariance", lambda P: (P == P.T).all() and eig(P).min() >= -1e-9, "That is rounding"),
    ("is_a_covariance", lambda P: abs((P - P.T).sum()) < 1e-9 and eig(P).min() >= -1e-9, "plus and minus cancel"),
    ("is_a_covariance", lambda P: np.allclose(P, P.T) or eig(P).min() >= 0, "Both must hold"),
    ("offset", lambda x1, K, dt: dt * x1 * (1 - K) / (1 + K), "Below the line stands 1 + K"),
    ("right_prediction", without_a_corner, "In the lower left P₁₀ itself is missing"),
    ("is_a_covariance", np.linalg.eigvalsh, "should be True or False, but it is an array"),
    ("right_prediction", overwritten, "dt²·P₁₁ counts three times"),
    ("right_update", lambda P, K: P, "the gain of the angle goes towards 1"),
    ("is_a_covariance", one_matrix, "You look for one matrix"),
    ("wrap", turns_by_hand, "trials"),
    ("right_prediction", symmetric, "need not be symmetric"),
    ("right_prediction", corner_mended, "yours get P₁₁ without dt"),
    ("right_update", second_column, "made of the *first* row"),
]
