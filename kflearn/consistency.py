"""Is the filter good, and does it know how good it is?"""

import numpy as np

from . import _checks as check
from .conditioning import squared_distance


def rmse(estimate, truth, axis=None):
    """Root mean square difference, over everything or along `axis` (as in NumPy), in the units of the arguments.

    Raises ValueError where one of the two cannot be stretched to the shape of the other: (T, 1) and (T,) do not fit.
    """
    estimate, truth = check.numbers("estimate", estimate), check.numbers("truth", truth)
    _fit(truth.shape, estimate.shape)
    return np.sqrt(np.mean((estimate - truth) ** 2, axis=axis))


def nees(belief, truth):
    """Normalised estimation error squared eᵀ P⁻¹ e, one a step: (..., T). Honest beliefs average n, the state's length.

    belief: anything with .mean (..., T, n) and .cov (..., T, n, n), a Track or a Gaussian; truth: (..., T, n).
    Source: Bar-Shalom, Li and Kirubarajan 2001, eq. (5.4.2-4).
    """
    truth = _truth_for(belief, truth)
    with np.errstate(divide="ignore", invalid="ignore"):
        try:
            score = squared_distance(truth - belief.mean, belief.cov)
        except np.linalg.LinAlgError:
            score = np.nan
    if not np.isfinite(score).all():
        raise ValueError("belief must have invertible covariances, found a singular one: take a marginal")
    return score


def nis(track):
    """Normalised innovation squared, one a step: (..., T). Honest filters average m. (5.4.2-9) of the same book."""
    if not hasattr(track, "nis"):
        raise TypeError(f"track must be what a filter returns, got {type(track).__name__}")
    return track.nis


def chi_square_interval(dof, runs=1, probability=0.95):
    """The two-sided interval (low, high) in which the average of `runs` chi-square values lies with `probability`.

    dof: degrees of freedom of each: n for NEES, m for NIS. Multiply `runs` by the steps when averaging over time too
    (exact for NIS, whose steps are independent; too narrow for NEES, whose steps are not).
    """
    from scipy.special import gammaincinv  # imported here: `import kflearn` shall not wait for SciPy

    check.whole_number("dof", dof)
    check.whole_number("runs", runs)
    if not 0 < check.number("probability", probability) < 1:
        raise ValueError(f"probability must lie between 0 and 1, got {probability!r}")
    tails = np.array([(1 - probability) / 2, (1 + probability) / 2])
    low, high = 2 * gammaincinv(dof * runs / 2, tails) / runs
    return float(low), float(high)


def coverage(belief, truth, sigmas=2):
    """The fraction of true values inside mean ± sigmas·std, one for each component: (n,). 2σ should hold 0.954."""
    error = _truth_for(belief, truth) - belief.mean
    inside = abs(error) <= check.number("sigmas", sigmas, positive=True) * belief.std
    return np.mean(inside, axis=tuple(range(inside.ndim - 1)))


def whiteness(innovation, lags=20):
    """The autocorrelation of the normalised innovations at lags 1 … `lags`, averaged over runs: (lags, m).

    innovation: Gaussian along time with mean (..., T, m), without gaps. White innovations stay within ±1.96/√N, N being
    runs × (T − lag), in 95 of 100 cases. Raises ValueError when the series is not longer than `lags`.
    """
    _check_belief("innovation", innovation)
    y = check.shape("innovation", check.numbers("innovation", innovation.mean / innovation.std), (None, None))
    T = y.shape[-2]
    if check.whole_number("lags", lags) >= T:
        raise ValueError(f"lags must be smaller than the {T} steps of the series, got {lags}")
    over = tuple(range(y.ndim - 1))
    power = np.mean(y**2, axis=over)
    return np.stack([np.mean(y[..., lag:, :] * y[..., :-lag, :], axis=over) / power for lag in range(1, lags + 1)])


def _check_belief(name, belief):
    if not isinstance(getattr(belief, "cov", None), np.ndarray):
        raise TypeError(f"{name} must have a .mean and a .cov, as Gaussians and tracks do, got {type(belief).__name__}")


def _truth_for(belief, truth):
    """True states (..., T, n) that go with a belief."""
    _check_belief("belief", belief)
    truth = check.shape("truth", check.numbers("truth", truth), (belief.mean.shape[-1],))
    _fit(truth.shape, belief.mean.shape)
    return truth


def _fit(truth, estimate):
    try:
        whole = np.broadcast_shapes(truth, estimate)
    except ValueError:
        whole = None
    if whole not in (truth, estimate):
        raise ValueError(f"truth must fit the shape {estimate} of the estimate, got {truth}")
