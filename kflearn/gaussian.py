"""A belief: a mean and a covariance, and what one can do with the two."""

from dataclasses import dataclass

import numpy as np

from . import _checks as check


@dataclass(frozen=True, eq=False)
class Gaussian:
    """The normal law N(mean, cov). The second number is a VARIANCE, not a standard deviation.

    mean: (..., n) in the units of the state; a plain number stands for n = 1.
    cov: (..., n, n) in the squared units; its leading axes broadcast against those of the mean, so that one
        covariance may serve many means. A plain number is a variance; with n > 1 it must be a matrix.

    Raises ValueError or TypeError, naming `mean` or `cov`, when the two do not fit or cov is no covariance.
    """

    mean: np.ndarray
    cov: np.ndarray

    def __post_init__(self):
        mean = np.atleast_1d(check.numbers("mean", self.mean))
        mean.flags.writeable = False
        cov = check.covariance("cov", self.cov, mean.shape[-1])
        check.batches(mean=mean.shape[:-1], cov=cov.shape[:-2])
        object.__setattr__(self, "mean", mean)
        object.__setattr__(self, "cov", cov)

    @property
    def batch(self):
        """The leading axes: () for a single belief."""
        return np.broadcast_shapes(self.mean.shape[:-1], self.cov.shape[:-2])

    @property
    def variance(self):
        """The diagonal of the covariance, (..., n)."""
        return np.diagonal(self.cov, axis1=-2, axis2=-1)

    @property
    def std(self):
        """The standard deviations, (..., n), in the units of the mean."""
        return np.sqrt(self.variance)

    def fuse(self, other):
        """The product of two independent opinions about the same quantity, eqs (10)–(14).

        K = P₁ (P₁ + P₂)⁻¹, mean = μ₁ + K (μ₂ − μ₁), cov = P₁ − K P₁. Raises ValueError where P₁ + P₂ is singular: two
        opinions that are both exact cannot be fused.
        """
        if not isinstance(other, Gaussian):
            raise TypeError(f"other must be a Gaussian, got {type(other).__name__}")
        if other.mean.shape[-1] != self.mean.shape[-1]:
            raise ValueError(f"other must have {self.mean.shape[-1]} components, got {other.mean.shape[-1]}")
        check.batches(belief=self.batch, other=other.batch)
        total = check.covariance("the sum of cov and other.cov", self.cov + other.cov, definite=True)
        gain = np.linalg.solve(total, self.cov).mT
        mean = self.mean + np.matvec(gain, other.mean - self.mean)
        return trusted(mean, symmetric(gain @ other.cov))  # K P₂ = P₁ − K P₁, without the subtraction

    def marginal(self, indices):
        """What is believed about some of the components alone: `indices` is one index or a list of them."""
        try:
            keep = np.atleast_1d(np.asarray(indices))
        except (ValueError, np.ma.MaskError):
            keep = np.empty(0)
        if keep.dtype.kind not in "iu" or keep.ndim != 1 or (abs(keep + 0.5) > self.mean.shape[-1]).any():
            found = " ".join(repr(indices).split())
            raise ValueError(f"indices must be whole numbers below {self.mean.shape[-1]}, got {found}")
        return trusted(self.mean[..., keep], self.cov[..., keep[:, None], keep])

    def sample(self, size=(), rng=None):
        """Random draws, shape (*size, ..., n). `rng` is a numpy Generator or a seed."""
        rng = np.random.default_rng(rng)
        size = (size,) if np.ndim(size) == 0 else tuple(size)
        return self.mean + np.matvec(root(self.cov), rng.standard_normal((*size, *self.batch, self.mean.shape[-1])))

    def ellipse(self, sigmas=2, points=61):
        """The contour at `sigmas` standard deviations of a two-dimensional Gaussian, (..., points, 2), closed."""
        if self.mean.shape[-1] != 2:
            raise ValueError(f"an ellipse needs 2 components, this Gaussian has {self.mean.shape[-1]}: take a marginal")
        angle = np.linspace(0, 2 * np.pi, points)
        circle = sigmas * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        return self.mean[..., None, :] + circle @ root(self.cov).mT

    def __format__(self, spec):
        """`f"{belief:.3f}"` writes N(mean, variance) with every number in that format."""

        def write(array):
            if array.ndim == 0:
                return format(float(array), spec or ".6g")
            return "[" + ", ".join(write(part) for part in array) + "]"

        mean, cov = (self.mean[..., 0], self.cov[..., 0, 0]) if self.mean.shape[-1] == 1 else (self.mean, self.cov)
        return f"N({write(mean)}, {write(cov)})"

    def __repr__(self):
        if self.mean.ndim == 1 and self.cov.ndim == 2:
            return format(self)
        return f"Gaussian(mean of shape {self.mean.shape}, cov of shape {self.cov.shape})"


def trusted(mean, cov):
    """A Gaussian from arrays that our own formulas made: no checks, no copies."""
    belief = object.__new__(Gaussian)
    object.__setattr__(belief, "mean", mean)
    object.__setattr__(belief, "cov", cov)
    return belief


def symmetric(P):
    """The symmetric part of P: rounding errors must not make a covariance lopsided."""
    return (P + P.mT) / 2


def tidy(belief):
    """The same belief; a variance of 0 that rounding has left at −1e-16 is put to 0, in place."""
    variance = np.einsum("...ii->...i", belief.cov)  # a view of the diagonal
    if (variance < 0).any():
        variance[variance < 0] = 0
    return belief


def root(P):
    """A matrix A with A Aᵀ = P: the Cholesky factor, or, for a singular P, one from the eigenvectors of the
    correlations, so that units do not matter."""
    try:
        return np.linalg.cholesky(P)
    except np.linalg.LinAlgError:
        variance = np.diagonal(P, axis1=-2, axis2=-1)
        scale = np.sqrt(np.where(variance > 0, variance, 1))[..., :, None]
        values, vectors = np.linalg.eigh(P / scale / scale.mT)
        return scale * vectors * np.sqrt(np.maximum(values, 0))[..., None, :]
