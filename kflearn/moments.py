"""A Gaussian through a function: where it lands, how wide it is there, and how in and out go together.

Kalman, extended, unscented and cubature filters differ in nothing else. Each way below takes a belief N(mean, cov) and
a function and returns `Moments`; `through` chooses what a filter uses. No noise is added here.
"""

from typing import NamedTuple

import numpy as np

from . import _checks as check
from .gaussian import root


class Moments(NamedTuple):
    """Mean (..., m) and covariance (..., m, m) of the output, and its cross-covariance (..., n, m) with the input.

    The other three say how these came about, for those who must not subtract covariances. Where the input varies by d,
    the output varies by `slope` d and by what no slope explains, of covariance `rest` (..., m, m). With a `basis` L,
    L Lᵀ being the input's covariance, where the input varies by L ξ the output varies by `slope` ξ.
    """

    mean: np.ndarray
    cov: np.ndarray
    cross: np.ndarray
    slope: np.ndarray
    basis: np.ndarray | None = None
    rest: np.ndarray | float = 0.0


def linearize(belief, function, slope, difference=np.subtract):
    """Along the tangent at the mean: exact for a linear function, first order for any other (EKF).

    slope(x) gives the Jacobian (..., m, n).
    """
    A = slope(belief.mean)
    return Moments(function(belief.mean), *spread(A, belief.cov), A)


def spread(A, P):
    """What a matrix does to a covariance: A P Aᵀ, and the cross-covariance P Aᵀ."""
    cross = _times(P, A.mT)
    return _times(cross.mT, A.mT).mT, cross


def _times(P, B):
    """P B. Where one B serves a whole axis of matrices P, their rows make one tall matrix: several times faster."""
    if P.ndim < 3 or (B.ndim > 2 and B.shape[-3] != 1):
        return P @ B
    rows = P.shape[-3] * P.shape[-2]
    product = P.reshape(*P.shape[:-3], rows, P.shape[-1]) @ (B if B.ndim == 2 else B[..., 0, :, :])
    return product.reshape(*product.shape[:-2], *P.shape[-3:-1], B.shape[-1])


class SigmaPoints(NamedTuple):
    """A rule: 2n+1 points, the mean and ± `spread` columns of the covariance's root, and their weights."""

    spread: float
    cov_centre: float
    others: float

    def __call__(self, belief, function, slope=None, difference=np.subtract):
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
        shift = self.others * offset.sum(axis=0)
        # A straight line moves a pair of points by ±: its slope is in their difference, what bends in their sum.
        slope = np.moveaxis(ahead - behind, 0, -1) / (2 * self.spread)
        bend = np.moveaxis((ahead + behind) / 2 - shift, 0, -1)
        rest = 2 * self.others * bend @ bend.mT + self.cov_centre * shift[..., :, None] * shift[..., None, :]
        return Moments(out[0] + shift, slope @ slope.mT + rest, L @ slope.mT, slope, L, rest)


def unscented(n, alpha=1.0, beta=2.0, kappa=0.0):
    """The scaled unscented rule for n states (Wan and van der Merwe 2000): λ = α²(n + κ) − n.

    Raises ValueError unless alpha and n + kappa are positive.
    """
    alpha, beta = check.number("alpha", alpha, positive=True), check.number("beta", beta)
    if not n + check.number("kappa", kappa) > 0:
        raise ValueError(f"kappa must be greater than -{n}, or else the points do not spread, got {kappa}")
    scale = alpha**2 * (n + kappa)
    centre = 1 - n / scale
    return SigmaPoints(np.sqrt(scale), centre + 1 - alpha**2 + beta, 1 / (2 * scale))


def cubature(n):
    """The third-degree cubature rule for n states (Arasaratnam and Haykin 2009): 2n points of equal weight."""
    return SigmaPoints(np.sqrt(n), 0.0, 1 / (2 * n))
