"""What a class handed in: whose is each file, of which lesson, and which of several attempts counts.

A folder has a folder for each learner, with files of any name at any depth. A notebook beside the folders belongs to
whom its name says, before the first `_`. A notebook is recognised by its cells, not by its name. Of each notebook that
is not graded there is a sentence that says why.
"""

import re
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from pathlib import Path

from nbformat import NotebookNode, converter, reader

from dev.teaching.fresh_copy import Sheet, mark, repaired

PACKED = (".zip", ".tar", ".gz", ".tgz", ".7z", ".rar")
TIE = 2  # s: archives and copies keep times no better than that
BROKEN = "Not graded: the file is no notebook."
NOTHING = "Nothing was handed in."


@dataclass
class HandIn:
    """A file that somebody handed in."""

    learner: str
    path: Path
    name: str  # of the file, as seen from the folder of all answers

    @cached_property
    def saved(self):
        return self.path.stat().st_mtime

    @cached_property
    def cells(self):
        """Its cells, or None when it is no notebook."""
        try:
            notebook = converter.convert(reader.reads(self.path.read_text(encoding="utf-8-sig")), 4)
            return [plain(cell) for cell in notebook.cells]
        except Exception:  # whatever is wrong with it
            return None


@dataclass
class Attempt:
    """A notebook for one lesson: kind is "answers" or "lesson"."""

    file: HandIn
    sheet: Sheet
    kind: str

    @cached_property
    def answered(self):
        return self.sheet.answered(self.file.cells, self.kind)


@dataclass
class Job:
    """What is to be done for a learner and a lesson: grade an attempt, or say the trouble."""

    learner: str
    sheet: Sheet
    attempt: Attempt | None = None
    trouble: str = ""

    @property
    def note(self):
        """For the table: what was done, if it was not the usual."""
        if self.trouble:
            return "nothing handed in" if self.trouble == NOTHING else "not graded"
        return "from the lesson itself" if self.attempt.kind == "lesson" else ""


def plain(cell):
    """What is needed of a cell, whatever else stands in it."""
    name = mark(cell)
    about = {"nbgrader": {"grade_id": name}} if name else {}
    kind, id = str(cell.cell_type), str(cell.get("id", ""))
    return NotebookNode(cell_type=kind, source=shown("".join(cell.source)), id=id, metadata=about)


def shown(text):
    """A text that can be printed and written into every file."""
    return text.encode("utf-8", "replace").decode()


# ---- whose is it


def owner(name):
    """To whom a file beside the folders belongs: kim_04-answers.ipynb to kim, lee.ipynb to lee."""
    stem = re.split(r"(?i)\.ipynb", name)[0]
    return stem.partition("_")[0].strip() or stem


def hidden(part):
    """Checkpoints, and what macOS puts into archives."""
    return part.startswith(".") or part == "__MACOSX"


def is_notebook(file):
    return ".ipynb" in file.name.lower()  # browsers make .ipynb.txt and .ipynb.json of it


def find(folder):
    """The learners, their files, and sentences about what lies beside the folders."""
    learners = {shown(path.name) for path in folder.iterdir() if path.is_dir() and not hidden(path.name)}
    files, said, beside = [], [], []
    for path in sorted(folder.rglob("*")):
        parts = [shown(part) for part in path.relative_to(folder).parts]
        if any(map(hidden, parts)) or not path.is_file():
            continue
        if len(parts) > 1:
            files.append(HandIn(parts[0], path, "/".join(parts)))
        elif is_notebook(path):
            beside.append(owner(parts[0]))
            files.append(HandIn(beside[-1], path, parts[0]))
        elif path.suffix.lower() in PACKED:
            said.append(f"{parts[0]} is packed and was not opened. Unpack it and grade again.")
    if beside:
        whose = ", ".join(sorted(set(beside)))
        said.append(f"For files beside the folders, the file's name says whose they are. These learners are: {whose}.")
    return sorted(learners | set(beside)), files, said


# ---- which counts


def natural(attempt):
    """For sorting names as people do: "04 (2)" before "04 (10)"."""
    parts = re.split(r"(\d+)", re.sub(r"\.ipynb$", "", attempt.file.name))
    return [int(each) if each.isdecimal() else each for each in parts]


