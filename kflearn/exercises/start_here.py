"""Lesson 0: start here."""

import math

import numpy as np

from kflearn.exercises._hints import is_about
from kflearn.exercises._slips_fourth import WRONG as FOURTH
from kflearn.exercises._slips_start import WRONG as SLIPS
from kflearn.exercises._slips_tenth_early import WRONG as TENTH
from kflearn.exercises._slips_third import WRONG as THIRD
from kflearn.exercises._start_here import WRONG
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "Add the three readings, then divide by how many there are.",
        "61 + 62 + 66 = 189.",
        "189 / 3 = 63.",
    ],
    wrong={
        "the middle one": (
            62,
            "62 is the middle reading, the median. The mean uses the size of every reading, so the 66 makes it larger than the median.",
        ),
        "the sum": (189, "189 is the sum of the readings; divide it by how many there are."),
        "divided by two": (94.5, "94.5 is 189/2. There are three readings."),
        "between the ends": (
            63.5,
            "63.5 is halfway between the smallest and the largest reading. The mean uses all three.",
        ),
        "the last two": (64, "64 is the mean of the last two readings. The first counts as much as they do."),
        "the first two": (61.5, "61.5 is the mean of the first two readings. The third counts as much as they do."),
        "the largest": (66, "66 is the largest reading. The mean uses all three."),
        "the smallest": (61, "61 is the smallest reading. The mean uses all three."),
    }
    | SLIPS["three_readings"]
    | THIRD["three_readings"]
    | FOURTH["three_readings"]
    | TENTH["three_readings"],
    unit="m",
    otherwise=lambda mean: (
        f"Your answer is {'too high' if mean > 63 else 'too low'}: three readings with this mean add up to {3 * mean:.6g} m. What do 61, 62 and 66 m add up to?"
    ),
    then="Two readings lie below the mean, by 2 m and 1 m, and one above it, by 3 m: the distances on both sides are equal.",
)
def three_readings():
    """The mean of the readings 61, 62 and 66 m."""
    return (61 + 62 + 66) / 3


@exercise(
    hints=[
        "The mean of n readings has the standard deviation σ/√n, here 2/√n metres.",
        "You need 2/√n = 0.25, so √n = 2/0.25.",
        "√n must be 8, so n = 8² = 64.",
    ],
    wrong=WRONG["readings_needed"],
    unit="readings",
    otherwise=lambda n: f"With n = {n:.4g}, 2/√n is {2 / math.sqrt(n):.3g} m. Solve 2/√n = 0.25 for n.",
    then="For 0.025 m you would need 6,400 readings: one more digit costs a hundred times as many.",
)
def readings_needed():
    """How many readings with σ = 2 m bring the σ of their mean down to 0.25 m?"""
    return (2 / 0.25) ** 2


def next_readings(rng):
    """A mean, the number of readings with the new one, the new reading."""
    mean = int(rng.integers(20, 41)) / 2
    return mean, int(rng.integers(2, 10)), mean + float(rng.choice([-6.5, -2, 1.5, 3, 7]))


@exercise(
    hints=[
        "Start at the old mean and go a part of the way towards the new reading. Which part?",
        "The surprise is z - mean, and the gain is 1 / n. n counts the new reading already.",
        "`return mean + (z - mean) / n`",
    ],
    inputs=next_readings,
    wrong=WRONG["update_mean"] | SLIPS["update_mean"] | THIRD["update_mean"],
    then="The gain 1/n goes to zero: the thousandth reading moves the mean by a thousandth of the surprise. If the length changes after all, the mean hardly follows.",
)
def update_mean(mean, n, z):
    """The mean of n readings, from the mean of the first n − 1 and the n-th reading z."""
    return mean + (z - mean) / n


