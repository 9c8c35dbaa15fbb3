"""What is said of filters that do not pass the open exercise of lesson 27, where the mistake can be recognised."""

import numpy as np

from kflearn.exercises._a_ride import MARKS, REST, H, white
from kflearn.exercises._inside import added, another_order, predictions, recognised, same_P, share, used_R
from kflearn.exercises._judge import pair


def steps(recording):
    return np.diff(recording[0][0])


def empty(recording):
    """The rows but the first in which nothing was read."""
    return np.isnan(recording[0][1][1:, 0])


def moves(dt):
    """F of each step."""
    F = np.tile(np.eye(4), (len(dt), 1, 1))
    F[:, 0, 1] = F[:, 2, 3] = dt
    return F


def spread(dt, push=white):
    """Q of each step with q = 1."""
    Q = np.zeros((len(dt), 4, 4))
    for i, row in enumerate(push(dt)):
        for j, entry in enumerate(row):
            Q[:, i, j] = Q[:, i + 2, j + 2] = entry
    return Q


def skipped(answer, answers, recordings):
    """Rows without a reading that are left at zero."""
    if all((pair(a)[0][1:][empty(r)] == 0).all() for a, r in zip(answers, recordings, strict=True)):
        return "In the rows without a reading your mean is 0: they are skipped. Predict in every row, each with its own Δt from the time stamps."
    return None


def moved(answer, answers, recordings):
    """How far the state goes in the rows without a reading."""
    table = [(steps, None), *STEPS]
    for length, words in table:
        off = []
        for a, r in zip(answers, recordings, strict=True):
            dt = steps(r)
            push = added(*pair(a), moves(length(r) + 0 * dt))[0][empty(r)]
            off.append(abs(push).max())
        if max(off) < 1e-6:
            return words
    return None


LONG = "Over the long hole it must move for all of it: take Δt from the time stamps, in each step."
STEPS = [
    (lambda r: 1.0, f"Your state moves for one second in each step. {LONG}"),
    (lambda r: np.median(steps(r)), f"Your state moves for the median Δt in each step. {LONG}"),
    (lambda r: np.mean(steps(r)), f"Your state moves for the mean Δt in each step. {LONG}"),
    (lambda r: 0.0, "In the rows without a reading your state stays as it was. Predict in every row; correct where there is a reading."),
    (lambda r: np.append(steps(r)[1:], 1), "Your steps are shifted: in each row you use the Δt that follows it. The step to row k is time[k] − time[k − 1]."),
    (lambda r: r[0][0][1:], "Your F holds the time itself. Δt is the difference of two time stamps."),
]  # fmt: skip


def widened(answer, answers, recordings):
    """What is added to P in the rows without a reading."""
    found, tables, scale = [], [[] for _ in SPREADS], []
    for a, r in zip(answers, recordings, strict=True):
        dt, q = steps(r), r[0][2]
        right = q * spread(dt)
        found.append((added(*pair(a), moves(dt))[1] / right.max(axis=(1, 2), keepdims=True))[empty(r)])
        scale.append(1.0)
        for rows, (other, _) in zip(tables, SPREADS, strict=True):
            rows.append((other(dt, q) / right.max(axis=(1, 2), keepdims=True))[empty(r)])
    return recognised(found, [(t, words) for t, (_, words) in zip(tables, SPREADS, strict=True)], scale)


def flat(d):
    return [[d**4 / 4, d**3 / 2], [d**3 / 2, d**2]]


def same(dt, d):
    return d + 0 * dt


SPREADS = [
    (lambda dt, q: q * spread(dt), None),
    (lambda dt, q: 0 * spread(dt), "Q is missing: P becomes F P Fᵀ, as if nothing ever disturbed the ride."),
    (lambda dt, q: q * spread(dt, flat), "Your Q is that of one push which lasts the whole step: Δt⁴/4. It makes P far too large over the long hole. q is white acceleration, in m²/s³: Δt³/3, Δt²/2, Δt."),
    (lambda dt, q: q * spread(same(dt, 1.0)), "Your Q is that of one second in each step. Over the long hole much more can happen: build Q from each step's own Δt."),
    (lambda dt, q: q * spread(same(dt, np.median(dt))), "Your Q is that of the median Δt in each step. Over the long hole more can happen: build Q from each step's own Δt."),
    (lambda dt, q: q * spread(dt, lambda d: [[d**3 / 3, 0], [0, d]]), "Your Q lacks its corners, q Δt²/2: what changes the speed changes the position too."),
    (lambda dt, q: q * spread(dt, lambda d: [[0, 0], [0, d]]), "Your Q holds the speeds only. Within a step the position is disturbed as well, by q Δt³/3."),
    (lambda dt, q: q * np.eye(4) + 0 * spread(dt), "Your Q is q on its diagonal, whatever the step. Build it from Δt: q Δt³/3, q Δt²/2, q Δt."),
    (lambda dt, q: q * dt[:, None, None] * np.eye(4), "Your Q is q Δt on its diagonal. For the position it is q Δt³/3, and between position and speed q Δt²/2."),
    (lambda dt, q: q**2 * spread(dt), "Your Q holds q². q is a variance already, per second: do not square it."),
    (lambda dt, q: spread(dt), "Your Q lacks the factor q."),
    (lambda dt, q: 0.5 * spread(dt), "Your Q holds the lesson's 0.5 m²/s³. Here q is given."),
]  # fmt: skip


