"""Lesson 4: two opinions, one belief."""

import math

import numpy as np

from kflearn.exercises._hints import is_about
from kflearn.exercises._slips import gaussian_fusion as slips
from kflearn.exercises.engine import exercise


def two_opinions(rng):
    """Means and variances of a prediction and a measurement: round, different, one often much less certain than the other."""
    means = rng.choice(np.arange(80, 121) / 2, 2, replace=False)
    variances = rng.choice([0.25, 0.5, 2.0, 3.0, 4.5, 9.0, 100.0], 2, replace=False)
    return float(means[0]), float(variances[0]), float(means[1]), float(variances[1])


@exercise(
    hints=[
        lambda last: (
            "62.94 comes from K = 0.8333 / (0.8333 + 2). What stands in (12), σ or σ²?"
            if is_about(last, 62.9412, within=2e-4)
            else "The satellite's number is a standard deviation. Formulas (10)–(14) want variances."
        ),
        "The prediction is now N(61.6667, 0.8333), the measurement N(66, 2²). Start with K.",
        "K = 0.8333 / (0.8333 + 4) = 0.1724. Move that fraction of the way from 61.6667 to 66.",
    ],
    wrong=slips.third_opinion.WRONG,
    unit="m",
    rtol=5e-4,
    otherwise=lambda mean: (
        f"Your answer lies {(mean - 61.6667) / 4.3333:.3g} of the way from 61.6667 m to 66 m. This share is K: which variance stands on top in it, and which two below?"
    ),
    then="The satellite moves the mean by only 0.75 m, although it is 4.3 m away. The variance becomes smaller, 0.69 m² in place of 0.83 m²: even an uncertain opinion helps, if its σ is right.",
)
def third_opinion():
    """The mean of N(61.6667, 0.8333) fused with a satellite fix of 66 m, σ = 2 m."""
    gain = 0.8333 / (0.8333 + 2**2)
    return 61.6667 + gain * (66 - 61.6667)


@exercise(
    hints=[
        "Three lines: first K from the two variances (12), then the mean (13), then the variance (14).",
        "K = var_x / (var_x + var_z). The mean starts at mean_x and moves the fraction K of the way to mean_z.",
        "`return mean_x + K * (mean_z - mean_x), var_x * (1 - K)`",
    ],
    inputs=two_opinions,
    wrong=slips.fuse.WRONG,
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
        "1/0.09 − 0.2 = 10.91, and readings come in whole numbers.",
    ],
    wrong=slips.readings_needed.WRONG,
    unit="readings",
    otherwise=lambda n: (
        f"With n = {n:.4g} the precision is 1/5 + n, and σ is {1 / math.sqrt(n + 0.2):.3g} m. Solve 1/5 + n = 1/0.3² for n."
    ),
    then="Ten readings give 0.313 m and eleven 0.299 m. Without the prediction it would take twelve: beside a good tape it saves one reading.",
)
def readings_needed():
    """How many readings with σ = 1 m bring a prediction of variance 5 m² below σ = 0.3 m?"""
    return math.ceil(1 / 0.3**2 - 1 / 5)


def two_variances(rng):
    """Variances of a prediction and a reading, round and different."""
    return tuple(rng.choice([0.25, 0.5, 2.0, 3.0, 4.5, 9.0, 100.0], 2, replace=False).tolist())


@exercise(
    hints=[
        "The mean squared error belongs to the returned mean. Which mean do the three versions return, and how far off is it on average? Only then divide by what is claimed.",
        "μx has the mean squared error var_x. The fused mean has var_x · var_z / (var_x + var_z), by (11).",
        "Published: var_x / var_z. Anna: fused / var_z. Ben: var_x / fused; with fused = var_x * var_z / (var_x + var_z).",
    ],
    inputs=two_variances,
    wrong=slips.published_claim.WRONG,
    then="For 5 and 1 m² these are 5, 5/6 and 6. Who mends one of the two faults may make things worse: Ben's ratio is even larger than that of the published version.",
)
def published_claim(var_x, var_z):
    """Real mean squared error over claimed variance: of N(μx, σz²), and with only its mean or only its variance mended."""
    fused = var_x * var_z / (var_x + var_z)
    return var_x / var_z, fused / var_z, var_x / fused


def three_covariances(rng):
    """P, R and a covariance c between them, with a parabola that has a lowest point."""
    P, R = rng.choice([1.0, 2.0, 4.0, 5.0, 9.0, 16.0], 2, replace=False).tolist()
    share = float(rng.choice([-0.5, -0.25, 0.25, 0.5, 0.75, 1.25, 1.25]))  # of the smaller one; 1.25: K beyond 0 or 1
    return P, R, (share if share**2 * min(P, R) < max(P, R) else 0.5) * min(P, R)


@exercise(
    hints=[
        "The error is (1 − K) e⁻ + K v, as before. The variance of a sum of two numbers is the sum of their variances plus twice their covariance.",
        "The covariance of (1 − K) e⁻ and K v is K (1 − K) c. So P(K) = (1 − K)² P + K² R + 2 K (1 − K) c. Where is its slope zero?",
        "−2 (1 − K) P + 2 K R + 2 (1 − 2 K) c = 0. Collect what belongs to K: K (P + R − 2 c) = P − c.",
    ],
    inputs=three_covariances,
    wrong=slips.common_cause.WRONG,
    otherwise=slips.common_cause.on_a_grid,
    then="With c = 0 this is (12). If c is larger than P, K is negative; if it is larger than R, K is above 1: then the best estimate is not even between the two numbers.",
)
def common_cause(P, R, c):
    """The best gain, when the errors of prediction and reading have the variances P and R and the covariance c."""
    return (P - c) / (P + R - 2 * c)
