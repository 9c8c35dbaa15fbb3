"""A thermometer in a cold store, for lesson 25: recordings in which something breaks, and what a filter may do then."""

import numpy as np

from ..models.gaussian import Gaussian
from ..models.kinematics import random_walk
from ..models.simulation import simulate

STEP = 30.0  # s between two readings
Q, R = 0.02**2, 0.2**2  # °C² for each step; °C²
MODEL, START = random_walk(Q, R), Gaussian(4, 0.01)
BEFORE, AFTER = 720, 360  # readings before a fault, and from it on


def recordings(runs=300, rng=2) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Nine hours of one thermometer, in which after six hours something happens: the same days in five ways.

    Parameters
    ----------
    runs : int
    rng : int or numpy.random.Generator

    Returns
    -------
    true : ndarray (runs, 1080)
        The temperatures (°C), of a store in which nothing happens.
    faults : dict of ndarray (runs, 1080)
        Name of what happens → readings (°C).

    Examples
    --------
    >>> from kflearn.course import cold_store
    >>> true, faults = cold_store.recordings(runs=2)
    >>> print(list(faults), true.shape)
    ['nothing', 'offset of 3 σ', 'noise doubled', 'stuck', 'drift, 0.3 °C/h'] (2, 1080)
    """
    rng = np.random.default_rng(rng)
    days = simulate(MODEL, START, BEFORE + AFTER, runs=runs, rng=rng)
    true, z = days.x[..., 0], days.z[..., 0]
    since = np.arange(BEFORE + AFTER) - BEFORE
    hours, broken = np.maximum(since, 0) * STEP / 3600, since >= 0
    return true, {
        "nothing": z,
        "offset of 3 σ": z + 3 * np.sqrt(R) * broken,
        "noise doubled": np.where(broken, true + 2 * (z - true), z),
        "stuck": np.where(broken, z[:, [BEFORE]], z),
        "drift, 0.3 °C/h": z + 0.3 * hours,
    }


def respond(z, answer, limit=18.0, silence=60) -> np.ndarray:
    """The estimates of a filter that does something when its CUSUM raises an alarm.

    Parameters
    ----------
    z : array_like (..., T)
        Readings, °C.
    answer : str
        "nothing"; "begin again", with the variance (1 °C)²; or "switch off", which leaves the readings of some steps
        unused.
    limit : float
        Of the CUSUM.
    silence : int
        For how many steps "switch off" lasts.

    Returns
    -------
    ndarray (..., T)
        °C.

    Examples
    --------
    >>> from kflearn.course import cold_store
    >>> knocked = [4.0] * 5 + [6.0] * 5
    >>> for answer in ("nothing", "begin again", "switch off"):
    ...     print(f"{cold_store.respond(knocked, answer)[-1]:.2f}")
    5.05
    5.98
    4.00
    """
    rows, silent, g = [], 0, 0.0
    series = np.moveaxis(np.asarray(z, float), -1, 0)
    x, P = series[0], np.full(series[0].shape, R)
    for reading in series:
        P, y = P + Q, reading - x
        g = np.maximum(0, g + y**2 / (P + R) - 1.5)
        alarm, g = g > limit, np.where(g > limit, 0, g)
        P = np.where(alarm & (answer == "begin again"), 1.0, P)
        silent = np.where(alarm & (answer == "switch off"), silence, silent)
        K = np.where(silent > 0, 0, P / (P + R))
        x, P, silent = x + K * y, (1 - K) * P, silent - 1
        rows.append(x)
    return np.stack(rows, axis=-1)
