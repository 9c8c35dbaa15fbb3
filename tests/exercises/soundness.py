"""What an exercise must stand before it meets a learner."""

import inspect
import re
import time
from types import SimpleNamespace

import numpy as np

from kflearn.exercises._answers import chosen, parts
from kflearn.exercises.engine import ChoiceExercise, FunctionExercise, Outcome, ValueExercise

UNTOUCHED = (..., None)
UNTOUCHED_FUNCTIONS = (lambda *inputs: None, lambda *inputs: ...)


def assert_sound(each):
    """The solution passes, each wrong answer gets its own sentence, the hints are sound."""
    assert each.question, f"{each.name}: the question (the solution's docstring) is missing"
    solved = quickly_checked(each, each._answer())
    assert solved.status == "right", f"{each.name}: its own solution gets: {solved}"
    for label, design in getattr(each, "passing", {}).items():
        assert each.check(design).status == "right", f"{each.name}: the design {label!r} gets: {each.check(design)}"
    for label, design in getattr(each, "failing", {}).items():
        assert each.check(design).status == "wrong", f"{each.name}: the design {label!r} passes"
    for label, (answer, sentence) in each.wrong.items():
        assert sentence.strip(), f"{each.name}: the wrong answer {label!r} has no sentence"
        expected, found = [Outcome("wrong", sentence).text], quickly_checked(each, answer).text
        if label.startswith("combined: "):  # of several mistakes another one may lead to the same results
            expected = [Outcome("wrong", text).text for _, text in each.wrong.values()]
        assert found.startswith(tuple(expected)), f"{each.name}: the wrong answer {label!r} gets: {found}"
    for untouched in UNTOUCHED + (UNTOUCHED_FUNCTIONS if isinstance(each, FunctionExercise) else ()):
        assert each.check(untouched).status == "not attempted", f"{each.name}: untouched is not recognised"
    assert len(each.hints) >= 2, f"{each.name}: two hints or more are wanted"
    hints = [hint(None) if callable(hint) else hint for hint in each.hints]
    for hint in hints:
        assert re.search(r"\w \S.*[.?!…:)`]$", hint, re.S), f"{each.name}: this hint is no sentence: {hint!r}"
    for hint in hints[:-1]:
        assert not gives_away(hint, each), f"{each.name}: this hint gives the answer away: {hint!r}"
    assert_solved(each)


def quickly_checked(each, answer):
    """The outcome of a check, which may take half a second of the processor."""
    start = time.process_time()
    outcome = each.check(answer)
    took = time.process_time() - start
    assert took < 0.5, f"{each.name}: {answer!r} is checked in {took:.1f} s"
    return outcome


def assert_solved(each, names=None):
    """The solution runs as it is shown, in a notebook with such names, and its last line hands in what is right."""
    module = SimpleNamespace(**{each.name: each})
    code, _, last = each.solution().text.rstrip().rpartition("\n")
    made_here = inspect.getclosurevars(each._solve).nonlocals  # of exercises that tests make
    found = {**made_here, **(names or {}), "exercises": module}
    exec(compile(code, f"solution of {each.name}", "exec"), found)
    outcome = eval(last, found)
    assert outcome.status == "right", f"{each.name}: its solution, as it is shown, gets: {outcome}"


def gives_away(hint, each):
    """Does a hint name every number of the answer, or every line?"""
    found = numbers_in(hint)
    if isinstance(each, ChoiceExercise):
        return each.lines and {int(line) for line in chosen(each.right)} <= set(found)
    if isinstance(each, ValueExercise):
        return bool(np.isclose(found[:, None], entries(each.right), each.rtol).any(axis=0).all())
    return False


def numbers_in(text):
    """The numbers a text names, those of equations left out: "eq (12)"."""
    text = re.sub(r"\beqs?\.? ?\([^)]*\)", "", text.replace("−", "-"))
    return np.array(re.findall(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?", text), dtype=float)


def entries(value):
    """All numbers of a value, in a flat array."""
    pieces = parts(value).values()
    return np.concatenate([entries(piece) for piece in pieces]) if pieces else np.ravel(value)
