"""Wrong answers to exercises of lesson 7 that a second stranger tried, and more of their kind."""

import numpy as np

from kflearn import chi_square_interval

WRONG = {
    "interval": {
        "seconds as runs": (
            lambda: chi_square_interval(2, 50 * 79),
            "Those are the limits for 50 · 79 runs, one for each second of 50 voyages. Within a run neighbouring errors are alike, so the average over 50 runs is that of 50 independent values.",
        ),
        "99 %": (
            lambda: chi_square_interval(2, 50, 0.99),
            "That interval holds 99 % of the averages; it should hold 95 %.",
        ),
        "90 % of twice": (
            lambda: chi_square_interval(2, 100),
            "Those are the limits for 100 runs. 50 · 2 are the degrees of freedom; the runs are 50.",
        ),
        "a bell, 2σ": (
            lambda: (2 - 4 / np.sqrt(50), 2 + 4 / np.sqrt(50)),
            "That is 2 ± 2 · 2/√50, ±2σ of a bell shape. The distribution is lopsided: take chi-square's own quantiles.",
        ),
        "one run, divided": (
            lambda: tuple(np.divide(chi_square_interval(2, 1), 50)),
            "Those are the limits for one run, divided by 50. The sum of 50 has a distribution of its own, with 50 · 2 degrees of freedom.",
        ),
        "their distance": (
            lambda: (2.0, 2.0),
            "2 is what the average should be. Chance moves it: between which limits?",
        ),
    },
    "nees": {
        "over the determinant": (
            lambda e, P: e @ e / np.linalg.det(P),
            "You divided by the determinant of P, which is a number of another unit. The inverse of P is a matrix, and e stands on both sides of it.",
        ),
        "squares of e": (
            lambda e, P: np.sum(np.linalg.inv(P) @ e**2),
            "That is Σ P⁻¹ e², as if e were squared first: the products of two different components are lost. `*` multiplies entry by entry; use `@`, with e on both sides of P⁻¹.",
        ),
        "1 over": (
            lambda e, P: 1 / (e @ P @ e),
            "That is 1/(eᵀ P e). It is P that has to be inverted, before it is multiplied.",
        ),
        "over the sum of P": (
            lambda e, P: e @ e / np.sum(P),
            "You divided the squared length by the sum of all entries of P. Each direction has its own variance: use P⁻¹.",
        ),
        "a logarithm too many": (
            lambda e, P: e @ np.linalg.solve(P, e) + np.log(np.linalg.det(P)),
            "eᵀ P⁻¹ e is right. The logarithm of the determinant belongs to the likelihood, not to NEES.",
        ),
        "largest": (
            lambda e, P: np.max(e**2 / np.diag(P)),
            "That is the largest of the squared errors over their variances. All components count, with their covariances.",
        ),
        "the other factor": (
            lambda e, P: np.sum(np.linalg.solve(np.linalg.cholesky(P).T, e) ** 2),
            "You solved with the transposed root. With P = L Lᵀ it is L that e is divided by: solve L y = e, and add up y².",
        ),
    },
    "share_inside": {
        "lower edge": (
            lambda e, P: np.mean(e >= -np.sqrt(P)),
            "You forgot the upper edge: errors far above zero count as inside. Take abs(e).",
        ),
        "mean NEES": (
            lambda e, P: np.mean(e**2 / P),
            "That is the mean of e²/P. A share is wanted: for how many of the errors is e²/P at most 1?",
        ),
        "mean in σ": (
            lambda e, P: np.mean(abs(e) / np.sqrt(P)),
            "That is how many σ an error is on average. A share is wanted: how many of them are at most 1σ?",
        ),
        "half of P": (
            lambda e, P: np.mean(abs(e) <= P / 2),
            "You compare with half the variance. σ is the root of P.",
        ),
        "squares and P squared": (
            lambda e, P: np.mean(e**2 <= P) > 0.683,
            "You say whether the share is above 68.3 %. Return the share itself.",
        ),
    },
    "draw_start": {
        "root of the product": (
            lambda mean, variances, normal: mean + np.sqrt(variances * normal),
            "The random number stands under the root: where it is negative there is no root. Take the root of the variance alone.",
        ),
        "added, not multiplied": (
            lambda mean, variances, normal: mean + np.sqrt(variances) + normal,
            "You added σ to the random number. It is to be stretched: multiply.",
        ),
        "divided by the variance": (
            lambda mean, variances, normal: mean + normal / variances,
            "You divided by the variance. The scatter is to become √variance: multiply by that.",
        ),
        "half of the variance": (
            lambda mean, variances, normal: mean + variances / 2 * normal,
            "You stretched by half the variance. The standard deviation is the root of the variance.",
        ),
        "mean times normal": (
            lambda mean, variances, normal: mean * normal + np.sqrt(variances),
            "Mean and σ have changed places: the random number stretches with σ, and the mean is added.",
        ),
        "squared numbers": (
            lambda mean, variances, normal: mean + np.sqrt(variances) * normal**2,
            "You squared the random numbers, so all starts lie above the mean.",
        ),
    },
}  # fmt: skip
