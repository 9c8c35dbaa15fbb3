"""Lesson 4: two opinions, one belief."""

import math

import numpy as np

from kflearn.exercises._gaussian_fusion import WRONG
from kflearn.exercises._hints import is_about
from kflearn.exercises._slips_foundations import WRONG as SLIPS
from kflearn.exercises.engine import exercise


def two_opinions(rng):
    """Means and variances of a prediction and a measurement: round, different, one often much vaguer than the other."""
    means = rng.choice(np.arange(80, 121) / 2, 2, replace=False)
    variances = rng.choice([0.25, 0.5, 2.0, 3.0, 4.5, 9.0, 100.0], 2, replace=False)
    return float(means[0]), float(variances[0]), float(means[1]), float(variances[1])


@exercise(
    hints=[
        lambda last: (
            "You have formed K = 0.8333 / (0.8333 + 2). What stands in (12), σ or σ²?"
            if is_about(last, 62.0588, within=1e-3)
            else "The satellite's number is a standard deviation. Formulas (10)–(14) want variances."
        ),
        "The prediction is now N(61.6667, 0.8333), the measurement N(63, 2²). Start with K.",
        "K = 0.8333 / (0.8333 + 4) = 0.1724. Walk that fraction of the way from 61.6667 to 63.",
    ],
    wrong=WRONG["third_opinion"],
    unit="m",
    rtol=5e-4,
    then="The satellite moves the mean by 0.23 m only, and it makes the variance smaller, 0.69 for 0.83 m²: even a vague opinion helps, if its σ is right.",
)
def third_opinion():
    """The mean of N(61.6667, 0.8333) fused with a satellite fix of 63 m, σ = 2 m."""
    gain = 0.8333 / (0.8333 + 2**2)
    return 61.6667 + gain * (63 - 61.6667)


@exercise(
    hints=[
        "Three lines: first K from the two variances (12), then the mean (13), then the variance (14).",
        "K = var_x / (var_x + var_z). The mean starts at mean_x and walks the fraction K towards mean_z.",
        "`return mean_x + K * (mean_z - mean_x), var_x * (1 - K)`",
    ],
    inputs=two_opinions,
    wrong=WRONG["fuse"] | SLIPS["fuse"],
    then="Exchange the two opinions and the result is the same: the formula does not ask which of them came first.",
)
def fuse(mean_x, var_x, mean_z, var_z):
    """Mean and variance of two opinions fused, eqs (12)–(14)."""
    K = var_x / (var_x + var_z)
    return mean_x + K * (mean_z - mean_x), var_x * (1 - K)


@exercise(
    hints=[
        "Precisions 1/σ² add: the prediction brings 1/5, each reading brings 1/1.",
        "You need 1/5 + n ≥ 1/0.3².",
        "1/0.09 − 0.2 = 10.91: and you cannot read a tape 0.91 times.",
    ],
    wrong=WRONG["readings_needed"],
    unit="readings",
    then="Ten readings give 0.313 m and eleven 0.299 m. Without the prediction it would take twelve: beside a good tape it saves one reading.",
)
def readings_needed():
    """How many readings with σ = 1 m bring a prediction of variance 5 m² below σ = 0.3 m?"""
    return math.ceil(1 / 0.3**2 - 1 / 5)


@exercise(
    hints=[
        "N(μx, σz²) takes its mean from one opinion and its variance from the other. Is either of them the fused one?",
        "Which number does the fused estimate move to, and how far? Formula (10) or (13). What is left of the variance? Formula (11) or (14).",
        "`mean = (mean_x * var_z + mean_z * var_x) / (var_x + var_z)`, `variance = var_x * var_z / (var_x + var_z)`",
    ],
    inputs=two_opinions,
    wrong=WRONG["published_claim"] | SLIPS["published_claim"],
    then="The fused variance is smaller than both, 0.83 m² from 5 and 1 m². The published sentence understates the knowledge and misses the position.",
)
def published_claim(mean_x, var_x, mean_z, var_z):
    """Mean and mean squared error of the fused estimate, which a published text gives as μx and σz²."""
    mean = (mean_x * var_z + mean_z * var_x) / (var_x + var_z)
    variance = var_x * var_z / (var_x + var_z)
    return mean, variance
