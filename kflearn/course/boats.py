"""Boats of lesson 26 on a sea full of false readings.

>>> from kflearn import boats
>>> scene = boats.crossing(boats.plane(), angle=30, clutter=2e-5, runs=100, rng=0)
>>> scene.x.shape, scene.z.shape[:2], scene.start.mean.shape
((40, 2, 4), (100, 40), (2, 4))
"""

from typing import NamedTuple

import numpy as np

from ..models.gaussian import Gaussian
from ..models.kinematics import constant_velocity
from ..models.simulation import simulate
from ..models.state_space import LinearModel
from ..targets.scans import scan_targets

__all__ = ["AREA", "Crossing", "adjustable", "at_the_end", "crossing", "fleet", "plane"]

AREA = ((-100, 500), (-200, 400))  # what the radar sees: x and y in m
DETECTION, SPEED = 0.9, 7.0  # P_D; m/s


def __dir__() -> list[str]:
    return __all__


def plane(acceleration=0.5, sigma=5.0) -> LinearModel:
    """A boat: constant velocity in x and in y, both measured once a second.

    Parameters
    ----------
    acceleration : float
        The standard deviation of its unknown acceleration, m/s².
    sigma : float
        The standard deviation of a reading in x and in y, m.

    Returns
    -------
    LinearModel
        State [x, v_x, y, v_y] in m and m/s.
    """
    line = constant_velocity(dt=1, acceleration=acceleration, R=sigma**2)
    return LinearModel(*(np.kron(np.eye(2), M) for M in (line.F, line.H, line.Q, line.R)))


class Crossing(NamedTuple):
    """Two boats that meet: true states x (T, 2, 4), scans z (runs, T, N, 2), the belief about both before the first."""

    x: np.ndarray
    z: np.ndarray
    start: Gaussian


def crossing(model, angle, clutter, runs, rng=None) -> Crossing:
    """Two boats on straight lines, at 7 m/s, that are at the same place after twenty of forty scans.

    Parameters
    ----------
    model : LinearModel
        Of `plane`.
    angle : float
        Between their courses, degrees.
    clutter : float
        False readings per m².
    runs : int
        How many series of scans.
    rng : numpy.random.Generator, int or None

    Returns
    -------
    Crossing
    """
    half = np.radians(angle) / 2
    velocity = SPEED * np.array([[np.cos(half), np.sin(half)], [np.cos(half), -np.sin(half)]])
    x = np.empty((41, 2, 4))
    x[..., [0, 2]] = np.arange(-20, 21)[:, None, None] * velocity
    x[..., [1, 3]] = velocity
    everywhere = np.broadcast_to(x[1:], (runs, 40, 2, 4))
    scans = scan_targets(model, everywhere, DETECTION, clutter, [[-200, 200], [-200, 200]], rng)
    return Crossing(x[1:], scans.z, Gaussian(x[0], np.diag([25.0, 1, 25, 1])))


def at_the_end(mean, x) -> tuple[np.ndarray, np.ndarray]:
    """Which boat is nearest to each of two tracks after the last scan?

    Parameters
    ----------
    mean : ndarray (runs, 2, T, 4)
        Of the tracks.
    x : ndarray (T, 2, 4)
        Of the boats.

    Returns
    -------
    exchanged, together : ndarray of bool (runs,)
        Each track is at the other boat; both are at the same boat.
    """
    place, boats = mean[:, :, -1][..., [0, 2]], x[-1][:, [0, 2]]
    nearest = np.linalg.norm(place[:, :, None] - boats, axis=-1).argmin(axis=-1)
    return (nearest == [1, 0]).all(axis=1), nearest[:, 0] == nearest[:, 1]


def fleet(model, runs, rng=None) -> np.ndarray:
    """Three boats in forty scans: one is there all the time, one comes with scan 5, one leaves after scan 24.

    Parameters
    ----------
    model : LinearModel
        Of `plane`.
    runs : int
    rng : numpy.random.Generator, int or None

    Returns
    -------
    ndarray (runs, 40, 3, 4)
        NaN where a boat is not there.
    """
    rng, x = np.random.default_rng(rng), np.full((runs, 40, 3, 4), np.nan)
    x[:, :, 0] = simulate(model, [0, SPEED, 0, 3], 40, runs=runs, rng=rng).x
    x[:, 5:, 1] = simulate(model, [300, -5, -100, 5], 35, runs=runs, rng=rng).x
    x[:, :25, 2] = simulate(model, [100, 0, 300, -6], 25, runs=runs, rng=rng).x
    return x


def adjustable(model, x, most, region, rng=None):
    """Scans whose P_D and λ can be turned like knobs: what stays in the scan stays where it was.

    Parameters
    ----------
    model : LinearModel
        Of `plane`.
    x : ndarray (T, 4)
        The true states of one boat.
    most : float
        The largest λ, per m².
    region : array_like (2, 2)
        As in scan_targets.
    rng : numpy.random.Generator, int or None

    Returns
    -------
    function(detection, clutter)
        Returns scans (T, N, 2), NaN where a reading is not there.
    """
    rng = np.random.default_rng(rng)
    scans = scan_targets(model, x[:, None], 1.0, most, region, rng)
    mark = rng.random(scans.source.shape)

    def thinned(detection, clutter):
        keep = mark < np.where(scans.source == 0, detection, clutter / most)
        return np.where(keep[..., None], scans.z, np.nan)

    return thinned
