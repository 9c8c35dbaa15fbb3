"""What learners hand in, for the tests of assignments: right, wrong, stripped, renamed, or the lesson itself."""

import os
import re
from functools import cache
from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell

from dev.lessons import lessons
from dev.teaching.assignment import assignment
from dev.teaching.fresh_copy import mark

ROOT = Path(__file__).parents[2]

LESSON = {path.name[:2]: path for path in lessons()}
ASKED = {
    "04": ["third_opinion", "fuse", "readings_needed", "published_claim", "common_cause"],
    "05": ["second_gain", "steady_gain", "is_unknown", "auto_start", "best_error", "whole_filter"],
}


@cache
def teachers(number):
    return assignment(LESSON[number])


def release(number):
    """A lesson's assignment as nbgrader hands it out."""
    notebook = teachers(number).copy()
    notebook.cells = [cell.copy() for cell in notebook.cells]
    for cell in notebook.cells:
        cell.source = re.sub(r"(?m)^ *### BEGIN SOLUTION.*?### END SOLUTION$", "", cell.source, flags=re.DOTALL)
    return notebook


def by_name(notebook):
    return {mark(cell): cell for cell in notebook.cells}


def right(number):
    """The solutions, by the names of the answer cells."""
    return {name: cell.source for name, cell in by_name(teachers(number)).items() if name in ASKED[number]}


def answered(number, answers=None):
    """A learner's notebook with everything right, but for some cells written anew."""
    notebook = release(number)
    answers = right(number) | (answers or {})
    for cell in notebook.cells:
        cell.source = answers.get(mark(cell), cell.source)
    return notebook


def without(notebook, *names):
    notebook.cells = [cell for cell in notebook.cells if mark(cell) not in names]
    return notebook


def stripped(notebook):
    """As some tools leave a notebook: no metadata, new ids."""
    for number, cell in enumerate(notebook.cells):
        cell.metadata, cell.id = {}, f"new-{number}"
    return notebook


def the_lesson(number):
    """The lesson itself, with the solutions in its own exercise cells."""
    notebook, solutions = nbformat.read(LESSON[number], as_version=4), right(number)
    for cell in notebook.cells:
        found = re.search(r"exercises\.(\w+)\.check\((\w+)\)", cell.source) if cell.cell_type == "code" else None
        if found:
            imports = cell.source.partition("\n\n")[0] if "import" in cell.source else ""
            solution = re.sub(r"\banswer_\w+", "answer", solutions[found[1]])
            cell.source = "\n\n".join([imports, solution, found[0]])
    return notebook


def save(notebook, folder, name, day=1):
    """Write a notebook, and say on which day of January 2026 it was saved."""
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    nbformat.write(notebook, path)
    os.utime(path, (1767225600 + 86400 * day,) * 2)
    return path


def helped(notebook):
    """Right, by means of a function in a cell of the learner's own."""
    cells = by_name(notebook)
    place = notebook.cells.index(cells["fuse"])
    cells[
        "fuse"
    ].source = "def fuse(mx, vx, mz, vz):\n    K = share(vx, vz)\n    return mx + K * (mz - mx), vx * (1 - K)"
    notebook.cells.insert(place, new_code_cell("def share(vx, vz):\n    return vx / (vx + vz)"))
    return notebook
