"""Checks of arguments: one clear sentence that names the argument, what was found and what was expected.

Each function takes the name of the argument and its value, and returns the value in the form in which the package uses
it. What it refuses is a ValueError or a TypeError.
"""

import numpy as np

from ..core.matrices import correlations

REAL = (int, float, np.integer, np.floating, np.bool_)  # what may stand in an array of objects


def numbers(name, value, gaps=False) -> np.ndarray:
    """A copy of `value` as an array of float64. Masked entries count as NaN.

    Text, complex numbers, other objects and infinity are refused, and NaN unless `gaps` is True.
    """
    given = _array_of_reals(name, value, gaps)
    if given.size == 0:
        raise ValueError(f"{name} must not be empty, got shape {given.shape}")
    try:
        array = given.astype(float)
    except OverflowError:
        raise ValueError(f"{name} must consist of numbers that a float can hold, found a larger one") from None
    bad = np.isinf(array) if gaps else ~np.isfinite(array)
    if bad.any():
        but = " (only NaN may mark what was not measured)" if gaps else ""
        raise ValueError(f"{name} must be finite{but}, found {array[bad][0]}")
    return array


def _array_of_reals(name, value, gaps):
    """`value` as an array of booleans, integers or floats, or of Python's and NumPy's real numbers as objects."""
    if isinstance(value, np.ndarray) and hasattr(value, "filled") and value.dtype.kind in "biufO":  # np.ma loads slowly
        value = (value if value.dtype.kind == "O" else value.astype(float)).filled(np.nan)
    try:
        given = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name} must be a regular array of numbers, but its rows have different lengths") from None
    except np.ma.MaskError:
        raise TypeError(f"{name} must consist of real numbers, found a masked one in a list") from None
    if given.dtype.kind in "biuf":
        return given
    strange = [v for v in given.flat if not isinstance(v, REAL) or isinstance(v, np.timedelta64)]
    if not strange:
        return given
    odd = strange[0]
    kind = "text" if isinstance(odd, (str, bytes)) else type(odd).__name__
    advice = ": use NaN for what was not measured" if odd is None and gaps else ""
    raise TypeError(f"{name} must consist of real numbers, found {kind}{advice}")


def number(name, value, positive=False, least=None) -> float:
    """One finite real number whose square is one too; `positive` asks for more than 0, `least` for at least that."""
    array = numbers(name, value)
    if array.size > 1:
        raise ValueError(f"{name} must be a single number, got shape {array.shape}")
    if positive and not array > 0:
        raise ValueError(f"{name} must be positive, got {array.item():g}")
    if least is not None and not array >= least:
        raise ValueError(f"{name} must be at least {least:g}, got {array.item():g}")
    if not (array == 0 or 1e-150 < abs(array) < 1e150):
        raise ValueError(f"{name} must be 0, or of a size between 1e-150 and 1e150, got {array.item():g}")
    return array.item()


def time_steps(name, value, zero=False) -> np.ndarray:
    """Seconds: one number above 0 (with `zero`, 0 or more), or an array (..., T) of numbers that are 0 or more."""
    array = numbers(name, value)
    if array.ndim == 0 and not zero:
        return np.array(number(name, value, positive=True))
    if (array < 0).any():
        raise ValueError(f"{name} must be at least 0 at each step, found {array[array < 0][0]:g}")
    if bad := [step for step in array.flat if step != 0 and not 1e-150 < step < 1e150]:
        raise ValueError(f"{name} must be 0, or of a size between 1e-150 and 1e150, found {bad[0]:g}")
    return array


def shape(name, array, expected, exact=False) -> np.ndarray:
    """The last axes of `array` must have the lengths `expected`; None stands for any length.

    With `exact` there must be no further axes in front of them.
    """
    found = array.shape[-len(expected) :]
    fits = len(found) == len(expected) and all(e in (None, f) for e, f in zip(expected, found, strict=True))
    if not fits or (exact and array.ndim != len(expected)):
        wanted = ", ".join("any" if e is None else str(e) for e in expected)
        comma = "," if len(expected) == 1 else ""
        raise ValueError(f"{name} must have shape ({wanted}{comma}), got {found_in(array)}")
    return array


def found_in(array) -> str:
    """How to speak of an array of the wrong shape."""
    return f"{array.shape}" if array.ndim else f"the number {array:g}"


