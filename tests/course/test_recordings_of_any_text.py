"""Any text at all is a Recording or a RecordingError, nothing else; what was written is read again."""

import contextlib
import math
from datetime import UTC, timedelta, timezone
from unittest.mock import patch

import numpy as np
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from kflearn.course.reading import rows
from kflearn.course.recordings import RecordingError, parse, read
from tests.course.tables import error_of, nan, sound

FIELDS = st.one_of(
    st.sampled_from(
        ["", "0", "1", "2.5", "-3,5", "1e400", "nan", "NA", '"', '"a,b"', "[m]", "x (s)", "t [ms]", "#", "−1"]
    ),
    st.sampled_from(["2026-05-03", "2026-05-03T01:02:03+02:00", "0001-01-01T00:00+23:59", "9999-12-31T23:59:59-23:59"]),
    st.floats().map(str),
    st.integers().map(str),
    st.datetimes(timezones=st.sampled_from([None, UTC, timezone(timedelta(hours=-9))])).map(str),
    st.text(max_size=6),
)
TABLES = st.tuples(
    st.sampled_from(["", "\ufeff", "# note\n", "t [s],x\n", "t [ms];x;y\n", "t;x [m]\n", "a\tb\n"]),
    st.lists(st.lists(FIELDS, max_size=4), max_size=8),
    st.sampled_from(",;\t"),
    st.sampled_from(["\n", "\r\n", "\r"]),
).map(lambda parts: parts[0] + parts[3].join(parts[2].join(row) for row in parts[1]))


@settings(max_examples=300, deadline=None)
@given(st.one_of(TABLES, st.text(max_size=200)))
def test_any_text(text):
    try:
        r = parse(text)
    except RecordingError as error:
        assert error.faults and len(error.faults) == len(error.lines)
        assert all(line is None or 1 <= line <= len(text) + 1 for line in error.lines)
    else:
        sound(r)
        with contextlib.suppress(RecordingError):
            sound(r.on_grid())


@settings(max_examples=100, deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes(tmp_path_factory, raw):
    path = tmp_path_factory.getbasetemp() / "fuzz.csv"
    path.write_bytes(raw)
    for encoding in ("utf-8-sig", "cp1252", "utf-16"):
        with contextlib.suppress(RecordingError):
            sound(read(path, encoding=encoding))


READINGS = st.floats(-1e12, 1e12).map(lambda x: float(f"{x:.9g}")) | st.just(nan)


@settings(max_examples=150, deadline=None)
@given(
    st.lists(st.tuples(st.integers(1, 10**9), READINGS, READINGS), min_size=2, max_size=12),
    st.sampled_from([(",", "."), (";", "."), (";", ","), ("\t", ",")]),
    st.sampled_from(["", "\ufeff", "# by hand\n"]),
    st.sampled_from(["\n", "\r\n"]),
)
def test_what_was_written_is_read(rows, style, head, end):
    separator, point = style
    stamps = np.cumsum([step for step, _, _ in rows])
    values = np.array([[x, y] for _, x, y in rows])
    values[0] = 0  # no column without any reading
    lines = [separator.join(["t [ms]", "x [m]", "y"])]
    for stamp, row in zip(stamps, values, strict=True):
        fields = [str(stamp), *("" if math.isnan(v) else repr(v).replace(".", point) for v in row.tolist())]
        lines.append(separator.join(fields))
    r = parse(head + end.join(lines))
    assert_array_equal(r.values, values)
    assert_allclose(r.time, (stamps - stamps[0]) / 1000, rtol=1e-15)
    assert r.units == ("m", "")


ROWS = st.lists(st.sampled_from(["1", "2.5", "", "nan", "-3e2", "x", "# y", "3 # z"]), min_size=0, max_size=4)


@settings(max_examples=300, deadline=None)
@given(
    st.lists(ROWS, min_size=2, max_size=6),
    st.sampled_from([",", ";", "\t"]),
    st.sampled_from(["", "preamble\n", "# note\n"]),
    st.sampled_from(["", "\n", "\n\n", "\n# end\n"]),
)
@example([["1", "1", "nan"], ["1", "1"]], ",", "", "")  # a word where there is no column
@example([["1", "2", ""], ["1"]], ",", "", "")  # a separator too many in one row hides the one missing in another
def test_pandas_and_line_by_line_say_the_same(table, separator, head, end):
    lines = [separator.join([str(k), *fields]) for k, fields in enumerate(table)]
    text = head + separator.join(["t [s]", "x", "y"]) + "\n" + "\n".join(lines) + end
    quick = _all_that_is_read(text)
    with patch.object(rows, "quick_table", return_value=None):
        assert quick == _all_that_is_read(text)


def _all_that_is_read(text):
    try:
        r = parse(text)
    except RecordingError as error:
        return str(error)
    return r.names, r.units, r.notes, r.time.tolist(), r.lines.tolist(), str(r.values.tolist())


def test_nothing_is_evaluated():
    error = error_of("t [s],x\n0,__import__('os').getcwd()\n1,2\n2,3\n")
    assert error.lines == (2,) and "is no number" in str(error)
