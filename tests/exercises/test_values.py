"""Values and choices that are handed in: which are right, and what is said of the others."""

import functools
import re
import types
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from kflearn import Gaussian
from kflearn.exercises.engine import exercise
from tests.exercises.examples import (
    ALL,
    Belief,
    Hostile,
    HostileClass,
    Sequence,
    bug_hunt,
    correct,
    fused_belief,
    fused_position,
    larger_R,
    loop_list,
    lopsided,
    made,
    spread,
    true_or_false,
)
from tests.exercises.soundness import assert_sound


def names(exercises):
    return {"argvalues": exercises, "ids": [each.name for each in exercises]}


@pytest.mark.parametrize("each", **names(ALL))
def test_sound(each):
    assert_sound(each)


@pytest.mark.parametrize("each", **names(ALL))
def test_untouched_is_not_attempted(each):
    for untouched in (..., None, [...], (..., [1, ...]), "", "  "):
        assert each.check(untouched).status == "not attempted"
    assert each.check().status == "not attempted"


RIGHT = [
    (fused_position, 61.667),
    (fused_position, 61.7),  # rounded by hand
    (fused_position, np.float64(61.6667)),
    (fused_position, np.array(61.6667)),
    (fused_position, np.array([61.6667])),
    (fused_position, [61.6667]),
    (fused_position, (61.6667,)),
    (fused_position, Fraction(185, 3)),
    (fused_position, Decimal("61.667")),
    (lopsided, [[13, 6.5], [6, 3]]),
    (lopsided, {"first row": [13, 6.5], "second row": [6, 3]}),
    (lopsided, ((13, 6.5), (6, 3))),
    (lopsided, np.array([[13, 6.5], [6, 3]], dtype=np.float32)),
    (lopsided, [np.array([13, 6.5]), [6, 3]]),
    (fused_belief, Belief([1, 2], [[2, 0.3], [0.3, 1]])),
    (fused_belief, types.SimpleNamespace(mean=[1, 2], cov=[[2, 0.3], [0.3, 1]])),
    (fused_belief, ([1, 2], [[2, 0.3], [0.3, 1]])),
    (fused_belief, [[1, 2], [[2, 0.3], [0.3, 1]]]),
    (larger_R, "b"),
    (larger_R, " B) "),
    (larger_R, ["b"]),
    (larger_R, np.str_("B")),
    (bug_hunt, {4, 7}),
    (bug_hunt, [7, 4]),
    (bug_hunt, (4, 7.0, 7)),
    (bug_hunt, np.array([4, 7])),
    (bug_hunt, ["4", "7"]),
    (true_or_false, True),
    (true_or_false, np.True_),
    (true_or_false, "true"),
    (correct, lambda x, P, z, R: ((R * x + P * z) / (P + R), 1 / (1 / P + 1 / R))),
    (correct, lambda *inputs: np.array(correct._solve(*inputs))),
    (correct, lambda x, P, z, R: [np.array([part]) for part in correct._solve(x, P, z, R)]),
    (correct, lambda x, P, z, R: Belief(*correct._solve(x, P, z, R))),
    (spread, lambda F, P: F.dot(P).dot(F.T)),
    (spread, functools.partial(lambda factor, F, P: factor * F @ P @ F.T, 1.0)),
]


@pytest.mark.parametrize("each, answer", RIGHT)
def test_right(each, answer):
    assert each.check(answer).status == "right"


def test_right_says_the_answer_with_its_unit():
    assert fused_position.check(61.7).text == "✓ Right. The answer is 61.67 m."
    assert bug_hunt.check([4, 7]).text == "✓ Right. The fault is in line 4, 7."
    assert larger_R.check("B").text == "✓ Right. The answer is B."
    assert correct.check(correct._solve).text == "✓ Right. Your function agrees with the solution on 20 random inputs."


