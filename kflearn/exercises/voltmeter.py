"""Lesson 5: the voltmeter."""

import math

import numpy as np

from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "Two lines of the loop come before x is touched: P grows, then K is formed.",
        "Before the second reading P has grown from 4 to 4 + Q.",
        "K = 8 / (8 + 4).",
    ],
    wrong={
        "forgot Q": (0.5, "You forgot to predict: P grows by Q = 4 before the gain is formed."),
        "1 − K": (1 / 3, "That is 1 − K, the weight of the prediction; the gain has P on top."),
        "σ for σ²": (
            math.sqrt(8) / (math.sqrt(8) + 2),
            "You weighed with standard deviations; the gain takes variances.",
        ),
        "steady gain": (0.618034, "That is where the gain comes to rest later; the second reading meets a larger one."),
        "Q and R swapped for sums": (
            0.8,
            "Q was added twice: only one prediction lies between the first and the second reading.",
        ),
    },
)
def second_gain():
    """The gain for the second reading, with P = 4 V² after the first and Q = R = 4 V²."""
    P = 4 + 4
    return P / (P + 4)


def noises(rng):
    """A pair Q, R over four decades."""
    return 10 ** rng.uniform(-2, 2), 10 ** rng.uniform(-2, 2)


def forgotten_prediction(Q, R):
    """The fixed point of a recursion that fuses P = Q with R."""
    return Q / (Q + R)


@exercise(
    hints=[
        "After the correction P = K·R (why? P = (1 − K)P⁻, and K = P⁻/(P⁻ + R)). So P⁻ = K·R + Q.",
        "Put it into K = P⁻/(P⁻ + R) and write q = Q/R: K² + qK − q = 0.",
        "K = (√(q² + 4q) − q) / 2; or simply `P = R`, then some hundred times `P = (P + Q) * R / (P + Q + R)`.",
    ],
    inputs=noises,
    rtol=1e-5,
    wrong={
        "Q / (Q + R)": (
            forgotten_prediction,
            "That takes P⁻ for Q alone. But what was left over from the step before is still there: P⁻ = P + Q.",
        ),
        "Q and R swapped": (
            lambda Q, R: (math.sqrt((R / Q) ** 2 + 4 * R / Q) - R / Q) / 2,
            "You swapped Q and R: the larger Q, the more a new reading must count.",
        ),
        "1 − K": (
            lambda Q, R: 1 - (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "That is 1 − K, what the prediction keeps.",
        ),
        "P instead of K": (
            lambda Q, R: R * (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "That is the steady variance P = K·R, in V²; the gain is a pure number.",
        ),
        "golden ratio always": (lambda Q, R: 0.6180339887, "0.618 is the answer for Q = R only."),
        "other root": (
            lambda Q, R: (-math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "The quadratic equation has two roots; a gain lies between 0 and 1.",
        ),
    },
)
def steady_gain(Q, R):
    """The gain at which growth by Q and cut by the reading balance."""
    q = Q / R
    return (math.sqrt(q**2 + 4 * q) - q) / 2


def starts(rng):
    """A state of three numbers, of which none, some or all are unknown."""
    x = rng.integers(-9, 10, 3).astype(float)
    unknown = rng.permutation(3)[: rng.integers(0, 4)]
    x[unknown] = np.nan
    return (x,)


@exercise(
    hints=[
        "One unknown entry is enough to spoil everything that follows.",
        "np.isnan(x) gives one True or False for each entry; you want to know whether any of them is True.",
        "return np.isnan(x).any()",
    ],
    inputs=starts,
    wrong={
        "as published": (
            lambda x: np.isnan(x).all(),
            "That is the published test again: it says yes only when every entry is unknown.",
        ),
        "the wrong way round": (lambda x: not np.isnan(x).any(), "Your function says yes when the start is known."),
        "only the first": (lambda x: np.isnan(x[0]), "You look at the first entry only; NaN may sit in any of them."),
        "x == nan": (
            lambda x: (x == np.nan).any(),
            "NaN equals nothing, not even itself, so x == np.nan is always False: use np.isnan.",
        ),
    },
)
def is_unknown(x):
    """True if any entry of the state is unknown (NaN)."""
    return np.isnan(x).any()


def first_measurements(rng):
    """A measurement of two states, its H and its R."""
    noise = rng.integers(1, 5, (2, 2)).astype(float)
    H = np.array([[2.0, 1.0], [0.0, 1.0]]) + rng.integers(0, 3, (2, 2)) * np.eye(2)
    return rng.integers(-9, 10, 2).astype(float), H, noise @ noise.T + np.eye(2)


@exercise(
    hints=[
        "z = Hx + v. If you knew that v = 0, what would x be?",
        "The error of x is H⁻¹v. The covariance of a matrix A times v is A R Aᵀ, here with A = H⁻¹.",
        "x = np.linalg.solve(H, z); half = np.linalg.solve(H, R); P = np.linalg.solve(H, half.T)",
    ],
    inputs=first_measurements,
    wrong={
        "H⁻¹R only": (
            lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R)),
            "x is right. P lacks its right-hand factor: H⁻¹R is not symmetric, and no covariance; multiply by H⁻ᵀ.",
        ),
        "P = R": (
            lambda z, H, R: (np.linalg.solve(H, z), R),
            "x is right. R is the covariance of z; that of x = H⁻¹z is H⁻¹RH⁻ᵀ.",
        ),
        "H⁻¹RH⁻¹": (
            lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R) @ np.linalg.inv(H)),
            "x is right. In P the second inverse must be transposed: H⁻¹RH⁻ᵀ.",
        ),
        "HRHᵀ": (
            lambda z, H, R: (np.linalg.solve(H, z), H @ R @ H.T),
            "x is right. HRHᵀ goes from states to measurements; here you go back, with inverses.",
        ),
        "z itself": (
            lambda z, H, R: (z, R),
            "z is a measurement, not a state: undo H first. The two agree only for H = 1.",
        ),
        "Hz": (
            lambda z, H, R: (H @ z, H @ R @ H.T),
            "You applied H once more instead of undoing it: z = Hx, so x = H⁻¹z.",
        ),
    },
)
def auto_start(z, H, R):
    """The state and covariance that one measurement z = Hx + v alone gives, H invertible."""
    x = np.linalg.solve(H, z)
    half = np.linalg.solve(H, R)
    return x, np.linalg.solve(H, half.T)


@exercise(
    hints=[
        "Two opinions about the voltage of this moment: N(12, 4) from knowing the source, and a reading with variance 4.",
        "Fuse them: K = 4 / (4 + 4), and the variance that is left is 4(1 − K).",
        "√2 V.",
    ],
    unit="V",
    rtol=4e-3,
    wrong={
        "variance": (2.0, "2 is the variance that is left, in V²; the error in volts is its root."),
        "K": (0.5, "That is K. The question goes on: what error is left?"),
        "filter's claim": (
            1.5723,
            "That is what the Kalman filter claims with its random walk; without the walk it gets better.",
        ),
        "filter's error": (
            1.63,
            "That is what the Kalman filter reaches; the formula that knows the right world gets better.",
        ),
    },
)
def best_error():
    """The root mean square error of the best answer when N(12, 4) is read with variance 4."""
    K = 4 / (4 + 4)
    return math.sqrt(4 * (1 - K))
