"""The gate: a reading whose NIS is too large to be believed is refused, as if it had not come."""

from typing import NamedTuple

import numpy as np

from ..models import checks as check
from ..models.gaussian import Gaussian
from ..results.track import scores


class Correction(NamedTuple):
    """What a correction did: the belief after it, the innovation z − ẑ with its covariance S, the gain, and refusals.

    innovation: Gaussian with mean (..., m), NaN where nothing was measured, and cov S (..., m, m). gain: (..., n, m),
    zero in the columns of what was not measured or not used. refused: bool (...), did the gate refuse the reading?
    """

    belief: Gaussian
    innovation: Gaussian
    gain: np.ndarray
    refused: np.ndarray


def gate_limits(gate, m):
    """The largest NIS that a gate lets pass, (m + 1,), for 0 … m components that were measured; None without a gate."""
    if gate is None:
        return None
    if not 0 < check.number("gate", gate) < 1:
        raise ValueError(f"gate must be a probability between 0 and 1, such as 0.99, got {gate!r}")
    from scipy.special import gammaincinv  # imported here: `import kflearn` shall not wait for SciPy

    return np.array([np.inf, *2 * gammaincinv(np.arange(1, m + 1) / 2, gate)])


def beyond(limits, innovation, S_root=None):
    """Which readings (...) a gate refuses, from their innovations and, where it is known, the root of S."""
    seen = (~np.isnan(innovation.mean)).sum(axis=-1)
    return scores(innovation, S_root)[0] > limits[seen]
