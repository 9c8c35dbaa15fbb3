"""Lesson 25: when was it?"""

import numpy as np

from kflearn.exercises import _a_stream, _a_stream_seen, _a_stream_signs
from kflearn.exercises._judge import track
from kflearn.exercises._slips import when_was_it as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise, judged


def least_difference(v, late, dt):
    """The shift at which the two differ least, each about its own mean."""
    return np.argmin([np.var(v[: len(v) - j] - late[j:]) for j in range(11)]) * dt


def whole_series(v, late, dt):
    """NumPy's cross-correlation of the whole series, the means taken off."""
    return np.argmax(np.correlate(late - late.mean(), v - v.mean(), "full")[len(v) - 1 : len(v) + 10]) * dt


OTHER_WAYS = [least_difference, whole_series]


@exercise(
    hints=[
        "The reading belongs to a moment in the past. Where was the bus then, seen from where it is when the stamp says so?",
        "The distance is speed times time, in m/s and s: 54 km/h is 15 m/s.",
        "In 0.24 s the bus drives on by 15 · 0.24 m. The reading lies behind it by that much, so `-15 * 0.24`",
    ],
    wrong=slips.behind.WRONG,
    otherwise=slips.behind.of_no_table,
    unit="m",
    then="A receiver whose own error is 1 m is off by more than three of its σ, always in the same direction, and no mean over readings removes it.",
)
def behind():
    """By how many metres is the reading ahead of the bus (negative: behind it)?"""
    return -15 * 0.24


def two_speeds(rng, T):
    """The speeds of one drive in a town from two instruments; the second is late by some steps and has an offset."""
    lag, dt = 10 if T == 50 else int(rng.integers(0, 10)), rng.integers(1, 9) / 20  # the longest delay is tried too
    true = [12.0]
    for push in rng.normal(0, 1, T + lag - 1):  # it stops and goes, so that no trend hides the delay
        true.append(12 + 0.9 * (true[-1] - 12) + push)
    true = np.array(true)
    true[T:] += np.linspace(0, 5, lag)  # the end of the drive is not like its beginning, to which `np.roll` takes it
    late = true[:T] + rng.choice([-8, -6, 0, 6, 8]) + rng.normal(0, 0.1, T)  # an offset that must be taken out
    return np.round(true[lag:] + rng.normal(0, 0.1, T), 2), np.round(late, 2), dt


@exercise(
    hints=[
        "If the second series is late by j steps, `late[j:]` belongs to `v[:len(v) - j]`. Compare the two for each j from 0 to 10.",
        "An offset of one instrument must not count: the correlation of the two, `np.corrcoef(a, b)[0, 1]`, does not see it. It is largest at the right j.",
        "The number of steps times dt is the time in seconds.",
        "`found = [np.corrcoef(v[: len(v) - j], late[j:])[0, 1] for j in range(11)]`, then `np.argmax(found) * dt`",
    ],
    inputs=in_turn(two_speeds, 60, 50, 90),
    wrong=slips.clock_offset.WRONG,
    also=OTHER_WAYS,
    then="Speeds serve better than places: a place has no sharp features, and its correlation is near 1 at every shift.",
)
def clock_offset(v, late, dt):
    """The delay in s of the second of two series of speeds (T,) with steps dt, from 0 to 10 steps."""
    found = [np.corrcoef(v[: len(v) - j], late[j:])[0, 1] for j in range(11)]
    return np.argmax(found) * dt


@exercise(
    hints=[
        "On an even clock this program is right. What is different on an uneven one? Write down the steps for times = [1, 2, 5] and start = 0.",
        "F in round k must carry the state from the moment before to times[k]. Which dt does round 0 get, and which should it get?",
        "`np.diff(times, append=…)` gives the step *after* each reading. The step before it is `np.diff(times, prepend=start)`: that line is to be changed.",
    ],
    wrong=slips.which_step.WRONG,
    then="`np.diff(times, prepend=start)`: the step that ends at a reading. On an even clock both give the same numbers, so no test with an even clock finds the fault.",
)
def which_step():
    """Which line holds the fault?"""
    return {4}


@judged(
    hints=[
        "Keep a list of all readings in the order of the moments at which they were taken. What has to be computed again when one is put in before others?",
        "The simplest filter that is exact: after each row, sort the readings known up to now by t, go through all of them from the start, and then predict to `now`. It is slow, and it passes. Then remember the belief after each reading, and begin at the last one before the late reading.",
        "F and Q of a step of dt: [[1, dt], [0, 1]] and q [[dt³/3, dt²/2], [dt²/2, dt]]. A row whose z is NaN is a question: nothing is corrected, and the belief is predicted to `now`.",
        "`TimedFilter(lambda dt: discretise(A, L, q, dt), Gaussian(mean, cov), 0)` does it: `update(z, H, R, t)` for each reading, `predict_to(now)` for each row.",
    ],
    recording=_a_stream.stream,
    marks=_a_stream_seen.MARKS,
    form=track(2),
    then="Put your class into a file of its own, with a test that hands in the same readings in two orders: with a replay both must give the same belief.",
    passing=_a_stream.PASSING,
    failing=_a_stream.FAILING,
    signs=_a_stream_signs.SIGNS,
)
def live(now, t, z, H, R, q, mean, cov):
    """A filter for a stream of readings of which some arrive late: the belief at each `now`, mean (N, 2) and covariance (N, 2, 2).

    now (N,): when the row arrived; t (N,): when its reading was taken, in s. z (N,): the reading, NaN for a question.
    H (N, 2), R (N,): how the sensor sees [position in m, velocity in m/s], and its variance. q: white acceleration in
    m²/s³. mean (2,), cov (2, 2): the belief at the time 0.
    """

    def moved(x, P, dt):
        F = np.array([[1, dt], [0, 1]])
        return F @ x, F @ P @ F.T + q * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])

    kept, means, covs = [(0.0, -1, mean, cov)], [], []  # time, row, belief after its reading
    for k in range(len(now)):
        if not np.isnan(z[k]):
            younger = [each[1] for each in kept if each[0] > t[k]]
            kept = kept[: len(kept) - len(younger)]
            for i in [k, *younger]:  # the new one, and again all that were taken later
                time, _, x, P = kept[-1]
                x, P = moved(x, P, t[i] - time)
                K = P @ H[i] / (H[i] @ P @ H[i] + R[i])
                kept.append((t[i], i, x + K * (z[i] - H[i] @ x), P - np.outer(K, H[i] @ P)))
        x, P = moved(*kept[-1][2:], now[k] - kept[-1][0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
