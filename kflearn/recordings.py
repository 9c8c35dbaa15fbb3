"""Your own data: a table of readings with time stamps, from a CSV file, for a filter.

The first line that is neither empty nor a comment (#) names the columns, with units in brackets: `height [m]` or
`height (m)`. Each other line is one row. Between columns stand semicolons, tabs or commas; with the first two, decimals
may have a comma. Time stamps are numbers with a unit, `t [ms]`, or dates as in ISO 8601, and they increase. An empty
field, NaN, NA, N/A, null or None is a gap. Nothing is guessed that could change a number, and nothing in a file is ever
evaluated: whatever else is found is a RecordingError, which says so with the number of the line.
"""

import sys
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from numbers import Real
from pathlib import Path

import numpy as np

from . import _tables as table
from ._tables import RecordingError, short

__all__ = ["EXAMPLES", "Recording", "RecordingError", "Steps", "example", "parse", "read"]

EXAMPLES = ("lift", "cyclist", "thermometer")
LONGEST_GRID = 10_000_000  # rows


@dataclass(frozen=True, eq=False)
class Steps:
    """The steps between the rows of a recording: dt (T−1,) in seconds, dt[k] leads from row k to row k+1."""

    dt: np.ndarray

    @property
    def median(self):
        """In seconds."""
        return float(np.median(self.dt))

    @property
    def even(self):
        """Are all steps within 1 % of the median?"""
        return bool((abs(self.dt - self.median) <= 0.01 * self.median).all())

    @property
    def holes(self):
        """The k of the steps that are longer than 3.5 medians, (holes,)."""
        return np.flatnonzero(self.dt > 3.5 * self.median)


@dataclass(frozen=True, eq=False)
class Recording:
    """A table of readings; `recording["height"]` is one column of it, (T,); print it to see what is in it.

    time: (T,) in seconds from the first row; values: (T, m), NaN for gaps; names, units: m texts each, the unit ""
    where the header gave none; lines: (T,) the line of each row in the file, 0 for a row that `on_grid` has put in;
    start: the first time stamp, a datetime or a number in its own unit.
    """

    time: np.ndarray
    values: np.ndarray
    names: tuple[str, ...]
    units: tuple[str, ...]
    lines: np.ndarray
    start: datetime | float

    def __post_init__(self):
        for array in (self.time, self.values, self.lines):
            array.flags.writeable = False

    def __len__(self):
        return len(self.time)

    def __getitem__(self, name):
        """The readings of one column, (T,). Raises RecordingError for an unknown name."""
        return self.values[:, table.find(name, self.names)]

    @cached_property
    def steps(self):
        """The steps between the rows: `.dt` (T−1,), `.median`, `.even`, `.holes`."""
        return Steps(np.diff(self.time))

    def on_grid(self, dt=None):
        """The same readings in even steps of dt seconds (default: the median step), rows of NaN where there was no row.

        Raises RecordingError when a row lies more than a tenth of a step off the grid.
        """
        dt = self.steps.median if dt is None else dt
        if not (isinstance(dt, Real) and 0 < dt <= sys.float_info.max):
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


def example(name):
    """The path of a recording that comes with the course: "lift", "cyclist" or "thermometer"."""
    if name not in EXAMPLES:
        raise RecordingError((None, f"there is no example {short(name)}; the examples are {', '.join(EXAMPLES)}"))
    return Path(__file__).with_name("data") / f"{name}.csv"


def read(path, time=None, columns=None, time_unit=None, encoding="utf-8-sig"):
    """A Recording from a CSV file.

    path: the file; time: the name of the column of time stamps (default: the first column); columns: the names of those
    to read (default: all others); time_unit: "ns", "us", "ms", "s", "min", "h" or "d", in place of the header's;
    encoding: of the text; by default UTF-8, with or without a byte order mark.
    Raises RecordingError, and nothing else, when the file cannot be read or something in it is wrong.
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


def parse(text, time=None, columns=None, time_unit=None):
    """A Recording from a text that holds the whole table; arguments and errors as in `read`."""
    if not isinstance(text, str):
        raise RecordingError((None, f"text must be a text, got {short(text)}"))
    faults = []
    rows, separator = table.rows_of(text, faults)
    top, names, units = table.header_of(*rows[0])
    clock = 0 if time is None else table.find(time, names, top)
    chosen = table.columns_of(columns, names, clock, top)
    rows = [row for row in rows[1:] if table.is_whole(*row, len(names), separator, faults)]
    if len(rows) < 2:
        faults.append((top, f"a recording needs two rows or more below its header, found {len(rows)}"))
        raise RecordingError(*faults)
    number = table.Numbers(separator)
    unit = units[clock] if time_unit is None or str(time_unit) == "" else time_unit
    seconds, start = table.times_of(rows, clock, names[clock], unit, top, number, faults)
    values = np.array([[number.reading(n, names[j], fields[j], faults) for j in chosen] for n, fields in rows])
    if not faults:
        silent = [names[chosen[i]] for i in np.flatnonzero(np.isnan(values).all(axis=0))]
        faults = [(top, f"column {short(name)} holds no reading at all") for name in silent]
    if faults:
        raise RecordingError(*sorted(faults))
    names, units = (tuple(part[j] for j in chosen) for part in (names, units))
    return Recording(np.array(seconds), values, names, units, np.array([n for n, _ in rows]), start)
