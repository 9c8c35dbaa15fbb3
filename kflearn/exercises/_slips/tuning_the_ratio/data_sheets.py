"""Lesson 6, `data_sheets`: wrong answers, each with the sentence that it gets."""

import math

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


WRONG = {
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
    "(c) without error": (
        (6.25, 0.09, 0),
        "(a) and (b) are right. In (c) R = 0 would make a rounded reading exact, but it may be wrong by up to a = "
        "0.25 V, half of a step. Errors that lie evenly within ±a have the variance a²/3.",
    ),
}
