"""A learner's answers in a fresh copy of the assignment: deleted or changed locked cells do no harm.

Every cell of the copy comes from the notebook that was handed out. Only the answer cells, and the few other cells that
are not locked, get the learner's text. Cells that the learner added stay where they are, between the others.
"""

import ast
import copy
import re

import nbformat

MODULE = re.compile(r"^\s*from kflearn\.exercises import (\w+)", re.MULTILINE)
CHECK = re.compile(r"\bexercises\.(\w+)\.check\(")  # in a lesson, and in a learner's own cells
LOCKED_CHECK = re.compile(r"^outcome = exercises\.(\w+)\.check\((.*)\)$", re.MULTILINE)  # in an assignment only


def bare(source):
    """A cell's text without differences of blanks and line ends."""
    return " ".join(source.split())


def mark(cell):
    """The name that nbgrader has written into a cell, or None."""
    about = cell.metadata.get("nbgrader", {}) if isinstance(cell.metadata, dict) else {}
    name = about.get("grade_id") if isinstance(about, dict) else None
    return name if isinstance(name, str) else None


def makes(source, variable):
    """Does the text make this name? It need not be correct Python."""
    name = re.escape(variable)
    return bool(re.search(rf"^(?:def {name}\b|{name}(?: *:[^=\n]+)? *=(?!=))", source, re.MULTILINE))


def code(cells):
    """The text of all code cells."""
    return "\n".join(cell.source for cell in cells if cell.cell_type == "code")


class Sheet:
    """A lesson's assignment as it was handed out: its cells by name, and which of them are answers."""

    def __init__(self, number, release, lesson):
        self.number = number
        self.notebook = nbformat.read(release, as_version=4)
        handed_out = self.notebook.cells
        self.cells = {mark(cell) or cell.id: cell for cell in handed_out}
        self.by_id = {cell.id: name for name, cell in self.cells.items()}
        self.by_text = {bare(cell.source): name for name, cell in self.cells.items()}
        self.locked = {name for name, cell in self.cells.items() if self.has(cell, "locked")}
        self.graded = [name for name, cell in self.cells.items() if self.has(cell, "grade")]
        self.variables = dict(LOCKED_CHECK.findall(code(handed_out)))  # what the check of each exercise looks for
        self.answers = [name for name in self.variables if name in self.cells]
        self.module = next(iter(MODULE.findall(code(handed_out))), "")
        lesson = nbformat.read(lesson, as_version=4).cells
        self.untouched = {bare(cell.source) for cell in [*handed_out, *lesson]}

    @staticmethod
    def has(cell, right):
        return bool(cell.metadata.get("nbgrader", {}).get(right))

    def kind(self, cells):
        """How a notebook belongs to this sheet: as "answers", as the "lesson" itself, or "" for not at all."""
        text = code(cells)
        modules, asked = set(MODULE.findall(text)), set(CHECK.findall(text)) & set(self.variables)
        if modules and self.module not in modules:
            return ""  # exercises of two lessons may have the same name
        marked = {*self.answers, *self.graded} & {mark(cell) for cell in cells}
        if marked or asked & {name for name, _ in LOCKED_CHECK.findall(text)}:
            return "answers"
        if asked:
            return "lesson"
        return "answers" if modules and any(makes(text, each) for each in self.variables.values()) else ""

    def answered(self, cells, kind):
        """How many answer cells say something else than what was handed out."""
        cells = section(cells) if kind == "lesson" else cells
        chosen = places(self, cells, labels(self, cells, kind))
        return sum(bare(cells[chosen[name]].source) not in self.untouched for name in self.answers if name in chosen)


# ---- which cell is which


def section(cells):
    """The cells of a lesson from its exercises on. What stands before is calculated again in the assignment."""
    heading = (place for place, cell in enumerate(cells) if "## Exercises" in cell.source)
    first = (place for place, cell in enumerate(cells) if cell.cell_type == "code" and CHECK.search(cell.source))
    return cells[next(heading, next(first, 0)) :]


def label(sheet, cell, kind):
    """The name of the cell on the sheet that a learner's cell stands for, or None."""
    if kind == "lesson":
        asked = CHECK.search(cell.source) if cell.cell_type == "code" else None
        return asked[1] if asked and asked[1] in sheet.answers else sheet.by_text.get(bare(cell.source))
    if mark(cell) in sheet.cells:
        return mark(cell)
    same = sheet.by_id.get(cell.get("id"))
    if same and sheet.cells[same].cell_type == cell.cell_type:
        return same
    checks = LOCKED_CHECK.search(cell.source)
    if checks and f"points-{checks[1]}" in sheet.cells:
        return f"points-{checks[1]}"
    return sheet.by_text.get(bare(cell.source))


