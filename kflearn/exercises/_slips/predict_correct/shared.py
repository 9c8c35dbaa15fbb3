"""Lesson 3: what several exercises' wrong answers are made of."""

import numpy as np


def correction(gain, x, P, z, H, sign=1.0):
    """The lines (8) and (9) with a given gain."""
    return x + sign * gain @ (z - H @ x), P - gain @ H @ P


def gain_of(P, H, R):
    """Line (7)."""
    return P @ H.T @ np.linalg.inv(H @ P @ H.T + R)


WRONG_STEPS = {
    "1 − K H": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            (1 - gain_of(P, H, R) @ H) @ P,
        ),
        "Your x is right. In P, `1 - K @ H` takes each entry away from 1. I is the identity matrix, np.eye(len(x)).",
    ),
    "np.eye(2)": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            (np.eye(2) - gain_of(P, H, R) @ H) @ P,
        ),
        "Not every state has two numbers: take np.eye(len(x)) for I.",
        r"(eye|identity)\(2\)",
    ),
    "np.eye(len(z))": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            (np.eye(len(z)) - gain_of(P, H, R) @ H) @ P,
        ),
        "I has as many rows as the state, not as the reading: take np.eye(len(x)).",
        r"(eye|identity)\((len\(z\)|z\.size)",
    ),
    "P/(P + R)": (
        lambda x, P, z, H, R: correction(P / (P + R), x, P, z, H),
        "K = P/(P + R) holds for single numbers. For matrices take (7): P @ H.T times the inverse of H @ P @ H.T + R.",
    ),
    "no H in the gain": (
        lambda x, P, z, H, R: (x + P @ np.linalg.inv(P + R) @ (z - x), P - P @ np.linalg.inv(P + R) @ P),
        "H is missing everywhere. The sensor reads H x, not x, so H stands in all three lines.",
    ),
    "H for Hᵀ in the gain": (
        lambda x, P, z, H, R: correction(P @ H @ np.linalg.inv(H @ P @ H.T + R), x, P, z, H),
        "Your gain has H where (7) has Hᵀ. With square matrices nobody complains; with H = [1, 0] the shapes would not fit.",
    ),
    "H and Hᵀ exchanged": (
        lambda x, P, z, H, R: correction(P @ H @ np.linalg.inv(H.T @ P @ H + R), x, P, z, H),
        "You exchanged H and Hᵀ in (7): the state's covariance goes through H from the left and through Hᵀ from the right, H P Hᵀ.",
    ),
    "Hᵀ everywhere": (
        lambda x, P, z, H, R: correction(gain_of(P, H.T, R), x, P, z, H.T),
        "You used Hᵀ for H throughout. H takes a state to what would be measured: H x.",
    ),
    "R forgotten": (
        lambda x, P, z, H, R: correction(gain_of(P, H, 0 * R), x, P, z, H),
        "R is missing in your gain: without it the reading counts as if it were exact.",
    ),
    "σ for σ²": (
        lambda x, P, z, H, R: correction(gain_of(P, H, np.sqrt(R)), x, P, z, H),
        "You took the root of R. R holds variances, and (7) wants variances.",
    ),
    "R squared": (
        lambda x, P, z, H, R: correction(gain_of(P, H, R @ R), x, P, z, H),
        "You squared R. It holds variances already.",
    ),
    "innovation backwards": (
        lambda x, P, z, H, R: correction(gain_of(P, H, R), x, P, z, H, sign=-1.0),
        "Your P is right. Your x moves away from the reading: (8) adds K times measured minus expected, z − H x.",
    ),
    "innovation without H": (
        lambda x, P, z, H, R: (x + gain_of(P, H, R) @ (z - x[: len(z)]), P - gain_of(P, H, R) @ H @ P),
        "Your P is right. But you took x away from z: compare the reading with the predicted reading, H x.",
    ),
    "z in place of the innovation": (
        lambda x, P, z, H, R: (x + gain_of(P, H, R) @ z, P - gain_of(P, H, R) @ H @ P),
        "Your P is right. But you added K z: only what is new about z counts, z − H x.",
    ),
    "covariance not reduced": (
        lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P),
        "Your x is right. P is still the predicted one: a measurement makes it smaller, (I − K H) P.",
    ),
    "I − K": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            (np.eye(len(x)) - gain_of(P, H, R)) @ P,
        ),
        "Your x is right. In P you wrote I − K; K takes metres of the tape to the state, so H must come first: I − K H.",
    ),
    "I − H K": (
        lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P - H @ gain_of(P, H, R) @ P),
        "Your x is right. In P the order matters: K H, not H K.",
    ),
    "K H P": (
        lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], gain_of(P, H, R) @ H @ P),
        "Your x is right. For P you kept the part that the measurement has removed; what remains is (I − K H) P.",
    ),
    "covariance added": (
        lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P + gain_of(P, H, R) @ H @ P),
        "Your x is right. Your P has grown: a reading makes it smaller, (I − K H) P with a minus.",
    ),
    "divided entry by entry": (
        lambda x, P, z, H, R: correction(P @ H.T / (H @ P @ H.T + R), x, P, z, H),
        "You divided entry by entry with /. The −1 in (7) is the inverse of a matrix: np.linalg.inv.",
    ),
    "multiplied entry by entry": (
        lambda x, P, z, H, R: correction(P * H.T @ np.linalg.inv(H * P * H.T + R), x, P, z, H),
        "In NumPy * multiplies entry by entry; the product of matrices is @.",
    ),
    "the order of the pair": (
        lambda x, P, z, H, R: correction(gain_of(P, H, R), x, P, z, H)[::-1],
        "Both are right, in the wrong order: return x first, then P.",
    ),
    "R for S": (
        lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(R), x, P, z, H),
        "You inverted R alone. What is inverted in (7) is the covariance of the innovation: H P Hᵀ belongs to it as well.",
    ),
    "S not inverted": (
        lambda x, P, z, H, R: correction(P @ H.T @ (H @ P @ H.T + R), x, P, z, H),
        "You multiplied by H P Hᵀ + R. The gain divides by it: the inverse is missing.",
    ),
    "no Hᵀ in the gain": (
        lambda x, P, z, H, R: correction(P @ np.linalg.inv(H @ P @ H.T + R), x, P, z, H),
        "Your gain lacks Hᵀ: (7) begins with P Hᵀ.",
    ),
    "S without H": (
        lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(P + R), x, P, z, H),
        "You added P and R, but P is about the state and R about the measurement. The variance of the predicted reading is H P Hᵀ.",
    ),
    "only the diagonal of R": (
        lambda x, P, z, H, R: correction(gain_of(P, H, np.diag(np.diag(R))), x, P, z, H),
        "You used the diagonal of R only. The errors of two sensors may go together: take R as it is.",
    ),
    "P shrunk by K": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            P - gain_of(P, H, R) @ R @ gain_of(P, H, R).T,
        ),
        "Your x is right. In P you took away K R Kᵀ, which a reading adds. Take away K H P.",
    ),
    "I − K H alone": (
        lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], np.eye(len(x)) - gain_of(P, H, R) @ H),
        "Your x is right. For P you stopped at I − K H: multiply P by it.",
    ),
    "P(I − K H)": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            P @ (np.eye(len(x)) - gain_of(P, H, R) @ H),
        ),
        "Your x is right. In P the order is the other way round: (I − K H) stands on the left.",
    ),
    "the step alone": (
        lambda x, P, z, H, R: (gain_of(P, H, R) @ (z - H @ x), P - gain_of(P, H, R) @ H @ P),
        "Your P is right. The first result is the step alone: add it to x.",
    ),
    "half of Joseph": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            (np.eye(len(x)) - gain_of(P, H, R) @ H) @ P @ (np.eye(len(x)) - gain_of(P, H, R) @ H).T,
        ),
        "Your x is right. The form with (I − K H) on both sides needs K R Kᵀ as well; or use it once, as in (9).",
    ),
    "Hᵀ P H": (
        lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(H.T @ P @ H + R), x, P, z, H),
        "In your gain H and Hᵀ are exchanged inside the inverse: H P Hᵀ + R.",
    ),
    "K S taken away": (
        lambda x, P, z, H, R: (
            correction(gain_of(P, H, R), x, P, z, H)[0],
            P - gain_of(P, H, R) @ (H @ P @ H.T + R),
        ),
        "Your x is right. In P you took K S away; (9) takes K H P away.",
    ),
    "both kept": (
        lambda x, P, z, H, R: (x, P),
        "You return what came in. First the gain, then the new x and the new P.",
    ),
    "minus R": (
        lambda x, P, z, H, R: correction(P @ H.T @ np.linalg.inv(H @ P @ H.T - R), x, P, z, H),
        "You took R away from H P Hᵀ. The innovation contains both errors, so their covariances add.",
    ),
}


def corrected(x, P, z, H, R, K=None):
    K = gain_of(P, H, R) if K is None else K
    return x + K @ (z - H @ x), P - K @ H @ P
