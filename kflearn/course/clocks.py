"""Drives for lesson 25: a receiver and the wheels of a car, each with a clock of its own, and the truth."""

from typing import NamedTuple

import numpy as np

from ..filters.events import Readings
from ..models.continuous import discretise
from ..models.gaussian import Gaussian
from ..models.simulation import simulate
from ..models.state_space import LinearModel

END, INTENSITY = 30.0, 1.0  # s; q in m²/s³
START = Gaussian([0, 20], [[4.0, 0.0], [0.0, 1.0]])  # place (m) and speed (m/s) at the time 0
H_PLACE, H_SPEED = np.array([[1.0, 0.0]]), np.array([[0.0, 1.0]])
R_PLACE, R_SPEED = 1.0, 0.04  # m², (m/s)²


class Drives(NamedTuple):
    """Many drives, read by two sensors at the same moments in all of them.

    Attributes
    ----------
    receiver, wheels : Readings
        Places (runs, 30, 1) about once a second, and speeds (runs, 150, 1) about five times a second.
    even : ndarray
        Moments ten times a second.
    moments, x : ndarray (T,), (runs, T, 2)
        All moments, and the true places and speeds at them.
    """

    receiver: Readings
    wheels: Readings
    even: np.ndarray
    moments: np.ndarray
    x: np.ndarray

    def truth(self, times) -> np.ndarray:
        """The true states (runs, …, 2) at some of the moments."""
        return self.x[:, np.searchsorted(self.moments, times)]


def drives(runs=300, rng=25) -> Drives:
    """Cars at about 20 m/s, pushed by white acceleration, for half a minute.

    Parameters
    ----------
    runs : int
    rng : int or numpy.random.Generator

    Returns
    -------
    Drives

    Examples
    --------
    >>> from kflearn.course import clocks
    >>> some = clocks.drives(runs=2)
    >>> print(some.receiver.z.shape, some.wheels.z.shape, some.truth(some.even[:3]).shape)
    (2, 30, 1) (2, 150, 1) (2, 3, 2)
    """
    rng = np.random.default_rng(rng)
    fixes = np.arange(0.5, END) + rng.uniform(-0.3, 0.3, 30)
    turns = np.arange(0.1, END, 0.2) + rng.uniform(-0.08, 0.08, 150)
    even = np.arange(1, 300) / 10
    moments = np.unique(np.concatenate([fixes, turns, even]))
    F, Q = discretise([[0, 1], [0, 0]], [[0], [1]], INTENSITY, np.diff(moments, prepend=0))
    x = simulate(LinearModel(F, H_PLACE, Q, 1), START, len(moments), runs=runs, rng=rng).x
    readings = []
    for times, H, R in ((fixes, H_PLACE, R_PLACE), (turns, H_SPEED, R_SPEED)):
        true = x[:, np.searchsorted(moments, times)] @ H.T
        readings.append(Readings(times, true + rng.normal(0, np.sqrt(R), true.shape), H, R))
    receiver, wheels = readings
    return Drives(receiver, wheels, even, moments, x)


def stream(some, delay) -> list[tuple]:
    """The readings of both sensors in the order of arrival, where the places arrive late.

    Parameters
    ----------
    some : Drives
    delay : float
        Seconds from a reading of a place to its arrival; speeds arrive at once.

    Returns
    -------
    list of (arrival, taken, z, H, R)
        z is (runs, 1).

    Examples
    --------
    >>> from kflearn.course import clocks
    >>> rows = clocks.stream(clocks.drives(runs=1), delay=0.5)
    >>> arrival, taken, z, H, R = next(row for row in rows if row[0] > row[1])
    >>> print(f"{arrival - taken:.1f} s, H = {H[0]}, R = {R}")
    0.5 s, H = [1. 0.], R = 1.0
    """
    rows = []
    for (times, z, H, R), late in ((some.receiver, delay), (some.wheels, 0.0)):
        rows += [(t + late, t, z[:, i], H, R) for i, t in enumerate(times)]
    return sorted(rows, key=lambda row: row[0])


def jam(rate) -> tuple[Readings, Readings, np.ndarray, np.ndarray]:
    """One drive of 40 s with a traffic jam in it, always the same but for how often the place is read.

    Parameters
    ----------
    rate : float
        Places a second.

    Returns
    -------
    receiver, wheels : Readings
    times, x : ndarray (T,), (T, 2)
        The truth, a hundred times a second.

    Examples
    --------
    >>> from kflearn.course import clocks
    >>> receiver, wheels, times, x = clocks.jam(rate=0.5)
    >>> print(len(receiver.times), x[2000].round(0) + 0)
    19 [225.   0.]
    """
    times = np.arange(4001) / 100
    speed = np.interp(times, [0, 6, 12, 26, 32, 40], [25, 25, 0, 0, 20, 20])
    place = np.concatenate([[0], np.cumsum((speed[1:] + speed[:-1]) / 200)])
    noise, turns = np.random.default_rng(7).normal(0, 1, 600), np.arange(0.1037, 40, 0.4)
    fixes = np.arange(1, 39, 1 / rate)
    z = np.interp(fixes, times, place) + noise[200 : 200 + len(fixes)] * np.sqrt(R_PLACE)
    v = np.interp(turns, times, speed) + noise[: len(turns)] * np.sqrt(R_SPEED)
    wheels = Readings(turns, v, H_SPEED, R_SPEED)
    return Readings(fixes, z, H_PLACE, R_PLACE), wheels, times, np.stack([place, speed], axis=-1)
