"""The open exercise of lesson 5: recordings of a voltmeter, what is looked at, and designs that pass and that do not."""

from typing import NamedTuple

import numpy as np

from kflearn import Gaussian, kalman_filter, random_walk

STEPS = 200


class Truth(NamedTuple):
    """The true voltage, where readings are missing, and what the best filter makes of the recording; (200,) each."""

    voltage: np.ndarray
    missing: np.ndarray
    best: np.ndarray


def recording(rng):
    """200 readings of a source that walks, with two gaps, and its Q and R: ((z, Q, R), Truth)."""
    R = 10 ** rng.uniform(0.5, 1.7)
    Q = R * 10 ** rng.uniform(-2, 0.5)
    voltage = rng.uniform(5, 20) + np.cumsum(rng.normal(0, np.sqrt(Q), STEPS))
    z = voltage + rng.normal(0, np.sqrt(R), STEPS)
    for first in (rng.integers(20, 80), rng.integers(110, 170)):
        z[first : first + rng.integers(4, 16)] = np.nan
    return (z, Q, R), Truth(voltage, np.isnan(z), filtered(z, Q, R)[0])


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
            return f"should hold {STEPS} {name}, but it holds {found.size}: one for each reading, the first included"
    return None


def collected(answers, truths):
    """All estimates, variances, true voltages and gaps, in flat arrays."""
    estimates, variances = (np.concatenate(part) for part in zip(*map(flat, answers), strict=True))
    return estimates, variances, *(np.concatenate(part) for part in zip(*truths, strict=True))


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


# ---- what to look at, from what the results do


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
        return "Your estimate moves from one missing reading to the next: does a NaN count as a number, such as 0? The estimate has to stay."
    if grows_in_gaps(answers, recordings):
        return "P grows by Q in the gaps, as it should. Look at the x and the P with which a gap begins."
    if grows_in_gaps([(a[0], np.square(a[1])) for a in map(flat, answers)], recordings):
        return "What you return grows in the gaps as a standard deviation does: return P itself, not its root."
    return "P has to grow by Q for each reading that is missing: yours does not."


def at_readings(answers, recordings):
    """What to look at where too few are inside at readings."""
    if moves_in_gaps(answers, recordings):
        return "After a gap the errors are too large for your variances: mend the gaps first."
    return "The variances are too small. Has P grown by Q before each gain, and is it P that you return, not its root?"


def of_errors(answers, recordings):
    """What to look at where the errors are too large."""
    if moves_in_gaps(answers, recordings):
        return "In the gaps your estimate moves although nothing was read: does a NaN count as a number, such as 0?"
    if all(
        np.allclose(flat(a)[0][~t.missing], z[~t.missing]) for a, ((z, *_), t) in zip(answers, recordings, strict=True)
    ):
        return "Your estimates are the readings themselves: with the gain K only a part of each reading counts."
    late = [np.mean(np.square(flat(a)[0][50:] - t.best[49:-1])) for a, (_, t) in zip(answers, recordings, strict=True)]
    now = [np.mean(np.square(flat(a)[0][50:] - t.best[50:])) for a, (_, t) in zip(answers, recordings, strict=True)]
    if np.mean(late) < 0.01 * np.mean(now):
        return "Your estimates are one reading late: keep x *after* the correction with that reading, not the prediction for it."
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