# What is said of an answer that is in no table: (exercise, answer, words)
SAID = [
    (fused_position, 63.9, "✗ Not yet. Your answer (in m) is too high."),
    (fused_position, 50, "✗ Not yet. Your answer (in m) is too low."),
    (fused_position, 61, "✗ Not yet. Your answer (in m) is too low."),
    (fused_position, 62, "✗ Not yet. Your answer (in m) is rounded too much: give three digits or more."),
    (fused_position, -61.6667, "✗ Not yet. Your answer (in m) has the opposite sign."),
    (fused_position, 61666.7, "✗ Not yet. Your answer (in m) is 1000 times too large."),
    (fused_position, 6.16667, "✗ Not yet. Your answer (in m) is 10 times too small."),
    (fused_position, np.nan, "✗ Not yet. Your answer (in m) should be one number, but it is nan."),
    (fused_position, -np.inf, "should be one number, but it is -inf."),
    (fused_position, "61.67", "should be one number, but it is text (of type str): leave out the quotation marks."),
    (fused_position, b"61.67", "text (of type bytes)"),
    (fused_position, [1, 2, 3], "should be one number, but it is a list of 3 items."),
    (fused_position, [], "a list of 0 items."),
    (fused_position, np.zeros((2, 2)), "should be one number, but it is an array of shape (2, 2)."),
    (fused_position, np.broadcast_to(1.0, (10**6, 10**6)), "an array of shape (1000000, 1000000)."),
    (fused_position, range(10**12), "a range of 1000000000000 items."),
    (fused_position, range(10**30), "cannot be read as numbers."),
    (fused_position, True, "should be one number, but it is of type bool."),
    (fused_position, 61.7 + 0j, "of type complex: real numbers are wanted."),
    (fused_position, {"x": 61.7}, "of type dict."),
    (fused_position, {61.7}, "of type set."),
    (fused_position, object(), "of type object."),
    (fused_position, (x for x in [61.7]), "of type generator."),
    (fused_position, lambda: 61.7, "a function: hand in the value itself."),
    (fused_position, float, "a function: hand in"),
    (fused_position, 10**400, "of type int."),
    (fused_position, np.datetime64("2026-01-01"), "of type datetime64."),
    (fused_position, Belief(61.7, 1.0), "a Belief of 2 items."),
    (fused_position, Hostile(), "✗ Not yet. Your answer (in m) cannot be read as numbers."),
    (fused_position, HostileClass(), "cannot be read as numbers."),
    (fused_position, [Hostile()], "cannot be read as numbers."),
    (lopsided, [[13, 6.5], [6, 4]], "✗ Not yet. Your answer differs in 1 of 4 entries: [1, 1] is too high."),
    (lopsided, [[13, 6], [6.5, 3]], "✗ Not yet. Your answer is the transpose of what it should be."),
    (lopsided, [[13, 6.5], [6]], "should be an array of shape (2, 2), but it is of type list, and its parts"),
    (lopsided, [13, 3], "should be an array of shape (2, 2), but it is an array of shape (2,)."),
    (lopsided, np.ones((2, 2, 1)), "an array of shape (2, 2, 1)."),
    (lopsided, 13, "should be an array of shape (2, 2), but it is one number."),
    (lopsided, [[13, 6.5], [6, None]], "but it is None at [1, 1]."),
    (lopsided, [[13, 6.5], [6, "x"]], "of type list, holding str."),
    (lopsided, np.array([[13, 6.5], [6, 3]]) * 1j, "of type ndarray, holding complex128: real numbers are wanted."),
    (lopsided, loop_list(), "Not yet."),
    (lopsided, Sequence(), "Not yet."),
    (fused_belief, Belief([1, 2], [[2, 0.3], [0.3, 2]]), "The covariance of your answer differs in 1 of 4 entries"),
    (fused_belief, Belief([1, 9], [[2, 0.3], [0.3, 1]]), "The mean of your answer differs in 1 of 2 entries"),
    (fused_belief, [1, 2, 3], "Your answer should hold 2 values (the mean, the covariance), not 3."),
    (fused_belief, 7, "Your answer should hold 2 values (the mean, the covariance), not one of type int."),
    (fused_belief, Hostile(), "Your answer cannot be read as numbers."),
    (larger_R, "d", "✗ Not yet. Choose from A, B, C."),
    (larger_R, ["a", "b"], "✗ Not yet. Choose one, please."),
    (larger_R, 3.5, "A letter is wanted, in quotation marks: choose from A, B, C."),
    (larger_R, "I think that it is the second", "A letter alone is wanted: choose from A, B, C."),
    (larger_R, np.nan, "A letter is wanted, in quotation marks: choose from A, B, C."),
    (larger_R, {}, "A letter is wanted, in quotation marks: choose from A, B, C."),
    (larger_R, np.zeros(1000), "A letter is wanted, in quotation marks: choose from A, B, C."),
    (larger_R, range(10**9), "A letter is wanted, in quotation marks: choose from A, B, C."),
    (larger_R, Hostile(), "✗ Not yet. Your answer cannot be read as a choice."),
    (larger_R, loop_list(), "✗ Not yet."),
    (bug_hunt, 99, "✗ Not yet. The fault is not in line 99."),
    (bug_hunt, {3, 4, 7}, "✗ Not yet. The fault is not in line 3."),
    (bug_hunt, {3, 4, 7, 12, 13, 14}, "✗ Not yet. These are too many: choose."),
    (bug_hunt, 7, "✗ Not yet. That is a part of the answer, but there is more to it."),
    (bug_hunt, "b", "✗ Not yet. Give the number of the line, or a list of them."),
    (bug_hunt, [], "Give the number of the line, or a list of them."),
    (true_or_false, 1, "✗ Not yet. Choose from true, false."),
]


