"""What strangers handed in, lesson by lesson: right answers pass, and the others are told what is wrong with them."""

import pkgutil
from importlib import import_module

import pytest

from tests.exercises import answers
from tests.exercises.hand_in import assert_right, assert_told


def rows(table):
    """A parameter for each row of all lessons: the exercise, the answer and the words."""
    for lesson in pkgutil.iter_modules(answers.__path__):
        found = getattr(import_module(f"{answers.__name__}.{lesson.name}"), table, [])
        for number, (exercise, *row) in enumerate(found):
            name = f"{lesson.name}.{exercise}"
            yield pytest.param(name, *row, *[None] * (table == "TOLD" and len(row) < 3), id=f"{name}-{number}")


@pytest.mark.parametrize(("name", "answer"), list(rows("RIGHT")))
@pytest.mark.filterwarnings("ignore:divide by zero")
def test_right(name, answer):
    assert_right(name, answer)


@pytest.mark.parametrize(("name", "answer", "words", "not_said"), list(rows("TOLD")))
@pytest.mark.filterwarnings("ignore:divide by zero")
def test_told(name, answer, words, not_said):
    assert_told(name, answer, words, not_said)
