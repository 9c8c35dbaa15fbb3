"""Readings of several sensors, each with a clock of its own, as one series of steps of different lengths."""

from typing import NamedTuple

import numpy as np

from ..models import checks as check


class Readings(NamedTuple):
    """What one sensor has read.

    Attributes
    ----------
    times : array_like (T,)
        When each reading was taken, in seconds, in any order, no moment twice.
    z : array_like (..., T, m)
        The readings, NaN where nothing was measured; (T,) will do for m = 1.
    H : array_like (m, n) or (T, m, n)
        How the sensor sees the state.
    R : array_like (m, m) or (T, m, m)
        The covariance of its noise; a number for m = 1.

    Examples
    --------
    >>> from kflearn import Readings
    >>> print(Readings(times=[0.4, 1.1], z=[20.0, 21.0], H=[[1, 0]], R=4).R)
    4
    """

    times: np.ndarray
    z: np.ndarray
    H: np.ndarray
    R: np.ndarray


class Events(NamedTuple):
    """What several sensors have read, in the order of time.

    Attributes
    ----------
    times, dt : ndarray (T,)
        All moments at which there is a reading or an estimate is wanted, and the seconds since the one before.
    z : ndarray (..., T, m)
        The components of all sensors side by side; NaN where a sensor has not read at that moment.
    H, R : ndarray (m, n), (m, m), or stacks (T, …) of them
        The rows of all sensors one below the other, and their covariances as blocks.
    at : ndarray of int
        The steps at which estimates were wanted, in the order in which they were given.
    """

    times: np.ndarray
    dt: np.ndarray
    z: np.ndarray
    H: np.ndarray
    R: np.ndarray
    at: np.ndarray


def merge_events(sensors, start, at=()) -> Events:
    """The readings of several sensors in the order of time, for a filter with steps of different lengths.

    Each moment is a step. All components of all sensors stand side by side; those that were not read at a moment are
    gaps there. So `LinearModel(F, events.H, Q, events.R)`, with F and Q for `events.dt`, goes with `events.z` through
    every filter and smoother. Moments `at` which nothing is read are steps too: an even path, or a forecast. A
    nonlinear model takes dt[k] in its f(x, u, k), and its h returns the components of all sensors.

    Parameters
    ----------
    sensors : list of Readings
    start : float
        The time of the initial belief, in seconds; no reading is earlier.
    at : array_like, optional
        Times at which estimates are wanted, `start` or later.

    Returns
    -------
    Events

    Raises
    ------
    ValueError, TypeError
        Naming what does not fit, and the number of the sensor, counted from 0.

    Examples
    --------
    >>> from kflearn import Gaussian, LinearModel, Readings, discretise, kalman_filter, merge_events
    >>> tape = Readings(times=[1, 2, 4], z=[1.1, 2.0, 3.9], H=[[1, 0]], R=0.04)
    >>> wheel = Readings(times=[1.5, 4], z=[1.0, 1.1], H=[[0, 1]], R=0.01)
    >>> events = merge_events([tape, wheel], start=0, at=[3, 5])
    >>> F, Q = discretise([[0, 1], [0, 0]], [[0], [1]], 0.01, events.dt)
    >>> track = kalman_filter(LinearModel(F, events.H, Q, events.R), events.z, Gaussian([0, 0], [[1, 0], [0, 1]]))
    >>> print(events.times, track.mean[events.at, 0].round(1))
    [1.  1.5 2.  3.  4.  5. ] [3. 5.]
    """
    if not isinstance(sensors, (list, tuple)) or isinstance(sensors, Readings) or not sensors:
        raise TypeError(f"sensors must be a list of Readings, got {type(sensors).__name__}")
    sensors = [_checked(i, each) for i, each in enumerate(sensors)]
    n = sensors[0].H.shape[-1]
    for i, each in enumerate(sensors):
        check.shape(f"H of sensor {i}", each.H, (None, n))
    start, at = check.number("start", start), _wanted(at)
    times = np.unique(np.concatenate([at, *(each.times for each in sensors)]))
    if times[0] < start:
        raise ValueError(f"start must not be later than the first time, got {start:g} and {times[0]:g}")
    T, rows = len(times), [np.searchsorted(times, each.times) for each in sensors]
    z = [_at_rows(each.z, where, T, np.nan) for each, where in zip(sensors, rows, strict=True)]
    H = _all_alike([_each_step(each.H, where, T) for each, where in zip(sensors, rows, strict=True)])
    R = _all_alike([_each_step(each.R, where, T) for each, where in zip(sensors, rows, strict=True)])
    batch = check.batches(**{f"z of sensor {i}": each.shape[:-2] for i, each in enumerate(z)})
    z = np.concatenate([np.broadcast_to(each, (*batch, *each.shape[-2:])) for each in z], axis=-1)
    dt = np.diff(times, prepend=start)
    return Events(times, dt, z, np.concatenate(H, axis=-2), _blocks(R), np.searchsorted(times, at))


