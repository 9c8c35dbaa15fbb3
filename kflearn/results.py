"""What a filter returns."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from .gaussian import Gaussian, tidy


@dataclass(frozen=True, eq=False)
class Track:
    """The beliefs of one run or of many, along time.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n), after each measurement.
    gain: (..., T, n, m), zero in the columns of what was not measured.
    predicted: Gaussian of the same shapes, before each measurement.
    innovation: Gaussian with mean z − ẑ (..., T, m), NaN where nothing was measured, and cov S (..., T, m, m).
    Where covariances and gains do not depend on the data they carry no batch axes: one sequence serves all runs.
    `predicted` and `innovation` are worked out when first asked for; so are `nis` and `log_likelihood`.
    """

    filtered: Gaussian
    gain: np.ndarray = field(repr=False)
    _predicted: Callable[[], Gaussian] = field(repr=False)
    _innovation: Callable[[], Gaussian] = field(repr=False)

    def __post_init__(self):
        self.gain.flags.writeable = False
        _fixed(self.filtered)

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

    @cached_property
    def predicted(self):
        """The beliefs before each measurement."""
        return _fixed(self._predicted())

    @cached_property
    def innovation(self):
        """The differences between measured and expected, with the covariance S the filter gives them."""
        return _fixed(self._innovation())

    @cached_property
    def nis(self):
        """Normalised innovation squared yᵀ S⁻¹ y of what was measured, (..., T); NaN where nothing was."""
        return _scores(self.innovation)[0]

    @cached_property
    def log_likelihood(self):
        """The logarithm of the probability density of the whole series under the model, (...)."""
        return _scores(self.innovation)[1].sum(axis=-1)


def _fixed(belief):
    """The same belief, read-only: what is worked out later must still agree with it."""
    tidy(belief)
    belief.mean.flags.writeable = belief.cov.flags.writeable = False
    return belief


def _scores(innovation):
    """NIS and log-likelihood of each step."""
    missing = np.isnan(innovation.mean)
    y, S = np.where(missing, 0, innovation.mean), innovation.cov
    if missing.any():
        S = hide(S, missing)
    nis = squared_distance(y, S)
    seen = (~missing).sum(axis=-1)
    log = -0.5 * (nis + np.linalg.slogdet(S)[1] + seen * np.log(2 * np.pi))
    return np.where(seen > 0, nis, np.nan), log


def hide(R, missing):
    """A covariance in which the missing components (..., m) have become independent with variance 1."""
    seen = ~missing
    return R * (seen[..., :, None] & seen[..., None, :]) + missing[..., :, None] * np.eye(missing.shape[-1])


def divide(C, S):
    """C S⁻¹ for C (..., n, m) and S (..., m, m), by solving; by Cramer's rule for m = 1 and 2, which is far faster."""
    if S.shape[-1] == 1:
        return C / S
    if S.shape[-1] == 2:
        adjugate = S[..., ::-1, ::-1].mT * _SIGNS
        determinant = S[..., 0, 0] * S[..., 1, 1] - S[..., 0, 1] * S[..., 1, 0]
        return C @ adjugate / determinant[..., None, None]
    return np.linalg.solve(S.mT, C.mT).mT


_SIGNS = np.array([[1.0, -1.0], [-1.0, 1.0]])


def squared_distance(y, S):
    """yᵀ S⁻¹ y for y (..., m) and S (..., m, m)."""
    return (divide(y[..., None, :], S) @ y[..., :, None])[..., 0, 0]
