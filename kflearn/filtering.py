"""Predict, correct, and the one loop over a series.

`correct` is Gaussian conditioning: K = C S⁻¹ with the cross-covariance C of state and measurement. For a linear model
C = P⁻Hᵀ and these are eqs (5)–(9). Kalman, extended, unscented, cubature and linearised filters differ only in
`through`, the way a Gaussian is pushed through a function (see `moments`).

Start convention, everywhere: `initial` is the belief one step BEFORE the first measurement. Every step predicts, then
corrects (FilterPy does the same; pykalman, statsmodels and dynamax hold it at the first measurement).
"""

from dataclasses import replace

import numpy as np

from . import _checks as check
from .arguments import check_belief, check_control, check_measure, check_model, check_move, check_series, check_step
from .conditioning import covariance_after, divide, without
from .gaussian import Gaussian, symmetric, tidy, trusted
from .linear import covariance_step, linear_filter
from .models import LinearModel, apply, at
from .moments import Moments, cubature, linearize, spread, unscented
from .results import Track


def predict(model, belief, u=None, k=0, through=linearize):
    """The belief one step later, before its measurement: eqs (5) and (6).

    belief: Gaussian with mean (..., n); u: control input (p,) or (..., p), or a number when p = 1; k: the step, for
    time-varying models. Returns a Gaussian. Raises ValueError or TypeError where the pieces do not fit.
    """
    check_model(model)
    check_belief("belief", belief, model)
    axes = check_step(model, k)
    if u is not None:
        u = np.atleast_1d(check.numbers("u", u))
        check_control(model, u)
        axes["u"] = u.shape[:-1]
    belief = _stretch(belief, check.batches(belief=belief.batch, **axes))
    check_move(model, belief.mean, u)
    return tidy(_predict(model, belief, u, k, through))


def correct(model, belief, z, k=0, through=linearize):
    """The predicted belief after the measurement z: eqs (7)–(9).

    z: (m,) or (..., m), or a number when m = 1; NaN marks components that were not measured. Returns a Gaussian.
    Raises ValueError or TypeError where the pieces do not fit.
    """
    check_model(model)
    check_belief("belief", belief, model)
    axes = check_step(model, k)
    z = check.shape("z", np.atleast_1d(check.numbers("z", z, gaps=True)), (model.m,))
    belief = _stretch(belief, check.batches(belief=belief.batch, z=z.shape[:-1], **axes))
    check_measure(model, belief.mean)
    return tidy(_correct(model, belief, z, k, through)[0])


def kalman_filter(model, z, initial, u=None):
    """The Kalman filter over a series, or over many series at once: eqs (5)–(9).

    model: LinearModel. z: (..., T, m), or (T,) when m = 1; NaN = that component was not measured.
    initial: Gaussian, the belief one step before the first measurement.
    u: control input (..., T, p), or (T,) when p = 1; u[k] acts on the way to z[k].
    Returns a Track. Raises ValueError or TypeError, naming the argument, before anything is computed.
    """
    return linear_filter(model, z, initial, u, covariance_step)


def extended_kalman_filter(model, z, initial, u=None):
    """The extended Kalman filter: every function is replaced by its tangent at the latest estimate.

    model: NonlinearModel (Jacobians given or by differences) or LinearModel. Arguments and result as in kalman_filter,
    but covariances and gains depend on the data and carry the batch axes. Source: Bar-Shalom et al. 2001, ch. 10.3.
    """
    return gaussian_filter(model, z, initial, u, linearize)


def unscented_kalman_filter(model, z, initial, u=None, alpha=1.0, beta=2.0, kappa=0.0):
    """The unscented Kalman filter, sigma points redrawn after Q was added. Source: Wan and van der Merwe 2000.

    Arguments and result as in extended_kalman_filter. With n states λ = α²(n + κ) − n.
    """
    check_model(model)
    return gaussian_filter(model, z, initial, u, unscented(model.n, alpha, beta, kappa))


def cubature_kalman_filter(model, z, initial, u=None):
    """The cubature Kalman filter, points redrawn after Q was added. Source: Arasaratnam and Haykin 2009.

    Arguments and result as in extended_kalman_filter.
    """
    check_model(model)
    return gaussian_filter(model, z, initial, u, cubature(model.n))


def linearized_kalman_filter(model, z, initial, u=None, nominal=None):
    """The linearised Kalman filter: every function is replaced by its tangent along a path fixed beforehand.

    nominal: states (..., T, n), the path at each measurement; without it, the path that initial.mean takes if nothing
    disturbs it. Other arguments and result as in extended_kalman_filter, but gains and covariances do not depend on
    the data. The first move is linearised at initial.mean. Source: Maybeck 1982, ch. 9.5.
    """
    check_model(model)
    z, u, batch = check_series(model, z, initial, u)
    n, T = model.n, z.shape[-2]
    if nominal is None:
        nominal = _undisturbed(model, initial.mean, u, T)
    nominal = check.shape("nominal", check.numbers("nominal", nominal), (T, n))
    check.batches(nominal=nominal.shape[:-2], z=batch)
    if isinstance(model, LinearModel):
        return kalman_filter(model, z, initial, u)
    first = np.broadcast_to(initial.mean[..., None, :], (*nominal.shape[:-2], 1, n))
    before = np.concatenate([first, nominal[..., :-1, :]], axis=-2)
    F = np.broadcast_to(model.move_slope(before, u), (*before.shape, n))
    H = np.broadcast_to(model.measure_slope(nominal), (*nominal.shape[:-1], model.m, n))
    # f(x) ≈ F x + what F does not explain at the nominal state, which acts like a control input; h alike.
    push = model.move(before, u) - np.matvec(F, before)
    z = model.difference(z, model.measure(nominal)) + np.matvec(H, nominal)
    track = kalman_filter(LinearModel(F, H, model.Q, model.R, np.eye(n)), z, initial, push)
    later = F[..., 1:, :, :]
    return replace(track, through=lambda now, function, slope: Moments(None, *spread(later, now.cov), later))


