"""Each reading of a scan beside a prediction: which of them are inside its gate, and how well they fit."""

from math import gamma, pi
from typing import NamedTuple

import numpy as np

from ..core.conditioning import covariance_after, definite, divide, log_determinant
from ..core.matrices import step_matrix
from ..filters.gate import gate_limits
from ..filters.moments import linearize
from ..filters.steps import refuse_innovation
from ..models import checks as check
from ..models.arguments import check_belief, check_measure, check_model, check_step
from ..models.gaussian import Gaussian


class Pairs(NamedTuple):
    """A prediction beside the N readings of a scan; leading axes are those of runs and tracks.

    Attributes
    ----------
    predicted : Gaussian
        The belief before the scan, mean (..., n).
    innovation : ndarray (..., N, m)
        Reading minus predicted reading; NaN where a row has no reading.
    S : ndarray (..., m, m)
        The covariance of the innovation of the target's own reading.
    gain, corrected : ndarray (..., n, m), (..., n, n)
        The gain, and the covariance after a correction with one reading: both are the same for all readings.
    nis : ndarray (..., N)
        yᵀ S⁻¹ y, the squared distance in standard deviations; NaN where a row has no reading.
    gate, limit : float
        The probability that the target's own reading is inside the gate, and the largest NIS inside.
    """

    predicted: Gaussian
    innovation: np.ndarray
    S: np.ndarray
    gain: np.ndarray
    corrected: np.ndarray
    nis: np.ndarray
    gate: float
    limit: float

    @property
    def inside(self) -> np.ndarray:
        """Which readings are inside the gate, bool (..., N)."""
        return self.nis <= self.limit  # NaN is not

    @property
    def volume(self) -> np.ndarray:
        """The volume of the gate, (...): a length for m = 1, the area of an ellipse for m = 2."""
        m = self.S.shape[-1]
        ball = pi ** (m / 2) / gamma(m / 2 + 1)
        return ball * self.limit ** (m / 2) * np.exp(log_determinant(self.S) / 2)

    def log_ratio(self, detection, clutter) -> np.ndarray:
        """How much more probable it is that a reading is the target's than that it is false and the target was missed.

        The logarithm of P_D N(y; 0, S) / (λ (1 − P_D P_G)), (..., N); −∞ outside the gate. It is what PDA weighs by,
        and what an assignment adds up.
        """
        m = self.S.shape[-1]
        density = -0.5 * (self.nis + m * np.log(2 * pi) + log_determinant(self.S)[..., None])
        ratio = density + np.log(detection / (clutter * (1 - detection * self.gate)))
        return np.where(self.inside, ratio, -np.inf)


def pair_up(model, belief, z, *, gate=0.99, k=0) -> Pairs:
    """Compare a predicted belief with every reading of a scan.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states and m components of a reading; h is linearised.
    belief : Gaussian
        What was predicted, mean (..., n).
    z : array_like (..., N, m)
        The readings of the scan; a row of NaN is no reading.
    gate : float
        A probability such as 0.99: that of the target's own reading to be inside.
    k : int
        The step, for models whose matrices change with time.

    Returns
    -------
    Pairs
        .nis and .inside (..., N), .volume (...), .log_ratio(detection, clutter).

    Raises
    ------
    ValueError, TypeError
        Naming the argument; a reading must be there as a whole, or not at all.

    References
    ----------
    Bar-Shalom, Willett and Tian 2011, *Tracking and Data Fusion*

    Examples
    --------
    >>> from kflearn import Gaussian, pair_up, random_walk
    >>> found = pair_up(random_walk(0, 9), Gaussian(50, 16), [[53], [80], [42]], gate=0.99)
    >>> print(found.nis.round(2), found.inside, f"{found.volume:.1f}")
    [ 0.36 36.    2.56] [ True False  True] 25.8
    """
    check_model(model)
    check_belief("belief", belief, model)
    axes, z, limit = check_step(model, k), scan_readings(model, z, (None, model.m)), gate_limit(gate, model.m)
    check.batches(belief=belief.batch, z=z.shape[:-2], **axes)
    check_measure(model, belief.mean, k=k)
    return compare(model, belief, z, k, gate, limit)


def compare(model, predicted, z, k, gate, limit) -> Pairs:
    """The same without checks: predicted (...), z (..., N, m)."""
    expected = linearize(predicted, lambda x: model.measure(x, None, k), lambda x: model.measure_slope(x, None, k))
    R = step_matrix(model.R, k)
    S = expected.cov + R
    if not definite(S).all():
        refuse_innovation(k)
    y = model.difference(z, expected.mean[..., None, :])
    gain = divide(expected.cross, S)
    corrected = covariance_after(gain, predicted.cov, expected.slope, R)
    nis = (divide(y, S) * y).sum(axis=-1)
    return Pairs(predicted, y, S, gain, corrected, nis, gate, limit)


def scan_readings(model, z, shape) -> np.ndarray:
    """Scans as an array whose last axes have this shape, each reading whole or absent."""
    z = check.shape("z", check.numbers("z", z, gaps=True), shape)
    missing = np.isnan(z)
    if (missing.any(axis=-1) & ~missing.all(axis=-1)).any():
        raise ValueError("z must have whole readings in a scan: a row is all numbers, or all NaN for no reading")
    return z


def gate_limit(gate, m):
    """The largest NIS inside a gate for a whole reading."""
    if gate is None:
        raise ValueError("gate must be a probability between 0 and 1, such as 0.99, got None")
    return float(gate_limits(gate, m)[m])


def check_sensor(detection, clutter):
    """P_D and λ, from which weights and costs are made."""
    if not 0 < check.number("detection", detection) <= 1:
        raise ValueError(f"detection must be a probability above 0 and at most 1, got {detection}")
    check.number("clutter", clutter, positive=True)
