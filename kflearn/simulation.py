"""Truth and measurements made by a model."""

from typing import NamedTuple

import numpy as np

from . import _checks as check
from .arguments import check_belief, check_control_series, check_measure, check_model, check_move, check_stacks
from .gaussian import Gaussian, root
from .models import apply, at


class Simulation(NamedTuple):
    """True states x (runs, T, n), measurements z (runs, T, m), control inputs u (T, p) or None.

    Without `runs` the first axis is absent.
    """

    x: np.ndarray
    z: np.ndarray
    u: np.ndarray | None


def simulate(model, initial, steps, u=None, runs=None, rng=None):
    """Let a model run: x[0] is one step after the start, as in the filters.

    model: LinearModel or NonlinearModel. initial: a Gaussian from which each run draws its start, or a state (n,) from
    which all start exactly. steps: T. u: (T, p), or (T,) when p = 1. rng: a numpy Generator or a seed.
    Starts, u and the model's stacks may have the axis of the runs in front: then each run has its own.
    Raises ValueError or TypeError, naming the argument, where the pieces do not fit.
    """
    check_model(model)
    T = check.whole_number("steps", steps)
    batch = () if runs is None else (check.whole_number("runs", runs),)
    rng = np.random.default_rng(rng)
    axes = check_stacks(model, T)
    if u is not None:
        u = check_control_series(model, u, T)
        axes["u"] = u.shape[:-2]
    if isinstance(initial, Gaussian):
        check_belief("initial", initial, model)
        axes["initial"] = initial.batch
    else:
        initial = check.shape("initial", np.atleast_1d(check.numbers("initial", initial)), (model.n,))
        axes["initial"] = initial.shape[:-1]
    for name, found in axes.items():
        if found not in ((), batch):
            raise ValueError(f"{name} must have the batch axes {batch} of the runs, or none, got {found}")
    if isinstance(initial, Gaussian):
        initial = initial.sample(() if initial.batch else batch, rng)
    state = np.broadcast_to(initial, (*batch, model.n))
    check_measure(model, check_move(model, state, None if u is None else u[..., 0, :]))
    x, z = np.empty((*batch, T, model.n)), np.empty((*batch, T, model.m))
    for k in range(T):
        moved = model.move(state, None if u is None else u[..., k, :], k)
        state = x[..., k, :] = moved + _noise(at(model.Q, k), batch, rng)
        z[..., k, :] = model.measure(state, k) + _noise(at(model.R, k), batch, rng)
    return Simulation(x, z, u)


def _noise(cov, batch, rng):
    return apply(root(cov), rng.standard_normal((*batch, cov.shape[-1])))