@exercise(
    hints=[
        lambda last: (
            "You have σ. Is R a σ or its square?"
            if is_about(last, 3)
            else "95 % of the readings lie within ±2σ. So which part of the 6 m is σ?"
        ),
        "σ is 6/2 metres. R is a variance: square it.",
        "σ = 3 m, R = 3² = 9 m².",
    ],
    wrong={
        "σ": (3, "3 m is the standard deviation. R is a variance: square it."),
        "6² without halving": (
            36,
            "36 is the square of the ±6 m of the data sheet. 6 m is 2σ: halve it first, then square. This R is four times too large.",
        ),
        "as printed": (
            6,
            "6 m is the bound of the data sheet, 2σ, and in metres. R is σ², in square metres.",
        ),
        "halved after squaring": (
            18,
            "18 is twice σ²: 6² is (2σ)² = 4σ², and half of it is still 2σ². Halve the 6 m first, then square.",
        ),
        "doubled": (144, "144 is 12², or 4 · 6². The 6 m already contain the 2 of ±2σ: halve them, then square."),
        "±3σ": (
            4,
            "4 is (6/3)², which holds if ±6 m were ±3σ. Within ±3σ lie 99.7 %; the data sheet says 95 %, which is ±2σ.",
        ),
        "root": (
            lambda: math.sqrt(3),
            "1.73 is √3, the root of σ, or 6/√12, which is for an error that is never beyond ±3 m. From a standard deviation to a variance you square.",
        ),
        "12": (
            12,
            "12 is 6²/3, which is for an error that is never beyond its bound, or 2 · 6. Here 5 % of the readings lie outside: 6 m is 2σ. Halve it, then square.",
        ),
        "root of 6": (lambda: math.sqrt(6), "2.45 is the root of 6. R is a square: that of σ, and 6 m is 2σ."),
        "half of half": (
            2.25,
            "2.25 is (6/4)², which holds if 6 m were the whole width. It is ±6 m, so the width is 12 m, and 6 m is 2σ.",
        ),
        "6 by 2² the wrong way": (1.5, "1.5 is 6/4, half of σ. Halve the 6 m once, which gives σ = 3 m; then square."),
        "95 % of it": (
            34.2,
            "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ.",
        ),
        "95 % of σ": (5.7, "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ."),
        "95 % of it, squared": (
            32.49,
            "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ.",
        ),
        "95 % of the half, squared": (
            8.1225,
            "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ.",
        ),
        "σ with 1.96": (
            3.061224489795918,
            "That is σ, with 1.96 where this lesson says 2. R is a variance: square it.",
        ),
        "twice the square": (72, "72 is 2 · 6². The 6 m are 2σ: halve them first, then square."),
    },
    unit="m²",
    rtol=5e-3,
    otherwise=lambda R: (
        f"Your R says that σ is its root, {math.sqrt(R):.3g} m. What is σ, if ±6 m hold 95 % of the readings?"
    ),
    also=[(6 / 1.96) ** 2],
    then="With 1.96 in place of 2 it is 9.37 m², which is right as well: no data sheet is as exact as that.",
)
def data_sheet():
    """R for a receiver whose data sheet says ±6 m at 95 %."""
    half = 6 / 2  # σ
    return half**2


def errors(rng, n):
    """Some errors, not centred on zero."""
    return (rng.integers(-8, 9, n) / 2 + 1.5,)


@exercise(
    hints=[
        "Read the name backwards: first square, then take the mean, then the root. Which of these does the published line do?",
        "`error**2` squares every entry of an array, `np.mean` takes the mean, `np.sqrt` the root.",
        "`return np.sqrt(np.mean(error**2))`",
    ],
    inputs=in_turn(errors, 2, 6, 9, 3),
    wrong=WRONG["root_mean_square"] | SLIPS["root_mean_square"] | THIRD["root_mean_square"] | TENTH["root_mean_square"],
    unit="m",
    then="For normally distributed errors the mean absolute error is 0.80 σ: that is why the published line looks a fifth better than it is.",
)
def root_mean_square(error):
    """The root mean square of an array of errors, which a published program replaces by their mean absolute value."""
    return np.sqrt(np.mean(error**2))
