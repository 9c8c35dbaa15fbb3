"""Whether a number that was typed is a certain value: nearly, or rounded to the digits that were typed."""

import numpy as np

from kflearn.exercises._answers import parts


def typed(answer, value, rtol) -> bool:
    """Whether an answer is a value within a narrow tolerance, or that value rounded to the digits that were typed.

    Examples
    --------
    >>> typed(61.67, 61.6667, 1e-4), typed(63.02, 63.0, 1e-4), typed(63.02, 63.0197, 1e-4)
    (True, False, True)
    """
    pairs = zip(_numbers_in(answer), _numbers_in(value), strict=False)
    return all(_near(one, other, rtol) for one, other in pairs)


def _numbers_in(value):
    """All numbers of a value in a flat list; none of what is no number."""
    pieces = list(parts(value).values()) or (value if isinstance(value, list) else [])
    if pieces:
        return [number for piece in pieces for number in _numbers_in(piece)]
    try:
        return np.ravel(np.asarray(value, float)).tolist()
    except (TypeError, ValueError, OverflowError):
        return []


def _near(one, other, rtol):
    """One number: within the tolerance (a whole one within 5e-5), or rounded to three digits or more."""
    if np.isinf(other) or other == 0:
        return one == other or abs(one - other) < 1e-12  # zero comes out of a sum as a rounding error
    rounded = any(abs(one - float(f"{other:.{digits}g}")) < 1e-12 * abs(other) for digits in (3, 4, 5, 6))
    return abs(one - other) <= (5e-5 if other == round(other) else rtol) * abs(other) or (
        rounded and other != round(other)
    )
