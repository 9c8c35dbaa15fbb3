"""Smoothers: the belief about a moment given all measurements, those before it and those after it."""

import numpy as np

from ..core.conditioning import covariance_after, decouple_missing, divide, divide_safely
from ..core.matrices import compact, congruence, root, step_matrix, symmetric
from ..core.recursion import linear_recursion, matvec_each_step
from ..models.arguments import check_model, check_series, check_stacks
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.state_space import LinearModel
from ..results.track import Filtered, Track, read_only
from .kalman import kalman_filter
from .linear import common_gaps
from .moments import Moments


def rts_smoother(model, track) -> Gaussian:
    """What the filter would have believed at each step, had it known the later measurements too.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        The model the track was filtered with, e.g. track.model.
    track : Track
        From kalman_filter, square_root_kalman_filter or one of the extended, unscented, cubature and linearised
        filters; the smoother goes through the model the same way.

    Returns
    -------
    Gaussian
        Mean (..., T, n) and cov (..., T, n, n), read-only. It equals the filter's at the last step.

    Raises
    ------
    ValueError, TypeError
        Where model and track do not belong together, the filter cannot be smoothed, or f mixes states.

    References
    ----------
    Rauch, Tung and Striebel 1965; for sigma points Särkkä 2008.

    Examples
    --------
    >>> from kflearn import Gaussian, kalman_filter, random_walk, rts_smoother
    >>> model = random_walk(1, 1)
    >>> smooth = rts_smoother(model, kalman_filter(model, [1.0, 2.0, 3.0], Gaussian(0, 1)))
    >>> print(f"first step: {smooth.mean[0, 0]:.3f} ± {smooth.std[0, 0]:.3f}")
    first step: 1.143 ± 0.690
    """
    _check_track(model, track)
    if track.mean.shape[-2] == 1:
        return track.filtered
    now, moved = _onward(model, track)
    P_next, Q = compact(track.predicted.cov, 3)[..., 1:, :, :], _from_second(model.Q)
    _check_same(model, track, moved, Q, P_next)
    gain = divide_safely(moved.cross, P_next)
    # Joseph form: the covariance of x_k given x_{k+1}; the smoothed covariance of x_{k+1} is added in the loop.
    left = covariance_after(gain, now.cov, moved.slope, Q + moved.rest, moved.basis)
    filtered_cov = compact(track.cov, 3)
    P = np.broadcast_to(filtered_cov, (*left.shape[:-3], *filtered_cov.shape[-3:])).copy()
    for k in range(P.shape[-3] - 2, -1, -1):
        P[..., k, :, :] = left[..., k, :, :] + congruence(gain[..., k, :, :], P[..., k + 1, :, :])[0]
    return read_only(unchecked_gaussian(_smoothed_means(track, gain), symmetric(P)))


def _smoothed_means(track, gain):
    """x_k = G_k x_{k+1} + (x̂_k − G_k x⁻_{k+1}), backwards from the last, where G = 0."""
    drive = track.mean.copy(order="K")
    drive[..., :-1, :] -= matvec_each_step(gain, track.predicted.mean[..., 1:, :])
    gain = np.concatenate([gain, np.zeros_like(gain[..., :1, :, :])], axis=-3)[..., ::-1, :, :]
    return linear_recursion(gain, drive[..., ::-1, :], np.zeros(track.mean.shape[-1]))[..., ::-1, :]


def two_filter_smoother(model, z, initial, u=None) -> Gaussian:
    """The smoothed beliefs from two filters, one running forwards and one backwards, fused at every step.

    The backward filter knows nothing at the end of the series and so carries information, Y = P⁻¹ and y = P⁻¹x. At step
    k the forward filter has used z_k and the backward one has not: each measurement counts once.

    Parameters
    ----------
    model, z, initial, u
        As in kalman_filter.

    Returns
    -------
    Gaussian
        Like that of rts_smoother, equal to it but for rounding.

    Raises
    ------
    ValueError, TypeError
        As in kalman_filter, and where one filter knows so much more than the other that they cannot be fused.

    References
    ----------
    Fraser and Potter 1969.

    Examples
    --------
    >>> from kflearn import Gaussian, random_walk, two_filter_smoother
    >>> smooth = two_filter_smoother(random_walk(1, 1), [1.0, 2.0, 3.0], Gaussian(0, 1))
    >>> print(f"first step: {smooth.mean[0, 0]:.3f} ± {smooth.std[0, 0]:.3f}")
    first step: 1.143 ± 0.690
    """
    forward = kalman_filter(model, z, initial, u)
    z, u, _ = check_series(model, z, initial, u)
    try:
        with np.errstate(all="ignore"):
            mean, P = _fused(model, forward, z, u)
    except np.linalg.LinAlgError:
        mean = P = np.array(np.nan)
    if not (np.isfinite(mean).all() and np.isfinite(P).all()):
        raise ValueError("Q must be smaller beside R: the two filters are 1e16 times apart and cannot be fused")
    return read_only(unchecked_gaussian(mean, P))


