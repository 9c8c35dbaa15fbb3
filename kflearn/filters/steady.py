"""Where the filter of a model that does not change comes to rest."""

from typing import NamedTuple

import numpy as np

from ..models.state_space import LinearModel
from .linear import covariance_step


class SteadyState(NamedTuple):
    """The covariances and the gain that no longer change: P⁻ before and P after a measurement (n, n), the covariance
    S of the innovation (m, m), and K (n, m)."""

    predicted: np.ndarray
    cov: np.ndarray
    S: np.ndarray
    gain: np.ndarray


def steady_state(model) -> SteadyState:
    """The covariances and the gain of a Kalman filter after very many steps, from the algebraic Riccati equation.

    Parameters
    ----------
    model : LinearModel
        With the same matrices at all steps.

    Returns
    -------
    SteadyState

    Raises
    ------
    ValueError, TypeError
        For a model that changes, or whose filter does not come to rest: an error that grows is not measured, or one
        that is never renewed keeps its share of the start for ever.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, sec. 5.2.5; solved by SciPy.

    Examples
    --------
    >>> from kflearn import random_walk, steady_state
    >>> print(f"{steady_state(random_walk(1469.1, 15099)).gain[0, 0]:.3f}")
    0.267
    """
    from scipy.linalg import solve_discrete_are  # loads slowly

    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    F, H, Q, R = model.F, model.H, model.Q, model.R
    if any(M.ndim > 2 for M in (F, H, Q, R)):
        raise ValueError("model must have the same matrices at all steps")
    try:
        predicted = solve_discrete_are(F.T, H.T, Q, R)
    except (np.linalg.LinAlgError, ValueError):
        raise ValueError(
            "model must have a steady state: is everything that grows measured, and renewed by Q?"
        ) from None
    P = np.linalg.solve(np.eye(model.n) + predicted @ H.T @ np.linalg.solve(R, H), predicted)
    _, step = covariance_step((P + P.T) / 2, F, H, Q, R, None)
    return SteadyState(step.predicted, step.cov, step.S, step.gain)
