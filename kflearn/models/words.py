"""How a model tells of its parts."""

import numpy as np


def in_words(matrix) -> str:
    """A small matrix with its numbers, any other array with its shape."""
    if matrix.ndim > 2 or matrix.size > 9:
        return f"({', '.join(map(str, matrix.shape))})"
    if matrix.size == 1:
        return f"{matrix.item():.4g}"
    return "[" + ", ".join("[" + ", ".join(f"{v:.4g}" for v in row) + "]" for row in np.atleast_2d(matrix)) + "]"


def name_of(function):
    """What a function is called, without its address in memory."""
    function = getattr(function, "func", function)  # of functools.partial
    return getattr(function, "__name__", type(function).__name__)
