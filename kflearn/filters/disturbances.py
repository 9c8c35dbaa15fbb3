"""What the smoothed states say of the noises: which reading was odd, and when the state itself broke."""

from typing import NamedTuple

import numpy as np

from ..core.matrices import compact, congruence
from ..core.recursion import matvec_each_step
from ..models.state_space import LinearModel
from ..results.track import LinearSteps
from .smoothing import smoothed, with_lag


class Disturbances(NamedTuple):
    """The noises as all readings together tell them, divided by their standard deviations: beyond ±3 something was odd.

    measurement (..., T, m): of each reading, an outlier where it is large; NaN where nothing was measured. state
    (..., T, n): of the step to each k, a break where it is large; NaN for the first step, and where Q moves nothing.
    """

    measurement: np.ndarray
    state: np.ndarray


def disturbances(model, track) -> Disturbances:
    """The smoothed noises of a linear model, in standard deviations (auxiliary residuals).

    Parameters
    ----------
    model : LinearModel
        The model the track was filtered with.
    track : Track
        From kalman_filter or square_root_kalman_filter.

    Returns
    -------
    Disturbances

    Raises
    ------
    ValueError, TypeError
        As rts_smoother.

    References
    ----------
    Harvey and Koopman 1992; Durbin and Koopman 2012, sec. 4.5.

    Examples
    --------
    >>> from kflearn import Gaussian, disturbances, kalman_filter, random_walk
    >>> model = random_walk(0.1, 1)
    >>> track = kalman_filter(model, [0.0, 0.2, 5.0, -0.1, 0.1, 0.3], Gaussian(0, 1))
    >>> print(f"{disturbances(model, track).measurement[2, 0]:.1f}")
    4.4
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    if not isinstance(getattr(track, "_later", None), LinearSteps):
        raise TypeError("track must come from kalman_filter or square_root_kalman_filter")
    smooth, lag = with_lag(*smoothed(model, track))
    cov, z = compact(smooth.cov, 3), track._later.z
    left = z - matvec_each_step(model.H, smooth.mean)
    told = _variances(model.R) - _variances(congruence(model.H, cov)[0])
    F, Q = (M if M.ndim == 2 or M.shape[-3] == 1 else M[..., 1:, :, :] for M in (model.F, model.Q))
    moved = matvec_each_step(F, smooth.mean[..., :-1, :])
    if track.u is not None:
        moved = moved + matvec_each_step(model.B, track.u)[..., 1:, :]
    back = lag @ F.mT
    unknown = cov[..., 1:, :, :] + congruence(F, cov[..., :-1, :, :])[0] - back - back.mT
    steps = _scaled(smooth.mean[..., 1:, :] - moved, _variances(Q) - _variances(unknown), _variances(Q))
    first = np.full_like(smooth.mean[..., :1, :], np.nan)
    return Disturbances(_scaled(left, told, _variances(model.R)), np.concatenate([first, steps], axis=-2))


def _variances(P):
    return np.diagonal(P, axis1=-2, axis2=-1)


def _scaled(noise, told, own):
    """Noises in standard deviations; NaN where the readings tell nothing of them."""
    with np.errstate(all="ignore"):
        return np.where(told > 1e-9 * own, noise / np.sqrt(told), np.nan)
