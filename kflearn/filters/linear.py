"""Filters whose gains do not depend on the data: first all gains, once, then the means of every run."""

from functools import partial
from typing import NamedTuple

import numpy as np

from ..core.conditioning import covariance_after, decouple_missing, definite, divide, without_missing
from ..core.matrices import congruence, matvec, step_matrix
from ..core.recursion import linear_recursion, matvec_each_step
from ..core.walk import Walk, same_covariance, walk
from ..models.arguments import check_series
from ..models.gaussian import unchecked_gaussian
from ..models.state_space import LinearModel, stacks
from ..results.track import LinearSteps, Track
from .gate import beyond, gate_limits
from .moments import linearize
from .steps import at_step, refuse_innovation, starting_belief


class Step(NamedTuple):
    """One step of a linear filter: predicted P, S, K, corrected P; roots of S and of P where the filter has them."""

    predicted: np.ndarray
    S: np.ndarray
    gain: np.ndarray
    cov: np.ndarray
    S_root: np.ndarray | None = None
    root: np.ndarray | None = None


def linear_filter(
    model, z, initial, u, step, carry=lambda P: P, same=same_covariance, through=linearize, gate=None
) -> Track:
    """Compute all gains with `step` (they do not depend on z), then the means of all runs.

    step(carried, F, H, Q, R, missing) → carried, Step sets the variants apart; `missing` is None where everything is
    measured. What is carried from step to step begins as carry(initial.cov), and `same` tells when it is at rest.
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    z, u, batch = check_series(model, z, initial, u)
    if gate is not None:
        return gated_filter(model, z, starting_belief(initial, batch), u, step, carry, through, gate)
    T, missing = z.shape[-2], np.isnan(z)
    plan = plan_steps(model, initial.cov, missing, step, carry, same)
    gain, index = plan.parts.gain, plan.index
    drive = matvec_each_step(gain, np.where(missing, 0, z) if missing.any() else z, index)
    whole = model.F.ndim == 2 and model.H.ndim == 2  # else the matrices of each step go with its gain
    of_each, index = (gain, index) if whole else (plan.each(gain, T), None)
    keep = np.eye(model.n) - of_each @ model.H
    if u is not None:
        drive = drive + matvec_each_step(keep, matvec_each_step(model.B, u), index)
    mean = linear_recursion(keep @ model.F, drive, initial.mean, index)
    return Track(
        unchecked_gaussian(mean, plan.each(plan.parts.cov, T)),
        plan.each(gain, T),
        model,
        LinearSteps(model, z, u, initial, plan),
        u,
        through,
    )


def covariance_step(P, F, H, Q, R, missing, choose=divide):
    """Eqs (6), (7) and (9): how the covariance goes through one step, with the gain that choose(cross, S) makes."""
    if P.size == H.size == 1 and missing is None and choose is divide:
        return _step_of_numbers(P.item(), F.item(), H.item(), Q.item(), R.item())
    predicted = congruence(F, P)[0] + Q
    moved, cross = congruence(H, predicted)
    S = moved + R
    used, cross = (S, cross) if missing is None else without_missing(missing, S, cross)
    gain = choose(cross, used)
    P = covariance_after(gain, predicted, H, R)
    return P, Step(predicted, S, gain, P)


def _step_of_numbers(P, F, H, Q, R):
    """The same for one state and one measured component: as plain numbers it takes a fourth of the time."""
    predicted = F * P * F + Q
    S = H * predicted * H + R
    gain = predicted * H / S
    keep = 1 - gain * H
    P = keep * predicted * keep + gain * R * gain
    steps = np.array([predicted, S, gain, P]).reshape(4, 1, 1)
    return steps[3], Step(*steps)


def plan_steps(model, P, missing, step, carry, same) -> Walk:
    """All covariances and gains, whose parts are a Step; each distinct one is computed once, where that is possible."""
    given = {name: M for name, M in stacks(model).items() if name != "B"}
    shared = P.ndim == 2 and all(M.ndim == 3 for M in given.values())
    with np.errstate(all="ignore"):  # what goes wrong is found below, and said with its step
        plan = _distinct_steps(model, P, missing, step, carry, same) if shared else None
        plan = plan or _every_step(model, P, missing, step, carry)
    _refuse_lost(plan, missing)
    return plan


def _distinct_steps(model, P, missing, step, carry, same):
    """The plan where runs differ in nothing but their gaps; None where (almost) each step is one of its own."""
    kinds, first = _kinds(model, missing.shape[-2])
    masks, gaps = gap_kinds(missing)
    if _all_different(gaps) or len(first) == missing.shape[-2] > 1:
        return None
    matrices = [M if M.ndim == 2 else M[first if len(M) > 1 else [0] * len(first)] for M in _matrices(model)]

    constant, whole = all(M.ndim == 2 for M in matrices), not masks.any()

    def take(carried, symbol):
        kind, gap = symbol // len(masks), symbol % len(masks)
        own = matrices if constant else [M if M.ndim == 2 else M[kind] for M in matrices]
        return step(carried, *own, None if whole or not masks[gap].any() else masks[gap])

    plan = walk(kinds * len(masks) + gaps, carry(P), take, same)
    return Walk(Step(*plan.parts), plan.index)


def _every_step(model, P, missing, step, carry):
    """The plan from a plain loop over all steps."""
    T = missing.shape[-2]
    missing = missing if missing.any() else None
    lead = () if missing is None else missing.shape[:-2]
    batch = np.broadcast_shapes(P.shape[:-2], lead, *(M.shape[:-3] for M in _matrices(model)))
    carried, steps = carry(np.broadcast_to(P, (*batch, *P.shape[-2:]))), []
    for k in range(T):
        own = (step_matrix(M, k) for M in _matrices(model))
        carried, parts = step(carried, *own, None if missing is None else missing[..., k, :])
        steps.append(parts)
    return Walk(_stacked(steps))


def gated_filter(model, z, belief, u, step, carry, through, gate):
    """With a gate the covariances depend on the data: step by step, each step in which a reading is refused twice."""
    limits, missing, steps = gate_limits(gate, model.m), np.isnan(z), []
    x, carried = belief.mean, carry(belief.cov)
    with np.errstate(all="ignore"):  # what goes wrong is found below, and said with its step
        for k in range(z.shape[-2]):
            x = model.move(x, at_step(u, k), k)
            y, lost = z[..., k, :] - model.measure(x, k=k), missing[..., k, :]
            one = partial(step, carried, *(step_matrix(M, k) for M in _matrices(model)))
            after, parts = one(lost if lost.any() else None)
            refused = beyond(limits, unchecked_gaussian(y, parts.S), parts.S_root)
            if refused.any():
                after, parts = one(lost | refused[..., None])
            carried, x = after, x + matvec(parts.gain, np.where(lost, 0, y))
            steps.append((x, refused, parts))
    means, refused, steps = zip(*steps, strict=True)
    plan = Walk(_stacked(steps))
    _refuse_lost(plan, missing)
    filtered = unchecked_gaussian(np.stack(means, -2), plan.parts.cov)
    later, refused = LinearSteps(model, z, u, belief, plan), np.stack(refused, -1)
    return Track(filtered, plan.parts.gain, model, later, u, through, refused)


def _stacked(steps):
    """The Steps of single steps as one Step along time."""
    return Step(*(None if part[0] is None else np.moveaxis(np.stack(part), 0, -3) for part in zip(*steps, strict=True)))


def _matrices(model):
    return model.F, model.H, model.Q, model.R


def _kinds(model, T):
    """Which of the distinct sets of matrices each step has, (T,), and the first step that has each of them."""
    long = [M.reshape(T, -1) for M in _matrices(model) if M.ndim > 2 and len(M) == T > 1]
    if not long:
        return np.zeros(T, np.int32), [0]
    rows = [row.tobytes() for row in np.concatenate(long, axis=1)]
    number = {row: i for i, row in enumerate(dict.fromkeys(rows))}
    kinds = np.array([number[row] for row in rows])
    return kinds, np.unique(kinds, return_index=True)[1]


def _all_different(gaps):
    """Do runs have so many gaps, each run its own (..., T), that hardly any step is like another one's?"""
    if gaps.ndim == 1 or np.mean(gaps != np.bincount(gaps.ravel()).argmax()) < 0.02:
        return False
    rows = gaps.reshape(-1, gaps.shape[-1])
    return len({row.tobytes() for row in rows}) > len(rows) / 4


