"""Checks of arguments: one clear sentence that names the argument, what was found and what was expected."""

import numpy as np


def numbers(name, value, gaps=False):
    """`value` as an array of float64; text, objects, complex numbers, infinity (and NaN unless `gaps`) are refused.

    The array may be the caller's own: never write into it. Masked entries count as NaN.
    """
    if np.ma.isMaskedArray(value):
        value = value.astype(float).filled(np.nan)
    try:
        given = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name} must be a regular array of numbers, but its rows have different lengths") from None
    if given.dtype.kind not in "biuf":
        kind = type(value).__name__ if given.dtype.kind == "O" else given.dtype.name
        raise TypeError(f"{name} must consist of real numbers, got {kind}")
    if given.size == 0:
        raise ValueError(f"{name} must not be empty, got shape {given.shape}")
    array = given.astype(float, copy=False)
    bad = np.isinf(array) if gaps else ~np.isfinite(array)
    if bad.any():
        but = " (only NaN may mark what was not measured)" if gaps else ""
        raise ValueError(f"{name} must be finite{but}, found {array[bad][0]}")
    return array


def shape(name, array, expected):
    """The last axes of `array` must have the lengths `expected`; None stands for any length."""
    found = array.shape[-len(expected) :]
    if len(found) < len(expected) or any(e not in (None, f) for e, f in zip(expected, found, strict=True)):
        wanted = ", ".join("any" if e is None else str(e) for e in expected)
        comma = "," if len(expected) == 1 else ""
        raise ValueError(f"{name} must have shape ({wanted}{comma}), got {array.shape}")
    return array


def matrix(name, value, rows=None, columns=None):
    """A copy of a matrix (rows, columns) or a stack (..., T, rows, columns); a plain number is a (1, 1) matrix."""
    array = numbers(name, value).copy()
    if array.ndim == 0:
        array = array.reshape(1, 1)
    if array.ndim == 1:
        raise ValueError(f"{name} must be a matrix with two axes, got shape {array.shape}")
    return shape(name, array, (rows, columns))


def covariance(name, value, size=None, definite=False):
    """A symmetric positive semi-definite matrix or a stack of them; `definite` asks for positive definite."""
    array = matrix(name, value, size, size)
    if array.shape[-1] != array.shape[-2]:
        raise ValueError(f"{name} must be square, got shape {array.shape}")
    if (abs(array - array.mT) > 1e-9 * abs(array).max()).any():
        raise ValueError(f"{name} must be symmetric, but it differs from its transpose")
    kind = "definite" if definite else "semi-definite"
    variances = np.diagonal(array, axis1=-2, axis2=-1)
    if (variances < 0).any() or (definite and (variances == 0).any()):
        raise ValueError(f"{name} must be positive {kind}, found {variances.min():g} on its diagonal")
    # Judge the correlations, not the covariances: then the units of the components do not matter.
    scale = np.sqrt(np.where(variances > 0, variances, 1))
    correlation = array / scale[..., :, None] / scale[..., None, :]
    smallest = np.linalg.eigvalsh(correlation).min()
    if smallest < -1e-9 or (definite and smallest < 1e-14):
        raise ValueError(f"{name} must be positive {kind}, but its correlations have the eigenvalue {smallest:.2g}")
    return array


def whole_number(name, value, least=1):
    """An integer that is at least `least`."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < least:
        raise ValueError(f"{name} must be a whole number of at least {least}, got {value!r}")
    return int(value)


def callable_or_none(name, value):
    """A function or None."""
    if value is not None and not callable(value):
        raise TypeError(f"{name} must be a function, got {type(value).__name__}")
    return value
