"""The course's equations by their names: a page, marks in the lessons to which it leads, and words for the search.

The table is pages/equations.md, a line for each equation: its names, its number, the lesson and the cell that derive
it, and the formula as the lesson writes it. Of a name, the words in bold are enough for the search.
"""

import re
import unicodedata
from pathlib import Path
from typing import NamedTuple

import nbformat

TABLE = Path(__file__).parent / "pages" / "equations.md"
ROW = r"(?m)^\| (?P<names>.+?) \| (?:\((?P<number>\w+)\) )?\| (?P<lesson>\d\d) (?P<cell>[\w-]+) \| (?P<formula>.+) \|$"
HEADING = r"(?m)^#+ (.+)$"


class Equation(NamedTuple):
    """A line of the table; `number` is "" where the equation has none."""

    names: list[str]
    number: str
    lesson: str
    cell: str
    formula: str

    @property
    def label(self):
        """The name of the mark in the lesson."""
        return f"eq-{self.lesson}-{self.cell}".lower()


def equation(row):
    """The equation in a line of the table."""
    return Equation(row["names"].split(", "), row["number"] or "", row["lesson"], row["cell"], row["formula"])


def table():
    """All equations, in the order of the page."""
    return [equation(row) for row in re.finditer(ROW, TABLE.read_text(encoding="utf-8"))]


# ---- the page, and the marks to which it leads


def page(lessons):
    """The page for Sphinx; lessons: paths of the notebooks that are built. The others are named without a link."""
    titles = {path.name[:2]: headings(path) for path in lessons}

    def row(found):
        each = equation(found)
        where = f"lesson {int(each.lesson)}"
        if each.lesson in titles:
            where = f"{{ref}}`{int(each.lesson)} · {titles[each.lesson][each.cell]} <{each.label}>`"
        number = f"({each.number})" if each.number else ""
        return f"| {', '.join(each.names)} | {number} | {where} | {each.formula} |"

    return re.sub(ROW, row, TABLE.read_text(encoding="utf-8"))


def headings(path):
    """{cell: heading under which it stands} of a lesson."""
    found, heading = {}, ""
    for cell in nbformat.read(path, as_version=4).cells:
        under = re.findall(HEADING, cell.source) if cell.cell_type == "markdown" else []
        heading = under[-1] if under else heading
        found[cell.id] = heading
    return found


def mark(cells, lesson):
    """Put the marks into the cells of a lesson, before the first paragraph under the last heading of each; lesson: its
    two digits."""
    marked = {each.cell: each.label for each in table() if each.lesson == lesson}
    for cell in cells:
        if cell.id in marked:
            above = max((found.end() for found in re.finditer(HEADING, cell.source)), default=0)
            cell.source = f"{cell.source[:above]}\n\n({marked[cell.id]})=\n{cell.source[above:].lstrip()}".lstrip()


# ---- the words by which the search finds them


def words(each):
    """What a reader may type for an equation: names in several spellings, their bold words, and its number."""
    bold = re.findall(r"\*\*(.+?)\*\*", " ".join(each.names))
    names = [name.replace("**", "").lower() for name in (*each.names, *bold)]
    return {spelling for name in names for spelling in spellings(name)} | set(numbered(each.number))


def spellings(name):
    """A name as it is printed, and as it is typed: with plain hyphens and letters, in American English."""
    plain = "".join(sign for sign in unicodedata.normalize("NFD", name) if not unicodedata.combining(sign))
    for text in {name, plain}:
        for dash in "–- ":
            joined = text.replace("–", dash)
            american = re.sub(r"is(ed|ation)\b", r"iz\1", joined)
            yield from (each.replace("'", "") if bare else each for each in (joined, american) for bare in (0, 1))


def numbered(number):
    """The ways to ask for an equation by its number."""
    if not number:
        return []
    forms = (number.lower(), f"({number.lower()})")
    return [forms[1], *(f"{word} {form}" for word in ("equation", "eq", "eq.", "formula") for form in forms)]
