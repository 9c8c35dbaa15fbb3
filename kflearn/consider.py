"""The Schmidt–Kalman filter: some states are not estimated, but their uncertainty counts."""

from functools import partial

import numpy as np

from . import _checks as check
from .arguments import check_belief, check_model
from .conditioning import divide
from .linear import covariance_step, linear_filter


def schmidt_kalman_filter(model, z, initial, u=None, considered=()):
    """The consider filter: the gain has zero rows for the states `considered`, a list of their indices.

    These states keep the mean that the model alone gives them, and their covariance with the others is kept up to date.
    Other arguments and result as in kalman_filter. Its covariances are true ones for the gain that is used, but later
    measurements are not exploited fully: rts_smoother refuses such a track. Source: Schmidt 1966; Jazwinski 1970,
    ch. 8.4.
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

    return linear_filter(model, z, initial, u, partial(covariance_step, choose=choose), through=None)
