"""Filters of one bearing for lessons 8 and 9, many recordings at once: plain, with a gate, with a robust weight.

All take readings (..., T) in degrees, start at the first one, and take every difference the short way round. Lesson
code and exercises find them in `kflearn.bearings`.
"""

from typing import NamedTuple

import numpy as np

from ..core.angles import angle_difference
from ..models.state_space import NonlinearModel
from ..results.comparison import Measured, with_error


class Gated(NamedTuple):
    """What a gated filter has done, each (..., T).

    Attributes
    ----------
    mean : ndarray
        The estimate after each reading, degrees, not wrapped.
    innovation, S : ndarray
        What the gate has looked at: reading minus prediction, and its variance.
    refused : ndarray of bool
        The readings beyond the gate.
    """

    mean: np.ndarray
    innovation: np.ndarray
    S: np.ndarray
    refused: np.ndarray


def rms(angles, truth) -> Measured:
    """The root mean square error of angles in degrees, the short way round, with its standard error over the runs.

    Parameters
    ----------
    angles, truth : array_like (runs, ...)
        Degrees.

    Returns
    -------
    Measured
        In degrees.

    Examples
    --------
    >>> from kflearn import bearings
    >>> print(f"{bearings.rms([[359.0, 2.0], [1.0, 358.0]], [[0.0, 0.0], [0.0, 0.0]]):.2f}°")
    1.58 ± 0.00°
    """
    return with_error(angle_difference(angles, truth) ** 2, root=True)


def scalar_filter(z, Q, R, difference=angle_difference) -> np.ndarray:
    """A random walk, read directly: the filter of lesson 8.

    Parameters
    ----------
    z : array_like (..., T)
        Readings in degrees.
    Q, R : float
        Variances of a step and of a reading, deg².
    difference : function
        difference(reading, prediction): `np.subtract` for the plain one, which looks south near north.

    Returns
    -------
    ndarray (..., T)
        Estimates, not wrapped.

    Examples
    --------
    >>> from kflearn import bearings
    >>> print(bearings.scalar_filter([339.0, 8.0, 8.0], 200, 500).round(1) % 360)
    [339.  355.9   1.9]
    """
    return _random_walk(z, Q, R, difference, lambda score: 1.0)


def _random_walk(z, Q, R, difference, weight):
    """The filter of a random walk; the first reading is its start, and R is divided by the weight of a NIS."""
    series = np.moveaxis(np.asarray(z, float), -1, 0)
    x, P, found = series[0], R, [series[0]]
    for reading in series[1:]:
        P, y = P + Q, difference(reading, x)
        K = P / (P + R / weight(y**2 / (P + R)))
        x, P = x + K * y, (1 - K) * P
        found.append(x)
    return np.stack(found, axis=-1)


def two_states(dt, Q, R, difference=angle_difference) -> NonlinearModel:
    """Angle (degrees) and its rate, of which the angle is read.

    Parameters
    ----------
    dt : float
        The time step; with 0 nothing ties the rate to the angle.
    Q : array_like (2, 2)
    R : float
    difference : function
        As in `scalar_filter`.

    Returns
    -------
    NonlinearModel

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import bearings
    >>> print(bearings.two_states(0.1, np.eye(2), 9).move(np.array([359.0, 20.0])))
    [361.  20.]
    """
    F = np.array([[1, dt], [0, 1]])
    return NonlinearModel(lambda x: x @ F.T, lambda x: x[..., :1], Q, R, residual=difference)


def gated_filter(z, Q, R, gate, patience=None, width=180.0) -> Gated:
    """A random walk with a gate, which starts again where `patience` of the last patience + 2 refused readings agree.

    Parameters
    ----------
    z : array_like (..., T)
        Readings in degrees.
    Q, R : float
        Variances of a step and of a reading, deg².
    gate : float
        How many standard deviations √S an innovation may be long.
    patience : int, optional
        How many refused readings must agree, the last one among them; without it the gate has no way back.
    width : float
        What counts as agreement, ± degrees; 180 counts all.

    Returns
    -------
    Gated

    Examples
    --------
    >>> from kflearn import bearings
    >>> found = bearings.gated_filter([10.0, 11, 90, 10, 200, 201, 202, 200], 0.2, 2, gate=4, patience=3, width=8)
    >>> print(found.mean.round(1) % 360)
    [ 10.   10.5  10.5  10.3  10.3  10.3 202.  201. ]
    >>> print(found.refused.astype(int))
    [0 0 1 0 1 1 1 0]
    """
    z = np.asarray(z, float)
    rows = [_gated(row, Q, R, gate, patience, width) for row in z.reshape(-1, z.shape[-1]).tolist()]
    mean, innovation, S, refused = np.moveaxis(np.array(rows), -1, 0).reshape(4, *z.shape)
    return Gated(mean, innovation, S, refused == 1)


def _gated(z, Q, R, gate, patience, width):
    """One recording; floats, as these loops are long."""
    x, P, waiting, rows = z[0], R, [], [(z[0], 0.0, R, False)]  # the first reading is the start
    for reading in z[1:]:
        P, y = P + Q, _short(reading - x)
        S = P + R
        refused = y**2 > gate**2 * S
        if not refused:
            K = P / S
            x, P, waiting = x + K * y, (1 - K) * P, []
        elif patience:
            waiting = [*waiting[-patience - 1 :], reading]
            if sum(abs(_short(old - reading)) <= width for old in waiting) >= patience:
                x, P, waiting = x + y, R, []
        rows.append((x, y, S, refused))
    return rows


def _short(difference):
    """`angle_difference` for one number, quickly."""
    return (difference + 180) % 360 - 180


def robust_filter(z, Q, R, weight) -> np.ndarray:
    """A random walk that corrects with R divided by a weight, which falls when a reading is surprising.

    Parameters
    ----------
    z : array_like (..., T)
        Readings in degrees.
    Q, R : float
        Variances of a step and of a reading, deg².
    weight : function
        NIS (...) → weight (...), between 0 and 1 or a little above.

    Returns
    -------
    ndarray (..., T)
        Estimates, not wrapped.

    Examples
    --------
    >>> from kflearn import bearings
    >>> print(bearings.robust_filter([10.0, 11, 90, 10], 0.2, 2, lambda score: 5 / (4 + score)).round(1))
    [10.  10.6 10.7 10.4]
    """
    return _random_walk(z, Q, R, angle_difference, weight)


def rows_of(flags) -> np.ndarray:
    """How long the rows of True are in flags (..., T), all together.

    Parameters
    ----------
    flags : array_like of bool (..., T)

    Returns
    -------
    ndarray of int

    Examples
    --------
    >>> from kflearn import bearings
    >>> bearings.rows_of([False, True, True, False, True])
    array([2, 1])
    """
    flags = np.atleast_2d(np.asarray(flags, bool)).astype(int)
    edges = np.diff(np.pad(flags.reshape(-1, flags.shape[-1]), ((0, 0), (1, 1))))
    return np.argwhere(edges == -1)[:, 1] - np.argwhere(edges == 1)[:, 1]