def _checked(i, sensor):
    """One sensor's Readings as arrays that fit together."""
    if not isinstance(sensor, Readings):
        raise TypeError(f"sensor {i} must be Readings, got {type(sensor).__name__}")
    times, of = check.numbers(f"times of sensor {i}", sensor.times), f"of sensor {i}"
    check.shape(f"times {of}", times, (None,), exact=True)
    alone, how_often = np.unique(times, return_counts=True)
    if (how_often > 1).any():
        twice = alone[how_often > 1][0]
        raise ValueError(f"times {of} must differ, found {twice:g} twice: give the second reading as another sensor's")
    H = check.matrix(f"H {of}", sensor.H)
    T, m = len(times), H.shape[-2]
    R = check.covariance(f"R {of}", sensor.R, m, definite=True)
    for name, M in (("H", H), ("R", R)):
        if M.ndim > 3 or (M.ndim == 3 and len(M) != T):
            raise ValueError(f"{name} {of} must be one matrix, or one for each of {T} readings, got shape {M.shape}")
    z = check.numbers(f"z {of}", sensor.z, gaps=True)
    z = z[:, None] if z.ndim == 1 and m == 1 else z
    return Readings(times, check.shape(f"z {of}", z, (T, m)), H, R)


def _wanted(at):
    """Wanted times as an array, which may be empty."""
    if getattr(at, "size", len(at) if isinstance(at, (list, tuple)) else 1) == 0:
        return np.zeros(0)
    return check.shape("at", check.numbers("at", at), (None,), exact=True)


def _at_rows(values, rows, T, elsewhere):
    """Values (..., t, m) at the given rows of a longer array (..., T, m), and `elsewhere` in the others."""
    whole = np.full((*values.shape[:-2], T, values.shape[-1]), elsewhere)
    whole[..., rows, :] = values
    return whole


def _each_step(M, rows, T):
    """A matrix as it is; a stack as one matrix for each step, that of the earliest reading where there is none."""
    if M.ndim == 2:
        return M
    whole = np.repeat(M[[np.argmin(rows)]], T, axis=0)
    whole[rows] = M
    return whole


def _all_alike(parts):
    """Stacks of all, where one of them is a stack."""
    T = max((len(M) for M in parts if M.ndim == 3), default=None)
    return parts if T is None else [np.broadcast_to(M, (T, *M.shape[-2:])) for M in parts]


def _blocks(parts):
    """Matrices (..., m, m) as the blocks on the diagonal of one."""
    sizes = [M.shape[-1] for M in parts]
    whole = np.zeros((*parts[0].shape[:-2], sum(sizes), sum(sizes)))
    end = 0
    for M, size in zip(parts, sizes, strict=True):
        begin, end = end, end + size
        whole[..., begin:end, begin:end] = M
    return whole
