"""A vehicle that navigates by its own motion sensors (strapdown INS, in the plane), aided by satellites (GNSS).

State, nine components: position east and north (m), velocity east and north (m/s), heading (rad, from east towards
north), and the sensors' errors: accelerometer biases forward and left (m/s²), gyro bias (rad/s), accelerometer scale
error (1). The control input u is what the sensors read: specific force forward and left (m/s²), turn rate (rad/s).
Source: Groves 2013, ch. 5 and 14, reduced to the plane.

Examples
--------
>>> import numpy as np
>>> from kflearn import navigation
>>> states, fixes, readings = navigation.drive("straight", steps=100, start=np.zeros(9), rng=0)
>>> print(f"{states[-1, 2]:.1f} m/s after 10 s, {np.isfinite(fixes[:, 0]).sum()} fixes")
10.0 m/s after 10 s, 10 fixes
"""

import numpy as np

from ..models import checks as check
from ..models.state_space import NonlinearModel

DT, RATE = 0.1, 10  # one step (s); steps from one satellite fix to the next
FORCE_NOISE, TURN_NOISE = 0.05, np.radians(0.1)  # of one reading: m/s², rad/s
FIX_NOISE = 3.0  # m, east and north
START_SD = np.array([3, 3, 0.5, 0.5, np.radians(5), 0.1, 0.1, np.radians(0.3), 0.02])
DRIFT_SD = np.array([1e-3, 1e-3, np.radians(1e-3), 1e-5])  # of the sensors' errors, a step


def move(x, u) -> np.ndarray:
    """One step of strapdown navigation: states (..., 9) and sensor readings (..., 3) to states (..., 9)."""
    position, velocity, heading = x[..., :2], x[..., 2:4], x[..., 4]
    turn = (u[..., 2] - x[..., 7]) * DT
    force = (u[..., :2] - x[..., 5:7]) / (1 + x[..., 8:])
    acceleration = _turned(force, heading + turn / 2)
    moved = position + velocity * DT + acceleration * DT**2 / 2
    return np.concatenate(
        [moved, velocity + acceleration * DT, (heading + turn)[..., None], _like(x[..., 5:], moved)], axis=-1
    )


def move_jacobian(x, u) -> np.ndarray:
    """The Jacobian (..., 9, 9) of `move` with respect to the state."""
    scale = 1 + x[..., 8:]
    force, heading = (u[..., :2] - x[..., 5:7]) / scale, x[..., 4] + (u[..., 2] - x[..., 7]) * DT / 2
    acceleration = _turned(force, heading)
    slope = np.zeros((*acceleration.shape, 9))  # of the acceleration
    slope[..., 4] = np.stack([-acceleration[..., 1], acceleration[..., 0]], axis=-1)
    for axis in range(2):
        slope[..., 5 + axis] = -_turned(np.broadcast_to(np.eye(2)[axis], force.shape), heading) / scale
    slope[..., 7] = -slope[..., 4] * DT / 2
    slope[..., 8] = -acceleration / scale
    F = np.zeros((*acceleration.shape[:-1], 9, 9))
    F[..., :2, :] = slope * DT**2 / 2
    F[..., 2:4, :] = slope * DT
    F[..., [0, 1], [2, 3]] = DT
    F[..., 4, 7] = -DT
    return F + np.eye(9)


def _turned(vector, heading):
    """Body axes to east and north."""
    c, s = np.cos(heading), np.sin(heading)
    forward, left = vector[..., 0], vector[..., 1]
    return np.stack([c * forward - s * left, s * forward + c * left], axis=-1)


def _like(part, whole):
    return np.broadcast_to(part, (*whole.shape[:-1], part.shape[-1]))


def fix(x) -> np.ndarray:
    """What the satellites measure: the position (..., 2) of states (..., 9)."""
    return x[..., :2]


def fix_jacobian(x) -> np.ndarray:
    """The Jacobian (2, 9) of `fix`, the same everywhere."""
    return np.eye(2, 9)


def model() -> NonlinearModel:
    """The filter's model: satellite fixes of 3 m; the noise of the motion sensors acts on velocity and heading."""
    push = np.kron([[DT**2 / 2], [DT]], np.eye(2)) * FORCE_NOISE
    Q = np.zeros((9, 9))
    Q[:4, :4] = push @ push.T
    Q[4:, 4:] = np.diag([TURN_NOISE * DT, *DRIFT_SD]) ** 2
    return NonlinearModel(move, fix, Q, FIX_NOISE**2 * np.eye(2), move_jacobian, fix_jacobian)


def commands(variant, steps) -> tuple[np.ndarray, np.ndarray]:
    """What the driver does: acceleration forward (m/s²) and turn rate (rad/s), (steps,) each.

    variant "turning": bends to the left and right from 30 s on; any other: straight on.
    """
    t = DT * np.arange(1, steps + 1)
    forward = np.where(t <= 10, 1.0, 0.0)
    bends = np.radians(9) * np.sign(np.sin(2 * np.pi * (t - 30) / 40)) * (t > 30)
    return forward, bends if variant == "turning" else np.zeros(steps)


def drive(variant, steps, start, rng, outage=(80.0, 110.0)) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Drives: what really happens, and what satellites and sensors say about it.

    Parameters
    ----------
    variant : "turning" or "straight"
        What the driver does, see `commands`.
    steps : int
        Of 0.1 s each.
    start : array_like (..., 9)
        The true states before the first step.
    rng : numpy.random.Generator, int or None
        A generator or a seed.
    outage : (float, float)
        From when to when there are no satellites, in seconds.

    Returns
    -------
    states : ndarray (..., steps, 9)
    fixes : ndarray (..., steps, 2)
        In m, one a second, NaN otherwise and in the outage.
    readings : ndarray (..., steps, 3)
        Specific force forward and left (m/s²) and turn rate (rad/s), as the sensors read them.
    """
    x, rng = np.asarray(start, dtype=float), check.generator("rng", rng)
    batch, states, readings = x.shape[:-1], [], []
    for forward, turn in zip(*commands(variant, steps), strict=True):
        speed = np.hypot(x[..., 2], x[..., 3])
        true = np.stack(np.broadcast_arrays(forward, speed * turn, turn), axis=-1)
        ones = np.ones((*batch, 1))
        x = np.concatenate([x[..., :5], x[..., 5:] + DRIFT_SD * rng.standard_normal((*batch, 4))], axis=-1)
        felt = true * np.concatenate([1 + x[..., 8:], 1 + x[..., 8:], ones], axis=-1) + x[..., 5:8]
        x = move(x, felt)
        states.append(x)
        readings.append(felt + rng.standard_normal((*batch, 3)) * [FORCE_NOISE, FORCE_NOISE, TURN_NOISE])
    states, readings = np.stack(states, axis=-2), np.stack(readings, axis=-2)
    t = DT * np.arange(1, steps + 1)
    fixes = states[..., :2] + FIX_NOISE * rng.standard_normal((*batch, steps, 2))
    hidden = (np.arange(1, steps + 1) % RATE != 0) | ((t > outage[0]) & (t <= outage[1]))
    return states, np.where(hidden[:, None], np.nan, fixes), readings
