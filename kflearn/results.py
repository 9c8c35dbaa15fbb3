"""What a filter returns."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from .conditioning import hide, log_determinant, squared_distance
from .gaussian import Gaussian, tidy


@dataclass(frozen=True, eq=False)
class Filtered:
    """Beliefs after each measurement: a Gaussian with mean (..., T, n) and cov (..., T, n, n), read-only."""

    filtered: Gaussian

    def __post_init__(self):
        settled(self.filtered)

    @property
    def mean(self):
        """Short for filtered.mean."""
        return self.filtered.mean

    @property
    def cov(self):
        """Short for filtered.cov."""
        return self.filtered.cov

    @property
    def std(self):
        """Short for filtered.std, (..., T, n)."""
        return self.filtered.std


@dataclass(frozen=True, eq=False)
class Track(Filtered):
    """The beliefs of one run or of many, along time.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n), after each measurement.
    gain: (..., T, n, m), zero in the columns of what was not measured.
    predicted: Gaussian of the same shapes, before each measurement.
    innovation: Gaussian with mean z − ẑ (..., T, m), NaN where nothing was measured, and cov S (..., T, m, m).
    Where covariances and gains do not depend on the data they carry no batch axes: one sequence serves all runs.
    `predicted` and `innovation` are worked out when first asked for; so are `nis` and `log_likelihood`.
    u, through: the control inputs (..., T, p) or None, and how the filter pushed its beliefs through the model (see
    `moments`; None where no smoother may follow).
    """

    gain: np.ndarray = field(repr=False)
    _predicted: Callable[[], Gaussian] = field(repr=False)
    _innovation: Callable[[], Gaussian] = field(repr=False)
    u: np.ndarray | None = field(default=None, repr=False)
    through: Callable | None = field(default=None, repr=False)

    def __post_init__(self):
        super().__post_init__()
        self.gain.flags.writeable = False

    @cached_property
    def predicted(self):
        """The beliefs before each measurement."""
        return settled(self._predicted())

    @cached_property
    def innovation(self):
        """The differences between measured and expected, with the covariance S the filter gives them."""
        return settled(self._innovation())

    @cached_property
    def nis(self):
        """Normalised innovation squared yᵀ S⁻¹ y of what was measured, (..., T); NaN where nothing was."""
        return scores(self.innovation)[0]

    @cached_property
    def log_likelihood(self):
        """The logarithm of the probability density of the whole series under the model, (...)."""
        return scores(self.innovation)[1].sum(axis=-1)


def settled(belief):
    """The same belief, read-only: what is worked out later must still agree with it."""
    tidy(belief)
    belief.mean.flags.writeable = belief.cov.flags.writeable = False
    return belief


def scores(innovation):
    """NIS and log-likelihood of each step."""
    missing = np.isnan(innovation.mean)
    y, S = np.where(missing, 0, innovation.mean), innovation.cov
    if missing.any():
        S = hide(S, missing)
    nis = squared_distance(y, S)
    seen = (~missing).sum(axis=-1)
    log = -0.5 * (nis + log_determinant(S) + seen * np.log(2 * np.pi))
    return np.where(seen > 0, nis, np.nan), log
