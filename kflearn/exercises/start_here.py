"""Lesson 0: start here."""

import math

import numpy as np

from kflearn.exercises._hints import is_about
from kflearn.exercises._slips import start_here as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "Add the three readings, then divide by how many there are.",
        "61 + 62 + 66 = 189.",
        "189 / 3 = 63.",
    ],
    wrong=slips.three_readings.WRONG,
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
    wrong=slips.readings_needed.WRONG,
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
    wrong=slips.update_mean.WRONG,
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
    wrong=slips.data_sheet.WRONG,
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
    wrong=slips.root_mean_square.WRONG,
    unit="m",
    then="For normally distributed errors the mean absolute error is 0.80 σ: that is why the published line looks a fifth better than it is.",
)
def root_mean_square(error):
    """The root mean square of an array of errors, which a published program replaces by their mean absolute value."""
    return np.sqrt(np.mean(error**2))
