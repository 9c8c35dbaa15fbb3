"""What is said of filters that do not pass the open exercise of lesson 22, where the mistake can be recognised."""

import numpy as np

from kflearn.exercises import _scenes
from kflearn.exercises._inside import added, another_order, predictions, recognised, same_P, share
from kflearn.exercises._judge import pair
from kflearn.exercises._unknown_sensor import BAD, GOOD, settled
from kflearn.exercises._unknown_sensor_seen import MARKS, empty, learnt, restless, scenes, used


def widened(answer, answers, recordings):
    """What is added to P in the steps without a reading."""
    found, right = [], []
    for a, r in zip(answers, recordings, strict=True):
        mean, cov = pair(a)
        found.append(np.median(added(mean, cov, r[0][1])[1][empty(r)], axis=0))
        right.append(r[0][2])
    stay = all(
        np.array_equal(pair(a)[1][1:][empty(r)], pair(a)[1][:-1][empty(r)])
        for a, r in zip(answers, recordings, strict=True)
    )
    if stay:
        return "In the steps without a reading your P stays as it was. Predict in every step, also where z is NaN."
    table = [
        (right, None),
        ([0 * Q for Q in right], "Q is missing: P becomes F P Fᵀ in the steps without a reading."),
        ([2 * Q for Q in right], "P becomes F P Fᵀ + 2 Q in the steps without a reading: Q counts twice."),
    ]
    return recognised(found, table, [Q.max() for Q in right])


def moved(answer, answers, recordings):
    """How the state moves in the steps without a reading."""
    for F, words in MOVES:
        pairs = zip(answers, recordings, strict=True)
        if all(np.abs(added(*pair(a), F)[0][empty(r)]).max() < 1e-6 for a, r in pairs):
            return words
    return None


MOVES = [
    (
        np.eye(2),
        "In the steps without a reading your state stays as it was. Predict in every step, also where z is NaN.",
    ),
    (
        np.array([[1, 0.1], [0, 1]]),
        "Your state moves as the lesson's cart does. Here F and Q are given, of another cart.",
    ),
]


def gates(answer, answers, recordings):
    """Readings that are left unused."""
    R, seen = used(answers, recordings)
    refused = [np.isinf(each) for each in R]
    if share(refused, seen) > 0.99:
        return "Your filter uses none of the readings: P never becomes smaller where there is one."
    bad = [s & settled(truth[:, 2], BAD)[1:] for s, (_, truth) in zip(seen, recordings, strict=True)]
    part = 100 * share(refused, bad)
    if part > 15:
        return (
            f"Your filter refuses {part:.0f} % of the readings where the sensor is bad. They are worse than the data sheet "
            "says, but not useless: let R follow the sensor, so that they get a smaller weight."
        )
    return None


def moves_by(R, answers, recordings):
    """Whether the means move by the gain of that R."""
    fits = []
    for a, ((z, F, Q, *_), _) in zip(answers, recordings, strict=True):
        (mean, cov), seen = pair(a), np.isfinite(z[1:])
        ahead, x = F @ cov[:-1] @ F.T + Q, mean[:-1] @ F.T
        K = ahead[:, :, 0] / (ahead[:, :1, 0] + R)
        right = x + K * (z[1:] - x[:, 0])[:, None]
        fits.append(np.allclose(mean[1:][seen], right[seen], rtol=1e-3, atol=1e-3 * R**0.5))
    return all(fits)


def constant(answer, answers, recordings):
    """One R for all."""
    R, seen = used(answers, recordings)
    all_of_them = np.concatenate([each[s] for each, s in zip(R, seen, strict=True)])
    if np.ptp(all_of_them) < 1e-3 * all_of_them.min():
        if not moves_by(all_of_them[0], answers, recordings):
            return (
                f"Your P is corrected with R = {all_of_them[0]:.3g} m² in every step, but the mean moves by another gain. "
                "Use the same R, the learnt one, in both."
            )
        return f"Your filter uses R = {all_of_them[0]:.3g} m² in every step. No constant R passes: it must be learnt."
    late = np.concatenate([each[s][100:] for each, s in zip(R, seen, strict=True)]).reshape(-1)
    if np.ptp(late) < 1e-3 * late.min() or all(
        np.ptp(each[s][60:]) < 1e-3 * each[s][60:].min() for each, s in zip(R, seen, strict=True)
    ):
        return "Your R̂ does not change any more after a while. The sensor may change at any moment: go on learning, and let a bank change."
    return None


def waits(answer, answers, recordings):
    """R̂ that begins to change late."""
    R, _ = used(answers, recordings)
    seen = [each[np.isfinite(each)] for each in R]
    first = np.median([np.argmax(abs(each - each[0]) > 1e-3 * each[0]) for each in seen])
    if first > 60:
        return (
            f"Your R̂ stays at {seen[0][0]:.3g} m² for the first {first:.0f} readings: until then nothing is learnt, and the sensor "
            "changes earlier. For that a window must be shorter, or R̂ must begin with fewer innovations."
        )
    return None


