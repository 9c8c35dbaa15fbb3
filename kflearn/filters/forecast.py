"""What comes next: beliefs about states and readings after the last measurement of a track."""

from typing import NamedTuple

import numpy as np

from ..core.matrices import step_matrix, symmetric
from ..models import checks as check
from ..models.arguments import check_control_series
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.state_space import stacks
from ..results.track import Track, stack_in_time
from .steps import at_step, expected_measurement, predicted_belief


class Forecast(NamedTuple):
    """Beliefs about the steps that follow a track: states (..., steps, n) and readings (..., steps, m), the latter with
    the measurement noise in them, so that 95 % of the readings come within ±1.96 of their `std`."""

    states: Gaussian
    readings: Gaussian


def forecast(track, steps, u=None) -> Forecast:
    """The states and the readings of the steps after a track, before they are measured.

    Parameters
    ----------
    track : Track
        Of a filter with one model; whose matrices must be the same at all steps.
    steps : int
        How many steps ahead.
    u : array_like, optional
        Control inputs of these steps, (..., steps, p).

    Returns
    -------
    Forecast

    Raises
    ------
    ValueError, TypeError
        Naming the argument; also where the model changes from step to step, since nobody told how it goes on.

    References
    ----------
    Durbin and Koopman 2012, sec. 4.11.

    Examples
    --------
    >>> from kflearn import Gaussian, forecast, kalman_filter, random_walk
    >>> track = kalman_filter(random_walk(1, 4), [1.0, 2.0, 1.5], Gaussian(0, 10))
    >>> ahead = forecast(track, 3)
    >>> print(f"{ahead.readings.mean[2, 0]:.2f} ± {ahead.readings.std[2, 0]:.2f}")
    1.42 ± 2.95
    """
    if not isinstance(track, Track) or track.through is None:
        raise TypeError("track must be a Track of a filter with one model that can be smoothed")
    steps, model = check.whole_number("steps", steps, least=1), track.model
    if any(M.shape[-3] > 1 for M in stacks(model).values()):
        raise ValueError("track must have a model with the same matrices at all steps: how do these go on?")
    u = None if u is None else check_control_series(model, u, steps)
    belief, states, readings = track[-1], [], []
    for k in range(steps):
        belief = predicted_belief(model, belief, at_step(u, k), k, track.through)
        expected, _ = expected_measurement(model, belief, np.nan, k, track.through, at_step(u, k))
        states.append(belief)
        readings.append(unchecked_gaussian(expected.mean, symmetric(expected.cov + step_matrix(model.R, k))))
    return Forecast(stack_in_time(states), stack_in_time(readings))
