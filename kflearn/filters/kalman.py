"""The filters over a series: Kalman, extended, unscented, cubature and linearised.

The letters, here and in the other modules of this folder; the superscript ⁻ means "before the measurement":

    x, P   the state's mean (n,) and covariance (n, n): a belief, N(x, P)
    F, f   how the state moves: x⁻ = F x, or f(x)                    Q   covariance (n, n) of what f cannot foresee
    B, u   how a control input u (p,) pushes the state: + B u
    H, h   what is measured of the state: ẑ = H x⁻, or h(x⁻)         R   covariance (m, m) of the measurement's noise
    z, y   the measurement (m,) and the innovation y = z − ẑ         S   covariance (m, m) of y
    C      cross-covariance (n, m) of state and measurement, P⁻Hᵀ    K   the gain (n, m), C S⁻¹
    n, m, p, T   the numbers of states, measured components, control inputs and steps

These filters differ only in `through`, the way a belief goes through a function (see `moments`).

Start convention, everywhere: `initial` is the belief one step BEFORE the first measurement. Every step predicts, then
corrects (FilterPy does the same; pykalman, statsmodels and dynamax hold it at the first measurement).
"""

from dataclasses import replace

import numpy as np

from ..models import checks as check
from ..models.arguments import check_model, check_series
from ..models.jumps import watched
from ..models.state_space import LinearModel
from ..results.track import StackedSteps, Track, stack_in_time
from .gate import gate_limits
from .linear import covariance_step, linear_filter
from .moments import AlongPath, cubature, linearize, unscented
from .steps import along, at_step, corrected_belief, predicted_belief, starting_belief


def kalman_filter(model, z, initial, u=None, *, gate=None) -> Track:
    """The Kalman filter over a series, or over many series at once: eqs (5)–(9).

    Parameters
    ----------
    model : LinearModel
        With n states, m measured components and p control inputs.
    z : array_like
        Measurements (..., T, m), or (T,) when m = 1. NaN: that component was not measured.
    initial : Gaussian
        The belief one step before the first measurement; it may have batch axes too.
    u : array_like, optional
        Control inputs (..., T, p), or (T,) when p = 1; u[k] acts on the way to z[k].
    gate : float, optional
        A probability such as 0.99: a reading whose NIS is larger than this share of honest ones would have it is
        refused, as if it had not come; `track.refused` tells which. Without it every reading is used.

    Returns
    -------
    Track
        With mean (..., T, n) and cov (..., T, n, n) after each measurement, in the units of the states. Where S is
        10ᵈ times R, up to d of a double's 16 digits are lost, counted in standard deviations; so it is in all filters
        but square_root_kalman_filter. For a start of which nothing is known, see diffuse_start.

    Raises
    ------
    ValueError, TypeError
        Naming the argument, before anything is computed.

    References
    ----------
    Kalman 1960; Bar-Shalom, Li and Kirubarajan 2001, ch. 5.2.

    Examples
    --------
    >>> from kflearn import Gaussian, kalman_filter, random_walk
    >>> track = kalman_filter(random_walk(0, 1), [1.0, 2.0, 3.0], Gaussian(0, 1e6))
    >>> print(f"{track.mean[-1, 0]:.3f} ± {track.std[-1, 0]:.3f}")
    2.000 ± 0.577
    """
    return linear_filter(model, z, initial, u, covariance_step, gate=gate)


def extended_kalman_filter(model, z, initial, u=None, *, gate=None) -> Track:
    """The extended Kalman filter: every function is replaced by its tangent at the latest estimate.

    Parameters
    ----------
    model : NonlinearModel or LinearModel
        Jacobians given, or else taken by differences.
    z, initial, u, gate
        As in kalman_filter.

    Returns
    -------
    Track
        Covariances and gains depend on the data: every run has its own.

    Raises
    ------
    ValueError, TypeError
        Naming the argument; also when f or h returns NaN, or jumps by a turn where no difference for it was given,
        naming the function and the step (counted from 0).

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, ch. 10.3.

    Examples
    --------
    >>> from kflearn import Gaussian, NonlinearModel, extended_kalman_filter
    >>> model = NonlinearModel(lambda x: x, lambda x: x**2, Q=0.01, R=0.1)
    >>> track = extended_kalman_filter(model, [4.1, 3.9, 4.0], Gaussian(1.5, 1))
    >>> print(f"{track.mean[-1, 0]:.2f} ± {track.std[-1, 0]:.2f}")
    2.00 ± 0.07
    """
    return gaussian_filter(model, z, initial, u, linearize, gate)


