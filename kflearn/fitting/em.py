"""Expectation–maximisation: smooth with a model, take from the smoothed states the model they speak for, and again."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..core.frozen import Frozen
from ..models import checks as check
from ..models.arguments import check_series
from ..models.gaussian import Gaussian
from ..models.state_space import LinearModel
from .many import Matrices, Start, forward, halves, in_a_row, times, transposed

FREE = ("Q", "R", "F", "H")


@dataclass(frozen=True, eq=False, repr=False)
class Learnt(Frozen):
    """What `em` found.

    model: the last model; of many series its free matrices are stacks (..., 1, rows, columns), one for each series.
    log_likelihood: under the model before each round, and under the last, (..., rounds + 1); it never falls.
    converged: whether the last round added less than `tolerance` to every series.
    """

    model: LinearModel
    log_likelihood: np.ndarray
    converged: bool

    def __repr__(self):
        rounds, last = self.log_likelihood.shape[-1] - 1, self.log_likelihood[..., -1]
        said = f"log-likelihood {last:.4f}" if np.ndim(last) == 0 else f"{last.size} series"
        return f"Learnt({said} after {rounds} rounds; {'at rest' if self.converged else 'NOT yet at rest'})"


class Smoothed(NamedTuple):
    """The states given all readings: means (T, n, *runs), covariances (T, n, n, *runs), and the covariances of each
    state with the one before, Cov(x_k, x_{k−1}), (T − 1, n, n, *runs)."""

    mean: np.ndarray
    cov: np.ndarray
    lag_one: np.ndarray


def smoothed(ends) -> Smoothed:
    """The way back through what `forward` kept: r and N gather what later readings say (de Jong 1989)."""
    kept = ends.kept
    columns = kept[0].X.shape[1]
    r, N, later = 0 * kept[-1].X, 0 * kept[-1].P, None
    parts = []
    for k in range(len(kept) - 1, -1, -1):
        X, P, H, S_inverse, gain, weighed, F = kept[k]
        stays = identity_like(P) - times(gain, H)
        if later is None:
            lag = None
        else:
            L = times(later[0], stays)  # how an error before this reading moves on to the next step
            lag = times(identity_like(P) - times(later[1], N), times(L, P))
            r, N = times(transposed(L), r), times(times(transposed(L), N), L)
        r = r + times(transposed(H), weighed)
        N = N + times(times(transposed(H), S_inverse), H)
        parts.append((X + times(P, r), P - times(times(P, N), P), lag))
        later = F, P
    means, covs, lags = zip(*parts[::-1], strict=True)
    X, cov, lag = np.stack(means), np.stack(covs), np.stack(lags[:-1])
    if columns == 1:
        return Smoothed(X[:, :, 0], cov, lag)
    known, spread = ends.start_after()
    answer = X[:, :, 1:]
    mean = X[:, :, 0] + np.einsum("tnc...,c...->tn...", answer, known)
    wide = np.einsum("tnc...,cd...->tnd...", answer, spread)
    both = "tnd...,tmd...->tnm..."
    return Smoothed(mean, cov + np.einsum(both, wide, answer), lag + np.einsum(both, wide[1:], answer[:-1]))


def identity_like(P):
    """The identity matrix (n, n, 1, …) beside P (n, n, *runs)."""
    return np.eye(len(P)).reshape(*P.shape[:2], *[1] * (P.ndim - 2))


def em(model, z, initial=None, u=None, *, free=("Q", "R"), rounds=1000, tolerance=1e-8) -> Learnt:
    """Q and R, and F and H where asked for, by expectation–maximisation: every round makes the readings more probable.

    Parameters
    ----------
    model : LinearModel
        Where to start; matrices that are not free stay as they are. Free ones are constant in time, and all their
        entries are free: where Q has a structure (a variance times a matrix), use `fit`.
    z : array_like
        Measurements (..., T, m), or (T,) when m = 1; NaN: not measured. Each series of a batch gets its own model.
    initial : Gaussian, optional
        The belief one step before the first measurement. Without it nothing is known at the first measurement.
    u : array_like, optional
        Control inputs (T, p), the same for all series.
    free : sequence of str
        Which matrices are learnt, of "Q", "R", "F", "H".
    rounds : int
        At most so many.
    tolerance : float
        Stop when a round adds less to the log-likelihood of every series.

    Returns
    -------
    Learnt

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Shumway and Stoffer 1982; Dempster, Laird and Rubin 1977.

    Examples
    --------
    >>> from kflearn import em, random_walk
    >>> steps = [0.0, 1.2, 0.7, 2.1, 2.9, 2.2, 3.8, 5.1, 4.6, 6.0]
    >>> em(random_walk(1, 1), steps, rounds=20).log_likelihood.shape
    (21,)
    """
    task = Task.of(model, z, initial, u, free)
    rounds = check.whole_number("rounds", rounds, least=1)
    matrices, values, rest = Matrices.of(model, runs=1), [], False
    for _ in range(rounds):
        ends = task.forward(matrices)
        values.append(ends.log_likelihood())
        if len(values) == 1 and not np.isfinite(values[0]).all():
            raise ValueError(f"z must determine all {model.n} states of the model in every series")
        if rest := len(values) > 1 and bool((values[-1] - values[-2] < tolerance).all()):
            break
        matrices = task.better(matrices, smoothed(ends))
    else:
        values.append(task.forward(matrices).log_likelihood())
    return task.told(matrices, np.array(values), rest)


class Task:
    """The series to learn from, z (T, m, N), and where their filters start: at the first of these steps."""

    def __init__(self, model, z, push, start, free, batch):
        self.model, self.z, self.push, self.start, self.free, self.batch = model, z, push, start, free, batch

    @classmethod
    def of(cls, model, z, initial, u, free):
        """After the arguments were looked at."""
        if not isinstance(model, LinearModel):
            raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
        if isinstance(free, str) or not free or set(free) - set(FREE):
            raise ValueError(f"free must list some of {', '.join(FREE)}, got {free!r}")
        n = model.n
        z, u, batch = check_series(model, z, Gaussian(np.zeros(n), np.eye(n)) if initial is None else initial, u)
        z, push = in_a_row(z, batch), None if u is None else np.matvec(model.B, u)[..., None]
        if initial is None:
            start = Start.unknown(Matrices.of(model, runs=1), np.moveaxis(z, 0, -1), push)
        else:  # one step earlier, at which nothing was measured
            z = np.concatenate([np.full_like(z[:, :1], np.nan), z], axis=1)
            push = None if push is None else np.concatenate([0 * push[:1], push])
            start = Start.known(initial, batch, resting=True)
        return cls(model, np.moveaxis(z, 0, -1), push, start, free, batch)

    def forward(self, matrices):
        """Filter all series."""
        return forward(matrices, self.z, self.push, self.start, keep=True)

    def better(self, matrices, states):
        """The matrices under which the smoothed states and the readings are most probable together."""
        F, H, Q, R, B = matrices
        x, cov, lag = states
        moved = x[1:] if self.push is None else x[1:] - self.push[1:]
        if "F" in self.free:
            F = _quotient(outer(moved, x[:-1]) + lag, outer(x[:-1], x[:-1]) + cov[:-1])
        if "Q" in self.free:
            step = F[1:] if len(F) > 1 else F
            e, back = moved - np.einsum("tij...,tj...->ti...", step, x[:-1]), chain(step, lag.swapaxes(1, 2))
            noise = outer(e, e) + cov[1:] - back - back.swapaxes(1, 2) + congruent(step, cov[:-1])
            Q = halves(noise.mean(axis=0))[None]
        if "H" in self.free:
            H = self._measured_by(x, cov)
        if "R" in self.free:
            R = self._measured_with(H, R, x, cov)
        return Matrices(F, H, Q, R, B)

    def _measured_by(self, x, cov):
        """H, row by row from the steps at which its component was measured."""
        seen = ~np.isnan(self.z)
        z, both = np.where(seen, self.z, 0), outer(x, x) + cov
        rows = [_quotient(outer(z[:, [i]], x), both * seen[:, i, None, None]) for i in range(self.model.m)]
        return np.concatenate(rows, axis=1)

    def _measured_with(self, H, R, x, cov):
        """R from what is left of the readings; of what was not measured it says what its neighbours say."""
        lost = np.isnan(self.z)
        e = np.where(lost, 0, self.z - np.einsum("tij...,tj...->ti...", H, x))
        noise = outer(e, e) + congruent(H, cov)
        some = (~lost).any(axis=1)
        for k in np.flatnonzero((lost & some[:, None]).any(axis=(1, 2))):
            noise[k] = _filled(noise[k], R[k if len(R) > 1 else 0], lost[k])
        return halves(np.sum(noise * some[:, None, None], axis=0) / some.sum(axis=0))[None]

    def told(self, matrices, values, rest):
        """The Learnt that belongs to the last matrices."""
        learnt = {name: np.moveaxis(getattr(matrices, name), -1, 0) for name in self.free}
        shaped = {name: M.reshape(*self.batch, *M.shape[1:]) if self.batch else M[0, 0] for name, M in learnt.items()}
        values = np.moveaxis(values, 0, -1).reshape(*self.batch, -1)
        return Learnt(self.model.replace(**shaped), values, rest)


def outer(a, b):
    """Products a bᵀ of vectors (T, i, *runs) and (T, j, *runs)."""
    return np.einsum("ti...,tj...->tij...", a, b)


def chain(A, B):
    """Products of matrices (T or 1, i, j, *runs) and (T, j, k, *runs)."""
    return np.einsum("tij...,tjk...->tik...", A, B)


def congruent(A, P):
    """A P Aᵀ at every step."""
    return chain(chain(A, P), np.broadcast_to(A.swapaxes(1, 2), (len(P), *A.swapaxes(1, 2).shape[1:])))


def _quotient(A, B):
    """Σ A (Σ B)⁻¹ over time, (1, i, j, *runs)."""
    A, B = (np.moveaxis(M.sum(axis=0), (0, 1), (-2, -1)) for M in (A, B))
    return np.moveaxis(np.linalg.solve(B, A.mT).mT, (-2, -1), (0, 1))[None]


def _filled(noise, R, lost):
    """E[v vᵀ] (m, m, N) at a step where some components are lost, from that of the others and their covariance R."""
    R = np.moveaxis(np.broadcast_to(R, noise.shape), -1, 0)
    noise, lost = np.moveaxis(noise, -1, 0), lost.T
    pair = lost[:, :, None] | lost[:, None, :]
    seen = np.where(pair, np.eye(len(R[0])), R)
    M = np.linalg.solve(seen, np.where(lost[:, :, None], 0, R)).mT * ~lost[:, None, :]
    filled = M @ np.where(pair, 0, noise) @ M.mT + R - M @ np.where(lost[:, :, None], 0, R)
    return np.moveaxis(filled, 0, -1)
