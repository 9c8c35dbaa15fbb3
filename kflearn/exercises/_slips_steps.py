"""More wrong answers to exercises of lessons 2 and 3, each with its sentence: those that a second stranger tried."""

import math

import numpy as np
from scipy.stats import chi2, norm

from kflearn.exercises._correction import WRONG as CORRECTION
from kflearn.exercises._predict_correct import F
from kflearn.exercises._slips_start import table


def parts(x, y):
    """The right variances and covariance."""
    return np.var(x), np.mean((x - x.mean()) * (y - y.mean())), np.var(y)


def with_corner(corner):
    """A table with the right variances and a corner made from (x, y, the right one)."""

    def made(x, y):
        a, c, b = parts(x, y)
        return table(a, corner(x, y, c), corner(x, y, c), b)

    return made


def upper_left(number):
    """The right covariance with another number at the upper left."""
    return [[number, 7], [7, 4]]


def corrected(x, P, z, H, R):
    """The right correction."""
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), P - K @ H @ P


def whole_step(correction):
    """A wrong correction after the right prediction."""
    return lambda x, P, z, F, H, Q, R: correction(F @ x, F @ P @ F.T + Q, z, H, R)


TAKEN = (
    "both kept",
    "covariance not reduced",
    "np.eye(2)",
    "np.eye(len(z))",
    "1 − K H",
)  # they have a sentence of their own, or a rule


WRONG = {
    "table_of": {
        "correlation in the corners": (
            with_corner(lambda x, y, c: c / (x.std() * y.std())),
            "The variances are right. In the corners stands the correlation, a pure number: the covariance is the mean of dx · dy, not divided by the σ's.",
        ),
        "N − 1 in the corners": (
            with_corner(lambda x, y, c: np.cov(x, y)[0, 1]),
            "The variances are right. In the corners you divided by N − 1, as `np.cov` does: divide by N there too.",
        ),
        "N − 1 on the diagonal": (
            lambda x, y: table(x.var(ddof=1), parts(x, y)[1], parts(x, y)[1], y.var(ddof=1)),
            "The corners are right. On the diagonal you divided by N − 1: divide by N there too.",
        ),
        "y not centred": (
            lambda x, y: table(parts(x, y)[0], parts(x, y)[1], parts(x, y)[1], np.mean(y * y)),
            "Three entries are right. For the variance of y take away the mean of y first.",
        ),
        "x not centred": (
            lambda x, y: table(np.mean(x * x), parts(x, y)[1], parts(x, y)[1], parts(x, y)[2]),
            "Three entries are right. For the variance of x take away the mean of x first.",
        ),
        "corners not centred": (
            with_corner(lambda x, y, c: np.mean(x * y)),
            "The variances are right. In the corners you averaged x · y: take the mean of each series away first.",
        ),
        "corner summed": (
            with_corner(lambda x, y, c: c * len(x)),
            "The variances are right. In the corners stands a sum over the pairs: divide by their number.",
        ),
        "product of variances": (
            with_corner(lambda x, y, c: x.var() * y.var()),
            "The variances are right. The corner is not their product: it is the mean of dx · dy, pair by pair.",
        ),
        "product of means": (
            with_corner(lambda x, y, c: x.mean() * y.mean()),
            "The variances are right. In the corners stands the product of the two means: a covariance is the mean of dx · dy.",
        ),
        "root of the corner": (
            with_corner(lambda x, y, c: np.sqrt(abs(c))),
            "The variances are right. You took the root of the corner: leave it as it is, with its sign.",
        ),
        "σ everywhere": (
            lambda x, y: table(x.std(), 0, 0, y.std()),
            "These are the standard deviations. The table holds variances, and in the corners the mean of dx · dy.",
        ),
    },
    "table_length": {
        "added, not rooted": (
            32.4,
            "32.4 mm² is a variance, and the corner is added in it. For a difference the corner is subtracted, twice; then take the root.",
        ),
        "σ for σ², all through": (
            lambda: math.sqrt(3 + 3 - 2 * 0.8 * 3),
            "1.1 is √(3 + 3 − 2 · 0.8 · 3), with 3 where 3² belongs: 3 mm is a σ. The variances are 9 mm², and the corner is 0.8 · 3 · 3.",
        ),
    },
    "told_speed": {
        "R = 1": (
            lambda: 10 + 6 / 14 * 3,
            "11.29 is 10 + 6/14 · 3, with 1 m² added to the variance of the position. This tape is perfect: the variance of its error is 0.",
        ),
        "0.9": (
            lambda: 10 + 0.9 * 3,
            "0.9 belongs to other numbers. Here the step for each metre is the corner of P over the variance of the position.",
        ),
        "variances": (
            lambda: 10 + 4 / 13 * 3,
            "10.92 is 10 + 4/13 · 3: that is the variance of the velocity over that of the position. On top belongs what the two share, the corner.",
        ),
    },
    "scale_for": {
        "one number, times √2": (
            lambda share: np.sqrt(2) * norm.interval(share)[1],
            "That is the scale for one number, times √2. The distance of two numbers has another distribution: solve share = 1 − exp(−k²/2) for k.",
        ),
        "three numbers": (
            lambda share: np.sqrt(chi2.ppf(share, 3)),
            "That is right for three numbers. The cloud has two: solve share = 1 − exp(−k²/2) for k.",
        ),
        "per cent": (
            lambda share: np.sqrt(-2 * np.log(1 - share / 100)),
            "You took the share for per cent. It is a number between 0 and 1.",
        ),
        "root of the scale": (
            lambda share: (-2 * np.log(1 - share)) ** 0.25,
            "You took the root twice: k² = −2 ln(1 − share), and one root of that is k.",
        ),
        "one number, squared": (
            lambda share: norm.interval(share)[1] ** 2,
            "That is the square of the scale for one number. For two numbers solve share = 1 − exp(−k²/2) for k.",
        ),
    },
    "predicted_covariance": {
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
            "That is the result without the corner of P, the 1. It belongs to the new corner, and twice to the upper left.",
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
    },
    "speedometer": {
        "gain added": (
            61.2,
            "61.2 is 60 + K₁. K₁ is a gain, in m for each m/s: multiply it by the innovation first.",
        ),
        "whole reading": (
            lambda: 60 + 1.2 * 13,
            "75.6 is 60 + K₁ · 13, with the whole reading. What counts is the innovation: the reading less what was expected of it.",
        ),
        "6/10": (
            lambda: 60 + 0.6 * 3,
            "61.8 is 60 + 0.6 · 3, and 0.6 is not K₁. K₁ is the corner over the variance of the innovation, and that is made from the velocity's variance and R.",
        ),
        "moved on, new speed": (
            lambda: 60 + 12.4,
            "72.4 is 60 + 12.4, one more second at the new speed. x̂⁻ is predicted already: only the correction is wanted.",
        ),
    },
    "misprints": {
        "Q twice": (
            lambda x, P, z, F, H, Q, R: corrected(F @ x, F @ P @ F.T + 2 * Q, z, H, R),
            "The second F is gone, and F P Fᵀ is right. But Q is added twice in line two: once is enough.",
        ),
        "Q squared": (
            lambda x, P, z, F, H, Q, R: corrected(F @ x, F @ P @ F.T + Q @ Q, z, H, R),
            "The second F is gone, and F P Fᵀ is right. Q holds variances already: it is not squared.",
        ),
    }
    | {
        label: (whole_step(answer), f"Both misprints are mended. {sentence}")
        for label, (answer, sentence, *pattern) in CORRECTION["correct"].items()
        if not pattern and label not in TAKEN
    },
}
