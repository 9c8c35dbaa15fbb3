"""Lesson 4: two opinions, one belief."""

import math

import numpy as np

from kflearn.exercises._turns import is_about
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
    wrong={
        "σ for σ²": (
            lambda: 61.6667 + 0.8333 / (0.8333 + 2) * (63 - 61.6667),
            "You weighed with σ = 2 m. (12) takes variances: the satellite's is 2² = 4 m², and 0.8333 m² is one already.",
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
            "61.67 m is where the cart was believed to be before the satellite. (Who fuses the satellite with N(60, 5), without the tape, gets the same number by chance.) Which way does 63 m pull it, and how far?",
        ),
        "satellite alone": (
            63,
            "63 m is the satellite alone. The 61.6667 m were worth more than it, as their variance is smaller.",
        ),
        "wrong sign": (
            lambda: 61.6667 - 0.8333 / (0.8333 + 4) * (63 - 61.6667),
            "The size of the step is right, but you went away from the satellite: 63 lies above 61.6667.",
        ),
        "variance": (lambda: 0.8333 * 4 / (0.8333 + 4), "That is the fused variance, in m². The mean was asked for."),
        "K": (lambda: 0.8333 / (0.8333 + 4), "That is the gain K. Go on: 61.6667 plus K times the way to 63."),
        "tape and satellite": (
            62.2,
            "You fused the tape N(62, 1) with the satellite. The prediction has been forgotten: begin with N(61.6667, 0.8333).",
        ),
    },
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
        "K swapped in both": (
            lambda mx, vx, mz, vz: (mx + vz / (vx + vz) * (mz - mx), vx * vx / (vx + vz)),
            "Your K has var_z on top: that is 1 − K. In (12) the prediction's variance stands on top, as a vague prediction must give way.",
        ),
        "σ in K, everywhere": (
            lambda mx, vx, mz, vz: (
                mx + math.sqrt(vx) / (math.sqrt(vx) + math.sqrt(vz)) * (mz - mx),
                vx * math.sqrt(vz) / (math.sqrt(vx) + math.sqrt(vz)),
            ),
            "You formed K from standard deviations; (12) wants the variances themselves.",
        ),
        "the tape's variance times 1 − K": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vz * vz / (vx + vz)),
            "The mean is right. In (14) it is the prediction's variance that is multiplied by 1 − K, not the tape's.",
        ),
        "precision": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), 1 / vx + 1 / vz),
            "The mean is right. Your second number is the sum of the precisions, in 1/m². Turn it over: 1 divided by it is the variance.",
        ),
        "K z added": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * mz, vx * vz / (vx + vz)),
            "The variance is right. To the mean you added a part of mean_z itself: add a part of the difference, mean_z − mean_x.",
        ),
        "only the step": (
            lambda mx, vx, mz, vz: (vx / (vx + vz) * (mz - mx), vx * vz / (vx + vz)),
            "The variance is right. The first number is the step alone: add it to mean_x.",
        ),
        "variances averaged": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), (vx + vz) / 2),
            "The mean is right. The variance is not the average of the two: it is smaller than each of them.",
        ),
        "variance squared": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx * (1 - vx / (vx + vz)) ** 2),
            "The mean is right. In (14) the factor 1 − K stands once, not squared: the tape's own error adds the rest.",
        ),
    },
    then="Exchange the two opinions and the result is the same: the formula does not ask which of them came first.",
)
def fuse(mean_x, var_x, mean_z, var_z):
    """Mean and variance of two opinions fused, eqs (12)–(14)."""
    K = var_x / (var_x + var_z)
    return mean_x + K * (mean_z - mean_x), var_x * (1 - K)


def far_off():
    """What σ so many readings would give."""
    for_each = {n: 1 / math.sqrt(1 / 5 + n) for n in range(1, 31) if n not in (3, 4, 10, 11, 12)}
    verdict = {True: "more than is allowed", False: "good enough, but fewer would do"}
    return {str(n): (n, f"With {n} readings σ is {s:.2f} m: {verdict[s > 0.3]}.") for n, s in for_each.items()}