def _undisturbed(model, x, u, T):
    """The states that follow x without noise, (..., T, n)."""
    path = []
    for k in range(T):
        x = model.move(x, None if u is None else u[..., k, :], k)
        path.append(x)
    return np.stack(path, axis=-2)


def kalman_step(z, R, x=None, P=None, F=None, H=None, Q=None, B=None, u=None):
    """One step with defaults, as the published `kalmanf` meant it.

    z (m,), R (m, m) are needed; F and H default to the identity, Q to zero. Without x and P the filter starts itself
    from the measurement: x = H⁻¹ z, P = H⁻¹ R H⁻ᵀ, and nothing is predicted. Returns the Gaussian after the step.
    Raises ValueError when the start is known only in part (x without P, NaN in x), or when H cannot be inverted.
    """
    z = np.atleast_1d(check.numbers("z", z, gaps=True))
    H = np.eye(z.shape[-1]) if H is None else check.matrix("H", H, z.shape[-1], None)
    n = H.shape[-1]
    model = LinearModel(np.eye(n) if F is None else F, H, np.zeros((n, n)) if Q is None else Q, R, B)
    if x is None and P is None:
        return start_from(model, z)
    if x is None or P is None:
        missing, given = ("x", "P") if x is None else ("P", "x")
        raise ValueError(f"{missing} must be given together with {given}: give both, or neither to start from z")
    x = check.shape("x", np.atleast_1d(check.numbers("x", x, gaps=True)), (n,))
    if np.isnan(x).any():
        raise ValueError("x must be known completely, found NaN: leave out x and P to start from z")
    return correct(model, predict(model, Gaussian(x, check.covariance("P", P, n)), u), z)


def start_from(model, z):
    """The belief that one measurement alone gives, x = H⁻¹ z and P = H⁻¹ R H⁻ᵀ: a start when nothing else is known.

    model: LinearModel with an invertible H; z: (..., m), or a number when m = 1. Raises ValueError when H is not square
    or is singular.
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    H, R = at(model.H, 0), at(model.R, 0)
    z = check.shape("z", np.atleast_1d(check.numbers("z", z)), (model.m,))
    if model.m != model.n or not _invertible(H):
        raise ValueError(f"H of shape {H.shape} must be invertible to start from z: not every state is measured")
    half = np.linalg.solve(H, R)
    return Gaussian(np.linalg.solve(H, z[..., None])[..., 0], symmetric(np.linalg.solve(H, half.mT)))


def _invertible(H):
    """Has a square matrix, or each of a stack, full rank in whatever units? Rows and columns are brought to size 1."""
    for axis in (-1, -2):
        size = abs(H).max(axis=axis, keepdims=True)
        H = H / np.where(size > 0, size, 1)
    return (np.linalg.matrix_rank(H) == H.shape[-1]).all()


def gaussian_filter(model, z, initial, u, through):
    """The loop for models whose covariances depend on the data: predict, correct, predict, correct …"""
    check_model(model)
    z, u, batch = check_series(model, z, initial, u)
    n, T = model.n, z.shape[-2]
    belief = trusted(np.broadcast_to(initial.mean, (*batch, n)), np.broadcast_to(initial.cov, (*batch, n, n)))
    steps = []
    for k in range(T):
        predicted = _predict(model, belief, None if u is None else u[..., k, :], k, through)
        belief, gain, innovation = _correct(model, predicted, z[..., k, :], k, through)
        steps.append((predicted, belief, innovation, gain))
    predicted, filtered, innovation, gains = zip(*steps, strict=True)
    return Track(along(filtered), np.stack(gains, -3), lambda: along(predicted), lambda: along(innovation), u, through)


def _predict(model, belief, u, k, through, Q=None):
    moved = through(belief, lambda x: model.move(x, u, k), lambda x: model.move_slope(x, u, k))
    return trusted(moved.mean, symmetric(moved.cov + (at(model.Q, k) if Q is None else Q)))


def _correct(model, predicted, z, k, through):
    expected, innovation = expect(model, predicted, z, k, through)
    return condition(predicted, expected, innovation, at(model.R, k))


def expect(model, predicted, z, k, through):
    """What the measurement should be, Moments without its noise, and the innovation z − ẑ."""
    expected = through(predicted, lambda x: model.measure(x, k), lambda x: model.measure_slope(x, k), model.difference)
    return expected, model.difference(z, expected.mean)


def condition(predicted, expected, innovation, R):
    """Gaussian conditioning on the measurement: the belief after it, the gain, the innovation with its covariance."""
    full = S = expected.cov + R
    cross, y, missing = expected.cross, innovation, np.isnan(innovation)
    if missing.any():
        S, cross = without(missing, S, cross)
        y = np.where(missing, 0, y)
    gain = divide(cross, S)
    P = covariance_after(gain, predicted.cov, expected.slope, R + expected.rest, expected.basis)
    return trusted(predicted.mean + apply(gain, y), P), gain, trusted(innovation, full)


def _stretch(belief, batch):
    """The same belief with a mean for every run."""
    return trusted(np.broadcast_to(belief.mean, (*batch, belief.mean.shape[-1])), belief.cov)


def along(beliefs):
    """Gaussians of single steps as one Gaussian along time."""
    return trusted(np.stack([b.mean for b in beliefs], -2), np.stack([b.cov for b in beliefs], -3))
