"""Would anybody have noticed? Lesson 7's two tests, which need no truth, on many recordings at once."""

import numpy as np

from ..results.consistency import chi_square_interval


def alarms(track, since) -> tuple[float, float, tuple[float, float]]:
    """The mean NIS and the mean correlation of neighbouring innovations, and how often each is found wrong.

    Parameters
    ----------
    track : Track
        Of many runs and one sensor, without gaps.
    since : int
        The first step that counts.

    Returns
    -------
    nis, neighbours : float
        Means over the runs; 1 and 0 are honest.
    found : (float, float)
        The shares of single runs whose NIS, or whose correlation, is outside what 95 % of honest filters have.

    Examples
    --------
    >>> from kflearn import Gaussian, kalman_filter, random_walk, simulate
    >>> model = random_walk(1, 1)
    >>> track = kalman_filter(model, simulate(model, [0], steps=400, runs=500, rng=1).z, Gaussian(0, 1))
    >>> nis, neighbours, found = alarms(track, since=100)
    >>> print(f"{nis:.2f}, {abs(neighbours):.2f}, found {found[0]:.0%} and {found[1]:.0%}")
    1.00, 0.00, found 4% and 5%
    """
    y = (track.innovation.mean / track.innovation.std)[:, since:, 0]
    steps = y.shape[1]
    low, high = chi_square_interval(1, steps)
    nis, pair = np.mean(y**2, axis=1), np.sum(y[:, 1:] * y[:, :-1], axis=1) / np.sum(y**2, axis=1)
    found = np.mean((nis < low) | (nis > high)), np.mean(abs(pair) > 1.96 / np.sqrt(steps))
    return nis.mean(), pair.mean(), found
