"""What is judged in the open exercise of lesson 27, and what of a filter is measurably right."""

import numpy as np

from kflearn.exercises._a_ride import HOLE, REST, H, white
from kflearn.exercises._inside import added, share, used_R
from kflearn.exercises._judge import Mark, inside, likely, nees, pair, rms
from kflearn.exercises._scenes import Scene


def at_the_hole(answers, truths):
    """The mean of error² / P of each state at the end of the long hole, where no reading has come yet."""
    found = []
    for answer, truth in zip(answers, truths, strict=True):
        mean, cov = pair(answer)
        found.append((truth[HOLE] - mean[HOLE]) ** 2 / np.diag(cov[HOLE]))
    return np.mean(found)


def beside_it(value):
    """A number of all rows but that at the end of the long hole."""

    def rest(answers, truths):
        kept = [tuple(np.delete(part, HOLE, axis=0) for part in pair(answer)) for answer in answers]
        return value(kept, [np.delete(truth, HOLE, axis=0) for truth in truths])

    return rest


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


def scenes(answers, recordings):
    """What the filter did in each ride, beside F, Q and H of each row."""
    found = []
    for answer, recording in zip(answers, recordings, strict=True):
        dt, (_, z, q) = steps(recording), recording[0]
        found.append(Scene(*pair(answer), moves(dt), q * spread(dt), np.zeros(4), H, z[1:]))
    return found


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


def of_rest(recordings):
    """The variance of the readings at rest, of one axis, in each ride."""
    return np.array([np.nanvar(z[time < REST], axis=0, ddof=1).mean() for (time, z, _), _ in recordings])


def refusals(answers, recordings):
    """Which readings are left unused, which are good, and which are far off, in each ride."""
    refused = [np.isinf(u) for u in corrections(answers, recordings)]
    off = [abs(z - truth[:, ::2]).max(axis=1)[1:] for (_, z, _), truth in recordings]
    sigma = [np.nanstd(z[time < REST], axis=0).mean() for (time, z, _), _ in recordings]
    pairs = list(zip(off, sigma, strict=True))
    return refused, [o < 4 * s for o, s in pairs], [o > 15 * s for o, s in pairs]


# ---- what is right in it


def F_right(answers, recordings):
    """Whether the state moves as it should where nothing is read."""
    pairs = zip(answers, recordings, strict=True)
    return all(abs(added(*pair(a), moves(steps(r)))[0][empty(r)]).max() < 1e-6 for a, r in pairs)


def R_right(answers, recordings):
    """Whether R is about the variance at rest."""
    used = np.array([np.median(u[np.isfinite(u)]) for u in corrections(answers, recordings)])
    return still(answers, recordings) and 0.6 < np.median(used / of_rest(recordings)) < 1.7


def gate_right(answers, recordings):
    """Whether good readings are used, and those that are far off are not."""
    refused, good, far = refusals(answers, recordings)
    return still(answers, recordings) and share(refused, good) < 0.05 and share(refused, far) > 0.9


MARKS = [
    Mark(
        "error of east (rms, after the rest)",
        beside_it(rms(0, 30)),
        high=5.5,
        unit="m",
        above=likely(
            (
                "Is there a gate for readings that are far off, by the NIS of two numbers? At 9 it refuses one good reading in 90, at 3 one in five.",
                gate_right,
            ),
            ("Has each step its own F and Q, with its own Δt?", still),
            ("Is R the variance at rest?", R_right),
            "In each row: predict, look whether there is a reading, gate, correct, keep x and P.",
        ),
    ),
    Mark(
        "error of the speed towards east (rms)",
        beside_it(rms(1, 30)),
        high=1.7,
        unit="m/s",
        above=likely(
            ("Look at Δt in F, and at the order of the states: east, its speed, north, its speed.", F_right),
            ("Look at Q.", still),
            "The speed is corrected by its own row of K.",
        ),
    ),
    Mark(
        "truth within ±2σ of east",
        beside_it(inside(0, 30)),
        low=90,
        high=99,
        unit="%",
        below=likely(
            "The claimed σ is too small for the errors.",
            ("Is R a variance?", R_right),
            ("Is Q there for the whole Δt of a step?", still),
        ),
        above=likely(
            "The claimed σ is too large.",
            ("Was R taken from the rest alone, on each axis about its own mean?", R_right),
            ("Is Q not too large?", still),
        ),
    ),
    Mark(
        "NEES / 4",
        beside_it(nees(30)),
        low=0.75,
        high=1.4,
        below=likely("The covariance is too large for the errors.", ("Look at R.", R_right), ("Look at Q.", still)),
        above=likely(
            "The covariance is too small for the errors.",
            ("Look at the gate.", gate_right),
            ("Look at R.", R_right),
            ("Look at the long step.", still),
        ),
    ),
    Mark(
        "error² / P at the end of the long hole",
        at_the_hole,
        low=0.4,
        high=2.2,
        below=likely(
            "There your P is far too large.",
            ("Over a long step it shows which Δt, and which power of it, stands in Q.", still),
        ),
        above=likely(
            "There your P is far too small for the error.", ("Have F and Q of the long step its own Δt?", still)
        ),
    ),
]
