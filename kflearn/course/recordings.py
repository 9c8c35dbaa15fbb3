"""Your own data: a table of readings with time stamps, for a filter.

`read` takes the name of a file, a DataFrame (of pandas, Polars, Arrow, …) or a dict of arrays. In a text the line with
the names of the columns is found by itself where that is plain, with units in brackets, `height [m]` or `height (m)`,
or in a row of their own; lines that begin with # are left out. Between columns stand semicolons, tabs or commas; with
the first two, decimals may have a comma. Time stamps are numbers with a unit, `t [ms]`, or dates, and they increase. An
empty field, NaN, NA, N/A, null or None is a gap. Only the columns that are read are judged: those asked for, or all
that hold numbers. Nothing is guessed that could change a number, and nothing in a file is ever evaluated: whatever else
is found is a RecordingError, which says so with the number of the line, and which option helps.

A clock may count other seconds than yours: GPS time is 18 s ahead of UTC since 2017, TAI 37 s. Two recordings of
different clocks have to be put on one before they are merged; no file tells.

Examples
--------
>>> from kflearn import recordings
>>> lift = recordings.read(recordings.example("lift"))
>>> print(lift.names, f"{lift.steps.median:.2f} s")
('height', 'acceleration') 0.20 s
>>> print(recordings.read({"t [s]": [0, 1, 2], "level [m]": [0.2, -999, 0.4]}, missing=[-999]))
3 rows in 2 s, the first at 0
steps: 1 to 1 s, median 1 s, even
holes: none
level: 0.2 to 0.4 m, gaps: 1, resolution 0.2
"""

from pathlib import Path

from .reading import clock, frames, order, rows, shapes, tracks
from .reading import columns as judge
from .reading.faults import RecordingError, needs, short
from .reading.merged import merge
from .reading.options import Options
from .reading.recording import Recording, Steps

__all__ = ["EXAMPLES", "Recording", "RecordingError", "Steps", "example", "merge", "parse", "read"]

EXAMPLES = ("lift", "cyclist", "thermometer")


def example(name) -> Path:
    """The path of a recording that comes with the course: "lift", "cyclist" or "thermometer".

    Raises RecordingError, with these names, for any other.
    """
    if name not in EXAMPLES:
        raise RecordingError((None, f"there is no example {short(name)}; the examples are {', '.join(EXAMPLES)}"))
    return Path(__file__).with_name("data") / f"{name}.csv"


