"""Your own data: a table of readings with time stamps, from a CSV file, for a filter.

The first line that is neither empty nor a comment (#) names the columns, with units in brackets: `height [m]` or
`height (m)`. Each other line is one row. Between columns stand semicolons, tabs or commas; with the first two, decimals
may have a comma. Time stamps are numbers with a unit, `t [ms]`, or dates as in ISO 8601, and they increase; local
times without a zone are refused where they leave out the hour that the clocks leave out in March. An empty field,
NaN, NA, N/A, null or None is a gap. Nothing is guessed that could change a number, and nothing in a file is ever
evaluated: whatever else is found is a RecordingError, which says so with the number of the line.

Examples
--------
>>> from kflearn import recordings
>>> lift = recordings.read(recordings.example("lift"))
>>> print(lift.names, f"{lift.steps.median:.2f} s")
('height', 'acceleration') 0.20 s
"""

import sys
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from numbers import Real
from pathlib import Path

import numpy as np

from ..core.frozen import Frozen, freeze
from . import tables as table
from .tables import RecordingError, short

__all__ = ["EXAMPLES", "Recording", "RecordingError", "Steps", "example", "parse", "read"]

EXAMPLES = ("lift", "cyclist", "thermometer")
LONGEST_GRID = 10_000_000  # rows


@dataclass(frozen=True, eq=False)
class Steps(Frozen):
    """The steps between the rows of a recording.

    Attributes
    ----------
    dt : ndarray (T − 1,)
        In seconds; dt[k] leads from row k to row k + 1.
    """

    dt: np.ndarray

    @property
    def median(self) -> float:
        """The median step, in seconds."""
        return float(np.median(self.dt))

    @property
    def even(self) -> bool:
        """Are all steps within 1 % of the median?"""
        return bool((abs(self.dt - self.median) <= 0.01 * self.median).all())

    @property
    def holes(self) -> np.ndarray:
        """The k of the steps that are longer than 3.5 medians, (holes,)."""
        return np.flatnonzero(self.dt > 3.5 * self.median)


@dataclass(frozen=True, eq=False)
class Recording(Frozen):
    """A table of readings; `recording["height"]` is one column of it, (T,); print it to see what is in it.

    Attributes
    ----------
    time : ndarray (T,)
        In seconds from the first row.
    values : ndarray (T, m)
        The readings, NaN for gaps.
    names, units : tuple of str
        Of the m columns; the unit is "" where the header gave none.
    lines : ndarray (T,)
        The line of each row in the file, 0 for a row that `on_grid` has put in.
    start : datetime or float
        The first time stamp, in its own unit.

    The arrays are read-only.
    """

    time: np.ndarray
    values: np.ndarray
    names: tuple[str, ...]
    units: tuple[str, ...]
    lines: np.ndarray
    start: datetime | float

    def __post_init__(self):
        freeze(vars(self))

    def __len__(self):
        return len(self.time)

    def __getitem__(self, name) -> np.ndarray:
        """The readings of one column, (T,). Raises RecordingError for an unknown name."""
        return self.values[:, table.find(name, self.names)]

    @cached_property
    def steps(self) -> Steps:
        """The steps between the rows: `.dt` (T−1,), `.median`, `.even`, `.holes`."""
        return Steps(np.diff(self.time))

    def on_grid(self, dt=None) -> "Recording":
        """The same readings in even steps, with rows of NaN where there was no row.

        Parameters
        ----------
        dt : float, optional
            The step in seconds; by default the median step.

        Raises
        ------
        RecordingError
            When a row lies more than a tenth of a step off the grid.
        """
        dt = self.steps.median if dt is None else dt
        if not (isinstance(dt, Real) and 0 < dt <= sys.float_info.max):  # type: ignore[operator]
            raise RecordingError((None, f"dt must be a positive number of seconds, got {short(dt)}"))
        dt = float(dt)
        if self.time[-1] > dt * LONGEST_GRID:
            raise RecordingError((None, f"a grid of {dt:g} s would have more than {LONGEST_GRID:,} rows"))
        place = self.time / dt
        k = np.round(place).astype(int)
        bad = (abs(place - k) > 0.1) | (np.diff(k, prepend=-1) == 0)
        if bad.any():
            off = f"the row at {self.time[bad][0]:.6g} s lies off the grid of {dt:g} s"
            raise RecordingError((int(self.lines[bad][0]), off))
        values, lines = np.full((k[-1] + 1, self.values.shape[1]), np.nan), np.zeros(k[-1] + 1, int)
        values[k], lines[k] = self.values, self.lines
        return Recording(dt * np.arange(k[-1] + 1), values, self.names, self.units, lines, self.start)

    def __str__(self):
        steps, evenness = self.steps, "even" if self.steps.even else "uneven"
        holes = [f"{steps.dt[k]:.4g} s after line {self.lines[k]}" for k in steps.holes]
        more = [f"and {len(holes) - 3} more"] if len(holes) > 3 else []
        told = [
            f"{len(self)} rows in {self.time[-1]:.6g} s, the first at {self.start}",
            f"steps: {steps.dt.min():.4g} to {steps.dt.max():.4g} s, median {steps.median:.4g} s, {evenness}",
            f"holes: {', '.join(holes[:3] + more) or 'none'}",
        ]
        for name, unit, z in zip(self.names, self.units, self.values.T, strict=True):
            span = f"{np.nanmin(z):.6g} to {np.nanmax(z):.6g} {unit or '(no unit)'}"
            told.append(f"{name}: {span}, gaps: {np.isnan(z).sum()}")
        return "\n".join(told)


