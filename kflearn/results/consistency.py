"""Is the filter good, and does it know how good it is?"""

import numpy as np

from ..core.conditioning import squared_distance
from ..core.matrices import compact
from ..models import checks as check
from .track import Filtered


def rmse(estimate, truth, axis=None) -> np.ndarray:
    """Root mean square difference, over everything or along `axis`.

    Parameters
    ----------
    estimate, truth : array_like
        Arrays of which one can be stretched to the shape of the other; (..., T) goes with (..., T, 1).
    axis : int or tuple of int, optional
        As in NumPy.

    Returns
    -------
    float or ndarray
        In the units of the arguments.

    Raises
    ------
    ValueError
        Where the shapes do not fit, or something is not finite.

    Examples
    --------
    >>> from kflearn import rmse
    >>> print(f"{rmse([1.0, 2.0, 3.0], [1.0, 2.0, 6.0]):.3f}")
    1.732
    """
    estimate, truth = check.numbers("estimate", estimate), check.numbers("truth", truth)
    estimate, truth = _with_one_component(estimate, truth), _with_one_component(truth, estimate)
    _fit(truth.shape, estimate.shape)
    return np.sqrt(np.mean((estimate - truth) ** 2, axis=axis))


def nees(belief, truth) -> np.ndarray:
    """Normalised estimation error squared eᵀ P⁻¹ e, one a step. Honest beliefs average n, the number of states.

    Parameters
    ----------
    belief : Track or Gaussian
        Anything with .mean (..., T, n) and .cov (..., T, n, n).
    truth : array_like
        True states (..., T, n); (..., T) will do for one state.

    Returns
    -------
    ndarray (..., T)
        Pure numbers.

    Raises
    ------
    ValueError, TypeError
        Where the shapes do not fit or a covariance is singular.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, eq. (5.4.2-4).

    Examples
    --------
    >>> from kflearn import Gaussian, nees
    >>> print(f"{nees(Gaussian([0, 0], [[4, 0], [0, 9]]), [2, 3]):.0f}")
    2
    """
    truth = _truth_for(belief, truth)
    with np.errstate(divide="ignore", invalid="ignore"):
        try:
            score = squared_distance(truth - belief.mean, compact(belief.cov))
        except np.linalg.LinAlgError:
            score = np.array(np.nan)
    if not np.isfinite(score).all():
        raise ValueError("belief must have invertible covariances, found a singular one: take a marginal")
    return score


def nis(track) -> np.ndarray:
    """Normalised innovation squared yᵀ S⁻¹ y, one a step. Honest filters average m, the number of measured components.

    Parameters
    ----------
    track : Track
        What a filter returns.

    Returns
    -------
    ndarray (..., T)
        Pure numbers; NaN where nothing was measured. Of a step that was measured in part, only that part counts. A
        reading that a gate refused has its NIS too: see track.refused.

    Raises
    ------
    TypeError
        When track is no Track; the multiple-model filters have no single innovation.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, eq. (5.4.2-9).

    Examples
    --------
    >>> from kflearn import Gaussian, kalman_filter, nis, random_walk
    >>> print(f"{nis(kalman_filter(random_walk(1, 2), [4.0], Gaussian(0, 1)))[0]:.0f}")
    4
    """
    if not hasattr(track, "nis"):
        raise TypeError(f"track must be what a filter returns, got {type(track).__name__}")
    return track.nis


def chi_square_interval(dof, runs=1, probability=0.95) -> tuple[float, float]:
    """The two-sided interval in which the average of `runs` chi-square values lies with `probability`.

    Parameters
    ----------
    dof : int
        Degrees of freedom of each value: n for NEES, m for NIS.
    runs : int
        The number of independent values. When averaging over time too, multiply by the steps: exact for NIS, whose
        steps are independent; too narrow for NEES, whose steps are not.
    probability : float
        Between 0 and 1.

    Returns
    -------
    tuple of two floats
        (low, high).

    Raises
    ------
    ValueError, TypeError
        When an argument does not make sense.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, ch. 5.4.

    Examples
    --------
    >>> from kflearn import chi_square_interval
    >>> low, high = chi_square_interval(2, runs=50)
    >>> print(f"{low:.2f} to {high:.2f}")
    1.48 to 2.59
    """
    from scipy.special import gammaincinv  # imported here: `import kflearn` shall not wait for SciPy

    check.whole_number("dof", dof)
    check.whole_number("runs", runs)
    if not 0 < check.number("probability", probability) < 1:
        raise ValueError(f"probability must lie between 0 and 1, got {probability!r}")
    tails = np.array([(1 - probability) / 2, (1 + probability) / 2])
    low, high = 2 * gammaincinv(dof * runs / 2, tails) / runs
    return float(low), float(high)


