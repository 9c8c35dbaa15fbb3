"""Lesson 4: two opinions, one belief."""

import math

import numpy as np

from kflearn.exercises.engine import exercise


def two_opinions(rng):
    """Means and variances of a prediction and a measurement."""
    return rng.normal(50, 10), rng.uniform(0.5, 9), rng.normal(50, 10), rng.uniform(0.5, 9)


@exercise(
    hints=[
        "The satellite's number is a standard deviation. Formulas (10)–(14) want variances.",
        "The prediction is now N(61.6667, 0.8333), the measurement N(63, 2²). Start with K.",
        "K = 0.8333 / (0.8333 + 4) = 0.1724. Walk that fraction of the way from 61.6667 to 63.",
    ],
    wrong={
        "σ for σ²": (
            lambda: 61.6667 + 0.8333 / (0.8333 + 2) * (63 - 61.6667),
            "You used σ = 2 as if it were a variance; the variance is 2² = 4 m².",
        ),
        "1 − K": (
            lambda: 61.6667 + 4 / (0.8333 + 4) * (63 - 61.6667),
            "You gave the satellite the prediction's weight: K has the prediction's variance on top, K = 0.8333 / (0.8333 + 4).",
        ),
        "halfway": (
            lambda: (61.6667 + 63) / 2,
            "That is the plain average. The satellite (variance 4) knows less than the fused cart (variance 0.83) and must count less.",
        ),
        "old prediction": (
            lambda: 60 + 5 / 9 * 3,
            "You fused with the old prediction N(60, 5) and lost the tape: begin with N(61.6667, 0.8333).",
        ),
    },
    unit="m",
    rtol=5e-4,
)
def third_opinion():
    """The mean of N(61.6667, 0.8333) fused with a satellite fix of 63 m, σ = 2 m."""
    K = 0.8333 / (0.8333 + 2**2)
    return 61.6667 + K * (63 - 61.6667)


@exercise(
    hints=[
        "Three lines: first K from the two variances (12), then the mean (13), then the variance (14).",
        "K = var_x / (var_x + var_z). The mean starts at mean_x and walks the fraction K towards mean_z.",
        "return mean_x + K * (mean_z - mean_x), var_x * (1 - K)",
    ],
    inputs=two_opinions,
    wrong={
        "weights swapped": (
            lambda mx, vx, mz, vz: (mx + vz / (vx + vz) * (mz - mx), vx * vz / (vx + vz)),
            "Your variance is right, but the mean has 1 − K in place of K: the vaguer the prediction, the further you must walk.",
        ),
        "σ for σ²": (
            lambda mx, vx, mz, vz: (
                mx + math.sqrt(vx) / (math.sqrt(vx) + math.sqrt(vz)) * (mz - mx),
                vx * vz / (vx + vz),
            ),
            "You weighed with standard deviations; (12) wants the variances themselves.",
        ),
        "variances added": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx + vz),
            "You added the variances. That is what a prediction does; a measurement makes the variance smaller: σx²(1 − K).",
        ),
        "variance not reduced": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx),
            "The mean is right, but the variance is still the prediction's: (14) multiplies it by 1 − K.",
        ),
        "K times the variance": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx * vx / (vx + vz)),
            "The mean is right, but you kept the part K of the variance; what remains is the part 1 − K.",
        ),
        "innovation backwards": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mx - mz), vx * vz / (vx + vz)),
            "Your innovation has the wrong sign: measured minus expected, mean_z − mean_x, or you walk away from the tape.",
        ),
        "plain average": (
            lambda mx, vx, mz, vz: ((mx + mz) / 2, vx * vz / (vx + vz)),
            "The variance is right, but the mean is the plain average: weigh with K.",
        ),
        "standard deviation returned": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), math.sqrt(vx * vz / (vx + vz))),
            "The mean is right; the second number is a standard deviation, and a variance was asked for.",
        ),
    },
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
    wrong={
        "0.3 taken as a variance": (
            4,
            "You asked for a variance of 0.3 m²; the question says σ below 0.3 m, a variance below 0.09 m².",
        ),
        "prediction forgotten": (
            12,
            "That is right for the tape alone; but the prediction knows something too: it brings a precision of 1/5.",
        ),
        "rounded down": (10, "With 10 readings σ is 0.313 m: not yet below 0.3 m. Round up."),
        "not rounded": (
            lambda: 1 / 0.09 - 0.2,
            "The calculation is right, but you can only read the tape a whole number of times.",
        ),
    },
    unit="readings",
)
def readings_needed():
    """How many readings with σ = 1 m bring a prediction of variance 5 m² below σ = 0.3 m?"""
    return int(np.ceil(1 / 0.3**2 - 1 / 5))


@exercise(
    hints=[
        "N(μx, σz²) takes its mean from one opinion and its variance from the other. Is either of them the fused one?",
        "Which number does the fused estimate move to, and how far? Formula (10) or (13). What is left of the variance? Formula (11) or (14).",
        "mean = (mean_x * var_z + mean_z * var_x) / (var_x + var_z), variance = var_x * var_z / (var_x + var_z)",
    ],
    inputs=two_opinions,
    wrong={
        "as published": (
            lambda mx, vx, mz, vz: (mx, vz),
            "That is still the published sentence: mean of the prediction, variance of the tape. The tape has not moved the mean at all.",
        ),
        "only the mean mended": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vz),
            "The mean is mended. The second fault remains: σz² is what the tape's own error is worth, before the prediction helped it.",
        ),
        "only the variance mended": (
            lambda mx, vx, mz, vz: (mx, vx * vz / (vx + vz)),
            "The variance is mended. The first fault remains: μx is where the prediction was, before the tape was read.",
        ),
        "the tape's law": (
            lambda mx, vx, mz, vz: (mz, vz),
            "N(μz, σz²) is the tape's own law: now the prediction is ignored.",
        ),
    },
)
def published_claim(mean_x, var_x, mean_z, var_z):
    """Mean and mean squared error of the fused estimate, which a published text gives as μx and σz²."""
    mean = (mean_x * var_z + mean_z * var_x) / (var_x + var_z)
    variance = var_x * var_z / (var_x + var_z)
    return mean, variance
