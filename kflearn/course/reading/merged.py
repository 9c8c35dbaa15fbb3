"""Several recordings of one clock on one axis of time."""

from datetime import datetime

import numpy as np

from .faults import RecordingError, short
from .recording import Recording


def merge(*recordings) -> Recording:
    """Several recordings of one clock as one: all their columns, NaN where a row has no reading of it.

    Time counts from the earliest of them. Rows with equal stamps become one row.

    Parameters
    ----------
    *recordings : Recording
        As from `read`: with stamps that are dates with a zone in all, dates without in all, or numbers in all.

    Raises
    ------
    RecordingError
        Where the clocks cannot be compared.

    Examples
    --------
    >>> from kflearn import recordings
    >>> gps = recordings.parse("t [ms],east [m]\\n15300,1\\n16300,2")
    >>> imu = recordings.parse("t [s],acc [m/s^2]\\n0,0.1\\n15.3,0.2")
    >>> both = recordings.merge(gps, imu)
    >>> print(both.time, both.names)
    [ 0.  15.3 16.3] ('east', 'acc')
    """
    for each in recordings:
        if not isinstance(each, Recording):
            raise RecordingError((None, f"merge takes recordings, got {short(each)}"))
    if not recordings:
        raise RecordingError((None, "merge needs a recording or more"))
    kinds = {_kind(each.start) for each in recordings}
    if len(kinds) > 1:
        raise RecordingError((None, f"these clocks cannot be compared: {' and '.join(sorted(kinds))}"))
    first = min(recordings, key=lambda each: _offset(each, recordings[0]))
    times = [np.round(each.time + _offset(each, first), 9) for each in recordings]
    time, place = np.unique(np.concatenate(times), return_inverse=True)
    values = np.full((len(time), sum(len(each.names) for each in recordings)), np.nan)
    lines, row, column = np.zeros(len(time), int), 0, 0
    for each in recordings:
        here = place[row : row + len(each)]
        if len(set(here.tolist())) < len(here):
            raise RecordingError((None, "a recording with equal stamps cannot be merged: read it with equal='merge'"))
        values[here, column : column + len(each.names)] = each.values
        lines[here] = each.lines
        row, column = row + len(each), column + len(each.names)
    names, notes = _names(recordings), tuple(dict.fromkeys(note for each in recordings for note in each.notes))
    units = tuple(unit for each in recordings for unit in each.units)
    return Recording(time, values, names, units, lines, first.start, first.tick, notes)


def _kind(start):
    if not isinstance(start, datetime):
        return "numbers"
    return "dates with a zone" if start.tzinfo else "dates without a zone"


def _offset(one, other):
    """Seconds by which one begins later; whole numbers are subtracted as such."""
    if isinstance(one.start, datetime):
        return (one.start - other.start).total_seconds()
    if one.tick == other.tick:
        return (one.start - other.start) * one.tick
    return one.start * one.tick - other.start * other.tick


def _names(recordings):
    """All names; of equal ones the second has a 2 behind it."""
    names: list = []
    for each in recordings:
        for name in each.names:
            n = 2
            fresh = name
            while fresh in names:
                fresh, n = f"{name} {n}", n + 1
            names.append(fresh)
    return tuple(names)
