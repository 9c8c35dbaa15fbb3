"""The Rauch–Tung–Striebel smoother: the belief about a moment given all measurements, before and after it."""

from functools import partial

import numpy as np

from ..core.matrices import compact, congruence, root, with_batch
from ..core.recursion import linear_recursion, matvec_each_step
from ..core.walk import same_root, walk
from ..models.arguments import check_model, check_stacks
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.state_space import LinearModel
from ..results.track import Filtered, LinearSteps, Track, read_only
from .linear import plan_steps
from .moments import AlongPath, Moments
from .square_root import square_root_step, triangular
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
        Mean (..., T, n) and cov (..., T, n, n), read-only. It equals the filter's at the last step. After filters of
        nonlinear models, which carry covariances and not their roots, its digits are lost where a start says that some
        combination of uncertain states is known exactly.

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
    return smoothed(model, track)[0]


def lag_one_covariances(model, track) -> np.ndarray:
    """The covariance of each smoothed state with the one before, Cov(x_k, x_{k−1}) given all readings: P_k G_{k−1}ᵀ.

    Parameters
    ----------
    model, track
        As in rts_smoother, of T steps.

    Returns
    -------
    ndarray (..., T − 1, n, n)
        Entry k is that of the steps k + 1 and k, in products of the states' units.

    Raises
    ------
    ValueError, TypeError
        As rts_smoother.

    References
    ----------
    Shumway and Stoffer 1982; de Jong 1989.

    Examples
    --------
    >>> from kflearn import Gaussian, kalman_filter, lag_one_covariances, random_walk
    >>> model = random_walk(1, 1)
    >>> lag = lag_one_covariances(model, kalman_filter(model, [1.0, 2.0, 3.0], Gaussian(0, 1)))
    >>> print(f"{lag[0, 0, 0]:.4f}")
    0.1905
    """
    return with_lag(*smoothed(model, track))[1]


def with_lag(belief, gain, index) -> tuple[Gaussian, np.ndarray]:
    """What `smoothed` returns as smoothed beliefs, and the covariance of each with the one before."""
    *batch, T, _ = belief.mean.shape
    gain = gain if index is None else gain[index]
    lag = compact(belief.cov, 3)[..., 1:, :, :] @ gain[..., : T - 1, :, :].mT
    return belief, with_batch(lag, (*batch, T - 1))


def smoothed(model, track):
    """The smoothed beliefs, and the distinct gains with the index of the steps that have them; None: one each."""
    _check_track(model, track)
    if track.mean.shape[-2] == 1:
        return track.filtered, np.zeros((1, model.n, model.n)), None
    gain, left, index = _shared(model, track) or _of_each_step(model, track)
    mean = track.mean + _shifts(track, gain, index)
    cov = _smoothed_covariances(gain, left, index, track.mean.shape[-2])
    return read_only(unchecked_gaussian(mean, cov)), gain, index


def _shared(model, track):
    """Gains and what is left, once for each distinct step of the filter; None where steps or runs have their own."""
    later = track._later
    if model is not track.model or not isinstance(later, LinearSteps) or later.model is not model:
        return None
    if model.F.ndim > 2 or model.Q.ndim > 2 or later.plan.parts.cov.ndim > 3:
        return None
    plan, noise, largest = later.plan, root(model.Q), _largest(later.plan.parts.predicted)
    L = root(plan.parts.cov) if plan.parts.root is None else plan.parts.root
    gain, left, thin = backward_gain(model.F @ L, L, noise, largest)
    if (
        thin and plan.parts.root is None
    ):  # roots of rounded covariances will not do: let roots be carried from the start
        unused = np.isnan(later.z) | track.refused[..., None]
        plan = plan_steps(model, later.start.cov, unused, square_root_step, root, same_root)
        L = plan.parts.root
        gain, left, _ = backward_gain(model.F @ L, L, noise, largest)
    # At the last step nothing is known of a later one: rows without gain, at which all of the covariance is left.
    index = plan.rows(track.mean.shape[-2])
    index = np.concatenate([index[..., :-1], index[..., -1:] + len(left)], axis=-1)
    return np.concatenate([gain, np.zeros_like(gain)]), np.concatenate([left, L]), index


