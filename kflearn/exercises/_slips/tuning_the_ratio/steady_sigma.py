"""Lesson 6, `steady_sigma`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def balance(Q, R):
    """The steady gain of the scalar random walk."""
    q = Q / R
    return (math.sqrt(q**2 + 4 * q) - q) / 2


def of_sigma(sigma):
    """What a σ would mean; one that is nearly √(P + Q) is that, with rounded numbers."""
    if abs(sigma - 0.23505) < 5e-4:
        return "That is σ before a reading, √(P + Q). After the reading P = K·R is left: take its root."
    return (
        f"σ = {sigma:.3g} °C is a variance of {sigma**2:.3g} °C², and as P = K·R it would need K = {4 * sigma**2:.3g}. "
        "Which K solves K² + qK − q = 0?"
    )


WRONG = {
    "variance": (
        lambda: balance(0.01, 0.25) * 0.25,
        "That is the variance P = K·R, in °C². The question asks for σ, its root.",
    ),
    "gain": (lambda: balance(0.01, 0.25), "That is the gain K, a pure number. Go on: P = K·R, then the root."),
    "before the reading": (
        lambda: math.sqrt(balance(0.01, 0.25) * 0.25 + 0.01),
        "That is √(P + Q), what the filter claims before the next reading; after it, it is √P with P = K·R.",
    ),
    "√(KQ)": (
        lambda: math.sqrt(balance(0.01, 0.25) * 0.01),
        "0.0425 is √(K·Q). At the balance P = K·R: (9) with the K of (7).",
    ),
    "√(QR) for the variance": (
        lambda: (0.01 * 0.25) ** 0.25,
        "0.224 is the root of 0.05 °C², which is √(QR), or √q · R. That is nearly the variance after the reading for a very small q only: "
        "solve K² + qK − q = 0, and P = K·R.",
    ),
    "forgotten memory": (
        lambda: math.sqrt(0.01 * 0.25 / 0.26),
        "0.098 °C is less than the filter can know. Did you exchange Q and R, or fuse Q with R alone? R = 0.25 belongs to the thermometer, and what was left over counts too: P⁻ = P + Q.",
    ),
    "ratio upside down": (
        lambda: math.sqrt(balance(0.25, 0.01) * 0.25),
        "0.491 comes from q = 25, the ratio upside down: q = Q/R = 0.04.",
    ),
    "R alone": (0.5, "That is the thermometer alone, √R. The filter remembers earlier readings and does better."),
    "sum": (
        lambda: math.sqrt(0.26),
        "0.51 is √(Q + R). The filter's variance is smaller than that of a single reading, not larger.",
    ),
    "K σ": (
        lambda: balance(0.01, 0.25) * 0.5,
        "0.0905 is K · 0.5, the gain times the σ of a reading. It is the variance that is K·R: take the root after that.",
    ),
    "√K": (
        lambda: math.sqrt(balance(0.01, 0.25)),
        "That is 2σ, or the root of the gain without R: with R = 0.25 the two are one number. P = K·R, and one σ is asked for.",
    ),
    "√q": (
        0.2,
        "0.2 is √q, nearly the gain for a small q. Go on: K from K² + qK − q = 0, then P = K·R, then the root.",
    ),
    "√Q": (
        0.1,
        "0.1 °C is √Q, what the temperature wanders in a minute. What the filter knows of it also depends on R.",
    ),
    "P before": (
        lambda: balance(0.01, 0.25) * 0.25 + 0.01,
        "That is P⁻ = P + Q, a variance, before the reading. The question asks for σ after it.",
    ),
    "ratio": (0.04, "That is the ratio q = Q/R. The gain follows from it, then P = K·R, then the root."),
    "R": (
        0.25,
        "0.25 is R, the variance of the thermometer alone, and also about the lesson's σ, of another Q and R. Here the filter does better; and σ is a root.",
    ),
    "Q + R": (
        0.26,
        "0.26 is Q + R. The filter's variance is smaller than that of a single reading, not larger.",
    ),
    "Q": (
        lambda: 0.01,
        "That is Q, a variance: what the temperature wanders in a minute. What the filter knows also depends on R.",
    ),
    "fused, not rooted": (
        lambda: 0.01 * 0.25 / 0.26,
        "Q and R alone do not tell it: what was left over counts too, P⁻ = P + Q. And σ is a root.",
    ),
    "4 for 4q": (
        lambda: math.sqrt((math.sqrt(0.04**2 + 4) - 0.04) / 2 * 0.25),
        "0.495 comes from K = 0.98. Under the root in K stands q² + 4q: does the 4 lack its q?",
    ),
    "not halved": (
        lambda: math.sqrt((math.sqrt(0.04**2 + 0.16) - 0.04) * 0.25),
        "0.301 is the root of 2P. Either K is not divided by 2 at its end, or it is multiplied by σ = 0.5 °C in place of R = 0.25 °C².",
    ),
    "squared": (
        lambda: math.sqrt(balance(0.0001, 0.0625)) * 0.25,
        "0.0495 comes from 0.01² and 0.25². Q and R are given in °C², so they are variances already.",
    ),
    "golden": (
        lambda: math.sqrt(0.618034 * 0.25),
        "0.618 is the gain for Q = R. Here Q/R is 0.04: solve for K again.",
    ),
    "golden, variance": (
        lambda: 0.618034 * 0.25,
        "0.618 is the gain for Q = R. Here Q/R is 0.04; and σ is a root.",
    ),
    "ratio of σ": (
        lambda: np.sqrt((np.sqrt(0.2**2 + 4 * 0.2) - 0.2) / 2 * 0.25),
        "0.299 comes from q = 0.2, which is 0.1/0.5, the ratio of two σ. q = Q/R is the ratio of the variances.",
    ),
    "of the innovation": (
        lambda: np.sqrt((0.01 + np.sqrt(0.0101)) / 2 + 0.25),
        "0.552 is √(P⁻ + R), the σ of the innovation: so far a reading is from its prediction. The filter claims "
        "√P for its estimate, after the reading.",
    ),
    "both squared": (
        0.05,
        "0.05 °C is what Q = 0.01² and R = 0.25² make. 0.01 and 0.25 °C² are variances already: do not square them.",
    ),
}