def example(name) -> Path:
    """The path of a recording that comes with the course: "lift", "cyclist" or "thermometer".

    Raises RecordingError, with these names, for any other.
    """
    if name not in EXAMPLES:
        raise RecordingError((None, f"there is no example {short(name)}; the examples are {', '.join(EXAMPLES)}"))
    return Path(__file__).with_name("data") / f"{name}.csv"


def read(path, time=None, columns=None, time_unit=None, encoding="utf-8-sig") -> Recording:
    """Read a recording from a CSV file.

    Parameters
    ----------
    path : str or Path
        The file.
    time : str, optional
        The name of the column of time stamps; by default the first column.
    columns : list of str, optional
        The names of the columns to read; by default all others.
    time_unit : str, optional
        "ns", "us", "ms", "s", "min", "h" or "d", in place of the header's.
    encoding : str
        Of the text; by default UTF-8, with or without a byte order mark.

    Raises
    ------
    RecordingError
        And nothing else, when the file cannot be read or something in it is wrong.
    """
    try:
        raw = Path(path).read_bytes()
    except (OSError, TypeError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "this is not the name of a file"
        raise RecordingError((None, f"{short(getattr(path, 'name', path))} cannot be read: {reason}")) from None
    try:
        text = raw.decode(encoding)
    except UnicodeError as error:
        line = raw[: getattr(error, "start", 0)].count(b"\n") + 1
        advice = 'save it as "CSV UTF-8", or name its encoding, perhaps cp1252 or utf-16'
        raise RecordingError((line, f"this is not text in {short(encoding)}: {advice}")) from None
    except (LookupError, TypeError, ValueError):
        raise RecordingError((None, f"there is no encoding {short(encoding)}; perhaps cp1252 or utf-16?")) from None
    return parse(text, time, columns, time_unit)


def parse(text, time=None, columns=None, time_unit=None) -> Recording:
    """A recording from a text that holds the whole table; arguments and errors as in `read`."""
    if not isinstance(text, str):
        raise RecordingError((None, f"text must be a text, got {short(text)}"))
    faults: list = []
    rows, separator = table.rows_of(text, faults)
    top, names, units = table.header_of(*rows[0])
    clock = 0 if time is None else table.find(time, names, top)
    chosen = table.columns_of(columns, names, clock, top)
    rows = [(n, row) for n, row in rows[1:] if table.is_whole(n, row, len(names), separator, faults)]
    if len(rows) < 2:
        faults.append((top, f"a recording needs two rows or more below its header, found {len(rows)}"))
        raise RecordingError(*faults)
    number = table.Numbers(separator)
    unit = units[clock] if time_unit is None or str(time_unit) == "" else time_unit
    seconds, start = table.times_of(rows, clock, names[clock], unit, top, number, faults)
    chosen = table.without_words(chosen, rows, names, top, faults) or chosen
    values = np.array([[number.reading(n, names[j], fields[j], faults) for j in chosen] for n, fields in rows])
    if not faults:
        silent = [names[chosen[i]] for i in np.flatnonzero(np.isnan(values).all(axis=0))]
        faults = [(top, f"column {short(name)} holds no reading at all") for name in silent]
    if faults:
        raise RecordingError(*sorted(faults))
    names, units = (tuple(part[j] for j in chosen) for part in (names, units))
    return Recording(np.array(seconds), values, names, units, np.array([n for n, _ in rows]), start)
