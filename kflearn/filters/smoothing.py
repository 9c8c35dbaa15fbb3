"""The Rauch–Tung–Striebel smoother: the belief about a moment given all measurements, before and after it."""

from functools import partial

import numpy as np

from ..core.matrices import compact, congruence, root, symmetric
from ..core.recursion import linear_recursion, matvec_each_step
from ..core.walk import same_covariance, walk
from ..models.arguments import check_model, check_stacks
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.state_space import LinearModel
from ..results.track import Filtered, LinearSteps, Track, read_only
from .moments import AlongPath, Moments
from .square_root import triangular
from .steps import at_step


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
    Rauch, Tung and Striebel 1965; on roots, so that P⁻ is never inverted: Park and Kailath 1995; for sigma points
    Särkkä 2008.

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
    gain, left, index = _shared(model, track) or _of_each_step(model, track)
    P = _smoothed_covariances(gain, left, index, track.mean.shape[-2])
    return read_only(unchecked_gaussian(track.mean + _shifts(model, track, gain, index), symmetric(P)))


def _shared(model, track):
    """Gains and what is left, once for each distinct step of the filter; None where steps or runs have their own."""
    later = track._later
    if model is not track.model or not isinstance(later, LinearSteps) or later.model is not model:
        return None
    steps = later.plan.parts
    if model.F.ndim > 2 or model.Q.ndim > 2 or steps.cov.ndim > 3:
        return None
    L = root(steps.cov) if steps.root is None else steps.root
    gain, left = backward_gain(model.F @ L, L, root(model.Q))
    T, count = track.mean.shape[-2], len(left)
    index = later.plan.rows(T)
    # At the last step nothing is known of a later one: rows without gain, at which all of the covariance is left.
    last = index[..., -1:] + count
    none = np.zeros_like(gain)
    return np.concatenate([gain, none]), np.concatenate([left, steps.cov]), np.concatenate([index[..., :-1], last], -1)


def _of_each_step(model, track):
    """Gains and what is left, for each step of each run."""
    moved = _onward(model, track)
    P_next, Q = compact(track.predicted.cov, 3)[..., 1:, :, :], _from_second(model.Q)
    _check_same(model, track, moved, Q, P_next)
    L = _roots(track) if moved.basis is None else moved.basis
    slope = moved.slope @ L if moved.basis is None else moved.slope
    gain, left = backward_gain(slope, L, root(Q + moved.rest))
    last = compact(track.cov, 3)[..., -1:, :, :]
    left = np.concatenate([left, np.broadcast_to(last, (*left.shape[:-3], *last.shape[-3:]))], axis=-3)
    return np.concatenate([gain, np.zeros_like(gain[..., :1, :, :])], axis=-3), left, None


def _roots(track):
    """Roots of all covariances but the last."""
    if isinstance(track._later, LinearSteps) and track._later.plan.parts.root is not None:
        plan = track._later.plan
        return plan.each(plan.parts.root, track.mean.shape[-2])[..., :-1, :, :]
    return root(compact(track.cov, 3)[..., :-1, :, :])


def backward_gain(slope, L, noise):
    """What the next state tells of this one: the gain G (..., n, n), and the covariance that is left once it is known.

    [[F L, Q½], [L, 0]] has the same square as the triangular [[P⁻½, 0], [G P⁻½, C]], and C Cᵀ is what is left: nothing
    is inverted but a root of P⁻. slope is F L, for a belief with the root L; noise is Q½.
    """
    n = L.shape[-1]
    array = np.zeros((*np.broadcast_shapes(slope.shape[:-2], L.shape[:-2], noise.shape[:-2]), 2 * n, 2 * n))
    array[..., :n, :n], array[..., :n, n:], array[..., n:, :n] = slope, noise, L
    array = triangular(array)
    C = array[..., n:, n:]
    return _divide_by_root(array[..., n:, :n], array[..., :n, :n]), C @ C.mT


def _divide_by_root(B, A):
    """B A⁻¹ for triangular A (..., n, n), which may be singular, as when Q = 0 and something is known exactly."""
    size = np.sqrt(np.sum(A * A, axis=-1))
    size = np.where(size > 0, size, 1)
    unit = A / size[..., :, None]
    thin = abs(np.diagonal(unit, axis1=-2, axis2=-1)).min(axis=-1) < 1e-10
    found = np.linalg.solve(np.where(thin[..., None, None], np.eye(A.shape[-1]), unit).mT, B.mT).mT
    if thin.any():
        found[thin] = B[thin] @ np.linalg.pinv(unit[thin], rcond=1e-13)
    return found / size[..., None, :]


