"""The exercise engine: four outcomes, teaching sentences, and no answer that makes check raise."""

import ast
import functools
import re
import sys
import types
import warnings
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from kflearn import Gaussian
from kflearn.exercises import engine
from kflearn.exercises.engine import Outcome, exercise


class Belief(NamedTuple):
    """Stands in for a Gaussian: anything with a mean and a cov."""

    mean: object
    cov: object


HINTS = ["Which of the two do you trust more?", "Weigh with the variances, eq (12).", "It is 60 + 5/6 × 2 = 61.67."]


@exercise(
    wrong={
        "weighed with σ": (lambda: 60 + 2 * 5**0.5 / (5**0.5 + 1), "You weighed with σ; eq (12) wants variances σ²."),
        "K for 1 − K": (60 + 1 / 6 * 2, "You gave the weight of the second source to the first."),
        "handed in both": ([60, 62], "These are the two sources: fuse them."),
    },
    hints=HINTS,
    unit="m",
)
def fused_position():
    """What is the fused position of N(60, 5) and N(62, 1)?"""
    gain = 5 / (5 + 1)  # the share of doubt in the first
    return 60 + gain * (62 - 60)


@exercise(
    wrong={"forgot F": (np.array([[1, 0.5], [0, 3]]), "Moving mixes position and velocity: F P Fᵀ.")},
    hints=["Multiply three matrices first.", "Do F P first."],
)
def lopsided():
    """What is F P Fᵀ + D for F = [[1, 2], [0, 1]], P = diag(1, 3), D = [[0, 0.5], [0, 0]]?"""
    F = np.array([[1.0, 2.0], [0.0, 1.0]])
    return F @ np.diag([1.0, 3.0]) @ F.T + np.array([[0, 0.5], [0, 0]])


@exercise(hints=["Fuse the two means.", "Fuse the two variances."])
def fused_belief():
    """What is the fused belief?"""
    return Belief(np.array([1.0, 2.0]), np.array([[2.0, 0.3], [0.3, 1.0]]))


def beliefs(rng):
    mean, z = rng.normal(size=2)
    P, R = rng.uniform(0.5, 3, 2)
    return mean, P, z, R


@exercise(
    wrong={
        "wrong sign": (lambda x, P, z, R: (x + P / (P + R) * (x - z), P * R / (P + R)), "The innovation is z − x."),
        "K for 1 − K": (lambda x, P, z, R: (x + R / (P + R) * (z - x), P * R / (P + R)), "That is 1 − K."),
        "P left as it was": (lambda x, P, z, R: (x + P / (P + R) * (z - x), P), "A measurement makes P smaller."),
        "only the mean": (lambda x, P, z, R: x + P / (P + R) * (z - x), "Return the variance too."),
    },
    hints=["First the gain K.", "K = P / (P + R)."],
    inputs=beliefs,
)
def correct(x, P, z, R):
    """Write correct(x, P, z, R): it returns the corrected mean and variance."""
    gain = P / (P + R)
    return x + gain * (z - x), (1 - gain) * P


@exercise(
    wrong={"no transpose": (lambda F, P: F @ P @ F, "The second F is transposed: F P Fᵀ.")},
    hints=["It has three factors.", "F P and one more."],
    inputs=lambda rng: (rng.normal(size=(2, 2)), np.eye(2) * rng.uniform(1, 2)),
)
def spread(F, P):
    """Write spread(F, P), the covariance after x ↦ F x."""
    return F @ P @ F.T


@exercise(
    wrong={"a": ("a", "That would be more trust in the model."), "c": ("c", "Q does not measure the sensor.")},
    hints=["What does R stand for?", "R is the sensor's variance."],
)
def larger_R():
    """A larger R makes the filter … (a) quicker, (b) slower, (c) neither?"""
    # the gain P / (P + R) becomes smaller
    return "b"


@exercise(
    wrong={"the gain": (2, "Line 2 is eq (7) as it should be."), "one of two": (4, "Right, but it has a companion.")},
    hints=["Look at the order.", "Something is used before it is made."],
)
def bug_hunt():
    """Which lines hold the fault?"""
    return {4, 7}


@exercise(wrong={"no": (False, "The mean of n readings has the variance σ²/n.")}, hints=["Try it.", "Count the σs."])
def true_or_false():
    """True or False: more readings make the mean better."""
    return True


ALL = [fused_position, lopsided, fused_belief, correct, spread, larger_R, bug_hunt, true_or_false]
VALUES = [fused_position, lopsided, fused_belief, larger_R, bug_hunt, true_or_false]
FUNCTIONS = [correct, spread]