def unscented_kalman_filter(model, z, initial, u=None, *, alpha=1.0, beta=2.0, kappa=0.0, gate=None) -> Track:
    """The unscented Kalman filter, sigma points redrawn after Q was added.

    Parameters
    ----------
    model, z, initial, u
        As in extended_kalman_filter; Jacobians are not needed.
    alpha, beta, kappa : float
        Where the points lie and how they are weighed, as in unscented: λ = α²(n + κ) − n.
    gate : float, optional
        As in kalman_filter.

    Returns
    -------
    Track
        As from extended_kalman_filter.

    Raises
    ------
    ValueError, TypeError
        As in extended_kalman_filter; when alpha or n + kappa is not positive, or when the points make a matrix that is
        no covariance, which can happen where n beta + alpha² kappa is negative.

    References
    ----------
    Wan and van der Merwe 2000.

    Examples
    --------
    >>> from kflearn import Gaussian, NonlinearModel, unscented_kalman_filter
    >>> model = NonlinearModel(lambda x: x, lambda x: x**2, Q=0.01, R=0.1)
    >>> track = unscented_kalman_filter(model, [4.1, 3.9, 4.0], Gaussian(1.5, 1))
    >>> print(f"{track.mean[-1, 0]:.2f} ± {track.std[-1, 0]:.2f}")
    1.98 ± 0.07
    """
    check_model(model)
    return gaussian_filter(model, z, initial, u, unscented(model.n, alpha, beta, kappa), gate)


def cubature_kalman_filter(model, z, initial, u=None, *, gate=None) -> Track:
    """The cubature Kalman filter, points redrawn after Q was added.

    Parameters
    ----------
    model, z, initial, u, gate
        As in extended_kalman_filter; Jacobians are not needed.

    Returns
    -------
    Track
        As from extended_kalman_filter.

    Raises
    ------
    ValueError, TypeError
        As in extended_kalman_filter.

    References
    ----------
    Arasaratnam and Haykin 2009.

    Examples
    --------
    >>> from kflearn import Gaussian, NonlinearModel, cubature_kalman_filter
    >>> model = NonlinearModel(lambda x: x, lambda x: x**2, Q=0.01, R=0.1)
    >>> track = cubature_kalman_filter(model, [4.1, 3.9, 4.0], Gaussian(1.5, 1))
    >>> print(f"{track.mean[-1, 0]:.2f} ± {track.std[-1, 0]:.2f}")
    1.98 ± 0.07
    """
    check_model(model)
    return gaussian_filter(model, z, initial, u, cubature(model.n), gate)