def _smoothed_covariances(gain, left, index, T):
    """P_k = what is left + G_k P_{k+1} G_kᵀ, backwards: (..., T, n, n)."""
    if index is None:
        P = left.copy()
        for k in range(T - 2, -1, -1):
            P[..., k, :, :] += congruence(gain[..., k, :, :], P[..., k + 1, :, :])[0]
        return P

    def step(P, row):
        P = left[row] + congruence(gain[row], P)[0]
        return P, (P,)

    plan = walk(index[..., ::-1], np.zeros_like(left[0]), step, same_covariance)
    return plan.each(plan.parts[0], T)[..., ::-1, :, :]


def _shifts(model, track, gain, index):
    """By how much means change: d_k = G_k (d_{k+1} + x̂_{k+1} − x⁻_{k+1}), backwards, with G = 0 at the last step."""
    learnt = model.state_difference(track.mean, track.predicted.mean)
    ahead = np.concatenate([learnt[..., 1:, :], np.zeros_like(learnt[..., :1, :])], axis=-2)
    drive = matvec_each_step(gain, ahead, index)[..., ::-1, :]
    back = None if index is None else index[..., ::-1]
    gain = gain[..., ::-1, :, :] if index is None else gain
    return linear_recursion(gain, drive, np.zeros(track.mean.shape[-1]), back)[..., ::-1, :]


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
    """How each belief but the last moves on before Q is added: Moments (..., T−1, ·)."""
    now = unchecked_gaussian(track.mean[..., :-1, :], compact(track.cov, 3)[..., :-1, :, :])
    if isinstance(model, LinearModel):
        F = _from_second(model.F)
        return Moments(None, *congruence(F, now.cov), F)
    u = None if track.u is None else track.u[..., 1:, :]
    try:
        if model.by_steps("f", "F_jacobian") and not isinstance(track.through, AlongPath):
            return _step_by_step(model, now, u, track.through)
        moves = lambda x: model.move(x, u), lambda x: model.move_slope(x, u)
        return track.through(now, *moves, model.state_difference)
    except (ValueError, TypeError, IndexError) as error:
        reason = str(error).split(". ")[0]
        raise ValueError(f"f {_ONE_BY_ONE}, got an error from all steps at once: {reason}") from error


def _step_by_step(model, now, u, through):
    """What _onward returns, for a function that changes from step to step: the first move is that to step 1."""
    steps = []
    for k in range(now.mean.shape[-2]):
        belief, push = unchecked_gaussian(now.mean[..., k, :], now.cov[..., k, :, :]), at_step(u, k)
        moves = partial(model.move, u=push, k=k + 1), partial(model.move_slope, u=push, k=k + 1)
        steps.append(through(belief, *moves, model.state_difference))
    mean, *matrices = zip(*steps, strict=True)
    alone = (parts[0] is None or np.ndim(parts[0]) == 0 for parts in matrices)  # no basis, no rest
    matrices = (parts[0] if lone else np.stack(parts, -3) for parts, lone in zip(matrices, alone, strict=True))
    return Moments(np.stack(mean, -2), *matrices)


_ONE_BY_ONE = "must treat every state alone, whatever axes stand before the last (write x[..., 0], not x[0] or x.T)"


def _check_same(model, track, moved, Q, P_next):
    """The model has to predict what the filter predicted: judged at each step, in units of its standard deviations."""
    std = np.sqrt(np.diagonal(P_next, axis1=-2, axis2=-1))
    largest = np.max(abs(P_next), axis=(-2, -1), keepdims=True)
    allowed = 1e-6 * std[..., :, None] * std[..., None, :] + 1e-12 * largest
    same = (abs(moved.cov + Q - P_next) <= allowed).all()
    if same and moved.mean is not None:
        mean = track.predicted.mean[..., 1:, :]
        largest = np.max(abs(mean), axis=-2, keepdims=True)
        same = (abs(model.state_difference(moved.mean, mean)) <= 1e-6 * std + 1e-9 * largest).all()
    if same:
        return
    if model is track.model:
        raise ValueError(f"f {_ONE_BY_ONE}: all steps at once give other predictions than one after the other")
    raise ValueError("model must be the one the track was filtered with: it predicts other covariances or means")


def _from_second(stack):
    """The matrices of all steps but the first."""
    return stack[..., 1:, :, :] if stack.ndim > 2 and stack.shape[-3] > 1 else stack
