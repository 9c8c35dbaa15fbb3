"""A recording and its steps."""

import sys
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cached_property
from numbers import Real

import numpy as np

from ...core.frozen import Frozen, freeze
from .codes import suspects
from .faults import RecordingError, listed, short
from .table import named
from .told import told

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
        In seconds from the stamp `start`, which is that of the first row.
    values : ndarray (T, m)
        The readings, NaN for gaps.
    names, units : tuple of str
        Of the m columns; the unit is "" where the header gave none.
    lines : ndarray (T,)
        The line of each row in the file, 0 for a row that `on_grid` has put in; of a DataFrame the number of the row.
    start : datetime or number
        The first time stamp, a pandas Timestamp (a datetime, with its zone), or a number in its own unit.
    tick : float
        The seconds of one unit of `start` where it is a number.
    notes : tuple of str
        What was done to read it, and what was left out.
    moved : ndarray (m,)
        By how much a straight line between neighbours would change the readings that `on_grid` moved: the mean square,
        in the units of R.

    The arrays are read-only: `recording.values.copy()` can be changed.
    """

    time: np.ndarray
    values: np.ndarray
    names: tuple[str, ...]
    units: tuple[str, ...]
    lines: np.ndarray
    start: datetime | float
    tick: float = 1.0
    notes: tuple[str, ...] = ()
    moved: np.ndarray | None = None

    def __post_init__(self):
        freeze(vars(self))

    def __len__(self):
        return len(self.time)

    def __getitem__(self, name) -> np.ndarray:
        """The readings of one column, (T,). Raises RecordingError for an unknown name."""
        return self.values[:, self.find(name)]

    def find(self, name) -> int:
        """The number of a column; its unit may follow its name. Raises RecordingError for an unknown name."""
        for wanted in (name, named(name)[0]) if isinstance(name, str) else ():
            if wanted in self.names:
                return self.names.index(wanted)
        raise RecordingError((None, f"there is no column {short(name)}; the columns are {listed(self.names)}"))

    @cached_property
    def steps(self) -> Steps:
        """The steps between the rows: `.dt` (T−1,), `.median`, `.even`, `.holes`."""
        return Steps(np.diff(self.time))

    @cached_property
    def suspects(self) -> list:
        """(name, number, how often, who writes it) for each number that may mean "not available"."""
        return [(self.names[j], code, count, who) for j, code, count, who in suspects(self.values)]

    def on_grid(self, dt=None) -> "Recording":
        """The same readings in even steps, with rows of NaN where there was no row.

        A row that lies off the grid by up to a tenth of a step is moved with its value as it is. Its `.moved`, and
        its print, say how far, and what that changes: compare it with R.

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
            raise RecordingError((int(self.lines[bad][0]), f"{off}: use each step, steps.dt, in F and Q"))
        values, lines = np.full((k[-1] + 1, self.values.shape[1]), np.nan), np.zeros(k[-1] + 1, int)
        values[k], lines[k] = self.values, self.lines
        shift = dt * k - self.time
        moved, notes = None, self.notes
        if abs(shift).max() > 1e-9 * max(dt, self.time[-1]):
            moved = _moved(self.time, self.values, shift)
            changes = ", ".join(
                f"{name} {v:.2g}{_square(unit)}" for name, unit, v in zip(self.names, self.units, moved, strict=True)
            )
            notes = (*notes, f"rows moved by up to {abs(shift).max():.3g} s; this adds to R about: {changes}")
        time = dt * np.arange(k[-1] + 1)
        return replace(self, time=time, values=values, lines=lines, notes=notes, moved=moved)

    def in_metres(self, lat="lat", lon="lon", origin=None) -> "Recording":
        """The same recording with metres east and north of its first position in place of degrees.

        Parameters
        ----------
        lat, lon : str
            The columns of latitude and longitude, in degrees.
        origin : (latitude, longitude), optional
            Of the point from which east and north are counted.

        Raises
        ------
        RecordingError
            Where a column is no latitude or longitude, or pymap3d is not installed.
        """
        from .plane import metres

        return metres(self, lat, lon, origin)

    def __str__(self):
        return told(self)


def _moved(time, values, shift):
    """Mean square of shift times slope: the slope from neighbours that were read."""
    changes = np.zeros(values.shape[1])
    for j, column in enumerate(values.T):
        there = ~np.isnan(column)
        if there.sum() > 1:
            slope = (
                np.gradient(column[there], time[there])
                if there.sum() > 2
                else np.diff(column[there]) / np.diff(time[there])
            )
            changes[j] = np.mean((slope * shift[there]) ** 2)
    return changes


def _square(unit):
    return f" {unit}²" if unit.isalpha() else f" ({unit})²" if unit else ""