def coverage(belief, truth, sigmas=2) -> np.ndarray:
    """The fraction of true values inside mean ± sigmas·std, one for each state. 2σ should hold 0.954.

    Parameters
    ----------
    belief : Track or Gaussian
        Anything with .mean (..., T, n) and .cov (..., T, n, n).
    truth : array_like
        True states (..., T, n); (..., T) will do for one state.
    sigmas : float
        Half the width of the band in standard deviations.

    Returns
    -------
    ndarray (n,)
        Between 0 and 1.

    Raises
    ------
    ValueError, TypeError
        Where the shapes do not fit.

    Examples
    --------
    >>> from kflearn import Gaussian, coverage
    >>> print(f"{coverage(Gaussian([[0], [0]], 1), [1.9, 2.1])[0]:.1f}")
    0.5
    """
    error = _truth_for(belief, truth) - belief.mean
    std = np.sqrt(np.diagonal(compact(belief.cov), axis1=-2, axis2=-1))
    inside = abs(error) <= check.number("sigmas", sigmas, positive=True) * std
    return np.mean(inside, axis=tuple(range(inside.ndim - 1)))


def whiteness(track, lags=20) -> np.ndarray:
    """The autocorrelation of the normalised innovations at lags 1 … `lags`, averaged over steps and runs.

    White innovations stay within ±1.96/√N in 95 of 100 cases, N being the number of pairs: runs × (T − lag) without
    gaps.

    Parameters
    ----------
    track : Track or Gaussian
        A track, of which the innovations are judged, or innovations: mean (..., T, m), NaN where nothing was measured.
    lags : int
        Below T.

    Returns
    -------
    ndarray (lags, m)
        The mean of y_k y_{k−lag} over all pairs that were measured, by the mean of y² over all that was measured;
        NaN where there is no such pair.

    Raises
    ------
    ValueError, TypeError
        When the series is not longer than `lags`, or track has no innovations.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, eq. (5.4.2-12).

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import Gaussian, whiteness
    >>> swing = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])[:, None]
    >>> print([f"{found:.1f}" for found in whiteness(Gaussian(swing, 1), lags=2)[:, 0]])
    ['-1.0', '1.0']
    """
    innovation = getattr(track, "innovation", track)
    if isinstance(innovation, Filtered):
        raise TypeError("track must have innovations: a track of imm_filter or mmae_filter has one for each model")
    _check_belief("track", innovation)
    std = np.sqrt(np.diagonal(compact(innovation.cov), axis1=-2, axis2=-1))
    y = check.shape("track", check.numbers("track", innovation.mean / std, gaps=True), (None, None))
    T = y.shape[-2]
    if check.whole_number("lags", lags) >= T:
        raise ValueError(f"lags must be smaller than the {T} steps of the series, got {lags}")
    power = _mean(y**2)
    return np.stack([_mean(lagged_products(y, lag)) / power for lag in range(1, lags + 1)])


def lagged_products(y, lag):
    """y_k y_{k−lag} of a series (..., T, m), (..., T − lag, m): the one ingredient of every autocorrelation."""
    return y[..., lag:, :] * y[..., :-lag, :]


def _mean(products):
    """The mean over runs and steps (m,), of what is not NaN."""
    over = tuple(range(products.ndim - 1))
    seen = ~np.isnan(products)
    if seen.all():
        return np.mean(products, axis=over)
    with np.errstate(invalid="ignore"):
        return np.where(seen, products, 0).sum(axis=over) / seen.sum(axis=over)


def _check_belief(name, belief):
    if not isinstance(getattr(belief, "cov", None), np.ndarray):
        raise TypeError(f"{name} must have a .mean and a .cov, as Gaussians and tracks do, got {type(belief).__name__}")


def _truth_for(belief, truth):
    """True states (..., T, n) that go with a belief."""
    _check_belief("belief", belief)
    truth = check.numbers("truth", truth)
    truth = check.shape("truth", _with_one_component(truth, belief.mean), (belief.mean.shape[-1],))
    _fit(truth.shape, belief.mean.shape)
    return truth


def _with_one_component(series, other):
    """A series (..., T) as (..., T, 1) where the other one has that shape: one state needs no axis of its own."""
    return series[..., None] if other.ndim > 1 and other.shape == (*series.shape, 1) else series


def _fit(truth, estimate):
    try:
        whole = np.broadcast_shapes(truth, estimate)
    except ValueError:
        whole = None
    if whole not in (truth, estimate):
        raise ValueError(f"truth must fit the shape {estimate} of the estimate, got {truth}")