def _of_each_step(model, track):
    """Gains and what is left, for each step of each run."""
    moved = _onward(model, track)
    P_next, Q = compact(track.predicted.cov, 3)[..., 1:, :, :], _from_second(model.Q)
    _check_same(model, track, moved, Q, P_next)
    L = _roots(track)
    before = L[..., :-1, :, :] if moved.basis is None else moved.basis
    slope = moved.slope @ before if moved.basis is None else moved.slope
    gain, left, _ = backward_gain(slope, before, root(Q + moved.rest), _largest(P_next))
    last = np.broadcast_to(L[..., -1:, :, :], (*left.shape[:-3], 1, *left.shape[-2:]))
    return np.concatenate([gain, np.zeros_like(gain[..., :1, :, :])], axis=-3), np.concatenate([left, last], -3), None


def _roots(track):
    """Roots of the covariances at each step."""
    if isinstance(track._later, LinearSteps) and track._later.plan.parts.root is not None:
        return track._later.plan.each(track._later.plan.parts.root, track.mean.shape[-2])
    return root(compact(track.cov, 3))


def _largest(predicted):
    """The largest standard deviation of each state along time: by it one judges which digits are rounding errors."""
    return np.sqrt(np.diagonal(predicted, axis1=-2, axis2=-1).max(axis=-2, keepdims=True))


def backward_gain(slope, L, noise, largest):
    """What the next state tells of this one: the gain G (..., n, n), a root of the covariance that is left once the
    next state is known, and whether roots that were made from rounded covariances would lack digits here.

    [[F L, Q½], [L, 0]] has the same square as the triangular [[P⁻½, 0], [G P⁻½, C]], and C Cᵀ is what is left: nothing
    is inverted but a root of P⁻. slope is F L, for a belief with the root L; noise is Q½; largest: as of _largest.
    """
    n = L.shape[-1]
    array = np.zeros((*np.broadcast_shapes(slope.shape[:-2], L.shape[:-2], noise.shape[:-2]), 2 * n, 2 * n))
    array[..., :n, :n], array[..., :n, n:], array[..., n:, :n] = slope, noise, L
    array = triangular(array)
    size, own = np.sqrt(np.sum(array[..., :n, :n] ** 2, axis=-1)), np.diagonal(array[..., :n, :n], axis1=-2, axis2=-1)
    thin = bool((own < 1e-4 * size).any())
    # Near 0 on the diagonal: this component follows from those before it, and so tells nothing more.
    tells = own > np.maximum(1e-14 * size, 1e-15 * n * largest)
    if tells.all():
        return np.linalg.solve(array[..., :n, :n].mT, array[..., n:, :n].mT).mT, array[..., n:, n:], thin
    return *_gain_of_few(array, tells), thin


def _gain_of_few(array, tells):
    """Gain and what is left where only some components of the next state tell something: the others go last, as 0."""
    n = tells.shape[-1]
    order = np.argsort(~tells, axis=-1, kind="stable")
    tell = np.take_along_axis(tells, order, axis=-1)
    rows = np.take_along_axis(array[..., :n, :], order[..., None], axis=-2) * tell[..., None]
    array = triangular(np.concatenate([rows, array[..., n:, :]], axis=-2))
    A = np.where(tell[..., None], array[..., :n, :n], np.eye(n))
    B, C = array[..., n:, :n], array[..., n:, n:]
    gain = np.linalg.solve(A.mT, (B * tell[..., None, :]).mT).mT
    gain = np.take_along_axis(gain, np.argsort(order, axis=-1)[..., None, :], axis=-1)
    return gain, triangular(np.concatenate([B * ~tell[..., None, :], C], axis=-1))


def _smoothed_covariances(gain, left, index, T):
    """P_k = what is left + G_k P_{k+1} G_kᵀ, backwards and on roots L_k L_kᵀ = P_k: (..., T, n, n)."""
    if index is None:
        roots = [left[..., -1, :, :]]
        for k in range(T - 2, -1, -1):
            ahead = gain[..., k, :, :] @ roots[-1]
            roots.append(triangular(np.concatenate(np.broadcast_arrays(left[..., k, :, :], ahead), axis=-1)))
        L = np.moveaxis(np.stack(np.broadcast_arrays(*roots[::-1])), 0, -3)
        return L @ L.mT

    def step(L, row):
        L = triangular(np.concatenate([left[row], gain[row] @ L], axis=-1))
        return L, (L @ L.mT,)

    plan = walk(index[..., ::-1], np.zeros_like(left[0]), step, same_root)
    return plan.each(plan.parts[0], T)[..., ::-1, :, :]


def _shifts(track, gain, index):
    """By how much means change: d_k = G_k (d_{k+1} + x̂_{k+1} − x⁻_{k+1}), backwards, with G = 0 at the last step."""
    ahead = np.roll(track.learnt, -1, axis=-2)  # the last one meets a gain of 0
    drive = matvec_each_step(gain, ahead, index)[..., ::-1, :]
    del ahead
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
