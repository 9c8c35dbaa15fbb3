"""Turn the exercises of lessons into an assignment, and grade a class's answers, with nbgrader.

    python -m dev.teaching.assignment 04 05                     the assignment, in build/assignment
    python -m dev.teaching.assignment 04 05 --grade answers     grade what is in answers/LEARNER

build/assignment is an nbgrader course: `source` is the teacher's version with solutions, `release` is for the learners.
Only who made the folder can look into it, so that on a shared machine nobody finds solutions or grades there.
Each notebook holds the exercises of one lesson, and what they need of it. An exercise is one point. Names of files that
are handed in do not matter (`hand_ins.py` says whose and which they are). Each notebook is graded as a fresh copy with
the learner's answers (`fresh_copy.py`), in a kernel of its own, with a time limit for each cell (`grading.py`); the
points come from the lesson's own check. The table is printed and kept in points-04-05.csv, what each learner was told
in answers-04-05.csv.
"""

import argparse
import ast
import os
import re
import symtable
import sys
import warnings
from importlib import import_module
from pathlib import Path

import nbformat

from dev.teaching.grading import Course, report, table, write

ROOT = Path(__file__).parents[2]
IMPORT = re.compile(r"^from kflearn\.exercises import (\w+) as exercises\n*", re.MULTILINE)
HEAD = """{title}: exercises

Open the lesson as well: where an exercise says "above", "the article" or "our", it means that lesson.

Put your work in place of the dots and run the cell. Then run the cell below it: it says what it finds, and shows a 1
when the point is yours. Try as often as you like. Save, and hand in this file, {file}.{given}"""
GIVEN = """

First comes what the exercises need of the lesson, calculated again: run these cells, you need not read them."""
GRADE = """outcome = exercises.{name}.check({answer})
print(outcome)
int(outcome.status == "right")"""


# ---- a lesson's exercises as a notebook for nbgrader


def assignment(path):
    """The teacher's version of a lesson's exercises: solutions between BEGIN SOLUTION and END SOLUTION."""
    cells = nbformat.read(path, as_version=4).cells
    code = "\n".join(cell.source for cell in cells if cell.cell_type == "code")
    found = IMPORT.search(code)
    start = next((i for i, cell in enumerate(cells) if "## Exercises" in cell.source), None)
    if not found or start is None:
        raise ValueError(f"{path.name} has no exercises")
    module = import_module(f"kflearn.exercises.{found[1]}")
    last = max(i for i, cell in enumerate(cells) if cell.cell_type == "code" and ".check(" in cell.source)
    cells[start].source = "## Exercises" + cells[start].source.partition("## Exercises")[2]
    section = cells[start : last + 1]
    made = [new(cell, module) for cell in section]
    needs = [
        new_cell("code", source, f"given-{i}", locked=True) for i, source in enumerate(given(cells[:start], section))
    ]
    title = cells[0].source.splitlines()[0]
    file = f"{path.name[:2]}-answers.ipynb"
    head = new_cell("markdown", HEAD.format(title=title, file=file, given=GIVEN if len(needs) > 1 else ""))
    notebook = nbformat.v4.new_notebook(cells=[head, *needs, *(cell for each in made for cell in each)])
    notebook.metadata.kernelspec = {"name": "python3", "display_name": "Python 3 (ipykernel)", "language": "python"}
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"
    return notebook


def new_cell(kind, source, grade_id=None, **rights):
    """A cell, with nbgrader's metadata when it has a name."""
    cell = nbformat.v4.new_code_cell(source) if kind == "code" else nbformat.v4.new_markdown_cell(source)
    if grade_id:
        plain = dict(schema_version=3, grade=False, solution=False, locked=False, task=False)
        cell.metadata.nbgrader = plain | {"grade_id": grade_id} | rights
    return cell


def new(cell, module):
    """The cells that a cell of the exercise section becomes: itself, or an answer and its check."""
    if cell.cell_type == "markdown":
        return [new_cell("markdown", re.sub(r"\[([^\]]*)\]\(\d\d-[\w-]+\.ipynb\)", r"\1", cell.source))]
    source = IMPORT.sub("", cell.source)
    asked = next((statement for statement in ast.parse(source).body if is_check(statement)), None)
    if asked is None:
        return [new_cell("code", source)]
    name, handed_in = asked.value.func.value.attr, asked.value.args[0]
    lines = source.splitlines()
    lines[asked.lineno - 1 : asked.end_lineno] = []
    source = "\n".join(lines).strip()
    if not isinstance(handed_in, ast.Name):
        source, answer = f"{source}\n\nanswer_{name} = ...", f"answer_{name}"
    elif handed_in.id == "answer":  # a name of its own, so that no answer is taken for that of another exercise
        source, answer = re.sub(r"\banswer\b", f"answer_{name}", source), f"answer_{name}"
    else:
        answer = handed_in.id
    source = with_solution(source, answer, getattr(module, name))
    return [
        new_cell("code", source, name, solution=True),
        new_cell("code", GRADE.format(name=name, answer=answer), f"points-{name}", grade=True, locked=True, points=1),
    ]


def is_check(statement):
    """Is it exercises.NAME.check(…)?"""
    return isinstance(statement, ast.Expr) and bool(
        re.fullmatch(r"exercises\.\w+\.check\(.*\)", ast.unparse(statement), re.DOTALL)
    )


