"""The open exercise of lesson 5: recordings of a voltmeter, what is looked at, and designs that pass and that do not."""

from typing import NamedTuple

import numpy as np

from kflearn import Gaussian, kalman_filter, random_walk

STEPS = 200


class Truth(NamedTuple):
    """The true voltage, where readings are missing, what the best filter estimates, (200,) each; and (z[0], R)."""

    voltage: np.ndarray
    missing: np.ndarray
    best: np.ndarray
    start: tuple


def recording(rng):
    """200 readings of a source that walks, with two gaps, and its Q and R: ((z, Q, R), Truth)."""
    R = 10 ** rng.uniform(0.5, 1.7)
    Q = R * 10 ** rng.uniform(-2, 0.5)
    voltage = rng.uniform(5, 20) + np.cumsum(rng.normal(0, np.sqrt(Q), STEPS))
    z = voltage + rng.normal(0, np.sqrt(R), STEPS)
    for first in (rng.integers(20, 80), rng.integers(110, 170)):
        z[first : first + rng.integers(4, 16)] = np.nan
    return (z, Q, R), Truth(voltage, np.isnan(z), filtered(z, Q, R)[0], (z[0], R))


def filtered(z, Q, R, start=None, grow_in_gaps=True):
    """The loop of the lesson, with gaps."""
    x, P = (z[0], R) if start is None else start
    estimates, variances = [], []
    for k, reading in enumerate(z):
        known = not np.isnan(reading)
        if k or start is not None:
            P = P + Q * (known or grow_in_gaps)
            K = P / (P + R) if known else 0.0
            x, P = x + K * (reading - x if known else 0.0), (1 - K) * P
        estimates.append(x)
        variances.append(P)
    return np.array(estimates), np.array(variances)


# ---- what is looked at


def flat(answer):
    """Estimates and variances as flat arrays, from a pair or from a track of the package."""
    mean, cov = (answer.mean, answer.cov) if hasattr(answer, "cov") else answer
    return np.ravel(np.asarray(mean, float)), np.ravel(np.asarray(cov, float))


def two_series(answer, truth):
    """A form: estimates and variances, one of each for every reading."""
    try:
        estimates, variances = flat(answer)
    except (TypeError, ValueError):
        return f"should be a pair, estimates and variances, with {STEPS} numbers each"
    for name, found in (("estimates", estimates), ("variances", variances)):
        if found.size != STEPS:
            count = 0 if np.isnan(found).all() else found.size  # None holds none
            return f"should hold {STEPS} {name}, but it holds {count}: one for each reading, the first and the missing ones included"
    return None


def collected(answers, truths):
    """All estimates, variances, true voltages and gaps, in flat arrays."""
    estimates, variances = (np.concatenate(part) for part in zip(*map(flat, answers), strict=True))
    return estimates, variances, *(np.concatenate(part) for part in zip(*(truth[:3] for truth in truths), strict=True))


def error_ratio(answers, truths):
    """The error of each recording over that of the best filter, as a mean (root mean square) of all."""
    pairs = [
        np.sum((flat(answer)[0] - truth.voltage) ** 2) / np.sum((truth.best - truth.voltage) ** 2)
        for answer, truth in zip(answers, truths, strict=True)
    ]
    return np.sqrt(np.mean(pairs))


def inside(answers, truths, where):
    """The share, in per cent, of steps with (or without) a reading where the truth lies within ±2σ."""
    estimates, variances, voltage, missing, _ = collected(answers, truths)
    return 100 * np.mean(abs(estimates - voltage)[missing == where] <= 2 * np.sqrt(variances[missing == where]))


def inside_readings(answers, truths):
    """The share, in per cent, of steps with a reading where the truth lies within ±2σ."""
    return inside(answers, truths, False)


def inside_gaps(answers, truths):
    """The same for the steps without a reading."""
    return inside(answers, truths, True)


def nees(answers, truths):
    """The mean of error²/P."""
    estimates, variances, voltage, _, _ = collected(answers, truths)
    return np.mean((estimates - voltage) ** 2 / variances)


def starts(answers, truths):
    """The share of recordings, in per cent, whose first estimate is z[0] and whose first variance is R."""
    pairs = zip(answers, truths, strict=True)
    return 100 * np.mean([_begins(answer, *truth.start) == (True, True) for answer, truth in pairs])


def _begins(answer, reading, R):
    """Whether the first estimate is that reading and the first variance is R; nearly, for a start from a vague belief."""
    estimates, variances = flat(answer)
    return abs(estimates[0] - reading) <= 0.05 * np.sqrt(R), abs(variances[0] / R - 1) <= 0.02


# ---- what to look at, from what the results do


