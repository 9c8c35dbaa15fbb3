"""Lesson 2: two numbers that err together."""

import math

import numpy as np

from kflearn.exercises._slips import two_numbers as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def pairs(rng, count):
    """So many pairs of round numbers, whose errors share a part."""
    shared = rng.integers(-8, 9, count) / 2
    return 20 + shared + rng.integers(-4, 5, count) / 2, 3 - shared + rng.integers(-4, 5, count) / 2


@exercise(
    hints=[
        "A deviation is what a number has above the mean of its own series. Which product is averaged?",
        "First `dx = x - x.mean()` and `dy = y - y.mean()`. A covariance is the mean of a product of two deviations; a variance is that of a number with itself.",
        "`return np.array([[(dx * dx).mean(), (dx * dy).mean()], [(dx * dy).mean(), (dy * dy).mean()]])`",
    ],
    inputs=in_turn(pairs, 4, 5, 9, 40),
    wrong=slips.table_of.WRONG,
    then="`np.cov(x, y, bias=True)` gives the same table. Without `bias=True` it divides by N − 1, because the mean was estimated from the same data.",
)
def table_of(x, y):
    """The covariance matrix of two series of equal length, as means over the pairs."""
    dx, dy = x - x.mean(), y - y.mean()
    return np.array([[(dx * dx).mean(), (dx * dy).mean()], [(dx * dy).mean(), (dy * dy).mean()]])


@exercise(
    hints=[
        "The length is the row [−1, 1] times the two ends. Which rule gives the variance of such a row times a state?",
        "A P Aᵀ with A = [−1, 1]: the variance of one end, plus that of the other, minus twice the corner.",
        "The corner is 0.8 · 3 · 3 = 7.2 mm². Then 9 + 9 − 2 · 7.2 = 3.6 mm², and its root.",
    ],
    wrong=slips.table_length.WRONG,
    unit="mm",
    rtol=5e-3,
    otherwise=lambda sigma: (
        f"A σ of {sigma:.3g} mm is a variance of {sigma**2:.3g} mm². Which variances, and which corner, should make it?"
    ),
    then="Errors that are shared cancel in a difference: that is why surveyors, and satellite receivers, measure differences.",
)
def table_length():
    """σ of the difference of two readings with σ = 3 mm each and correlation 0.8."""
    A, P = np.array([-1.0, 1.0]), np.array([[9.0, 7.2], [7.2, 9.0]])
    return math.sqrt(A @ P @ A)


@exercise(
    hints=[
        "The carts that stand 3 m further than predicted: are they faster or slower than the average cart?",
        "On average the velocity deviates by corner / variance of the position for each metre.",
        "6 / 13 (m/s)/m · 3 m, on top of the 10 m/s that were expected.",
    ],
    wrong=slips.told_speed.WRONG,
    unit="m/s",
    rtol=5e-3,
    otherwise=lambda speed: (
        f"Your answer adds {(speed - 10) / 3:.3g} m/s for each of the 3 m. Which two entries of P make this number?"
    ),
    then="The factor 6/13 is what lesson 3 calls K₂, the second entry of the gain: corner over variance. With a tape that errs itself, its variance is added below the line, and the step becomes smaller.",
)
def told_speed():
    """The mean velocity of the carts that stand 3 m further than predicted; P = [[13, 6], [6, 4]], 10 m/s expected."""
    return 10 + 6 / 13 * 3


@exercise(
    hints=[
        "Which share does the ellipse of k standard deviations hold? The text has the formula, for a round cloud and so for every ellipse.",
        "Solve share = 1 − exp(−k²/2) for k.",
        "`return np.sqrt(-2 * np.log(1 - share))`",
    ],
    inputs=lambda rng: (float(rng.choice([0.1, 0.39, 0.5, 0.68, 0.8, 0.86, 0.9, 0.95, 0.99, 0.999])),),
    wrong=slips.scale_for.WRONG,
    otherwise=slips.scale_for.stretched,
    then="For 95 % k is 2.45. With m numbers, tied or not, k² is the chi-square quantile with m degrees of freedom: `scipy.stats.chi2.ppf(share, m)`.",
)
def scale_for(share):
    """How many standard deviations large an ellipse must be to hold a given share of a cloud of two numbers."""
    return np.sqrt(-2 * np.log(1 - share))
