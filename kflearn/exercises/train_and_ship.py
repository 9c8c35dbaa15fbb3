"""Lesson 10: a train and a ship."""

import math

import numpy as np

from kflearn.exercises._train_and_ship import WRONG
from kflearn.exercises.engine import exercise


def speeds(rng):
    """The limits of a speed, and what the filter believes (m/s)."""
    low = float(rng.integers(0, 10))
    high = low + float(rng.integers(4, 30))
    return low, high, float(rng.integers(0, 30))


@exercise(
    hints=[
        "Two things make x̂₀ wrong: the speed scatters about the middle of its range, and the middle is not where the filter starts.",
        "The mean square about `believed` is the variance about the middle, plus the squared distance from the middle to `believed`.",
        "Where anything between two limits is equally likely, the variance is (high − low)²/12. Add ((low + high)/2 − believed)².",
    ],
    inputs=speeds,
    wrong={
        "as published": (
            lambda low, high, believed: 1.0,
            "That is the published answer again: 1, whatever is known. Then five becomes 'five, give or take one'.",
        ),
        "the wrong guess forgotten": (
            lambda low, high, believed: (high - low) ** 2 / 12,
            "That is the variance about the middle of the range. The filter starts at `believed`, and P₀ counts errors from there.",
        ),
        "the scatter forgotten": (
            lambda low, high, believed: ((low + high) / 2 - believed) ** 2,
            "That is the squared distance from the middle only; at believed = middle it would claim to know the speed exactly.",
        ),
        "a deviation": (
            lambda low, high, believed: math.sqrt((high - low) ** 2 / 12 + ((low + high) / 2 - believed) ** 2),
            "Rightly put together, and then the root was taken: P holds variances, in (m/s)².",
        ),
        "distance not squared": (
            lambda low, high, believed: (high - low) ** 2 / 12 + abs((low + high) / 2 - believed),
            "The distance from the middle to `believed` is in m/s; to be added to a variance it must be squared.",
        ),
        "the whole range squared": (
            lambda low, high, believed: (high - low) ** 2 + ((low + high) / 2 - believed) ** 2,
            "You took the whole range for a standard deviation. Between two limits the variance is the range squared, over 12.",
        ),
        "half the range squared": (
            lambda low, high, believed: (high - low) ** 2 / 4 + ((low + high) / 2 - believed) ** 2,
            "Half the range is the farthest that the speed can be from the middle; on average it is nearer: divide the range squared by 12.",
        ),
        "half the range squared, guess forgotten": (
            lambda low, high, believed: (high - low) ** 2 / 4,
            "Half the range as σ is too much between hard limits (divide the range squared by 12), and the wrong guess is missing.",
        ),
        "range over 12": (
            lambda low, high, believed: (high - low) / 12 + ((low + high) / 2 - believed) ** 2,
            "The 12 belongs under the range *squared*; m/s and (m/s)² cannot be added.",
        ),
        "the worst case": (
            lambda low, high, believed: max(abs(high - believed), abs(low - believed)) ** 2,
            "That is the worst error, squared. P₀ is the *mean* square: nothing is over-confident here, but the start counts too little.",
        ),
    },
)
def start_variance(low, high, believed):
    """The honest P₂₂ when the speed lies between two limits, all equally likely, and the filter starts at `believed`."""
    middle = (low + high) / 2
    return (high - low) ** 2 / 12 + (middle - believed) ** 2


def positions(rng):
    """Positions of something that moves, and the time between two of them."""
    dt = float(rng.integers(1, 11) / 10)
    return 50 + np.cumsum(rng.integers(0, 20, int(rng.integers(8, 12))) / 2), dt


@exercise(
    hints=[
        "Five differences need six readings. Which is the first reading that has five before it?",
        "The sixth, `z[5]`. Start from `np.full(len(z), np.nan)` and fill it from there on.",
        "Five differences in a row add up to one: the average at k is `(z[k] - z[k - 5]) / (5 * dt)`.",
        "`speed[5:] = (z[5:] - z[:-5]) / (5 * dt)`, in an array that was NaN before.",
    ],
    inputs=positions,
    wrong=WRONG["running_average"],
)
def running_average(z, dt):
    """The average of the last five differences at each reading, in units per second; NaN where five do not exist."""
    speed = np.full(len(z), np.nan)
    speed[5:] = (z[5:] - z[:-5]) / (5 * dt)
    return speed


def fix_errors(rng):
    """Errors of fixes, east and north (m), with a mean that is not zero."""
    return (rng.normal([3, -2], [8, 12], (12, 2)).round(1),)


