"""[KM] A missile homes on a target: nine states in space, two angles measured, proportional navigation.

State: relative position (m), velocity (m/s) and acceleration (m/s²), three axes each, in a right-handed frame. The
acceleration is Singer's with rate 1e4 1/s: within a step of 0.01 s it is forgotten. The missile steers by a law that
drives the predicted miss at the time of impact to zero; the published filter applies that law to its own estimate.

Examples
--------
>>> from kflearn import homing
>>> flight = homing.fly(runs=2, rng=0)
>>> print(flight.x.shape, f"{flight.left.max():.1f} m away at the end, miss {flight.miss.max():.1f} m")
(2, 366, 9) 21.9 m away at the end, miss 0.0 m
"""

from typing import NamedTuple

import numpy as np

from ..core.angles import angle_difference
from ..filters.moments import linearize
from ..filters.steps import correct, predict
from ..models import checks as check
from ..models.gaussian import Gaussian
from ..models.kinematics import singer_matrix
from ..models.state_space import NonlinearModel

DT, RATE, STEPS, IMPACT = 0.01, 1e4, 366, 3.7  # s, 1/s, steps, s
TRUE_START = np.array([3500.0, 1500, 1000, -1100, -150, -50, 0, 0, 0])
START = Gaussian([3000, 1200, 960, -800, -100, -100, 0, 0, 0], np.diag([1e4] * 6 + [1e2] * 3))
F = np.kron(singer_matrix(DT, RATE), np.eye(3))
PUSH = -np.kron([[DT**2 / 2], [DT], [0]], np.eye(3))
Q = np.diag([0.0] * 6 + [0.1] * 3)


def move(x, u) -> np.ndarray:
    """One step: states (..., 9) and the missile's acceleration u (..., 3) in m/s² to states (..., 9)."""
    return x @ F.T + u @ PUSH.T


def move_jacobian(x, u) -> np.ndarray:
    """The Jacobian (9, 9) of `move`, the same everywhere."""
    return F


def angles(x) -> np.ndarray:
    """Elevation and azimuth (rad) of the line of sight, (..., 2), for states (..., 9)."""
    east, up, north = np.moveaxis(x[..., :3], -1, 0)
    return np.stack([np.arctan2(up, np.hypot(east, north)), np.arctan2(-north, east)], axis=-1)


def angles_jacobian(x) -> np.ndarray:
    """The Jacobian (..., 2, 9) of `angles`."""
    east, up, north = np.moveaxis(x[..., :3], -1, 0)
    ground, level = east**2 + north**2, np.hypot(east, north)
    H = np.zeros((*x.shape[:-1], 2, 9))
    H[..., 0, :3] = np.stack([-east * up / level, level, -up * north / level], axis=-1) / (ground + up**2)[..., None]
    H[..., 1, 0], H[..., 1, 2] = north / ground, -east / ground
    return H


def wrapped(z, expected) -> np.ndarray:
    """The difference of two angles in radians, between −π and π."""
    return angle_difference(z, expected, 2 * np.pi)


def time_to_go(k) -> np.ndarray:
    """Seconds from step k to the impact that the guidance law is made for; 3.68 at the first step, k = 0."""
    return IMPACT - (np.asarray(k) + 2) * DT


def law(x, t, gain=3.0) -> np.ndarray:
    """Proportional navigation: how the missile accelerates.

    Parameters
    ----------
    x : ndarray (..., 9)
        States.
    t : float or ndarray (...)
        The time to go, in s.
    gain : float
        The navigation constant.

    Returns
    -------
    ndarray (..., 3)
        In m/s².
    """
    t = np.asarray(t)
    weights = gain * np.stack([1 / t**2, 1 / t, (np.exp(-RATE * t) + RATE * t - 1) / (RATE * t) ** 2], axis=-1)
    return np.einsum("...i,...ij->...j", weights, x.reshape(*x.shape[:-1], 3, 3))


def noise(distance) -> np.ndarray:
    """R = 0.1/d² (rad²), a stack (..., 1, 2, 2), for distances d (...) in metres."""
    return (0.1 / np.square(distance))[..., None, None, None] * np.eye(2)


_MODEL = NonlinearModel(move, angles, Q, np.eye(2), move_jacobian, angles_jacobian, wrapped)


def model(distance=1000.0) -> NonlinearModel:
    """The filter's model, with R for a target `distance` metres away (...); the control input is the acceleration."""
    return _MODEL.replace(R=noise(np.asarray(check.numbers("distance", distance))))


def place(z, distance) -> np.ndarray:
    """The place (..., 3) that two angles (..., 2) and a distance (...) say: east, up, north, in metres."""
    up, side = z[..., 0], z[..., 1]
    direction = [np.cos(up) * np.cos(side), np.sin(up), -np.cos(up) * np.sin(side)]
    return distance[..., None] * np.stack(direction, axis=-1)


def miss(x) -> np.ndarray:
    """How near each missile would pass its target if nobody accelerated any more: (...) in metres, for (..., T, 9).

    From the step with the smallest distance on. The flights end before the planned impact, with many missiles still
    on their way; the distance at that moment says how late one is, and not how wide.
    """
    nearest = np.linalg.norm(x[..., :3], axis=-1).argmin(axis=-1)[..., None, None]
    now = np.take_along_axis(x, nearest, axis=-2)[..., 0, :]
    r, v = now[..., :3], now[..., 3:6]
    return np.linalg.norm(np.cross(r, v), axis=-1) / np.linalg.norm(v, axis=-1)


