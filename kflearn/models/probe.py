"""Functions that a user hands in, tried at several states before a filter relies on them.

The contract is that f, h, the Jacobians and residual work on the last axis and leave all leading axes alone: a state
(n,) gives one value, a batch (..., n) gives one value for each of its states. Therefore each function is called with
n + 1 different states, once for all of them together and once for each of them alone; both ways must give the same.
A function that mixes up the rows of a batch would pass a test of shapes, and the filter would be silently wrong.
"""

import numpy as np

FAILURES = (TypeError, ValueError, IndexError)  # what NumPy raises where shapes do not fit
STEPS = 0.6180339887498949, 0.41421356237309515  # irrational: the multiples, modulo 1, do not repeat


def try_near(name, function, expected, x, std, scale, inputs=()) -> np.ndarray:
    """Try a function of the state at n + 1 different states near x (n,), or (..., n); returns its values there.

    Two sets of states are tried before it is refused: at a jump of the function rounding alone can make a difference.

    Parameters
    ----------
    name : str
        What the error calls the function.
    function : callable
        Takes states (..., n), or states and inputs (..., p), and returns (..., *expected).
    expected : tuple
        The lengths of the last axes of what it returns; None stands for any length.
    x, std : ndarray (n,)
        The state that matters, and how far from it the function is tried.
    scale : float or ndarray (n,)
        The size of the states.
    inputs : sequence of ndarray (p,) or (n + 1, p)
        Further arguments.

    Raises
    ------
    ValueError or TypeError
        If shapes are wrong, something is raised, or a state together with others gives another value than alone.
    """
    for step in STEPS:
        rows = _states_near(x, std, scale, step), *inputs
        values, wrong = _try_rows(name, function, expected, rows)
        if wrong is None:
            return values
    raise ValueError(_mixed(name, wrong, len(values)))


def try_difference(name, function, values):
    """Try a difference of two values of a function at `values` (count, ..., m), as `try_near` returned them.

    Every second pair is 300 to 1000 apart, so that angles in degrees or in radians have to wrap.
    """
    last = values.shape[-1:]
    for step in STEPS:
        shares = np.arange(1, values.size + 1).reshape(values.shape) * step % 1
        z = np.roll(values, 1, axis=0)
        z[1::2] += (np.where(shares > 0.5, 700, -700) * shares + np.where(shares > 0.5, 300, -300))[1::2]
        _, wrong = _try_rows(name, function, last, (z, values))
        if wrong is None:
            break
    else:
        raise ValueError(_mixed(name, wrong, len(values)))
    # The sigma points of a batch are compared with one value each: the second argument has fewer axes.
    call(name, function, last, read_only(z[:, None] if z.ndim == 2 else z), read_only(values[0]))


def _mixed(name, row, count):
    """What is said of a function that mixes up the rows of a batch."""
    return (
        f"{name} must treat each state alone, but row {row} of a batch of {count} is not what it returns for that "
        "state alone: index the last axis, for instance y[..., 1]"
    )


def _states_near(x, std, scale, step):
    """n + 1 different states, (n + 1, ..., n): x (..., n) itself and n others within a standard deviation of it.

    std (n,) is at least 1/10,000 and at most 1000 times max(|x|, scale): with P = 0 the states must differ too, and a
    start that is hardly known must not lead to states at which rounding errors are all there is.
    """
    n = x.shape[-1]
    size = np.maximum(abs(x), scale)
    reach = np.clip(std, 1e-4 * size, 1e3 * size)
    shares = np.arange(1, n * n + 1).reshape(n, *(1,) * (x.ndim - 1), n) * step % 1  # between 0 and 1
    return np.concatenate([x[None], x + reach * (2 * shares - 1)])


