"""The arguments of the filters, looked at before anything is computed."""

import numpy as np

from . import _checks as check
from .gaussian import Gaussian
from .models import LinearModel, NonlinearModel


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


def check_control_series(model, u, T):
    """Control inputs along time as an array (..., T, p)."""
    u = _series("u", u, model.p if isinstance(model, LinearModel) and model.B is not None else None)
    check_control(model, u)
    if u.shape[-2] != T:
        raise ValueError(f"u must have {T} steps, one for each measurement, got shape {u.shape}")
    return u


def check_series(model, z, initial, u):
    """z as (..., T, m) and u as (..., T, p), after all arguments of a filter were looked at."""
    check_belief("initial", initial, model)
    z = _series("z", z, model.m, gaps=True)
    T = z.shape[-2]
    for name in "FHBQR":
        M = getattr(model, name, None)
        if M is not None and M.ndim > 2 and M.shape[-3] not in (1, T):
            raise ValueError(f"{name} must have {T} steps like z, or 1, got shape {M.shape}")
    if u is not None:
        u = check_control_series(model, u, T)
    batches = {"z": z.shape[:-2], "initial": initial.mean.shape[:-1], "u": () if u is None else u.shape[:-2]}
    try:
        np.broadcast_shapes(*batches.values())
    except ValueError:
        found = ", ".join(f"{name} {batch}" for name, batch in batches.items())
        raise ValueError(f"z, initial and u must have batch axes that broadcast, got {found}") from None
    return z, u


def _series(name, value, width, gaps=False):
    array = check.numbers(name, value, gaps)
    if array.ndim == 1 and width in (1, None):
        array = array[:, None]
    if array.ndim < 2:
        raise ValueError(f"{name} must have shape (..., T, {width or 'any'}), got {array.shape}")
    if width not in (None, array.shape[-1]):
        raise ValueError(f"{name} must have shape (..., T, {width}), got {array.shape}")
    return array
