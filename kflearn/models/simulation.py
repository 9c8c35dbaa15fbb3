"""True states and measurements made by a model."""

from typing import NamedTuple

import numpy as np

from ..core.matrices import matvec, root, step_matrix
from . import checks as check
from .arguments import check_belief, check_control_series, check_functions, check_model, check_stacks
from .gaussian import Gaussian


class Simulation(NamedTuple):
    """What `simulate` returns; without `runs` the first axis is absent.

    Attributes
    ----------
    x : ndarray (runs, T, n)
        True states.
    z : ndarray (runs, T, m)
        Measurements.
    u : ndarray (T, p), (runs, T, p) or None
        Control inputs.
    """

    x: np.ndarray
    z: np.ndarray
    u: np.ndarray | None


def simulate(model, initial, steps, u=None, runs=None, rng=None) -> Simulation:
    """Let a model run, and measure it: x[0] is one step after the start, as in the filters.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        What moves and is measured.
    initial : Gaussian or array_like (n,)
        A Gaussian from which each run draws its start, or a state from which all start exactly.
    steps : int
        T, the length of the series.
    u : array_like (T, p), optional
        Control inputs, or (T,) when p = 1; u[k] acts on the way to x[k], and when x[k] is measured.
    runs : int, optional
        How many runs; without it a single one, and no axis for runs.
    rng : numpy.random.Generator, int or None
        A generator or a seed.

    Starts, u and the model's stacks may have the axis of the runs in front: then each run has its own.

    Returns
    -------
    Simulation
        x (runs, T, n), z (runs, T, m) and u.

    Raises
    ------
    ValueError or TypeError
        Naming the argument, where the pieces do not fit.

    Examples
    --------
    >>> from kflearn import random_walk, simulate
    >>> data = simulate(random_walk(Q=1, R=4), [0], steps=50, runs=3, rng=0)
    >>> print(data.x.shape, data.z.shape)
    (3, 50, 1) (3, 50, 1)
    """
    check_model(model)
    T = check.whole_number("steps", steps)
    batch = () if runs is None else (check.whole_number("runs", runs),)
    rng = check.generator("rng", rng)
    if u is not None:
        u = check_control_series(model, u, T)
    initial = _starts(model, initial, {**check_stacks(model, T), "u": () if u is None else u.shape[:-2]}, batch)
    start, std = initial, np.zeros(model.n)
    if isinstance(initial, Gaussian):
        start, std = initial.sample(() if initial.batch else batch, rng), initial.std
    state = np.broadcast_to(start, (*batch, model.n))
    check_functions(model, state, u, std)
    x, z = np.empty((*batch, T, model.n)), np.empty((*batch, T, model.m))
    for k in range(T):
        push = None if u is None else u[..., k, :]
        moved = model.move(state, push, k)
        state = moved + _noise(step_matrix(model.Q, k), batch, rng)
        x[..., k, :] = state
        z[..., k, :] = model.measure(state, push, k) + _noise(step_matrix(model.R, k), batch, rng)
    return Simulation(x, z, u)


def _starts(model, initial, axes, batch):
    """`initial` as a Gaussian or an array, after a look at whether all batch axes are those of the runs, or none."""
    if isinstance(initial, Gaussian):
        check_belief("initial", initial, model)
        axes["initial"] = initial.batch
    else:
        initial = check.shape("initial", np.atleast_1d(check.numbers("initial", initial)), (model.n,))
        axes["initial"] = initial.shape[:-1]
    for name, found in axes.items():
        if found not in ((), batch):
            raise ValueError(f"{name} must have the batch axes {batch} of the runs, or none, got {found}")
    return initial


def _noise(cov, batch, rng):
    """Random draws (*batch, n) from N(0, cov)."""
    return matvec(root(cov), rng.standard_normal((*batch, cov.shape[-1])))
