"""Filter, log-likelihood and smoother in 80 digits: by these the package's own are judged where doubles lose digits.

Arrays of Python's Decimal numbers; one series, constant matrices, the covariance form as in every book. Nothing is
inverted but S: the smoother goes backwards with what the later innovations say (de Jong 1989; Bryson and Frazier 1963),
so that exact states, Q = 0 and a singular P⁻ are like any other.
"""

from dataclasses import dataclass
from decimal import Decimal, localcontext
from functools import cached_property
from typing import NamedTuple

import numpy as np

DIGITS = 80
LOG_2_PI = (2 * Decimal("3.14159265358979323846264338327950288419716939937510582097494")).ln()

exact = np.frompyfunc(Decimal, 1, 1)
_root = np.frompyfunc(lambda variance: max(variance, Decimal(0)).sqrt(), 1, 1)


class Step(NamedTuple):
    """One step: x⁻, P⁻, x, P, the innovation, H of what was measured, HᵀS⁻¹, K, S beside R, its part of log L."""

    predicted_mean: np.ndarray
    predicted: np.ndarray
    mean: np.ndarray
    cov: np.ndarray
    y: np.ndarray
    H: np.ndarray
    weight: np.ndarray
    gain: np.ndarray
    ratio: float
    log: Decimal


@dataclass(frozen=True)
class Answer:
    """Means and standard deviations (T, n) of Decimals, filtered and smoothed, from all steps and F."""

    steps: list[Step]
    F: np.ndarray

    @cached_property
    def filtered(self):
        """Means and standard deviations after each measurement."""
        return np.stack([step.mean for step in self.steps]), np.stack([_std(step.cov) for step in self.steps])

    @cached_property
    def smoothed(self):
        """Means and standard deviations given all measurements."""
        with localcontext(prec=DIGITS):
            mean, std = zip(*backwards(self.F, self.steps), strict=True)
        return np.stack(mean), np.stack(std)

    @cached_property
    def log_likelihood(self):
        """The logarithm of the probability density of the series."""
        return float(sum(step.log for step in self.steps))

    @cached_property
    def surprise(self):
        """The largest S beside R, in any direction, of all steps."""
        return max((step.ratio for step in self.steps if len(step.y)), default=0.0)


def answer(model, z, start) -> Answer:
    """What is true of a LinearModel and a series z (T, m), NaN where nothing was measured."""
    F, H, Q, R = (exact(M) for M in (model.F, model.H, model.Q, model.R))
    x, P, steps = exact(start.mean), exact(start.cov), []
    with localcontext(prec=DIGITS):
        for reading in z:
            steps.append(one_step(F @ x, F @ P @ F.T + Q, H, R, reading))
            x, P = steps[-1].mean, steps[-1].cov
    return Answer(steps, F)


def one_step(x, P, H, R, reading) -> Step:
    """Equations (7) to (9) for the prediction x, P."""
    seen = ~np.isnan(reading)
    H, R = H[seen], R[np.ix_(seen, seen)]
    y = exact(reading[seen]) - H @ x
    cross = P @ H.T
    S = H @ cross + R
    inverse, pivots = inverted(S)
    gain = cross @ inverse
    log = -(y @ inverse @ y + sum(pivot.ln() for pivot in pivots) + len(y) * LOG_2_PI) / 2 if len(y) else Decimal(0)
    return Step(x, P, x + gain @ y, P - gain @ cross.T, y, H, H.T @ inverse, gain, ratio(S, R), log)


def backwards(F, steps):
    """Smoothed means and standard deviations of all steps: r and N gather what this and later innovations say of x⁻."""
    r, N, found = F[0] * 0, F * 0, []
    for step in reversed(steps):
        K, H, P = step.gain, step.H, step.predicted
        r = step.weight @ step.y + r - H.T @ (K.T @ r)  # r ← HᵀS⁻¹y + (I − KH)ᵀ r
        N = N - (N @ K) @ H
        N = step.weight @ H + N - H.T @ (K.T @ N)
        found.append((step.predicted_mean + P @ r, _root(np.diagonal(P) - ((P @ N) * P).sum(axis=1))))
        r, N = F.T @ r, F.T @ N @ F
    return found[::-1]


def _std(P):
    with localcontext(prec=DIGITS):
        return _root(np.diagonal(P))


def inverted(S):
    """The inverse of a covariance by elimination, and the pivots, whose product is the determinant."""
    m = len(S)
    A, pivots = np.concatenate([S, exact(np.eye(m))], axis=1), []
    for i in range(m):
        pivots.append(A[i, i])
        A[i] = A[i] / A[i, i]
        for j in range(m):
            if j != i:
                A[j] = A[j] - A[j, i] * A[i]
    return A[:, m:], pivots


def ratio(S, R) -> float:
    """The largest eigenvalue of R⁻¹S."""
    L = np.linalg.inv(np.linalg.cholesky(R.astype(float))) if len(R) else np.zeros((1, 0))
    return np.linalg.eigvalsh(L @ S.astype(float) @ L.T).max()


def off_by(belief, right):
    """How far means (T, n) and standard deviations are off: the largest |mean − right| / sd and |sd / right sd − 1|.

    What is known exactly is judged in millionths of its size.
    """
    mean, std = right
    with localcontext(prec=DIGITS):
        known = std == 0
        unit = np.where(known, abs(mean) * Decimal("1e-6"), std)
        means = abs(exact(belief.mean) - mean) / unit
        stds = abs(exact(np.sqrt(belief.variance)) / unit - np.where(known, 0, 1))
    return float(means.max()), float(stds.max())


def finest(right):
    """How well a double can hold the means at all, in standard deviations: the largest ε |mean| / sd."""
    mean, std = (part.astype(float) for part in right)
    return np.max(np.finfo(float).eps * abs(mean) / np.where(std > 0, std, np.inf))
