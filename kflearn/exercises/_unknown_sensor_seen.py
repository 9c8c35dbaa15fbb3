"""What is judged in the open exercise of lesson 22, and what of a filter is measurably right."""

import numpy as np

from kflearn.exercises._inside import added, used_R
from kflearn.exercises._judge import Mark, likely, pair
from kflearn.exercises._scenes import Scene
from kflearn.exercises._unknown_sensor import BAD, GOOD, settled

H = np.array([[1.0, 0.0]])


def empty(recording):
    """The steps but the first without a reading."""
    return np.isnan(recording[0][0][1:])


def used(answers, recordings):
    """For each recording: the R used in each step but the first, and where there is a reading."""
    pairs = list(zip(answers, recordings, strict=True))
    extra = [abs(added(*pair(a), r[0][1])[1][empty(r)] - r[0][2]).max(axis=(1, 2)) / r[0][2].max() for a, r in pairs]
    if np.median(np.concatenate(extra)) > 0.5:
        raise ValueError("no filter, so its corrections cannot be read")
    return [used_R(pair(a)[1], r[0][1], r[0][2], H) for a, r in pairs], [~empty(r) for _, r in pairs]


def scenes(answers, recordings):
    """What the filter did in each recording, beside F, Q and H."""
    return [
        Scene(
            *pair(a),
            *(np.broadcast_to(part, (len(z) - 1, *part.shape)) for part in (F, Q)),
            np.zeros(2),
            H,
            z[1:, None],
        )
        for a, ((z, F, Q, *_), _) in zip(answers, recordings, strict=True)
    ]


def learnt(R, recordings):
    """Where R̂ ends after the change, and how many readings that takes, inf if more than come: for each new level of R, the median."""
    level, needed = {GOOD: [], BAD: []}, {GOOD: [], BAD: []}
    for each, (_, truth) in zip(R, recordings, strict=True):
        after, new = each[np.flatnonzero(np.diff(truth[:, 2]))[0] :], truth[-1, 2]
        after = after[np.isfinite(after)]
        there = after < 3 if new == GOOD else after > 8
        wrong = [n for n in range(len(there) - 15) if there[n : n + 15].mean() < 0.5]
        level[new].append(np.median(after[45:]))
        never = wrong and wrong[-1] == len(there) - 16
        needed[new].append(np.inf if never else wrong[-1] + 8 if wrong else 0)
    return [np.median(each[new]) for each in (level, needed) for new in (GOOD, BAD)]


def restless(R, recordings):
    """R̂ jumps."""
    jumps, lows = [], []
    floor = min(each[np.isfinite(each)].min() for each in R)
    for each, (_, truth) in zip(R, recordings, strict=True):
        late = each[settled(truth[:, 2], truth[-1, 2])[1:] & np.isfinite(each)]
        jumps.append(np.std(np.log(late)))
        lows.append(np.mean(late < 1.001 * floor))
    if np.median(jumps) < 0.8:
        return None
    if np.mean(lows) > 0.15:
        return (
            f"Your R̂ jumps up and down where the sensor does not change, and in {100 * np.mean(lows):.0f} % of the steps it is at its lowest, {floor:.2g} m². "
            "Is more taken off C than HP⁻Hᵀ? Or is it the mean of too few squared innovations? A longer window is steadier."
        )
    return (
        "Your R̂ jumps up and down where the sensor does not change, as a mean of too few squared innovations does. A longer "
        "window is steadier."
    )


def judged_at(truth, level, read=1):
    """The steps that are judged: R has a value, and there is a reading, or none."""
    return settled(truth[:, 2], level) & (truth[:, 3] == read)


def honest(level, read=1):
    """The mean NEES / 2 where R has a value and there is a reading, or none, of all recordings together."""

    def value(answers, truths):
        found = []
        for answer, truth in zip(answers, truths, strict=True):
            (mean, cov), at = pair(answer), judged_at(truth, level, read)
            error = (truth[:, :2] - mean)[at]
            found.append(np.sum(error * np.linalg.solve(cov[at], error[..., None])[..., 0], axis=-1))
        return np.mean(np.concatenate(found)) / 2

    return value


def off(level):
    """The rms error of the position where R has a value."""

    def value(answers, truths):
        at = [judged_at(truth, level) for truth in truths]
        errors = [(pair(a)[0] - t[:, :2])[w, 0] for a, t, w in zip(answers, truths, at, strict=True)]
        return np.sqrt(np.mean(np.concatenate(errors) ** 2))

    return value


# ---- what is right in it


def comes_down(answers, recordings):
    """Whether R̂ gets near 1 m² in time."""
    good, _, until_good, _ = learnt(used(answers, recordings)[0], recordings)
    return 0.5 < good < 1.6 and until_good <= 40


def goes_up(answers, recordings):
    """Whether R̂ gets near 16 m² in time."""
    _, bad, _, until_bad = learnt(used(answers, recordings)[0], recordings)
    return 11 < bad < 22 and until_bad <= 40


def steady(answers, recordings):
    """Whether R̂ does not jump."""
    return restless(used(answers, recordings)[0], recordings) is None


P_ITSELF = "Look at P itself: F P Fᵀ + Q in each step, and what is returned."
MARKS = [
    Mark(
        "error of the position where R became 1 m² (rms)",
        off(GOOD),
        high=0.95,
        unit="m",
        above=likely(
            ("Does R̂ come down again after the bad stretch?", comes_down),
            "Does a missing reading leave R̂ alone?",
        ),
    ),
    Mark(
        "error of the position where R became 16 m² (rms)",
        off(BAD),
        high=2.45,
        unit="m",
        above=likely(
            ("How many readings does it take until R̂ is near 16 m²?", goes_up),
            "Does each reading move the state by the K of its own R̂?",
        ),
    ),
    Mark(
        "NEES / 2 where R became 1 m²",
        honest(GOOD),
        low=0.7,
        high=2.1,
        below=likely(
            "The claimed σ is too large for the errors.",
            ("R̂ should be about 1 m² here: is HP⁻Hᵀ taken off C, and are old innovations forgotten?", comes_down),
            P_ITSELF,
        ),
        above=likely(
            "The claimed σ is too small for the errors.",
            ("Is HP⁻Hᵀ taken off C only once?", comes_down),
            ("Is the window long? A short one makes R̂ restless.", steady),
            P_ITSELF,
        ),
    ),
    Mark(
        "NEES / 2 where R became 16 m²",
        honest(BAD),
        low=0.8,
        high=1.25,
        below=likely(
            "The claimed σ is too large for the errors.",
            ("R̂ should be about 16 m² here: is HP⁻Hᵀ taken off C?", goes_up),
            P_ITSELF,
        ),
        above=likely(
            "The claimed σ is too small for the errors.",
            ("Does R̂ follow the sensor, and is HP⁻Hᵀ taken off C only once?", goes_up),
            ("Is the window long?", steady),
            P_ITSELF,
        ),
    ),
    Mark(
        "NEES / 2 where R became 1 m², without a reading",
        honest(GOOD, read=0),
        low=0.6,
        high=1.6,
        below="Without a reading your P is too large for the errors.",
        above=likely(
            "Without a reading the claimed σ is too small for the errors: P becomes F P Fᵀ + Q there, and is not corrected."
        ),
    ),
]
