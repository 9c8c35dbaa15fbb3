"""More wrong answers to exercises of lesson 22, each with the sentence that it gets."""

import numpy as np


def spread_about(p, means, covs, weights):
    apart = means - p @ means
    return np.tensordot(p, covs, 1) + (apart.T * weights) @ apart


def of_two(p, means, covs):
    x, P = p @ means, np.zeros((2, 2))
    for weight, mean, cov in zip(p, means, covs, strict=True):
        P += weight * (np.outer(mean - x, mean - x) + cov)
    return P


SLIPS = {}

SLIPS["mixture_cov"] = {
    "spread not weighted": (
        lambda p, means, covs: spread_about(p, means, covs, np.ones(len(p))),
        "The covariances are weighed, how far the means are apart is not. Each y yᵀ counts with its filter's probability too.",
    ),
    "spread averaged": (
        lambda p, means, covs: spread_about(p, means, covs, np.full(len(p), 1 / len(p))),
        "The covariances are weighed. You took the plain average of the y yᵀ: each counts with its filter's probability too.",
    ),
    "covariances not weighted": (
        lambda p, means, covs: covs.mean(axis=0) + spread_about(p, means, 0 * covs, p),
        "The spread of the means is right. The covariances must be weighed too: each with its filter's probability.",
    ),
    "covariances summed": (
        lambda p, means, covs: covs.sum(axis=0) + spread_about(p, means, 0 * covs, p),
        "The spread of the means is right. The covariances must be weighed too: each with its filter's probability.",
    ),
    "2 × 2": (
        of_two,
        "The size 2 stands in the function. It must work for any number of states: begin with zeros like `covs[0]`.",
        r"zeros\(\[?\(?2, ?2",
    ),
    "informations averaged": (
        lambda p, means, covs: np.linalg.inv(np.tensordot(p, np.linalg.inv(covs), 1)),
        "You averaged the inverses. One of the filters is right, and we do not know which: the covariances are averaged, and how far the means are apart comes on top.",
    ),
    "np.cov's divisor": (
        lambda p, means, covs: np.tensordot(p, covs, 1) + np.cov(means.T, aweights=p),
        "Nearly: by itself `np.cov` divides by less than the sum of the weights, as for a sample. Here it is a plain weighted mean: `ddof=0`.",
    ),
    "np.cov without weights": (
        lambda p, means, covs: np.tensordot(p, covs, 1) + np.cov(means.T),
        "The spread is that of `np.cov(means.T)`, without the weights and divided by M − 1. Each y yᵀ counts with its filter's probability.",
    ),
    "the last filter": (
        lambda p, means, covs: p[-1] * (covs[-1] + np.outer(means[-1] - p @ means, means[-1] - p @ means)),
        "Only the last filter is left: each turn of the loop overwrites P. Add to it.",
    ),
}  # fmt: skip
SLIPS["window_needed"] = {
    "0.1 not squared": (
        2 * 1.3**2 / 0.1,
        "S is squared, 0.1 is not. From 1.3 √(2/N) = 0.1 follows N = 2 · 1.3²/0.1².",
    ),
    "relative": (
        2 / 0.1**2 / 1.3**2,
        "S stands in the wrong place. A larger S scatters more and needs more innovations: N = 2 S²/0.1².",
    ),
    "the lesson's": (30, "30 is the lesson's window. How much does R̂ scatter with it? Solve S √(2/N) = 0.1 for N."),
    "half": (
        84.5,
        "The 2 stands on the wrong side: the mean of squares scatters by S √(2/N), not by S/√(2N).",
    ),
    "R alone, not squared": (20, "20 is 2 · 1/0.1. S = 1 + 0.3, and N = 2 S²/0.1²."),
    "S² alone": (1.69, "That is S². From S √(2/N) = 0.1 follows N = 2 S²/0.1²."),
    "added as deviations": (
        lambda: 2 * (1 + 0.3**0.5) ** 4 / 0.01,
        "That is right for S = (1 + √0.3)². 1 and 0.3 are variances: S = 1 + 0.3.",
    ),
}  # fmt: skip
