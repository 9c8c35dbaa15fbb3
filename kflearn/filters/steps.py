"""One step at a time: predict and correct, and how a filter may start from a measurement.

`correct` is Gaussian conditioning: K = C S⁻¹ with the cross-covariance C of state and measurement. For a linear model
C = P⁻Hᵀ, and these are eqs (5)–(9). The letters are explained in `kalman`.
"""

from math import isfinite
from typing import Literal, overload

import numpy as np

from ..core.conditioning import covariance_after, definite, divide, without_missing
from ..core.matrices import compact, matvec, step_matrix, symmetric, with_batch
from ..models import checks as check
from ..models.arguments import check_belief, check_control, check_measure, check_model, check_move, check_step
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.jumps import watched
from ..models.state_space import LinearModel, NonlinearModel
from ..results.track import read_only
from .gate import Correction, beyond, gate_limits
from .moments import check_through, linearize, refuse_negative
from .start import start_from


def predict(model, belief, u=None, *, k=0, through=linearize) -> Gaussian:
    """The belief one step later, before its measurement: eqs (5) and (6).

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states.
    belief : Gaussian
        Mean (..., n), in the units of the states.
    u : array_like, optional
        The control input, (p,) or (..., p), or a number when p = 1.
    k : int
        The step, counted from 0; it matters for models whose matrices change with time.
    through : callable
        How the belief goes through f: linearize, unscented(n) or cubature(n).

    Returns
    -------
    Gaussian
        Read-only; its mean and its covariance have the batch axes of all arguments together.

    Raises
    ------
    ValueError, TypeError
        Naming the argument, where the pieces do not fit or f returns NaN.

    References
    ----------
    Kalman 1960; Bar-Shalom, Li and Kirubarajan 2001, ch. 5.2.

    Examples
    --------
    >>> from kflearn import Gaussian, cart, predict
    >>> later = predict(cart(dt=1, mass=1, Q=[[4, 0], [0, 0]], R=1), Gaussian([50, 10], [[1, 0], [0, 0]]))
    >>> print(f"{later:.0f}")
    N([60, 10], [[5, 0], [0, 0]])
    """
    check_model(model)
    check_through(through)
    check_belief("belief", belief, model)
    axes = check_step(model, k)
    u = _control(model, u, axes)
    belief = _with_a_mean_each(belief, check.batches(belief=belief.batch, **axes))
    check_move(model, belief.mean, u, k=k)
    return read_only(predicted_belief(model, belief, u, k, through), series=False)


@overload
def correct(model, belief, z, *, u=..., k=..., through=..., gate=..., details: Literal[False] = ...) -> Gaussian: ...


@overload
def correct(model, belief, z, *, u=..., k=..., through=..., gate=..., details: Literal[True]) -> Correction: ...


