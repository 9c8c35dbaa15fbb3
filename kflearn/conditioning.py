"""Conditioning a Gaussian on a measurement: the few formulas that every filter and every smoother is made of."""

import numpy as np

from .gaussian import symmetric
from .moments import spread


def covariance_after(gain, P, H, R, basis=None):
    """What a correction with `gain` leaves of P: Joseph's form, (I−KH)P(I−KH)ᵀ + KRKᵀ, positive whatever K is.

    For sigma points with the `basis` L, L Lᵀ = P, and H the slope along it: (L−KH)(L−KH)ᵀ + KRKᵀ.
    """
    keep = (np.eye(P.shape[-1]) if basis is None else basis) - gain @ H
    left = spread(keep, P)[0] if basis is None else keep @ keep.mT
    return symmetric(left + spread(gain, R)[0])


def without(missing, S, cross):
    """S and the cross-covariance when some components (..., m) are missing: these get no gain and disturb nothing."""
    return hide(S, missing), cross * ~missing[..., None, :]


def hide(R, missing):
    """A covariance in which the missing components (..., m) have become independent with variance 1."""
    seen = ~missing
    return R * (seen[..., :, None] & seen[..., None, :]) + missing[..., :, None] * np.eye(missing.shape[-1])


def divide(C, S):
    """C S⁻¹ for C (..., n, m) and S (..., m, m), by solving; by Cramer's rule for m = 1 and 2, which is far faster."""
    if S.shape[-1] == 1:
        return C / S
    if S.shape[-1] == 2:
        adjugate = S[..., ::-1, ::-1].mT * _SIGNS
        determinant = S[..., 0, 0] * S[..., 1, 1] - S[..., 0, 1] * S[..., 1, 0]
        return C @ adjugate / determinant[..., None, None]
    return np.linalg.solve(S.mT, C.mT).mT


_SIGNS = np.array([[1.0, -1.0], [-1.0, 1.0]])


def divide_safely(cross, P):
    """C P⁻¹ where P may be singular, as when Q = 0 and something is known exactly: by way of the correlations."""
    variance = np.diagonal(P, axis1=-2, axis2=-1)
    scale = np.sqrt(np.where(variance > 0, variance, 1))[..., None, :]
    return cross / scale @ np.linalg.pinv(P / scale / scale.mT, rtol=1e-14, hermitian=True) / scale


def log_determinant(S):
    """log det S of positive definite matrices (..., m, m); written out for m = 1 and 2."""
    if S.shape[-1] == 1:
        return np.log(S[..., 0, 0])
    if S.shape[-1] == 2:
        return np.log(S[..., 0, 0] * S[..., 1, 1] - S[..., 0, 1] * S[..., 1, 0])
    return np.linalg.slogdet(S)[1]


def squared_distance(y, S):
    """yᵀ S⁻¹ y for y (..., m) and S (..., m, m)."""
    return (divide(y[..., None, :], S) @ y[..., :, None])[..., 0, 0]
