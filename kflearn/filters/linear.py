"""Filters whose gains do not depend on the data: first all gains, once, then the means of every run."""

import numpy as np

from ..core.conditioning import covariance_after, divide, without_missing
from ..core.matrices import congruence, step_matrix
from ..core.recursion import extend_last, linear_recursion, matvec_each_step
from ..models.arguments import check_series
from ..models.gaussian import unchecked_gaussian
from ..models.state_space import LinearModel, stacks
from ..results.track import LinearSteps, Track
from .moments import linearize


def linear_filter(model, z, initial, u, step, carry=lambda P: P, through=linearize) -> Track:
    """Compute all gains with `step` (they do not depend on z), then the means of all runs.

    step(carried, F, H, Q, R, missing) → carried, (predicted P, S, K, corrected P) sets the variants apart; `missing`
    is None where everything is measured. What is carried from step to step begins as carry(initial.cov).
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    z, u, _ = check_series(model, z, initial, u)
    missing = np.isnan(z)
    predicted_cov, S, gain, cov = _gains(model, initial.cov, missing, step, carry)
    keep = np.eye(model.n) - gain @ model.H
    drive = matvec_each_step(gain, np.where(missing, 0, z) if missing.any() else z)
    if u is not None:
        drive = drive + matvec_each_step(keep @ model.B, u)
    mean = linear_recursion(keep @ model.F, drive, initial.mean)
    T = z.shape[-2]
    return Track(
        unchecked_gaussian(mean, extend_last(cov, T)),
        extend_last(gain, T),
        model,
        LinearSteps(model, z, u, initial.mean, predicted_cov, S),
        u,
        through,
    )


def covariance_step(P, F, H, Q, R, missing, choose=divide):
    """Eqs (6), (7) and (9): how the covariance goes through one step, with the gain that choose(cross, S) makes."""
    predicted = congruence(F, P)[0] + Q
    moved, cross = congruence(H, predicted)
    S = moved + R
    used, cross = (S, cross) if missing is None else without_missing(missing, S, cross)
    gain = choose(cross, used)
    P = covariance_after(gain, predicted, H, R)
    return P, (predicted, S, gain, P)


def common_gaps(missing):
    """The gaps (..., T, m) without their batch axes where they are the same in every run; None where there are none."""
    if not missing.any():
        return None
    first = missing.reshape(-1, *missing.shape[-2:])[0]
    return first if (missing == first).all() else missing


def _gains(model, P, missing, step, carry):
    """Covariances and gains: predicted P, S, K, corrected P, each (..., steps, ·, ·), for all T steps or, when nothing
    changes any more after fewer, for these."""
    T = missing.shape[-2]
    missing = common_gaps(missing)
    gaps = missing is not None
    series = stacks(model).values()
    batch = np.broadcast_shapes(P.shape[:-2], missing.shape[:-2] if gaps else (), *(M.shape[:-3] for M in series))
    constant = not gaps and all(M.shape[-3] == 1 for M in series)
    P = np.broadcast_to(P, (*batch, *P.shape[-2:]))
    carried, steps = carry(P), []
    for k in range(T):
        before = P
        F, H, Q, R = (step_matrix(M, k) for M in (model.F, model.H, model.Q, model.R))
        carried, parts = step(carried, F, H, Q, R, missing[..., k, :] if gaps else None)
        P = parts[-1]
        steps.append(parts)
        if constant and k % 8 == 7 and _unchanged(P, before):
            break
    return [np.stack(part, axis=-3) for part in zip(*steps, strict=True)]


def _unchanged(P, before):
    """Has a covariance come to rest? Judged against its own variances, a few roundings wide."""
    variance = np.diagonal(P, axis1=-2, axis2=-1)
    scale = np.sqrt(abs(variance[..., :, None] * variance[..., None, :]))
    return (abs(P - before) <= 1e-14 * scale).all()