def names(exercises):
    return {"argvalues": exercises, "ids": [each.name for each in exercises]}


# The four outcomes


@pytest.mark.parametrize("each", **names(ALL))
def test_self_test(each):
    each.self_test()


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


class Hostile:
    """Fights back whatever is done to it."""

    def _refuse(self, *args, **kwargs):
        raise RuntimeError("no")

    __array__ = __repr__ = __str__ = __eq__ = __ne__ = __float__ = __int__ = __index__ = __len__ = __iter__ = _refuse
    __hash__ = __bool__ = __getitem__ = __deepcopy__ = __copy__ = __format__ = __lt__ = __gt__ = __contains__ = _refuse
    __getattr__ = _refuse


class HostileClass:
    @property
    def __class__(self):
        raise RuntimeError("no")


class Fighter(Exception):
    def __str__(self):
        raise RuntimeError("no")


class Sequence:
    def __len__(self):
        return 10**12

    def __getitem__(self, i):
        return self


def loop_list():
    loop = [1.0]
    loop.append(loop)
    return loop


# What is said of an answer that is in no table: (exercise, answer, words)
SAID = [
    (fused_position, 63.9, "✗ Not yet. Your answer (in m) is too high."),
    (fused_position, 50, "✗ Not yet. Your answer (in m) is too low."),
    (fused_position, 61, "✗ Not yet. Your answer (in m) is close, but too low: if you rounded, keep more digits."),
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
    (fused_position, 61.7 + 0j, "of type complex."),
    (fused_position, {"x": 61.7}, "of type dict."),
    (fused_position, {61.7}, "of type set."),
    (fused_position, object(), "of type object."),
    (fused_position, (x for x in [61.7]), "of type generator."),
    (fused_position, lambda: 61.7, "a function: call it and hand in what it returns."),
    (fused_position, float, "a function: call it"),
    (fused_position, 10**400, "of type int."),
    (fused_position, np.datetime64("2026-01-01"), "of type datetime64."),
    (fused_position, Belief(61.7, 1.0), "a Belief of 2 items."),
    (fused_position, Hostile(), "✗ Not yet. Your answer (in m) cannot be read as numbers."),
    (fused_position, HostileClass(), "cannot be read as numbers."),
    (fused_position, [Hostile()], "cannot be read as numbers."),
    (lopsided, [[13, 6.5], [6, 4]], "✗ Not yet. Your answer differs in 1 of 4 entries: [1, 1] is too high."),
    (lopsided, [[13, 6], [6.5, 3]], "✗ Not yet. Your answer is the transpose of what it should be."),
    (lopsided, [[13, 6.5], [6]], "should be an array of shape (2, 2), but it is of type list, and its rows"),
    (lopsided, [13, 3], "should be an array of shape (2, 2), but it is an array of shape (2,)."),
    (lopsided, np.ones((2, 2, 1)), "an array of shape (2, 2, 1)."),
    (lopsided, 13, "should be an array of shape (2, 2), but it is one number."),
    (lopsided, [[13, 6.5], [6, None]], "but it is nan at [1, 1]."),
    (lopsided, [[13, 6.5], [6, "x"]], "of type list, holding str."),
    (lopsided, np.array([[13, 6.5], [6, 3]]) * 1j, "of type ndarray, holding complex128."),
    (lopsided, loop_list(), "Not yet."),
    (lopsided, Sequence(), "Not yet."),
    (fused_belief, Belief([1, 2], [[2, 0.3], [0.3, 2]]), "The covariance of your answer differs in 1 of 4 entries"),
    (fused_belief, Belief([1, 9], [[2, 0.3], [0.3, 1]]), "The mean of your answer differs in 1 of 2 entries"),
    (fused_belief, [1, 2, 3], "Your answer should hold 2 values (the mean, the covariance), not 3."),
    (fused_belief, 7, "Your answer should hold 2 values (the mean, the covariance), not one of type int."),
    (fused_belief, Hostile(), "Your answer cannot be read as numbers."),
    (larger_R, "d", "✗ Not yet. Choose from A, B, C."),
    (larger_R, ["a", "b"], "✗ Not yet. It is not A."),
    (larger_R, 3.5, "Choose from A, B, C."),
    (larger_R, np.nan, "Choose from A, B, C."),
    (larger_R, {}, "Choose from A, B, C."),
    (larger_R, np.zeros(1000), "Choose from A, B, C."),
    (larger_R, range(10**9), "Choose from A, B, C."),
    (larger_R, Hostile(), "✗ Not yet. Your answer cannot be read as a choice."),
    (larger_R, loop_list(), "✗ Not yet."),
    (bug_hunt, 99, "✗ Not yet. The fault is not in line 99."),
    (bug_hunt, {3, 4, 7, 12}, "✗ Not yet. The fault is not in line 3, 12."),
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

    fused.self_test()
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


# Functions


def divides(x, P, z, R):
    return 1 / int(P - P)


def forgot_return(x, P, z, R):
    x + P


def half_done(x, P, z, R):
    gain = ...
    return x + gain * (z - x), (1 - gain) * P


def half_done_matrix(F, P):
    left = ...
    return left @ P


def in_place(F, P):
    before = F.copy()
    F *= 0
    P *= 7
    return before @ (P / 7) @ before.T


def talks(x, P, z, R):
    print("gain", P / (P + R))
    warnings.warn("careful", stacklevel=1)
    np.float64(1) / np.float64(0)
    return correct._solve(x, P, z, R)


def endless(x, P, z, R):
    return endless(x, P, z, R)


def address(x, P, z, R):
    raise ValueError(f"no use for {divides} from /some/where/else.py or C:\\some\\where.py\nat all")


def helped(x, P, z, R):
    return helper(x)


def helper(x):
    return np.linalg.inv(np.zeros((2, 2)))


def leaves(x, P, z, R):
    sys.exit("bye")


def fights(x, P, z, R):
    raise Fighter


def todo(x, P, z, R):
    raise NotImplementedError


def yields(x, P, z, R):
    yield x


async def waits(x, P, z, R):
    return x


def sometimes(x, P, z, R):
    if x > 0:
        return correct._solve(x, P, z, R)


class Filter:
    def correct(self, x, P, z, R):
        return correct._solve(x, P, z, R)

    def __call__(self, x, P, z, R):
        return 1 // 0


CALLED = [
    (correct, divides, "raised", "✗ Your code raised an error. `ZeroDivisionError: "),
    (correct, divides, "raised", "in the line `return 1 / int(P - P)`, called with `x = "),
    (correct, helped, "raised", "`LinAlgError: Singular matrix` in the line `return np.linalg.inv(np.zeros((2, 2)))`"),
    (correct, address, "raised", "`ValueError: no use for <function divides> from else.py or where.py at all` in"),
    (correct, endless, "raised", "`RecursionError: maximum recursion depth exceeded"),
    (correct, leaves, "raised", '`SystemExit: bye` in the line `sys.exit("bye")`'),
    (correct, fights, "raised", "`Fighter` in the line `raise Fighter`"),
    (correct, Filter(), "raised", "`ZeroDivisionError"),
    (correct, Filter().correct, "right", "✓"),
    (correct, talks, "right", "✓"),
    (spread, in_place, "right", "✓"),
    (correct, forgot_return, "not attempted", "… Not attempted yet. Your function returns nothing yet."),
    (correct, half_done, "not attempted", "A `...` is still in your function"),
    (spread, half_done_matrix, "not attempted", "A `...` is still in your function"),
    (correct, todo, "not attempted", "A `...` is still in your function"),
    (correct, lambda x, P, z, R: (..., ...), "not attempted", "returns nothing yet"),
    (correct, lambda x: x, "wrong", "✗ Not yet. Your function takes 1 argument, it is called with 4 (x, P, z, R)."),
    (correct, lambda x, P, z, R, u: x, "wrong", "Your function takes 5 arguments, it is called with 4 (x, P, z, R)."),
    (correct, 61.7, "wrong", "✗ Not yet. A function is wanted: hand in its name without parentheses"),
    (correct, Hostile(), "wrong", "✗ Not yet."),
    (correct, Hostile, "wrong", "✗ Not yet."),
    (correct, lambda *inputs: Hostile(), "wrong", "The result cannot be read as numbers."),
    (correct, yields, "wrong", "the result should hold 2 values (value 1, value 2), not one of type generator."),
    (correct, waits, "wrong", "not one of type coroutine."),
    (correct, sometimes, "wrong", "not one of type NoneType."),
    (correct, lambda x, P, z, R: (x, "P"), "wrong", "` value 1 of the result is"),
    (spread, lambda F, P: -F @ P @ F.T, "wrong", "(it has the opposite sign)."),
    (
        spread,
        lambda F, P: (F @ P @ F.T)[0],
        "wrong",
        "should be an array of shape (2, 2), but it is an array of shape (2",
    ),
    (spread, lambda F, P: F @ P @ F.T * np.nan, "wrong", "but it is nan at [0, 0]."),
    (spread, lambda F, P: F @ P @ F.T + 1e-5, "wrong", "was expected."),
    (spread, np.matmul, "wrong", "was expected."),
    (spread, max, "raised", "ValueError"),
    (spread, len, "wrong", "Your function takes 1 argument, it is called with 2 (F, P)."),
    (spread, int, "raised", "TypeError"),
    (spread, loop_list, "wrong", "Your function takes 0 arguments, it is called with 2 (F, P)."),
]


@pytest.mark.parametrize("each, answer, status, words", CALLED, ids=[f"{c[0].name}-{i}" for i, c in enumerate(CALLED)])
def test_functions(each, answer, status, words):
    outcome = each.check(answer)
    assert outcome.status == status
    assert words in outcome.text


def test_a_failing_case_shows_input_result_and_expectation():
    text = spread.check(lambda F, P: F @ P).text
    inner = re.fullmatch(r"✗ Not yet. For `F = (.+), P = (.+)` the result is (.+), but (.+) was expected\.", text)
    F, P, got, expected = (np.array(ast.literal_eval(group)) for group in inner.groups())
    np.testing.assert_allclose(got, F @ P, rtol=1e-2, atol=1e-3)
    np.testing.assert_allclose(expected, F @ P @ F.T, rtol=1e-2, atol=1e-3)


def test_nearly_equal_numbers_are_shown_with_enough_digits():
    text = spread.check(lambda F, P: F @ P @ F.T * (1 + 1e-5)).text
    got, expected = re.search(r"the result is (.+), but (.+) was expected", text).groups()
    assert got != expected


def test_prints_and_warnings_stay_inside(capsys):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        correct.check(talks)
        correct.check(waits)  # a coroutine that is never awaited
    assert capsys.readouterr().out == "" and not caught


def test_interrupt_passes_through():
    def stopped(x, P, z, R):
        raise KeyboardInterrupt

    class Stops:
        def __array__(self, *args, **kwargs):
            raise KeyboardInterrupt

    for each, answer in ((correct, stopped), (fused_position, Stops()), (correct, lambda *inputs: Stops())):
        with pytest.raises(KeyboardInterrupt):
            each.check(answer)


def test_answers_are_left_as_they_were():
    answer = np.array([[13.0, 6.5], [6.0, 3.0]])
    lopsided.check(answer)
    assert answer.tolist() == [[13, 6.5], [6, 3]]


# Hints, solution, display


def test_hints_become_stronger_and_end():
    each = exercise(hints=HINTS)(fused_position._solve)
    assert [repr(each.hint()) for _ in HINTS] == [f"Hint {i} of 3. {hint}" for i, hint in enumerate(HINTS, 1)]
    last = "There are 3 hints; after the last, `fused_position.solution()` shows the answer."
    assert repr(each.hint()) == repr(each.hint()) == last
    assert repr(each.hint(2)) == f"Hint 2 of 3. {HINTS[1]}"
    for odd in (0, 4, -1, "x", 1.5):
        assert repr(each.hint(odd)) == last


def test_solution_is_the_source_without_decorator_and_question():
    assert repr(fused_position.solution()).splitlines() == [
        "def fused_position():",
        "    gain = 5 / (5 + 1)  # the share of doubt in the first",
        "    return 60 + gain * (62 - 60)",
    ]
    assert "# the gain P / (P + R) becomes smaller" in larger_R.solution().text
    assert correct.solution()._repr_markdown_().startswith("```python\ndef correct(x, P, z, R):\n    gain")


def test_display():
    outcome = fused_position.check(50)
    assert isinstance(outcome, Outcome) and repr(outcome) == outcome.text
    assert outcome._repr_markdown_() == "**✗ Not yet.** Your answer (in m) is too low."
    assert dir(fused_position) == ["check", "hint", "solution"]
    assert repr(fused_position) == "fused_position: What is the fused position of N(60, 5) and N(62, 1)?"
    assert len({lead[0] for lead in engine.LEAD.values()}) == 3 and len(set(engine.LEAD.values())) == 4


def test_texts_do_not_change_from_call_to_call():
    rows = [(each, answer) for each, answer, *_ in SAID + CALLED] + RIGHT
    texts = [each.check(answer).text for each, answer in rows if type(answer) is not types.GeneratorType]
    again = [each.check(answer).text for each, answer in rows if type(answer) is not types.GeneratorType]
    assert texts == again
    for text in texts:
        assert "0x" not in text and "/" not in re.sub(r"`[^`]*`", "", text) and "\n" not in text, text
        assert len(text) < 500


def test_exercises_of_lists_in_order_of_definition():
    module = sys.modules[__name__]
    assert engine.exercises_of(module) == ALL
    assert engine.exercises_of(engine) == []


# Authors' errors


def made(value, **options):
    def asked():
        """What?"""
        return value

    return exercise(**{"hints": ["First step.", "Second step."], **options})(asked)


def test_errors_of_authors_are_refused_at_once():
    with pytest.raises(ValueError, match="'same' cannot be told from the 'right answer'"):
        made(5.0, wrong={"same": (lambda: 5.0001, "No.")})
    with pytest.raises(ValueError, match="'two' cannot be told from the 'one'"):
        made(5.0, wrong={"one": (3, "No."), "two": (3.0001, "No.")})
    with pytest.raises(ValueError, match="'B' cannot be told from the 'right answer'"):
        made("b", wrong={"B": ("B", "No.")})
    with pytest.raises(ValueError, match="needs its wrong choices"):
        made("b")
    with pytest.raises(ValueError, match="the solution has no parameters"):
        made(5.0, inputs=lambda rng: (1,))
    for inputs in (None, lambda rng: 1, lambda rng: (1, 2)):
        with pytest.raises(ValueError, match=r"square: .*inputs= must"):

            @exercise(hints=[], inputs=inputs)
            def square(x):
                """Square."""
                return x * x


def test_self_test_finds_errors_of_authors():
    def fails(each, words):
        with pytest.raises(AssertionError, match=words):
            each.self_test()

    fails(made(61.7, hints=["Only one."]), "two hints")
    fails(made(61.7, hints=["", "It is so."]), "no sentence")
    fails(made(61.7, hints=["no stop here", "It is so."]), "no sentence")
    fails(made(61.7, hints=["It is 61.7 of course.", "It is so."]), "gives the answer away")
    fails(made([1.5, 2.5], hints=["It is 1.5 and 2.5.", "It is so."]), "gives the answer away")
    fails(made({3}, wrong={"4": (4, "No.")}, hints=["Look at line 3.", "It is so."]), "gives the answer away")
    fails(made(5.0, wrong={"silent": (3, "")}), "no sentence")
    made(12.0, hints=["See eq (12).", "Yes, 12 it is."]).self_test()

    def function(**wrong):
        @exercise(hints=["First step.", "Second step."], inputs=lambda rng: (rng.normal(),), wrong=wrong)
        def square(x):
            """Square."""
            return x * x

        return square

    function(half=(lambda x: x * x / 2, "Half of it.")).self_test()
    fails(function(same=(lambda x: x**2, "No.")), "'same' gets: ✓ Right")
    fails(function(one=(lambda x: x, "One."), two=(lambda x: x + 0, "Two.")), "'two' gets: ✗ Not yet. One.")
    fails(function(bad=(lambda x: 1 / 0, "Bad.")), "'bad' gets: ✗ Your code raised")
    fails(exercise(hints=["First step.", "Second step."])(lambda: 3), "question")


# Anything at all

numbers = st.one_of(
    st.integers(-100, 100),
    st.sampled_from([10**400, -(2**70), 61.6667, 61.38, 13, 6.5]),
    st.floats(),
    st.complex_numbers(),
    st.fractions(),
    st.decimals(),
    st.booleans(),
)
arrays = hnp.arrays(hnp.scalar_dtypes(), hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=3))
leaves = numbers | st.none() | st.just(...) | st.text(max_size=3) | st.binary(max_size=3) | arrays | st.dates()
anything = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.tuples(inner, inner),
        st.builds(Belief, inner, inner),
        st.dictionaries(st.text(max_size=2), inner, max_size=2),
        st.sets(st.integers(0, 9) | st.floats(), max_size=3),
    ),
    max_leaves=8,
)


@settings(max_examples=150, deadline=None)
@given(anything)
def test_check_never_raises(answer):
    for each in VALUES:
        outcome = each.check(answer)
        assert outcome.text.startswith(engine.LEAD[outcome.status]) and outcome.status != "raised"
        assert "\n" not in outcome.text and len(outcome.text) < 300
    for each in FUNCTIONS:
        assert each.check(answer).status in ("wrong", "not attempted")
        assert each.check(lambda *inputs: answer).status in ("wrong", "not attempted")


@settings(max_examples=100, deadline=None)
@given(anything)
def test_plain_data_is_explained_without_the_safety_net(answer):
    for each in (fused_position, lopsided, fused_belief, larger_R, bug_hunt):
        assert "cannot be read" not in each.check(answer).text
