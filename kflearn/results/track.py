"""What a filter returns: plain data that can be read, copied, pickled and sent to another process, but not changed."""

from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property
from operator import index

import numpy as np

from ..core.conditioning import decouple_missing, log_determinant, squared_distance
from ..core.frozen import Frozen
from ..core.matrices import compact, solve_lower, symmetric, with_batch
from ..core.recursion import matvec_each_step
from ..core.walk import Walk
from ..models.gaussian import Gaussian, clip_variances, unchecked_gaussian
from ..models.state_space import LinearModel, NonlinearModel


@dataclass(frozen=True, eq=False, repr=False)
class Filtered(Frozen):
    """Beliefs after each measurement, read-only.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n). `track[k]` is the belief after step k.
    """

    filtered: Gaussian

    def __post_init__(self):
        object.__setattr__(self, "filtered", read_only(self.filtered))

    @property
    def mean(self) -> np.ndarray:
        """Short for filtered.mean, (..., T, n)."""
        return self.filtered.mean

    @property
    def cov(self) -> np.ndarray:
        """Short for filtered.cov, (..., T, n, n)."""
        return self.filtered.cov

    @property
    def std(self) -> np.ndarray:
        """The standard deviations, (..., T, n), in the units of the states."""
        variance = np.diagonal(compact(self.cov, 3), axis1=-2, axis2=-1)
        return with_batch(np.sqrt(variance), self.mean.shape[:-2])

    def __getitem__(self, k) -> Gaussian:
        """The belief at step k (negative k count from the end), or for a slice the beliefs of these steps."""
        T = self.mean.shape[-2]
        if not isinstance(k, slice):
            try:
                k = index(k)
            except TypeError:
                raise TypeError(f"a step must be a whole number or a slice, got {type(k).__name__}") from None
            if not -T <= k < T:
                raise IndexError(f"a step must lie between {-T} and {T - 1} in a track of {T} steps, got {k}")
        return unchecked_gaussian(self.mean[..., k, :], self.cov[..., k, :, :])

    def __repr__(self):
        *batch, T, n = self.mean.shape
        runs = f", batch={tuple(batch)}" if batch else ""
        first = (0,) * len(batch)
        mean, std = (_short(array[(*first, -1)]) for array in (self.mean, self.std))
        whose = "first run ends with" if batch else "last"
        return f"{type(self).__name__}(T={T} steps, n={n} states{self._sizes()}{runs}; {whose} mean {mean}, std {std})"

    def _sizes(self):
        """What else repr tells of the sizes."""
        return ""

    def __getstate__(self):
        """The fields alone, and of arrays only what is stored: copies and pickles stay as small as the track."""
        return {part.name: _stored(getattr(self, part.name)) for part in fields(self)}

    def __setstate__(self, state):
        super().__setstate__(state)
        self.__post_init__()


@dataclass(frozen=True, eq=False, repr=False)
class Track(Filtered):
    """The beliefs of one run or of many, along time. All filters but the multiple-model ones return it.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n), after each measurement; `mean`, `cov` and `std` are
        short for its own, `track[k]` is the belief after step k.
    gain: (..., T, n, m), zero in the columns of what was not measured.
    predicted: Gaussian of the same shapes, before each measurement.
    innovation: Gaussian with mean z − ẑ (..., T, m), NaN where nothing was measured, and cov S (..., T, m, m).
    refused: bool (..., T), True where the filter's gate refused the reading, so that it was not used.
    nis, log_likelihood: (..., T) and (...); a refused reading has its NIS, but no share in the likelihood.
    model, u, through: the model that the filter was given, its control inputs (..., T, p) or None, and how it pushed
        beliefs through the model (see `filters.moments`; None where no smoother may follow).

    Every array has the batch axes of the runs. Covariances and gains that are the same in all runs are stored once;
    what you see then is a view that repeats them. All arrays are read-only: `predicted` and `innovation` are computed
    from them when first asked for.

    Examples
    --------
    >>> from kflearn import Gaussian, kalman_filter, random_walk
    >>> track = kalman_filter(random_walk(0.1, 1), [1.0, 2.0, 1.5], Gaussian(0, 10))
    >>> print(f"{track[-1]:.2f}")
    N(1.47, 0.38)
    """

    gain: np.ndarray
    model: LinearModel | NonlinearModel
    _later: "LinearSteps | StackedSteps"
    u: np.ndarray | None = None
    through: Callable | None = None
    _refused: np.ndarray | None = None

    def __post_init__(self):
        super().__post_init__()
        self._share("gain")

    def _share(self, name):
        """Mark an array of matrices read-only and give it the batch axes of the mean."""
        array = getattr(self, name)
        array.flags.writeable = False
        object.__setattr__(self, name, with_batch(array, self.mean.shape[:-1]))

    def _sizes(self):
        return f", m={self.gain.shape[-1]} measured"

    @cached_property
    def predicted(self) -> Gaussian:
        """The beliefs before each measurement."""
        return read_only(self._later.predicted(self.mean))

    @cached_property
    def innovation(self) -> Gaussian:
        """The differences between measured and expected, with the covariance S the filter gives them."""
        return read_only(self._later.innovation(self.predicted))

    @cached_property
    def nis(self) -> np.ndarray:
        """Normalised innovation squared yᵀ S⁻¹ y of what was measured, used or not, (..., T); NaN where nothing was."""
        return self._scores[0]

    @cached_property
    def log_likelihood(self) -> np.ndarray:
        """The logarithm of the probability density of all readings that were used under the model, (...)."""
        each = self._scores[1]
        return (each if self._refused is None else np.where(self._refused, 0, each)).sum(axis=-1)

    @property
    def refused(self) -> np.ndarray:
        """Which readings the gate refused, (..., T); none where there was no gate."""
        refused = np.broadcast_to(False if self._refused is None else self._refused, self.mean.shape[:-1])
        refused.flags.writeable = False
        return refused

    @property
    def learnt(self) -> np.ndarray:
        """K (z − ẑ), (..., T, n), by which each measurement changed the mean; it is x̂ − x⁻ without the subtraction."""
        y = self._later.surprise(self.mean)
        return matvec_each_step(compact(self.gain, 3), np.where(np.isnan(y), 0, y))

    @property
    def _scores(self):
        return scores(self.innovation, self._later.S_root())


