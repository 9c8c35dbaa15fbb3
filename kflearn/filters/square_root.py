"""The Kalman filter that carries a root of the covariance: L Lᵀ is a covariance whatever rounding does to L."""

from functools import cache

import numpy as np

from ..core.conditioning import decouple_missing
from ..core.matrices import root
from ..core.walk import same_root
from ..results.track import Track
from .linear import Step, linear_filter


def square_root_kalman_filter(model, z, initial, u=None, *, gate=None) -> Track:
    """The Kalman filter in square-root form, the roots by QR decomposition: the same numbers, with fewer lost digits.

    The condition number of what is carried from step to step is the square root of that of P.

    Parameters
    ----------
    model, z, initial, u, gate
        As in kalman_filter.

    Returns
    -------
    Track
        As from kalman_filter.

    Raises
    ------
    ValueError, TypeError
        As in kalman_filter.

    References
    ----------
    Kailath, Sayed and Hassibi 2000, ch. 12 (array algorithms).

    Examples
    --------
    >>> from kflearn import Gaussian, random_walk, square_root_kalman_filter
    >>> track = square_root_kalman_filter(random_walk(0, 1), [1.0, 2.0, 3.0], Gaussian(0, 1e6))
    >>> print(f"{track.mean[-1, 0]:.3f} ± {track.std[-1, 0]:.3f}")
    2.000 ± 0.577
    """
    return linear_filter(model, z, initial, u, square_root_step, root, same_root, gate=gate)


def square_root_step(L, F, H, Q, R, missing=None):
    """One step of the roots: L (..., n, n) with L Lᵀ = P before, the same after it, and the Step.

    Keeps the precision of its arguments: float32 stays float32.
    """
    moved = F @ L
    L = triangular(np.concatenate([moved, np.broadcast_to(root(Q), moved.shape)], axis=-1))
    predicted, full = L @ L.mT, None
    if missing is not None:
        full = (H @ L) @ (H @ L).mT + R
        H, R = H * ~missing[..., :, None], decouple_missing(R, missing)
    S_root, cross, L = corrected_root(L, H, root(R))
    S = S_root @ S_root.mT if full is None else full
    return L, Step(predicted, S, divide_root(cross, S_root), L @ L.mT, S_root, L)


def corrected_root(L, H, noise):
    """A correction on roots: S½ (..., m, m), K S½ (..., n, m) and L⁺, from L with L Lᵀ = P⁻, H and R½."""
    m, n = H.shape[-2:]
    # [[H L, R½], [L, 0]] has the same square as [[S½, 0], [K S½, L⁺]]. In this order no digit of L⁺ is lost where R is
    # far below H P Hᵀ; with R½ in front L⁺ would be a small difference of large numbers.
    array = np.zeros((*np.broadcast_shapes(L.shape[:-2], H.shape[:-2], noise.shape[:-2]), m + n, m + n), L.dtype)
    array[..., :m, :n], array[..., :m, n:], array[..., m:, :n] = H @ L, noise, L
    array = triangular(array)
    return array[..., :m, :m], array[..., m:, :m], array[..., m:, m:]


def divide_root(C, A):
    """C A⁻¹ for a triangular A (..., m, m); NaN where A is singular."""
    try:
        return np.linalg.solve(A.mT, C.mT).mT
    except np.linalg.LinAlgError:
        return np.full_like(C, np.nan)


def triangular(A):
    """The lower triangular L (..., n, n) with L Lᵀ = A Aᵀ for A (..., n, any); its diagonal is not negative."""
    factored, _ = np.linalg.qr(A.mT, mode="raw")  # L is its lower triangle, but for the signs of the columns
    L = factored[..., : A.shape[-2]]
    return L * (_lower(*L.shape[-2:]) * np.copysign(1.0, np.diagonal(L, axis1=-2, axis2=-1))[..., None, :])


@cache
def _lower(rows, columns):
    """True on and below the diagonal."""
    return np.tri(rows, columns, dtype=bool)


def turned(A):
    """The same L, and the turn U (..., any, n), whose columns are orthogonal, with L = A U."""
    U, R = np.linalg.qr(A.mT)
    sign = np.where(np.diagonal(R, axis1=-2, axis2=-1)[..., None, :] < 0, -1, 1)
    return R.mT * sign, U * sign
