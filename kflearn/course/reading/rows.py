"""From a text to a table: by pandas where the text is plain, else line by line, with a sentence for each odd line."""

import io
import warnings

import numpy as np

from .faults import RecordingError
from .layout import LOOKED_AT, fields_of, is_comment, layout_of
from .table import GAPS, Table

BLANK = " ;,\t|"
GAP_WORDS = sorted(GAPS - {""} | {word.upper() for word in GAPS} | {"NaN", "NaT", "None", "Null", "Na"})


def quick_table(text, options, path=None):
    """A table whose texts may have lost their exact form, or None where the text is not plain enough for pandas.

    Parameters
    ----------
    text : str
    options : Options
    path : Path, optional
        Of a file in UTF-8 that holds this text: read from there, pandas is faster.
    """
    import pandas as pd

    if any(mark in text for mark in '"#\0') or text.count("\r") != text.count("\r\n") or options.separator == " ":
        return None
    layout = layout_of(_first_lines(text), options)
    width, rows = len(layout.titles), text.count("\n") + (not text.endswith("\n")) - layout.first + 1
    clocks = set() if options.time_format is None and len(options.clocks) < 2 else set(options.clocks)
    kept = {j: str for j, title in enumerate(layout.titles) if clocks & {title, title.split(" [")[0].split(" (")[0]}}
    settings = dict(sep=layout.separator, header=None, names=range(width), skiprows=layout.first - 1, dtype=kept)
    settings |= dict(index_col=False, na_values=GAP_WORDS, keep_default_na=False)
    settings |= dict(decimal=_decimal(text, layout, options), encoding="utf-8-sig")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            frame = pd.read_csv(path or io.BytesIO(text.encode()), na_filter=True, **settings)
    except Exception:  # whatever it is, reading line by line says it better
        return None
    whole = text.count(layout.separator) - _before(text, layout) == rows * (width - 1)
    columns = [frame[j] for j in range(width)]
    if not whole or len(frame) != rows or any(c.dtype.kind == "f" and np.isinf(c).any() for c in columns):
        return None
    lines = np.arange(layout.first, layout.first + rows)
    return Table(columns, layout.titles, lines, layout.top, layout.separator, exact=False, units_row=layout.units)


def _first_lines(text):
    """The first lines that hold something, with their numbers."""
    start = io.StringIO(text[: 2000 * LOOKED_AT].removeprefix("\ufeff"), newline=None)
    return _filled(start.read().split("\n")[:LOOKED_AT])


def _filled(lines):
    lines = [(n, line) for n, line in enumerate(lines, 1) if line.strip(BLANK)]
    if all(is_comment(line) for _, line in lines):
        raise RecordingError((None, "there is nothing in it, or nothing but empty lines and comments"))
    return lines


def _before(text, layout):
    """How often the separator stands above the first row."""
    at = 0
    for _ in range(layout.first - 1):
        at = text.index("\n", at) + 1 if "\n" in text[at:] else len(text)
    return text.count(layout.separator, 0, at)


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
