"""A belief: a mean and a covariance, and what one can do with the two."""

from dataclasses import dataclass

import numpy as np

from ..core.conditioning import divide
from ..core.frozen import Frozen
from ..core.matrices import compact, root, symmetric, with_batch
from . import checks as check


@dataclass(frozen=True, eq=False)
class Gaussian(Frozen):
    """The normal distribution N(mean, cov). The second number is a VARIANCE, not a standard deviation.

    Parameters
    ----------
    mean : array_like (..., n)
        In the units of the state; a plain number stands for n = 1.
    cov : array_like (..., n, n)
        In the squared units. Its leading axes broadcast against those of the mean, so that one covariance may serve
        many means. A plain number is a variance; with n > 1 it must be a matrix.

    Both arrays are copied and read-only, also in copies and after pickling.

    Raises
    ------
    ValueError or TypeError
        Naming `mean` or `cov`, when the two do not fit or cov is no covariance.

    Examples
    --------
    >>> from kflearn import Gaussian
    >>> belief = Gaussian([60, 10], [[5, 0], [0, 4]])
    >>> print(f"{belief:.1f}, standard deviations {belief.std.round(2)}")
    N([60.0, 10.0], [[5.0, 0.0], [0.0, 4.0]]), standard deviations [2.24 2.  ]
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
    def batch(self) -> tuple[int, ...]:
        """The leading axes: () for a single belief."""
        return np.broadcast_shapes(self.mean.shape[:-1], self.cov.shape[:-2])

    @property
    def variance(self) -> np.ndarray:
        """The diagonal of the covariance, (..., n)."""
        return np.diagonal(self.cov, axis1=-2, axis2=-1)

    @property
    def std(self) -> np.ndarray:
        """The standard deviations, (..., n), in the units of the mean."""
        return np.sqrt(self.variance)

    def fuse(self, other) -> "Gaussian":
        """The product of two independent beliefs about the same quantity, eqs (10)–(14).

        K = P₁ (P₁ + P₂)⁻¹, mean = μ₁ + K (μ₂ − μ₁), cov = P₁ − K P₁.

        Parameters
        ----------
        other : Gaussian
            With as many components; its batch axes broadcast.

        Raises
        ------
        ValueError
            Where P₁ + P₂ is singular: two beliefs that are both exact cannot be fused.

        Examples
        --------
        >>> from kflearn import Gaussian
        >>> print(f"{Gaussian(60, 5).fuse(Gaussian(62, 1)):.3f}")
        N(61.667, 0.833)
        """
        if not isinstance(other, Gaussian):
            raise TypeError(f"other must be a Gaussian, got {type(other).__name__}")
        if other.mean.shape[-1] != self.mean.shape[-1]:
            raise ValueError(f"other must have {self.mean.shape[-1]} components, got {other.mean.shape[-1]}")
        check.batches(belief=self.batch, other=other.batch)
        P1, P2 = compact(self.cov), compact(other.cov)
        total = check.covariance("the sum of cov and other.cov", P1 + P2, definite=True)
        gain = divide(P1, total)
        mean = self.mean + np.matvec(gain, other.mean - self.mean)
        cov = symmetric(gain @ P2)  # K P₂ = P₁ − K P₁, without the subtraction
        return _read_only(mean, with_batch(cov, np.broadcast_shapes(self.cov.shape[:-2], other.cov.shape[:-2])))

    def marginal(self, indices) -> "Gaussian":
        """The belief about some of the components alone.

        Parameters
        ----------
        indices : int or list of int
            Which components, in this order; negative ones count from the end.

        Examples
        --------
        >>> from kflearn import Gaussian
        >>> print(f"{Gaussian([60, 10], [[5, 1], [1, 4]]).marginal(1):.0f}")
        N(10, 4)
        """
        n = self.mean.shape[-1]
        try:
            keep = np.atleast_1d(np.asarray(indices))
        except (ValueError, np.ma.MaskError):
            keep = np.full(1, np.nan)
        if keep.size == 0:
            raise ValueError(f"indices must hold one index or more, got {_short(indices)}")
        if keep.dtype.kind not in "iu" or keep.ndim != 1 or ((keep < -n) | (keep >= n)).any():
            raise ValueError(f"indices must be a whole number below {n}, or a list of such, got {_short(indices)}")
        cov = with_batch(compact(self.cov)[..., keep[:, None], keep], self.cov.shape[:-2])
        return _read_only(self.mean[..., keep], cov)

    def sample(self, size=(), rng=None) -> np.ndarray:
        """Random draws.

        Parameters
        ----------
        size : int or tuple of int
            How many.
        rng : numpy.random.Generator, int or None
            A generator or a seed.

        Returns
        -------
        ndarray (*size, ..., n)
        """
        rng = check.generator("rng", rng)
        size = (size,) if np.ndim(size) == 0 else tuple(size)
        return self.mean + np.matvec(root(self.cov), rng.standard_normal((*size, *self.batch, self.mean.shape[-1])))

    def ellipse(self, sigmas=2, points=61) -> np.ndarray:
        """The contour at `sigmas` standard deviations of a two-dimensional Gaussian, closed.

        Returns
        -------
        ndarray (..., points, 2)

        Raises
        ------
        ValueError
            If there are not exactly two components.
        """
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
        n, batch = self.mean.shape[-1], self.batch
        mean, cov = self.mean[(0,) * (self.mean.ndim - 1)], self.cov[(0,) * (self.cov.ndim - 2)]
        first = unchecked_gaussian(mean, cov)
        told = format(first) if n <= 3 else f"mean {_in_words(first.mean)}, std {_in_words(first.std)}"
        if batch:
            return f"Gaussian with n = {n} and batch axes {batch}; the first is {told}"
        return told if n <= 3 else f"Gaussian with n = {n}: {told}"


def _in_words(vector):
    """A vector with at most nine of its numbers."""
    shown = [f"{v:.4g}" for v in vector[:9]] + ["…"] * (len(vector) > 9)
    return f"[{', '.join(shown)}]"


def _short(thing):
    """How to quote an argument in an error."""
    found = " ".join(repr(thing).split())
    return found if len(found) <= 60 else found[:60] + "…"


def unchecked_gaussian(mean, cov) -> Gaussian:
    """A Gaussian from arrays that our own formulas made: no checks, no copies, and not yet read-only."""
    belief = object.__new__(Gaussian)
    object.__setattr__(belief, "mean", mean)
    object.__setattr__(belief, "cov", cov)
    return belief


def _read_only(mean, cov):
    """A Gaussian to be handed out."""
    mean.flags.writeable = cov.flags.writeable = False
    return unchecked_gaussian(mean, cov)


def clip_variances(belief, series=False) -> Gaussian:
    """Clip variances that rounding made slightly negative to 0, in place. Returns the same belief.

    series: is the last batch axis the time? A variance below −1e-9 times the largest one is no rounding: ValueError.
    """
    variance = np.einsum("...ii->...i", belief.cov)  # a view of the diagonal
    if (variance < 0).any():
        bad = variance < -1e-9 * variance.max()
        if bad.any():
            in_time = series and bad.ndim > 1
            step = f" at step {np.argwhere(bad)[:, -2].min()}" if in_time else ""
            raise ValueError(
                f"P must have no negative variances, found {variance[bad][0]:.2g}{step}: sigma points with kappa < 0 "
                "or beta < 2 can make such; else too many digits were lost, try square_root_kalman_filter"
            )
        variance[variance < 0] = 0
    return belief
