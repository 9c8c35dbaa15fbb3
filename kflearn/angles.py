"""Angles go round: their differences and their mean. Degrees by default; give period=2 * np.pi for radians."""

import numpy as np


def wrap(angle, period=360.0):
    """The same direction written between −period/2 (included) and +period/2 (not included). Any shape."""
    return (np.asarray(angle) + period / 2) % period - period / 2


def angle_difference(angle, other, period=360.0):
    """The short way round from `other` to `angle`, from −period/2 to +period/2; the shapes broadcast."""
    return wrap(np.subtract(angle, other), period)


def circular_mean(angle, axis=None, period=360.0):
    """The direction of the mean of the unit vectors, from 0 to period (Mardia and Jupp 2000, eq. 2.2.4).

    axis: as in NumPy. The mean of exactly opposite directions is meaningless, whatever number comes out.
    """
    turn = 2 * np.pi / period
    return np.angle(np.mean(np.exp(1j * turn * np.asarray(angle)), axis=axis)) / turn % period
