"""Lesson 27: your own data."""

from itertools import cycle

import numpy as np

from kflearn.exercises import _a_ride, _a_ride_seen, _a_ride_signs
from kflearn.exercises._hints import after
from kflearn.exercises._judge import track
from kflearn.exercises._slips import your_data as slips
from kflearn.exercises.engine import exercise, judged
from kflearn.results.consistency import chi_square_interval


@exercise(
    hints=[
        "The sum of squared deviations over R is chi-square with 40 degrees of freedom: one goes to the mean.",
        "`chi_square_interval(1, 40)` is the interval of (sample variance) / R. You want R: it stands in the denominator.",
        "With `ends = chi_square_interval(1, 40)` the answer is `(0.09 / ends[1], 0.09 / ends[0])`.",
    ],
    wrong=slips.interval_of_R.WRONG,
    otherwise=slips.interval_of_R.limits_of,
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
    wrong=slips.milliseconds_for_seconds.WRONG,
    otherwise=slips.milliseconds_for_seconds.in_thousands,
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
    wrong=slips.clock.WRONG,
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
    wrong=slips.variance_at_rest.WRONG,
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