def floored(answer, answers, recordings):
    """R̂ that comes near zero, though its window is long enough."""
    R, _ = used(answers, recordings)
    late = np.concatenate([r[settled(truth[:, 2], GOOD)[1:]] for r, (_, truth) in zip(R, recordings, strict=True)])
    part = 100 * np.mean(late[np.isfinite(late)] < 0.04)
    if part > 0.5 and not restless([np.maximum(each, 0.05) for each in R], recordings):
        return (
            f"Where the sensor is good, your R̂ is below 0.04 m² in {part:.2g} % of the steps: a reading is then taken for almost "
            "exact. C − HP⁻Hᵀ may come near zero or below it. Give R̂ a floor of 0.05 m² or more."
        )
    return None


def takes(count, level, R, recordings):
    """How many readings it takes until R̂ is at a level, in words."""
    if np.isfinite(count):
        return f"it takes {count:.0f} readings (median) until your R̂ is mostly {level}"
    after = [each[np.flatnonzero(np.diff(truth[:, 2]))[0] :] for each, (_, truth) in zip(R, recordings, strict=True)]
    left = np.median([np.isfinite(each).sum() for each in after])
    return f"your R̂ does not get mostly {level} within the recording ({left:.0f} readings), in half of them or more"


def follows(answer, answers, recordings):
    """R̂ after a change."""
    R, _ = used(answers, recordings)
    good, bad, until_good, until_bad = learnt(R, recordings)
    if words := restless(R, recordings) or ends(good, bad):
        return words
    granted = "and 45 steps are granted"
    if until_good > 40 or good > 5:
        return (
            f"After the sensor has become good {takes(until_good, 'below 3 m²', R, recordings)}, {granted}. "
            "Do the bad readings count for too long (a window must be shorter, a mean must forget, a bank must be allowed to change), "
            "or does a limit hold R̂ up?"
        )
    if until_bad > 40:
        return (
            f"After the sensor has become bad {takes(until_bad, 'above 8 m²', R, recordings)}, {granted}. "
            "Do newer innovations count for enough, and is C the mean of their squares, as they are before the correction?"
        )
    return None


def ends(good, bad):
    """Where R̂ ends."""
    levels = f"Your R̂ is about {good:.2g} m² where the sensor's R is 1 m², and {bad:.2g} m² where it is 16 m²"
    if good > 30 and bad > 30:
        return f"{levels}. Is that the variance of the readings? The cart moves, and its way is no noise. C is the mean of the squared innovations."
    if good > 2 and bad > 21:
        return f"{levels}: too large both times. Is HP⁻Hᵀ taken off C, and may R̂ fall as well as rise?"
    if bad < 5.5:
        return (
            f"{levels}: there it is far too small. C is the mean of the squared innovations, before the correction. Does a standard deviation, or a root, "
            "stand in place of a variance, is it made of what is left after the correction, or does something hold R̂?"
        )
    return None


def levels(answer, answers, recordings):
    """R̂ that is wrong by a factor where the sensor does not change."""
    good, bad, *_ = learnt(used(answers, recordings)[0], recordings)
    if 0.5 < good < 2 and 10 < bad < 24:
        return None
    return (
        f"Your R̂ is about {good:.2g} m² where the sensor's R is 1 m², and {bad:.2g} m² where it is 16 m². What is taken off C must be the HP⁻Hᵀ of "
        "the same step, and C a plain mean of squared innovations."
    )


def capped(answer, answers, recordings):
    """R̂ that is the same, largest number in many steps."""
    R = np.concatenate([each[np.isfinite(each)] for each in used(answers, recordings)[0]])
    at_top = (1 - 1e-6) * R.max() < R
    if 0.05 < at_top.mean() < 0.95 and R.max() < 14:
        return f"Your R̂ is {R.max():.3g} m² in {100 * at_top.mean():.0f} % of the steps, and never larger, as if a limit holds it. The sensor's R may be 16 m²."
    return None


def two_gains(answer, answers, recordings):
    """A mean that moves with one R, and a P that follows another."""
    found = []
    for scene in scenes(answers, recordings):
        if not np.allclose(scene.grown, scene.Q[scene.empty], rtol=1e-3, atol=1e-3 * scene.Q.max()):
            return None
        (x, P), seen = scene.ahead, ~scene.empty
        share = ((scene.mean[1:] - x)[:, 0] / (scene.z[:, 0] - x[:, 0]))[seen]
        found.append(P[seen, 0, 0] * (1 / share - 1))
    found = np.concatenate(found)
    if np.ptp(found) < 1e-3 * abs(np.median(found)):
        return f"Your mean moves by the gain of R = {np.median(found):.3g} m² in every step. Use the same R, the learnt one, for x and for P."
    return None


def seen(check, *words, of_filters_only=False):
    """A sign from a check of scenes."""
    return _scenes.sign(check, scenes, "steps", *words, of_filters_only=of_filters_only)


ORDER = "In another order of your states all of this passes. The order is: position, velocity."
SIGNS = [
    same_P("steps"),
    predictions(),
    another_order(MARKS, ORDER),
    moved,
    widened,
    seen(_scenes.predicted),
    seen(_scenes.negative),
    seen(_scenes.rooted),
    seen(_scenes.read_in_gaps, of_filters_only=True),
    seen(_scenes.growth, "Q is given, and right; what changes is the sensor: learn R."),
    constant,
    two_gains,
    seen(_scenes.gain, "reading"),
    gates,
    waits,
    floored,
    capped,
    follows,
    levels,
]
