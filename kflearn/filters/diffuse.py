"""A start from nothing: the belief that the first measurements alone give, without a number for "I know nothing"."""

from typing import NamedTuple

import numpy as np

from ..core.matrices import solve_lower
from ..models.arguments import check_series
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.state_space import LinearModel, stacks
from ..results.track import read_only
from .square_root import square_root_kalman_filter


class DiffuseStart(NamedTuple):
    """What the first measurements say.

    belief: after the last of them. steps: how many they are. log_likelihood: theirs; the first n numbers that determine
    the n states count nothing but how well they do so, as in KFAS (statsmodels counts −½ log 2π more for each of them).
    model: the model of the steps that follow; where matrices are stacks, its stacks begin there.
    """

    belief: Gaussian
    steps: int
    log_likelihood: float
    model: LinearModel


def diffuse_start(model, z, u=None) -> DiffuseStart:
    """The belief after as many measurements as it takes to know all states, when nothing is known before them.

    Go on with kalman_filter(start.model, z[start.steps:], start.belief). It is the limit of a start with an infinite
    variance at the first measurement (not one step before it), without its rounding errors.

    Parameters
    ----------
    model : LinearModel
        With n states; without batch axes.
    z : array_like
        One series (T, m), or (T,) when m = 1. NaN: not measured.
    u : array_like, optional
        Control inputs (T, p); u[0] is not used, because nothing is known before z[0].

    Returns
    -------
    DiffuseStart

    Raises
    ------
    ValueError, TypeError
        Naming the argument, and where z does not determine all states.

    References
    ----------
    de Jong 1991; Durbin and Koopman 2012, ch. 5.

    Examples
    --------
    >>> from kflearn import constant_velocity, diffuse_start
    >>> start = diffuse_start(constant_velocity(dt=1, acceleration=0.1, R=1), [10.0, 12.0, 14.5])
    >>> print(f"after {start.steps} steps: {start.belief:.2f}")
    after 2 steps: N([12.00, 2.00], [[1.00, 1.00], [1.00, 2.00]])
    """
    z, u = _checked(model, z, u)
    responses = Responses.of(model, z, u)
    for steps in range(1, len(z) + 1):
        if (found := responses.solved(steps)) is not None:
            mean, half, log_likelihood = found
            belief = read_only(responses.belief(steps - 1, mean, half))
            return DiffuseStart(belief, steps, log_likelihood, from_step(model, steps))
    raise ValueError(f"z must determine all {model.n} states, but its {len(z)} steps leave some of them open")


class Responses(NamedTuple):
    """How a filter that starts from an exactly known state answers to the data, and to each component of that state.

    Everything is linear in the state at the first measurement: run 0 starts at 0 and sees the data, run j starts at the
    unit vector j and sees 0. beliefs: of these 1 + n runs, from the first measurement on. white (1 + n, T, m): their
    innovations, divided by the root of S. log_det (T,): log det S of what was measured; seen (T, m): what was measured.
    """

    beliefs: Gaussian
    white: np.ndarray
    log_det: np.ndarray
    seen: np.ndarray

    @classmethod
    def of(cls, model, z, u) -> "Responses":
        """Run the filter 1 + n times at once. Its first step is one at which nothing moves."""
        n, T = model.n, len(z)
        starts = Gaussian(np.concatenate([np.zeros((1, n)), np.eye(n)]), np.zeros((n, n)))
        series = np.concatenate([z[None], np.broadcast_to(np.where(np.isnan(z), np.nan, 0), (n, *z.shape))])
        if u is not None:
            u = np.concatenate([np.zeros((1, u.shape[1])), u[1:]])
            u = np.concatenate([u[None], np.zeros((n, *u.shape))])
        track = square_root_kalman_filter(resting_first(model, T), series, starts, u)
        root = track._later.S_root()
        white = solve_lower(root, np.where(np.isnan(z), 0, track.innovation.mean))
        log_det = 2 * np.sum(np.log(np.diagonal(root, axis1=-2, axis2=-1)), axis=-1)
        return cls(track.filtered, white, log_det, ~np.isnan(z))

    def solved(self, steps):
        """The state at the first measurement as the first steps tell it: its mean, a root of its covariance, and the
        log-likelihood; None where they leave some of it open."""
        n = len(self.white) - 1
        told = self.white[:, :steps].reshape(n + 1, -1).T
        size = np.linalg.norm(told[:, 1:], axis=0)
        if len(told) < n or not size.all():
            return None
        # The innovations are those of run 0 plus what the state adds; least squares, with columns of length 1.
        R = np.linalg.qr(np.column_stack([told[:, 1:] / size, -told[:, 0]]), mode="r")
        R, y, rest = R[:n, :n], R[:n, n], R[n:, n]
        if abs(np.diagonal(R)).min() < 1e-10:
            return None
        count = self.seen[:steps].sum() - n
        log_det = self.log_det[:steps].sum() + 2 * np.log(abs(np.diagonal(R) * size)).sum()
        log_likelihood = -0.5 * (log_det + rest @ rest + count * np.log(2 * np.pi))
        half = np.linalg.inv(R) / size[:, None]
        return half @ y, half, float(log_likelihood)

    def belief(self, k, mean, half):
        """What was filtered at step k by the run with the data, moved and widened as the state at the start demands."""
        response = self.beliefs.mean[1:, k].T
        spread = response @ half
        return unchecked_gaussian(self.beliefs.mean[0, k] + response @ mean, self.beliefs.cov[0, k] + spread @ spread.T)


def resting_first(model, T):
    """The same model, but at the first of T steps nothing moves: a start one step before is one at the measurement."""
    n = model.n
    still = {}
    for name, first in (("F", np.eye(n)), ("Q", np.zeros((n, n)))):
        M = getattr(model, name)
        still[name] = np.broadcast_to(M, (T, n, n)).copy()
        still[name][0] = first
    return model.replace(**still)


def from_step(model, k):
    """The model of the steps from k on."""
    return model.replace(**{name: M[k:] for name, M in stacks(model).items() if len(M) > 1})


def _checked(model, z, u):
    """One series as (T, m) and its control inputs, after the arguments were looked at."""
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    z, u, batch = check_series(model, z, Gaussian(np.zeros(model.n), np.eye(model.n)), u)
    if batch:
        raise ValueError(f"z must be one series, without batch axes, got the batch axes {batch}")
    return z, u
