"""Results that no learner means: whatever is said of them must be true of them.

Each is made from the right result of every exercise with a function, so that no exercise is left out.
"""

import numpy as np
import pytest

from kflearn.exercises._answers import parts
from kflearn.exercises.engine import FunctionExercise, ValueExercise
from tests.exercises.test_exercises import EXERCISES
from tests.exercises.test_trials import per_function

RELATED = ("what would be right for", "times what is wanted", "follows how many", "is rounded to")
VALUES = [each for each in EXERCISES if type(each) is ValueExercise]


def made(each, change):
    """The exercise's own function, with something made of each of its results."""

    def answer(*inputs):
        return of_each_part(each._solve(*inputs), change)

    return answer


def of_each_part(result, change):
    wanted = list(parts(result).values())
    return tuple(of_each_part(part, change) for part in wanted) if wanted else change(np.asarray(result, float))


@per_function
def test_nan_alone_is_called_nan(each):
    said = each.check(made(each, lambda a: a * np.nan)).sentence
    assert "nan" in said.casefold(), said


@per_function
@pytest.mark.parametrize("number", [0, 7.5])
def test_one_number_for_everything_is_related_to_nothing(each, number):
    """Unless the exercise has a sentence of its own for it."""
    said = each.check(made(each, lambda a: 0 * np.nan_to_num(a) + number)).sentence
    assert not any(words in said for words in RELATED), said


@per_function
def test_complex_numbers_are_called_complex_and_nothing_of_them_right(each):
    said = each.check(made(each, lambda a: a * 1j)).sentence
    assert "complex" in said and "right" not in said and "are wrong" not in said, said


@per_function
def test_of_another_form_no_product_is_blamed(each):
    said = each.check(made(each, lambda a: np.reshape(a, (-1, 1)))).text
    assert "`*`" not in said and "typed in" not in said, said


@per_function
@pytest.mark.parametrize("more", [lambda r: (r, np.ones(4)), lambda r: [r, [1.0, [2.0]]]])
def test_more_than_is_wanted_can_be_read(each, more):
    outcome = each.check(lambda *inputs: more(each._solve(*inputs)))
    assert "cannot be read" not in outcome.sentence, outcome


@per_function
def test_text_is_called_text(each):
    outcome = each.check(lambda *inputs: str(each._solve(*inputs)))
    assert outcome.status == "wrong" and ("text" in outcome.sentence or "type str" in outcome.sentence), outcome
    assert "get lost" not in each.check(lambda *inputs: "a formula").sentence


@pytest.mark.parametrize("each", VALUES, ids=lambda each: each.name)
def test_a_sign_is_called_a_sign_or_has_its_own_sentence(each):
    outcome = each.check(of_each_part(each.right, np.negative))
    own = any(outcome.sentence.endswith(sentence) for _, sentence in each.wrong.values())
    assert own or outcome.status == "right" or "opposite sign" in outcome.sentence, outcome


def test_there_are_functions_and_values():
    assert len(VALUES) > 30 and sum(isinstance(each, FunctionExercise) for each in EXERCISES) > 60
