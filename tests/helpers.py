"""Random models and plain formulas that several test files share."""

import numpy as np

from kflearn import Gaussian, LinearModel, NonlinearModel


def random_covariance(rng, n, rank=None):
    """A covariance of the given rank (full without it) with entries around 1."""
    A = rng.normal(size=(n, n if rank is None else rank))
    return A @ A.T + (0.05 * np.eye(n) if rank is None else 0)


def random_model(rng, n, m, p=0, steps=None, fastest=1.05):
    """A LinearModel whose state neither dies out nor explodes at once: it grows by `fastest` a step at most.

    With `steps`, all its matrices are stacks.
    """

    def one():
        F = rng.normal(size=(n, n))
        F *= rng.uniform(0.7, fastest) / max(abs(np.linalg.eigvals(F)))
        H, B = rng.normal(size=(m, n)), rng.normal(size=(n, p)) if p else None
        return F, H, random_covariance(rng, n), random_covariance(rng, m), B

    if steps is None:
        return LinearModel(*one())
    F, H, Q, R, B = zip(*(one() for _ in range(steps)), strict=True)
    return LinearModel(np.stack(F), np.stack(H), np.stack(Q), np.stack(R), np.stack(B) if p else None)


def random_belief(rng, n):
    return Gaussian(rng.normal(size=n), random_covariance(rng, n))


def with_gaps(rng, z, fraction=0.3):
    """The same measurements with NaN in some places."""
    return np.where(rng.random(z.shape) < fraction, np.nan, z)


def as_nonlinear(model):
    """The same linear model, dressed up as functions."""
    F, H, B = model.F, model.H, model.B
    return NonlinearModel(
        lambda x, *u: x @ F.T + (u[0] @ B.T if u else 0),
        lambda x: x @ H.T,
        model.Q,
        model.R,
        F_jacobian=lambda x, *u: F,
        H_jacobian=lambda x: H,
    )


def bent(model, bend=0.3):
    """A nonlinear model near a linear one, with Jacobians."""
    F, H, B = model.F, model.H, model.B
    return NonlinearModel(
        lambda x, *u: (x + bend * np.sin(x)) @ F.T + (u[0] @ B.T if u else 0),
        lambda x: (x + bend * np.cos(x)) @ H.T,
        model.Q,
        model.R,
        F_jacobian=lambda x, *u: F * (1 + bend * np.cos(x))[..., None, :],
        H_jacobian=lambda x: H * (1 - bend * np.sin(x))[..., None, :],
    )


def matrices_at(model, k):
    """F, H, Q, R and B of one step, whether the model has stacks of them or one for all steps."""
    return [M if M is None or M.ndim == 2 else M[k] for M in (model.F, model.H, model.Q, model.R, model.B)]


def textbook(model, z, initial, u=None):
    """Eqs (5)–(9) as they stand in every book, one series, one step after the other. NaN rows are predict only.

    Returns filtered means, covariances, gains, predicted means and covariances, S, and the log-likelihood.
    """
    x, P, steps, log_likelihood = initial.mean, initial.cov, [], 0.0
    for k in range(len(z)):
        F, H, Q, R, B = matrices_at(model, k)
        x = F @ x + (0 if u is None else B @ u[k])
        P = F @ P @ F.T + Q
        x_predicted, P_predicted = x, P
        seen = ~np.isnan(z[k])
        H, R = H[seen], R[np.ix_(seen, seen)]
        S = H @ P @ H.T + R
        K = P @ H.T @ np.linalg.inv(S)
        y = z[k][seen] - H @ x
        x = x + K @ y
        P = (np.eye(len(x)) - K @ H) @ P
        log_likelihood -= 0.5 * (y @ np.linalg.inv(S) @ y + np.log(np.linalg.det(2 * np.pi * S)))
        steps.append((x, P, x_predicted, P_predicted))
    return *(np.stack(series) for series in zip(*steps, strict=True)), log_likelihood


def least_squares(model, z, initial, u=None):
    """All states of one series at once: the start, every move and every measurement are one row each of a weighted
    least-squares problem. Returns means (T, n) and covariances (T, n, n)."""
    T, n = len(z), model.n
    rows, right = [], []

    def add(blocks, value, cov):
        weight = np.linalg.inv(np.linalg.cholesky(cov))
        row = np.zeros((len(value), (T + 1) * n))
        for k, matrix in blocks.items():
            row[:, k * n : (k + 1) * n] = matrix
        rows.append(weight @ row)
        right.append(weight @ value)

    add({0: np.eye(n)}, initial.mean, initial.cov)
    for k in range(T):
        F, H, Q, R, B = matrices_at(model, k)
        add({k: -F, k + 1: np.eye(n)}, np.zeros(n) if u is None else B @ u[k], Q)
        seen = ~np.isnan(z[k])
        if seen.any():
            add({k + 1: H[seen]}, z[k][seen], R[np.ix_(seen, seen)])
    A = np.concatenate(rows)
    x = np.linalg.lstsq(A, np.concatenate(right))[0].reshape(T + 1, n)
    cov = np.linalg.inv(A.T @ A).reshape(T + 1, n, T + 1, n)
    return x[1:], np.stack([cov[k, :, k] for k in range(1, T + 1)])


def close(found, expected, tolerance=1e-9):
    """Equal to within `tolerance` of the largest expected number; NaN only where NaN is expected."""
    expected = np.asarray(expected)
    size = np.nanmax(abs(expected)) if np.isfinite(expected).any() else 0
    np.testing.assert_allclose(found, expected, rtol=0, atol=tolerance * size)


def same_track(found, expected, tolerance=1e-9):
    """All that two tracks say is the same, covariances and gains compared after broadcasting."""
    close(found.mean, expected.mean, tolerance)
    close(found.predicted.mean, expected.predicted.mean, tolerance)
    close(found.innovation.mean, expected.innovation.mean, tolerance)
    close(found.nis, expected.nis, tolerance)
    close(found.log_likelihood, expected.log_likelihood, tolerance)
    for of in (lambda t: t.cov, lambda t: t.predicted.cov, lambda t: t.innovation.cov, lambda t: t.gain):
        one, other = of(found), of(expected)
        shape = np.broadcast_shapes(one.shape, other.shape)
        close(np.broadcast_to(one, shape), np.broadcast_to(other, shape), tolerance)
