"""What a class handed in: whose is each file, of which lesson, and which of several attempts counts.

A folder has a folder for each learner, with files of any name at any depth. A notebook beside the folders belongs to
whom its name says, before the first `_`. A notebook is recognised by its cells, not by its name. Of each file that is
not graded there is a sentence that says why; only hidden files, such as checkpoints, are passed over.
"""

import re
import unicodedata
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property
from pathlib import Path

from nbformat import NotebookNode, converter, reader

from dev.teaching.fresh_copy import MODULE, Sheet, code, lost, mark, repaired

PACKED = (".zip", ".tar", ".gz", ".tgz", ".7z", ".rar")
TIE = 2  # s: archives and copies keep times no better than that
UNUSABLE = "Handed in, not usable"
PACKAGE = "is packed and was not opened. Unpack it and grade again."
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
    unusable: list = field(default_factory=list)  # what may have been meant for this lesson, in place of an attempt
    trouble: str = ""

    @property
    def note(self):
        """For the table: what was done, if it was not the usual."""
        if self.unusable:
            return f"{UNUSABLE.lower()}: {self.files}"
        if self.trouble:
            return "not graded" if self.attempt else "nothing handed in"
        return "from the lesson itself" if self.attempt.kind == "lesson" else ""

    @property
    def files(self):
        """The names of what was handed in."""
        return ", ".join(file.name for file in ([self.attempt.file] if self.attempt else self.unusable))


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


def letters(name):
    """For sorting people's names: capitals and accents make no difference, unless nothing else does."""
    plain_letters = "".join(sign for sign in unicodedata.normalize("NFKD", name) if not unicodedata.combining(sign))
    return plain_letters.casefold(), name


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
            said.append(f"{parts[0]} {PACKAGE}")
        else:
            said.append(f"{parts[0]} is no notebook and in no learner's folder. It was not used.")
    if beside:
        whose = ", ".join(sorted(set(beside), key=letters))
        said.append(f"For files beside the folders, the file's name says whose they are. These learners are: {whose}.")
    return sorted(learners | set(beside), key=letters), files, said


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
    if gone := lost(taken.sheet, taken.file.cells, taken.kind):
        said.append(f"{who}: no answer cell was found, as when it was deleted, for: {', '.join(gone)}.")
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
        tried = {sheet.number: attempts_at(sheet, mine) for sheet in sheets}
        used = [each.file for attempts in tried.values() for each in attempts]
        left = [file for file in mine if file not in used]
        for sheet in sheets:
            if attempts := tried[sheet.number]:
                taken = choose(attempts)
                jobs.append(Job(learner, sheet, taken))
                said += about(taken, attempts)
            else:
                jobs.append(without_attempt(learner, sheet, sheets, left))
        said += [f"{learner}: {file.name} {useless(file)}" for file in left]
    return jobs, said


def attempts_at(sheet, files):
    notebooks = [file for file in files if is_notebook(file.path) and file.cells is not None]
    found = [Attempt(file, sheet, sheet.kind(file.cells)) for file in notebooks]
    return [each for each in found if each.kind]


def without_attempt(learner, sheet, sheets, left):
    """There is nothing to grade. A useless file may be meant for a lesson, unless its name has another's number."""
    known, meant = {each.number for each in sheets}, []
    for file in left:
        named = [number for number in re.findall(r"(?<!\d)\d\d(?!\d)", file.path.name) if number in known]
        if named[:1] in ([], [sheet.number]):
            meant.append(file)
    reasons = " ".join(f"{file.name} {useless(file)}" for file in meant)
    return Job(learner, sheet, None, meant, f"{UNUSABLE}: {reasons}" if meant else NOTHING)


def useless(file):
    """Why a file is not used at all; the end of a sentence that begins with its name."""
    if file.path.suffix.lower() in PACKED:
        return PACKAGE
    if not is_notebook(file.path) or file.cells is None:
        return "is no notebook. It was not used."
    if not file.cells:
        return "has no cells. It was not used."
    other = "exercises of another lesson" if MODULE.search(code(file.cells)) else "no exercise of this assignment"
    return f"has {other}. It was not used."
