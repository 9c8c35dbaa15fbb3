"""A Kalman filter that learns R, or the size of Q, from its own innovations."""

from dataclasses import dataclass, field

import numpy as np

from . import _checks as check
from .arguments import check_model, check_series
from .conditioning import divide_safely
from .filtering import _predict, along, condition, expect
from .gaussian import symmetric, trusted
from .models import at
from .moments import linearize, spread
from .results import Track


@dataclass(frozen=True, eq=False)
class AdaptiveTrack(Track):
    """A Track and the noise it was made with: R (..., T, m, m) and Q (..., T, n, n), at each step."""

    R: np.ndarray = field(default=None, repr=False)
    Q: np.ndarray = field(default=None, repr=False)


def adaptive_kalman_filter(model, z, initial, u=None, window=30, floor=0.01, adapt="R", through=linearize):
    """The innovation-based adaptive filter: what the last innovations scatter more, or less, than expected is blamed on
    the noise.

    adapt "R": R = C − H P⁻ Hᵀ, with C the mean of y yᵀ over the last `window` innovations y, the present one included.
    adapt "Q": Q = α Q₀; innovations that scatter by C instead of S call for a Q larger by K (C − S) Kᵀ, and α follows,
    by at most a tenth a step; a new α acts from the next step on. Until `window` steps have been measured completely
    the model's own R₀ and Q₀ hold. R is never below `floor` R₀, and α stays between `floor` and 1/`floor`.
    Other arguments as in extended_kalman_filter, for LinearModel and NonlinearModel; returns an AdaptiveTrack.
    Source: Mehra 1970; Mohamed and Schwarz 1999.
    """
    check_model(model)
    z, u, batch = check_series(model, z, initial, u)
    window = check.whole_number("window", window, least=2)
    floor = check.number("floor", floor, positive=True)
    if adapt not in ("R", "Q"):
        raise ValueError(f"adapt must be 'R' or 'Q', got {adapt!r}")
    n = model.n
    belief = trusted(np.broadcast_to(initial.mean, (*batch, n)), np.broadcast_to(initial.cov, (*batch, n, n)))
    innovations, alpha, steps = Innovations(window, batch, model.m), np.ones(batch), []
    for k in range(z.shape[-2]):
        Q0, R0 = at(model.Q, k), at(model.R, k)
        Q, R = alpha[..., None, None] * Q0 if adapt == "Q" else Q0, R0
        predicted = _predict(model, belief, None if u is None else u[..., k, :], k, through, Q)
        expected, innovation = expect(model, predicted, z[..., k, :], k, through)
        C, ready = innovations.take(innovation)
        if adapt == "R":
            R = np.where(ready[..., None, None], _at_least(floor, C - expected.cov, R0), R0)
        belief, gain, innovation = condition(predicted, expected, innovation, R)
        if adapt == "Q":
            called_for = np.stack([spread(gain, C - innovation.cov)[0], Q])
            surplus, own = np.trace(divide_safely(called_for, predicted.cov), axis1=-2, axis2=-1)
            faster = np.exp(np.clip(surplus / np.where(own > 0, own, 1) / window, -0.1, 0.1))  # α 0 = 0: any α will do
            alpha = np.where(ready, np.clip(alpha * faster, floor, 1 / floor), alpha)
        steps.append((predicted, belief, innovation, gain, R, Q))
    predicted, filtered, innovation, gains, *noises = zip(*steps, strict=True)
    R, Q = (np.broadcast_to(M := np.stack(noise, -3), (*batch, *M.shape[-3:])) for noise in noises)
    return AdaptiveTrack(
        along(filtered), np.stack(gains, -3), lambda: along(predicted), lambda: along(innovation), u, None, R, Q
    )


class Innovations:
    """The last innovations of each run; a step of which some component was not measured does not count."""

    def __init__(self, window, batch, m):
        self.squares = np.zeros((window, *batch, m, m))
        self.count = np.zeros(batch, dtype=int)

    def take(self, y):
        """Take y (..., m) in; return the mean of y yᵀ (..., m, m) and whether the window is full (...)."""
        measured = np.isfinite(y).all(axis=-1)
        square = np.where(measured[..., None, None], y[..., :, None] * y[..., None, :], 0)
        later = np.concatenate([self.squares[1:], square[None]])
        self.squares = np.where(measured[..., None, None], later, self.squares)
        self.count = self.count + measured
        return self.squares.mean(axis=0), self.count >= len(self.squares)


def _at_least(floor, R, R0):
    """R, with no direction in which it is smaller than `floor` R₀: eigenvalues in units of R₀ are raised."""
    L = np.linalg.cholesky(R0)
    units = np.linalg.inv(L)
    values, vectors = np.linalg.eigh(symmetric(units @ R @ units.mT))
    root = L @ vectors * np.sqrt(np.maximum(values, floor))[..., None, :]
    return root @ root.mT
