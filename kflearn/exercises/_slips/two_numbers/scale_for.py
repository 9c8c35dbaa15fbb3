"""Lesson 2, `scale_for`: wrong answers, each with the sentence that it gets."""

import numpy as np
from scipy.stats import chi2, norm


def stretched(scales, rights):
    """What is said of the scale of one number, or of the share, times a factor that is the same for all shares."""
    from scipy.stats import norm

    if np.ptp(scales) == 0:
        return None
    each = scales / (1 - np.exp(-(rights**2) / 2))
    if np.ptp(each) < 1e-3 * each[0]:
        return f"Your k is {each[0]:.3g} times the share. k is not proportional to the share: solve share = 1 − exp(−k²/2) for k."

    factor = scales / norm.ppf(1 - np.exp(-(rights**2) / 2) / 2)
    if np.ptp(factor) < 1e-3 and abs(factor[0] - 1) > 0.01:
        return "You stretched the scale of one number. One factor mends one share only: solve share = 1 − exp(−k²/2) for k."
    return None


WRONG = {
    "one number": (
        lambda share: norm.interval(share)[1],
        "That is right for one number: 1.96 for 95 %. With two numbers both have to be inside: solve share = 1 − exp(−k²/2).",
    ),
    "one-sided": (
        lambda share: norm.ppf(share),
        "`norm.ppf` is the quantile of one number, and of one side. For two numbers solve share = 1 − exp(−k²/2) for k.",
    ),
    "no root": (lambda share: -2 * np.log(1 - share), "That is k². Take the root."),
    "no 2": (
        lambda share: np.sqrt(-np.log(1 - share)),
        "exp(−k²/2) = 1 − share gives k² = −2 ln(1 − share): the 2 is missing.",
    ),
    "share for 1 − share": (
        lambda share: np.sqrt(-2 * np.log(share)),
        "That ellipse leaves the share outside. Inside is 1 − exp(−k²/2).",
    ),
    "log10": (
        lambda share: np.sqrt(-2 * np.log10(1 - share)),
        "`np.log10` is the logarithm to base 10. The formula has exp: use `np.log`.",
    ),
    "forwards": (
        lambda share: 1 - np.exp(-(share**2) / 2),
        "That is the share for a given k. It is k for a given share that is asked for: solve the formula for k.",
    ),
    "half": (
        lambda share: np.sqrt(-np.log(1 - share) / 2),
        "That is half of k: k² = −2 ln(1 − share), without another division by 2.",
    ),
    "root of both": (
        lambda share: norm.interval(np.sqrt(share))[1],
        "That is a square whose two sides hold √share each. An ellipse leaves the square's corners out: solve share = 1 − exp(−k²/2).",
    ),
    "always 2.45": (lambda share: 2.4477, "2.45 is right for 95 %. The function must work for every share."),
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
    "two tails": (
        lambda share: np.sqrt(-2 * np.log((1 - share) / 2)),
        "That ellipse leaves (1 − share)/2 outside. One number has two tails that share the rest; an ellipse has "
        "one outside, all around it: it holds 1 − share.",
    ),
    "half of the square": (
        lambda share: -np.log(1 - share),
        "That is k²/2, half of the chi-square quantile. k itself is asked for: two steps are left.",
    ),
    "straight lines": (
        lambda share: np.interp(share, [0, 0.395, 0.864, 0.949, 0.989], [0, 1, 2, 2.45, 3]),
        "It answers as if straight lines joined the few shares that the lesson names. The curve between them is "
        "bent, and goes on beyond them: solve share = 1 − exp(−k²/2) for k.",
    ),
}
