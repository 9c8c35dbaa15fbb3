"""Objects whose arrays cannot be written to, not even in a copy or after pickling."""

import numpy as np


class Frozen:
    """A base class for frozen dataclasses: the arrays among their attributes stay read-only in every copy.

    NumPy keeps the flag "read-only" with the array, but `copy.deepcopy` and `pickle` do not. Python calls
    `__setstate__` after `copy.copy`, `copy.deepcopy` and `pickle.loads`, and there the flag is set again. Arrays inside
    tuples, lists and dicts are frozen too; an object inside the object (a Gaussian in a Track) is frozen by its own
    class.
    """

    __slots__ = ()

    def __setstate__(self, state):
        for name, value in state.items():
            object.__setattr__(self, name, freeze(value))


def freeze(value):
    """Make an array read-only, or every array in a tuple, list or dict; returns the same object."""
    if isinstance(value, np.ndarray):
        value.flags.writeable = False
    elif isinstance(value, (tuple, list)):
        for part in value:
            freeze(part)
    elif isinstance(value, dict):
        for part in value.values():
            freeze(part)
    return value
