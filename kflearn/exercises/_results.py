"""The results of a filter that is judged: mean and covariance, and what is said where they are none."""

import numpy as np

from kflearn.exercises._shown import count


def pair(answer):
    """Mean and covariance of what a filter returned."""
    if hasattr(answer, "cov") and not callable(answer.cov):
        return np.asarray(answer.mean, float), np.asarray(answer.cov, float)
    mean, cov = answer
    return np.asarray(mean, float), np.asarray(cov, float)


def unusual(answer):
    """What is said of a dictionary or of complex numbers; None of anything else."""
    if isinstance(answer, dict):
        return "is a dictionary: return the values one after the other, without names"
    rows = answer if isinstance(answer, (tuple, list)) else [answer]
    numbers = [row for row in rows if isinstance(row, (complex, np.ndarray, np.generic))]
    return "holds complex numbers: real ones are wanted" if any(map(np.iscomplexobj, numbers)) else None


def shape_of(answer):
    """The shape of an array of numbers, or of lists that make one; else None."""
    try:
        return np.asarray(answer, float).shape
    except (TypeError, ValueError):
        return None


def unlike(answer, shape):
    """What is said of a result that is not one array of this shape; None of one that is."""
    if isinstance(answer, tuple) and len(answer) != shape[0]:
        return f"is a tuple of {len(answer)} items: one array of shape {shape} is wanted"
    try:
        array = np.asarray(answer)
    except ValueError:
        return f"is a list of rows of different lengths: an array of shape {shape} is wanted"
    if array.dtype.kind not in "biuf" and not array.ndim:  # a text, a set, a function
        return f"is of type {type(answer).__name__}: an array of shape {shape} is wanted"
    found = array.shape
    return None if found == shape else f"should be of shape {shape}, but is {found}"


def of_rows(answer, T, states):
    """What is said of a result that is not two arrays, such as a list with a pair for each reading."""
    wanted = f"two arrays are wanted, the means {(T, states)} and the covariances {(T, states, states)}"
    rows = answer if isinstance(answer, (list, tuple)) else []
    if rows and all((isinstance(row, (list, tuple)) and len(row) == 2) or hasattr(row, "cov") for row in rows):
        return f"is one list with a mean and a covariance for each reading: {wanted}"
    found = f"a {type(answer).__name__} of {count(len(rows), 'item')}" if rows else f"of type {type(answer).__name__}"
    return f"is {found}: {wanted}"


def first_endless(answer):
    """The first reading at which a result is not finite; None where all of it is."""
    parts = (answer.mean, answer.cov) if hasattr(answer, "cov") and not callable(answer.cov) else answer
    rows = [np.asarray(part, float) for part in (parts if isinstance(parts, tuple) else [parts])]
    found = [np.argwhere(~np.isfinite(row)) for row in rows]
    steps = [places[0][0 if row.ndim < 4 else 1] for row, places in zip(rows, found, strict=True) if len(places)]
    return min(map(int, steps), default=None)


ROWS_OF_NAN = "This scan holds rows of NaN, which are no readings: leave them out before the NIS and the weights."
SOME_NAN = "This reading holds NaN beside the numbers, and whatever is calculated with NaN is NaN: use the numbers that are there."


def of_gaps(inputs, at):
    """What is said of a result that is not finite from step `at` on: what the missing readings tell of the cause."""
    series = [part for part in map(np.asarray, inputs) if part.dtype.kind == "f" and part.ndim]
    longest = max(map(len, series), default=0)
    rows = [np.isnan(part.reshape(longest, -1)) for part in series if len(part) == longest > at]
    missing, some = (
        np.any([kind(row, axis=1)[: at + 1] for row in rows] or [np.zeros(at + 1, bool)], axis=0)
        for kind in (np.all, np.any)
    )
    if some[at] and not (missing[at] or some[:at].any()):
        scans = any(part.ndim == 3 and len(part) == longest for part in series)
        return f". {ROWS_OF_NAN if scans else SOME_NAN}"
    if missing[at]:
        return ". There the reading is NaN, and whatever is calculated with NaN is NaN: predict, and leave the correction out."
    if some[at]:
        said = "It holds NaN beside the numbers, as others before it did, which have been passed:"
    elif missing[: max(at - 1, 0)].any():
        said = "The reading there is a number, and missing readings have been passed before: is a NaN of them kept, or"
    elif at and missing[at - 1]:
        return ". It is the first after a missing reading: is something made of that NaN kept, such as an innovation in a window?"
    else:
        said = "The reading there is a number:"
    return f". {said} is it the root of a negative number, or a division by zero?"


def singular(answers):
    """What is said of covariances of which one has no inverse."""
    for recording, answer in enumerate(answers, 1):
        for k, P in enumerate(pair(answer)[1]):
            try:
                np.linalg.inv(P)
            except np.linalg.LinAlgError:
                where = f"For recording {recording} P has no inverse at reading {k + 1}: it claims that something is known exactly"
                return f"{where}. Is R in S, and Q in the prediction? Nothing else is judged yet."
    return "A covariance has no inverse: it claims that something is known exactly. Nothing else is judged yet."
