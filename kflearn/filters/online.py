"""One reading at a time, as it comes from a sensor: the model is looked at once, then each step costs microseconds."""

from math import isfinite

import numpy as np

from ..core.conditioning import definite, divide, squared_distance, without_missing
from ..core.frozen import freeze
from ..core.matrices import step_matrix
from ..models import checks as check
from ..models.arguments import check_belief, check_control, check_measure, check_model, check_move, check_stacks
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.jumps import watched
from ..models.state_space import LinearModel, stacks
from ..results.track import read_only, scores
from .gate import gate_limits
from .moments import check_through, linearize
from .steps import corrected_belief, predicted_belief


class OnlineFilter:
    """A Kalman filter that is fed one reading at a time; for a nonlinear model the extended one.

    Its numbers are those of kalman_filter and extended_kalman_filter (to ten digits where Jacobians are taken by
    differences). predict and correct do the same, but look at all their arguments anew each time. The letters are
    explained in `filters.kalman`.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states, of which m components are measured. Of stacked matrices each step takes its own.
    initial : Gaussian
        The belief one step before the first reading; with batch axes many runs are followed side by side.
    through : callable
        How beliefs go through f and h: linearize, unscented(n) or cubature(n).
    gate : float, optional
        A probability such as 0.99, as in kalman_filter.

    Attributes
    ----------
    belief, mean, cov
        What is believed now, as a Gaussian, (..., n) and (..., n, n).
    k : int
        The step, counted from 0; −1 before the first prediction.
    innovation, S, nis, gain, refused
        Of the last reading: a Gaussian with mean z − ẑ and covariance S, S itself (..., m, m), yᵀ S⁻¹ y (...), the gain
        (..., n, m), and whether the gate refused it (...). None before the first reading.

    Raises
    ------
    ValueError, TypeError
        Naming the argument, where the pieces do not fit; the filter then stays as it was.

    Examples
    --------
    >>> from kflearn import Gaussian, OnlineFilter, random_walk
    >>> live = OnlineFilter(random_walk(0, 1), Gaussian(0, 1e6))
    >>> for reading in [1.0, 2.0, 3.0]:
    ...     live.step(reading)
    >>> print(f"{live.belief:.2f}, last innovation {live.innovation.mean[0]:.2f}")
    N(2.00, 0.33), last innovation 1.50
    """

    def __init__(self, model, initial, *, through=linearize, gate=None):
        check_model(model)
        check_through(through)
        check_belief("initial", initial, model)
        self.model, self.through, self.k = model, through, -1
        self._limits, self._steps = gate_limits(gate, model.m), _steps_of(model)
        lead = {name: M.shape[:-3] for name, M in stacks(model).items()}
        batch = check.batches(initial=initial.batch, **lead)
        self._mean, self._cov = np.broadcast_to(initial.mean, (*batch, model.n)), initial.cov
        self._last, self._u, self._untried = None, None, {"f(x)", "f(x, u)", "h(x)"}
        self._quick = batch == () and through is linearize
        self._linear = isinstance(model, LinearModel)
        self._one, self._ones_n, self._ones_m = np.eye(model.n), np.ones(model.n), np.ones(model.m)

    def predict(self, u=None) -> None:
        """Go on to the next step, before its reading: eqs (5) and (6). u: the control input (p,), if there is one."""
        model, k = self.model, self.k + 1
        if self._steps is not None and k >= self._steps:
            raise ValueError(
                f"model must have matrices for each step, but it has {self._steps} steps and they are over"
            )
        if u is not None:
            u = self._input(u)
        if self._untried and (task := "f(x)" if u is None else "f(x, u)") in self._untried:
            check_move(model, self._mean, u, k=k)
            self._untried.discard(task)
        if self._quick:
            F, Q = model.move_slope(self._mean, u, k), step_matrix(model.Q, k)
            x = F.dot(self._mean) if self._linear and u is None else model.move(self._mean, u, k)  # (5)
            P = F.dot(self._cov).dot(F.T) + Q  # (6)
            if isfinite(x.dot(self._ones_n)):
                self._mean, self._cov, self._u, self.k = x, P, u, k
                return
        made = predicted_belief(model, self._now(), u, k, self.through)  # any other case, and every error
        self._mean, self._cov, self._u, self.k = made.mean, made.cov, u, k

    def correct(self, z) -> None:
        """Take in the reading z (m,) of this step, or a number when m = 1: eqs (7)–(9). NaN: not measured."""
        model, k = self.model, max(self.k, 0)
        if isinstance(z, float) and model.m == 1:
            z = np.array([z])
        elif type(z) is not np.ndarray or z.dtype != float or z.shape != self._ones_m.shape:
            z = check.shape("z", np.atleast_1d(check.numbers("z", z, gaps=True)), (model.m,))
        if "h(x)" in self._untried:
            check_measure(model, self._mean, self._u, k=k)
            self._untried.discard("h(x)")
        made = self._corrected(z, k) if self._quick and z.ndim == 1 else None
        if made is None:  # any other case, and every error
            check.numbers("z", z, gaps=True)
            how = k, self.through, self._u, self._limits
            after, innovation, gain, refused = corrected_belief(model, self._now(), z, *how)
            refused = np.zeros(innovation.batch, bool) if refused is None else refused
            made = after.mean, after.cov, (innovation.mean, innovation.cov, gain, refused)
        self._mean, self._cov, self._last = made

    def step(self, z, u=None) -> None:
        """Predict with the control input u, then correct with the reading z: one step of a filter."""
        before = self._mean, self._cov, self._u, self.k
        self.predict(u)
        try:
            self.correct(z)
        except Exception:
            self._mean, self._cov, self._u, self.k = before  # a reading that is no reading takes the whole step back
            raise

    def _corrected(self, z, k):
        """Eqs (7)–(9) for one run along the tangent: x, P and what is told of the reading; None where it fails."""
        model, x, P = self.model, self._mean, self._cov
        H, R = model.measure_slope(x, self._u, k), step_matrix(model.R, k)
        expected = H.dot(x) if self._linear else model.measure(x, self._u, k)
        y = used = z - expected if self._linear else watched(model, "h", x, self._u, k)(z, expected)
        C = P.dot(H.T)
        S, seen = H.dot(C) + R, len(y)
        rest = S
        if not isfinite(y.dot(self._ones_m)):
            if not np.isfinite(expected).all() or np.isinf(z).any():
                return None
            missing = np.isnan(y)
            if missing.all():
                return x, P, (y, S, np.zeros_like(C), np.False_)
            rest, C = without_missing(missing, S, C)
            used, seen = np.where(missing, 0, y), len(y) - missing.sum()
        if not (S[0, 0] > 0 and (len(S) == 1 or definite(rest))):
            return None
        K = C / rest if len(S) == 1 else divide(C, rest)  # (7)
        if self._limits is not None and squared_distance(used, rest) > self._limits[seen]:
            return x, P, (y, S, np.zeros_like(K), np.True_)
        x = x + K.dot(used)  # (8)
        left = self._one - K.dot(H)
        P = left.dot(P).dot(left.T) + K.dot(R).dot(K.T)  # (9) in Joseph's form, as in core.conditioning
        return x, (P + P.T) * 0.5, (y, S, K, np.False_)

    def _input(self, u):
        """A control input after it was looked at."""
        if (
            type(u) is np.ndarray
            and u.dtype == float
            and u.shape == (getattr(self.model, "p", -1),)
            and isfinite(u.sum())
        ):
            return u
        u = np.atleast_1d(check.numbers("u", u))
        check_control(self.model, u)
        return u

    def _now(self):
        return unchecked_gaussian(self._mean, self._cov)

    @property
    def belief(self) -> Gaussian:
        """What is believed now."""
        return read_only(unchecked_gaussian(self._mean, self._cov.copy()), series=False)

    @property
    def mean(self) -> np.ndarray:
        """Short for belief.mean."""
        self._mean.flags.writeable = False
        return self._mean

    @property
    def cov(self) -> np.ndarray:
        """Short for belief.cov."""
        return self.belief.cov

    @property
    def innovation(self) -> Gaussian | None:
        """The last innovation with its covariance S, NaN where nothing was measured."""
        return None if self._last is None else read_only(unchecked_gaussian(*self._last[:2]), series=False)

    @property
    def S(self) -> np.ndarray | None:
        """Short for innovation.cov."""
        return None if self.innovation is None else self.innovation.cov

    @property
    def nis(self) -> np.ndarray | None:
        """yᵀ S⁻¹ y of what was measured of the last reading, used or refused; NaN where nothing was."""
        return None if self.innovation is None else scores(self.innovation)[0]

    @property
    def gain(self) -> np.ndarray | None:
        """The last gain, zero in the columns of what was not measured or not used."""
        return None if self._last is None else freeze(self._last[2])

    @property
    def refused(self) -> np.ndarray | None:
        """Did the gate refuse the last reading?"""
        return None if self._last is None else self._last[3]

    def __repr__(self):
        return f"OnlineFilter at step {self.k}: {self.belief!r}"


def _steps_of(model):
    """How many steps a model has matrices for; None where they serve all steps."""
    T = max((M.shape[-3] for M in stacks(model).values()), default=1)
    check_stacks(model, T)
    return T if T > 1 else None
