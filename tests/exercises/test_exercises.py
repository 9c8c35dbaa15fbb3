"""The exercises of all lessons: each stands its own test, and its lesson uses it."""

import json
import re
from importlib import import_module
from pkgutil import iter_modules

import pytest

import kflearn.exercises
from dev.lessons import notebooks
from kflearn.exercises.engine import exercises_of
from tests.exercises.soundness import assert_sound

FOUND = [module.name for module in iter_modules(kflearn.exercises.__path__)]
LESSONS = [
    name for name in FOUND if name not in ("engine", "progress") and not name.startswith("_")
]  # a module of exercises a lesson
EXERCISES = [each for name in LESSONS for each in exercises_of(import_module(f"kflearn.exercises.{name}"))]
NOTEBOOKS = notebooks()
IMPORT = re.compile(r"^from kflearn\.exercises import (\w+)(?: as (\w+))?[ \t]*$", re.MULTILINE)


def code_of(notebook):
    """All code cells of a notebook in one text."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


def modules_used_by(notebook):
    """{module: the name it has in the notebook} for each module of exercises that a notebook imports."""
    return {module: alias or module for module, alias in IMPORT.findall(code_of(notebook))}


def test_the_search_finds_the_package():
    assert "engine" in FOUND and "_answers" in FOUND


def test_the_import_is_recognised(tmp_path):
    cells = [
        {"cell_type": "markdown", "source": ["from kflearn.exercises import talked_about"]},
        {"cell_type": "code", "source": ["import numpy as np\n", "from kflearn.exercises import first as exercises\n"]},
        {"cell_type": "code", "source": "from kflearn.exercises import second"},
    ]
    notebook = tmp_path / "lesson.ipynb"
    notebook.write_text(json.dumps({"cells": cells}), encoding="utf-8")
    assert modules_used_by(notebook) == {"first": "exercises", "second": "second"}


@pytest.mark.parametrize("each", EXERCISES, ids=lambda each: f"{each.module.rpartition('.')[2]}.{each.name}")
def test_exercise(each):
    assert_sound(each)


@pytest.mark.parametrize("name", LESSONS)
def test_every_module_has_exercises_and_a_lesson(name):
    assert exercises_of(import_module(f"kflearn.exercises.{name}")), f"{name} defines no exercise"
    assert any(name in modules_used_by(notebook) for notebook in NOTEBOOKS), f"no lesson imports {name}"


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_a_lesson_uses_every_exercise_of_its_module(notebook):
    code, used = code_of(notebook), modules_used_by(notebook)
    assert code.count("kflearn.exercises") == len(used), "write: from kflearn.exercises import <module> as exercises"
    for module, alias in used.items():
        for each in exercises_of(import_module(f"kflearn.exercises.{module}")):
            assert f"{alias}.{each.name}.check(" in code, f"{notebook.name} does not use {module}.{each.name}"
