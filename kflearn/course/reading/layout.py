"""Where the table begins in a text: separator, names, units, the first row; found by itself where that is plain."""

import csv
import re
from dataclasses import dataclass

from .faults import RecordingError, short
from .table import NUMBER, is_gap

LOOKED_AT = 120  # lines
KINDS = re.compile(r"min|max|avg|std|smp|tot|wvc|sd|mean|med", re.IGNORECASE)
UNIT_WORDS = (
    r"[\[(].*[\])]",  # in brackets
    r"-|ts|rn|utc|iso|none|count|string|float|int|[°º%].*",
    r"(n|u|µ|μ|m|k|c|h|d)?(s|m|g|v|a|w|pa|hz|l|n|rad|bar|j)",  # ms, km, hPa
    r"volts?|amps?|watts?|kn|knots?|mph|in|ft|inch|min|h|hr|d|ppm|ppb|dbm?|mbar|inhg",
    r"(deg|degree)s?( ?[cfk])?|(sec|second|minute|hour|day|meter|metre)s?",
    r"[a-z²³µ]{1,5}(/|\*|·|\^)[-a-z0-9²³^/·*]{1,8}",  # m/s^2
    r"[a-z]+[/-][a-z]+([/-][a-z]+)?( [a-z:]+)?",  # yyyy-mm-dd hh:mm
)
UNITS = re.compile("|".join(UNIT_WORDS), re.IGNORECASE)
DATE = re.compile(
    r"\d{1,4}[-/.]\d{1,2}([-/.]\d{1,4})?\D|\d{4}-\d{2}(-\d{2})?$|\d{1,2}[-/.]\d{1,2}[-/.]\d{2,4}|\d{1,2}:\d\d"
    r"|\d{4}-?W\d\d|\d{8}T\d"
)
JSON = "this is JSON, not a table: pandas.read_json or json.loads, then read(DataFrame or dict of lists)"
NO_TABLES = (
    ("<gpx", "this is GPX: save it with the ending .gpx, then read takes it"),
    ("<", "this is XML or HTML, not a table: pandas.read_xml, then read(the DataFrame)"),
    ("{", JSON),
    ("[{", JSON),
    ("[[", JSON),
    ("$G", "this is NMEA: save it with the ending .nmea, then read takes it"),
    ("!AIVDM", "these are AIS sentences, no table: the package pyais decodes them, then read(a dict of lists)"),
)


@dataclass(frozen=True)
class Layout:
    """Separator, line and fields of the header, fields of a row of units, line of the first row."""

    separator: str
    top: int | None
    titles: tuple
    units: tuple
    first: int


def layout_of(lines, options) -> Layout:
    """From the first lines that hold something, (number, text) each."""
    _not_a_table(lines)
    separator = options.separator or _separator_of(lines)
    rows = [(n, fields_of(line, separator), line) for n, line in lines if not is_comment(line) or n == options.header]
    if options.header is False:
        width = max(len(_cut(fields)) for _, fields, _ in rows)
        return Layout(separator, None, tuple(f"column {j + 1}" for j in range(width)), (), rows[0][0])
    k = _header_among(rows, options)
    top, fields, line = rows[k]
    if fields is None:
        raise RecordingError((top, "its quotation marks do not match, or a field is far too long"))
    if is_comment(line):
        fields = fields_of(line.lstrip("# "), separator)
    fields = _cut(fields)
    if all(is_gap(field) or _is_value(field) for field in fields):
        hint = "here stand readings already (what follows a # is a comment); header=False names them column 1, 2, …"
        raise RecordingError((top, f"the names of the columns are missing: {hint}"))
    units, after = (), k + 1
    while after < len(rows) and _of_units(rows[after][1], len(fields)):
        units, after = units or tuple(re.sub(r"^[\[(](.*)[\])]$", r"\1", u) for u in rows[after][1]), after + 1
    first = rows[after][0] if after < len(rows) else rows[-1][0] + 1
    return Layout(separator, top, tuple(fields), units, first)


def _not_a_table(lines):
    top, text = next(((n, line.strip()) for n, line in lines), (None, ""))
    for sign, sentence in NO_TABLES:
        if text.startswith(sign) and not (sign == "<" and text.startswith("<-")):
            raise RecordingError((top, sentence))


def _separator_of(lines):
    """The mark that separates the header; below a preamble, the one that makes the most lines alike."""
    top, header = next(((n, line) for n, line in lines if not is_comment(line)), lines[0])
    inside = [line for n, line in lines if not is_comment(line)]
    best = {}
    for mark in "\t;,":
        counts = [len(_cut(fields_of(line, mark) or [])) for line in inside]
        wide = [c for c in counts if c > 1]
        best[mark] = max(map(wide.count, wide), default=0)
    mark = next((mark for mark in "\t;," if mark in header), None)
    if max(best.values()) > 2 * best.get(mark, 0):
        mark = max(best, key=best.get)  # of equals the first
    if mark is None or (mark not in header and best[mark] < 2):
        spaces = "; separator=' ' reads columns with spaces between" if " " in header.strip() else ""
        raise RecordingError((top, f"no comma, semicolon or tab separates columns here: {short(header)}{spaces}"))
    return mark


def _header_among(rows, options):
    """Which row has the names: the one told, the one with the asked name, or the last words before the readings."""
    if options.header:
        found = [k for k, (n, _, _) in enumerate(rows) if n == options.header]
        if not found:
            raise RecordingError((None, f"header={options.header}: there is nothing in this line"))
        return found[0]
    asked = {name for name in options.clocks if isinstance(name, str) and name.strip()}
    if asked:
        for k, (_, fields, _) in enumerate(rows):
            if fields and asked <= {*fields, *(re.sub(r"\s*[\[(].*", "", field) for field in fields)}:
                return k
    widths = [len(fields or []) for _, fields, _ in rows]
    width = max(widths, key=widths.count)
    data = next((k for k, (_, fields, _) in enumerate(rows) if fields and len(fields) == width and _is_row(fields)), 0)
    if data == 0 or (_plain_title(rows[0][2]) and widths[0] >= width):
        return 0
    names = [k for k in range(data) if rows[k][1] and not _is_row(rows[k][1])]
    while len(names) > 1 and _of_units(rows[names[-1]][1], width):
        names.pop()
    return names[-1] if names else 0


def _plain_title(line):
    return re.search(r"\w ?[\[(][^][()]+[\])]", line) is not None


def _is_row(fields):
    return any(_is_value(field) for field in fields) and not all(map(is_gap, fields))


def _is_value(field):
    return bool(NUMBER.fullmatch(field) or DATE.match(field))


def _of_units(fields, width):
    """Is that a row of units, or one that says Min, Avg, Max?"""
    if not fields or len(_cut(fields)) > width or not any(fields) or len(fields) < 2:
        return False
    words = [field for field in fields if field]
    return all(UNITS.fullmatch(word) or KINDS.fullmatch(word) for word in words)


def is_comment(line) -> bool:
    """A line that begins with #."""
    return line.lstrip().startswith("#")


def fields_of(line, separator):
    """The fields of one line, stripped; None where its quotation marks do not match."""
    line = line.strip(" ")
    if separator == " ":
        return line.split()
    try:
        fields = next(csv.reader([line], delimiter=separator, strict=True, skipinitialspace=True), [])
    except csv.Error:
        return None
    return [field.strip() for field in fields]


def _cut(fields):
    """Without the empty fields at the end."""
    fields = list(fields)
    while fields and not fields[-1]:
        fields.pop()
    return fields
