"""Maximum likelihood: the parameters of a model under which the measurements are most probable."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from ..core.frozen import Frozen
from ..filters.diffuse import diffuse_start
from ..filters.kalman import kalman_filter
from ..models.arguments import check_series
from ..models.gaussian import Gaussian
from ..models.state_space import LinearModel
from ..results.track import Track
from .climb import LEAST, climb
from .family import Family
from .many import Start, forward, in_a_row
from .one import forward_of_one, is_one

SAME = 1e-6  # of a log-likelihood: less is no difference
DECADES = np.log(10) * np.concatenate([[0], np.arange(-12, 13, 2)])  # by which a parameter is moved at first


@dataclass(frozen=True, eq=False, repr=False)
class Fit(Frozen):
    """What `fit` found. Of many series every number is an array with their batch axes.

    parameters: the most probable ones, by name. standard_errors: of each, from the curvature of the log-likelihood at
        its top (the observed information), in the parameter's own unit; NaN for one that is at its boundary.
    at_boundary: by name, whether 0 is the best value of a positive parameter. It is 0 exactly then, or, where a model
        must not have 0 there (as R), so small that a hundred times as much would do as well.
    log_likelihood: at the top. A diffuse start counts log 2π for all measured numbers but the n that fix the states, as
        KFAS and R do.
    converged: whether the top was reached.
    model, track: the model with these parameters, and its filter's track; of many series the first one's. After a
        diffuse start the track begins with the step at which every state is known.
    """

    parameters: Mapping
    standard_errors: Mapping
    at_boundary: Mapping
    log_likelihood: np.ndarray
    converged: np.ndarray
    model: LinearModel
    states_without_start: int
    _follow: Callable

    @cached_property
    def track(self) -> Track | None:
        """The filter's track with the fitted model; None if it takes all readings to know the states."""
        return self._follow(self.model)

    @property
    def log_likelihood_of_all(self):
        """The log-likelihood that counts log 2π for every number, also for those that fix the states."""
        return self.log_likelihood - self.states_without_start / 2 * np.log(2 * np.pi)

    @property
    def aic(self):
        """Akaike's criterion −2 log L + 2 × (parameters + states without a start): the smaller, the better."""
        return 2 * (len(self.parameters) + self.states_without_start) - 2 * self.log_likelihood

    def __repr__(self):
        if np.ndim(self.converged):
            return f"Fit(of {self.converged.size} series; {int(self.converged.sum())} reached the top)"
        each = (
            f"{name} = 0, at its boundary"
            if self.at_boundary[name]
            else f"{name} = {_short(value)} ± {_short(self.standard_errors[name], 2)}"
            for name, value in self.parameters.items()
        )
        reached = "converged" if self.converged else "NOT converged"
        return f"Fit({'; '.join(each)}; ln L {self.log_likelihood:.2f}; {reached})"


def fit(build, z, start, initial=None, u=None, *, as_is=()) -> Fit:
    """The parameters under which the measurements are most probable, with their standard errors.

    Parameters
    ----------
    build : function
        build(**parameters) returns a LinearModel.
    z : array_like
        Measurements (..., T, m), or (T,) when m = 1; NaN: not measured. Each series of a batch is fitted alone.
    start : dict
        A first value of each parameter, by name, in its own unit. Positive ones are searched as logarithms, and stay
        positive or become 0 exactly; their first values may be wrong by many powers of ten.
    initial : Gaussian, optional
        The belief one step before the first measurement. Without it nothing is known at the first measurement.
    u : array_like, optional
        Control inputs (T, p), the same for all series.
    as_is : list of str
        Positive parameters that are not to be searched as logarithms, because they may be negative too.

    Returns
    -------
    Fit

    Raises
    ------
    ValueError, TypeError
        Naming the argument, or where z does not determine all states of a model without a start.

    References
    ----------
    Harvey 1989, sec. 3.4; Durbin and Koopman 2012, ch. 7.

    Examples
    --------
    >>> from kflearn import fit, random_walk
    >>> steps = [0.0, 1.2, 0.7, 2.1, 2.9, 2.2, 3.8, 5.1, 4.6, 6.0]
    >>> fit(random_walk, steps, {"Q": 1.0, "R": 1.0})
    Fit(Q = 1.05 ± 0.81; R = 0.0981 ± 0.35; ln L -13.73; converged)
    """
    family = Family(build, start, as_is)
    series = _Series.of(family, z, initial, u)
    function = series.log_likelihood
    peaks = climb(function, _scanned(function, series.first(), _each(family)))
    _look_again(family, function, peaks)
    _set_to_zero(family, function, peaks)
    return _told(family, series, peaks)