def with_solution(source, answer, exercise):
    """The cell with the solution behind the learner's dots."""
    *lines, check = exercise.solution().text.splitlines()
    found = ast.parse(check).body[0].value.args[0].id
    place = next(s for s in ast.parse(source).body if answer in names(ast.unparse(s))[1])
    is_function = isinstance(place, ast.FunctionDef)
    if is_function:
        lines += [f"return {found}({', '.join(each.arg for each in place.args.args)})"]
    else:
        lines = [re.sub(r"\banswer\b", answer, line) for line in lines]
    block = ["### BEGIN SOLUTION", *lines, "### END SOLUTION"]
    indent = "    " if is_function else ""
    code = source.splitlines()
    code[place.end_lineno : place.end_lineno] = [f"{indent}{line}".rstrip() for line in block]
    return "\n".join(code)


# ---- what the exercises need of the lesson


def names(source):
    """The global names that a piece of code reads, and those that it makes."""
    top = symtable.symtable(source, "cell", "exec")
    symbols, tables = {symbol.get_name(): symbol for symbol in top.get_symbols()}, top.get_children()
    reads = {name for name, symbol in symbols.items() if symbol.is_referenced()}
    makes = {name for name, symbol in symbols.items() if symbol.is_assigned() or symbol.is_imported()}
    while tables:
        table = tables.pop()
        tables += table.get_children()
        reads |= {symbol.get_name() for symbol in table.get_symbols() if symbol.is_global()}
    return reads, makes


def changes(source):
    """Names of what is changed in place: x[…] = …, x.y = …, x.append(…), and random generators, by being used."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Attribute | ast.Subscript) and isinstance(node.ctx, ast.Store):
            found |= {part.id for part in ast.walk(node.value) if isinstance(part, ast.Name)}
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            function = node.value.func
            if isinstance(function, ast.Attribute) and isinstance(function.value, ast.Name):
                found.add(function.value.id)
        if isinstance(node, ast.Name) and "rng" in node.id:
            found.add(node.id)
    return found


def split(source):
    """The import statements of a cell, and the rest of it."""
    imports = [each for each in ast.parse(source).body if isinstance(each, ast.Import | ast.ImportFrom)]
    lines = source.splitlines()
    for each in imports:
        lines[each.lineno - 1 : each.end_lineno] = [""] * (each.end_lineno - each.lineno + 1)
    return imports, "\n".join(lines).strip()


def given(before, section):
    """The code of the lesson on which its exercises depend: imports first, then whole cells, in their order."""
    needed, words = {"np"}, set()
    for cell in section:
        if cell.cell_type == "code":
            needed |= names(cell.source)[0]
            words |= set(re.findall(r"\w+", cell.source))  # a comment may say what is at hand
        else:
            needed |= set(re.findall(r"\w+", " ".join(re.findall(r"`([^`]+)`", cell.source))))
    needed.discard("answer")  # of an exercise before these
    code = [split(cell.source) for cell in before if cell.cell_type == "code"]
    imports = [statement for statements, _ in code for statement in statements]
    imported = {alias.asname or alias.name for statement in imports for alias in statement.names}
    kept = []
    for _, source in reversed(code):
        if (names(source)[1] | changes(source) - imported) & needed:
            kept.insert(0, source)
            needed |= names(source)[0]
    first = []
    for statement in imports:
        statement.names = [alias for alias in statement.names if (alias.asname or alias.name) in needed | words]
        if statement.names:
            first.append(ast.unparse(statement))
    checks = IMPORT.search("\n".join(cell.source for cell in [*before, *section] if cell.cell_type == "code"))[
        0
    ].strip()
    return ["\n".join([*dict.fromkeys(line for line in first if line != checks), checks]), *kept]


# ---- the command


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lessons", nargs="+", help="numbers of lessons, such as 04 05")
    parser.add_argument("--grade", type=Path, metavar="FOLDER", help="a folder with a folder of notebooks a learner")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "assignment")
    parser.add_argument("--seconds", type=int, help="time limit of a cell (60)")
    options = parser.parse_args()
    if options.grade and not options.grade.is_dir():
        sys.exit(f"there is no folder {options.grade}")
    lessons = []
    for number in options.lessons:
        found = sorted((ROOT / "notebooks").glob(f"{number:0>2}-*.ipynb"))
        lessons += found or sys.exit(f"there is no lesson {number}")
    course = Course(options.out, lessons, options.seconds)
    warnings.filterwarnings("ignore", module="nbgrader")  # what its database says to its authors
    if not (options.grade and (options.out / "release" / course.name).exists()):  # graded is what was handed out
        course.build(assignment)
        print(f"for the learners: {os.path.relpath(options.out / 'release' / course.name)}")
    if options.grade:
        grade(course, options.grade)


def grade(course, folder):
    """Grade a folder of answers; print and keep what came out."""
    rows, jobs, said = course.grade(folder)
    if not rows:
        sys.exit("\n".join([f"{folder} has no notebooks and no folders of learners.", *said]))
    points, answers = write(rows, course.folder)
    print(f"\n{table(rows, jobs)}\n\n{report(jobs, said)}")
    print(f"\nThe points are also in {os.path.relpath(points)}, the sentences in {answers.name}.")


if __name__ == "__main__":
    main()
