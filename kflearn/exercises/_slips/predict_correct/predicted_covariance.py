"""Lesson 3, `predicted_covariance`: wrong answers, each with the sentence that it gets."""

import numpy as np

F, P, Q = np.array([[1.0, 2.0], [0.0, 1.0]]), np.array([[2.0, 1.0], [1.0, 3.0]]), np.diag([4.0, 1.0])


def upper_left(number):
    """The right covariance with another number at the upper left."""
    return [[number, 7], [7, 4]]


WRONG = {
    "forgot Q": (
        lambda: F @ P @ F.T,
        "That is F P Fᵀ, the old covariance, moved. The bumps of this step are missing: add Q.",
    ),
    "F P F": (
        lambda: F @ P @ F + Q,
        "That is F P F + Q. The right-hand F must be Fᵀ, or the result is not even symmetric.",
    ),
    "F P F without Q": (
        lambda: F @ P @ F,
        "Two faults: the right-hand F must be Fᵀ (a covariance is symmetric, yours is not), and Q is missing.",
    ),
    "P F P": (
        lambda: P @ F @ P + Q,
        "That is P F P + Q, in m⁴. It is the other way round: P stands between F and Fᵀ.",
    ),
    "P F P without Q": (
        lambda: P @ F @ P,
        "That is the published misprint, P F P: its unit would be m⁴ for the position. Write F P Fᵀ, and add Q.",
    ),
    "Fᵀ P F": (
        lambda: F.T @ P @ F + Q,
        "That is Fᵀ P F + Q. The errors become F e, with dt at the upper right of F: F stands on the left and Fᵀ on the right.",
    ),
    "F P": (
        lambda: F @ P + Q,
        "That is F P + Q. The error stands twice in a covariance, and both must be moved: multiply by Fᵀ on the right.",
    ),
    "P + Q": (
        lambda: P + Q,
        "That is P + Q, and the old covariance is not moved: in 2 s an uncertain velocity makes the position uncertain.",
    ),
    "entry by entry": (
        lambda: F * P * F.T + Q,
        "Two ways lead to it: P + Q without the corner of P, or `*` in F P Fᵀ, which multiplies entry by entry in NumPy. F P Fᵀ is a product of matrices, made with `@`.",
    ),
    "diagonal only": (
        lambda: np.diag(np.diag(F @ P @ F.T + Q)),
        "The diagonal is right. But the errors of position and velocity now belong together: the corners are not 0.",
    ),
    "minus Q": (
        lambda: F @ P @ F.T - Q,
        "That is F P Fᵀ − Q. Bumps make the belief wider: add Q.",
    ),
    "Q taken for σ": (
        lambda: F @ P @ F.T + Q @ Q,
        "In the upper left stands 18 + 16, the square of 4. Q holds variances already; add it as it is.",
    ),
    "dt = 1": (
        lambda: [[11, 4], [4, 4]],
        "That is the result for dt = 1 s, as in the lesson. Here dt is 2 s, so F = [[1, 2], [0, 1]].",
    ),
    "Q in the corners": (
        lambda: F @ P @ F.T + [[4, 1], [1, 1]],
        "diag(4, 1) has zeros in the corners: Q is added on the diagonal only.",
    ),
    "dt = 1 for the corner": (
        lambda: F @ P @ F.T + np.diag([1.0, 4.0]),
        "Q is upside down: diag(4, 1) has 4 for the position and 1 for the velocity.",
    ),
    "Q as a row": (
        lambda: F @ P @ F.T + np.array([4, 1]),
        "Here [4, 1] is added to each row. diag(4, 1) is a matrix with 4 and 1 on the diagonal and zeros in the corners: np.diag([4, 1]).",
    ),
    "Q times dt": (
        lambda: F @ P @ F.T + 2 * Q,
        "That is F P Fᵀ + dt·Q. Q is given for this step: add it as it is.",
    ),
    "Q times dt²": (
        lambda: F @ P @ F.T + 4 * Q,
        "That is F P Fᵀ + dt²·Q. Q is given for this step: add it as it is.",
    ),
    "P Fᵀ": (
        lambda: P @ F.T + Q,
        "That is P Fᵀ + Q, without the F on the left. The error stands twice in a covariance, and both must be moved: F P Fᵀ.",
    ),
    "F(P + Q)Fᵀ": (
        lambda: F @ (P + Q) @ F.T,
        "That is F(P + Q)Fᵀ, with Q moved as well. Q belongs to this step: first F P Fᵀ, then add Q.",
    ),
    "Q for the position only": (
        lambda: F @ P @ F.T + np.diag([4.0, 0.0]),
        "Q is added for the position only. The velocity has an entry in Q too: 1 at the lower right.",
    ),
    "4 missing": (
        upper_left(18),
        "Three entries are right. In the upper left 4 m² are missing: is the corner of P counted twice there, and is Q added?",
    ),
    "dt not squared": (
        upper_left(16),
        "Three entries are right. In the upper left the variance of the velocity counts with dt² = 4, and the corner of P twice.",
    ),
    "dt² P₂₂ missing": (
        upper_left(10),
        "Three entries are right. In the upper left the part of the velocity's variance is missing, dt² times it.",
    ),
    "corner once": (
        upper_left(20),
        "Three entries are right. In the upper left 2 m² are missing: the corner of P counts twice there, times dt, and Q is added as it is, without a root.",
    ),
    "P diagonal": (
        [[18, 6], [6, 4]],
        "That is the result without the corner of P, the 1. It belongs to the new corner, and with 2·dt to the upper left.",
    ),
    "P diagonal, without Q": (
        [[14, 6], [6, 3]],
        "Two things are missing: the corner of P, the 1, and Q.",
    ),
    "corner kept": (
        [[22, 1], [1, 4]],
        "The diagonal is right. The corners moved as well: each becomes the old corner plus dt times the variance of the velocity.",
    ),
    "corner without dt": (
        [[22, 4], [4, 4]],
        "The diagonal is right. In the corners the variance of the velocity counts with dt = 2.",
    ),
    "corner without P": (
        [[22, 6], [6, 4]],
        "The diagonal is right. In the corners the old corner of P, the 1, is missing.",
    ),
    "the lesson's P and Q": (
        lambda: F @ np.diag([1.0, 0.0]) @ F.T + np.diag([4.0, 0.0]),
        "That is the result for P and Q of the lesson. Here they are [[2, 1], [1, 3]] and diag(4, 1).",
    ),
    "the lesson's, with an uncertain speed": (
        [[14, 9], [9, 9]],
        "That is the lesson's P⁻. Here dt, P and Q are others: calculate F P Fᵀ + Q anew.",
    ),
    "two steps of 1 s": (
        [[27, 8], [8, 5]],
        "That is what two steps of 1 s make, each with this Q. Here one step takes 2 s, and Q belongs to all of "
        "it: dt = 2 in F, and Q once.",
    ),
}
