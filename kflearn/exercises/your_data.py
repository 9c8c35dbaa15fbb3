"""Lesson 22: your own data."""

import numpy as np

from kflearn.exercises.engine import exercise
from kflearn.results.consistency import chi_square_interval

LOW, HIGH = chi_square_interval(1, 40)


@exercise(
    hints=[
        "The sum of squared deviations over R is chi-square with 40 degrees of freedom: one goes to the mean.",
        "`chi_square_interval(1, 40)` is the interval of (sample variance) / R. You want R: it stands in the denominator.",
        "With `low, high = chi_square_interval(1, 40)` the answer is `(0.09 / high, 0.09 / low)`.",
    ],
    wrong={
        "multiplied": (
            (0.09 * LOW, 0.09 * HIGH),
            "You multiplied. The chi-square number is sample variance / R, so R = 0.09 / number, and large numbers give "
            "the lower limit.",
        ),
        "ends swapped": ((0.09 / LOW, 0.09 / HIGH), "The two are right; hand in the lower limit first."),
        "41 degrees": (
            lambda: tuple(0.09 / end for end in chi_square_interval(1, 41)[::-1]),
            "Almost. The mean was estimated from the same readings, which costs one degree of freedom: 40.",
        ),
        "standard deviations": (
            lambda: tuple((0.09 / end) ** 0.5 for end in (HIGH, LOW)),
            "Those are the limits of σ. The question asks for R, the variance.",
        ),
        "σ taken for σ²": (
            lambda: tuple(0.3 / end for end in (HIGH, LOW)),
            "You put in the standard deviation, 0.3 m. 0.09 m² is the variance already.",
        ),
        "limits of one reading": (
            lambda: tuple(0.09 / end for end in chi_square_interval(1, 1)[::-1]),
            "That is what a single squared deviation would say. Forty of them say more: `runs=40`.",
        ),
        "40 dimensions": (
            lambda: tuple(0.09 / end for end in chi_square_interval(40)[::-1]),
            "`chi_square_interval(40)` is the interval of a sum of 40 squares, its middle is 40. You want their average: "
            "`chi_square_interval(1, 40)`.",
        ),
        "straight normal": (
            (0.09 * (1 - 1.96 * (2 / 40) ** 0.5), 0.09 * (1 + 1.96 * (2 / 40) ** 0.5)),
            "That is the rule of thumb R (1 ± 1.96 √(2/40)), symmetric about 0.09. The true interval is lopsided: it "
            "reaches further up than down.",
        ),
    },
    unit="m²",
    rtol=3e-3,
)
def interval_of_R():
    """41 readings at rest scatter with a sample variance of 0.09 m². Between which limits does R lie, at 95 %?"""
    low, high = chi_square_interval(1, 40)
    return 0.09 / high, 0.09 / low


@exercise(
    hints=[
        "Which power of a time stands in the unit of q?",
        "The position's share of Q is q Δt³/3, in m². All Δt are 1000 times too large, and this share has to stay.",
        "`0.1 / 1000**3`",
    ],
    wrong={
        "÷ 1000": (1e-4, "You divided by 1000 once. The unit of q is m²/s³: the time stands there three times."),
        "÷ 1000²": (1e-7, "You divided by 1000². The unit of q is m²/s³: the time stands there once more."),
        "times": (1e8, "The wrong way round: the steps have become longer, so the variance a second has to shrink."),
        "unchanged": (
            0.1,
            "With the same number q the position would be 10⁹ times as uncertain after each step: NIS would fall.",
        ),
        "√": (
            lambda: 0.1 / 1000**1.5,
            "You scaled a standard deviation. q is a variance a time, m²/s³: divide by 1000³.",
        ),
    },
    unit="m²/s³",
)
def milliseconds_for_seconds():
    """Time stamps in milliseconds are taken for seconds. Which q leaves NIS as it was with q = 0.1 m²/s³?"""
    return 0.1 / 1000**3


def gappy(rng):
    """Uneven time stamps (the first readings are there), and readings of which some are missing."""
    n = int(rng.integers(6, 10))
    time, z = np.cumsum(rng.integers(1, 5, n)) / 2, rng.integers(0, 20, n) / 2
    z[rng.choice(np.arange(2, n - 1), 2, replace=False)] = np.nan
    return time, z