def _try_rows(name, function, expected, rows):
    """The values of a function for each row alone, and the first row that has another value together with all others.

    rows: the arguments (count, n), or (count, ..., n), different states, the first of them the one that matters; an
    argument (p,) serves all rows.
    """
    rows = list(map(read_only, rows))
    try:
        alone, together = _both_ways(name, function, expected, rows)
    except ValueError:
        # Perhaps the function is defined near the first row only: then copies of this row must do.
        rows = [a if a.ndim == 1 else np.broadcast_to(a[:1], a.shape) for a in rows]
        alone, together = _both_ways(name, function, expected, rows)
    return alone, _first_difference(np.broadcast_to(together, alone.shape), alone)


def _both_ways(name, function, expected, rows):
    """The values of a function for each row alone, and for all at once."""
    each = [call(name, function, expected, *(a if a.ndim == 1 else a[i] for a in rows)) for i in range(len(rows[0]))]
    return np.array(each), _all_rows(name, function, expected, rows)


def _all_rows(name, function, expected, rows):
    """The values of a function for all rows at once, which have three axes or more: it must not count on two."""
    together = call(name, function, expected, *(a[:, None] if a.ndim == 2 else a for a in rows))
    added = rows[0].ndim == 2 and together.ndim > len(expected)
    return together[:, 0] if added else together


def read_only(array):
    """A view that cannot be written to: a function that overwrites the filter's states is found out."""
    view = array.view()
    view.flags.writeable = False
    return view


def call(name, function, expected, *arguments) -> np.ndarray:
    """The value of a function as an array whose shape was checked: (..., *expected) for states (..., n).

    A Jacobian may also be constant, (m, n) for any number of states.
    """
    states = arguments[0].shape
    try:
        with np.errstate(all="ignore"):
            value = function(*arguments)
        found = np.shape(value)
    except FAILURES as error:
        reason = str(error).split(". ")[0]
        raise ValueError(
            f"{_wanted(name, expected)}, got an error for an argument of shape {states}: {reason}"
        ) from error
    if isinstance(value, (list, tuple)):
        raise TypeError(f"{name} must return an array, got a {type(value).__name__}")
    if found != (*states[:-1], *expected):
        _check_shape(name, found, expected, states)
    return np.asarray(value)


def _check_shape(name, found, expected, states):
    """Where a shape is not simply (*states[:-1], *expected): a constant Jacobian is right, and None is any length."""
    front, last = found[: max(len(found) - len(expected), 0)], found[-len(expected) :]
    fits = len(last) == len(expected) and all(e in (None, f) for e, f in zip(expected, last, strict=True))
    constant = name.endswith("jacobian") and front == ()
    if not fits or not (constant or front == states[:-1]):
        raise ValueError(f"{_wanted(name, expected)}, got {found} for an argument of shape {states}")


def _wanted(name, expected):
    return f"{name} must return shape ({', '.join(['...', *('m' if e is None else str(e) for e in expected)])})"


def _first_difference(together, alone):
    """The first row in which two arrays (count, ...) differ by more than rounding; None where there is none.

    Rounding: a thousandth of what a column varies by, or 1e-9 of the largest number (100 units of float32, if it is
    that). NaN equals NaN, and infinity equals infinity: far from the initial state a function need not be defined.
    """
    if together.dtype.kind not in "biuf" or alone.dtype.kind not in "biuf" or (together == alone).all():
        return None  # complex numbers and other objects are refused elsewhere
    eps = np.finfo(together.dtype).eps if together.dtype.kind == "f" else 0
    together, alone = together.astype(float), alone.astype(float)
    known = np.isfinite(alone)
    high = np.max(np.where(known, alone, -np.inf), axis=0)
    low = np.min(np.where(known, alone, np.inf), axis=0)
    largest = np.max(abs(alone), where=known, initial=0)
    tolerance = 1e-3 * np.where(high > low, high - low, 0) + max(1e-9, 100 * eps) * largest
    with np.errstate(invalid="ignore"):
        same = (abs(together - alone) <= tolerance) | (together == alone) | (np.isnan(together) & np.isnan(alone))
    wrong = np.flatnonzero(~same.reshape(len(same), -1).all(axis=1))
    return int(wrong[0]) if wrong.size else None
