"""The Schmidt–Kalman filter: some states are not estimated, but their uncertainty counts."""

from functools import partial

import numpy as np

from ..core.conditioning import divide
from ..models import checks as check
from ..models.arguments import check_belief, check_model
from ..results.track import Track
from .linear import covariance_step, linear_filter


def schmidt_kalman_filter(model, z, initial, u=None, *, considered=(), gate=None) -> Track:
    """The consider filter: the gain has zero rows for the states `considered`.

    These states keep the mean that the model alone gives them, and their covariance with the others is kept up to date.

    Parameters
    ----------
    model, z, initial, u
        As in kalman_filter.
    considered : list of int
        The indices of the states that are not estimated.
    gate : float, optional
        As in kalman_filter.

    Returns
    -------
    Track
        Its covariances are true ones for the gain that is used, but later measurements are not exploited fully:
        rts_smoother refuses such a track.

    Raises
    ------
    ValueError, TypeError
        As in kalman_filter, and when considered is no list of indices below n.

    References
    ----------
    Schmidt 1966; Jazwinski 1970, ch. 8.4.

    Examples
    --------
    >>> from kflearn import Gaussian, LinearModel, schmidt_kalman_filter
    >>> biased = LinearModel(F=[[1, 0], [0, 1]], H=[[1, 1]], Q=[[0, 0], [0, 0]], R=1)
    >>> start = Gaussian([0, 0], [[100, 0], [0, 4]])  # a place, and the sensor's bias of ± 2
    >>> track = schmidt_kalman_filter(biased, [5.0] * 50, start, considered=[1])
    >>> print(f"{track.std[-1, 0]:.2f}, bias {track.mean[-1, 1]:.0f} ± {track.std[-1, 1]:.0f}")
    2.00, bias 0 ± 2
    """
    check_model(model)
    check_belief("initial", initial, model)
    n = model.n
    try:
        indices = [check.whole_number("each of considered", i, least=0) for i in considered]
    except TypeError:
        raise TypeError(f"considered must be a list of indices, got {considered!r}") from None
    if any(i >= n for i in indices):
        raise ValueError(f"considered must hold indices below {n}, the number of states, got {considered!r}")
    estimated = ~np.isin(np.arange(n), indices)

    def choose(cross, S):
        return divide(cross, S) * estimated[:, None]

    return linear_filter(model, z, initial, u, partial(covariance_step, choose=choose), through=None, gate=gate)
