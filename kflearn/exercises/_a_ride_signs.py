"""What is said of filters that do not pass the open exercise of lesson 27, where the mistake can be recognised."""

import numpy as np

from kflearn.exercises import _scenes
from kflearn.exercises._a_ride import HOLE, REST
from kflearn.exercises._a_ride_seen import (
    MARKS,
    corrections,
    empty,
    moves,
    of_rest,
    refusals,
    scenes,
    spread,
    steps,
    still,
)
from kflearn.exercises._inside import added, another_order, predictions, recognised, same_P, share
from kflearn.exercises._judge import pair


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


def trusts(answer, answers, recordings):
    """The R of the corrections."""
    if not still(answers, recordings):
        return None
    used = [u[np.isfinite(u)] for u in corrections(answers, recordings)]
    if not all(map(len, used)):
        return None
    found = np.array(list(map(np.median, used)))
    rest, right = [inputs[1][inputs[0] < REST] for inputs, _ in recordings], of_rest(recordings)
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
        return "Your R is twice the variance at rest, as the sum of east and north. R is that of one axis: their mean."
    ratio = np.median(found / right)
    if 0.6 < ratio < 1.7:
        return None
    look = "is R taken from these alone, each axis about its own mean" if ratio > 1 else "is R a variance"
    return (
        f"A reading makes your P smaller as if R were {ratio:.2g} times the variance of the readings in the first 30 s (median of the rides): {look}, "
        "and is the correction of P right?"
    )


def gates(answer, answers, recordings):
    """Which readings are left unused."""
    if not still(answers, recordings):
        return None
    refused, good, far = refusals(answers, recordings)
    if share(refused, good) > 0.99:
        return "Your filter uses none of the readings: P never becomes smaller where there is one."
    if share(refused, far) < 0.5:
        return (
            "Your filter uses readings that are far off. Is there a gate, by the NIS, and before the correction? And is it "
            "not so wide that all pass?"
        )
    if share(refused, good) > 0.05 and in_a_row(refused, good) > 0.5:
        return (
            f"Your filter refuses {100 * share(refused, good):.0f} % of the good readings, mostly many in a row: once locked "
            "out, it stays so for long. Compare with the prediction, by the NIS. Is the limit too low?"
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


def begins(answer, answers, recordings):
    """The first state."""
    away = [np.linalg.norm(pair(a)[0][0, ::2] - r[0][1][0]) for a, r in zip(answers, recordings, strict=True)]
    if np.median(away) > 20:
        return f"Your state begins {np.median(away):.0f} m from the first reading (median of the rides). The first reading is good: begin there."
    return None


def hole(answer, answers, recordings):
    """How far the state goes, and what P is, at the end of the long hole."""
    pairs = [pair(a) for a in answers]
    if all(np.allclose(cov[HOLE], cov[0]) for _, cov in pairs):
        return "At the end of the long hole your P is that of the start again. The filter still knows how well it knew place and speed: predict P over the hole."
    last = HOLE - 1
    way = np.array([mean[HOLE, ::2] - mean[last, ::2] for mean, _ in pairs])
    speed = np.array([mean[last, 1::2] for mean, _ in pairs])
    times = np.sum(way * speed, axis=1) / np.sum(speed**2, axis=1)
    dt = np.array([steps(r)[last] for r in recordings])
    straight = np.linalg.norm(way - times[:, None] * speed, axis=1) < 1e-6 * (1 + np.linalg.norm(way, axis=1))
    if straight.all() and np.all(abs(times - dt) > 0.05 * dt):
        return f"Over the long hole of ride 1, which lasts {dt[0]:.3g} s, your state moves on for {times[0]:.2g} s. Its Δt is the difference of the two time stamps."
    return None


def exchanged(answer, answers, recordings):
    """P grows by the variance at rest where q belongs."""
    found = []
    for scene, ((_, _, q), _) in zip(scenes(answers, recordings), recordings, strict=True):
        unit = scene.Q[scene.empty] / q
        found.append(np.median(np.sum(scene.grown * unit, axis=(1, 2)) / np.sum(unit**2, axis=(1, 2))))
    found = np.array(found)
    rest = of_rest(recordings)
    if np.all(abs(found / rest - 1) < 0.5) and np.median(abs(found / rest - 1)) < 0.15:
        return "In the rows without a reading your P grows by the variance of the readings at rest times the matrix of Δt. There q belongs; the variance at rest is R, which belongs to S."
    return None


def seen(check, *words, of_filters_only=False):
    """A sign from a check of scenes."""
    return _scenes.sign(check, scenes, "rows", *words, z_at=1, of_filters_only=of_filters_only)


ORDER = "In another order of your states all of this passes. The order is: east, its speed, north, its speed."
SIGNS = [
    same_P("rows"),
    skipped,
    predictions(1),
    another_order(MARKS, ORDER),
    begins,
    moved,
    hole,
    widened,
    seen(_scenes.predicted),
    seen(_scenes.negative),
    seen(_scenes.rooted),
    exchanged,
    seen(_scenes.read_in_gaps, of_filters_only=True),
    seen(_scenes.growth),
    seen(_scenes.gain, "reading"),
    trusts,
    gates,
]