def _fused(model, forward, z, u):
    """Means and covariances given what the forward filter and the measurements ahead say."""
    Y, y = _information_ahead(model, z, u)
    # P₊ = (P⁻¹ + Y)⁻¹ = L (I + LᵀYL)⁻¹ Lᵀ with P = L Lᵀ, so that neither P nor Y need have an inverse.
    L = root(compact(forward.cov, 3))
    P = L @ np.linalg.solve(np.eye(model.n) + L.mT @ Y @ L, L.mT)
    return forward.mean + matvec_each_step(P, y - matvec_each_step(Y, forward.mean)), symmetric(P)


def _information_ahead(model, z, u):
    """What the measurements after each step say about its state: Y (..., T, n, n) and y (..., T, n), 0 at the last."""
    n, missing = model.n, np.isnan(z)
    gaps = common_gaps(missing)
    H, R = (model.H, model.R) if gaps is None else (model.H * ~gaps[..., :, None], decouple_missing(model.R, gaps))
    weights = np.linalg.solve(R, H).mT  # HᵀR⁻¹
    learnt = weights @ H
    ahead, Y, steps = np.zeros((n, n)), [], []
    for k in range(z.shape[-2] - 1, -1, -1):
        F, G = step_matrix(model.F, k), root(step_matrix(model.Q, k))
        with_z = ahead + step_matrix(learnt, k)
        # Backwards through x' = F x + G w: a correction again, with Gᵀ in the place of H and I in the place of R.
        gain = divide(with_z @ G, congruence(G.mT, with_z)[0] + np.eye(n))
        Y.append(ahead)
        steps.append((with_z, F.mT @ (np.eye(n) - gain @ G.mT)))
        ahead = symmetric(congruence(F.mT, covariance_after(gain, with_z, G.mT, np.eye(n)))[0])
    with_z, back = (_stacked(matrices) for matrices in zip(*steps, strict=True))
    told = matvec_each_step(weights, np.where(missing, 0, z))[..., ::-1, :]
    if u is not None:
        told = told - matvec_each_step(with_z, matvec_each_step(model.B, u)[..., ::-1, :])
    y = linear_recursion(back, matvec_each_step(back, told), np.zeros(n))[..., -2::-1, :]
    last = np.zeros((*y.shape[:-2], 1, n))
    return _stacked(Y)[..., ::-1, :, :], np.concatenate([y, last], axis=-2)


def _stacked(matrices):
    """Matrices of single steps along time."""
    return np.stack(np.broadcast_arrays(*matrices), axis=-3)


def _check_track(model, track):
    check_model(model)
    if isinstance(track, Filtered) and not isinstance(track, Track):
        raise TypeError("track comes from imm_filter or mmae_filter, which cannot be smoothed: it has no single model")
    if not isinstance(track, Track):
        raise TypeError(f"track must be what a filter returns, got {type(track).__name__}")
    if track.through is None:
        raise ValueError(
            "track comes from schmidt_kalman_filter or adaptive_kalman_filter, which cannot be smoothed; smooth a "
            "kalman_filter track instead"
        )
    n, T = track.mean.shape[-1], track.mean.shape[-2]
    if model.n != n:
        raise ValueError(f"model must have {n} states like the track, got {model.n}")
    check_stacks(model, T)


def _onward(model, track):
    """Each belief but the last, and how it moves on before Q is added: Moments (..., T−1, ·)."""
    now = unchecked_gaussian(track.mean[..., :-1, :], compact(track.cov, 3)[..., :-1, :, :])
    if isinstance(model, LinearModel):
        F = _from_second(model.F)
        return now, Moments(None, *congruence(F, now.cov), F)
    u = None if track.u is None else track.u[..., 1:, :]
    try:
        return now, track.through(now, lambda x: model.move(x, u), lambda x: model.move_slope(x, u))
    except (ValueError, TypeError, IndexError) as error:
        reason = str(error).split(". ")[0]
        raise ValueError(f"f {_ONE_BY_ONE}, got an error from all steps at once: {reason}") from error


_ONE_BY_ONE = "must treat every state alone, whatever axes stand before the last (write x[..., 0], not x[0] or x.T)"


def _check_same(model, track, moved, Q, P_next):
    """The model has to predict what the filter predicted."""
    same = np.allclose(moved.cov + Q, P_next, rtol=1e-6, atol=1e-6 * np.max(abs(P_next), initial=0))
    if same and moved.mean is not None:
        mean = track.predicted.mean[..., 1:, :]
        same = np.allclose(moved.mean, mean, rtol=1e-6, atol=1e-6 * np.max(abs(mean), initial=0))
    if same:
        return
    if model is track.model:
        raise ValueError(f"f {_ONE_BY_ONE}: all steps at once give other predictions than one after the other")
    raise ValueError("model must be the one the track was filtered with: it predicts other covariances or means")


def _from_second(stack):
    """The matrices of all steps but the first."""
    return stack[..., 1:, :, :] if stack.ndim > 2 and stack.shape[-3] > 1 else stack