@exercise(
    hints=[
        "Precisions 1/σ² add: the prediction brings 1/5, each reading brings 1/1.",
        "You need 1/5 + n ≥ 1/0.3².",
        "1/0.09 − 0.2 = 10.91: and you cannot read a tape 0.91 times.",
    ],
    wrong={
        "0.3 taken as a variance": (
            4,
            "Four readings bring the *variance* below 0.3 m². The question says σ below 0.3 m: a variance below 0.09 m².",
        ),
        "prediction forgotten": (
            12,
            "Twelve readings are enough, but fewer will do. The prediction brings a precision of 1/5, to be taken away from 1/0.09. (5 m² is a variance already: it is not squared.)",
        ),
        "rounded down": (10, "With 10 readings σ is 0.313 m: not yet below 0.3 m. Round up."),
        "not rounded": (
            lambda: 1 / 0.09 - 0.2,
            "The calculation is right, but you can only read the tape a whole number of times.",
        ),
        **far_off(),
        "variance, rounded down": (
            3,
            "With 3 readings σ is 0.56 m. Did you set 0.3 in place of 0.3²? The precision that is wanted is 1/0.09.",
        ),
        "not rounded, prediction forgotten": (
            lambda: 1 / 0.09,
            "1/0.09 is the precision that is wanted. The prediction brings a part of it, and readings come in whole numbers.",
        ),
        "5/0.09": (lambda: 5 / 0.09, "You divided the variances. With every reading *precisions* add: 1/5 + n."),
    },
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
        "the tape alone": (
            lambda mx, vx, mz, vz: (mz, vz),
            "N(μz, σz²) is the tape alone: now the prediction is ignored.",
        ),
        "weights exchanged": (
            lambda mx, vx, mz, vz: ((mx * vx + mz * vz) / (vx + vz), vx * vz / (vx + vz)),
            "The variance is right. In the mean the weights are exchanged: each opinion is multiplied by the variance of the *other* one.",
        ),
        "variances added": (
            lambda mx, vx, mz, vz: ((mx * vz + mz * vx) / (vx + vz), vx + vz),
            "The mean is right. You added the variances; when two opinions are fused it is the precisions that add.",
        ),
        "the prediction's variance": (
            lambda mx, vx, mz, vz: ((mx * vz + mz * vx) / (vx + vz), vx),
            "The mean is right. Your variance is the prediction's, from before the tape was read.",
        ),
        "averages": (
            lambda mx, vx, mz, vz: ((mx + mz) / 2, (vx + vz) / 2),
            "You took plain averages of both. The article's formulas weigh: the less certain opinion counts less.",
        ),
        "plain mean": (
            lambda mx, vx, mz, vz: ((mx + mz) / 2, vx * vz / (vx + vz)),
            "The variance is right. The mean is the plain average: weigh each opinion by the variance of the other one.",
        ),
        "variances averaged": (
            lambda mx, vx, mz, vz: ((mx * vz + mz * vx) / (vx + vz), (vx + vz) / 2),
            "The mean is right. The variance is no average of the two: it is smaller than each of them.",
        ),
        "1 − K": (
            lambda mx, vx, mz, vz: (mx + vz / (vx + vz) * (mz - mx), vx * vx / (vx + vz)),
            "Your K is 1 − K: in (12) the prediction's variance stands on top.",
        ),
        "precision": (
            lambda mx, vx, mz, vz: ((mx * vz + mz * vx) / (vx + vz), 1 / vx + 1 / vz),
            "The mean is right. Your second number is a precision: 1 divided by it is the variance.",
        ),
    },
    then="The fused variance is smaller than both, 0.83 m² from 5 and 1 m². The published sentence understates the knowledge and misses the position.",
)
def published_claim(mean_x, var_x, mean_z, var_z):
    """Mean and mean squared error of the fused estimate, which a published text gives as μx and σz²."""
    mean = (mean_x * var_z + mean_z * var_x) / (var_x + var_z)
    variance = var_x * var_z / (var_x + var_z)
    return mean, variance