@exercise(
    hints=[
        "Drop rows if you like, but drop their time stamps with them, and take the differences afterwards.",
        "`seen = ~np.isnan(z)` says which rows hold a reading. Which time stamps do they have?",
        "`return np.diff(time[~np.isnan(z)])`",
    ],
    inputs=gappy,
    wrong={
        "ones": (
            lambda time, z: np.ones((~np.isnan(z)).sum() - 1),
            "That is the bug itself: one reading, one second. Where a reading is missing the clock goes on.",
        ),
        "median": (
            lambda time, z: np.full((~np.isnan(z)).sum() - 1, np.median(np.diff(time))),
            "You gave every step the median length. Over a gap the step is longer.",
        ),
        "all rows": (
            lambda time, z: np.diff(time),
            "Those are the steps between all rows, the empty ones too. Their number no longer fits the readings.",
        ),
        "steps dropped": (
            lambda time, z: np.diff(time)[~np.isnan(z[1:])],
            "You took the differences first and then dropped those that lead to a gap. The time of the dropped steps is "
            "lost: the clock still stops. First drop, then take differences.",
        ),
        "times": (
            lambda time, z: time[~np.isnan(z)],
            "Those are the right time stamps. The filter wants the steps between them: `np.diff`.",
        ),
        "differences of readings": (
            lambda time, z: np.diff(z[~np.isnan(z)]),
            "You took differences of the readings. The steps are differences of the time stamps.",
        ),
        "backwards": (
            lambda time, z: -np.diff(time[~np.isnan(z)]),
            "Your steps are negative: the later time stamp minus the earlier one.",
        ),
    },
)
def clock(time, z):
    """The steps (s) between the readings that are there; time (T,), z (T,) with NaN where one is missing."""
    return np.diff(time[~np.isnan(z)])


def a_departure(rng):
    """Time stamps, readings that stand still and then leave, one of them missing, and the moment of departure."""
    time = np.arange(12) / 2
    until = float(rng.integers(5, 9)) / 2
    z = rng.integers(-4, 5, 12) / 4 + 3 * np.maximum(time - until, 0) + 5
    z[int(rng.integers(1, 4))] = np.nan
    return time, z, until


def at_rest(time, z, until):
    return z[time < until]


@exercise(
    hints=[
        "Which rows stand still? Those with `time < until`.",
        "One of them is NaN, so `np.nanvar`. And the mean is estimated from the same readings: `ddof=1`.",
        "`return np.nanvar(z[time < until], ddof=1)`",
    ],
    inputs=a_departure,
    wrong={
        "whole record": (
            lambda time, z, until: np.nanvar(z, ddof=1),
            "You took the whole record. Whatever moved counts as noise then: keep to `time < until`.",
        ),
        "whole record, ddof 0": (
            lambda time, z, until: np.nanvar(z),
            "You took the whole record. Whatever moved counts as noise then: keep to `time < until`.",
        ),
        "the moving part": (
            lambda time, z, until: np.nanvar(z[time >= until], ddof=1),
            "That is the variance of the ride. At rest means *before* `until`.",
        ),
        "NaN": (
            lambda time, z, until: np.var(at_rest(time, z, until), ddof=1),
            "One reading at rest is NaN, and so is your variance: use `np.nanvar`.",
        ),
        "NaN, ddof 0": (
            lambda time, z, until: np.var(at_rest(time, z, until)),
            "One reading at rest is NaN, and so is your variance: use `np.nanvar`.",
        ),
        "ddof 0": (
            lambda time, z, until: np.nanvar(at_rest(time, z, until)),
            "Almost: you divided by the number of readings. Their mean was estimated too, so divide by one less: `ddof=1`.",
        ),
        "standard deviation": (
            lambda time, z, until: np.nanstd(at_rest(time, z, until), ddof=1),
            "That is the standard deviation. R is the variance.",
        ),
        "about 0": (
            lambda time, z, until: np.nanmean(at_rest(time, z, until) ** 2),
            "You took the mean square about 0. Where it stood is not noise: take off the mean first.",
        ),
    },
)
def variance_at_rest(time, z, until):
    """R from the readings with time < until, at which nothing moved; z (T,) may hold NaN."""
    return np.nanvar(z[time < until], ddof=1)