def of_start(answers, recordings):
    """What to look at where the first estimate or its variance is another."""
    rows = [(flat(answer), inputs) for answer, (inputs, _) in zip(answers, recordings, strict=True)]
    if not all(_begins(pair, z[0], R)[0] for pair, (z, _, R) in rows):
        return "The first estimate has to be the first reading, z[0]."
    twice = [R * (R + Q) / (2 * R + Q) for _, (_, Q, R) in rows]
    found = [pair[1][0] for pair, _ in rows]
    if np.allclose(found, twice, rtol=0.02):
        return "The first variance is too small: the first reading is the start, and your loop uses it a second time."
    if np.allclose(np.square(found), [R for _, (*_, R) in rows], rtol=0.02):
        return "The first variance is √R: R is a variance already."
    return "The first variance has to be R: nothing but the first reading is known then."


def _ratios(answers, recordings):
    """Each variance over that of the best filter, where there is a reading and in the gaps, without the start."""
    ratios, gaps = [], []
    for answer, ((z, Q, R), truth) in zip(answers, recordings, strict=True):
        ratios.append((flat(answer)[1] / filtered(z, Q, R)[1])[20:])
        gaps.append(truth.missing[20:])
    ratios, gaps = np.concatenate(ratios), np.concatenate(gaps)
    return ratios[~gaps], ratios[gaps]


def _are_right(ratios):
    return np.allclose(ratios, 1, rtol=0.02)


def of_variances(answers, recordings):
    """What to look at where the variances do not fit the errors."""
    if moves_in_gaps(answers, recordings):
        return "Your estimate moves in the gaps too, where nothing is read. A mean of the last few readings does that."
    at_readings, in_gaps = _ratios(answers, recordings)
    if _are_right(at_readings) and _are_right(in_gaps):
        return "Your variances are right. It is your estimates that do not fit them."
    if np.mean(abs(at_readings - 1) < 0.02) > 0.6:
        return "At most readings your variances are right. Are they right in the gaps, or just after them?"
    squares = [(a[0], np.square(a[1])) for a in map(flat, answers)]
    if _are_right(_ratios(squares, recordings)[0]):
        return "You return σ: a variance is wanted, P itself and not its root."
    before = [(flat(a)[0], _before(*inputs)) for a, (inputs, _) in zip(answers, recordings, strict=True)]
    if np.allclose(at_readings, _ratios(before, recordings)[0], rtol=0.02):
        return "At the readings you return the variance before each of them: wanted is the one after it, (1 − K)P."
    low, high = np.quantile(at_readings, [0.05, 0.95])
    return f"At the readings your variances are {low:.2g} to {high:.2g} times those of the best filter. Do they come from this recording's Q and R, with P + Q before each gain and (1 − K)P after it?"


def _before(z, Q, R):
    """The variances before each reading, of the best filter."""
    variances = filtered(z, Q, R)[1]
    return np.append(variances[:1], variances[:-1] + Q)


def exchanged(answer, answers, recordings):
    """Whether the variances are those of a filter with Q and R exchanged, whatever the first one is."""
    pairs = [
        (flat(a)[1][20:], filtered(z, R, Q)[1][20:]) for a, ((z, Q, R), _) in zip(answers, recordings, strict=True)
    ]
    if all(_are_right(mine / other) for mine, other in pairs):
        return "You exchanged Q and R: before each reading P grows by Q, and the gain is P/(P + R)."
    return None


def goes_away(answers, recordings):
    """Whether the estimates move away from the readings."""
    share = []
    for answer, ((z, *_), truth) in zip(answers, recordings, strict=True):
        x = flat(answer)[0]
        share += ((x[1:] - x[:-1]) * (z[1:] - x[:-1]) < 0)[~truth.missing[1:]].tolist()
    return np.mean(share) > 0.9


def moves_in_gaps(answers, recordings):
    """Whether estimates change between two missing readings."""
    return any(
        _gaps(a, r, 0).any() and abs(_gaps(a, r, 0)).max() > 1e-9 for a, r in zip(answers, recordings, strict=True)
    )


def grows_in_gaps(answers, recordings):
    """Whether the variances grow by Q from one missing reading to the next."""
    return all(np.allclose(_gaps(a, r, 1), r[0][1], rtol=1e-3) for a, r in zip(answers, recordings, strict=True))


def _gaps(answer, recording, part):
    """The changes of the estimates (0) or variances (1) between two missing readings."""
    missing = recording[1].missing
    return np.diff(flat(answer)[part])[missing[1:] & missing[:-1]]