@dataclass(frozen=True, eq=False)
class LinearSteps(Frozen):
    """What a linear filter keeps for later: predictions and innovations follow from its means.

    model, z (..., T, m), u (..., T, p) or None; start: the initial belief; plan: a Walk whose parts are the distinct
    steps, with predicted P, S, and S_root where there is one.
    """

    model: LinearModel
    z: np.ndarray
    u: np.ndarray | None
    start: Gaussian
    plan: Walk

    def predicted(self, mean):
        """The beliefs before each measurement, from the means (..., T, n) after them: eqs (5) and (6)."""
        return unchecked_gaussian(self._moved(mean), self._each(symmetric(self.plan.parts.predicted)))

    def innovation(self, predicted):
        """z − H x⁻ and S."""
        return unchecked_gaussian(self._difference(predicted.mean), self._each(self.plan.parts.S))

    def surprise(self, mean):
        """z − H x⁻ alone."""
        return self._difference(self._moved(mean))

    def _difference(self, predicted_mean):
        return self.z - matvec_each_step(self.model.H, predicted_mean)

    def _moved(self, mean):
        before = np.empty_like(mean)  # which lies in memory as `mean` does
        before[..., 0, :], before[..., 1:, :] = self.start.mean, mean[..., :-1, :]
        moved = matvec_each_step(self.model.F, before)
        if self.u is not None:
            moved = moved + matvec_each_step(self.model.B, self.u)
        return moved

    def S_root(self):
        """The triangular roots of S, in which unmeasured components have variance 1; None where there are none."""
        root = self.plan.parts.S_root
        return None if root is None else self._each(root)

    def _each(self, part):
        return self.plan.each(part, self.z.shape[-2])


@dataclass(frozen=True, eq=False)
class StackedSteps(Frozen):
    """What the other filters keep for later: the predictions and innovations of each step, not yet stacked."""

    predictions: tuple[Gaussian, ...]
    innovations: tuple[Gaussian, ...]

    def predicted(self, mean):
        """The beliefs before each measurement."""
        return stack_in_time(self.predictions)

    def innovation(self, predicted):
        """The innovations with their covariances."""
        return stack_in_time(self.innovations)

    def surprise(self, mean):
        """The innovations alone."""
        return np.stack([innovation.mean for innovation in self.innovations], -2)

    def S_root(self):
        """No roots are kept."""
        return


def stack_in_time(beliefs):
    """Gaussians of single steps as one Gaussian along time."""
    return unchecked_gaussian(np.stack([b.mean for b in beliefs], -2), np.stack([b.cov for b in beliefs], -3))


def read_only(belief, series=True):
    """The same belief with read-only arrays: what is computed later must still agree with it.

    Its covariances get the batch axes of its mean, as a view where they are the same in all runs. series: is the last
    batch axis the time?
    """
    if belief.cov.flags.writeable:
        clip_variances(belief, series)
    belief.mean.flags.writeable = belief.cov.flags.writeable = False
    cov = with_batch(belief.cov, belief.mean.shape[:-1])
    return belief if cov is belief.cov else unchecked_gaussian(belief.mean, cov)


def scores(innovation, S_root=None):
    """NIS and log-likelihood of each step, (..., T) each; from triangular roots of S where they are known."""
    missing = np.isnan(innovation.mean)
    y = np.where(missing, 0, innovation.mean)
    if S_root is None:
        S = compact(innovation.cov)
        if missing.any():
            S = decouple_missing(S, missing)
        nis, log_det = squared_distance(y, S), log_determinant(S)
    else:
        nis = np.sum(solve_lower(S_root, y) ** 2, axis=-1)
        log_det = 2 * np.sum(np.log(abs(np.diagonal(S_root, axis1=-2, axis2=-1))), axis=-1)
    seen = (~missing).sum(axis=-1)
    log = -0.5 * (nis + log_det + seen * np.log(2 * np.pi))
    return np.where(seen > 0, nis, np.nan), log


def _stored(value):
    """A field without the axes along which its matrices only repeat themselves."""
    if isinstance(value, Gaussian):
        return unchecked_gaussian(value.mean, compact(value.cov))
    return compact(value) if isinstance(value, np.ndarray) and value.ndim > 2 else value


def _short(numbers):
    """The first six numbers of a vector, with four digits."""
    told = [f"{number:.4g}" for number in numbers[:6]]
    return f"[{', '.join([*told, '…'] if len(numbers) > 6 else told)}]"
