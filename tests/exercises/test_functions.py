"""Functions that are handed in: they are tried, and whatever they do is explained."""

import ast
import re
import sys
import warnings

import numpy as np
import pytest

from kflearn.exercises.engine import exercise
from tests.exercises.examples import Fighter, Hostile, correct, fused_position, loop_list, lopsided, spread


def divides(x, P, z, R):
    return 1 / int(P - P)


def forgot_return(x, P, z, R):
    x + P


def never_true(x, P, z, R):
    if x == 0.95:
        return z, R


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
    (correct, never_true, "not attempted", "its `return` stands in an `if` that was never true."),
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
    (correct, sometimes, "wrong", "your function returns nothing, for example for"),
    (correct, lambda x, P, z, R: (x, "P"), "wrong", "` value 1 of the result is"),
    (spread, lambda F, P: -F @ P @ F.T, "wrong", "✗ Not yet. The result has the opposite sign."),
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


def test_prints_are_shown_and_warnings_stay_inside(capsys):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        correct.check(talks)
        correct.check(waits)  # a coroutine that is never awaited
    printed = capsys.readouterr().out.splitlines()
    assert len(printed) == 2 and printed[1] == "(printed in the first of 20 calls)"
    assert re.fullmatch(r"gain 0\.\d+", printed[0]) and not caught


def test_a_flood_of_prints_is_cut(capsys):
    def floods(x, P, z, R):
        for _ in range(10_000):
            print("x" * 99)
        return correct._solve(x, P, z, R)

    assert correct.check(floods).status == "right"
    printed = capsys.readouterr().out
    assert len(printed) < 1000 and "… and 999,400 characters more" in printed


# ---- mistakes that are the same in every exercise


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda m, v: (v, m), "The results are right, but they are wanted in the other order."),
        (lambda m, v: (m, v**0.5), "The rest is right. Value 2 of the result is the square root of what is wanted"),
        (lambda m, v: (m, v**2), "is the square of what is wanted"),
        (lambda m, v: (m, 1 - v), "is 1 minus what is wanted"),
        (lambda m, v: (m, 1 / v), "is 1 divided by what is wanted"),
        (lambda m, v: (m, 2 * v), "is twice what is wanted"),
        (lambda m, v: (m, v / 2), "is half of what is wanted"),
        (lambda m, v: (m, np.degrees(v)), "is 180/π times what is wanted: degrees in place of radians?"),
        (lambda m, v: (m, 100 * v), "is 100 times too large"),
        (lambda m, v: (m, round(v, 3)), "is rounded to 3 digits after the point"),
        (lambda m, v: (m, v // 1), "`//` and `int` cut them off"),
        (lambda m, v: (m, v if m > 0 else 0), "It is right in "),
    ],
)
def test_common_mistakes_have_their_sentence(change, words):
    assert words in correct.check(lambda x, P, z, R: change(*correct._solve(x, P, z, R))).text


def test_an_argument_that_is_not_used_is_named():
    text = correct.check(lambda x, P, z, R: correct._solve(x, P, z, 2.0)).text
    assert text.startswith("✗ Not yet. The result does not depend on R: a number, or a name of the notebook")


def test_what_the_failing_trials_have_in_common_is_said():
    @exercise(hints=["One.", "Two."], inputs=lambda rng: (rng.choice([1.0, 2.0, np.nan], 3),))
    def total(z):
        """Write total(z), of what was measured."""
        return np.nansum(z)

    assert re.search(r"It is right in \d+ of 20 trials; those that fail have a NaN\.", total.check(np.sum).text)


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


def test_a_known_mistake_is_known_where_other_sizes_stop_it():
    """H for Hᵀ: with square matrices it gives a wrong number, with others an error."""
    rows = iter([2, 2, 2, 2, 3] * 4)

    @exercise(
        hints=["First step.", "Second step."],
        inputs=lambda rng: (rng.normal(size=(next(rows), 2)),),
        wrong={"H for Hᵀ": (lambda H: np.eye(2) @ H, "You left out the transpose.")},
    )
    def turned(H):
        """Hᵀ after the identity."""
        return np.eye(2) @ H.T

    assert "You left out the transpose" in turned.check(lambda H: np.eye(2) @ H).text
    assert turned.check(lambda H: np.eye(2) @ H @ np.eye(3)).status == "raised"
