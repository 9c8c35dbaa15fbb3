"""[KM] A missile homes on a target: nine states in space, two angles measured, proportional navigation.

State: relative position (m), velocity (m/s) and acceleration (m/s²), three axes each, in a right-handed frame. The
acceleration is Singer's with rate 1e4 1/s: within a step of 0.01 s it is forgotten. The missile steers by a law that
drives the predicted miss at the time of impact to zero; the published filter applies that law to its own estimate.
"""

from typing import NamedTuple

import numpy as np

from . import _checks as check
from .angles import angle_difference
from .filtering import correct, predict
from .gaussian import Gaussian
from .models import NonlinearModel, singer_matrix
from .moments import linearize

DT, RATE, STEPS, IMPACT = 0.01, 1e4, 366, 3.7
TRUE_START = np.array([3500.0, 1500, 1000, -1100, -150, -50, 0, 0, 0])
START = Gaussian([3000, 1200, 960, -800, -100, -100, 0, 0, 0], np.diag([1e4] * 6 + [1e2] * 3))
F = np.kron(singer_matrix(DT, RATE), np.eye(3))
PUSH = -np.kron([[DT**2 / 2], [DT], [0]], np.eye(3))
Q = np.diag([0.0] * 6 + [0.1] * 3)


def angles(x):
    """Elevation and azimuth (rad) of the line of sight, (..., 2), for states (..., 9)."""
    east, up, north = np.moveaxis(x[..., :3], -1, 0)
    return np.stack([np.arctan2(up, np.hypot(east, north)), np.arctan2(-north, east)], axis=-1)


def angles_jacobian(x):
    """The Jacobian (..., 2, 9) of `angles`."""
    east, up, north = np.moveaxis(x[..., :3], -1, 0)
    ground, level = east**2 + north**2, np.hypot(east, north)
    H = np.zeros((*x.shape[:-1], 2, 9))
    H[..., 0, :3] = np.stack([-east * up / level, level, -up * north / level], axis=-1) / (ground + up**2)[..., None]
    H[..., 1, 0], H[..., 1, 2] = north / ground, -east / ground
    return H


def wrapped(z, expected):
    """The difference of two angles in radians, between −π and π."""
    return angle_difference(z, expected, 2 * np.pi)


def time_to_go(k):
    """Seconds (…) from step k to the impact that the guidance law is made for; 3.68 at the first step, k = 0."""
    return IMPACT - (np.asarray(k) + 2) * DT


def law(x, t, gain=3.0):
    """Proportional navigation: the acceleration (..., 3) in m/s² for states (..., 9) and a time to go t (...) in s."""
    t = np.asarray(t)
    weights = gain * np.stack([1 / t**2, 1 / t, (np.exp(-RATE * t) + RATE * t - 1) / (RATE * t) ** 2], axis=-1)
    return np.einsum("...i,...ij->...j", weights, x.reshape(*x.shape[:-1], 3, 3))


def noise(distance):
    """R = 0.1/d² (rad²), a stack (..., 1, 2, 2), for distances d (...) in metres."""
    return (0.1 / np.square(distance))[..., None, None, None] * np.eye(2)


def model(distance=1000.0):
    """The filter's model, with R for a target `distance` metres away; the control input is the acceleration."""
    R = noise(np.asarray(check.numbers("distance", distance)))
    return NonlinearModel(lambda x, u: x @ F.T + u @ PUSH.T, angles, Q, R, lambda x, u: F, angles_jacobian, wrapped)


def step(belief, z, u, distance, through=linearize):
    """The published filter's step: predict with the acceleration u (..., 3), correct with the angles z (..., 2)."""
    now = model(distance)
    return correct(now, predict(now, belief, u), z, through=through)


class Flight(NamedTuple):
    """Many flights: true states x (runs, T, 9), angles z (runs, T, 2), estimates mean (runs, T, 9) and cov.

    applied, told: the accelerations (runs, T, 3) that acted and that the filter believed in.
    """

    x: np.ndarray
    z: np.ndarray
    mean: np.ndarray
    cov: np.ndarray
    applied: np.ndarray
    told: np.ndarray

    @property
    def error(self):
        """Distance between estimated and true position, (runs, T), in metres."""
        return np.linalg.norm((self.mean - self.x)[..., :3], axis=-1)

    @property
    def miss(self):
        """The closest that each missile came to its target at the end of a step, (runs,), in metres."""
        return np.linalg.norm(self.x[..., :3], axis=-1).min(axis=-1)


def fly(
    runs=50,
    rng=None,
    steered_by="truth",
    told="own law",
    distance="estimate",
    measured=True,
    start=START,
    through=linearize,
):
    """Let missiles fly and filters watch, 366 steps of 0.01 s.

    steered_by: "truth" (as published: the guidance law sees the true state) or "estimate".
    told: the control that the filter predicts with: "own law" (published: its own estimate in the law) or "applied".
    distance: what R = 0.1/d² is made of: "estimate" (published), "truth", or a number of metres (no range at all).
    measured: False leaves the filter without any angle. start: the Gaussian of the filter before the first step.
    through: how it corrects, see `moments`.
    Returns a Flight. Raises ValueError for other words.
    """
    _known("steered_by", steered_by, ("truth", "estimate"))
    _known("told", told, ("own law", "applied"))
    if isinstance(distance, str):
        _known("distance", distance, ("estimate", "truth"))
    runs, rng = check.whole_number("runs", runs), np.random.default_rng(rng)
    x, belief, rows = np.tile(TRUE_START, (runs, 1)), start, []
    for k in range(STEPS):
        own = np.broadcast_to(law(belief.mean, time_to_go(k)), (runs, 3))
        applied = law(x, time_to_go(k)) if steered_by == "truth" else own
        x = x @ F.T + applied @ PUSH.T
        x[:, 6:] += np.sqrt(0.1) * rng.standard_normal((runs, 3))
        away = np.linalg.norm(x[:, :3], axis=-1)
        z = angles(x) + np.sqrt(0.1) / away[:, None] * rng.standard_normal((runs, 2))
        believed = own if told == "own law" else applied
        ranges = {"truth": away, "estimate": np.linalg.norm(belief.mean[..., :3], axis=-1)}
        seen = z if measured else np.full_like(z, np.nan)
        belief = step(belief, seen, believed, ranges[distance] if isinstance(distance, str) else distance, through)
        rows.append((x, z, belief.mean, np.broadcast_to(belief.cov, (runs, 9, 9)), applied, believed))
    x, z, mean, cov, applied, believed = (np.stack(part, axis=1) for part in zip(*rows, strict=True))
    return Flight(x, z, mean, cov, applied, believed)


def _known(name, word, words):
    if word not in words:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, words))}, got {word!r}")
