"""The arguments of the filters, looked at before anything is computed."""

import numpy as np

from . import _checks as check
from .gaussian import Gaussian
from .models import LinearModel, NonlinearModel, stacks


def check_model(model):
    """A model has to be one of the two kinds."""
    if not isinstance(model, (LinearModel, NonlinearModel)):
        raise TypeError(f"model must be a LinearModel or a NonlinearModel, got {type(model).__name__}")


def check_belief(name, belief, model):
    if not isinstance(belief, Gaussian):
        raise TypeError(f"{name} must be a Gaussian, got {type(belief).__name__}")
    if belief.mean.shape[-1] != model.n:
        raise ValueError(f"{name} must have {model.n} components like the model, got {belief.mean.shape[-1]}")


def check_control(model, u):
    """One control input (..., p) has to fit the model."""
    if isinstance(model, LinearModel):
        if model.B is None:
            raise ValueError("u was given, but the model has no B: expected a model with B or no u")
        check.shape("u", u, (model.p,))


def check_step(model, k):
    """{name: batch axes} of the model's stacks, in all of which the step k has to exist."""
    check.whole_number("k", k, least=0)
    for name, M in stacks(model).items():
        if 1 < M.shape[-3] <= k:
            raise ValueError(f"k must be below {M.shape[-3]}, the number of steps of {name}, got {k}")
    return {name: M.shape[:-3] for name, M in stacks(model).items()}


def check_stacks(model, T):
    """{name: batch axes} of the model's stacks, all of which have T steps, or 1."""
    for name, M in stacks(model).items():
        if M.shape[-3] not in (1, T):
            raise ValueError(f"{name} must have {T} steps, or 1, got shape {M.shape}")
    return {name: M.shape[:-3] for name, M in stacks(model).items()}


def check_move(model, x, u=None):
    """Does f of a nonlinear model broadcast? Tried once, on n + 1 copies of the states x (..., n); returns f(x)."""
    if isinstance(model, LinearModel):
        return x
    x, u = np.broadcast_to(x, (model.n + 1, *x.shape)), () if u is None else (u,)
    moved = check.numbers("what f returns", _tried("f", model.f, (model.n,), x, *u))
    if model.F_jacobian is not None:
        _tried("F_jacobian", model.F_jacobian, (model.n, model.n), x, *u)
    return moved[0]


def check_measure(model, x):
    """The same for h and what goes with it."""
    if isinstance(model, LinearModel):
        return
    x = np.broadcast_to(x, (model.n + 1, *x.shape))
    expected = check.numbers("what h returns", _tried("h", model.h, (model.m,), x))
    if model.H_jacobian is not None:
        _tried("H_jacobian", model.H_jacobian, (model.m, model.n), x)
    if model.residual is not None:
        _tried("residual", model.residual, (model.m,), expected, expected)


def _tried(name, function, expected, *arguments):
    states = arguments[0].shape
    wanted = f"{name} must return shape (..., {', '.join(map(str, expected))})"
    try:
        with np.errstate(all="ignore"):
            # Read-only arguments: a function that overwrites the filter's states is found out.
            value = function(*(np.broadcast_to(a, a.shape) for a in arguments))
        found = np.shape(value)
    except (TypeError, ValueError, IndexError) as error:
        reason = str(error).split(". ")[0]
        raise ValueError(f"{wanted}, got an error for an argument of shape {states}: {reason}") from error
    whole = (*states[:-1], *expected)
    constant = name.endswith("jacobian") and found == expected
    if found != whole and not constant:
        raise ValueError(f"{wanted}, got {found} for an argument of shape {states}")
    return value


def check_control_series(model, u, T):
    """Control inputs along time as an array (..., T, p)."""
    u = _series("u", u, model.p if isinstance(model, LinearModel) and model.B is not None else None)
    check_control(model, u)
    if u.shape[-2] != T:
        raise ValueError(f"u must have {T} steps, one for each measurement, got shape {u.shape}")
    return u


def check_series(model, z, initial, u):
    """z as (..., T, m), u as (..., T, p) and all batch axes, after the arguments of a filter were looked at."""
    check_belief("initial", initial, model)
    z = _series("z", z, model.m, gaps=True)
    T = z.shape[-2]
    axes = check_stacks(model, T)
    if u is not None:
        u = check_control_series(model, u, T)
        axes["u"] = u.shape[:-2]
    batch = check.batches(z=z.shape[:-2], initial=initial.batch, **axes)
    x = np.broadcast_to(initial.mean, (*batch, model.n))
    check_measure(model, check_move(model, x, None if u is None else u[..., 0, :]))
    return z, u, batch


def _series(name, value, width, gaps=False):
    array = check.numbers(name, value, gaps)
    if array.ndim == 1 and width in (1, None):
        array = array[:, None]
    if array.ndim < 2:
        raise ValueError(f"{name} must have shape (..., T, {width or 'any'}), got {check.found_in(array)}")
    if width not in (None, array.shape[-1]):
        raise ValueError(f"{name} must have shape (..., T, {width}), got {check.found_in(array)}")
    return array
