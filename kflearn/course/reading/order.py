"""Time stamps increase: what is done, and said, where they repeat, run back, or change with the clocks."""

import re
from datetime import timedelta

import numpy as np

from .faults import short
from .table import is_gap

CLOCKS = "did the clocks change here? write stamps with a zone, or say zone='Europe/Berlin'"
SIZES = [2.0**n for n in (8, 16, 24, 31, 32)] + [2.0**32 / 1000, 604_800, 86_400, 604_800_000, 86_400_000, 3600, 60]
SIZES += [10.0**n for n in range(2, 11)]
MANY = 20  # faults with words of their own


def ordered(table, clock, options):
    """The table and its clock in order: newest first turned round, sorted if asked, a counter unwrapped if asked."""
    seconds, good = clock.seconds, ~np.isnan(clock.seconds)
    if options.wraps is not None and not clock.dated:
        steps = np.diff(seconds)
        times = np.cumsum(steps < 0, dtype=float)  # not whole numbers: in a browser these have 32 bits
        seconds = seconds + np.concatenate([[0], times]) * options.wraps * clock.tick
        clock.notes.append(f"the counter began again {int((steps < 0).sum())} times, after {options.wraps:.15g}")
        clock.seconds = seconds
    if clock.dated and len(seconds) > 2 and seconds[1] < seconds[0] and (np.diff(seconds) < 0).all():
        clock.notes.append("the newest row came first: turned round")
        return turned(table, clock, np.arange(len(seconds))[::-1])
    if options.sort and good.all() and (np.diff(seconds) < 0).any():
        clock.notes.append("rows sorted by time")
        return turned(table, clock, np.argsort(seconds, kind="stable"))
    return table, clock


def turned(table, clock, order):
    """Rows in another order; seconds count from the first of them."""
    seconds, texts = clock.seconds[order], clock.texts
    where = [int(k) for k in order]
    if clock.stamps is not None:
        stamps = clock.stamps
        clock.stamps = stamps[order] if isinstance(stamps, np.ndarray) else stamps.iloc[order].reset_index(drop=True)
        first = clock.stamps[0]
        clock.start = first.item() if hasattr(first, "item") else first
    elif clock.dated:
        clock.start = clock.start + np.timedelta64(round(float(seconds[0])), "s")
    clock.seconds, clock.texts = seconds - seconds[0], lambda k: texts(where[k])
    return table.take(order), clock


def equal_rows(table, clock, options, values):
    """Times, values and lines with equal stamps kept, merged, or only the first of them."""
    seconds, lines = clock.seconds, table.lines
    if options.equal in ("refuse", "keep") or not (np.diff(seconds) == 0).any():
        return seconds, values, lines
    new = np.concatenate([[True], np.diff(seconds) > 0])
    clock.notes.append(f"{int((~new).sum())} rows had the stamp of the row before: equal={options.equal!r}")
    if options.equal == "merge":
        group, size = np.cumsum(new) - 1, int(new.sum())
        there = ~np.isnan(values)
        total, count = np.zeros((size, values.shape[1])), np.zeros((size, values.shape[1]))
        np.add.at(total, group, np.where(there, values, 0))
        np.add.at(count, group, there)
        with np.errstate(invalid="ignore"):
            values = np.concatenate([total / count, values[:0]])
    else:
        values = values[new]
    return seconds[new], values, lines[new]


def faults_of(table, clock, options):
    """(line, sentence) for each stamp that is missing, repeats, lies before the one before, or leaves out an hour."""
    faults, lines = [], table.lines
    for k, why in clock.bad.items():
        text = clock.texts(k)
        missing = not text or (is_gap(text) and not why)
        said = "the time stamp is missing" if missing else f"the time stamp {short(text, 32)} {why}"
        faults.append((int(lines[k]), said))
    if not _increases(clock.seconds):
        good = np.flatnonzero(~np.isnan(clock.seconds))
        faults += _late(table, clock, options, good) if len(good) > 1 else []
    stamps = clock.stamps
    if clock.dated and stamps is not None and stamps.dt.tz is None and not np.isnan(clock.seconds).any():
        for k in put_forward(stamps, clock.seconds):
            faults.append((int(lines[k]), f"the time stamp {stamps[k]} comes an hour late: {CLOCKS}"))
    return faults


def _increases(seconds):
    """Is each stamp there, and later than the one before?"""
    return bool((seconds[1:] > seconds[:-1]).all())