def linearized_kalman_filter(model, z, initial, u=None, *, nominal=None, gate=None) -> Track:
    """The linearised Kalman filter: every function is replaced by its tangent along a path fixed beforehand.

    Parameters
    ----------
    model, z, initial, u
        As in extended_kalman_filter.
    nominal : array_like, optional
        States (..., T, n), the path at each measurement. Without it, the path that initial.mean takes if nothing
        disturbs it. The first move is linearised at initial.mean.
    gate : float, optional
        As in kalman_filter.

    Returns
    -------
    Track
        Gains and covariances do not depend on the data (without a gate): one sequence serves all runs.

    Raises
    ------
    ValueError, TypeError
        As in extended_kalman_filter, and when nominal does not fit.

    References
    ----------
    Maybeck 1982, ch. 9.5.

    Examples
    --------
    >>> from kflearn import Gaussian, NonlinearModel, linearized_kalman_filter
    >>> model = NonlinearModel(lambda x: x, lambda x: x**2, Q=0.01, R=0.1)
    >>> track = linearized_kalman_filter(model, [4.1, 3.9, 4.0], Gaussian(1.9, 1))
    >>> print(f"{track.mean[-1, 0]:.2f} ± {track.std[-1, 0]:.2f}")
    2.00 ± 0.07
    """
    check_model(model)
    z, u, batch = check_series(model, z, initial, u)
    n, T = model.n, z.shape[-2]
    if nominal is None:
        nominal = _undisturbed(model, initial.mean, u, T)
    nominal = check.shape("nominal", check.numbers("nominal", nominal), (T, n))
    check.batches(nominal=nominal.shape[:-2], z=batch)
    if isinstance(model, LinearModel):
        return kalman_filter(model, z, initial, u, gate=gate)
    tangents, z, push = _tangents(model, z, initial.mean, u, nominal)
    track = kalman_filter(tangents, z, initial, push, gate=gate)
    return replace(track, model=model, u=u, through=AlongPath(tangents.F[..., 1:, :, :]))


def _tangents(model, z, start, u, nominal):
    """The linear model along a nominal path, its measurements and its control inputs."""
    n = model.n
    first = np.broadcast_to(start[..., None, :], (*nominal.shape[:-2], 1, n))
    before = np.concatenate([first, nominal[..., :-1, :]], axis=-2)
    moved = _finite_series("f", along(model, "f", model.move, before, u))
    if model.state_residual is not None:  # the same path, its angles written as f writes them
        nominal = moved + model.state_difference(nominal, moved)
        before = np.concatenate([first, nominal[..., :-1, :]], axis=-2)
    expected = _finite_series("h", along(model, "h", model.measure, nominal, u))
    F = np.broadcast_to(along(model, "F_jacobian", model.move_slope, before, u, -3), (*before.shape, n))
    H = along(model, "H_jacobian", model.measure_slope, nominal, u, -3)
    H = np.broadcast_to(H, (*nominal.shape[:-1], model.m, n))
    # f(x) ≈ F x + what F does not explain at the nominal state, which acts like a control input; h alike.
    push = moved - np.matvec(F, before)
    z = watched(model, "h", nominal, u, None)(z, expected) + np.matvec(H, nominal)
    return LinearModel(F, H, model.Q, model.R, np.eye(n)), z, push


def _undisturbed(model, x, u, T):
    """The states that follow x without noise, (..., T, n)."""
    path = []
    for k in range(T):
        x = model.move(x, at_step(u, k), k)
        path.append(x)
    return _finite_series("f", np.stack(path, axis=-2))


def _finite_series(name, values):
    """What a function returned for all steps (..., T, ·), which has to be finite."""
    odd = ~np.isfinite(values)
    if odd.any():
        k = int(np.argmax(odd.any(axis=(*range(odd.ndim - 2), -1))))
        raise ValueError(f"{name} must return finite numbers, found {values[odd][0]} at step {k}")
    return values


def gaussian_filter(model, z, initial, u, through, gate=None) -> Track:
    """The loop for models whose covariances depend on the data: predict, correct, predict, correct …"""
    check_model(model)
    z, u, batch = check_series(model, z, initial, u)
    belief, limits, steps = starting_belief(initial, batch), gate_limits(gate, model.m), []
    for k in range(z.shape[-2]):
        push = at_step(u, k)
        predicted = predicted_belief(model, belief, push, k, through)
        belief, *parts = corrected_belief(model, predicted, z[..., k, :], k, through, push, limits)
        steps.append((predicted, belief, *parts))
    predicted, filtered, innovation, gains, refused = zip(*steps, strict=True)
    later, refused = StackedSteps(predicted, innovation), None if limits is None else np.stack(refused, -1)
    return Track(stack_in_time(filtered), np.stack(gains, -3), model, later, u, through, refused)