def before_gaps(answers, recordings):
    """What to look at where too few are inside in the gaps."""
    if moves_in_gaps(answers, recordings):
        return "Your estimate moves from one missing reading to the next: does a NaN count as a number, such as 0 or the last reading? Or is it a mean of the last ones? The estimate has to stay."
    if grows_in_gaps(answers, recordings):
        return "P grows by Q in the gaps, as it should. Look at the x and the P with which a gap begins."
    if grows_in_gaps([(a[0], np.square(a[1])) for a in map(flat, answers)], recordings):
        return "What you return grows in the gaps as a standard deviation does: return P itself, not its root."
    if all((np.abs(_gaps(a, r, 1)) < 1e-12 * r[0][1]).all() for a, r in zip(answers, recordings, strict=True)):
        return "P has to grow by Q for each reading that is missing: yours does not."
    return "P does not grow by Q from one missing reading to the next. Is Q added there, and nothing else done? A gap corrects nothing: no factor 1 − K."


def too_wide_in_gaps(answers, recordings):
    """What to look at where too many are inside in the gaps."""
    if grows_in_gaps(answers, recordings):
        return "P grows by Q in the gaps, as it should. Is it too large already when a gap begins?"
    return "In a gap P grows by Q, once for each missing reading, and by no more."


def of_errors(answers, recordings):
    """What to look at where the errors are too large."""
    if moves_in_gaps(answers, recordings):
        return "In the gaps your estimate moves although nothing was read: does a NaN count as a number, such as 0 or the last reading? Or is it a mean of the last ones?"
    if all(
        np.allclose(flat(a)[0][~t.missing], z[~t.missing]) for a, ((z, *_), t) in zip(answers, recordings, strict=True)
    ):
        return "Your estimates are the readings themselves: with the gain K only a part of each reading counts."
    late = [np.mean(np.square(flat(a)[0][50:] - t.best[49:-1])) for a, (_, t) in zip(answers, recordings, strict=True)]
    now = [np.mean(np.square(flat(a)[0][50:] - t.best[50:])) for a, (_, t) in zip(answers, recordings, strict=True)]
    if np.mean(late) < 0.01 * np.mean(now):
        return "Your estimates are one reading late: keep x *after* the correction with that reading, not the prediction for it."
    if goes_away(answers, recordings):
        return (
            "Your estimates move away from the readings: x + K · (reading − x) moves towards them. Look at both signs."
        )
    if all(np.ptp(flat(a)[0]) == 0 for a in answers):
        return "Your estimate is the same for a whole recording: each reading has to move it, by K times the reading minus x."
    if all(map(_are_right, _ratios(answers, recordings))):
        return "Your variances are right, so the gain can be right as well. Look at the line of the estimate: x + K · (reading − x)."
    return "Does the gain come from this recording's Q and R, and is it formed anew for each reading?"


# ---- designs


def last_reading(z):
    """Each missing reading replaced by the last one before it."""
    return z[np.maximum.accumulate(np.where(np.isnan(z), 0, np.arange(len(z))))]


def packaged(z, Q, R):
    """The package's filter, from a vague belief."""
    return kalman_filter(random_walk(Q=Q, R=R), z, Gaussian(z[0], 1e4 * R))


def by_precision(z, Q, R):
    """The same in precisions: they add."""
    precision, state, found = 1 / R, z[0], []
    for reading in z:
        known = not np.isnan(reading)
        prior = precision if not found else 1 / (1 / precision + Q)
        precision = prior + known / R if found else prior
        state = (prior * state + (reading / R if known else 0.0)) / precision if found else state
        found.append((state, 1 / precision))
    return tuple(zip(*found, strict=True))


PASSING = {
    "from a vague start": lambda z, Q, R: filtered(z, Q, R, start=(12.0, 1e6)),
    "by precisions": by_precision,
    "the package": packaged,
}
FAILING = {
    "ignores all but the first": lambda z, Q, R: (np.full(len(z), z[0]), R + Q * np.arange(len(z))),
    "says 12 V": lambda z, Q, R: (np.full(len(z), 12.0), np.full(len(z), R)),
    "raw readings": lambda z, Q, R: (last_reading(z), np.full(len(z), R)),
    "raw readings, NaN kept": lambda z, Q, R: (z, np.full(len(z), R)),
    "the lesson's numbers": lambda z, Q, R: filtered(z, 4.0, 4.0),
    "Q and R swapped": lambda z, Q, R: filtered(z, R, Q),
    "σ returned": lambda z, Q, R: (filtered(z, Q, R)[0], np.sqrt(filtered(z, Q, R)[1])),
    "no growth in gaps": lambda z, Q, R: filtered(z, Q, R, grow_in_gaps=False),
    "gaps filled with the last reading": lambda z, Q, R: filtered(last_reading(z), Q, R),
    "gaps filled with zeros": lambda z, Q, R: filtered(np.nan_to_num(z), Q, R),
    "mean of all so far": lambda z, Q, R: filtered(z, 0.0, R),
    "predictions": lambda z, Q, R: tuple(
        np.append(part[:1], part[:-1]) + k * Q for k, part in enumerate(filtered(z, Q, R))
    ),
    "steady gain 0.618": lambda z, Q, R: filtered(z, R, R),
}
