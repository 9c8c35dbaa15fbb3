"""A table as it was found: columns of pandas, their names and units, and the number of each row's line."""

import re
from dataclasses import dataclass, replace

import numpy as np

from .faults import RecordingError, listed, short

GAPS = {"", "nan", "na", "n/a", "null", "none", "<na>", "#n/a", "nat"}
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
NAME_AND_UNIT = re.compile(r"(.*?)\s*(?:\[([^][]*)\]|\(([^()]*)\))")


@dataclass(frozen=True)
class Table:
    """Columns (pandas Series: numbers, dates or text), `titles` as written, `names`, `units`, `lines` of the rows.

    `top` is the line of the header, `word` what a row is called, "line" or "row"; `exact` tells whether each text is
    as it was written; `separator` is "" where there is no text.
    """

    columns: list
    titles: tuple
    lines: np.ndarray
    top: int | None = None
    separator: str = ""
    word: str = "line"
    exact: bool = True
    units_row: tuple = ()
    names: tuple = ()
    units: tuple = ()

    def __post_init__(self):
        if not self.names:
            names, units = names_of(self.titles, self.units_row)
            object.__setattr__(self, "names", names)
            object.__setattr__(self, "units", units)

    def __len__(self):
        return len(self.lines)

    def take(self, chosen) -> "Table":
        """Some of the rows, by a mask or their numbers."""
        return replace(self, columns=[c[chosen].reset_index(drop=True) for c in self.columns], lines=self.lines[chosen])

    def with_columns(self, columns, names, units) -> "Table":
        """The same rows with other columns."""
        return replace(self, columns=columns, names=tuple(names), units=tuple(units), titles=tuple(names))

    def find(self, name) -> int:
        """The number of a column, by its name, its title as written, or its name with a unit behind it."""
        if isinstance(name, str):
            twice = [j for j, title in enumerate(self.titles) if title == name]
            if name and len(twice) > 1 and name not in self.names:
                which = " or ".join(repr(self.names[j]) for j in twice[:2])
                raise RecordingError((self.top, f"two columns have the name {short(name)}: ask for {which}"))
            for known, wanted in ((self.names, name), (self.titles, name), (self.names, named(name)[0])):
                if wanted in known:
                    return known.index(wanted)
            if name.startswith("Unnamed: ") and "" in self.titles:  # what pandas calls them
                return self.titles.index("")
        fault = f"there is no column {short(name)}; the columns are {listed(self.names)}"
        raise RecordingError((self.top, fault), word=self.word)

    def text(self, j):
        """A column as stripped texts, "" for a gap; a list of str."""
        column = self.columns[j]
        if column.dtype.kind in "iub":
            return [str(each).lower() for each in column.tolist()]
        if column.dtype.kind == "f":
            return ["" if each != each else repr(each).removesuffix(".0") for each in column.tolist()]
        return ["" if each is None or each != each else str(each).strip() for each in column.tolist()]

    def is_numeric(self, j) -> bool:
        """Does a column hold numbers, not texts?"""
        return self.columns[j].dtype.kind in "iuf"


def is_gap(text) -> bool:
    """Is that a word for "no reading" that needs no asking?"""
    return text.lower() in GAPS


def named(field) -> tuple[str, str]:
    """Name and unit: "height [m]" → ("height", "m")."""
    found = NAME_AND_UNIT.fullmatch(field)
    return (found[1], (found[2] or found[3] or "").strip()) if found else (field, "")


def names_of(titles, units_row=()) -> tuple[tuple, tuple]:
    """Names and units of the columns: titles of which the short forms are equal keep their brackets."""
    pairs = [named(title) for title in titles]
    counts: dict = {}
    for name, _ in pairs:
        counts[name] = counts.get(name, 0) + 1
    names, units = [], []
    for j, (name, unit) in enumerate(pairs):
        if counts[name] > 1 or not name:
            unit = "" if len(unit) == 1 and unit in "xyzXYZ" else unit
            name = titles[j] if titles[j] and titles.count(titles[j]) == 1 else f"{titles[j] or 'column'}.{j + 1}"
        name = name if name != "column." + str(j + 1) else f"column {j + 1}"
        names.append(name)
        units.append(unit or (units_row[j] if j < len(units_row) else ""))
    return tuple(names), tuple(units)
