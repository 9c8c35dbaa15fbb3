"""A Gaussian through a function: where it lands, how wide it is there, and how input and output vary together.

Kalman, extended, unscented and cubature filters differ in nothing else. Each way below takes a belief N(mean, cov) and
a function and returns `Moments`; the argument `through` of filters, `predict` and `correct` chooses the way. No noise
is added here.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..core.frozen import Frozen
from ..core.matrices import congruence, correlations, root
from ..models import checks as check


class Moments(NamedTuple):
    """Mean (..., m) and covariance (..., m, m) of the output, and its cross-covariance (..., n, m) with the input.

    slope, rest and basis split cov so that Joseph's form can be used: where the input varies by d, the output varies by
    `slope` d and by what no slope explains, of covariance `rest` (..., m, m); so cov = slope C slopeᵀ + rest with the
    input's covariance C. With a `basis` L, L Lᵀ = C, the input varies by L ξ and the output by `slope` ξ.
    """

    mean: np.ndarray
    cov: np.ndarray
    cross: np.ndarray
    slope: np.ndarray
    basis: np.ndarray | None = None
    rest: np.ndarray | float = 0.0


def linearize(belief, function, slope, difference=np.subtract) -> Moments:
    """Push a belief through a function along the tangent at its mean: the extended Kalman filter's way.

    Exact for a linear function, first order for any other.

    Parameters
    ----------
    belief : Gaussian
        Mean (..., n).
    function : callable
        (..., n) → (..., m).
    slope : callable
        (..., n) → the Jacobian (..., m, n).
    difference : callable
        Not needed here; sigma points use it.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, ch. 10.3.

    Examples
    --------
    >>> from kflearn import Gaussian, linearize
    >>> square = linearize(Gaussian(3, 2), lambda x: x**2, lambda x: 2 * x[..., None])
    >>> print(f"mean {square.mean[0]:.0f}, variance {square.cov[0, 0]:.0f}")
    mean 9, variance 72
    """
    A = slope(belief.mean)
    return Moments(function(belief.mean), *congruence(A, belief.cov), A)


class SigmaPoints(NamedTuple):
    """A rule: 2n+1 points, the mean and ± `spread` columns of the covariance's root, and how they are weighed.

    weight: that of each point but the one in the middle. extra: how often the square of the mean's shift counts in the
    covariance; −1 for "mean of squares less square of mean", β − α² in the scaled unscented rule.
    """

    spread: float
    weight: float
    extra: float

    def __call__(self, belief, function, slope=None, difference=np.subtract) -> Moments:
        """Push the points through `function` and take their weighted moments; `slope` is not needed.

        `function` gets all points at once, (2n+1, ..., n).
        """
        n = belief.mean.shape[-1]
        L = np.broadcast_to(root(belief.cov), (*belief.batch, n, n))
        reach = self.spread * np.moveaxis(L, -1, 0)
        out = function(belief.mean + np.concatenate([np.zeros_like(reach[:1]), reach, -reach]))
        # All relative to the image of the mean: weights of ±1e4 then cost fewer digits, and angles may wrap.
        offset = difference(out[1:], out[0])
        ahead, behind = offset[:n], offset[n:]
        # The odd part of the function over a pair of ±points is its slope; the even part is curvature.
        slope = np.moveaxis(ahead - behind, 0, -1) / (2 * self.spread)
        bend = np.moveaxis((ahead + behind) / 2, 0, -1)
        shift = 2 * self.weight * bend.sum(axis=-1)
        rest = self._curvature(bend, shift)
        return Moments(out[0] + shift, slope @ slope.mT + rest, L @ slope.mT, slope, L, rest)

    def _curvature(self, bend, shift):
        """2 w Σ b bᵀ + extra s sᵀ for the columns b of `bend`, as a sum of squares wherever it is one.

        Written so, no rounding makes a variance negative: for extra < 0, b − c s with the right c takes the place of b.
        """
        most = 1 / (2 * self.weight * bend.shape[-1])  # no b − c s takes away more than this share of s sᵀ
        c = most * (1 - np.sqrt(max(1 + self.extra / most, 0))) if self.extra < 0 else 0.0
        bend = bend - c * shift[..., :, None]
        left = self.extra if self.extra >= 0 else min(self.extra + most, 0)
        return 2 * self.weight * bend @ bend.mT + left * shift[..., :, None] * shift[..., None, :]

    def may_be_negative(self, n):
        """Can these weights make a covariance that is none?"""
        return 1 + 2 * self.weight * n * self.extra < 0


def unscented(n, alpha=1.0, beta=2.0, kappa=0.0) -> SigmaPoints:
    """The scaled unscented rule for n states: 2n+1 points at ±α √(n + κ) standard deviations.

    Parameters
    ----------
    n : int
        The number of states, e.g. model.n.
    alpha, beta, kappa : float
        λ = α²(n + κ) − n. β changes the weight of the middle point in the covariance; 2 is best for Gaussians.

    Returns
    -------
    SigmaPoints
        To be given as `through`.

    Raises
    ------
    ValueError
        When n is no whole number from 1, or alpha or n + kappa is not positive.

    References
    ----------
    Wan and van der Merwe 2000.

    Examples
    --------
    >>> from kflearn import Gaussian, unscented
    >>> square = unscented(1)(Gaussian(3, 2), lambda x: x**2)
    >>> print(f"mean {square.mean[0]:.0f}, variance {square.cov[0, 0]:.0f}")
    mean 11, variance 80
    """
    n = check.whole_number("n", n)
    alpha, beta = check.number("alpha", alpha, positive=True), check.number("beta", beta)
    if not n + check.number("kappa", kappa) > 0:
        raise ValueError(f"kappa must be greater than -{n}, or else the points do not spread, got {kappa}")
    scale = alpha**2 * (n + kappa)
    return SigmaPoints(np.sqrt(scale), 1 / (2 * scale), beta - alpha**2)


def cubature(n) -> SigmaPoints:
    """The third-degree cubature rule for n states: 2n points of equal weight at ±√n standard deviations.

    Parameters
    ----------
    n : int
        The number of states, e.g. model.n.

    Returns
    -------
    SigmaPoints
        To be given as `through`.

    Raises
    ------
    ValueError
        When n is no whole number from 1.

    References
    ----------
    Arasaratnam and Haykin 2009.

    Examples
    --------
    >>> from kflearn import Gaussian, cubature
    >>> square = cubature(1)(Gaussian(3, 2), lambda x: x**2)
    >>> print(f"mean {square.mean[0]:.0f}, variance {square.cov[0, 0]:.0f}")
    mean 11, variance 72
    """
    return SigmaPoints(np.sqrt(check.whole_number("n", n)), 1 / (2 * n), -1.0)


@dataclass(frozen=True, eq=False)
class AlongPath(Frozen):
    """The way of the linearised filter: slopes (..., n, n) that were found beforehand, whatever the belief is."""

    slopes: np.ndarray

    def __call__(self, belief, function=None, slope=None, difference=np.subtract) -> Moments:
        """The moments but the mean, which a smoother does not need."""
        return Moments(None, *congruence(self.slopes, belief.cov), self.slopes)


def refuse_negative(name, P, through, k, *parts):
    """Where sigma points may make a P that is no covariance: look at it, and say what to do.

    parts: one or more covariances that P is made of. A variance that is negative beside theirs is no rounding error
    either, however small the units of this state are.
    """
    if not isinstance(through, SigmaPoints) or not through.may_be_negative(P.shape[-1]):
        return
    values = np.linalg.eigvalsh(P)
    size = sum(abs(np.diagonal(part, axis1=-2, axis2=-1)) for part in parts)
    own = np.linalg.eigvalsh(correlations(P, np.sqrt(np.where(size > 0, size, 1)))[0])[..., 0]
    plain = values[..., 0] < -1e-9 * abs(values).max(axis=-1)
    if (bad := plain | (own < -1e-9)).any():
        raise ValueError(
            f"kappa or beta must be larger, so that n beta + alpha² kappa is at least 0: at step {k} these sigma "
            f"points make {name} no covariance, with the eigenvalue {np.where(plain, values[..., 0], own)[bad][0]:.2g}"
        )


def check_through(through):
    """`through` has to be one of the ways above."""
    if through is linearize:
        return
    for rule in (unscented, cubature):
        if through is rule:
            name = rule.__name__
            raise TypeError(f"through must be a rule for a number of states, {name}(model.n), got {name} itself")
    if not callable(through):
        raise TypeError(f"through must be linearize, unscented(model.n) or cubature(model.n), got {through!r}")
