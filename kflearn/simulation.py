"""Truth and measurements made by a model."""

from typing import NamedTuple

import numpy as np

from . import _checks as check
from .arguments import check_control_series, check_model
from .gaussian import Gaussian, root
from .models import at


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
    """
    check_model(model)
    T = check.whole_number("steps", steps)
    batch = () if runs is None else (check.whole_number("runs", runs),)
    rng = np.random.default_rng(rng)
    if u is not None:
        u = check_control_series(model, u, T)
    if isinstance(initial, Gaussian):
        state = initial.sample(batch, rng)
    else:
        start = np.atleast_1d(check.numbers("initial", initial))
        state = np.broadcast_to(check.shape("initial", start, (model.n,)), (*batch, model.n))
    x, z = np.empty((*batch, T, model.n)), np.empty((*batch, T, model.m))
    for k in range(T):
        moved = model.move(state, None if u is None else u[k], k)
        state = x[..., k, :] = moved + _noise(at(model.Q, k), batch, rng)
        z[..., k, :] = model.measure(state, k) + _noise(at(model.R, k), batch, rng)
    return Simulation(x, z, u)


def _noise(cov, batch, rng):
    return rng.standard_normal((*batch, cov.shape[-1])) @ root(cov).mT
