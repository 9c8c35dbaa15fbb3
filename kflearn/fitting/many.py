"""Filters of many models at once, each with matrices of its own: what fitting needs of them, and nothing more.

The runs come last: matrices are (rows, columns, *runs), series (T, m, *runs). Axes of runs broadcast.
"""

from typing import NamedTuple

import numpy as np

from ..models.state_space import LinearModel

SURE, OPEN = 1e-10, 1e-13  # of what readings tell, in units in which it is 1: enough digits; nothing but rounding
quiet = np.errstate(all="ignore")  # far from the data much is not finite, and counts as −inf


class Matrices(NamedTuple):
    """The matrices of many models, each (S, rows, columns, *runs); S is 1 where they are the same at all steps."""

    F: np.ndarray
    H: np.ndarray
    Q: np.ndarray
    R: np.ndarray
    B: np.ndarray | None = None

    @classmethod
    def of(cls, model: LinearModel, runs: int = 0) -> "Matrices":
        """Those of one model, with `runs` axes of length 1 for the runs."""
        own = (getattr(model, name) for name in cls._fields)
        return cls(*(None if M is None else _steps_first(M).reshape(*_steps_first(M).shape, *[1] * runs) for M in own))

    def at(self, k):
        """The matrices of step k."""
        return (None if M is None else M[k if len(M) > 1 else 0] for M in self)


class Start(NamedTuple):
    """Where the filters start: at the columns X (n, c, *runs) of a state, with the covariance P (n, n, *runs).

    Of more columns than one, the first sees the data and the others answer to a change of the state at the start, about
    which nothing is known. resting: is this the state at the first step itself, to which nothing moves?
    """

    X: np.ndarray
    P: np.ndarray
    resting: bool

    @classmethod
    def unknown(cls, matrices, z, push) -> "Start":
        """A start about which nothing is known.

        Its first column goes through as many readings as it takes to know the state: so no digits are lost, whatever R.
        It is sought without noise of the states, under which the readings' weights do not differ by powers of ten.
        """
        n, runs = matrices.F.shape[1], z.shape[2:]
        X = np.zeros((n, n + 1, *runs))
        X[range(n), range(1, n + 1)] = 1
        start, still = cls(X, np.zeros((n, n, *[1] * len(runs))), True), matrices._replace(Q=0 * matrices.Q)
        for steps in range(1, len(z) + 1):
            ends = forward(still, z[:steps], push, start)
            if (told := ends.told_of_the_start()) > SURE:
                break
        if not told > OPEN:
            raise ValueError(f"z must determine all {n} states of the model in every series")
        X[:, 0] = ends.start_after()[0]
        return start

    @classmethod
    def known(cls, initial, batch, resting) -> "Start":
        """Gaussians with the axes `batch`, as runs in one row."""
        n = initial.mean.shape[-1]
        mean = np.broadcast_to(initial.mean, (*batch, n)).reshape(-1, n)
        cov = np.broadcast_to(initial.cov, (*batch, n, n)).reshape(-1, n, n)
        return cls(mean.T[:, None], np.moveaxis(cov, 0, -1), resting)


class Kept(NamedTuple):
    """What the way back needs of each step: predicted columns and P, H, S⁻¹ of what was measured, K, S⁻¹ V, and F of
    the step to it."""

    X: np.ndarray
    P: np.ndarray
    H: np.ndarray
    S_inverse: np.ndarray
    gain: np.ndarray
    weighed: np.ndarray
    F: np.ndarray


class Ends(NamedTuple):
    """What a pass forward leaves: Σ Vᵀ S⁻¹ V (c, c, *runs), Σ log det S, how many numbers were measured, all Kept."""

    gram: np.ndarray
    log_det: np.ndarray
    seen: np.ndarray
    kept: list

    @quiet
    def start_after(self):
        """The state at the first measurement, relative to the first column's: mean (n, *runs) and covariance."""
        G = np.moveaxis(self.gram, (0, 1), (-2, -1))
        inverse = _inverse(G[..., 1:, 1:])
        mean = -np.matvec(inverse, G[..., 1:, 0])
        return np.moveaxis(mean, -1, 0), np.moveaxis(inverse, (-2, -1), (0, 1))

    @quiet
    def told_of_the_start(self) -> float:
        """How much the readings tell of the state at the first one, in the direction and the run of which least."""
        inside, _ = self._scaled()
        known = np.isfinite(inside).all(axis=(-2, -1))
        return float(np.linalg.eigvalsh(np.where(known[..., None, None], inside, 0)).min())

    @quiet
    def scatter(self):
        """The mean of the innovations squared, in units of what the filter claims: 1 where its claims are right."""
        return self._parts()[0] / (self.seen - self._n)

    @quiet
    def log_likelihood(self):
        """Of each run, (*runs); a diffuse start counts as in `diffuse_start`. −inf where S is no covariance."""
        rest, log_det = self._parts()
        value = -0.5 * (log_det + rest + (self.seen - self._n) * np.log(2 * np.pi))
        return np.where(np.isfinite(value), value, -np.inf)

    @property
    def _n(self):
        """How many states have no start."""
        return len(self.gram) - 1

    def _parts(self):
        """The sum of the squared innovations and of all log-determinants, once the start is fitted to the data."""
        G = np.moveaxis(self.gram, (0, 1), (-2, -1))
        if not self._n:
            return G[..., 0, 0], self.log_det
        inside, scale = self._scaled()
        right = G[..., 1:, 0] / scale
        sure = np.sum(right * np.linalg.solve(inside, right[..., None])[..., 0], axis=-1)
        return G[..., 0, 0] - sure, self.log_det + np.linalg.slogdet(inside)[1] + 2 * np.log(scale).sum(axis=-1)

    def _scaled(self):
        """What the readings tell of the start (*runs, n, n), in units in which its diagonal is 1, and these units."""
        G = np.moveaxis(self.gram, (0, 1), (-2, -1))[..., 1:, 1:]
        scale = np.sqrt(np.diagonal(G, axis1=-2, axis2=-1))
        inside = G / scale[..., :, None] / scale[..., None, :]
        return np.where(np.isfinite(inside), inside, np.nan), scale