def _late(table, clock, options, good):
    """The stamps that are not later than the newest before them."""
    faults: list = []
    lines, seconds = table.lines[good], clock.seconds[good]
    newest = np.maximum.accumulate(seconds)
    late = np.flatnonzero(seconds[1:] <= newest[:-1]) + 1
    if options.equal != "refuse":
        late = late[seconds[late] < newest[late - 1]]
    for k in late.tolist():
        same = seconds[k] == newest[k - 1]
        before = lines[np.flatnonzero(seconds[:k] == seconds[k])[-1] if same else np.argmax(seconds[:k])]
        help_ = _help(table, clock, options, good, k, same) if not faults else ""
        text = short(clock.texts(int(good[k])), 32)
        order = "repeats" if same else "lies before"
        faults.append((int(lines[k]), f"the time stamp {text} {order} that of line {before}{help_}"))
        if len(faults) == MANY:  # the rest is counted, not written
            faults += [(int(n), "the time stamp is not later than those before") for n in lines[late[MANY:]]]
            break
    return faults


def _help(table, clock, options, good, k, same):
    """The option that helps where a stamp is not later than the one before."""
    if clock.dated and options.zone is None and _put_back(clock.stamps, good[k]):
        return f": {CLOCKS}"
    if not same:
        size = None if clock.dated else _size(clock, good, k)
        if size:
            return f": does the counter run over? wraps={size:.15g}"
        return ": sort=True puts rows in order"
    other = _column_of_clocks(table, clock)
    if other:
        return f": date and clock in two columns? time=({clock.name!r}, {other!r})"
    split = _column_of_objects(table, clock)
    if split:
        return split
    return ": equal='keep' or 'merge'"


def _size(clock, good, k):
    """Where the counter begins again, if that makes the step like the others."""
    stamps = clock.stamps
    if not isinstance(stamps, np.ndarray):
        return None
    stamps = stamps[good].astype(float)
    usual = np.median(np.diff(stamps)[np.diff(stamps) > 0]) if (np.diff(stamps) > 0).any() else 0
    for size in SIZES:
        step = stamps[k] + size - stamps[k - 1]
        if stamps[k - 1] < size and 0 < step <= 3.5 * usual:
            return size
    return None


def _column_of_clocks(table, clock):
    """A column of clocks beside one of dates."""
    stamps = clock.stamps
    if not clock.dated or stamps is None or (stamps != stamps.dt.normalize()).any():
        return None
    for j, name in enumerate(table.names):
        if name != clock.name and not table.is_numeric(j):
            texts = table.columns[j].head(20).tolist()
            if all(re.match(r"\d{1,2}:\d\d", str(text).strip()) for text in texts):
                return name
    return None


def _column_of_objects(table, clock):
    """A column that tells apart rows of one stamp: several objects, or one reading a row."""
    import pandas as pd

    if (np.diff(np.sort(clock.seconds)) == 0).mean() < 0.2:
        return None
    for j, name in enumerate(table.names):
        if name == clock.name or table.columns[j].dtype.kind in "f":
            continue
        column = pd.Series(table.text(j))
        kinds = column.nunique()
        if not 2 <= kinds <= min(500, len(column) / 2) or column.str.contains(r"^\d*[.,]\d*$").any():
            continue
        if not pd.DataFrame({"t": clock.seconds, "x": column}).duplicated().any():
            first = int(column[0]) if column[0].isdecimal() and column[0][0] != "0" else column[0]
            others = [n for n in table.names if n not in (name, clock.name)]
            if len(others) == 1 and not column[0][:1].isdigit():
                return f": one reading a row? pivot=({name!r}, {others[0]!r})"
            return f": several objects? where={{{name!r}: {first!r}}}"
    return None


# ---- local time


def put_forward(stamps, seconds) -> list[int]:
    """The rows before which local clocks seem to have been put forward: stamps that leave out the hour from 1, 2 or 3.

    On the last Sunday of March (Europe) or its second (North America), where a step is an hour longer than the median
    step. Stamps with a zone say themselves what the clocks did.
    """
    if len(stamps) < 3:
        return []
    steps = np.diff(seconds)
    if steps.max() <= 3600:
        return []
    usual = float(np.median(steps))
    near = min(2.5 * usual, 1800)
    late = np.flatnonzero((steps > 3600) & (abs(steps - 3600 - usual) <= near)) + 1
    nights = [int(k) for k in late if _night_in_march(stamps[k])]
    return [
        k
        for k in nights
        if _leaves_out_an_hour(stamps[k - 1].to_pydatetime(warn=False), stamps[k].to_pydatetime(warn=False))
    ]


def _night_in_march(stamp):
    return stamp.month == 3 and stamp.weekday() == 6 and (stamp.day >= 25 or 8 <= stamp.day <= 14)


def _leaves_out_an_hour(before, after):
    hours = [after.replace(hour=hour, minute=0, second=0, microsecond=0) for hour in (1, 2, 3)]
    return any(before < hour and after >= hour + timedelta(hours=1) for hour in hours)


def _put_back(stamps, k):
    """Is that a Sunday on which local clocks are put back, the last of October or the first of November?"""
    if stamps is None or getattr(stamps.dt, "tz", None) is not None or stamps[k].weekday() != 6:
        return False
    month, day = stamps[k].month, stamps[k].day
    return (month == 10 and day >= 25) or (month == 11 and day <= 7)
