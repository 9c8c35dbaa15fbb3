"""Lesson 27: your own data."""

from itertools import cycle

import numpy as np

from kflearn.exercises import _a_ride, _a_ride_seen, _a_ride_signs
from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._hints import after
from kflearn.exercises._judge import track
from kflearn.exercises._slips_data import SLIPS
from kflearn.exercises._slips_eleventh import WRONG as ELEVENTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_data import WRONG as THIRD
from kflearn.exercises._your_data import WRONG
from kflearn.exercises.engine import exercise, judged
from kflearn.results.consistency import chi_square_interval

LOW, HIGH = chi_square_interval(1, 40)


@exercise(
    hints=[
        "The sum of squared deviations over R is chi-square with 40 degrees of freedom: one goes to the mean.",
        "`chi_square_interval(1, 40)` is the interval of (sample variance) / R. You want R: it stands in the denominator.",
        "With `ends = chi_square_interval(1, 40)` the answer is `(0.09 / ends[1], 0.09 / ends[0])`.",
    ],
    wrong={
        "multiplied": (
            (0.09 * LOW, 0.09 * HIGH),
            "That is 0.09 times the chi-square numbers. They are sample variance / R, so R = 0.09 / number, and large numbers give the lower limit.",
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
            "That is right for 0.3, the standard deviation in m. 0.09 m² is the variance already.",
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
        "the interval itself": (
            (LOW, HIGH),
            "That is the interval of (sample variance) / R. Solve for R: 0.09 divided by each end, the larger end"
            " first.",
        ),
        "two columns": (
            lambda: tuple(0.09 / end for end in chi_square_interval(2, 40)[::-1]),
            "That is what `chi_square_interval(2, 40)` gives, for two columns. Here it is one: `chi_square_interval(1, 40)`.",
        ),
        "eighty": (
            lambda: tuple(0.09 / end for end in chi_square_interval(1, 80)[::-1]),
            "That is the number for two columns together. One column of 41 readings has 40 degrees of freedom.",
        ),
        "41 degrees, multiplied": (
            lambda: tuple(0.09 * end for end in chi_square_interval(1, 41)),
            "Two things: one degree of freedom goes to the mean, which leaves 40; and R = 0.09 divided by the "
            "chi-square number.",
        ),
        "interval of the mean": (
            (0.09 - 2 * 0.3 / 41**0.5, 0.09 + 2 * 0.3 / 41**0.5),
            "That is how well the *mean* is known, ±2σ/√n, about the wrong middle. The variance has its own "
            "interval: chi-square.",
        ),
        "90 %": (
            lambda: tuple(0.09 / end for end in chi_square_interval(1, 40, 0.9)[::-1]),
            "That is the interval at 90 %. The question asks for 95 %, which is what `chi_square_interval` takes "
            "by itself.",
        ),
        "99 %": (
            lambda: tuple(0.09 / end for end in chi_square_interval(1, 40, 0.99)[::-1]),
            "That is the interval at 99 %. The question asks for 95 %, which is what `chi_square_interval` takes by itself.",
        ),
        "41 in the numerator": (
            lambda: tuple(0.09 * 41 / 40 / end for end in (HIGH, LOW)),
            "That is 41/40 of the right limits. The sample variance is the sum of squares by 40 already: 0.09 · 40 is that sum.",
        ),
        "chi-square itself": (
            (40 * LOW, 40 * HIGH),
            "Those are the limits of chi-square with 40 degrees of freedom. Divide the sum of squares, 0.09 · 40, by each.",
        ),
        "one number": (0.09, "That is the sample variance. Hand in two limits, `(low, high)`."),
    }
    | SLIPS["interval_of_R"]
    | THIRD["interval_of_R"]
    | FOURTH["interval_of_R"]
    | ELEVENTH["interval_of_R"],
    otherwise=facts.limits_of,
    unit="m²",
    rtol=3e-3,
    then=(
        "From 41 readings R is known to within a factor of about 0.7 to 1.6. To halve the width of that interval "
        "takes about four times as many readings."
    ),
)
def interval_of_R():
    """41 readings at rest scatter with a sample variance of 0.09 m². Between which limits does R lie, at 95 %?"""
    ends = chi_square_interval(1, 40)
    return 0.09 / ends[1], 0.09 / ends[0]


@exercise(
    hints=[
        after(
            1e-4,
            "That is right for a q in m²/s. How often does the time stand in m²/s³?",
            "Which power of a time stands in the unit of q?",
        ),
        "The position's share of Q is q Δt³/3, in m². All Δt are 1000 times too large, and this share has to stay.",
        "`0.1 / 1000**3`",
    ],
    wrong={
        "÷ 1000": (
            1e-4,
            "That is 0.1 divided by 1000 once. The unit of q is m²/s³: the time stands there three times.",
        ),
        "÷ 1000²": (1e-7, "That is 0.1 divided by 1000². The unit of q is m²/s³: the time stands there once more."),
        "times": (1e8, "The wrong way round: the steps have become longer, so the variance a second has to shrink."),
        "unchanged": (
            0.1,
            "With the same number q the position would be 10⁹ times as uncertain after each step: NIS would fall.",
        ),
        "√": (
            lambda: 0.1 / 1000**1.5,
            "That is 0.1 divided by 1000^1.5, as for a standard deviation. q is a variance a time, m²/s³: divide by 1000³.",
        ),
        "times 1000": (
            100.0,
            "That is 0.1 times 1000. The steps have become longer, so q has to shrink; and the time stands three times in m²/s³.",
        ),
        "times 1000²": (
            1e5,
            "That is 0.1 times 1000². The steps have become longer, so q has to shrink; and the time stands three times in m²/s³.",
        ),
        "root of 1000": (
            0.1 / 1000**0.5,
            "That is 0.1 divided by √1000. Look at the unit of q, m²/s³: divide by 1000 for each of the three times.",
        ),
        "÷ 1000⁴": (
            1e-13,
            "That is 0.1 divided by 1000⁴. The unit of q is m²/s³: three times, not four.",
        ),
        "÷ 10⁷": (1e-8, "The noughts: 1000³ is 10⁹, and 0.1 divided by that is 10⁻¹⁰."),
        "÷ 10¹¹": (1e-12, "The noughts: 1000³ is 10⁹, and 0.1 divided by that is 10⁻¹⁰."),
        "without 0.1": (
            1e-9,
            "That is 1/1000³. It is to be multiplied by the 0.1 that q was before.",
        ),
        "only 1000⁻³ of a third": (
            0.1 / 3 / 1000**3,
            "The third in q Δt³/3 stands on both sides and cancels: 0.1 divided by 1000³.",
        ),
        "negative": (
            -0.1,
            "A variance cannot be negative. Divide by 1000 for each of the three times in m²/s³.",
        ),
    }
    | SLIPS["milliseconds_for_seconds"]
    | THIRD["milliseconds_for_seconds"]
    | FOURTH["milliseconds_for_seconds"],
    otherwise=facts.in_thousands,
    unit="m²/s³",
    then=(
        "The card cannot tell, because Q is the same; but q says what can happen within one of its “seconds”, and "
        "this one says that nothing ever happens."
    ),
)
def milliseconds_for_seconds():
    """Time stamps in milliseconds are taken for seconds. Which q leaves NIS as it was with q = 0.1 m²/s³?"""
    return 0.1 / 1000**3


def holes(z, kind, rng):
    """Some readings are missing: in the middle, the first, the last, several in a row, or none."""
    z[rng.integers(1, 3)] = np.nan if kind != 4 else z[0]
    z[0] = np.nan if kind == 1 else z[0]
    z[-1] = np.nan if kind == 2 else z[-1]
    z[3:5] = np.nan if kind == 3 else z[3:5]
    return z


KINDS = cycle(range(5))  # each of them in the twenty trials


def gappy(rng):
    """Uneven time stamps, and readings of which some are missing."""
    n = int(rng.choice([9, 7, 6]))
    steps = rng.integers(3, 17, n)
    steps[4] *= 40 if n == 9 else 1  # a hole in some of them, whatever the other steps are
    time = np.cumsum(steps) / rng.choice([8.0, 0.125])  # steps of 0.4 to 2 s, or of 24 to 128 s
    return time, holes(rng.integers(0, 20, n) / 2, next(KINDS), rng)


@exercise(
    hints=[
        "Drop rows if you like, but drop their time stamps with them, and take the differences afterwards.",
        "`seen = ~np.isnan(z)` says which rows hold a reading. Which time stamps do they have?",
        "`return np.diff(time[~np.isnan(z)])`",
    ],
    inputs=gappy,
    wrong=WRONG["clock"] | THIRD["clock"] | FOURTH["clock"] | SEVENTH["clock"] | TENTH["clock"] | ELEVENTH["clock"],
    then="The sum of the steps is the time from the first reading to the last: a check worth having in every program that reads a clock.",
)
def clock(time, z):
    """The steps (s) between the readings that are there; time (T,), z (T,) with NaN where one is missing."""
    return np.diff(time[~np.isnan(z)])


def a_departure(rng):
    """Uneven time stamps, readings that stand still and then leave, some of them missing, and when they leave."""
    n, rows = int(rng.choice([24, 18, 12])), int(rng.integers(5, 9))
    time = np.cumsum(rng.integers(1, 9, n)) / 2 * rng.integers(1, 3)
    until = float(time[rows] - 0.25)  # between two time stamps: `<` or `<=` is all one
    z = rng.integers(-4, 5, n) / 4 + 3 * np.maximum(time - until, 0) + 5
    kind = next(KINDS)
    z[:rows] = holes(z[:rows], kind, rng)
    z[-1] = np.nan if kind == 3 else z[-1]
    return time, z, until


@exercise(
    hints=[
        "Which rows stand still? Those with `time < until`.",
        "One of them is NaN, so `np.nanvar`. And the mean is estimated from the same readings: `ddof=1`.",
        "`return np.nanvar(z[time < until], ddof=1)`",
    ],
    inputs=a_departure,
    wrong=WRONG["variance_at_rest"]
    | SLIPS["variance_at_rest"]
    | THIRD["variance_at_rest"]
    | ELEVENTH["variance_at_rest"],
    then="How well is it known? With n readings its relative error is about √(2/(n − 1)): for 20 readings a third.",
)
def variance_at_rest(time, z, until):
    """R from the readings with time < until, at which nothing moved; z (T,) may hold NaN."""
    return np.nanvar(z[time < until], ddof=1)


@judged(
    hints=[
        "Three things before the first step: R from the first 30 s, the steps Δt from the time stamps, and a start from the first reading. What does each of them look like in this lesson?",
        "In each step build F and Q from its own Δt, as `velocity` does. Then predict, ask for the NIS, correct if it passes the gate; a NaN never passes.",
        "`R = np.nanvar(z[time < 30], axis=0, ddof=1).mean()`; x = [z[0, 0], 0, z[0, 1], 0] with variances R and 9; a gate at 13.8 refuses one good reading in a thousand.",
    ],
    recording=_a_ride.a_ride,
    marks=_a_ride_seen.MARKS,
    form=track(4),
    then="Here the truth was known. For a file of your own the report card takes its place: hand it this filter, and read each line.",
    passing=_a_ride.PASSING,
    failing=_a_ride.FAILING,
    signs=_a_ride_signs.SIGNS,
)
def ride(time, z, q):
    """From the arrays of a file to a filter that can be defended: mean (T, 4) and covariance (T, 4, 4) at each time stamp.

    State: east, its speed, north, its speed, in m and m/s. time (T,): time stamps in s, uneven, with one long hole.
    z (T, 2): readings of east and north in m, of which some are NaN and some are far off; the first one is good. During
    the first 30 s nothing moves. q: white acceleration in m²/s³. R, in m², the same on both axes, is for you to find.
    """
    R = np.nanvar(z[time < 30], axis=0, ddof=1).mean()
    H, each = np.kron(np.eye(2), [[1, 0]]), np.eye(2)
    x, P = np.array([z[0, 0], 0, z[0, 1], 0]), np.kron(each, np.diag([R, 9]))
    means, covs = [x], [P]
    for dt, seen in zip(np.diff(time), z[1:], strict=True):
        F = np.kron(each, [[1, dt], [0, 1]])
        Q = q * np.kron(each, [[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])
        x, P = F @ x, F @ P @ F.T + Q
        y, S = seen - H @ x, H @ P @ H.T + R * each
        if y @ np.linalg.solve(S, y) < 13.8:  # never true for NaN
            K = np.linalg.solve(S, H @ P).T
            x, P = x + K @ y, P - K @ S @ K.T
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
