"""Products, roots and slices of matrices (..., n, n). Nothing is checked here."""

from functools import cache

import numpy as np


@cache
def identity(n) -> np.ndarray:
    """The identity matrix (n, n), made once; nobody can write into it."""
    eye = np.eye(n)
    eye.flags.writeable = False
    return eye


def symmetric(P) -> np.ndarray:
    """The symmetric part of P (..., n, n): rounding errors must not make a covariance unsymmetric."""
    return (P + P.mT) / 2


def correlations(P, scale=None) -> tuple[np.ndarray, np.ndarray]:
    """The correlations that belong to a covariance, and the scale that was divided out.

    Work with correlations where the units of the components must not matter.

    Parameters
    ----------
    P : ndarray (..., n, n)
        A covariance.
    scale : ndarray (..., n), optional
        What to divide by; by default the standard deviations, and 1 where a variance is not positive.

    Returns
    -------
    correlation : ndarray (..., n, n)
        P[i, j] / scale[i] / scale[j].
    scale : ndarray (..., n)
    """
    if scale is None:
        variance = np.diagonal(P, axis1=-2, axis2=-1)
        scale = np.sqrt(np.where(variance > 0, variance, 1))
    return P / scale[..., :, None] / scale[..., None, :], scale


def root(P) -> np.ndarray:
    """A matrix A (..., n, n) with A Aᵀ = P.

    It is the Cholesky factor; for a singular P it is made from the eigenvectors of the correlations, so that units do
    not matter.
    """
    try:
        return np.linalg.cholesky(P)
    except np.linalg.LinAlgError:
        correlation, scale = correlations(P)
        values, vectors = np.linalg.eigh(correlation)
        scale = np.where(np.diagonal(P, axis1=-2, axis2=-1) > 0, scale, 0)  # what is known exactly stays so
        return scale[..., :, None] * vectors * np.sqrt(np.maximum(values, 0))[..., None, :]


def solve_lower(L, b) -> np.ndarray:
    """L⁻¹ b for a lower triangular L (..., m, m) and b (..., m), one component after the other.

    Turned upside down L is upper triangular, and np.linalg.solve finds no pivots to choose. Of L itself it would choose
    some where the rows have units of very different sizes, and lose digits.
    """
    return np.linalg.solve(L[..., ::-1, ::-1], b[..., ::-1, None])[..., ::-1, 0]


def inverse_lower(L) -> np.ndarray:
    """L⁻¹ for a lower triangular L (..., m, m), without pivots as in solve_lower."""
    return np.linalg.inv(L.mT).mT


def step_matrix(matrix, k) -> np.ndarray:
    """The matrix of step k: `matrix` itself, or its k-th slice where it is a stack (..., T, rows, columns)."""
    if matrix.ndim == 2:
        return matrix
    return matrix[..., k if matrix.shape[-3] > 1 else 0, :, :]


def matvec(matrix, x) -> np.ndarray:
    """The products of a matrix, or of one matrix each, with the vectors x (..., n)."""
    return x @ matrix.T if matrix.ndim == 2 else np.matvec(matrix, x)


def congruence(A, P) -> tuple[np.ndarray, np.ndarray]:
    """Push a covariance through a matrix: the new covariance A P Aᵀ, and the cross-covariance P Aᵀ."""
    cross = _times(P, A.mT)
    return _times(cross.mT, A.mT).mT, cross


def _times(P, B):
    """P B. Where one B serves a whole axis of matrices P, their rows make one tall matrix: several times faster."""
    if P.ndim < 3:
        return P.dot(B) if B.ndim == 2 else P @ B  # the same product; of two small matrices in half the time
    if B.ndim > 2 and B.shape[-3] != 1:
        return P @ B
    rows = P.shape[-3] * P.shape[-2]
    product = P.reshape(*P.shape[:-3], rows, P.shape[-1]) @ (B if B.ndim == 2 else B[..., 0, :, :])
    return product.reshape(*product.shape[:-2], *P.shape[-3:-1], B.shape[-1])


def compact(array, axes=2):
    """The part of an array that is really stored: without leading axes along which it only repeats itself.

    np.broadcast_to makes such axes; their stride is 0. The last `axes` axes stay as they are. What is computed from the
    compact array broadcasts to what would be computed from the whole one, with far fewer operations.
    """
    strides = array.strides[: array.ndim - axes]
    if all(strides):
        return array
    first = next((i for i, stride in enumerate(strides) if stride), len(strides))
    inner = tuple(slice(None) if stride else slice(0, 1) for stride in strides[first:])
    return array[(0,) * first + inner]


def with_batch(matrices, lead):
    """Matrices with the leading axes `lead`: a read-only view that takes no memory, where they lack some."""
    shape = (*lead, *matrices.shape[-2:])
    return matrices if matrices.shape == shape else np.broadcast_to(matrices, shape)
