"""Arrays stay read-only in copies."""

import copy
import pickle
from dataclasses import dataclass

import numpy as np
import pytest

from kflearn.core.frozen import Frozen, freeze


@dataclass(frozen=True, eq=False)
class Thing(Frozen):
    array: np.ndarray
    inside: tuple
    named: dict
    word: str = "word"

    def __post_init__(self):
        freeze(vars(self))


@pytest.mark.parametrize("again", [lambda it: it, copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
def test_no_array_can_be_written_to(again):
    thing = again(Thing(np.ones(2), (np.ones(3), [np.ones(1)]), {"a": np.ones(4)}))
    for array in (thing.array, thing.inside[0], thing.inside[1][0], thing.named["a"]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 7
        assert (array == 1).all()
    assert thing.word == "word"
    with pytest.raises(AttributeError):
        thing.array = 3
