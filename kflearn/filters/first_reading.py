"""Two conventions of the start: the belief one step before the first reading, or at the time of the first reading.

kflearn, FilterPy, OpenCV and kalman-py hold the first, pykalman's filter, statsmodels, simdkalman and dynamax the
second. These two functions lead from one to the other, and nothing is lost: neither a reading nor its likelihood.
"""

import numpy as np

from ..models import checks as check
from ..models.arguments import check_stacks
from ..models.gaussian import Gaussian
from ..models.state_space import LinearModel
from .steps import predict


def to_first_reading(model, initial, u=None) -> Gaussian:
    """kflearn's start for a library that wants the belief at the time of the first reading: eqs (5) and (6), once.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states.
    initial : Gaussian
        The belief one step before the first reading, as every filter of kflearn takes it; mean (..., n), in the
        units of the states.
    u : array_like, optional
        The control input (p,) of the first step, u[0] of a series.

    Returns
    -------
    Gaussian
        The belief at the time of the first reading and before it: for pykalman's KalmanFilter, statsmodels, simdkalman
        and dynamax.

    Raises
    ------
    ValueError, TypeError
        Naming the argument that does not fit.

    References
    ----------
    Durbin and Koopman 2012, sec. 4.3, start with this belief; Bar-Shalom, Li and Kirubarajan 2001, ch. 5.2, with the
    one before.

    Examples
    --------
    >>> from kflearn import Gaussian, random_walk, to_first_reading
    >>> print(f"{to_first_reading(random_walk(Q=4, R=1), Gaussian(10, 9)):.0f}")
    N(10, 13)
    """
    return predict(model, initial, u)


def from_first_reading(model, steps) -> LinearModel:
    """A model for a start that is given at the time of the first reading: nothing happens on the way to that reading.

    Filter with it as usual: kalman_filter(from_first_reading(model, len(z)), z, belief). Track, likelihood and smoother
    are those of the libraries that hold this convention.

    Parameters
    ----------
    model : LinearModel
        Its matrices may be stacks; the first F, Q and B of a stack are not used, nor is u[0].
    steps : int
        How many readings there are, T.

    Returns
    -------
    LinearModel
        With F = I, Q = 0 and B = 0 at the first step, and the matrices of `model` at all others: stacks (..., T, n, n).

    Raises
    ------
    ValueError, TypeError
        Where model is no LinearModel, steps is no whole number of at least 1, or a stack has another number of steps.

    References
    ----------
    Durbin and Koopman 2012, sec. 4.3.

    Examples
    --------
    >>> from kflearn import Gaussian, from_first_reading, kalman_filter, random_walk
    >>> model = from_first_reading(random_walk(Q=4, R=1), steps=3)
    >>> track = kalman_filter(model, [11.0, 12.0, 11.5], Gaussian(10, 9))
    >>> print(f"variance {track.predicted.cov[0, 0, 0]:.1f}, after the first reading {track.cov[0, 0, 0]:.1f}")
    variance 9.0, after the first reading 0.9
    """
    if not isinstance(model, LinearModel):
        raise TypeError(f"model must be a LinearModel, got {type(model).__name__}")
    steps = check.whole_number("steps", steps)
    check_stacks(model, steps)
    still = {"F": np.eye(model.n), "Q": 0.0} | ({} if model.B is None else {"B": 0.0})
    return model.replace(**{name: _first(getattr(model, name), steps, value) for name, value in still.items()})


def _first(matrix, steps, value):
    """A matrix or a stack of them as a stack of `steps` matrices, the first of which is `value`."""
    stack = matrix if matrix.ndim > 2 else matrix[None]
    stack = np.broadcast_to(stack, (*stack.shape[:-3], steps, *stack.shape[-2:])).copy()
    stack[..., 0, :, :] = value
    return stack
