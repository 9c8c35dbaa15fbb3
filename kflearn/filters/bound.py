"""How well can any filter do? The posterior Cramér–Rao bound."""

import numpy as np

from ..core.conditioning import covariance_after, decouple_missing, definite, divide
from ..core.matrices import congruence, step_matrix, symmetric
from ..models import checks as check
from ..models.arguments import check_belief, check_control_series, check_functions, check_model, check_stacks
from .steps import at_step


def cramer_rao_bound(model, x, initial, u=None, z=None) -> np.ndarray:
    """The covariance below which no filter can come on average, at each step.

    The information J is followed along true states: what the readings add is the mean of HᵀR⁻¹H over the runs, with
    the slope H at the true state. For a linear model the bound is the P of the Kalman filter.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states.
    x : array_like (T, n) or (runs, T, n)
        True states, as of `simulate`. One run: the bound along this path for estimates without bias, the P of an
        extended filter whose slopes are taken at the truth. Many runs: their mean information. It is a bound on the
        mean over all that may happen, but where each run hides another direction it can lie far below what is possible;
        then compute each run's alone.
    initial : Gaussian
        The belief one step before the first reading, the same for all runs. The slope of the first move is taken at its
        mean, as nobody tells the states there.
    u : array_like (T, p), optional
        The control inputs, the same for all runs.
    z : array_like (T, m), optional
        Where NaN stands in it nothing is measured; its numbers do not matter. Without it all is measured.

    Returns
    -------
    ndarray (T, n, n)
        The bound after each reading, in the squared units of the states.

    Raises
    ------
    ValueError, TypeError
        Naming the argument. Where F differs from run to run, Q must be positive definite.

    References
    ----------
    P. Tichavský, C. H. Muravchik and A. Nehorai, Posterior Cramér–Rao bounds for discrete-time nonlinear filtering,
    IEEE Transactions on Signal Processing 46, 1998, eq. (21).

    Examples
    --------
    >>> from kflearn import Gaussian, cramer_rao_bound, random_walk, simulate
    >>> model, start = random_walk(1, 4), Gaussian(0, 12)
    >>> bound = cramer_rao_bound(model, simulate(model, start, steps=2, rng=1).x, start)
    >>> print(bound[:, 0, 0].round(2))
    [3.06 2.01]
    """
    check_model(model)
    check_belief("initial", initial, model)
    if initial.batch:
        raise ValueError(f"initial must be the same for all runs, got batch axes {initial.batch}")
    x = check.shape("x", check.numbers("x", x), (None, model.n))
    if x.ndim > 3:
        raise ValueError(f"x must have shape (T, {model.n}) or (runs, T, {model.n}), got {x.shape}")
    x = x.reshape(-1, *x.shape[-2:])
    check_stacks(model, x.shape[-2])
    u = None if u is None else check_control_series(model, u, x.shape[-2])
    check_functions(model, x[:, 0], u, initial.std)
    missing = np.zeros((x.shape[-2], model.m), bool) if z is None else _gaps(model, z, x.shape[-2])
    before = np.concatenate([np.broadcast_to(initial.mean, x[:, :1].shape), x[:, :-1]], axis=1)
    P, found = initial.cov, []
    for k in range(x.shape[-2]):
        F = model.move_slope(before[:, k], at_step(u, k), k)
        P = _before_reading(P, F, step_matrix(model.Q, k))
        H = model.measure_slope(x[:, k], at_step(u, k), k)
        P = _after_reading(P, H, step_matrix(model.R, k), missing[k])
        found.append(P)
    return np.stack(found)


def _gaps(model, z, T):
    """Which components (T, m) are not measured."""
    z = check.numbers("z", z, gaps=True)
    return np.isnan(check.shape("z", z[:, None] if z.ndim == 1 and model.m == 1 else z, (T, model.m), exact=True))


def _before_reading(P, F, Q):
    """The bound after a move: F P Fᵀ + Q; where F differs from run to run, the same with means, by way of J."""
    F = F.reshape(-1, *F.shape[-2:])
    if np.allclose(F, F[:1], rtol=0, atol=1e-6 * abs(F).max()):
        return symmetric(congruence(F[0], P)[0] + Q)
    if not definite(Q):
        raise ValueError("Q must be positive definite where F differs from run to run; of a single run it need not be")
    through = np.linalg.solve(Q, F)  # Q⁻¹F, of each run
    D11, D12 = np.mean(F.mT @ through, axis=0), np.mean(through, axis=0).T
    J = np.linalg.inv(Q) - D12.T @ np.linalg.solve(np.linalg.inv(P) + D11, D12)
    return symmetric(np.linalg.inv(J))


def _after_reading(P, H, R, missing):
    """The bound after a reading: the mean of HᵀR⁻¹H, as one sensor with R = I, so that P may be singular."""
    H = H * ~missing[:, None]
    rows = np.linalg.solve(np.linalg.cholesky(decouple_missing(R, missing)), H)  # of each run a sensor with R = I
    runs = len(rows) if rows.ndim == 3 else 1
    seen = np.linalg.qr(rows.reshape(-1, H.shape[-1]) / np.sqrt(runs), mode="r")
    one = np.eye(len(seen))
    moved, cross = congruence(seen, P)
    return covariance_after(divide(cross, moved + one), P, seen, one)