def choose(attempts):
    """The attempt that counts: one with answers, in the assignment's own file, the newest."""
    worked_on = max((each.answered > 0, each.kind == "answers") for each in attempts)
    best = [each for each in attempts if (each.answered > 0, each.kind == "answers") == worked_on]
    newest = max(each.file.saved for each in best)
    best = [each for each in best if newest - each.file.saved <= TIE]
    return max(best, key=lambda each: (each.answered, natural(each)))


def date(attempt):
    return datetime.fromtimestamp(attempt.file.saved).strftime("%Y-%m-%d %H:%M:%S")


def why_not(attempt, taken):
    """Why an attempt was set aside."""
    if attempt.file.cells == taken.file.cells:
        return "it is an exact copy"
    if taken.answered and not attempt.answered:
        return "nothing is answered in it" + (", though it is newer" if attempt.file.saved > taken.file.saved else "")
    if attempt.kind == "lesson" and taken.kind == "answers":
        return "it is the lesson itself, and there is a file of the assignment"
    if taken.file.saved - attempt.file.saved > TIE:
        return f"it is older, saved {date(attempt)}"
    fewer = attempt.answered < taken.answered
    return "it is as old, and " + ("has fewer answers" if fewer else "its name comes first")


def about(taken, attempts):
    """Sentences about a learner's files for a lesson, of which one is taken. The usual case needs none."""
    said, who = [], f"{taken.file.learner}, lesson {taken.sheet.number}"
    if taken.kind == "lesson":
        said.append(f"{who}: graded from the lesson itself, {taken.file.name}.")
    if not taken.answered:
        said.append(f"{who}: nothing is answered in {taken.file.name}.")
    deleted, changed = repaired(taken.sheet, taken.file.cells) if taken.kind == "answers" else ([], [])
    if deleted:
        said.append(f"{who}: locked cells had been deleted and were put back: {', '.join(deleted)}.")
    if changed:
        said.append(f"{who}: locked cells had been changed and were graded as handed out: {', '.join(changed)}.")
    others = [each for each in attempts if each is not taken]
    if others:
        said.append(f"{who}: {taken.file.name} was graded, saved {date(taken)}.")
    return said + [f"{who}: {each.file.name} was set aside: {why_not(each, taken)}." for each in others]


# ---- all together


def plan(sheets, folder):
    """The jobs, one for each learner and lesson, and sentences about all files that need one."""
    learners, files, said = find(Path(folder))
    jobs = []
    for learner in learners:
        mine = [file for file in files if file.learner == learner]
        notebooks = [file for file in mine if is_notebook(file.path)]
        used = []
        for sheet in sheets:
            attempts = attempts_at(sheet, notebooks)
            taken = choose(attempts) if attempts else None
            jobs.append(Job(learner, sheet, taken, "" if taken else missing(sheet, sheets, notebooks)))
            said += about(taken, attempts) if taken else []
            used += [each.file for each in attempts]
        said += [unused(file) for file in notebooks if file not in used]
        said += [unused(file) for file in mine if file not in notebooks and (is_packed(file) or not notebooks)]
    return jobs, said


def attempts_at(sheet, notebooks):
    found = [Attempt(file, sheet, sheet.kind(file.cells)) for file in notebooks if file.cells is not None]
    return [each for each in found if each.kind]


def missing(sheet, sheets, notebooks):
    """Why there is nothing to grade. A broken file may be that of a lesson, unless its name has another's number."""
    known = {each.number for each in sheets}
    for file in notebooks:
        named = [number for number in re.findall(r"(?<!\d)\d\d(?!\d)", file.path.name) if number in known]
        if file.cells is None and named[:1] in ([], [sheet.number]):
            return BROKEN
    return NOTHING


def is_packed(file):
    return file.path.suffix.lower() in PACKED


def unused(file):
    """A sentence about a file that is not used at all."""
    if is_packed(file):
        return f"{file.learner}: {file.name} is packed and was not opened. Unpack it and grade again."
    if not is_notebook(file.path) or file.cells is None:
        return f"{file.learner}: {file.name} is no notebook. It was not used."
    return f"{file.learner}: {file.name} has no exercise of this assignment. It was not used."