@pytest.mark.parametrize("each, answer, words", SAID, ids=[f"{row[0].name}-{i}" for i, row in enumerate(SAID)])
def test_wrong_value_is_explained(each, answer, words):
    outcome = each.check(answer)
    assert outcome.status == "wrong"
    assert words in outcome.text


def test_a_large_array_says_where_it_differs():
    @exercise(hints=["One.", "Two."], inputs=lambda rng: (rng.normal(size=50),))
    def running(z):
        """Write running(z)."""
        return np.cumsum(z)

    def late(z):
        result = np.cumsum(z)
        result[30] = 1234.5
        return result

    text = running.check(late).text
    assert re.fullmatch(
        r"✗ Not yet. For `z = an array of shape \(50,\)` the result is at \[30\] 1234, but \S+ was expected.", text
    ), text


def test_the_course_s_own_gaussian():
    @exercise(
        hints=["Fuse the two.", "Use `fuse`."], wrong={"the first": (Gaussian(60, 5), "That is the first alone.")}
    )
    def fused():
        """Fuse N(60, 5) and N(62, 1)."""
        return Gaussian(60, 5).fuse(Gaussian(62, 1))

    assert_sound(fused)
    assert fused.check((61.67, 0.833)).text == "✓ Right. The answer is N([61.67], [[0.8333]])."
    assert "That is the first alone." in fused.check([60, 5]).text
    assert "The covariance of your answer is too high." in fused.check(Gaussian(61.67, 1)).text
    assert "should be one number, but it is of type Gaussian" in made(5.0).check(Gaussian(5, 1)).text


def test_exact_tolerances_can_be_set():
    @exercise(hints=["One.", "Two."], rtol=0, atol=0.5)
    def roughly():
        """How many?"""
        return 10

    assert [roughly.check(x).status for x in (9.4, 9.6, 10.4, 10.6)] == ["wrong", "right", "right", "wrong"]


def test_tiny_values_are_not_swallowed_by_the_absolute_tolerance():
    @exercise(hints=["One.", "Two."])
    def small():
        """How small?"""
        return 3e-10

    assert small.check(0).status == "wrong" and small.check(3.001e-10).status == "right"


def test_another_value_may_be_right_too():
    each = made(9.0, also=[9.371], wrong={"root": (3, "That is σ.")})
    assert each.check(9).status == each.check(9.37).status == "right"
    assert each.check(9.2).status == "wrong"
    with pytest.raises(ValueError, match=r"'twin' cannot be told from the 'right answer 9.371'"):
        made(9.0, also=[9.371], wrong={"twin": (9.37, "No.")})