def correct(model, belief, z, *, u=None, k=0, through=linearize, gate=None, details=False) -> Gaussian | Correction:
    """The belief after the measurement z: eqs (7)–(9).

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states, of which m components are measured.
    belief : Gaussian
        What was predicted, mean (..., n).
    z : array_like
        (m,) or (..., m), or a number when m = 1; NaN marks components that were not measured.
    u, k, through
        As in predict; u is for h(x, u).
    gate : float, optional
        A probability such as 0.99: a reading is refused, and the belief stays what was predicted, where its NIS is
        larger than this share of honest readings would have it. Without it every reading is used.
    details : bool
        Whether to return what was computed on the way too.

    Returns
    -------
    Gaussian, or with details a Correction (belief, innovation, gain, refused)
        Read-only; mean and covariance have the batch axes of all arguments together. The innovation is a Gaussian with
        mean z − ẑ and covariance S.

    Raises
    ------
    ValueError, TypeError
        Naming the argument, where the pieces do not fit or h returns NaN.

    References
    ----------
    Kalman 1960; Bar-Shalom, Li and Kirubarajan 2001, ch. 5.2.

    Examples
    --------
    >>> from kflearn import Gaussian, correct, random_walk
    >>> print(f"{correct(random_walk(1, 1), Gaussian(60, 5), 62):.3f}")
    N(61.667, 0.833)
    >>> far = correct(random_walk(1, 1), Gaussian(60, 5), 72, gate=0.99, details=True)
    >>> print(f"{far.belief:.0f}, innovation {far.innovation:.0f}, refused: {far.refused}")
    N(60, 5), innovation N(12, 6), refused: True
    """
    check_model(model)
    check_through(through)
    check_belief("belief", belief, model)
    axes, limits = check_step(model, k), gate_limits(gate, model.m)
    z = check.shape("z", np.atleast_1d(check.numbers("z", z, gaps=True)), (model.m,))
    u = _control(model, u, axes)
    batch = check.batches(belief=belief.batch, z=z.shape[:-1], **axes)
    belief = _with_a_mean_each(belief, batch)
    check_measure(model, belief.mean, u, k=k)
    after, innovation, gain, refused = corrected_belief(model, belief, z, k, through, u, limits)
    after = read_only(after, series=False)
    if not details:
        return after
    gain, refused = with_batch(gain, batch), np.broadcast_to(False if refused is None else refused, batch)
    gain.flags.writeable = False
    return Correction(after, read_only(innovation, series=False), gain, refused)


def kalman_step(z, R, x=None, P=None, F=None, H=None, Q=None, B=None, u=None) -> Gaussian:
    """One step with defaults, as the published `kalmanf` meant it: predict with F, Q, B and u, correct with z.

    Parameters
    ----------
    z, R : array_like
        The measurement (m,) and its covariance (m, m).
    x, P : array_like, optional
        The belief before the step, (n,) and (n, n). Without both, the filter starts from the measurement as in
        start_from, and nothing is predicted.
    F, H, Q, B, u : array_like, optional
        F and H default to the identity, Q to zero.

    Returns
    -------
    Gaussian
        The belief after the step.

    Raises
    ------
    ValueError
        When the start is known only in part (x without P, NaN in x), or when H cannot be inverted.

    Examples
    --------
    >>> from kflearn import kalman_step
    >>> print(f"{kalman_step(62, 1, x=60, P=5):.3f}")
    N(61.667, 0.833)
    """
    z = np.atleast_1d(check.numbers("z", z, gaps=True))
    H = np.eye(z.shape[-1]) if H is None else check.matrix("H", H, z.shape[-1], None)
    n = H.shape[-1]
    model = LinearModel(np.eye(n) if F is None else F, H, np.zeros((n, n)) if Q is None else Q, R, B)
    if x is None and P is None:
        return start_from(model, z)
    if x is None or P is None:
        missing, given = ("x", "P") if x is None else ("P", "x")
        raise ValueError(f"{missing} must be given together with {given}: give both, or neither to start from z")
    x = check.shape("x", np.atleast_1d(check.numbers("x", x, gaps=True)), (n,))
    if np.isnan(x).any():
        raise ValueError("x must be known completely, found NaN: leave out x and P to start from z")
    return correct(model, predict(model, Gaussian(x, check.covariance("P", P, n)), u), z)


def starting_belief(initial, batch):
    """The initial belief with a mean and a covariance for every run."""
    n = initial.mean.shape[-1]
    return unchecked_gaussian(np.broadcast_to(initial.mean, (*batch, n)), np.broadcast_to(initial.cov, (*batch, n, n)))


def at_step(series, k):
    """Row k of a series (..., T, p), or None where there is no series."""
    return None if series is None else series[..., k, :]


def along(model, name, function, x, u, axis=-2, first=0):
    """One of a model's functions at states of successive steps, x (..., T, n), the first of which is `first`.

    name: which of f, h and their Jacobians it is; axis: where the axis of the steps goes, -3 for matrices. All steps
    are computed at once, where none has a function of its own.
    """
    if not model.by_steps(name, name[0].lower()):
        return function(x, u, None)  # no single step
    values = [function(x[..., k, :], at_step(u, k), k + first) for k in range(x.shape[-2])]
    return np.stack(np.broadcast_arrays(*values), axis=axis)


