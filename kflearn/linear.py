"""Filters whose gains do not depend on the data: first all gains, once, then the means of every run."""

import numpy as np

from .arguments import check_series
from .conditioning import covariance_after, divide, without
from .gaussian import symmetric, trusted
from .models import LinearModel, apply, at, stacks
from .moments import linearize, spread
from .recursion import linear_recursion
from .results import Track


def linear_filter(model, z, initial, u, step, carry=lambda P: P, through=linearize):
    """One filter for many runs, over the gains that `step` makes.

    step(carried, F, H, Q, R, missing) → carried, (predicted P, S, K, corrected P) sets the variants apart; `missing`
    is None where everything is measured. What is carried from step to step begins as carry(initial.cov).
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    z, u, _ = check_series(model, z, initial, u)
    missing = np.isnan(z)
    predicted_cov, S, gain, cov = _gains(model, initial.cov, missing, step, carry)
    keep = np.eye(model.n) - gain @ model.H
    drive = each(gain, np.where(missing, 0, z) if missing.any() else z)
    if u is not None:
        drive = drive + each(keep @ model.B, u)
    mean = linear_recursion(keep @ model.F, drive, initial.mean)
    T = z.shape[-2]

    def predicted():
        before = np.empty_like(mean)  # which lies in memory as `mean` does
        before[..., 0, :], before[..., 1:, :] = initial.mean, mean[..., :-1, :]
        moved = each(model.F, before)
        return trusted(moved if u is None else moved + each(model.B, u), hold(symmetric(predicted_cov), T))

    def innovation():
        return trusted(z - each(model.H, track.predicted.mean), hold(S, T))

    track = Track(trusted(mean, hold(cov, T)), hold(gain, T), predicted, innovation, u, through)
    return track


def covariance_step(P, F, H, Q, R, missing, choose=divide):
    """Eqs (6), (7) and (9): how the covariance goes through one step, with the gain that choose(cross, S) makes."""
    predicted = spread(F, P)[0] + Q
    moved, cross = spread(H, predicted)
    S = moved + R
    used, cross = (S, cross) if missing is None else without(missing, S, cross)
    gain = choose(cross, used)
    P = covariance_after(gain, predicted, H, R)
    return P, (predicted, S, gain, P)


def shared(missing):
    """The gaps (..., T, m) without their batch axes where they are the same in every run; None where there are none."""
    if not missing.any():
        return None
    first = missing.reshape(-1, *missing.shape[-2:])[0]
    return first if (missing == first).all() else missing


def _gains(model, P, missing, step, carry):
    """Covariances and gains: predicted P, S, K, corrected P, each (..., steps, ·, ·), for all T steps or, when nothing
    changes any more after fewer, for these."""
    T = missing.shape[-2]
    missing = shared(missing)
    gaps = missing is not None
    series = stacks(model).values()
    batch = np.broadcast_shapes(P.shape[:-2], missing.shape[:-2] if gaps else (), *(M.shape[:-3] for M in series))
    constant = not gaps and all(M.shape[-3] == 1 for M in series)
    P = np.broadcast_to(P, (*batch, *P.shape[-2:]))
    carried, steps = carry(P), []
    for k in range(T):
        before = P
        F, H, Q, R = (at(M, k) for M in (model.F, model.H, model.Q, model.R))
        carried, parts = step(carried, F, H, Q, R, missing[..., k, :] if gaps else None)
        P = parts[-1]
        steps.append(parts)
        if constant and k % 8 == 7 and _unchanged(P, before):
            break
    return [np.stack(part, axis=-3) for part in zip(*steps, strict=True)]


def hold(array, T):
    """An array (..., steps, ·, ·) made T long by holding its last entry."""
    rest = T - array.shape[-3]
    last = array[..., -1:, :, :]
    held = np.broadcast_to(last, (*last.shape[:-3], rest, *last.shape[-2:]))
    return np.concatenate([array, held], axis=-3) if rest else array


def _unchanged(P, before):
    """Has a covariance come to rest? Judged against its own variances, a few roundings wide."""
    variance = np.diagonal(P, axis1=-2, axis2=-1)
    scale = np.sqrt(abs(variance[..., :, None] * variance[..., None, :]))
    return (abs(P - before) <= 1e-14 * scale).all()


def each(M, v):
    """M_k v_k for all steps: M (..., steps, n, m) or (n, m), v (..., T, m); the last of fewer matrices holds on."""
    if M.ndim == 2 and (v.ndim == 2 or v.flags.c_contiguous):
        return apply(M, v)
    if M.ndim > 3:
        return np.matvec(hold(M, v.shape[-2]), v)
    # One matrix a step serves all runs: put the runs last, where they may lie already, and use matrix products.
    M = M if M.ndim > 2 else M[None]
    wide = np.moveaxis(v, (-2, -1), (0, 1)).reshape(*v.shape[-2:], -1)
    out = np.empty((len(wide), M.shape[-2], wide.shape[-1]))
    np.matmul(M, wide[: len(M)], out=out[: len(M)])
    out[len(M) :] = M[-1] @ wide[len(M) :]
    return np.moveaxis(out.reshape(*out.shape[:2], *v.shape[:-2]), (0, 1), (-2, -1))
