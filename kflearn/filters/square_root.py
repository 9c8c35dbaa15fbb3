"""The Kalman filter that carries a root of the covariance: L Lᵀ is a covariance whatever rounding does to L."""

import numpy as np

from ..core.conditioning import decouple_missing
from ..core.matrices import root
from ..results.track import Track
from .linear import linear_filter


def square_root_kalman_filter(model, z, initial, u=None) -> Track:
    """The Kalman filter in square-root form, the roots by QR decomposition: the same numbers, with fewer lost digits.

    The condition number of what is carried from step to step is the square root of that of P.

    Parameters
    ----------
    model, z, initial, u
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
    return linear_filter(model, z, initial, u, square_root_step, root)


def square_root_step(L, F, H, Q, R, missing=None):
    """One step of the roots: L (..., n, n) with L Lᵀ = P before, the same after it, and (predicted P, S, K, P).

    Keeps the precision of its arguments: float32 stays float32.
    """
    moved = F @ L
    L = triangular(np.concatenate([moved, np.broadcast_to(root(Q), moved.shape)], axis=-1))
    predicted, S = L @ L.mT, (H @ L) @ (H @ L).mT + R
    if missing is not None:
        H, R = H * ~missing[..., :, None], decouple_missing(R, missing)
    m, n = H.shape[-2:]
    # [[R½, H L], [0, L]] has the same square as [[S½, 0], [K S½, L⁺]].
    array = np.zeros((*L.shape[:-2], m + n, m + n), L.dtype)
    array[..., :m, :m], array[..., :m, m:], array[..., m:, m:] = root(R), H @ L, L
    array = triangular(array)
    gain = np.linalg.solve(array[..., :m, :m].mT, array[..., m:, :m].mT).mT
    L = array[..., m:, m:]
    return L, (predicted, S, gain, L @ L.mT)


def triangular(A):
    """The lower triangular L (..., n, n) with L Lᵀ = A Aᵀ, for A (..., n, any)."""
    return np.linalg.qr(A.mT, mode="r").mT