@exercise(
    hints=[
        "A mean error has a sign, and is in metres: one number for east, one for north.",
        "Root mean square, read backwards: square first, then the mean, then the root. Which squares? Those of the distance.",
        "`errors.mean(axis=0)`, and the squared distance of a fix is `np.sum(errors**2, axis=1)`.",
        "`return errors.mean(axis=0), np.sqrt(np.mean(np.sum(errors**2, axis=1)))`",
    ],
    inputs=fix_errors,
    wrong={
        "as published": (
            lambda e: (np.cov(e.T), np.mean(np.hypot(*e.T))),
            "That is the published report again: a covariance called a mean, and a mean distance called RMS.",
        ),
        "mean distance": (
            lambda e: (e.mean(axis=0), np.mean(np.hypot(*e.T))),
            "The mean is right. The second number is still the mean distance: square, *then* average, then take the root.",
        ),
        "rms right, covariance": (
            lambda e: (np.cov(e.T), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first is still a covariance, in m²: a mean error is in metres.",
        ),
        "variances": (
            lambda e: (e.var(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first are variances, in m²: a mean error is in metres and has a sign.",
        ),
        "an rms for each axis": (
            lambda e: (e.mean(axis=0), np.sqrt(np.mean(e**2, axis=0))),
            "The mean is right. You return one rms for each axis, as R wants them; the rms *distance* is one number.",
        ),
        "all numbers alike": (
            lambda e: (e.mean(axis=0), np.sqrt(np.mean(e**2))),
            "The mean is right. `np.mean` over all 2T numbers gives an rms per axis, √2 too small: first add the squares of a fix.",
        ),
        "root forgotten": (
            lambda e: (e.mean(axis=0), np.mean(np.sum(e**2, axis=1))),
            "The mean is right. The second is a mean square, in m²: the root is missing.",
        ),
        "about the mean": (
            lambda e: (e.mean(axis=0), np.sqrt(np.mean(np.sum((e - e.mean(axis=0)) ** 2, axis=1)))),
            "The mean is right. But you took it away before squaring: a receiver that is always 50 m off would get a fine mark.",
        ),
        "mean not divided": (
            lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2))),
            "The mean is right. You took the root of the *sum* over all fixes: more fixes would make the error larger.",
        ),
        "mean of both axes": (
            lambda e: (e.mean(), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The mean needs `axis=0`: east and north apart, else one hides the other.",
        ),
        "mean of each fix": (
            lambda e: (e.mean(axis=1), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. You averaged east with north in each fix: the mean goes over the fixes, `axis=0`.",
        ),
        "mean without sign": (
            lambda e: (abs(e).mean(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. A mean error keeps its sign: errors to both sides cancel, and so they should.",
        ),
    },
)
def report(errors):
    """The mean error (east, north) and the root mean square distance of the errors (T, 2) of fixes."""
    return errors.mean(axis=0), np.sqrt(np.mean(np.sum(errors**2, axis=1)))


@exercise(
    hints=[
        "For σ = 10 m on each axis the lesson printed all four numbers. Which of them is the one of this data sheet?",
        "Half of the fixes lay within 11.8 m where σ was 10 m. All distances grow in proportion to σ.",
        "σ = 6 m / 1.177, and R is its square.",
    ],
    unit="m²",
    rtol=5e-3,
    wrong={
        "σ = 6": (
            36.0,
            "You took 6 m for σ of an axis. Where σ is 10 m, half of the fixes lie within 11.8 m: σ is smaller than 6 m.",
        ),
        "as rms distance": (
            18.0,
            "You took 6 m for the rms *distance*, √2 σ. Half of the fixes lie within a smaller circle, 1.18 σ.",
        ),
        "as mean distance": (
            lambda: 36 / (math.pi / 2),
            "You took 6 m for the mean distance, 1.25 σ. The radius that holds half of the fixes is 1.18 σ.",
        ),
        "a deviation": (
            lambda: 6 / math.sqrt(2 * math.log(2)),
            "That is σ, in metres. R is a variance: square it.",
        ),
        "as 2σ": (
            9.0,
            "You took 6 m for 2σ. A radius of 2σ holds 86 % of the fixes in the plane; this one holds half.",
        ),
        "on a line": (
            lambda: (6 / 0.6744897501960817) ** 2,
            "0.674σ holds half of the values on a *line*. In the plane both axes must be small at once, and it takes 1.18 σ.",
        ),
        "both axes": (
            lambda: 2 * 36 / (2 * math.log(2)),
            "That is the mean square distance, both axes together. R wants the variance of one axis: half of it.",
        ),
        "multiplied": (
            lambda: 36 * 2 * math.log(2),
            "You multiplied 6 m by 1.18. The radius is the larger number here, σ the smaller: divide.",
        ),
    },
)
def data_sheet():
    """Half of all fixes lie within 6 m of the truth: which R (m²) for each axis?"""
    sigma = 6 / math.sqrt(2 * math.log(2))
    return sigma**2


def two_fixes(rng):
    """Two fixes of one axis, the time between them, and R."""
    z0 = float(rng.integers(-100, 100))
    return z0, z0 + float(rng.integers(3, 40)), float(rng.integers(2, 9) / 2) + 0.5, float(rng.integers(2, 50))


@exercise(
    hints=[
        "The position is the last fix, z₁; its error is e₁, with variance R. Write the error of the speed with e₀ and e₁.",
        "The speed's error is (e₁ − e₀)/dt. Its variance is that of two readings, over dt². And it contains e₁: so the corner is not zero.",
        "The corner is the mean of e₁ · (e₁ − e₀)/dt, which is R/dt, for e₀ and e₁ are independent.",
        "`return np.array([z1, (z1 - z0) / dt]), R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]])`",
    ],
    inputs=two_fixes,
    wrong=WRONG["two_point_start"],
)
def two_point_start(z0, z1, dt, R):
    """Mean and covariance of (position, speed) after two fixes, dt apart, each with variance R."""
    mean = np.array([z1, (z1 - z0) / dt])
    return mean, R * np.array([[1, 1 / dt], [1 / dt, 2 / dt**2]])