def still(answers, recordings):
    """Whether all that was added to P in rows without a reading is right: then the answer is a filter."""
    pairs = zip(answers, recordings, strict=True)
    return all(
        np.allclose(added(*pair(a), moves(steps(r)))[1][empty(r)], r[0][2] * spread(steps(r))[empty(r)], rtol=1e-3)
        for a, r in pairs
    )


def corrections(answers, recordings):
    """For each recording the R used in each row."""
    pairs = zip(answers, recordings, strict=True)
    return [used_R(pair(a)[1], moves(steps(r)), r[0][2] * spread(steps(r)), H) for a, r in pairs]


def trusts(answer, answers, recordings):
    """The R of the corrections."""
    if not still(answers, recordings):
        return None
    used = [u[np.isfinite(u)] for u in corrections(answers, recordings)]
    if not all(map(len, used)):
        return None
    found = np.array(list(map(np.median, used)))
    rest = [inputs[1][inputs[0] < REST] for inputs, _ in recordings]
    right = np.array([np.nanvar(each, axis=0, ddof=1).mean() for each in rest])
    if np.ptp(found) < 1e-6 * found.max():
        return f"Your R is {found[0]:.3g} m² in all rides. It is another one in each file: take it from the first 30 s."
    near = lambda other: np.all(abs(found - other) < 0.05 * other)  # noqa: E731
    if near(np.array([np.nanvar(inputs[1], axis=0).mean() for inputs, _ in recordings])):
        return "Your R is the variance of the whole ride, so the ride itself counts as noise. Nothing moves in the first 30 s only."
    if near(np.array([np.nanvar(each) for each in rest])):
        return "Your R is taken about one mean for both axes: east and north lie far apart. Take off each axis' own mean (`axis=0`)."
    if near(right**0.5):
        return "Your R is the standard deviation of the readings at rest. R is their variance."
    if near(right**2):
        return "Your R is the square of the variance at rest. The variance is R already."
    if near(2 * right):
        return "Your R is the sum of the variances of east and north. R is that of one axis: their mean."
    ratio = np.median(found / right)
    if 0.6 < ratio < 1.7:
        return None
    look = "Is it taken from these alone, and each axis about its own mean?" if ratio > 1 else "Is it a variance?"
    return f"Your R is {ratio:.2g} times the variance of the readings in the first 30 s (median of the rides). {look}"


def gates(answer, answers, recordings):
    """Which readings are left unused."""
    if not still(answers, recordings):
        return None
    refused = [np.isinf(u) for u in corrections(answers, recordings)]
    off = [abs(z - truth[:, ::2]).max(axis=1)[1:] for (_, z, _), truth in recordings]
    sigma = [np.nanstd(z[time < REST], axis=0).mean() for (time, z, _), _ in recordings]
    good = [o < 4 * s for o, s in zip(off, sigma, strict=True)]
    if share(refused, good) > 0.99:
        return "Your filter uses none of the readings: P never becomes smaller where there is one."
    if share(refused, [o > 15 * s for o, s in zip(off, sigma, strict=True)]) < 0.5:
        return (
            "Your filter uses readings that are far off. Is there a gate, by the NIS, and before the correction? And is it "
            "not so wide that all pass?"
        )
    if share(refused, good) > 0.05 and in_a_row(refused, good) > 0.5:
        return (
            f"Your filter refuses {100 * share(refused, good):.0f} % of the good readings, mostly many in a row: once locked "
            "out, it stays so for long. Compare with the prediction, by the NIS: S grows while nothing is used."
        )
    if share(refused, good) > 0.05:
        return (
            f"Your filter refuses {100 * share(refused, good):.0f} % of the good readings. NIS is the square of a distance "
            "in σ, and of two numbers: how large may it be?"
        )
    return None


def in_a_row(refused, good):
    """Which share of the good readings that are refused stands in runs of five or more refusals."""
    long, short = 0, 0
    for r, g in zip(refused, good, strict=True):
        for begin, end in runs(r):
            count = np.sum(g[begin:end])
            long, short = (long + count, short) if count >= 5 else (long, short + count)
    return long / max(long + short, 1)


def runs(marked):
    """The begin and the end of each run of True."""
    edges = np.diff(np.concatenate([[False], marked, [False]]).astype(int))
    return list(zip(np.flatnonzero(edges == 1), np.flatnonzero(edges == -1), strict=True))


ORDER = "In another order of your states all of this passes. The order is: east, its speed, north, its speed."
SIGNS = [same_P("rows"), skipped, predictions(1), another_order(MARKS, ORDER), moved, widened, trusts, gates]