def matrix(name, value, rows=None, columns=None, hint="") -> np.ndarray:
    """A copy of a matrix (rows, columns) or a stack (..., T, rows, columns); a plain number is a (1, 1) matrix.

    `hint` is added to the message where there is one axis only; it is a function of the array.
    """
    array = numbers(name, value)
    if array.ndim == 0 and rows in (None, 1) and columns in (None, 1):
        array = array.reshape(1, 1)
    if array.ndim == 1:
        advice = hint(array) if hint else ""
        raise ValueError(f"{name} must be a matrix with two axes, got shape {array.shape}{advice}")
    array = shape(name, array, (rows, columns))
    array.flags.writeable = False  # a model or a belief that changed later would contradict what was made from it
    return array


def square(name, value, size=None, hint="") -> np.ndarray:
    """A square matrix or a stack of them."""
    array = matrix(name, value, size, size, hint)
    if array.shape[-1] != array.shape[-2]:
        raise ValueError(f"{name} must be square, got shape {array.shape}")
    return array


def covariance(name, value, size=None, definite=False) -> np.ndarray:
    """A symmetric positive semi-definite matrix or a stack of them; `definite` asks for positive definite."""
    array = square(name, value, size, _variances_alone)
    kind = "definite" if definite else "semi-definite"
    variances = np.diagonal(array, axis1=-2, axis2=-1)
    if (variances < 0).any() or (definite and (variances == 0).any()):
        exact = name == "R" and variances.min() == 0
        way_out = "; no sensor is exact: one that tells steps of d has at least d²/12" if exact else ""
        raise ValueError(f"{name} must be positive {kind}, found {variances.min():g} on its diagonal{way_out}")
    if array.shape[-1] == 1:
        return array
    # Judge the correlations, not the covariances: then the units of the components do not matter.
    correlation, _ = correlations(array, np.sqrt(variances) if definite else _scale(variances))
    if (abs(correlation - correlation.mT) > 1e-9).any():
        raise ValueError(f"{name} must be symmetric, but it differs from its transpose")
    smallest = np.linalg.eigvalsh(correlation).min()
    if smallest < -1e-6 or (definite and smallest < 1e-14):
        raise ValueError(f"{name} must be positive {kind}, but its correlations have the eigenvalue {smallest:.2g}")
    return array


def _scale(variances):
    """Standard deviations; a variance 1e-28 times another one is a rounding error, and so are the covariances there."""
    largest = variances.max(axis=-1, keepdims=True)
    return np.sqrt(np.where(variances > 1e-28 * largest, variances, np.where(largest > 0, 1e-14 * largest, 1)))


def _variances_alone(array):
    shown = ", ".join(f"{v:g}" for v in array) if array.size <= 6 else "…"
    return f"; for variances alone use np.diag([{shown}])"


def sizes(name, value, count) -> np.ndarray:
    """A positive number, or one for each of `count` components."""
    array = numbers(name, value)
    if array.ndim:
        shape(name, array, (count,))
    if bad := [size for size in array.flat if not 1e-150 < size < 1e150]:
        raise ValueError(f"{name} must be positive, of a size between 1e-150 and 1e150, found {bad[0]:g}")
    return array


def whole_number(name, value, least=1) -> int:
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


def word(name, value, words) -> str:
    """One of several texts."""
    if not isinstance(value, str) or value not in words:
        found = " ".join(repr(value).split())
        found = found if len(found) <= 60 else found[:60] + "…"
        raise ValueError(f"{name} must be one of {', '.join(map(repr, words))}, got {found}")
    return value


def generator(name, value) -> np.random.Generator:
    """A random generator: `value` itself, or a new one from a seed (a whole number of at least 0), or from None."""
    try:
        return np.random.default_rng(value)
    except (TypeError, ValueError):
        found = " ".join(repr(value).split())[:60]
        raise TypeError(f"{name} must be a numpy Generator or a seed, got {found}") from None


def batches(**shapes) -> tuple[int, ...]:
    """The leading axes that those of all arguments broadcast to."""
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        found = {name: axes for name, axes in shapes.items() if axes}
        got = ", ".join(f"{name} {axes}" for name, axes in found.items())
        raise ValueError(f"{' and '.join(found)} must have batch axes that broadcast, got {got}") from None
