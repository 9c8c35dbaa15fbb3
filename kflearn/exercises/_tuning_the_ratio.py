"""Wrong answers to exercises of lesson 6, each with the sentence that it gets."""

import math


def balance(Q, R):
    """The steady gain of the scalar random walk."""
    q = Q / R
    return (math.sqrt(q**2 + 4 * q) - q) / 2


SHEETS = [
    (2.5**2, "In (a) the sheet gives σ itself: R is its square."),
    (0.3**2, "In (b), 95 % of the readings lie within ±2σ: halve the 0.6 °C first, then square."),
    (0.25**2 / 3, "In (c) a reading is rounded by a quarter of a volt at most: R is the square of this limit, over 3."),
]


KNOWN = [  # for each sheet: what a number would mean
    {
        56.25: "In (a), 56.2 is (3 · 2.5)². The sheet gives one sigma: R is the square of 2.5 m, without the 3.",
        1.5625: "In (a), 1.56 is (2.5/2)², as if 2.5 m were 2σ. The sheet says one sigma.",
        0.6944: "In (a), 0.694 is (2.5/3)², as if 2.5 m were 3σ. The sheet says one sigma.",
        2.0833: "In (a), 2.08 is 2.5²/3, as for hard limits. The sheet gives σ itself: R is its square.",
    },
    {
        0.36: "In (b), 0.36 is 0.6², as if 0.6 °C were σ. It holds 95 % of the readings, which is 2σ: halve it first, then square.",
        0.3: "In (b), 0.3 °C is σ. R is its square.",
        0.12: "In (b), 0.12 is 0.6²/3, as if ±0.6 °C were hard limits. 5 % of the readings lie beyond: 0.6 °C is 2σ.",
        0.04: "In (b), 0.04 is (0.6/3)², as if 0.6 °C were 3σ. It holds 95 % of the readings, which is 2σ.",
        0.03: "In (b), 0.3 °C is σ already. The 3 below the line belongs to hard limits.",
    },
    {},
]


def sheet_by_sheet(answer):
    """Which of three variances are right, and what to look at in the others."""
    faults, good = [], []
    for letter, value, (right, words), known in zip("abc", answer, SHEETS, KNOWN, strict=True):
        if abs(value / right - 1) > 0.05:
            faults.append(next((told for number, told in known.items() if abs(value / number - 1) < 0.005), words))
        else:
            good.append(letter)
    right = f"({') and ('.join(good)}) {'is' if len(good) == 1 else 'are'} right. " if good else ""
    return f"{right}{' '.join(faults)}" if faults else None


def of_sigma(sigma):
    """What a σ would mean; one that is nearly √(P + Q) is that, with rounded numbers."""
    if abs(sigma - 0.23505) < 5e-4:
        return "That is σ before a reading, √(P + Q). After the reading P = K·R is left: take its root."
    return (
        f"σ = {sigma:.3g} °C is a variance of {sigma**2:.3g} °C², and as P = K·R it would need K = {4 * sigma**2:.3g}. "
        "Which K solves K² + qK − q = 0?"
    )


