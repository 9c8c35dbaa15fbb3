"""Derivatives by central differences."""

import numpy as np

from . import checks as check
from . import probe

RELATIVE_STEP = np.cbrt(np.finfo(float).eps)


def numerical_jacobian(function, x, difference=np.subtract, scale=1.0) -> np.ndarray:
    """The Jacobian of a function by central differences.

    It has 5 to 10 correct digits where the components of x are of the order of `scale` or larger: the step is
    6e-6 max(|x|, scale).

    Parameters
    ----------
    function : callable
        (..., n) → (..., m), on the last axis like the functions of a NonlinearModel; it is called with states that
        have one more axis in front, (n, ..., n).
    x : array_like (..., n)
        Where the slope is wanted.
    difference : callable
        difference(a, b) subtracts two values of the function; give the model's own for angles.
    scale : float or array_like (n,)
        The size of the components of x.

    Returns
    -------
    ndarray (..., m, n)

    Raises
    ------
    ValueError or TypeError
        Where x is not a state, `scale` does not fit or is not positive, or `function` does not treat each state alone.

    Examples
    --------
    >>> from kflearn import numerical_jacobian
    >>> J = numerical_jacobian(lambda x: x[..., :1] * x[..., 1:], [2, 3])
    >>> print(J.round(6))
    [[3. 2.]]
    """
    x = check.shape("x", check.numbers("x", x), (None,))
    scale = check.sizes("scale", scale, x.shape[-1])
    for name, given in (("function", function), ("difference", difference)):
        if not callable(given):
            raise TypeError(f"{name} must be a function, got {type(given).__name__}")
    values = probe.try_near("function", function, (None,), x, 1e-3 * np.maximum(abs(x), scale), scale)
    if difference is not np.subtract:
        probe.try_difference("difference", difference, values.astype(float))
    return central_differences(function, x, difference, scale)


def central_differences(function, x, difference, scale) -> np.ndarray:
    """What numerical_jacobian returns, without its checks."""
    step = RELATIVE_STEP * np.maximum(abs(x), scale)
    if x.ndim == 1:  # the same without axes of a batch: filters that go step by step spend their time here
        shift = step * np.eye(len(x))
        return difference(function(x + shift), function(x - shift)).T / (2 * step)
    shift = np.moveaxis(step[..., None, :] * np.eye(x.shape[-1]), -2, 0)
    return np.moveaxis(difference(function(x + shift), function(x - shift)), 0, -1) / (2 * step[..., None, :])