def unseen(belief) -> np.ndarray:
    """What a tangent does not see of the angles: σ² along the line of sight times σ² across it, over d⁴.

    A variance in rad², to be added to R as (..., 1, 2, 2). An error along a line that is turned by the error across it
    looks like an error across.
    """
    r, P = belief.mean[..., :3], belief.cov[..., :3, :3]
    d = np.linalg.norm(r, axis=-1)
    sight = r / d[..., None]
    along = np.vecdot(sight, np.matvec(P, sight))
    across = (np.trace(P, axis1=-2, axis2=-1) - along) / 2  # there are two directions across
    return (along * across / d**4)[..., None, None, None] * np.eye(2)


def step(belief, z, u, distance, through=linearize, larger_R=False) -> Gaussian:
    """The published filter's step: predict with the acceleration u (..., 3), correct with the angles z (..., 2).

    belief: Gaussian of the nine states; distance (...): of the target, in m; through: see `filters.moments`;
    larger_R: whether to add to R what a tangent does not see.
    """
    now = model(distance)
    belief = predict(now, belief, u, through=through)
    if larger_R:
        now = now.replace(R=now.R + unseen(belief))
    return correct(now, belief, z, through=through)


class Flight(NamedTuple):
    """Many flights, T = 366 steps each.

    Attributes
    ----------
    x : ndarray (runs, T, 9)
        True states.
    z : ndarray (runs, T, 2)
        Measured angles, in rad.
    mean, cov : ndarray (runs, T, 9) and (runs, T, 9, 9)
        What the filters believed.
    applied, told : ndarray (runs, T, 3)
        The accelerations that acted and those that the filters were told, in m/s².
    """

    x: np.ndarray
    z: np.ndarray
    mean: np.ndarray
    cov: np.ndarray
    applied: np.ndarray
    told: np.ndarray

    @property
    def error(self) -> np.ndarray:
        """Distance between estimated and true position, (runs, T), in metres."""
        return np.linalg.norm((self.mean - self.x)[..., :3], axis=-1)

    @property
    def left(self) -> np.ndarray:
        """Distance between missile and target after the last step, (runs,), in metres."""
        return np.linalg.norm(self.x[:, -1, :3], axis=-1)

    @property
    def nearest(self) -> np.ndarray:
        """Time of the step with the smallest distance, (runs,), in s."""
        return DT * (np.linalg.norm(self.x[..., :3], axis=-1).argmin(axis=-1) + 1)

    @property
    def miss(self) -> np.ndarray:
        """How near each missile would pass if nobody accelerated any more, (runs,), in metres: see `miss`."""
        return miss(self.x)


def fly(
    runs=50,
    rng=None,
    steered_by="truth",
    told="own law",
    distance="estimate",
    measured=True,
    start=START,
    through=linearize,
    larger_R=False,
) -> Flight:
    """Let missiles fly, each with a filter that watches its target; 366 steps of 0.01 s.

    Parameters
    ----------
    runs : int
        How many missiles.
    rng : numpy.random.Generator, int or None
        A generator or a seed.
    steered_by : "truth" or "estimate"
        What the guidance law sees: the true state (as published), or the filter's estimate.
    told : "own law" or "applied"
        What the filter predicts with: the law applied to its own estimate (as published), or what really acts.
    distance : "estimate", "truth" or float
        What R = 0.1/d² is made of: the estimate (as published), the truth, or a fixed number of metres.
    measured : bool
        False leaves the filter without any angle.
    start : Gaussian
        What the filter believes before the first step.
    through : callable
        How the filter corrects, see `filters.moments`.
    larger_R : bool
        True adds to R what a tangent does not see, see `unseen`.

    Raises
    ------
    ValueError or TypeError
        Naming the argument.
    """
    check.word("steered_by", steered_by, ("truth", "estimate"))
    check.word("told", told, ("own law", "applied"))
    if isinstance(distance, str):
        check.word("distance", distance, ("estimate", "truth"))
    runs, rng = check.whole_number("runs", runs), check.generator("rng", rng)
    x, belief, rows = np.tile(TRUE_START, (runs, 1)), start, []
    for k in range(STEPS):
        own = np.broadcast_to(law(belief.mean, time_to_go(k)), (runs, 3))
        applied = law(x, time_to_go(k)) if steered_by == "truth" else own
        believed = own if told == "own law" else applied
        x, z, away = _fly_on(x, applied, rng)
        ranges = {"truth": away, "estimate": np.linalg.norm(belief.mean[..., :3], axis=-1)}
        seen = z if measured else np.full_like(z, np.nan)
        told_distance = ranges[distance] if isinstance(distance, str) else distance
        belief = step(belief, seen, believed, told_distance, through, larger_R)
        rows.append((x, z, belief.mean, np.broadcast_to(belief.cov, (runs, 9, 9)), applied, believed))
    return Flight(*(np.stack(part, axis=1) for part in zip(*rows, strict=True)))


def _fly_on(x, applied, rng):
    """One step of the truth: new states, measured angles and distances."""
    x = move(x, applied)
    x[:, 6:] += np.sqrt(0.1) * rng.standard_normal((len(x), 3))
    away = np.linalg.norm(x[:, :3], axis=-1)
    return x, angles(x) + np.sqrt(0.1) / away[:, None] * rng.standard_normal((len(x), 2)), away
