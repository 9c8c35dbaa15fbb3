"""What a function is tried on: several sizes, nothing constant, so that no answer fits by accident.

An exercise may say why something stays the same: `fixed={"H": "only the position is measured in this lesson"}`.
"""

import ast
import copy
import inspect
import re
import textwrap

import numpy as np
import pytest

from kflearn.exercises._shown import ENTRIES_SHOWN, show
from kflearn.exercises.engine import ChoiceExercise, FunctionExercise, OpenExercise
from tests.exercises.test_exercises import EXERCISES

NAMES = [f"{each.module.rpartition('.')[2]}.{each.name}" for each in EXERCISES]
FUNCTIONS = [each for each in EXERCISES if isinstance(each, FunctionExercise)]
per_function = pytest.mark.parametrize("each", FUNCTIONS, ids=lambda e: f"{e.module.rpartition('.')[2]}.{e.name}")


def shapes(each, i):
    """The shapes of an argument in all trials."""
    return {np.shape(case[i]) for case in each.cases}


def is_constant(values):
    """Are they all the same?"""
    first = values[0]
    if callable(first):
        return False
    return all(np.shape(v) == np.shape(first) and np.array_equal(v, first, equal_nan=_numeric(first)) for v in values)


def _numeric(value):
    return np.asarray(value).dtype.kind in "fc"


def short(number):
    """Whether a number ends after twelve digits or fewer."""
    return np.isfinite(number) and np.isclose(float(f"{number:.12g}"), number, 1e-13, 0)


@per_function
def test_a_trial_that_is_shown_can_be_tried(each):
    """Each number that ends is shown to its end, so that the learner finds what the check has found."""
    for case in each.cases:
        for part in case:
            values = np.ravel(part) if _numeric(part) else []
            if 0 < len(values) <= ENTRIES_SHOWN:
                text = show(part, exact=True).replace("nan", "0")
                found = [float(number) for number in re.findall(r"-?\d+\.?\d*(?:e[+-]?\d+)?", text)]
                assert all(np.isclose(a, b, 1e-12, 0) or not short(b) for a, b in zip(found, values, strict=True))


@per_function
def test_no_input_is_constant(each):
    for i, name in enumerate(each.parameters):
        if name not in each.fixed:
            assert not is_constant([case[i] for case in each.cases]), f"{name} is the same in all trials"


@per_function
def test_arrays_come_in_two_sizes_at_least(each):
    for i, name in enumerate(each.parameters):
        found = shapes(each, i)
        if found != {()} and name not in each.fixed:
            assert len(found) > 1, f"{name} has always the shape {found}"


@per_function
def test_what_is_fixed_has_its_reason(each):
    for name, why in each.fixed.items():
        assert name in each.parameters
        assert len(why.split()) >= 4, f"why is {name} fixed?"


# ---- answers fitted to the first trial, made from the solution: all must fail


def fitted(each):
    """Functions that are right in the first trial, and know its sizes and its numbers."""
    first = each.cases[0]
    for i, name in enumerate(each.parameters):
        if name in each.fixed:
            continue
        yield (
            f"{name} of the first trial",
            lambda *args, i=i: each._solve(*args[:i], copy.deepcopy(first[i]), *args[i + 1 :]),
        )
        if isinstance(first[i], np.ndarray) and first[i].ndim:
            yield f"{name} cut to the first size", lambda *args, i=i: _cut(each, first, args, i)
    yield from written_out(each)


def _cut(each, first, args, i):
    """The solution for an argument of which only as much is used as the first trial had."""
    part = tuple(slice(0, side) for side in first[i].shape)
    return each._solve(*args[:i], np.asarray(args[i])[part], *args[i + 1 :])


def written_out(each):
    """The solution's source in which len(…), .shape, .size and the size of np.eye(…) are those of the first trial."""
    source = textwrap.dedent(inspect.getsource(each._solve))
    tree = ast.parse(source)
    tree.body[0].decorator_list = []
    for number, node in enumerate(list(sizes(tree))):
        names = dict(zip(each.parameters, copy.deepcopy(each.cases[0]), strict=False))
        try:
            value = eval(compile(ast.Expression(node), "size", "eval"), each._solve.__globals__ | names)
        except NameError:  # of something that the function computes first
            continue
        new = Exchange(node, value).visit(copy.deepcopy(tree))
        space = dict(each._solve.__globals__)
        exec(compile(ast.fix_missing_locations(new), "fitted", "exec"), space)
        yield f"{ast.unparse(node)} = {value}, number {number}", space[each.name]


def sizes(tree):
    """The parts of a source that are sizes."""
    for node in ast.walk(tree):
        text = ast.unparse(node) if isinstance(node, ast.Call | ast.Subscript | ast.Attribute) else ""
        shape = isinstance(node, ast.Subscript) and ast.unparse(node.value).endswith(".shape")
        if shape or text.startswith("len(") or (text.endswith(".size") and "(" not in text):
            yield node


class Exchange(ast.NodeTransformer):
    """Put a number in place of an expression, wherever it stands."""

    def __init__(self, node, value):
        self.text, self.value = ast.unparse(node), value

    def generic_visit(self, node):
        if isinstance(node, ast.expr) and ast.unparse(node) == self.text:
            return ast.Constant(self.value)
        return super().generic_visit(node)


@per_function
def test_what_fits_only_the_first_trial_fails(each):
    for label, function in fitted(each):

        def answer(*args, function=function):
            return function(*args)

        found = each.check(answer)
        assert found.status != "right", f"accepted: {label}"


# ---- what else every exercise has


@pytest.mark.parametrize("each", EXERCISES, ids=NAMES)
def test_right_leads_on(each):
    """A sentence after "right": for choices the reason."""
    assert len(each.then.split()) >= 4, "then= is missing"
    assert each.then.endswith((".", "?"))


@pytest.mark.parametrize("each", EXERCISES, ids=NAMES)
def test_the_likeliest_mistakes_have_their_sentence(each):
    """Five at least in the table; the rules of the engine add some. A choice has one for each wrong choice."""
    if not isinstance(each, ChoiceExercise | OpenExercise):
        assert len(each.wrong) >= 5, f"only {len(each.wrong)} in the table"