def in_a_row(z, batch):
    """Series (..., T, m) with the axes `batch` as runs in one row, (N, T, m)."""
    return np.broadcast_to(z, (*batch, *z.shape[-2:])).reshape(-1, *z.shape[-2:])


@quiet
def forward(matrices, z, push, start, keep=False) -> Ends:
    """Filter the series z (T, m, *runs), NaN where nothing was measured; push: B u (T, n, *runs), or None.

    Far from the data much is not finite, without a warning: the log-likelihood is −inf there.
    """
    runs = np.broadcast_shapes(z.shape[2:], start.X.shape[2:], *(M.shape[3:] for M in matrices if M is not None))
    X, P = np.broadcast_to(start.X, (*start.X.shape[:2], *runs)), start.P
    gram, log_det, kept, lost = 0.0, 0.0, [], np.isnan(z)
    gaps, known = lost.reshape(len(z), -1).any(axis=1), np.where(lost, 0, z)
    constant = all(M is None or len(M) == 1 for M in matrices)
    step = _Step.of(matrices, 0)
    for k in range(len(z)):
        step = step if constant else _Step.of(matrices, k)
        if k or not start.resting:
            X, P = times(step.F, X), times(times(step.F, P), step.F_T) + step.Q
            if push is not None:
                X[:, 0] += push[k]
        V, cross = times(step.minus_H, X), times(P, step.H_T)
        V[:, 0] += known[k]
        S = step.R - times(step.minus_H, cross)
        if gaps[k]:
            V, cross, S = _without(lost[k], V, cross, S)
        S_inverse, log = inverse_and_log_det(S)
        gain, weighed = times(cross, S_inverse), times(S_inverse, V)
        if keep:
            H = -step.minus_H
            kept.append(
                Kept(X, P, np.where(lost[k, :, None], 0, H) if gaps[k] else H, S_inverse, gain, weighed, step.F)
            )
        gram, log_det = gram + times(transposed(V), weighed), log_det + log
        X, P = X + times(cross, weighed), halves(P - times(gain, transposed(cross)))
    return Ends(gram, log_det, (~lost).sum(axis=(0, 1)), kept)


class _Step(NamedTuple):
    """The matrices of one step, as `forward` needs them."""

    F: np.ndarray
    F_T: np.ndarray
    minus_H: np.ndarray
    H_T: np.ndarray
    Q: np.ndarray
    R: np.ndarray

    @classmethod
    def of(cls, matrices, k):
        F, H, Q, R, _ = matrices.at(k)
        return cls(F, transposed(F), -H, transposed(H), Q, R)


def _without(lost, V, cross, S):
    """Innovations, cross-covariance and S without the components (m, *runs) that are lost."""
    pair = lost[:, None] | lost
    eye = np.eye(len(S)).reshape(*S.shape[:2], *[1] * (S.ndim - 2))
    return np.where(lost[:, None], 0, V), np.where(lost, 0, cross), np.where(pair, eye, S)


def times(A, B):
    """Products of matrices: A (a, b, *runs) with B (b, c, *runs)."""
    return A * B if A.shape[1] == 1 else np.einsum("ab...,bc...->ac...", A, B)


def transposed(A):
    """Aᵀ for A (a, b, *runs)."""
    return A.swapaxes(0, 1)


def halves(P):
    """The symmetric part: without it rounding errors would grow from step to step."""
    return P if len(P) == 1 else (P + transposed(P)) / 2


def inverse_and_log_det(S):
    """S⁻¹ (m, m, *runs) and log det S (*runs); NaN where S is not positive."""
    if len(S) == 1:
        return 1 / S, np.log(S[0, 0])
    first = np.moveaxis(S, (0, 1), (-2, -1))
    sign, log = np.linalg.slogdet(first)
    return np.moveaxis(_inverse(first), (-2, -1), (0, 1)), np.where(sign > 0, log, np.nan)


def _inverse(A):
    """A⁻¹ (..., n, n) for positive definite A, in units in which its diagonal is 1; NaN where there is none."""
    scale = np.sqrt(np.diagonal(A, axis1=-2, axis2=-1))
    A = A / scale[..., :, None] / scale[..., None, :]
    good = np.isfinite(A).all(axis=(-2, -1)) & (abs(np.linalg.det(np.where(np.isfinite(A), A, 0))) > 0)
    inverse = np.linalg.inv(np.where(good[..., None, None], A, np.eye(A.shape[-1])))
    return np.where(good[..., None, None], inverse, np.nan) / scale[..., :, None] / scale[..., None, :]


def _steps_first(M):
    """A matrix, or a stack of one a step, as (S, rows, columns)."""
    return M[None] if M.ndim == 2 else M
