"""Models of fewer states than the whole: written for the whole state, and what their states are apart."""

from functools import partial

import numpy as np

from ..models import checks as check
from ..models.arguments import check_belief, check_model
from ..models.gaussian import Gaussian
from ..models.state_space import LinearModel


def lifted(models, initial, states):
    """The models, each written for the whole state."""
    if not isinstance(models, (list, tuple)) or not models:
        raise TypeError(f"models must be a list of models, got {type(models).__name__}")
    for model in models:
        check_model(model)
    measured = {model.m for model in models}
    if len(measured) > 1:
        raise ValueError(f"models must all measure the same components, got {sorted(measured)} of them")
    if states is None:
        for model in models:
            check_belief("initial", initial, model)
        return list(models)
    if not isinstance(initial, Gaussian):
        raise TypeError(f"initial must be a Gaussian, got {type(initial).__name__}")
    n = initial.mean.shape[-1]
    if not isinstance(states, (list, tuple)) or len(states) != len(models):
        raise ValueError(f"states must be a list of {len(models)} lists, one for each model, got {states!r}")
    return [_lift(model, n, kept) for model, kept in zip(models, states, strict=True)]


def _lift(model, n, kept):
    """A model of the states `kept` as a model of all n: the others stay at 0."""
    try:
        kept = [check.whole_number("each of states", i, least=0) for i in kept]
    except TypeError:
        raise TypeError(f"each of states must be a list of indices, got {kept!r}") from None
    if len(set(kept)) != model.n or len(kept) != model.n or max(kept) >= n:
        raise ValueError(f"each of states must hold as many different indices below {n} as its model has states")
    E = np.eye(n)[:, kept]
    if isinstance(model, LinearModel):
        B = None if model.B is None else E @ model.B
        return LinearModel(E @ model.F @ E.T, model.H @ E.T, E @ model.Q @ E.T, model.R, B)
    return model.replace(
        f=lambda x, u=None, k=0: model.move(x[..., kept], u, k) @ E.T,
        h=lambda x, u=None, k=0: model.measure(x[..., kept], u, k),
        Q=E @ model.Q @ E.T,
        F_jacobian=lambda x, u=None, k=0: E @ model.move_slope(x[..., kept], u, k) @ E.T,
        H_jacobian=lambda x, u=None, k=0: model.measure_slope(x[..., kept], u, k) @ E.T,
        state_residual=None if model.state_residual is None else partial(_lifted_difference, model, kept),
        scale=E @ model.scale + 1 - E.sum(axis=1) if model.scale.ndim else model.scale,
    )


def _lifted_difference(model, kept, x, other):
    """state_residual of a model with the states `kept`, for states (..., n); other components are subtracted."""
    apart = x - other
    apart[..., kept] = model.state_residual(x[..., kept], other[..., kept])
    return apart


def difference_of(models):
    """The difference of two states that belong to several models: of what they make of it, the shortest."""
    own = [model.state_difference for model in models if getattr(model, "state_residual", None) is not None]
    if not own:
        return np.subtract

    def difference(x, other):
        apart = x - other
        for each in own:
            shorter = each(x, other)
            apart = np.where(abs(shorter) < abs(apart), shorter, apart)
        return apart

    return difference
