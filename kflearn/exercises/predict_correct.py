"""Lesson 3: predict and correct."""

import numpy as np

from kflearn.exercises.engine import exercise

F, P, Q = np.array([[1.0, 2.0], [0.0, 1.0]]), np.array([[2.0, 1.0], [1.0, 3.0]]), np.diag([4.0, 1.0])


@exercise(
    hints=[
        "Three products and a sum: first F P, then that times Fᵀ, then add Q.",
        "F P = [[4, 7], [1, 3]]. Fᵀ = [[1, 0], [2, 1]]: the 2 has gone to the other corner.",
        "F P Fᵀ = [[18, 7], [7, 3]]; add 4 and 1 on the diagonal.",
    ],
    wrong={
        "forgot Q": (
            lambda: F @ P @ F.T,
            "That is F P Fᵀ: the old doubt, moved. The jolts of this step are missing: add Q.",
        ),
        "F P F": (
            lambda: F @ P @ F + Q,
            "You multiplied by F on both sides. The right-hand one must be Fᵀ, or the result is not even symmetric.",
        ),
        "F P F without Q": (
            lambda: F @ P @ F,
            "Two faults: the right-hand F must be Fᵀ (a covariance is symmetric, yours is not), and Q is missing.",
        ),
        "P F P": (
            lambda: P @ F @ P + Q,
            "You put F between two P. It is the other way round: P is the filling, F P Fᵀ. Variances squared have no place here.",
        ),
        "P F P without Q": (
            lambda: P @ F @ P,
            "That is the published misprint, P F P: its unit would be m⁴ for the position. Write F P Fᵀ, and add Q.",
        ),
        "Fᵀ P F": (
            lambda: F.T @ P @ F + Q,
            "The transpose is on the wrong side: the errors become F e, so F stands on the left and Fᵀ on the right.",
        ),
        "F P": (
            lambda: F @ P + Q,
            "You stopped after F P. The error stands twice in a covariance, and both must be moved: multiply by Fᵀ on the right.",
        ),
        "P + Q": (
            lambda: P + Q,
            "You added the jolts, but forgot to move the old doubt: in 2 s an unsure velocity makes the position unsure.",
        ),
        "entry by entry": (
            lambda: F * P * F.T + Q,
            "In NumPy * multiplies entry by entry; the product of matrices is @.",
        ),
        "diagonal only": (
            lambda: np.diag(np.diag(F @ P @ F.T + Q)),
            "The diagonal is right. But position and velocity now err together: the corners are not 0.",
        ),
        "minus Q": (
            lambda: F @ P @ F.T - Q,
            "You took Q away. Jolts make the belief wider, never sharper: add it.",
        ),
        "Q taken for σ": (
            lambda: F @ P @ F.T + Q @ Q,
            "You squared Q. It holds variances already; add it as it is.",
        ),
    },
)
def predicted_covariance():
    """The predicted covariance for dt = 2 s, P = [[2, 1], [1, 3]], Q = diag(4, 1)."""
    return F @ P @ F.T + Q


def corrections(rng):
    """A belief about two numbers and a measurement of two, with round entries."""
    A = rng.integers(1, 4, (2, 2)).astype(float)
    H = rng.integers(1, 4, (2, 2)) + 3 * np.eye(2)
    R = np.diag(rng.integers(2, 10, 2) / 2)
    return rng.integers(-9, 10, 2).astype(float), A @ A.T + np.eye(2), rng.integers(-9, 10, 2).astype(float), H, R


def correction(gain, x, P, z, H, sign=1.0):
    """The lines (8) and (9) with a given gain."""
    return x + sign * gain @ (z - H @ x), P - gain @ H @ P


def gain_of(P, H, R):
    """Line (7)."""
    return P @ H.T @ np.linalg.inv(H @ P @ H.T + R)


@exercise(
    hints=[
        "Three lines, in the order of the lesson: K by (7), the new x by (8), the new P by (9). x and P come in already predicted.",
        "K = P @ H.T @ np.linalg.inv(...). What has to be inverted is the covariance of the innovation, H P Hᵀ + R.",
        "`K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)`, then `return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P`",
    ],
    inputs=corrections,
    wrong={
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
            "R is missing in your gain: without it the measurement is believed as if it were exact.",
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
            "Your P is right. Your x walks away from the measurement: the innovation is measured minus expected, z − H x.",
        ),
        "innovation without H": (
            lambda x, P, z, H, R: (x + gain_of(P, H, R) @ (z - x), P - gain_of(P, H, R) @ H @ P),
            "Your P is right. But you took x away from z: compare the measurement with what you expected to measure, H x.",
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
            lambda x, P, z, H, R: (correction(gain_of(P, H, R), x, P, z, H)[0], P - gain_of(P, H, R) @ P),
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
            "Your x is right. Your P has grown: a measurement takes doubt away, (I − K H) P with a minus.",
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
    },
)
def correct(x, P, z, H, R):
    """The state and the covariance after the measurement z, eqs (7)–(9)."""
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