def labels(sheet, cells, kind):
    """What each of a learner's cells stands for. An answer without its mark is recognised by the name that it makes."""
    found = [label(sheet, cell, kind) for cell in cells]
    for name in sheet.answers:
        if name not in found:
            for place, cell in enumerate(cells):
                if not found[place] and cell.cell_type == "code" and makes(cell.source, sheet.variables[name]):
                    found[place] = name
    return found


def places(sheet, cells, found):
    """Where each cell of the sheet stands among the learner's: {name: place}.

    Of an answer that is there twice the last one counts that is not untouched; of a check the first after its answer.
    """
    chosen = {}
    for place, name in enumerate(found):
        written = bare(cells[place].source) not in sheet.untouched
        if name in sheet.answers and (written or name not in chosen):
            chosen[name] = place
    for place, name in enumerate(found):
        if name and place > chosen.get(name.removeprefix("points-"), -1):
            chosen.setdefault(name, place)
    return chosen


# ---- the copy


def fresh_copy(sheet, cells, kind):
    """The notebook to be graded, and the names of the exercises for which the learner has no answer cell."""
    cells = section(cells) if kind == "lesson" else cells
    found = labels(sheet, cells, kind)
    chosen = places(sheet, cells, found)
    made = []
    for place, (name, cell) in enumerate(zip(found, cells, strict=True)):
        if chosen.get(name) == place:
            made.append((name, carried(sheet, name, cell, kind)))
        elif name not in sheet.locked:
            made.append((None, own(cell)))
    put_back(sheet, made)
    notebook = copy.deepcopy(sheet.notebook)
    notebook.cells = [cell for _, cell in made]
    for number, cell in enumerate(notebook.cells):
        cell.id = f"cell-{number}"
    return notebook, lost(sheet, cells, kind)


def lost(sheet, cells, kind):
    """The names of the exercises for which the learner has no answer cell."""
    cells = section(cells) if kind == "lesson" else cells
    found = labels(sheet, cells, kind)
    return [name for name in sheet.answers if name not in found]


def repaired(sheet, cells):
    """The names of the locked cells that a learner deleted, and of those that were changed."""
    found, bad = labels(sheet, cells, "answers"), set()
    for name, cell in zip(found, cells, strict=True):
        if name in sheet.locked and bare(cell.source) != bare(sheet.cells[name].source):
            bad.add(name)
    deleted = [name for name in sheet.cells if name in sheet.locked and name not in found]
    return deleted, [name for name in sheet.cells if name in bad]


def carried(sheet, name, cell, kind):
    """The sheet's cell of this name, with the learner's text unless it is locked."""
    new = copy.deepcopy(sheet.cells[name])
    if name not in sheet.locked:
        in_lesson = kind == "lesson" and name in sheet.answers
        new.source = adapted(cell.source, name, sheet.variables[name]) if in_lesson else cell.source
    return new


def adapted(source, name, variable):
    """A lesson's exercise cell with one more line: what it checks also gets the name that the assignment checks."""
    try:
        calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call) and node.args]
        given = [ast.unparse(node.args[0]) for node in calls if ast.unparse(node.func) == f"exercises.{name}.check"]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        given = re.findall(rf"\bexercises\.{name}\.check\((.*)\)", source)
    return source if not given or given[-1] == variable else f"{source}\n{variable} = {given[-1]}"


def own(cell):
    """A cell that the learner added: its text, and nothing that nbgrader would read."""
    kinds = {"code": nbformat.v4.new_code_cell, "raw": nbformat.v4.new_raw_cell}
    return kinds.get(cell.cell_type, nbformat.v4.new_markdown_cell)(cell.source)


def put_back(sheet, made):
    """Put what was deleted back before the cell that follows it on the sheet. Answers are not invented."""
    names = list(sheet.cells)
    for number in reversed(range(len(names))):
        name, present = names[number], [one for one, _ in made]
        if name in present or name in sheet.answers:
            continue
        place = next((present.index(after) for after in names[number + 1 :] if after in present), len(made))
        answer = name.removeprefix("points-")
        if answer in present:
            place = max(place, present.index(answer) + 1)
        made.insert(place, (name, copy.deepcopy(sheet.cells[name])))