def read(path, time=None, columns=None, time_unit=None, encoding="utf-8-sig", **options) -> Recording:
    """Read a recording from a file, or from a table in memory.

    Parameters
    ----------
    path : str, Path, DataFrame, dict of arrays, or a list of these
        A table of text; GPX (needs gpxpy) or NMEA (needs pynmea2), told by the ending .gpx, .nmea or by the first
        sign. Several, of one clock, are read with the same settings and merged.
    time : str or pair of str, optional
        The name of the column of time stamps, by default the first column; date and clock in two: ("date", "clock").
    columns : list of str, optional
        The names of the columns to read; by default all others that hold numbers.
    time_unit : str, optional
        "ns", "us", "ms", "s", "min", "h", "d", "week", "month" or "year" (365.2425 days), in place of the header's.
    encoding : str
        Of the text; by default UTF-8, with or without a byte order mark.
    **options
        time_format : str
            As for strptime, "%d.%m.%Y %H:%M"; for clocks without a date "%H%M%S".
        dayfirst : bool
            Is 3.5.2026 in May (True) or in March (False)?
        zone : str
            Of local stamps, "Europe/Berlin".
        missing : list, or dict of lists
            What stands for "no reading": [-999, "--"], or by column {"speed": [102.3]}.
        where : dict
            The rows of one object: {"ship": 211000000}.
        pivot : (str, str)
            For one reading a row: the columns of the sensors' names and of their readings.
        equal : "refuse", "keep", "merge" or "first"
            Rows with equal stamps: kept with a step of 0, merged to the mean of each column, or
            all but the first dropped.
        sort : bool
            Put the rows in the order of time. (Dates whose newest comes first are turned round anyway.)
        wraps : float
            Where a counter begins again, in its own unit, such as 2**32.
        header : int or False
            The line with the names of the columns; False: there is none.
        separator, decimal, thousands : str
            The signs between columns, in decimals, and in thousands; separator=" " for any number of spaces.
        checksum : bool
            Refuse NMEA sentences whose checksum is wrong.

    Raises
    ------
    RecordingError
        And nothing else, when the file cannot be read or something in it is wrong.
    """
    settings = dict(time=time, columns=columns, time_unit=time_unit, **options)
    if isinstance(path, (list, tuple)) and path and not any(isinstance(each, (list, tuple)) for each in path):
        return merge(*(read(each, encoding=encoding, **settings) for each in path))
    told = Options.of(settings)
    needs("pandas", "reading a table")
    if frames.is_frame(path):
        return _recording(frames.table_of(path), told, [])
    try:
        raw = Path(path).read_bytes()
    except (OSError, TypeError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "this is not the name of a file"
        raise RecordingError((None, f"{short(getattr(path, 'name', path))} cannot be read: {reason}")) from None
    tracks.refuse_binary(raw, short(Path(path).name))
    ending = Path(path).suffix.lower()
    if isinstance(encoding, str) and encoding in ("utf-8", "utf-8-sig"):
        return _parsed(lambda: _decoded(raw, encoding), raw, told, ending, Path(path))
    text = _decoded(raw, encoding)
    return _parsed(lambda: text, text.encode(), told, ending)


def _decoded(raw, encoding):
    try:
        if encoding == "utf-8-sig":  # Python's own takes its time
            return raw.removeprefix(b"\xef\xbb\xbf").decode("utf-8")
        return raw.decode(encoding)
    except UnicodeError as error:
        line = raw[: getattr(error, "start", 0)].count(b"\n") + 1
        advice = 'save it as "CSV UTF-8", or name its encoding, perhaps cp1252 or utf-16'
        raise RecordingError((line, f"this is not text in {short(encoding)}: {advice}")) from None
    except (LookupError, TypeError, ValueError):
        raise RecordingError((None, f"there is no encoding {short(encoding)}; perhaps cp1252 or utf-16?")) from None


def parse(text, time=None, columns=None, time_unit=None, **options) -> Recording:
    """A recording from a text that holds the whole table; arguments and errors as in `read`."""
    if not isinstance(text, str):
        raise RecordingError((None, f"text must be a text, got {short(text)}"))
    needs("pandas", "reading a table")
    told = Options.of(dict(time=time, columns=columns, time_unit=time_unit, **options))
    return _parsed(lambda: text, text.encode("utf-8", "surrogatepass"), told)


def _parsed(text, raw, options, ending="", path=None):
    """From plain texts quickly; if anything is wrong once more, slowly, to say what.

    text: a function that returns the whole text, which takes its time; raw: the same in UTF-8; path: of a file of raw.
    """
    head = raw[:8000]
    if ending == ".gpx" or b"<gpx" in head:
        return _recording(tracks.gpx(text()), options, [])
    if ending == ".nmea" or head.lstrip(b"\xef\xbb\xbf \r\n").startswith((b"$G", b"\\g:")):
        return _recording(tracks.nmea(text(), options), options, [])
    try:
        table = rows.quick_table(raw, options, path)
        if table is not None:
            return _recording(table, options, [])
    except RecordingError:
        pass
    faults: list = []
    return _recording(rows.exact_table(text(), options, faults), options, faults)


def _recording(table, options, faults):
    """From a table to a recording; faults are added to those of the rows."""
    places = [table.find(name) for name in options.clocks] or [0]
    if options.where is not None:
        table = shapes.where(table, options.where)
    if options.pivot is not None:
        table = shapes.pivot(table, options.pivot, places)
        places = list(range(len(places)))
    if len(table) < 2:
        below = "below its header, " if table.word == "line" else ""
        faults.append((table.top, f"a recording needs two rows or more {below}found {len(table)}"))
        raise RecordingError(*faults, word=table.word)
    chosen, others = judge.chosen_of(table, places, options)
    ticks = clock.clock_of(table, places, options)
    table, ticks = order.ordered(table, ticks, options)
    faults += order.faults_of(table, ticks, options)
    values = judge.values_of(table, chosen, options, faults)
    if not faults:
        chosen, values = judge.without_silent(table, chosen, values, options, faults, others)
    if faults:
        raise RecordingError(*sorted(faults, key=lambda fault: fault[0] or 0), word=table.word)
    seconds, values, lines = order.equal_rows(table, ticks, options, values)
    names, units = (tuple(part[j] for j in chosen) for part in (table.names, table.units))
    notes = list(ticks.notes)
    if others:
        notes.append("not read: " + ", ".join(f"{table.names[j]} ({why})" for j, why in others.items()))
    return Recording(seconds, values, names, units, lines, ticks.start, float(ticks.tick), tuple(notes))
