"""The arguments of the filters, looked at before anything is computed."""

from functools import partial

import numpy as np

from . import checks as check
from . import probe
from .gaussian import Gaussian
from .state_space import NO_B, LinearModel, NonlinearModel, stacks


def check_model(model):
    """A model has to be one of the two kinds."""
    if not isinstance(model, (LinearModel, NonlinearModel)):
        raise TypeError(f"model must be a LinearModel or a NonlinearModel, got {type(model).__name__}")


def check_belief(name, belief, model):
    """A belief has to be a Gaussian with as many components as the model has states."""
    if not isinstance(belief, Gaussian):
        raise TypeError(f"{name} must be a Gaussian, got {type(belief).__name__}")
    if belief.mean.shape[-1] != model.n:
        raise ValueError(f"{name} must have {model.n} components like the model, got {belief.mean.shape[-1]}")


def check_control(model, u):
    """One control input (..., p) has to fit the model."""
    if isinstance(model, LinearModel):
        if model.B is None:
            raise ValueError(NO_B)
        check.shape("u", u, (model.p,))


def check_input(model, u):
    """h(x, u) and H_jacobian(x, u) need an input u."""
    if isinstance(model, NonlinearModel):
        for name in ("h", "H_jacobian"):
            model.inputs(name, u, 0)


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


def check_move(model, x, u=None, std=None, k=0):
    """Do f, F_jacobian and state_residual of a nonlinear model keep to their contract at the states x (..., n)?

    With std (n,), the standard deviations of the first of these states, they are tried at n + 1 states around it, see
    `probe`. Without std, as in single steps, this is done once for each model, and later nothing.
    """
    if isinstance(model, NonlinearModel):
        _try_three(
            model, ("f", "F_jacobian", "state_residual"), (model.move, model.move_slope), model.n, (x, u, std, k)
        )


def check_measure(model, x, u=None, std=None, k=0):
    """The same for h, H_jacobian and residual."""
    check_input(model, u)
    if isinstance(model, NonlinearModel):
        functions = model.measure, model.measure_slope
        _try_three(model, ("h", "H_jacobian", "residual"), functions, model.m, (x, u, std, k))


def _try_three(model, names, functions, size, at):
    """Try f or h, which returns `size` components, its Jacobian and the difference of two of its values."""
    (x, u, std, k), (name, jacobian, residual) = at, names
    task = f"{name}(x)" if u is None else f"{name}(x, u)"
    if std is None and task in model.passed:
        return
    value, slope = (partial(function, k=k) for function in functions)
    first, near = _first_state(model, x, std)
    u = () if u is None else (u,)
    rows = tuple(_inputs(each, model.n + 1) for each in u)
    values = probe.try_near(name, value, (size,), first, near, model.scale, rows)
    at_x = probe.call(name, value, (size,), *map(probe.read_only, (x, *u))) if x.ndim > 1 else values[0]
    check.numbers(f"what {name} returns", at_x)
    if getattr(model, jacobian) is not None:
        probe.try_near(jacobian, slope, (size, model.n), first, near, model.scale, rows)
    if (difference := getattr(model, residual)) is not None:
        probe.try_difference(residual, difference, values.astype(float))
    model.passed.add(task)


def _first_state(model, x, std):
    """The state of the first run, (n,), and how far from it a function is tried."""
    first = x.reshape(-1, model.n)[0]
    return first, 0.01 * np.maximum(abs(first), model.scale) if std is None else std


def _inputs(u, count):
    """Control inputs for `count` states: one (p,) for all, or (count, p) spread over those of all runs."""
    if u.ndim == 1:
        return u
    flat = u.reshape(-1, u.shape[-1])
    return flat[np.linspace(0, len(flat) - 1, count).astype(int)]


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
    check_functions(model, x, u, initial.std)
    return z, u, batch


def check_functions(model, x, u, std):
    """Try a model before a series that starts at the states x (..., n), with std (..., n) and inputs u (..., T, p)."""
    if isinstance(model, LinearModel):
        return
    check_input(model, u)
    near = std.reshape(-1, model.n)[0]
    u = None if u is None else u[..., 0, :]
    check_move(model, x, u, near)
    check_measure(model, model.move(x, u), u, near)


def _series(name, value, width, gaps=False):
    array = check.numbers(name, value, gaps)
    if array.ndim == 1 and width in (1, None):
        array = array[:, None]
    if array.ndim < 2:
        raise ValueError(f"{name} must have shape (..., T, {width or 'any'}), got {check.found_in(array)}")
    if width not in (None, array.shape[-1]):
        raise ValueError(f"{name} must have shape (..., T, {width}), got {check.found_in(array)}")
    return array
