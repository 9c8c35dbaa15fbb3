"""Smoothers: the belief about a moment given all measurements, those before it and those after it."""

import numpy as np

from .arguments import check_model, check_series, check_stacks
from .conditioning import covariance_after, divide, divide_safely, hide
from .filtering import kalman_filter
from .gaussian import root, symmetric, trusted
from .linear import each, shared
from .models import LinearModel, at
from .moments import Moments, spread
from .recursion import linear_recursion
from .results import Track, settled


def rts_smoother(model, track):
    """What the filter would have believed at each step, had it known the later measurements too.

    model: the model the track was filtered with; track: what kalman_filter, square_root_kalman_filter or one of the
    extended, unscented, cubature and linearised filters returned (the smoother goes through the model the same way).
    Returns a Gaussian with mean (..., T, n) and cov (..., T, n, n), which equals the filter's at the last step.
    Raises TypeError or ValueError where model and track do not belong together, or the filter cannot be smoothed.
    Source: Rauch, Tung and Striebel 1965; for sigma points Särkkä 2008.
    """
    _check_track(model, track)
    if track.mean.shape[-2] == 1:
        return track.filtered
    moved, P_next = _onward(model, track), track.predicted.cov[..., 1:, :, :]
    Q = _from_second(model.Q)
    if not np.allclose(moved.cov + Q, P_next, rtol=1e-6, atol=1e-6 * np.max(abs(P_next), initial=0)):
        raise ValueError("model must be the one the track was filtered with: it predicts other covariances")
    gain = divide_safely(moved.cross, P_next)
    # Joseph's form once more: what is left of P when the next state is known with the covariance that comes later.
    now = track.cov[..., :-1, :, :]
    left = covariance_after(gain, now, moved.slope, Q + moved.rest, moved.basis)
    P = np.broadcast_to(track.cov, (*left.shape[:-3], *track.cov.shape[-3:])).copy()
    for k in range(P.shape[-3] - 2, -1, -1):
        P[..., k, :, :] = left[..., k, :, :] + spread(gain[..., k, :, :], P[..., k + 1, :, :])[0]
    # x_k = G_k x_{k+1} + (x̂_k − G_k x⁻_{k+1}), backwards from the last, where G = 0.
    drive = track.mean.copy(order="K")
    drive[..., :-1, :] -= each(gain, track.predicted.mean[..., 1:, :])
    gain = np.concatenate([gain, np.zeros_like(gain[..., :1, :, :])], axis=-3)[..., ::-1, :, :]
    mean = linear_recursion(gain, drive[..., ::-1, :], np.zeros(model.n))[..., ::-1, :]
    return settled(trusted(mean, symmetric(P)))


def two_filter_smoother(model, z, initial, u=None):
    """The same beliefs from two filters, one running forwards and one backwards, fused at every step.

    Arguments as in kalman_filter; returns a Gaussian like rts_smoother, with equal numbers. The backward filter knows
    nothing at the end of the series and so carries information, Y = P⁻¹ and y = P⁻¹x. At step k the forward filter has
    used z_k and the backward one has not: each measurement counts once. Raises ValueError where one knows so much more
    than the other that their sum is singular. Source: Fraser and Potter 1969.
    """
    forward = kalman_filter(model, z, initial, u)
    z, u, _ = check_series(model, z, initial, u)
    Y, y = _information_ahead(model, z, u)
    # P₊ = (P⁻¹ + Y)⁻¹ = L (I + LᵀYL)⁻¹ Lᵀ with P = L Lᵀ, so that neither P nor Y need have an inverse.
    L = root(forward.cov)
    try:
        P = L @ np.linalg.solve(np.eye(model.n) + L.mT @ Y @ L, L.mT)
    except np.linalg.LinAlgError:
        raise ValueError(
            "Q must be smaller beside R: the two filters are 1e16 times apart and cannot be fused"
        ) from None
    return settled(trusted(forward.mean + each(P, y - each(Y, forward.mean)), symmetric(P)))


def _information_ahead(model, z, u):
    """What the measurements after each step say about its state: Y (..., T, n, n) and y (..., T, n), 0 at the last."""
    n, missing = model.n, np.isnan(z)
    gaps = shared(missing)
    H, R = (model.H, model.R) if gaps is None else (model.H * ~gaps[..., :, None], hide(model.R, gaps))
    weights = np.linalg.solve(R, H).mT  # HᵀR⁻¹
    learnt = weights @ H
    ahead, Y, steps = np.zeros((n, n)), [], []
    for k in range(z.shape[-2] - 1, -1, -1):
        F, G = at(model.F, k), root(at(model.Q, k))
        with_z = ahead + at(learnt, k)
        # Backwards through x' = F x + G w: a correction again, with Gᵀ in the place of H and I in the place of R.
        gain = divide(with_z @ G, spread(G.mT, with_z)[0] + np.eye(n))
        Y.append(ahead)
        steps.append((with_z, F.mT @ (np.eye(n) - gain @ G.mT)))
        ahead = symmetric(spread(F.mT, covariance_after(gain, with_z, G.mT, np.eye(n)))[0])
    with_z, back = (_along(matrices) for matrices in zip(*steps, strict=True))
    told = each(weights, np.where(missing, 0, z))[..., ::-1, :]
    if u is not None:
        told = told - each(with_z, each(model.B, u)[..., ::-1, :])
    y = linear_recursion(back, each(back, told), np.zeros(n))[..., -2::-1, :]
    last = np.zeros((*y.shape[:-2], 1, n))
    return _along(Y)[..., ::-1, :, :], np.concatenate([y, last], axis=-2)


def _along(matrices):
    return np.stack(np.broadcast_arrays(*matrices), axis=-3)


def _check_track(model, track):
    check_model(model)
    if not isinstance(track, Track):
        raise TypeError(f"track must be what a filter returns, got {type(track).__name__}")
    if track.through is None:
        raise ValueError("track must come from a filter that carries all it knows: this one cannot be smoothed")
    n, T = track.mean.shape[-1], track.mean.shape[-2]
    if model.n != n:
        raise ValueError(f"model must have {n} states like the track, got {model.n}")
    check_stacks(model, T)


def _onward(model, track):
    """How each belief but the last moves on, before Q is added: Moments (..., T−1, ·)."""
    now = trusted(track.mean[..., :-1, :], track.cov[..., :-1, :, :])
    if isinstance(model, LinearModel):
        F = _from_second(model.F)
        return Moments(None, *spread(F, now.cov), F)
    u = None if track.u is None else track.u[..., 1:, :]
    return track.through(now, lambda x: model.move(x, u), lambda x: model.move_slope(x, u))


def _from_second(stack):
    """The matrices of all steps but the first."""
    return stack[..., 1:, :, :] if stack.ndim > 2 and stack.shape[-3] > 1 else stack
