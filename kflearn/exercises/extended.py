"""Lesson 14: where the tangent touches, and what no tangent can do."""

import numpy as np

from kflearn.exercises._slips import extended as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def believed_starts(rng, runs):
    """A mean, a diagonal P₀ and standard normal numbers for a few runs."""
    mean = rng.integers(-200, 200, 4).astype(float)
    return mean, np.diag(rng.integers(2, 60, 4) / 2 + 0.5), rng.normal(size=(runs, 4)).round(2)


@exercise(
    hints=[
        "A filter that starts with N(mean, P0) says that the truth is scattered about `mean` with the variances of P0. Draw the true starts in that way.",
        "Standard normal numbers have variance 1. Multiply column i by the *root* of P0[i, i], then add mean[i].",
        "`return mean + normal * np.sqrt(np.diag(P0))` (one row a run; P0 is diagonal).",
    ],
    inputs=in_turn(believed_starts, 2, 3, 12, 1),
    wrong=slips.true_starts.WRONG,
    also=[lambda mean, P0, normal: mean - normal * np.sqrt(np.diag(P0))],  # a Gaussian is symmetric
    fixed={"mean": "a place and a velocity in the plane: four numbers", "P0": "it belongs to a state of four numbers"},
    then="With starts like these the mean NEES before the first reading is 4, the number of states; with the published ones it is 0.",
)
def true_starts(mean, P0, normal):
    """True starts (runs, 4) drawn from the belief N(mean, P0), P0 diagonal, by standard normal numbers (runs, 4)."""
    return mean + normal * np.sqrt(np.diag(P0))


def growth_beliefs(rng):
    """An estimate, its variance and an input of the growth model."""
    return float(rng.integers(-40, 41) / 4 + 0.1), float(rng.integers(1, 20) / 4), float(rng.integers(-32, 33) / 4)


@exercise(
    hints=[
        "F says how much the move stretches the belief. Is the belief at the old x when it is moved, or at the new one?",
        "The belief is at the old x before the move, so the slope is needed there. But the first line has overwritten the old x.",
        "Swap two lines: first `F = move_slope(x)`, then `x = move(x, u)`, then P = F * P * F + 10.",
    ],
    inputs=growth_beliefs,
    wrong=slips.mended_prediction.WRONG,
    then="At x = 2 the slope is −2.5, at 0 it is 25.5, ten times as large. So it matters at which place the slope is taken.",
)
def mended_prediction(x, P, u):
    """The EKF's prediction of the growth model (coefficient 25, Q = 10): the mean and its variance."""
    F = 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2
    x = x / 2 + 25 * x / (1 + x**2) + u
    return x, F * P * F + 10


@exercise(
    hints=[
        "Compare the sag σ²/(2d) of the first tangent with the σ of a reading, 2.24 m. The first distance is 316 m.",
        "The sag grows with the square of σ: 30²/(2·316) m = 1.4 m has become 100²/(2·316) m = 16 m.",
        "The sag is seven times the reading's σ. Which of the two filters draws its next tangents at an estimate that was corrected so badly?",
    ],
    wrong=slips.winner.WRONG,
    otherwise=slips.winner.WINNER,
    then="Over a thousand runs the rms error of the LKF is 51 m, that of the EKF 106 m. Nevertheless neither is good: with tangents at the truth it would be 37 m.",
)
def winner():
    """Which filter has the smaller rms error with a start wrong by 100 m and 1 m/s: "LKF", "EKF" or "no difference"?"""
    return "LKF"


@exercise(
    hints=[
        "The mean of the whole belief is the mean of the two places, each weighed by its probability.",
        "For the variance take the mean square distance from that mean: 0.7·(11 − mean)² + 0.3·(−11 − mean)², and add the variance within a hump.",
        "The mean is 0.7·11 − 0.3·11 = 4.4. The variance is 0.7·6.6² + 0.3·15.4² + 1² = 102.64; take its root.",
    ],
    wrong=slips.both_humps.WRONG,
    otherwise=slips.both_humps.of_humps,
    then="The rms error of the answer 4.4 is 10.1. The answer +11, where the state probably is, has 12.1: when it is wrong, it is wrong by 22. "
    "So the mean is the best single number by the squared error, although the state is never there.",
)
def both_humps():
    """Mean and standard deviation of a belief with two humps: N(11, 1) with probability 0.7, N(−11, 1) with 0.3."""
    mean = 0.7 * 11 - 0.3 * 11
    return mean, np.sqrt(0.7 * (11 - mean) ** 2 + 0.3 * (-11 - mean) ** 2 + 1)