class _Series:
    """The series to be fitted, as a function of coordinates."""

    def __init__(self, family, z, initial, u, batch):
        self.family, self.z, self.initial, self.u, self.batch = family, z, initial, u, batch
        self.count = len(z)
        self.runs_last = np.moveaxis(z, 0, -1)[:, :, None]  # (T, m, 1, N)
        if initial is None:
            matrices = family.matrices(family.first[None, None])
            self.start = Start.unknown(matrices, self.runs_last, self._push(matrices))
        else:
            X, P, _ = Start.known(initial, batch, resting=False)
            self.start = Start(X[:, :, None], P[:, :, None], False)

    @classmethod
    def of(cls, family, z, initial, u):
        """After the arguments were looked at."""
        known = Gaussian(np.zeros(family.model.n), np.eye(family.model.n)) if initial is None else initial
        z, u, batch = check_series(family.model, z, known, u)
        if u is not None and u.ndim > 2:
            raise ValueError(f"u must have shape (T, p), the same for all series, got {u.shape}")
        return cls(family, in_a_row(z, batch), initial, u, batch)

    def log_likelihood(self, coordinates, which=slice(None)):
        """Of models at coordinates (M, n, p), with the series `which` (n,): (M, n)."""
        return self._ends(coordinates, which).log_likelihood()

    def _ends(self, coordinates, which=slice(None)):
        matrices, (X, P, resting) = self.family.matrices(self.family.values(coordinates)), self.start
        some = (part[..., which] if part.shape[-1] > 1 else part for part in (X, P))
        run = forward_of_one if is_one(matrices) else forward
        return run(matrices, self.runs_last[..., which], self._push(matrices), Start(*some, resting))

    def first(self):
        """Coordinates (N, p) of the first values, all positive ones times one factor where that helps."""
        at = np.tile(self.family.coordinates(self.family.first), (self.count, 1))
        ends = self._ends(at[None])
        before = ends.log_likelihood()
        if not np.isfinite(before).all():
            self._explain()
        scatter = np.maximum(ends.scatter()[0], np.finfo(float).tiny)
        moved = at + np.log(scatter)[:, None] * self.family.positive
        return np.where((self.log_likelihood(moved[None]) > before).T, moved, at)

    def _push(self, matrices):
        if self.u is None:
            return None
        B = np.broadcast_to(matrices.B, (len(self.u), *matrices.B.shape[1:]))
        return np.einsum("tnp...,tp->tn...", B, self.u)

    def _explain(self):
        """Why there is no likelihood at the start."""
        if self.initial is None:
            for z in self.z:
                diffuse_start(self.family.model, z, self.u)
        raise ValueError("start must give a model under which z is possible, but its log-likelihood is not finite")

    def track(self, model):
        """The filter's track of the first series."""
        if self.initial is not None:
            first = (0,) * (self.initial.mean.ndim - 1)
            initial = Gaussian(self.initial.mean[first], self.initial.cov[first])
            return kalman_filter(model, self.z[0], initial, self.u)
        start = diffuse_start(model, self.z[0], self.u)
        if start.steps == self.z.shape[1]:
            return None
        u = None if self.u is None else self.u[start.steps :]
        return kalman_filter(start.model, self.z[0, start.steps :], start.belief, u)


def _short(number, digits=3):
    """A number with so many digits or more, in plain form where that is short."""
    return f"{number:.0f}" if 10**digits <= abs(number) < 1e7 else f"{number:.{digits}g}"


def _each(family):
    """Each positive parameter alone."""
    return np.diag(family.positive)[family.positive]


def _scanned(function, at, groups, which=slice(None)):
    """The best places to climb from: groups of parameters (p,), one after another, times a power of ten."""
    for group in groups:
        tried = at + DECADES[:, None, None] * group
        at = tried[np.argmax(function(tried, which), axis=0), np.arange(len(at))]
    return at


def _look_again(family, function, peaks):
    """A positive parameter that became tiny feels no slope any more: from there one looks at other powers of ten."""
    flat = np.flatnonzero((abs(np.diagonal(peaks.hill.bend, axis1=1, axis2=2)) < LEAST).any(axis=1))
    if len(flat):
        better = _scanned(function, peaks.at[flat], _each(family), flat)
        more = function(better[None], flat)[0] > peaks.hill.value[flat] + SAME
        _climb_some(function, peaks, flat[more], better[more])


def _set_to_zero(family, function, peaks):
    """Positive parameters for which 0 is as probable as the value found become 0, and the others are sought again."""
    for i in np.flatnonzero(family.positive):
        without = peaks.at.copy()
        without[:, i] = -np.inf
        if family.possible(family.values(without)[0]):
            zero = np.flatnonzero(function(without[None])[0] >= peaks.hill.value - SAME)
            _climb_some(function, peaks, zero, without[zero])


def _at_boundary(family, function, peaks):
    """Which positive parameters are 0, or so small that a hundred times as much would do as well, (N, p)."""
    found = np.zeros(peaks.at.shape, bool)
    for i in np.flatnonzero(family.positive):
        larger = peaks.at.copy()
        larger[:, i] += np.log(100)
        found[:, i] = function(larger[None])[0] >= peaks.hill.value - SAME
    return found


def _climb_some(function, peaks, which, start):
    """Climb with some of the series from other places, and note where that leads."""
    if len(which):
        peaks.put(which, climb(partial(_of_some, function, which), start))


def _of_some(function, some, points, which=slice(None)):
    """A function of all series as one of some of them."""
    return function(points, some[which])


def _told(family, series, peaks):
    """The Fit that belongs to the peaks."""
    values, p, boundary = family.values(peaks.at), len(family.names), _at_boundary(family, series.log_likelihood, peaks)
    information = np.where(boundary[:, :, None] | boundary[:, None], np.eye(p), -peaks.hill.bend)
    sound = np.linalg.eigvalsh(information)[:, :1] > 0
    variance = np.diagonal(np.linalg.inv(np.where(sound[..., None], information, np.eye(p))), axis1=-2, axis2=-1)
    error = np.sqrt(np.where(sound & ~boundary & (variance > 0), variance, np.nan))
    error = error * np.where(family.positive, values, family.scale)

    def shaped(array):
        return array.reshape(series.batch)[()]

    def by_name(array):
        return {name: shaped(column) for name, column in zip(family.names, array.T, strict=True)}

    return Fit(
        by_name(values),
        by_name(error),
        by_name(boundary),
        shaped(peaks.hill.value),
        shaped(peaks.reached),
        family.at(values[0]),
        family.model.n if series.initial is None else 0,
        series.track,
    )
