"""From a text to a table: by pandas where the text is plain, else line by line, with a sentence for each odd line."""

import io
import re
import warnings

import numpy as np

from .faults import RecordingError
from .layout import LOOKED_AT, fields_of, is_comment, layout_of
from .table import GAPS, Table, named

ISO = re.compile(r"\d{4}-\d\d-\d\d([T ]\d\d:\d\d.*)?$")
DAYS = ((b"o", b"now"), (b"o", b"oday"), (b"O", b"NOW"), (b"O", b"ODAY"))  # pandas takes them for dates
BLANK = " ;,\t|"
GAP_WORDS = sorted(GAPS - {""} | {word.upper() for word in GAPS} | {"NaN", "NaT", "None", "Null", "Na"})


def quick_table(raw, options, path=None):
    """A table whose texts may have lost their exact form, or None where the text is not plain enough for pandas.

    Parameters
    ----------
    raw : bytes
        A text in UTF-8. Only its head is decoded here.
    options : Options
    path : Path, optional
        Of the file that holds it: read from there, pandas is faster.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            return _by_pandas(raw, options, path)
    except Exception:  # whatever it is, reading line by line says it better
        return None


def _by_pandas(raw, options, path):
    import pandas as pd

    odd = any(mark in raw for mark in (b'"', b"\0")) or (b"\r" in raw and raw.count(b"\r") != raw.count(b"\r\n"))
    if odd or options.separator == " ":
        return None
    text = _head(raw)
    layout = layout_of(_first_lines(text), options)
    settings = _settings(text, layout, options)
    if ("parse_dates" in settings and _names_a_day(raw)) or _hides_a_word(raw, text, layout):
        return None
    frame = pd.read_csv(path or io.BytesIO(raw), **settings)
    columns = [frame[j] for j in range(len(layout.titles))]
    if any(c.dtype.kind == "f" and not _finite(c.to_numpy()) for c in columns if c.size):
        return None
    if any(c.dtype.kind not in "iufbM" for c in columns) and b"#" in raw:  # perhaps a comment that pandas took for text
        return None
    if not _are_full(raw, layout, np.flatnonzero(columns[-1].isna())):  # pandas fills short rows up with NaN
        return None
    lines = np.arange(layout.first, layout.first + len(frame))
    return Table(columns, layout.titles, lines, layout.top, layout.separator, exact=False, units_row=layout.units)


def _head(raw):
    """The first lines as text; whole lines, where there are any."""
    end = raw.rfind(b"\n", 0, 2000 * LOOKED_AT) + 1 if len(raw) > 2000 * LOOKED_AT else len(raw)
    return raw[: end or len(raw)].decode("utf-8")


def _names_a_day(raw):
    """Does "now" or "today" stand in it? In a column of dates pandas would take it for one."""
    return any((raw.find(sign, 4000) >= 0 and day in raw) or day in raw[:4000] for sign, day in DAYS)


def _hides_a_word(raw, text, layout):
    """May a word for a gap stand behind the last column? If the first row is too long, pandas drops it silently."""
    fields = fields_of(_first_row(text, layout), layout.separator) or []
    return len(fields) > len(layout.titles) and any(word.encode() in raw for word in GAP_WORDS)


def _first_row(text, layout):
    return next((line for n, line in _first_lines(text) if n >= layout.first), "")


def _finite(numbers):
    """Are all numbers finite but for gaps, and is there one?"""
    return bool(np.isfinite([np.fmin.reduce(numbers), np.fmax.reduce(numbers)]).all())


def _are_full(raw, layout, rows):
    """Has each of these rows, which end with a gap, all its fields?"""
    if not len(rows):
        return True
    ends = np.append(np.flatnonzero(np.frombuffer(raw, np.uint8) == ord("\n")), len(raw))
    lines = rows + layout.first - 1  # counted from 0
    places = zip(np.where(lines > 0, ends[lines - 1], 0).tolist(), ends[lines].tolist(), strict=True)
    return all(raw.count(layout.separator.encode(), a, b) >= len(layout.titles) - 1 for a, b in places)


def _settings(text, layout, options):
    """What pandas is told: nothing that it would have to guess, and the time stamps as dates if they begin as such."""
    width = len(layout.titles)
    settings = dict(sep=layout.separator, header=None, names=range(width), skiprows=layout.first - 1, index_col=False)
    settings["skip_blank_lines"] = False  # an empty line is a row of NaN: it counts
    settings |= dict(na_values=GAP_WORDS, keep_default_na=False)
    if text.startswith("\ufeff"):
        settings["encoding"] = "utf-8-sig"  # only where it is needed: it takes its time
    settings["decimal"] = _decimal(text, layout, options)
    names = [named(title)[0] for title in layout.titles]
    clocks = [k for k in range(width) if {names[k], layout.titles[k]} & set(options.clocks)]
    if options.time_format is not None or len(options.clocks) > 1:
        settings["dtype"] = dict.fromkeys(clocks, str)
    else:
        first = fields_of(_first_row(text, layout), layout.separator) or [""]
        (j,) = clocks if len(clocks) == 1 else (0,)
        if ISO.match(first[j : j + 1][0]):
            settings |= dict(parse_dates=[j], date_format="ISO8601")
    return settings


def _first_lines(text):
    """The first lines that hold something, with their numbers."""
    start = io.StringIO(text[: 2000 * LOOKED_AT].removeprefix("\ufeff"), newline=None)
    return _filled(start.read().split("\n")[:LOOKED_AT])


def _filled(lines):
    lines = [(n, line) for n, line in enumerate(lines, 1) if line.strip(BLANK)]
    if all(is_comment(line) for _, line in lines):
        raise RecordingError((None, "there is nothing in it, or nothing but empty lines and comments"))
    return lines


def _decimal(text, layout, options):
    """The mark of decimals in the first rows."""
    if options.decimal:
        return options.decimal
    marks = "".join(c for _, line in _first_lines(text)[-30:] for c in line if c in ",.")
    return "," if layout.separator != "," and marks.count(",") > marks.count(".") else "."


def exact_table(text, options, faults) -> Table:
    """A table of texts as they are written; the odd lines are left out and told in faults."""
    import pandas as pd

    text = io.StringIO(text.removeprefix("\ufeff"), newline=None).read()
    lines = _filled(text.split("\n"))
    layout = layout_of(lines[:LOOKED_AT], options)
    width, rows, numbers = len(layout.titles), [], []
    for n, line in lines:
        if n >= layout.first and not is_comment(line):
            fields = fields_of(line, layout.separator)
            if _is_whole(n, fields, width, layout, faults):
                rows.append(fields[:width])
                numbers.append(n)
    columns = [pd.Series([row[j] for row in rows], dtype=object) for j in range(width)]
    lines = np.array(numbers, dtype=int)
    return Table(columns, layout.titles, lines, layout.top, layout.separator, units_row=layout.units)


def _is_whole(n, fields, width, layout, faults):
    """Has a row as many fields as the header? Empty ones at the end do not count."""
    if fields is None:
        faults.append((n, "its quotation marks do not match, or a field is far too long"))
        return False
    surplus = any(fields[width:])
    if surplus or len(fields) < width:
        commas = layout.separator == "," and surplus
        hint = (
            "(decimals with a comma need semicolons between the columns)"
            if commas
            else "(if it was cut off, delete it)"
        )
        faults.append((n, f"found {len(fields)} fields, but the header names {width} columns {hint}"))
        return False
    if tuple(fields[:width]) == layout.titles:
        faults.append((n, "the header stands here once more: keep one recording a file, then read([file, file])"))
        return False
    return True
