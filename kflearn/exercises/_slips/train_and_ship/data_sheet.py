"""Lesson 11, `data_sheet`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

SIGMA = 6 / math.sqrt(2 * math.log(2))

BOTH = "That is the mean square distance, both axes together. R wants the variance of one axis: half of it."
HALVED = "That is half of R. R is already the one of each axis: do not halve it."


WRONG = {
    "σ = 6": (
        36.0,
        "36 is 6², with 6 m for σ of an axis. Where σ is 10 m, half of the fixes lie within 11.8 m: σ is smaller than 6 m.",
    ),
    "as rms distance": (
        18.0,
        "18 is 6²/2, as if 6 m were the rms *distance*, √2 σ. Half of the fixes lie within a smaller circle, 1.18 σ.",
    ),
    "as mean distance": (
        lambda: 36 / (math.pi / 2),
        "22.9 is (6/1.25)², with 6 m for the mean distance, 1.25 σ. The radius that holds half of the fixes is 1.18 σ.",
    ),
    "a deviation": (lambda: 6 / math.sqrt(2 * math.log(2)), "That is σ, in metres. R is a variance: square it."),
    "as 2σ": (
        9.0,
        "9 is (6/2)², as if 6 m were 2σ. A radius of 2σ holds 86 % of the fixes in the plane; this one holds half.",
    ),
    "on a line": (
        lambda: (6 / 0.6744897501960817) ** 2,
        "0.674σ holds half of the values on a *line*. In the plane both axes must be small at once, and it takes 1.18 σ.",
    ),
    "both axes": (
        lambda: 2 * 36 / (2 * math.log(2)),
        BOTH,
    ),
    "multiplied": (
        lambda: 36 * 2 * math.log(2),
        "49.9 is (6 · 1.18)². The radius is the larger number here, σ the smaller: divide.",
    ),
    "not squared, not divided": (
        6.0,
        "6 is the radius of the sheet itself, and not an R. (You get 6 also if you take 6 m for R95, 2.45 σ. But half of the fixes are within 1.18 σ.) First find σ of one axis, then square it.",
    ),
    "rms distance, not squared": (
        lambda: 6 / math.sqrt(2),
        "4.24 is 6/√2, a σ if 6 m were the rms distance. Half of the fixes lie within 1.18 σ; and R is a variance.",
    ),
    "mean distance of the lesson": (
        lambda: (60 / 12.5) ** 2,
        "23.04 is (6/1.25)², and the lesson's 12.5 m is the *mean* distance. Which of the four numbers has half of the fixes inside?",
    ),
    "half of 6 m as σ": (
        3.0,
        "3 is half of the radius. R is a variance, and half of the fixes lie within 1.18 σ, not within 2 σ.",
    ),
    "half of σ": (
        lambda: 6 / math.sqrt(2 * math.log(2)) / 2,
        "2.55 is half of σ. R is the square of σ, and σ of one axis is 6 m/1.177.",
    ),
    "root of the radius over 1.18": (
        lambda: 6 / 1.177**2,
        "4.33 is 6/1.177², with the 6 m not squared. First σ = 6 m/1.177, then the square of it.",
    ),
    "36/1.18": (
        lambda: 36 / 1.18,
        "30.5 is 6²/1.18, with the 1.18 not squared. First σ = 6 m/1.18, then the square of it.",
    ),
    "1.18 · 36": (
        lambda: 36 * 1.18,
        "42.5 is 1.18 · 6². The radius is the larger number here, σ the smaller: divide, then square.",
    ),
    "2DRMS": (
        lambda: (6 / math.sqrt(8)) ** 2,
        "4.5 is (6/2.83)², as if 6 m were twice the rms distance, 2.83 σ. Half of the fixes lie within a smaller circle, 1.18 σ.",
    ),
    "over √2": (lambda: 36 / math.sqrt(2), "25.5 is 6²/√2. First σ of one axis, 6 m/1.18, then the square of it."),
    "rounded σ": (25.0, "σ is 6 m/1.18 = 5.1 m, so R is a little more than 25 m²: round only at the end."),
    "σ on a line": (
        lambda: 6 / 0.6745,
        "0.674σ holds half of the values on a *line*, and that is a σ, not a variance. In the plane half are within 1.18 σ.",
    ),
    "doubled": (144.0, "144 is 12². Half of the *fixes* are within 6 m, that is not half of σ: 6 m are 1.18 σ."),
    "twice 36": (72.0, "72 is (√2 · 6)². The radius is the larger number here, σ the smaller: σ = 6 m/1.18."),
    "R of 10 m": (
        100.0,
        "That is R of the lesson's receiver, with σ = 10 m. Of this one half of the fixes are within 6 m.",
    ),
    "multiplied σ": (
        lambda: 6 * 1.177,
        "7.06 is 1.18 · 6. The radius is the larger number here, σ the smaller; R is σ².",
    ),
    "a quarter": (
        lambda: SIGMA**2 / 4,
        "6.49 is the square of half of σ. 6 m/1.18 is σ of one axis already, and R is its square.",
    ),
    "over √2 of σ": (lambda: SIGMA / math.sqrt(2), "3.6 is σ/√2. 6 m/1.18 is σ of one axis already; R is its square."),
    "fourth power": (lambda: SIGMA**4, "674 is the fourth power of σ: square once."),
    "mean, not squared": (
        lambda: 6 / 1.25,
        "4.8 is 6/1.25, a σ, with 6 m for the mean distance. Half of the fixes lie within 1.18 σ; and R is a variance.",
    ),
    "95 % factor, not squared": (
        lambda: 6 / 2.45,
        "2.45 is √6, or 6/2.45 as if 6 m held 95 %. Half of the fixes lie within 1.18 σ; and R is a variance.",
    ),
    "6/1.18²": (
        6 / 1.18**2,
        "4.31 is 6/1.18², with the 6 m not squared. First σ = 6 m/1.18, then the square of it.",
    ),
    "1.18 · 6, squared": (
        lambda: (6 * 1.18) ** 2,
        "50.1 is (1.18 · 6)². The radius is the larger number here, σ the smaller: divide, then square.",
    ),
    "rms distance, 1.41": (
        lambda: (6 / 1.41) ** 2,
        "18.1 is (6/1.41)², with 6 m for the rms distance, 1.41 σ. Half of the fixes lie within a smaller circle, 1.18 σ.",
    ),
    "95 %": (
        lambda: (6 / 2.45) ** 2,
        "6.0 is (6/2.45)², with 6 m for the radius that holds 95 % of the fixes, 2.45 σ. This one holds half of them, and is 1.18 σ.",
    ),
    "halved, rounded": ((6 / 1.18) ** 2 / 2, HALVED),
    "halved, exactly": (36 / (4 * np.log(2)), HALVED),
    "log10": (
        lambda: 36 / (2 * np.log10(2)),
        "59.8 comes from `np.log10(2)`. The formula holds with the natural logarithm, `np.log(2)`.",
    ),
    "both axes, from 1.18": (
        lambda: 2 * (6 / 1.18) ** 2,
        BOTH,
    ),
}
