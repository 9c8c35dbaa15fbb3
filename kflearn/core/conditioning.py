"""Conditioning a Gaussian on a measurement: the few formulas that every filter and every smoother is made of."""

import numpy as np

from .matrices import congruence, correlations, identity, symmetric

ROUNDING = np.finfo(float).eps  # as much may be left of a variance of 1 by rounding alone: one unit in the last place


def covariance_after(gain, P, H, R, basis=None):
    """The covariance after a correction with this gain: (I−KH)P(I−KH)ᵀ + KRKᵀ.

    This is Joseph's form, positive semi-definite for any K. For sigma points with the `basis` L, L Lᵀ = P, H is the
    slope along L: (L−KH)(L−KH)ᵀ + KRKᵀ.
    """
    keep = (identity(P.shape[-1]) if basis is None else basis) - gain @ H
    left = congruence(keep, P)[0] if basis is None else keep @ keep.mT
    return symmetric(left + congruence(gain, R)[0])


def without_missing(missing, S, cross):
    """S and the cross-covariance C when some components (..., m) are missing.

    Missing components get unit variance, no correlation with the others, and zero gain.
    """
    return decouple_missing(S, missing), cross * ~missing[..., None, :]


def decouple_missing(R, missing):
    """A covariance in which the missing components (..., m) have become independent with variance 1."""
    seen = ~missing
    return R * (seen[..., :, None] & seen[..., None, :]) + missing[..., :, None] * np.eye(missing.shape[-1])


def divide(C, S):
    """C S⁻¹ for C (..., n, m) and a covariance S (..., m, m), by elimination; written out for m = 2.

    A covariance needs no pivots: elimination in any order is stable. Where the components have units of very different
    sizes, to choose pivots would even lose digits; so for m > 2 the correlations take the place of S. A singular S
    gives NaN or infinity.
    """
    if S.shape[-1] == 1:
        return C / S
    if S.shape[-1] == 2:
        return _divide_two(C, S)
    correlation, scale = correlations(S)
    scale = scale[..., None, :]
    try:
        return np.linalg.solve(correlation.mT, (C / scale).mT).mT / scale
    except np.linalg.LinAlgError:
        return np.full(np.broadcast_shapes(C.shape[:-2], S.shape[:-2]) + C.shape[-2:], np.nan)


def _divide_two(C, S):
    """C S⁻¹ for two components."""
    (a, b), (c, d) = S if S.ndim == 2 else np.moveaxis(S[..., None], (-3, -2), (0, 1))
    one, two, share = C[..., 0], C[..., 1], b / a
    second = (two - share * one) / (d - share * c)
    out = np.empty((*second.shape, 2), second.dtype)
    out[..., 0], out[..., 1] = (one - c * second) / a, second
    return out


def _eliminated(S):
    """Of covariances (..., 2, 2): what the first component tells of the second, and the variance that is left of it."""
    share = S[..., 0, 1] / S[..., 0, 0]
    return share, S[..., 1, 1] - share * S[..., 1, 0]


def definite(S):
    """Which of the symmetric matrices (..., m, m) are positive definite, by more than a rounding error; NaN is not."""
    if S.shape[-1] == 1:
        return S[..., 0, 0] > 0
    if S.shape[-1] == 2:
        return (S[..., 0, 0] > 0) & (_eliminated(S)[1] > ROUNDING * S[..., 1, 1])
    finite = np.isfinite(S).all(axis=(-2, -1))
    correlation, _ = correlations(np.where(finite[..., None, None], S, 0))
    return finite & (np.linalg.eigvalsh(correlation)[..., 0] > ROUNDING)


def divide_safely(cross, P):
    """C P⁻¹ where P may be singular, as when Q = 0 and something is known exactly: by way of the correlations."""
    correlation, scale = correlations(P)
    scale = scale[..., None, :]
    # Transposed, so that roundings stay what they were: a smoother amplifies them where P is nearly singular.
    return cross / scale @ np.linalg.pinv(correlation.mT, rtol=1e-14, hermitian=True) / scale


def log_determinant(S):
    """log det S of positive definite matrices (..., m, m); written out for m = 1 and 2."""
    if S.shape[-1] == 1:
        return np.log(S[..., 0, 0])
    if S.shape[-1] == 2:
        return np.log(S[..., 0, 0]) + np.log(_eliminated(S)[1])
    correlation, scale = correlations(S)
    return np.linalg.slogdet(correlation)[1] + 2 * np.log(scale).sum(axis=-1)


def squared_distance(y, S):
    """yᵀ S⁻¹ y for y (..., m) and S (..., m, m)."""
    return (divide(y[..., None, :], S) @ y[..., :, None])[..., 0, 0]