@exercise(
    hints=[
        "No single mistake does it. one_step(H2=1, v=1), for instance, makes two of them at once.",
        "60.5 lies half a metre above the prediction of 60. Which gain, times which innovation, is a half?",
        "A gain of 1/2 needs P⁻ = R, so somebody forgot Q; an innovation of 1 needs H x̂⁻ = 61, so the tape is compared with 60 + 1.",
    ],
    wrong={
        "right filter": (
            {"C"},
            "A wrong velocity alone does no harm, as H = [1, 0] does not ask for it: 61.67 m.",
        ),
        "readers' 61": ({"B"}, "Without Q alone the step ends at 61 m: one of the readers' answers."),
        "61 again": (
            {"B", "C"},
            "Without Q and with the wrong velocity the step still ends at 61 m: H = [1, 0] never looks at the velocity.",
        ),
        "readers' 56": (
            {"A", "B"},
            "That gives 56 m, one of the readers' answers: the tape was expected to read 60 + 10 = 70. One more mistake is needed.",
        ),
        "53.33": ({"A"}, "H = [1, 1] alone gives 53.33 m: the tape was expected to read 60 + 10 = 70."),
        "60.83": ({"A", "C"}, "That gives 60.83 m: close, but with Q the gain is 5/6. Which gain does 60.5 need?"),
        "sign": ({"D"}, "With the wrong sign the step walks away from the tape, to 58.33 m."),
    },
)
def printed_position():
    """Which mistakes together give 60.5 m: A H = [1, 1], B Q forgotten, C velocity 1 for 10, D wrong sign?"""
    return {"A", "B", "C"}


def whole_steps(rng):
    """A belief about position and velocity, a reading, and a model with round entries."""
    root = rng.integers(1, 4, (2, 2)).astype(float)
    F = np.array([[1.0, rng.integers(2, 7) / 2], [0.0, 1.0]])
    x, z = rng.integers(-9, 10, 2).astype(float), rng.integers(-9, 10, 1).astype(float)
    Q, R = np.diag(rng.integers(1, 9, 2) / 2), rng.integers(1, 9, (1, 1)) / 2
    return x, root @ root.T + np.eye(2), z, F, np.array([[1.0, 0.0]]), Q, R


def step(x_pred, P_pred, z, H, R, begin=None):
    """A correction of a prediction; as printed it begins its walk elsewhere."""
    K = gain_of(P_pred, H, R)
    return (x_pred if begin is None else begin) + K @ (z - H @ x_pred), P_pred - K @ H @ P_pred


@exercise(
    hints=[
        "Two lines are misprinted: the one of the predicted covariance and the one of the new state. And a term is missing in the first of them.",
        "Line two is eq (6): move the errors with F on the left and Fᵀ on the right, then add the jolts. In line four x_pred has been moved already.",
        "P_pred = F @ P @ F.T + Q, and x_new = x_pred + K @ (z - H @ x_pred); the other lines stay.",
    ],
    inputs=whole_steps,
    wrong={
        "as published": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P @ F @ P, z, H, R, begin=F @ F @ x),
            "That is still the published step: line two and line four are both misprinted.",
        ),
        "only line four": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P @ F @ P, z, H, R),
            "The stray F is gone. Line two remains: P F P should be F P Fᵀ + Q.",
        ),
        "only line two": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T + Q, z, H, R, begin=F @ F @ x),
            "Line two is mended. Line four still moves the state a second time: begin the walk at x_pred, not at F @ x_pred.",
        ),
        "Q still missing": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T, z, H, R),
            "The sandwich F P Fᵀ is right and the stray F is gone; but the jolts are missing: add Q.",
        ),
        "Q missing, stray F": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T, z, H, R, begin=F @ F @ x),
            "The sandwich F P Fᵀ is right. Q is still missing behind it, and line four still has a second F.",
        ),
        "P F P + Q": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P @ F @ P + Q, z, H, R),
            "The stray F is gone and Q is there. But P F P has the filling outside: F P Fᵀ.",
        ),
        "F P F": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F + Q, z, H, R),
            "The stray F is gone. In line two the right-hand F must be transposed: F P Fᵀ + Q.",
        ),
        "Fᵀ P F": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F.T @ P @ F + Q, z, H, R),
            "The stray F is gone. In line two the transpose is on the wrong side: F P Fᵀ + Q.",
        ),
        "F in the innovation": (
            lambda x, P, z, F, H, Q, R: step(F @ F @ x, F @ P @ F.T + Q, z, H, R),
            "Line two is mended. But now F acts twice on the state, in the innovation too: x_pred is F @ x, moved once.",
        ),
        "not predicted at all": (
            lambda x, P, z, F, H, Q, R: step(x, F @ P @ F.T + Q, z, H, R),
            "One F too many was taken out: x_pred = F @ x stays, only the second F, in line four, has to go.",
        ),
        "never predicted": (
            lambda x, P, z, F, H, Q, R: step(x, P, z, H, R),
            "That is a correction alone. Predict first: x_pred = F @ x and P_pred = F P Fᵀ + Q.",
        ),
        "innovation with the old state": (
            lambda x, P, z, F, H, Q, R: (
                F @ x + gain_of(F @ P @ F.T + Q, H, R) @ (z - H @ x),
                step(F @ x, F @ P @ F.T + Q, z, H, R)[1],
            ),
            "P is right. But the innovation compares z with the state of a second ago: use x_pred.",
        ),
    },
)
def misprints(x, P, z, F, H, Q, R):
    """The whole step, eqs (5)–(9), which is published with P·F·P and a second F before the prediction."""
    x_pred = F @ x
    P_pred = F @ P @ F.T + Q
    K = P_pred @ H.T @ np.linalg.inv(H @ P_pred @ H.T + R)
    x_new = x_pred + K @ (z - H @ x_pred)
    return x_new, (np.eye(len(x)) - K @ H) @ P_pred
