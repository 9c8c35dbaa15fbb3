"""Is the filter good, and does it know how good it is?"""

import numpy as np

from . import _checks as check
from .results import squared_distance


def rmse(estimate, truth, axis=None):
    """Root mean square difference, over everything or along `axis` (as in NumPy), in the units of the arguments.

    Raises ValueError where the shapes do not broadcast.
    """
    estimate, truth = check.numbers("estimate", estimate), check.numbers("truth", truth)
    try:
        error = estimate - truth
    except ValueError:
        raise ValueError(f"truth must fit the estimate's shape {estimate.shape}, got {truth.shape}") from None
    return np.sqrt(np.mean(error**2, axis=axis))


def nees(belief, truth):
    """Normalised estimation error squared eᵀ P⁻¹ e, one a step: (..., T). Honest beliefs average n, the state's length.

    belief: anything with .mean (..., T, n) and .cov (..., T, n, n), a Track or a Gaussian; truth: (..., T, n).
    Source: Bar-Shalom, Li and Kirubarajan 2001, eq. (5.4.2-4).
    """
    truth = check.shape("truth", check.numbers("truth", truth), (belief.mean.shape[-1],))
    return squared_distance(truth - belief.mean, belief.cov)


def nis(track):
    """Normalised innovation squared, one a step: (..., T). Honest filters average m. (5.4.2-9) of the same book."""
    return track.nis


def chi_square_interval(dof, runs=1, probability=0.95):
    """The two-sided interval (low, high) in which the average of `runs` chi-square values lies with `probability`.

    dof: degrees of freedom of each: n for NEES, m for NIS. Multiply `runs` by the steps when averaging over time too
    (exact for NIS, whose steps are independent; too narrow for NEES, whose steps are not).
    """
    from scipy.special import gammaincinv  # imported here: `import kflearn` shall not wait for SciPy

    check.whole_number("dof", dof)
    check.whole_number("runs", runs)
    if not 0 < probability < 1:
        raise ValueError(f"probability must lie between 0 and 1, got {probability!r}")
    tails = np.array([(1 - probability) / 2, (1 + probability) / 2])
    low, high = 2 * gammaincinv(dof * runs / 2, tails) / runs
    return float(low), float(high)


def coverage(belief, truth, sigmas=2):
    """The fraction of true values inside mean ± sigmas·std, one for each component: (n,). 2σ should hold 0.954."""
    return np.mean(abs(truth - belief.mean) <= sigmas * belief.std, axis=tuple(range(belief.mean.ndim - 1)))


def whiteness(innovation, lags=20):
    """The autocorrelation of the normalised innovations at lags 1 … `lags`, averaged over runs: (lags, m).

    innovation: Gaussian along time with mean (..., T, m), without gaps. White innovations stay within ±1.96/√N, N being
    runs × (T − lag), in 95 of 100 cases. Raises ValueError when the series is not longer than `lags`.
    """
    y = check.numbers("innovation", innovation.mean / innovation.std)
    T = y.shape[-2]
    if check.whole_number("lags", lags) >= T:
        raise ValueError(f"lags must be smaller than the {T} steps of the series, got {lags}")
    over = tuple(range(y.ndim - 1))
    power = np.mean(y**2, axis=over)
    return np.stack([np.mean(y[..., lag:, :] * y[..., :-lag, :], axis=over) / power for lag in range(1, lags + 1)])
