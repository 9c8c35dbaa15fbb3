"""Look-alikes of the recordings behind the bearing demo: a microphone array reports whole degrees, 0 to 359.

No recording ships with the course. The generator has the statistics of six real ones: a sparse grid of preferred
directions, values that dwell (heavy-tailed), small steps about the true level, bursts of outliers that often alternate
between two reflections, sudden switches to another source, and a track that crosses from 360 to 0.

Examples
--------
>>> import numpy as np
>>> from kflearn import bearings
>>> truth, reported = bearings.recording(bearings.VARIANTS["typical"], 325, np.random.default_rng(8))
>>> print(truth.shape, f"{abs(np.median(reported - truth)):.0f}°")
(325,) 0°
"""

from typing import NamedTuple

import numpy as np

from ..core.angles import angle_difference
from .gates import Gated, gated_filter, rms, robust_filter, rows_of, scalar_filter, two_states

__all__ = [
    "GRID",
    "VARIANTS",
    "Gated",
    "Habits",
    "gated_filter",
    "nearest",
    "recording",
    "rms",
    "robust_filter",
    "room",
    "rows_of",
    "scalar_filter",
    "two_states",
    "walkers",
]

# The steps from one to the next, in random order; written out, as a generator made here would slow the import down.
_GAPS = np.array(
    list(
        "4243212144334411141111314233112122222442133132423122412332223112411113324243"
        "113443222242233144411211113233243121132334243333312213414412344213121322444"
    ),
    dtype=int,
)
GRID = np.cumsum(_GAPS) % 360  # the 151 directions that occur, whole degrees


class Habits(NamedTuple):
    """How a recording behaves.

    Attributes
    ----------
    level : float
        The share of the stretches of equal values that lie at the true level.
    stay : float
        Their mean length, in samples.
    spread : float
        Standard deviation of the other values about the level, in degrees.
    bursts : float
        The probability that a burst of outliers begins at a sample.
    reflections : float
        The share of the bursts that alternate between two fixed wrong values.
    switches : int
        How often the source changes.
    drift : float
        Of the source, in degrees a sample.
    """

    level: float
    stay: float
    spread: float
    bursts: float
    reflections: float = 0.5
    switches: int = 0
    drift: float = 0.0


VARIANTS = {
    "calm": Habits(level=0.40, stay=12, spread=2.5, bursts=0.0),
    "typical": Habits(level=0.32, stay=6, spread=2.5, bursts=0.02),
    "reflections": Habits(level=0.45, stay=9, spread=2.5, bursts=0.11, reflections=0.9),
    "switching": Habits(level=0.34, stay=6, spread=2.5, bursts=0.02, switches=3),
    "crossing": Habits(level=0.34, stay=6, spread=2.5, bursts=0.02, drift=0.12),
    "hard": Habits(level=0.30, stay=2.5, spread=3.0, bursts=0.06, switches=2),
}


def recording(habits, steps, rng) -> tuple[np.ndarray, np.ndarray]:
    """One recording.

    Parameters
    ----------
    habits : Habits
        One of VARIANTS, or one with other figures: `VARIANTS["calm"]._replace(drift=0.5)`.
    steps : int
        How many samples.
    rng : numpy.random.Generator
        Where the random numbers come from.

    Returns
    -------
    truth, reported : ndarray (steps,)
        The true bearing in degrees, not wrapped, and the reported one, in whole degrees.
    """
    truth = _source(habits, steps, rng)
    reported = _dwells(habits, truth, rng)
    for begin, length in _bursts(habits, steps, rng):
        end = min(begin + length, steps)
        reported[begin:end] = _wrong(habits, truth[begin], end - begin, rng)
    return truth, reported


