"""The Kalman filter that carries a root of the covariance: L Lᵀ is a covariance whatever rounding does to L."""

import numpy as np

from .conditioning import hide
from .gaussian import root
from .linear import linear_filter


def square_root_kalman_filter(model, z, initial, u=None):
    """The Kalman filter in square-root form, the roots by QR decomposition.

    Arguments and result as in kalman_filter, the same numbers too. The condition number of what is carried is the
    square root of that of P. Source: Kailath, Sayed and Hassibi 2000, ch. 12 (array algorithms).
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
        H, R = H * ~missing[..., :, None], hide(R, missing)
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
