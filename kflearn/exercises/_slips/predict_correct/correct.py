"""Lesson 3, `correct`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.predict_correct.shared import WRONG_STEPS, corrected


def outside(x, P, z, H, R):
    """R is added to the gain."""
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T) + R
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


def one_row_for_each_reading(x, P, z, H, R):
    K = H @ P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


def variances_alone(x, P, z, H, R):
    x, P = corrected(x, P, z, H, R)
    return x, np.diag(np.diag(P))


def gain_of_the_new_P(x, P, z, H, R):
    after = corrected(x, P, z, H, R)[1]
    return corrected(x, after, z, H, R)[0], after


WRONG = WRONG_STEPS | {
    "R for the new P": (
        lambda x, P, z, H, R: (x + P @ H.T @ np.linalg.inv(H @ P @ H.T + R) @ (z - H @ x), R),
        "Your x is right. You returned R, which belongs to the measurement; the new P is (I − K H) P.",
    ),
    "x alone": (
        lambda x, P, z, H, R: x + P @ H.T @ np.linalg.inv(H @ P @ H.T + R) @ (z - H @ x),
        "Your x is right. P is wanted as well: return both, x first.",
    ),
    "R outside": (
        outside,
        "R belongs inside the bracket that is inverted, inv(H P Hᵀ + R). You added it to the gain, which is a matrix of another kind.",
    ),
    "H in front of P Hᵀ": (
        one_row_for_each_reading,
        "Your K is H P Hᵀ S⁻¹. K needs one row for each state: P Hᵀ S⁻¹, without the H in front.",
    ),
    "variances alone": (
        variances_alone,
        "Your x is right, and so are the variances in P. But the corners of (I − K H) P are gone: the errors of "
        "the states belong together, so keep the whole matrix.",
    ),
    "gain of the new P": (
        gain_of_the_new_P,
        "Your P is right. Your x is corrected with a gain that is made of the *new* P. One gain serves (8) and "
        "(9): that of (7), from the P that comes in.",
    ),
    "first reading alone": (
        lambda x, P, z, H, R: corrected(x, P, z[:1], H[:1], R[:1, :1]),
        "That is the correction by the first number of z alone. All of them count: use the whole z, H and R.",
    ),
    "the first entry for H x": (
        lambda x, P, z, H, R: (x + P @ H.T @ np.linalg.inv(H @ P @ H.T + R) @ (z - x[0]), corrected(x, P, z, H, R)[1]),
        "Your P is right. But you took x[0] away from z: compare the reading with the predicted reading, H x.",
    ),
}