def predicted_belief(model, belief, u, k, through, Q=None):
    """The belief one step later, nothing checked but what f returns; Q: in place of the model's own."""
    difference = watched(model, "f", belief.mean, u, k)
    moved = through(belief, lambda x: model.move(x, u, k), lambda x: model.move_slope(x, u, k), difference)
    # A quick test: a sum is finite only if all its terms are.
    if isinstance(model, NonlinearModel) and not isfinite(moved.mean.sum()):
        _check_finite("f", moved.mean, belief, k)
    Q = step_matrix(model.Q, k) if Q is None else Q
    P = symmetric(moved.cov + Q)
    refuse_negative("P⁻", P, through, k, moved.cov, moved.rest, Q)
    return unchecked_gaussian(moved.mean, P)


def corrected_belief(model, predicted, z, k, through, u=None, limits=None):
    """The Correction by a measurement; arguments are not checked. limits: of the gate."""
    expected, innovation = expected_measurement(model, predicted, z, k, through, u)
    made = condition(predicted, expected, innovation, step_matrix(model.R, k), k, limits)
    refuse_negative("P⁺", made.belief.cov, through, k, predicted.cov)
    return made


def expected_measurement(model, predicted, z, k, through, u=None):
    """What the measurement should be, Moments without its noise, and the innovation z − ẑ."""
    difference = watched(model, "h", predicted.mean, u, k)
    expected = through(predicted, lambda x: model.measure(x, u, k), lambda x: model.measure_slope(x, u, k), difference)
    return expected, difference(z, expected.mean)


def condition(predicted, expected, innovation, R, k, limits=None):
    """Gaussian conditioning on the measurement of step k, a Correction; without limits its `refused` is None."""
    full = S = expected.cov + R
    cross, y, missing, refused = expected.cross, innovation, np.isnan(innovation), None
    if missing.any():
        _check_finite("h", expected.mean, predicted, k)
        S, cross = without_missing(missing, S, cross)
        y = np.where(missing, 0, y)
    if not definite(S).all():
        refuse_innovation(k)
    gain, innovation = divide(cross, S), unchecked_gaussian(innovation, full)
    if limits is not None:
        refused = beyond(limits, innovation)
        gain = np.where(refused[..., None, None], 0, gain)
    P = covariance_after(gain, predicted.cov, expected.slope, R + expected.rest, expected.basis)
    return Correction(unchecked_gaussian(predicted.mean + matvec(gain, y), P), innovation, gain, refused)


def refuse_innovation(k):
    """Say that S of step k is no covariance, and what to do."""
    raise ValueError(
        f"R must be larger beside P: at step {k} S = H P⁻ Hᵀ + R is singular or negative in rounded numbers. If P is "
        "huge, start with diffuse_start or use square_root_kalman_filter; if two components measure nearly the same, "
        "leave one out; sigma points need kappa of at least 0, or beta = 2"
    )


def _check_finite(name, values, belief, k):
    """A function of finite states has to return finite numbers: NaN would pass for "not measured" later on."""
    odd = values[~np.isfinite(values)]
    if odd.size and np.isfinite(belief.mean).all():
        raise ValueError(f"{name} must return finite numbers, found {odd[0]} at step {k}")


def _control(model, u, axes):
    """The control input of one step (..., p), after it was looked at; its batch axes are added to `axes`."""
    if u is not None:
        u = np.atleast_1d(check.numbers("u", u))
        check_control(model, u)
        axes["u"] = u.shape[:-1]
    return u


def _with_a_mean_each(belief, batch):
    """The same belief with a mean for every run; its covariance stays shared where it is."""
    return unchecked_gaussian(np.broadcast_to(belief.mean, (*batch, belief.mean.shape[-1])), compact(belief.cov))
