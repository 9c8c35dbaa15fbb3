"""Values, shapes, counts and choices in a few characters, for the sentences of the exercises."""

import textwrap

import numpy as np

ENTRIES_SHOWN = 12  # a larger array is named by its shape


def is_gaussian(value):
    """Anything with a mean and a covariance that are values (an array's mean is a method)."""
    return all(hasattr(value, name) and not callable(getattr(value, name)) for name in ("mean", "cov"))


def show(value, digits=4, exact=False) -> str:
    """A value in a few characters: numbers with four significant digits, a large array by its shape.

    Where `exact`, a number that ends after twelve digits or fewer is shown whole: an input that a learner may try.
    """
    if is_gaussian(value):
        return f"N({show(value.mean, digits, exact)}, {show(value.cov, digits, exact)})"
    if isinstance(value, tuple):
        return f"({', '.join(show(part, digits, exact) for part in value)})"
    array = np.asarray(value)
    if array.dtype.kind not in "biufc":
        return f"a {type(value).__name__}"
    if array.size > ENTRIES_SHOWN:
        return f"an array of shape {array.shape}"
    if array.ndim:
        return f"[{', '.join(show(row, digits, exact) for row in array)}]"
    if array.dtype == bool:
        return str(array)
    number = array.item() + 0  # + 0 turns -0 into 0
    lengths = range(digits, 13) if exact and array.dtype.kind in "iuf" else ()
    whole = (f"{number:.{length}g}" for length in lengths)
    return next((text for text in whole if np.isclose(float(text), number, 1e-13, 0)), f"{number:.{digits}g}")


def form(shape, kind="f"):
    single = "True or False" if kind == "b" else "one number"
    return f"an array of shape {shape}" if shape else single


def count(number, noun):
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def listed(choices, names=None) -> str:
    """Choices in order, on a short line; as they are named, else letters as capitals."""
    names = names or {}
    texts = (names.get(choice, choice.upper() if len(choice) == 1 else choice) for choice in choices)
    line = ", ".join(sorted(texts, key=lambda name: (len(name), name)))
    return textwrap.shorten(line, 160, placeholder="…")
