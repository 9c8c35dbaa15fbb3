"""From the text of a table to time stamps and numbers; faults are collected line by line, each as a sentence.

A fault is a pair (number of the line, sentence). The functions add to a list of faults and go on where they can.
"""

import csv
import io
import math
import re
import statistics
from datetime import datetime, timedelta
from itertools import pairwise

SECONDS = {"ns": 1e-9, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ms": 1e-3, "s": 1, "sec": 1, "seconds": 1}
SECONDS |= {"min": 60, "minutes": 60, "h": 3600, "hours": 3600, "d": 86400, "days": 86400}
GAPS = {"", "nan", "na", "n/a", "null", "none"}
NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
THOUSANDS = re.compile(r"[+-]?\d{1,3}([., '’\u00a0\u202f]\d{3})+([.,]\d*)?", re.ASCII)
NAME_AND_UNIT = re.compile(r"(.*?)\s*(?:\[([^][]*)\]|\(([^()]*)\))")
FAULTS_SHOWN = 5


class RecordingError(ValueError):
    """What is wrong with a recording: one sentence for each fault, the first five of them in the message.

    Attributes
    ----------
    faults : tuple of str
        All the sentences.
    lines : tuple of int or None
        For each the number of its line in the file, counted from 1.

    Examples
    --------
    >>> from kflearn import recordings
    >>> try:
    ...     recordings.parse("t [s],height [m]\\n0,1.5\\n1,high\\n2,1.7")
    ... except recordings.RecordingError as error:
    ...     print(error)
    line 3: column 'height': 'high' is no number
    """

    def __init__(self, *faults):
        self.lines = tuple(line for line, _ in faults)
        self.faults = tuple(f"line {line}: {text}" if line else text for line, text in faults)
        more = [f"… and {len(faults) - FAULTS_SHOWN} more"] if len(faults) > FAULTS_SHOWN else []
        super().__init__("\n".join([*self.faults[:FAULTS_SHOWN], *more]))


def short(thing, width=24) -> str:
    """How to quote something in a sentence."""
    quoted = repr(thing) if isinstance(thing, str) else f"{type(thing).__name__} {thing!r}"
    if len(quoted) <= width + 2:
        return quoted
    return quoted[:width] + ("…'" if isinstance(thing, str) else "")


# ---- rows and columns


def rows_of(text, faults) -> tuple[list, str]:
    """(line number, fields) of all that is neither empty nor a comment, and the separator of the fields."""
    lines = enumerate(io.StringIO(text.removeprefix("\ufeff"), newline=None).read().split("\n"), 1)
    lines = [(n, line) for n, line in lines if line.strip(" ;,\t") and not line.lstrip().startswith("#")]
    if not lines:
        raise RecordingError((None, "there is nothing in it, or nothing but empty lines and comments"))
    top, header = lines[0]
    separator = next((mark for mark in "\t;," if mark in header), None)
    if separator is None:
        raise RecordingError((top, f"no comma, semicolon or tab separates columns here: {short(header)}"))
    rows = [(n, _fields(n, line, separator, faults)) for n, line in lines]
    if faults and faults[0][0] == top:
        raise RecordingError(faults[0])
    return rows, separator


def _fields(n, line, separator, faults):
    try:
        fields = next(csv.reader([line.strip(" ")], delimiter=separator, strict=True, skipinitialspace=True))
    except csv.Error:
        faults.append((n, "its quotation marks do not match, or a field is far too long"))
        return []
    return [field.strip() for field in fields]


def is_whole(n, fields, wanted, separator, faults) -> bool:
    """Has a row as many fields as the header? Empty ones at the end do not count."""
    surplus = any(fields[wanted:])
    if fields and (surplus or len(fields) < wanted):
        commas = separator == "," and surplus
        hint = " (decimals with a comma need semicolons between the columns)" if commas else ""
        faults.append((n, f"found {len(fields)} fields, but the header names {wanted} columns{hint}"))
    return len(fields) >= wanted and not surplus


def header_of(top, fields) -> tuple[int, tuple, tuple]:
    """Line number, names and units of the columns."""
    while fields and not fields[-1]:
        fields.pop()
    if all(field.lower() in GAPS or NUMBER.fullmatch(field) or date(field) for field in fields):
        hint = "here stand readings already (what follows a # is a comment)"
        raise RecordingError((top, f"the names of the columns are missing: {hint}"))
    names, units = zip(*map(named, fields), strict=True)
    for j, name in enumerate(names):
        if not name:
            raise RecordingError((top, f"column {j + 1} has no name"))
        if name in names[:j]:
            raise RecordingError((top, f"two columns have the name {short(name)}"))
    return top, names, units


def named(field) -> tuple[str, str]:
    """Name and unit: "height [m]" → ("height", "m")."""
    found = NAME_AND_UNIT.fullmatch(field)
    return (found[1], (found[2] or found[3] or "").strip()) if found else (field, "")


def find(name, names, top=None) -> int:
    """The number of a column; its unit may follow its name."""
    for wanted in (name, named(name)[0]) if isinstance(name, str) else ():
        if wanted in names:
            return names.index(wanted)
    raise RecordingError((top, f"there is no column {short(name)}; the columns are {short(', '.join(names), 60)}"))


def columns_of(columns, names, clock, top) -> list[int]:
    """The numbers of the columns to read."""
    columns = [columns] if isinstance(columns, str) else columns
    if columns is None:
        chosen = [j for j in range(len(names)) if j != clock]
    elif isinstance(columns, (list, tuple)):
        chosen = [find(name, names, top) for name in columns]
    else:
        raise RecordingError((None, f"columns must be a list of names, got {short(columns)}"))
    if not chosen or clock in chosen or len(set(chosen)) < len(chosen):
        raise RecordingError((top, "there must be a column or more beside that of the time stamps, each named once"))
    return chosen


def without_words(chosen, rows, names, top, faults) -> list[int]:
    """The columns that are no words; a column in which no field holds a digit is one fault, not one a row."""
    words = []
    for j in chosen:
        written = [fields[j] for _, fields in rows if fields[j].lower() not in GAPS]
        if written and not any(mark.isdigit() for field in written for mark in field):
            words.append(j)
    others = short(", ".join(names[j] for j in chosen if j not in words), 40)
    for j in words:
        such = f"holds words, such as {short(written_in(j, rows))}"
        faults.append((top, f"column {short(names[j])} {such}: name the others in columns=[…], {others}"))
    return [j for j in chosen if j not in words]


def written_in(j, rows) -> str:
    """The first field of a column that is no gap."""
    return next(fields[j] for _, fields in rows if fields[j].lower() not in GAPS)


# ---- time stamps and numbers


def times_of(rows, clock, name, unit, top, number, faults) -> tuple[list[float], datetime | float | None]:
    """Seconds since the first time stamp, a list, and that stamp."""
    numeric = 2 * sum(bool(NUMBER.fullmatch(fields[clock])) for _, fields in rows) >= len(rows)
    scale = SECONDS.get(str(unit).lower()) if numeric else 1
    if scale is None:
        reason = f"{short(unit)} is not one of ns, us, ms, s, min, h, d" if str(unit) else "write [s] or [ms] behind it"
        raise RecordingError((top, f"column {short(name)} needs the unit of its time stamps: {reason}"))
    seconds, stamps, places, first, before = [], [], [], None, None
    for n, fields in rows:
        text = fields[clock]
        try:
            stamp = number(text) if numeric else _dated(text)
            now = _apart(stamp, stamp if first is None else first, scale)
            if before and now <= seconds[-1]:
                order = "repeats" if now == seconds[-1] else "lies before"
                raise ValueError(f"{order} that of line {before}{f': {CLOCKS}' if _put_back(stamp) else ''}")
        except ValueError as error:
            faults.append((n, f"the time stamp {short(text, 32)} {error}" if text else "the time stamp is missing"))
            continue
        seconds.append(now)
        stamps.append(stamp)
        first, before = stamp if first is None else first, n
        places.append(n)
    faults += [
        (places[k], f"the time stamp {stamps[k]} comes an hour late: {CLOCKS}") for k in put_forward(stamps, seconds)
    ]
    return seconds, first


CLOCKS = "did the clocks change here? write stamps with a zone"


def put_forward(stamps, seconds) -> list[int]:
    """The rows before which local clocks seem to have been put forward: stamps that leave out the hour from 1, 2 or 3.

    On the last Sunday of March (Europe) or its second (North America), where a step is an hour longer than the median
    step. Stamps with a zone say themselves what the clocks did.
    """
    if len(stamps) < 3 or not isinstance(stamps[0], datetime) or stamps[0].tzinfo:
        return []
    steps = [b - a for a, b in pairwise(seconds)]
    usual = statistics.median(steps)
    near = min(2.5 * usual, 1800)
    late = [k + 1 for k, dt in enumerate(steps) if dt > 3600 and abs(dt - 3600 - usual) <= near]
    return [k for k in late if _night_in_march(stamps[k]) and _leaves_out_an_hour(stamps[k - 1], stamps[k])]


def _night_in_march(stamp):
    return stamp.month == 3 and stamp.weekday() == 6 and (stamp.day >= 25 or 8 <= stamp.day <= 14)


def _leaves_out_an_hour(before, after):
    hours = [after.replace(hour=hour, minute=0, second=0, microsecond=0) for hour in (1, 2, 3)]
    return any(before < hour and after >= hour + timedelta(hours=1) for hour in hours)


def _put_back(stamp):
    """Is that a Sunday on which local clocks are put back, the last of October or the first of November?"""
    if not isinstance(stamp, datetime) or stamp.tzinfo or stamp.weekday() != 6:
        return False
    return (stamp.month == 10 and stamp.day >= 25) or (stamp.month == 11 and stamp.day <= 7)


def _dated(text):
    stamp = date(text)
    if stamp is None:
        raise ValueError("is no date as in ISO 8601, like 2026-05-31 14:05:09")
    return stamp


def _apart(stamp, first, scale):
    """Seconds from the first time stamp."""
    try:
        seconds = (stamp - first).total_seconds() if isinstance(stamp, datetime) else (stamp - first) * scale
    except TypeError:
        raise ValueError("has a time zone where the first has none, or the other way round") from None
    if not math.isfinite(seconds):
        raise ValueError("is too far from the first")
    return seconds


def date(text) -> datetime | None:
    """A datetime, or None."""
    try:
        return datetime.fromisoformat(text)
    except ValueError:
        return None


class Numbers:
    """From text to number; keeps to one way of writing decimals within a file."""

    def __init__(self, separator):
        self.separator, self.mark = separator, None

    def __call__(self, text) -> float:
        text = text.replace("−", "-")
        if not NUMBER.fullmatch(text):
            raise ValueError("has separators of thousands" if THOUSANDS.fullmatch(text) else "is no number")
        mark = next((mark for mark in ".," if mark in text), None)
        if mark == "," == self.separator:
            raise ValueError("has a comma, but commas separate the columns")
        if mark and mark != (self.mark or mark):
            raise ValueError(f"has a {mark!r} where others have {self.mark!r}: is it a separator of thousands?")
        value = float(text.replace(",", "."))
        if math.isinf(value):
            raise ValueError("is too large")
        self.mark = self.mark or mark
        return value

    def reading(self, n, name, text, faults) -> float:
        """One reading; NaN for a gap or a fault."""
        if text.lower() in GAPS:
            return math.nan
        try:
            return self(text)
        except ValueError as error:
            faults.append((n, f"column {short(name)}: {short(text)} {error}"))
            return math.nan
