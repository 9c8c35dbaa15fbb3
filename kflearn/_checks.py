"""Checks of arguments: one clear sentence that names the argument, what was found and what was expected."""

import numpy as np


def numbers(name, value, gaps=False):
    """A copy of `value` as an array of float64; text, objects, complex numbers, infinity (and NaN unless `gaps`) are
    refused. Masked entries count as NaN.
    """
    if isinstance(value, np.ndarray) and hasattr(value, "filled") and value.dtype.kind in "biuf":  # np.ma loads slowly
        value = value.astype(float).filled(np.nan)
    try:
        given = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name} must be a regular array of numbers, but its rows have different lengths") from None
    except np.ma.MaskError:
        raise TypeError(f"{name} must consist of real numbers, found a masked one in a list") from None
    if given.dtype.kind not in "biuf":
        odd = next((v for v in given.flat if not isinstance(v, (int, float))), value)
        kind = "text" if isinstance(odd, (str, bytes)) else type(odd).__name__
        raise TypeError(f"{name} must consist of real numbers, found {kind}")
    if given.size == 0:
        raise ValueError(f"{name} must not be empty, got shape {given.shape}")
    array = given.astype(float)
    bad = np.isinf(array) if gaps else ~np.isfinite(array)
    if bad.any():
        but = " (only NaN may mark what was not measured)" if gaps else ""
        raise ValueError(f"{name} must be finite{but}, found {array[bad][0]}")
    return array


def number(name, value, positive=False):
    """One finite real number whose square is one too; `positive` asks for more than zero."""
    array = numbers(name, value)
    if array.size > 1:
        raise ValueError(f"{name} must be a single number, got shape {array.shape}")
    if positive and not array > 0:
        raise ValueError(f"{name} must be positive, got {array.item():g}")
    if not (array == 0 or 1e-150 < abs(array) < 1e150):
        raise ValueError(f"{name} must be 0, or of a size between 1e-150 and 1e150, got {array.item():g}")
    return array.item()


def shape(name, array, expected):
    """The last axes of `array` must have the lengths `expected`; None stands for any length."""
    found = array.shape[-len(expected) :]
    if len(found) < len(expected) or any(e not in (None, f) for e, f in zip(expected, found, strict=True)):
        wanted = ", ".join("any" if e is None else str(e) for e in expected)
        comma = "," if len(expected) == 1 else ""
        raise ValueError(f"{name} must have shape ({wanted}{comma}), got {found_in(array)}")
    return array


def found_in(array):
    """How to speak of an array of the wrong shape."""
    return f"{array.shape}" if array.ndim else f"the number {array:g}"


def matrix(name, value, rows=None, columns=None):
    """A copy of a matrix (rows, columns) or a stack (..., T, rows, columns); a plain number is a (1, 1) matrix."""
    array = numbers(name, value)
    if array.ndim == 0 and rows in (None, 1) and columns in (None, 1):
        array = array.reshape(1, 1)
    if array.ndim == 1:
        raise ValueError(f"{name} must be a matrix with two axes, got shape {array.shape}")
    array = shape(name, array, (rows, columns))
    array.flags.writeable = False  # a model or a belief that changed later would contradict what was made from it
    return array


def square(name, value, size=None):
    """A square matrix or a stack of them."""
    array = matrix(name, value, size, size)
    if array.shape[-1] != array.shape[-2]:
        raise ValueError(f"{name} must be square, got shape {array.shape}")
    return array


def covariance(name, value, size=None, definite=False):
    """A symmetric positive semi-definite matrix or a stack of them; `definite` asks for positive definite."""
    array = square(name, value, size)
    kind = "definite" if definite else "semi-definite"
    variances = np.diagonal(array, axis1=-2, axis2=-1)
    if (variances < 0).any() or (definite and (variances == 0).any()):
        raise ValueError(f"{name} must be positive {kind}, found {variances.min():g} on its diagonal")
    # Judge the correlations, not the covariances: then the units of the components do not matter. Only a variance 1e-28
    # times another one is a rounding error, and so are the covariances beside it.
    largest = variances.max(axis=-1, keepdims=True)
    scale = np.sqrt(np.where(variances > 1e-28 * largest, variances, np.where(largest > 0, 1e-14 * largest, 1)))
    correlation = array / scale[..., :, None] / scale[..., None, :]
    if (abs(correlation - correlation.mT) > 1e-9).any():
        raise ValueError(f"{name} must be symmetric, but it differs from its transpose")
    smallest = np.linalg.eigvalsh(correlation).min()
    if smallest < -1e-6 or (definite and smallest < 1e-14):
        raise ValueError(f"{name} must be positive {kind}, but its correlations have the eigenvalue {smallest:.2g}")
    return array


def sizes(name, value, count):
    """A positive number, or one for each of `count` components."""
    array = numbers(name, value)
    if array.ndim:
        shape(name, array, (count,))
    if bad := [size for size in array.flat if not 1e-150 < size < 1e150]:
        raise ValueError(f"{name} must be positive, of a size between 1e-150 and 1e150, found {bad[0]:g}")
    return array


def whole_number(name, value, least=1):
    """An integer that is at least `least`."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < least:
        raise ValueError(f"{name} must be a whole number of at least {least}, got {value!r}")
    if value >= 2**63:
        raise ValueError(f"{name} must be below 2**63, got a number of {len(str(value))} digits")
    return int(value)


def callable_or_none(name, value):
    """A function or None."""
    if value is not None and not callable(value):
        raise TypeError(f"{name} must be a function, got {type(value).__name__}")
    return value


def batches(**shapes):
    """The leading axes that those of all arguments broadcast to."""
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        found = {name: axes for name, axes in shapes.items() if axes}
        got = ", ".join(f"{name} {axes}" for name, axes in found.items())
        raise ValueError(f"{' and '.join(found)} must have batch axes that broadcast, got {got}") from None