WRONG = {
    "steady_sigma": {
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
    },
    "data_sheets": {
        "σ for σ²": (
            (2.5, 0.3, 0.25 / math.sqrt(3)),
            "Three right standard deviations. R is a variance: square each of them.",
        ),
        "limits squared": (
            (6.25, 0.36, 0.0625),
            "Those are the squares of 2.5, 0.6 and 0.25. (a) is right; (b) is 2σ, and (c) a hard limit: σ = a/√3.",
        ),
        "95 % taken for 1σ": (
            (6.25, 0.36, 0.25**2 / 3),
            "(a) and (c) are right. In (b), 95 % of readings lie within 2σ, so σ is half of 0.6 °C.",
        ),
        "95 % taken for 3σ": (
            (6.25, 0.04, 0.25**2 / 3),
            "(a) and (c) are right. In (b) 0.04 is (0.6/3)²; within 3σ lie 99.7 % of readings, within 2σ 95 %.",
        ),
        "halved after squaring": (
            (6.25, 0.18, 0.25**2 / 3),
            "(a) and (c) are right. In (b) halve first, then square: (0.6/2)², not 0.6²/2.",
        ),
        "whole step as limit": (
            (6.25, 0.09, 0.5**2 / 3),
            "(a) and (b) are right. In (c), rounding to the nearest half volt is wrong by a quarter of a volt at most: a = 0.25 V, and a is squared before it is divided by 3.",
        ),
        "limit as σ": (
            (6.25, 0.09, 0.0625),
            "(a) and (b) are right. In (c), 0.25 V is the largest error there can be; most are smaller: σ = a/√3.",
        ),
        "limit as 2σ": (
            (6.25, 0.09, 0.25**2 / 4),
            "(a) and (b) are right. In (c) 0.0156 is (0.25/2)², which takes the limit for 2σ; a rounding error lies anywhere within it with equal chance: σ = a/√3.",
        ),
        "limit as 3σ": (
            (6.25, 0.09, 0.25**2 / 9),
            "(a) and (b) are right. In (c) 0.00694 is (0.25/3)², which takes the limit for 3σ; a rounding error lies anywhere within it with equal chance: σ = a/√3.",
        ),
        "√3 not squared": (
            (6.25, 0.09, 0.25**2 / math.sqrt(3)),
            "(a) and (b) are right. In (c) the √3 is squared too: R = a²/3.",
        ),
        "(a) not squared": (
            lambda: (2.5, 0.09, 0.25**2 / 3),
            "(b) and (c) are right. In (a) the sheet gives σ; R is its square.",
        ),
        "(a) halved": (
            lambda: (1.25**2, 0.09, 0.25**2 / 3),
            "(b) and (c) are right. In (a) the sheet says one sigma: 2.5 m is σ already.",
        ),
        "(b) not squared": (
            lambda: (6.25, 0.3, 0.25**2 / 3),
            "(a) and (c) are right. In (b) you have σ; R is its square.",
        ),
        "(c) not squared": (
            lambda: (6.25, 0.09, 0.25 / math.sqrt(3)),
            "(a) and (b) are right. In (c) you have σ; R is its square.",
        ),
        "(c) the limit itself": (
            (6.25, 0.09, 0.25),
            "(a) and (b) are right. In (c) the error is never larger than a = 0.25 V, half of a step. The variance is neither a nor the step squared: it is a²/3.",
        ),
        "(c) the step squared": (
            (6.25, 0.09, 0.125),
            "(a) and (b) are right. In (c) the limit is a = 0.25 V, half of a step, and the variance is a²/3.",
        ),
        "(b) doubled": (
            lambda: (6.25, 1.44, 0.25**2 / 3),
            "(a) and (c) are right. In (b) 1.44 is (2 · 0.6)²: 0.6 °C contains the 2 of 2σ already. Halve it, then square.",
        ),
        "(b) the limit itself": (
            lambda: (6.25, 0.6, 0.25**2 / 3),
            "(a) and (c) are right. In (b), 0.6 °C is 2σ: halve it, then square.",
        ),
        "(c) the step itself": (
            (6.25, 0.09, 0.5),
            "(a) and (b) are right. In (c), rounding is wrong by half of a step at most, a = 0.25 V, and the variance is a²/3.",
        ),
        "(c) a step of 1 V": (
            lambda: (6.25, 0.09, 1 / 3),
            "(a) and (b) are right. In (c) the step is half a volt, so an error is a = 0.25 V at most, and the variance is a²/3.",
        ),
        "numbers of the sheets": (
            (2.5, 0.6, 0.25),
            "These are the numbers of the sheets. Which of them is σ, which 2σ, which a hard limit? And R is a variance.",
        ),
        "(c) over 12": (
            lambda: (6.25, 0.09, 0.25**2 / 12),
            "(a) and (b) are right. In (c) the 12 belongs to the whole step, 0.5 V; with the limit a = 0.25 V it is a²/3.",
        ),
    },
}
