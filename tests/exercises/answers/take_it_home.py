"""Lesson 29: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def all_read(x, P, z, H, R):
    S = H @ P @ H.T + R
    K = P @ H.T @ np.linalg.inv(S)
    return x + K @ np.nan_to_num(z - H @ x), P - K @ S @ K.T


def spread(x, P, z, H, R):
    seen = ~np.isnan(z)
    h = H[seen]
    S = h @ P @ h.T + R[seen, seen]
    K = P @ h.T @ np.linalg.inv(S)
    return x + K @ (z[seen] - h @ x), P - K @ S @ K.T


def rows_of_R(x, P, z, H, R):
    seen = ~np.isnan(z)
    Hs, Rs = H[seen], R[seen]
    S = Hs @ P @ Hs.T + Rs
    K = P @ Hs.T @ np.linalg.inv(S)
    return x + K @ (z[seen] - Hs @ x), P - K @ S @ K.T


def nothing_to_return(x, P, z, H, R):
    seen = ~np.isnan(z)
    if seen.any():
        Hs, Rs = H[seen], R[seen][:, seen]
        K = P @ Hs.T @ np.linalg.inv(Hs @ P @ Hs.T + Rs)
        return x + K @ (z[seen] - Hs @ x), P - K @ Hs @ P


def number_one(x, P, z, H, R):
    seen = ~np.isnan(z)
    Hs, Rs = H[seen], R[np.ix_(seen, seen)]
    S = Hs @ P @ Hs.T + Rs
    K = P @ Hs.T @ np.linalg.inv(S)
    return x + K @ (z[seen] - Hs @ x), (1 - K @ Hs) @ P


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("use_what_is_there", all_read, "the mean is pulled towards H x", "if R is not diagonal"),
    ("use_what_is_there", spread, "The block of R is `R[np.ix_(seen, seen)]`", "several sizes"),
    ("own_start", "B", 'several are handed in as a set, such as {"X", "Y"}'),
    ("use_what_is_there", rows_of_R, "Both go", "raised an error"),
    ("use_what_is_there", nothing_to_return, "your function returns nothing"),
    ("use_what_is_there", number_one, "I is the identity matrix"),
    ("own_start", {"A": 25, "B": 0, "C": 50, "D": -25, "E": 0}, "Letters are wanted", "A letter"),
]
