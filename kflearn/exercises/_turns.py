"""Trials of several sizes, in turn."""

from collections.abc import Callable
from itertools import cycle


def sized(make, *sizes) -> Callable:
    """Inputs whose size changes from trial to trial: the first size in the first trial, and so on, round and round.

    Examples
    --------
    >>> inputs = sized(lambda rng, n: (n * [1],), 2, 4)
    >>> inputs(None), inputs(None), inputs(None)
    (([1, 1],), ([1, 1, 1, 1],), ([1, 1],))
    """
    turn = cycle(sizes)
    return lambda rng: make(rng, next(turn))
