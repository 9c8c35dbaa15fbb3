"""Angles that wrap around: their differences and their mean. In degrees; give period=2 * np.pi for radians."""

import numpy as np


def wrap(angle, period=360.0) -> np.ndarray:
    """Write an angle as the equal angle between −period/2 and +period/2.

    Parameters
    ----------
    angle : array_like
        Angles of any shape, in the unit of `period`.
    period : float
        A full turn: 360 for degrees, 2π for radians.

    Returns
    -------
    ndarray or float
        The same shape; −period/2 can occur, +period/2 cannot.

    Examples
    --------
    >>> from kflearn import wrap
    >>> print(f"{wrap(190.0):.0f} {wrap(180.0):.0f} {wrap(-10.0):.0f}")
    -170 -180 -10
    """
    return _modulo(np.asarray(angle) + period / 2, period) - period / 2


def angle_difference(angle, other, period=360.0) -> np.ndarray:
    """The short way round from one angle to another.

    Parameters
    ----------
    angle, other : array_like
        Angles in the unit of `period`, of shapes that broadcast.
    period : float
        A full turn: 360 for degrees, 2π for radians.

    Returns
    -------
    ndarray or float
        angle − other, written between −period/2 (included) and +period/2 (not included).

    Examples
    --------
    >>> from kflearn import angle_difference
    >>> print(f"{angle_difference(3, 358):.0f} {angle_difference(358, 3):.0f}")
    5 -5
    """
    return wrap(np.subtract(angle, other), period)


def circular_mean(angle, axis=None, period=360.0) -> np.ndarray:
    """The mean direction: the direction of the mean of the unit vectors.

    Parameters
    ----------
    angle : array_like
        Angles in the unit of `period`.
    axis : int, tuple of int or None
        Which axes to average over, as in NumPy; None averages over all.
    period : float
        A full turn: 360 for degrees, 2π for radians.

    Returns
    -------
    ndarray or float
        Between 0 (included) and period (not included). Exactly opposite directions have no mean direction: the number
        returned for them has no meaning.

    References
    ----------
    Mardia and Jupp 2000, Directional Statistics, eq. (2.2.4).

    Examples
    --------
    >>> from kflearn import circular_mean
    >>> print(f"{circular_mean([350, 10]):.0f} {circular_mean([350, 20]):.0f}")
    0 5
    """
    turn = 2 * np.pi / period
    return _modulo(np.angle(np.mean(np.exp(1j * turn * np.asarray(angle)), axis=axis)) / turn, period)


def _modulo(angle, period):
    """angle % period, below period even for angle = −1e-20, where % rounds up to period itself."""
    rest = angle % period
    return np.where(rest == period, 0.0, rest)[()]
