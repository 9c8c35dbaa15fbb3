"""A Gaussian through a function: where it lands, how wide it is there, and how in and out go together.

Kalman, extended, unscented and cubature filters differ in nothing else. Each way below takes a belief N(mean, cov) and
a function and returns `Moments`; `through` chooses what a filter uses. No noise is added here.
"""

from typing import NamedTuple

import numpy as np

from .gaussian import root


class Moments(NamedTuple):
    """Mean (..., m) and covariance (..., m, m) of the output, its cross-covariance (..., n, m) with the input, and the
    matrix (..., m, n) of a linear map where there is one."""

    mean: np.ndarray
    cov: np.ndarray
    cross: np.ndarray
    matrix: np.ndarray | None = None


def linearize(belief, function, slope, difference=np.subtract):
    """Along the tangent at the mean: exact for a linear function, first order for any other (EKF).

    slope(x) gives the Jacobian (..., m, n).
    """
    A = slope(belief.mean)
    return Moments(function(belief.mean), *spread(A, belief.cov), A)


def spread(A, P):
    """What a matrix does to a covariance: A P Aᵀ, and the cross-covariance P Aᵀ."""
    cross = P @ A.mT
    return A @ cross, cross


class SigmaPoints(NamedTuple):
    """A rule: 2n+1 points, the mean and ± `spread` columns of the covariance's root, and their weights."""

    spread: float
    cov_centre: float
    others: float

    def __call__(self, belief, function, slope=None, difference=np.subtract):
        """Push the points through `function` and take their weighted moments; `slope` is not needed."""
        reach = self.spread * root(belief.cov).mT  # its rows are the steps from the mean to the points
        reach = np.concatenate([np.zeros_like(reach[..., :1, :]), reach, -reach], axis=-2)
        out = function(belief.mean[..., None, :] + reach)
        # All relative to the image of the mean: weights of ±1e4 then cost no digits, and angles may wrap.
        centre = out[..., :1, :]
        offset = difference(out, centre)
        shift = self.others * offset[..., 1:, :].sum(axis=-2)
        deviation = offset - shift[..., None, :]
        weights = np.full(out.shape[-2], self.others)
        weights[0] = self.cov_centre
        weighted = (deviation * weights[:, None]).mT
        return Moments(centre[..., 0, :] + shift, weighted @ deviation, (weighted @ reach).mT)


def unscented(n, alpha=1.0, beta=2.0, kappa=0.0):
    """The scaled unscented rule for n states (Wan and van der Merwe 2000): λ = α²(n + κ) − n.

    Raises ValueError unless n + λ is positive.
    """
    scale = alpha**2 * (n + kappa)
    if not scale > 0:
        raise ValueError(f"alpha and kappa must give alpha² (n + kappa) > 0, got {scale:g} for n = {n}")
    centre = 1 - n / scale
    return SigmaPoints(np.sqrt(scale), centre + 1 - alpha**2 + beta, 1 / (2 * scale))


def cubature(n):
    """The third-degree cubature rule for n states (Arasaratnam and Haykin 2009): 2n points of equal weight."""
    return SigmaPoints(np.sqrt(n), 0.0, 1 / (2 * n))
