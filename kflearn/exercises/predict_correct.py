"""Lesson 3: predict and correct."""

import numpy as np

from kflearn.exercises._slips import predict_correct as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "Three products and a sum: first F P, then that times Fᵀ, then add Q.",
        "F P = [[4, 7], [1, 3]]. Fᵀ = [[1, 0], [2, 1]]: the 2 has gone to the other corner.",
        "F P Fᵀ = [[18, 7], [7, 3]]; add 4 and 1 on the diagonal.",
    ],
    wrong=slips.predicted_covariance.WRONG,
    then="The errors of position and velocity now belong together more closely: their correlation has grown from 1/√6 = 0.41 to 7/√88 = 0.75. The motion alone would make it 7/√54 = 0.95; the bumps lower it again.",
)
def predicted_covariance():
    """The predicted covariance for dt = 2 s, P = [[2, 1], [1, 3]], Q = diag(4, 1)."""
    move, before = np.array([[1, 2], [0, 1]]), np.array([[2, 1], [1, 3]])
    return move @ before @ move.T + np.diag([4, 1])


def full(rng, n):
    """A covariance of n numbers, with corners."""
    A = rng.integers(1, 4, (n, n)).astype(float)
    return A @ A.T + np.eye(n)


def corrections(rng, n, m):
    """A belief about n numbers and a measurement of m, with round entries."""
    H = rng.integers(1, 4, (m, n)) + 3 * np.eye(m, n)
    return (
        rng.integers(-9, 10, n).astype(float),
        full(rng, n),
        rng.integers(-9, 10, m).astype(float),
        H,
        full(rng, m) / 2,
    )


@exercise(
    hints=[
        "Three lines, in the order of the lesson: K by (7), the new x by (8), the new P by (9). x and P come in already predicted.",
        "K = P @ H.T @ np.linalg.inv(...). What has to be inverted is the covariance of the innovation, H P Hᵀ + R.",
        "`K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)`, then `return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P`",
    ],
    inputs=in_turn(corrections, (1, 1), (2, 2), (3, 3), (2, 2), (2, 1), (3, 2)),
    wrong=slips.correct.WRONG,
    then="If R goes to zero and H can be inverted, K goes to H⁻¹: the new state is then the one that gives exactly z.",
)
def correct(x, P, z, H, R):
    """The state and the covariance after the measurement z, eqs (7)–(9)."""
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ P


@exercise(
    hints=[
        "The speedometer reads the second number of the state: H = [0, 1]. What is P⁻Hᵀ, and what is H P⁻Hᵀ + R?",
        "P⁻Hᵀ is the second column of P⁻, [6, 4], and the variance of the innovation is 4 + 1 = 5. Which entry of K belongs to the position?",
        "K₁ = 6/5 m per m/s, and the innovation is 13 − 10 = 3 m/s.",
    ],
    wrong=slips.speedometer.WRONG,
    unit="m",
    otherwise=lambda x: (
        f"Your answer is {x - 60:.3g} m from the predicted 60 m. Only K₁ times the innovation of 3 m/s is to be added, so K₁ would be {(x - 60) / 3:.3g}. Which numbers make K₁?"
    ),
    then="A speedometer has corrected a position, through the corner of P⁻. The variance of the position falls from 20 to 20 − 6/5 · 6 = 12.8 m².",
)
def speedometer():
    """The new position, when a speedometer reads 13 m/s: x̂⁻ = [60, 10], P⁻ = [[20, 6], [6, 4]], R = 1."""
    before, P, H = np.array([60.0, 10.0]), np.array([[20.0, 6.0], [6.0, 4.0]]), np.array([[0.0, 1.0]])
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + 1)
    return (before + K @ ([13.0] - H @ before))[0]


@exercise(
    hints=[
        "No single mistake does it. `one_step(H2=1, v=1)`, for instance, makes two of them at once.",
        "60.5 m is half a metre more than the prediction of 60 m. Which gain, times which innovation, is a half?",
        "A gain of 1/2 needs P⁻ = R, so somebody forgot Q; an innovation of 1 needs H x̂⁻ = 61, so the tape is compared with 60 + 1.",
    ],
    wrong=slips.printed_position.WRONG,
    then="Three mistakes together end 1.17 m from the right 61.67 m, and one of them alone 8.33 m: mistakes can hide one another.",
)
def printed_position():
    """Which mistakes together give 60.5 m: A H = [1, 1], B Q forgotten, C velocity 1 for 10, D wrong sign?"""
    return {"A", "B", "C"}


def whole_steps(rng, n, m):
    """A belief about n numbers, m readings, and a model with round entries."""
    F = np.eye(n) + np.triu(rng.integers(1, 6, (n, n)) / 2, n > 1)
    H = np.eye(m, n) + rng.integers(0, 2, (m, n))
    x, z = rng.integers(-9, 10, n).astype(float), rng.integers(-9, 10, m).astype(float)
    return x, full(rng, n), z, F, H, full(rng, n) / 2, full(rng, m) / 2


@exercise(
    hints=[
        "Two lines are misprinted: the one of the predicted covariance and the one of the new state. And a term is missing in the first of them.",
        "Line two is eq (6): F on the left and Fᵀ on the right move the errors, then Q is added. In line four x_pred has been moved already.",
        "P_pred = F @ P @ F.T + Q, and x_new = x_pred + K @ (z - H @ x_pred); the other lines stay.",
    ],
    inputs=in_turn(whole_steps, (1, 1), (2, 2), (3, 3), (2, 2), (2, 1), (3, 2)),
    wrong=slips.misprints.WRONG,
    then="A covariance is symmetric, and P·F·P is not as soon as the velocity is uncertain: a test of symmetry would have found this misprint.",
)
def misprints(x, P, z, F, H, Q, R):
    """The whole step, eqs (5)–(9), which is published with P·F·P and a second F before the prediction."""
    x_pred = F @ x
    P_pred = F @ P @ F.T + Q
    K = P_pred @ H.T @ np.linalg.inv(H @ P_pred @ H.T + R)
    x_new = x_pred + K @ (z - H @ x_pred)
    return x_new, (np.eye(len(x)) - K @ H) @ P_pred
