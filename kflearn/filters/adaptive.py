"""A Kalman filter that learns R, or the size of Q, from its own innovations."""

from dataclasses import dataclass

import numpy as np

from ..core.conditioning import divide_safely
from ..core.frozen import freeze
from ..core.matrices import congruence, inverse_lower, step_matrix, symmetric
from ..models import checks as check
from ..models.arguments import check_model, check_series
from ..results.track import StackedSteps, Track, stack_in_time
from .moments import check_through, linearize, refuse_negative
from .steps import at_step, condition, expected_measurement, predicted_belief, starting_belief

LONGEST_WINDOW = 1_000_000


@dataclass(frozen=True, eq=False, repr=False)
class AdaptiveTrack(Track):
    """A Track and the noise it was made with: R (..., T, m, m) and Q (..., T, n, n), at each step.

    The filter goes on where it stopped when it is given its track as `initial`.
    """

    R: np.ndarray | None = None
    Q: np.ndarray | None = None
    _memory: tuple = ()  # at the end: the squares y yᵀ in the window (..., N, m, m), how many there were (...), α (...)

    def __post_init__(self):
        super().__post_init__()
        self._share("R")
        self._share("Q")
        freeze(self._memory)


def adaptive_kalman_filter(
    model, z, initial, u=None, *, window=30, floor=0.01, adapt="R", through=linearize
) -> AdaptiveTrack:
    """The innovation-based adaptive filter: recent innovations that scatter too much or too little change R, or Q.

    The excess (or lack) of scatter is attributed to R, or to the size of Q. Until `window` steps have been measured
    completely the model's own R₀ and Q₀ are used: on shorter series this is the extended Kalman filter.

    Parameters
    ----------
    model, z, initial, u
        As in extended_kalman_filter, for LinearModel and NonlinearModel. `initial` may also be the track of the
        readings before z, made by this filter: then its window of innovations, and α, are carried on.
    window : int
        The number N of innovations that are averaged, from 2. A step of which a component was not measured does not
        count.
    floor : float
        R is never below `floor` R₀ in any direction; α stays between `floor` and 1/`floor`.
    adapt : "R" or "Q"
        "R": R = C − H P⁻ Hᵀ, with C the mean of y yᵀ over the last N innovations y, the present one included.
        "Q": Q = α Q₀. Innovations that scatter by C instead of S call for a Q larger by K (C − S) Kᵀ, and α follows, by
        at most a tenth a step (a factor e^±0.1); a new α acts from the next step on.
    through : callable
        linearize, unscented(n) or cubature(n), for nonlinear models.

    Returns
    -------
    AdaptiveTrack
        A Track with the R and Q of each step. rts_smoother refuses it.

    Raises
    ------
    ValueError, TypeError
        As in extended_kalman_filter, and when a setting does not make sense.

    References
    ----------
    Mehra 1970; Mohamed and Schwarz 1999.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import Gaussian, adaptive_kalman_filter, random_walk
    >>> z = np.random.default_rng(0).normal(0, 3, 2000)  # noise of variance 9, where the model says 1
    >>> track = adaptive_kalman_filter(random_walk(1e-4, 1), z, Gaussian(0, 1), window=100)
    >>> print(f"R {track.R[0, 0, 0]:.0f} at first, {track.R[200:].mean():.0f} in the end")
    R 1 at first, 9 in the end
    """
    check_model(model)
    check_through(through)
    before, initial = (initial, initial[-1]) if isinstance(initial, AdaptiveTrack) else (None, initial)
    z, u, batch = check_series(model, z, initial, u)
    window, floor = _checked(window, floor, adapt)
    innovations, alpha = _carried_on(before, window, z.shape[-2], batch, model.m)
    belief, steps = starting_belief(initial, batch), []
    for k in range(z.shape[-2]):
        R, Q, push = step_matrix(model.R, k), step_matrix(model.Q, k), at_step(u, k)
        if adapt == "Q":
            Q = alpha[..., None, None] * Q
        predicted = predicted_belief(model, belief, push, k, through, Q)
        expected, innovation = expected_measurement(model, predicted, z[..., k, :], k, through, push)
        C, ready = innovations.take(innovation)
        if adapt == "R":
            R = np.where(ready[..., None, None], _at_least(floor, C - expected.cov, R), R)
        belief, innovation, gain, _ = condition(predicted, expected, innovation, R, k)
        refuse_negative("P⁺", belief.cov, through, k, predicted.cov)
        if adapt == "Q":
            faster = _growth(congruence(gain, C - innovation.cov)[0], Q, predicted.cov, window)
            alpha = np.where(ready, np.clip(alpha * faster, floor, 1 / floor), alpha)
        steps.append((predicted, belief, innovation, gain, R, Q))
    predicted, filtered, innovation, *matrices = zip(*steps, strict=True)
    gain, R, Q = (np.stack(matrix, -3) for matrix in matrices)
    later = StackedSteps(predicted, innovation)
    memory = np.moveaxis(innovations.squares, 0, -3), innovations.count, alpha
    return AdaptiveTrack(stack_in_time(filtered), gain, model, later, u, R=R, Q=Q, _memory=memory)


def _carried_on(before, window, T, batch, m):
    """The window of innovations and α at the start of T steps: empty and 1, or what a track had at its end."""
    if before is None:
        return Innovations(min(window, T + 1), batch, m), np.ones(batch)  # a longer window is never full either
    squares, count, alpha = before._memory
    if squares.shape[-1] != m:
        raise ValueError(f"initial must be a track of {m} measured components like the model, got {squares.shape[-1]}")
    innovations = Innovations(min(window, squares.shape[-3] + T + 1), batch, m)
    kept = min(squares.shape[-3], len(innovations.squares))
    squares = np.broadcast_to(squares[..., squares.shape[-3] - kept :, :, :], (*batch, kept, m, m))
    innovations.squares[len(innovations.squares) - kept :] = np.moveaxis(squares, -3, 0)
    innovations.count = np.broadcast_to(np.minimum(count, kept), batch)
    return innovations, np.broadcast_to(alpha, batch)


def _checked(window, floor, adapt):
    """The settings, after they were looked at."""
    window = check.whole_number("window", window, least=2)
    if window > LONGEST_WINDOW:
        raise ValueError(f"window must be at most {LONGEST_WINDOW:,} steps, got {window:,}")
    if adapt not in ("R", "Q"):
        raise ValueError(f"adapt must be 'R' or 'Q', got {adapt!r}")
    return window, check.number("floor", floor, positive=True)


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


def _growth(surplus, Q, P, window):
    """The factor (...) by which α grows when the innovations call for a Q larger by `surplus`; P: the predicted one.

    Both are measured in units of P, so that the units of the states do not matter.
    """
    surplus, own = np.trace(divide_safely(np.stack([surplus, Q]), P), axis1=-2, axis2=-1)
    share = surplus / np.where(own > 0, own, 1)  # if Q₀ is zero, α has no effect; avoid 0/0
    return np.exp(np.clip(share / window, -0.1, 0.1))


def _at_least(floor, R, R0):
    """R, with no direction in which it is smaller than `floor` R₀: eigenvalues in units of R₀ are raised."""
    L = np.linalg.cholesky(R0)
    units = inverse_lower(L)
    values, vectors = np.linalg.eigh(symmetric(units @ R @ units.mT))
    root = L @ vectors * np.sqrt(np.maximum(values, floor))[..., None, :]
    return root @ root.mT
