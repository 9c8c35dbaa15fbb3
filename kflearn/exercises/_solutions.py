"""A solution as it can be run in a lesson's own cell."""

import ast
import inspect
import textwrap
from types import FunctionType, ModuleType

import kflearn


def for_a_cell(solution, name) -> str:
    """The solution's source without decorator and question, with its imports, handed to `check` in the last line.

    A function gets the name my_…, so that it hides nothing in the notebook; a value or a choice becomes `answer`.
    """
    source = textwrap.dedent(inspect.getsource(solution))
    function, lines = ast.parse(source).body[0], source.splitlines()
    body = function.body[1:] if ast.get_docstring(function) else function.body
    text = "\n".join(lines[(function.body[0].end_lineno if body is not function.body else function.lineno) :])
    if inspect.signature(solution).parameters:
        head = lines[function.lineno - 1].replace(f"def {name}(", f"def my_{name}(", 1)
        code, mine = f"{head}\n{text}\n", f"my_{name}"
    else:
        code, mine = _as_statements(text, body), "answer"
    needed = _imports(solution, function)
    return "\n".join([*needed, *([""] if needed else []), code, f"exercises.{name}.check({mine})"])


def _as_statements(text, body):
    """The lines of a function's body; what it returns at its end is the answer."""
    assert isinstance(body[-1], ast.Return), "a solution ends with what it returns"
    before, _, after = textwrap.dedent(text).rpartition("return ")
    return f"{before}answer = {after}"


def _imports(solution, function):
    """Lines for the names that a solution takes from its module."""
    used = {node.id for part in function.body for node in ast.walk(part) if isinstance(node, ast.Name)}
    known = solution.__globals__
    return [_line(name, known[name], solution.__module__) for name in sorted(used & set(known))]


def _line(name, thing, module):
    if isinstance(thing, ModuleType):
        return f"import {thing.__name__}" + (f" as {name}" if thing.__name__ != name else "")
    if name in kflearn.__all__:
        return f"from kflearn import {name}"
    home = thing.__module__ if isinstance(thing, (FunctionType, type)) else module
    return f"from {home} import {name}"
