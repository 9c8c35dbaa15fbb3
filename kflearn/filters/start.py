"""A start from a measurement alone."""

import numpy as np

from ..core.matrices import correlations, step_matrix, symmetric
from ..models import checks as check
from ..models.gaussian import Gaussian
from ..models.state_space import LinearModel


def start_from(model, z) -> Gaussian:
    """The belief that one measurement alone gives, x = H⁻¹ z and P = H⁻¹ R H⁻ᵀ: a start when nothing else is known.

    Parameters
    ----------
    model : LinearModel
        With an invertible H: as many components are measured as there are states.
    z : array_like
        (..., m), or a number when m = 1.

    Returns
    -------
    Gaussian
        Mean (..., n) and one covariance (n, n).

    Raises
    ------
    ValueError
        When H is not square or is singular.

    Examples
    --------
    >>> from kflearn import random_walk, start_from
    >>> print(f"{start_from(random_walk(1, 4), 3):.0f}")
    N(3, 4)
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    H, R = step_matrix(model.H, 0), step_matrix(model.R, 0)
    z = check.shape("z", np.atleast_1d(check.numbers("z", z)), (model.m,))
    if model.m != model.n or not _invertible(H):
        raise ValueError(f"H of shape {H.shape} must be invertible to start from z: not every state is measured")
    # In units in which R is a matrix of correlations and each column of H is at most 1: elimination chooses its pivots
    # by their size, and would lose digits where the components' own units are very different.
    R, noise = correlations(R)
    H = H / noise[..., :, None]
    size = abs(H).max(axis=-2)
    H = H / size[..., None, :]
    mean = np.linalg.solve(H, (z / noise)[..., None])[..., 0] / size
    cov = np.linalg.solve(H, np.linalg.solve(H, R).mT)
    return Gaussian(mean, symmetric(cov) / size[..., :, None] / size[..., None, :])


def _invertible(H):
    """Has a square matrix, or each of a stack, full rank in whatever units? Rows and columns are brought to size 1."""
    for axis in (-1, -2):
        size = abs(H).max(axis=axis, keepdims=True)
        H = H / np.where(size > 0, size, 1)
    return (np.linalg.matrix_rank(H) == H.shape[-1]).all()