def walkers(drift, runs=30, rng=None) -> tuple[np.ndarray, np.ndarray]:
    """Calm recordings of speakers who walk at a steady pace.

    Parameters
    ----------
    drift : float
        Degrees a reading.
    runs : int
    rng : numpy.random.Generator or int, optional

    Returns
    -------
    truth, reported : ndarray (runs, 325)

    Examples
    --------
    >>> from kflearn import bearings
    >>> truth, heard = bearings.walkers(0.5, runs=2, rng=8)
    >>> print(truth.shape, truth[0, 1] - truth[0, 0])
    (2, 325) 0.5
    """
    rng = np.random.default_rng(rng)
    found = [recording(VARIANTS["calm"]._replace(drift=drift), 325, rng) for _ in range(runs)]
    return np.array([truth for truth, _ in found]), np.array([reported for _, reported in found])


def room(echoes) -> tuple[np.ndarray, np.ndarray]:
    """The recording of lesson 9's playground: a walker, one change of speaker, and as many echoes as one likes.

    Each burst of echoes has drawn a number once; `echoes` says up to which number they are heard. More echoes leave
    those that were there as they are.

    Parameters
    ----------
    echoes : float
        From 0 to 40, roughly per cent of the readings.

    Returns
    -------
    truth, reported : ndarray (325,)

    Examples
    --------
    >>> from kflearn import bearings
    >>> truth, heard = bearings.room(0)
    >>> print(f"{abs(bearings.angle_difference(heard, truth)).max():.0f}°")
    5°
    """
    habits = VARIANTS["reflections"]._replace(bursts=0.0, switches=1, drift=0.2)
    truth, calm = recording(habits, 325, np.random.default_rng(26))
    _, spiky = recording(habits._replace(bursts=0.3), 325, np.random.default_rng(26))
    wrong = spiky != calm
    burst = np.cumsum(wrong & ~np.append(False, wrong[:-1]))
    chance = np.random.default_rng(26).random(325)[burst]
    return truth, np.where(chance < echoes / 40, spiky, calm)


def _source(habits, steps, rng):
    """Where the sound comes from, on the grid or between: constant or drifting, with switches of 50° to 160°."""
    start = rng.uniform(0, 360) if not habits.drift else 360 - habits.drift * steps * rng.uniform(0.3, 0.7)
    truth = start + habits.drift * np.arange(steps)
    for moment in rng.integers(steps // 8, steps, habits.switches):
        truth[moment:] += rng.choice([-1, 1]) * rng.uniform(50, 160)
    return truth


def _dwells(habits, truth, rng):
    """Values that dwell: long at the direction nearest to the truth, short at neighbours of it."""
    reported = np.empty(len(truth))
    k = 0
    while k < len(truth):
        at_level = rng.random() < habits.level
        length = rng.geometric(1 / habits.stay if at_level else 0.85)
        offset = 0 if at_level else np.clip(rng.normal(0, habits.spread), -4, 4)
        for j in range(k, min(k + length, len(truth))):
            reported[j] = nearest(truth[j]) if at_level else nearest(truth[k] + offset)
        k += length
    return reported


def _bursts(habits, steps, rng):
    """Beginnings and lengths (1 to 9, mean 2.2) of the bursts of outliers."""
    free = 0
    for begin in np.flatnonzero(rng.random(steps) < habits.bursts):
        if begin > free:
            length = min(rng.geometric(0.45), 9)
            free = begin + length
            yield begin, length


def _wrong(habits, level, length, rng):
    """A burst: the same wrong direction again and again, or two that alternate; 10° to 160° off, median 28°."""
    off = np.clip(28 * np.exp(0.6 * rng.standard_normal(2)), 10, 160) * rng.choice([-1, 1], 2)
    if rng.random() > habits.reflections:
        off[1] = off[0]
    return nearest(level + off[np.arange(length) % 2])


def nearest(angle) -> np.ndarray:
    """The nearest direction of the grid, any shape."""
    distance = abs(angle_difference(np.asarray(angle)[..., None], GRID))
    return GRID[np.argmin(distance, axis=-1)].astype(float)
