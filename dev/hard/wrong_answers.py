"""Junk, and nearly right answers, for the exercises' check."""

import copy
from importlib import import_module
from pkgutil import iter_modules

import numpy as np

import kflearn.exercises
from dev.hard.junk import Inputs, Junk, print_of
from kflearn.exercises.engine import LEAD, Outcome, exercises_of


def all_exercises():
    """Every exercise of every lesson."""
    names = [m.name for m in iter_modules(kflearn.exercises.__path__) if not m.name.startswith("_")]
    modules = [import_module(f"kflearn.exercises.{name}") for name in names]
    return [exercise for module in modules for exercise in exercises_of(module)]


def near(exercise, junk):
    """Something like the right answer: its numbers shifted, dressed otherwise, or a function that nearly gives it."""
    right = copy.deepcopy(getattr(exercise, "right", None))
    if right is None:
        return off(exercise, junk)
    if isinstance(right, (str, bool, set, frozenset)) or not isinstance(right, (int, float, np.ndarray)):
        return junk.rng.choice([right, [right], str(right), {"answer": right}, (right, junk.thing())])
    shifted = np.array(right, float) * junk.rng.choice([1, -1, 1000, 1 + 1e-3, np.nan])
    return junk.rng.choice(
        [shifted, shifted.tolist(), str(right), shifted.astype(object), junk.dressed(shifted), [right]]
    )


def off(exercise, junk):
    """A function that answers rightly for a while, then with junk; it overwrites what it was given."""
    left, solve, answer = junk.rng.randrange(4), exercise._answer(), junk.thing()

    def function(*given):
        nonlocal left
        left -= 1
        right = solve(*given)
        for one in given:
            if isinstance(one, np.ndarray) and one.dtype.kind == "f":
                one[...] = np.nan
        return right if left > 0 else answer

    return function


def check_exercises(inputs):
    """Junk, and nearly right answers, for every exercise in turn."""
    tally, exercises, junk = Inputs(), all_exercises(), Junk(1, fighters=True)
    secrets = [print_of(known(exercise)) for exercise in exercises]
    while tally.tried < inputs:
        exercise = exercises[tally.tried % len(exercises)]
        answer = near(exercise, junk) if junk.rng.random() < 0.1 else junk.thing()
        tally.tried += 1
        before = print_of(answer)
        try:
            outcome = exercise.check(answer)
            assert isinstance(outcome, Outcome) and outcome.status in LEAD and repr(outcome), "no outcome"
            tally.ends[outcome.status] += 1
        except BaseException as error:
            if isinstance(error, KeyboardInterrupt):
                raise
            tally.faults.append(f"{exercise.name} {type(error).__name__}")
        if print_of(answer) != before:
            tally.changed.append(exercise.name)
    pairs = zip(exercises, secrets, strict=True)
    tally.changed += [f"the answer of {e.name}" for e, secret in pairs if print_of(known(e)) != secret]
    return tally


def known(exercise):
    """What an exercise compares with."""
    return getattr(exercise, "right", None), getattr(exercise, "cases", None)