def gap_kinds(missing):
    """The distinct patterns of gaps (kinds, m), and which of them each step has: (..., T), or (T,) if all runs agree.

    missing: (..., T, m).
    """
    *batch, T, m = missing.shape
    flat = missing.reshape(-1, T, m)
    if (flat == flat[:1]).all():
        flat, batch = flat[:1], ()
    kinds = np.zeros(len(flat) * T, int)
    for column in flat.reshape(-1, m).T:
        if column.any():
            kinds = 2 * kinds + column
            met = np.bincount(kinds) > 0
            kinds = (np.cumsum(met) - 1)[kinds]  # numbered without holes
    first = [int(np.argmax(kinds == kind)) for kind in range(kinds.max() + 1)]
    return flat.reshape(-1, m)[first], kinds.astype(np.int32).reshape(*batch, T)


def _refuse_lost(plan, missing):
    """Refuse a plan in which too many digits were lost: S is no covariance any more, or something is NaN."""
    steps, T = plan.parts, missing.shape[-2]
    finite = np.isfinite(steps.gain).all(axis=(-2, -1)) & np.isfinite(steps.cov).all(axis=(-2, -1))
    good = finite & (definite(steps.S) if steps.S_root is None else True)
    if good.all():
        return
    S = decouple_missing(plan.each(steps.S, T), missing)
    good = plan.each(finite[..., None, None], T)[..., 0, 0] & (definite(S) if steps.S_root is None else True)
    if not good.all():
        refuse_innovation(int(np.argmin(good.reshape(-1, T).all(axis=0))))
