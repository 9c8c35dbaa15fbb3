"""The learner's own files: what is right is read exactly; each kind of damage gets one clear sentence with its line."""

import contextlib
import importlib.util
import math
from datetime import UTC, datetime, timedelta, timezone
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from kflearn import Gaussian, LinearModel, constant_velocity, kalman_filter, random_walk, simulate
from kflearn.recordings import EXAMPLES, Recording, RecordingError, example, parse, read
from kflearn.report import ReportCard, longest_run, neighbours, report_card

nan = np.nan
GOOD = "t [s],x [m]\n0,1\n0.5,2\n1,3\n"


def error_of(text, **settings):
    with pytest.raises(RecordingError) as caught:
        parse(text, **settings)
    assert str(caught.value) and "\n\n" not in str(caught.value)
    return caught.value


# ---- what is right


def test_a_plain_table():
    r = parse("# by hand\n\nt [s],height [m],speed (km/h),kind\n0,1.5,36,1\n0.5,,18,nan\n1.5,-2e1,NA,3\n")
    assert_array_equal(r.time, [0, 0.5, 1.5])
    assert_array_equal(r.values, [[1.5, 36, 1], [nan, 18, nan], [-20, nan, 3]])
    assert r.names == ("height", "speed", "kind") and r.units == ("m", "km/h", "")
    assert_array_equal(r.lines, [4, 5, 6])
    assert r.start == 0 and len(r) == 3
    assert_array_equal(r["height"], [1.5, nan, -20])
    assert_array_equal(r["height [m]"], r["height"])
    assert "speed: 18 to 36 km/h, gaps: 1" in str(r) and "kind: 1 to 3 (no unit)" in str(r)


@pytest.mark.parametrize("separator", ",;\t")
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_separators_line_ends_and_marks(separator, end, mark):
    text = mark + GOOD.replace(",", separator).replace("\n", end)
    assert_array_equal(parse(text).values, [[1], [2], [3]])
    assert_array_equal(parse(text).lines, [2, 3, 4])


@pytest.mark.parametrize("separator", ";\t")
def test_decimal_commas(separator):
    r = parse(f"t [s]{separator}x\n0{separator}1,5\n,5{separator}-2,\n1,25{separator}3e-1\n")
    assert_array_equal(r.values[:, 0], [1.5, -2, 0.3])
    assert_array_equal(r.time, [0, 0.5, 1.25])


def test_quotes_spaces_and_a_true_minus_sign():
    r = parse('"Time (s)", "Height, up (m)" \n 0 , "1" \n1, −2\n')
    assert r.names == ("Height, up",) and r.units == ("m",)
    assert_array_equal(r.values[:, 0], [1, -2])


def test_empty_fields_at_the_end_of_lines_and_rows_without_anything():
    r = parse("t [s];x;\n0;1;\n;;\n1;2\n2;3;;;\n   \n")
    assert_array_equal(r.values[:, 0], [1, 2, 3])
    assert_array_equal(r.lines, [2, 4, 5])


@pytest.mark.parametrize("gap", ["", "nan", "NaN", "NA", "n/a", "null", "None", " "])
def test_gaps(gap):
    assert_array_equal(parse(f"t [s],x\n0,{gap}\n1,2\n").values[:, 0], [nan, 2])


@pytest.mark.parametrize(
    ("unit", "seconds"),
    [("ns", 1e-9), ("µs", 1e-6), ("ms", 1e-3), ("s", 1), ("S", 1), ("min", 60), ("h", 3600), ("d", 86400)],
)
def test_units_of_time(unit, seconds):
    for r in (parse(f"t [{unit}],x\n5,1\n7,2\n"), parse("t,x\n5,1\n7,2\n", time_unit=unit)):
        assert_allclose(r.time, [0, 2 * seconds], rtol=1e-15)
        assert r.start == 5
    assert_allclose(parse("t [min],x\n5,1\n7,2\n", time_unit=unit).time[1], 2 * seconds, rtol=1e-15)


def test_large_stamps_keep_their_differences():
    assert_array_equal(parse("t [ms],x\n1767225600000,1\n1767225600007,2\n").time, [0, 0.007])


@pytest.mark.parametrize(
    "stamps",
    [
        ("2026-05-03 08:14:00", "2026-05-03 08:14:02.5"),
        ("2026-05-03T08:14:00Z", "2026-05-03T10:14:02.500+02:00"),
        ("20260503T081400", "20260503T081402,5"),
        ("2026-12-31T23:59:59", "2027-01-01 00:00:01.5"),
    ],
)
def test_dates(stamps):
    r = parse("when;x\n{};1\n{};2\n".format(*stamps))
    assert_array_equal(r.time, [0, 2.5])
    assert isinstance(r.start, datetime)


def test_a_summer_time_change_with_zones_is_no_jump():
    r = parse("t;x\n2026-03-29T01:59:59+01:00;1\n2026-03-29T03:00:00+02:00;2\n")
    assert r.time[1] == 1


def test_columns_and_the_time_column_are_chosen_by_name():
    text = "a [m],t [s],b,note\n1,0,2,walk\n3,1,4,run\n"
    r = parse(text, time="t", columns=["b", "a"])
    assert r.names == ("b", "a") and r.units == ("", "m")
    assert_array_equal(r.values, [[2, 1], [4, 3]])
    assert_array_equal(parse(text, time="t [s]", columns="a [m]").values, [[1], [3]])


def test_a_recording_cannot_be_changed():
    r = parse(GOOD)
    for array in (r.time, r.values, r.lines):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 7


def test_steps():
    r = parse("t [s],x\n0,1\n1,1\n2,1\n12,1\n13,1\n")
    assert_array_equal(r.steps.dt, [1, 1, 10, 1])
    assert r.steps.median == 1 and not r.steps.even
    assert_array_equal(r.steps.holes, [2])
    assert "holes: 10 s after line 4" in str(r) and "uneven" in str(r)
    assert parse("t [s],x\n0,1\n1.001,1\n2,1\n").steps.even
    many = parse("t [s],x\n" + "".join(f"{k + 10 * (k // 4)},1\n" for k in range(24)))
    assert len(many.steps.holes) == 5 and "and 2 more" in str(many)


def test_on_grid():
    r = parse("t [s],x,y\n0,1,2\n1.04,3,4\n4,5,\n5,6,7\n6,8,9\n")
    grid = r.on_grid(1)
    assert_array_equal(grid.time, range(7))
    assert_array_equal(grid["x"], [1, 3, nan, nan, 5, 6, 8])
    assert_array_equal(grid.lines, [2, 3, 0, 0, 4, 5, 6])
    assert grid.names == r.names and grid.start == r.start and grid.steps.even
    assert_array_equal(grid.on_grid().values, grid.values)
    assert_array_equal(r.on_grid(0.5)["y"][[0, 2, 12]], [2, 4, 9])
    assert_array_equal(r.on_grid(Fraction(1, 2)).values, r.on_grid(0.5).values)


@pytest.mark.parametrize(
    ("dt", "words"),
    [
        (0.3, r"line 3: the row at 1 s lies off the grid of 0.3 s"),
        (100, r"line 3: the row at 1 s lies off the grid of 100 s"),
        (0, "dt must be a positive number of seconds, got int 0"),
        (nan, "dt must be a positive"),
        (math.inf, "dt must be a positive"),
        (-1, "dt must be a positive"),
        (10**400, "dt must be a positive number of seconds, got int 1000"),
        ("1 s", "dt must be a positive number of seconds, got '1 s'"),
        (1e-9, "a grid of 1e-09 s would have more than 10,000,000 rows"),
        (5e-324, "would have more than"),
    ],
)
def test_on_grid_refuses(dt, words):
    with pytest.raises(RecordingError, match=words):
        parse("t [s],x\n0,1\n1,2\n2,3\n").on_grid(dt)


# ---- what is wrong: (text, settings, line, words)

DAMAGE = {
    "nothing": ("", {}, None, "there is nothing in it"),
    "comments only": ("# a\n\n  # b\n ;;; \n", {}, None, "nothing but empty lines and comments"),
    "no separator": ("t x\n0 1\n1 2\n", {}, 1, "no comma, semicolon or tab separates columns here: 't x'"),
    "no header": ("# note\n0,1\n1,2\n2,3\n", {}, 2, "the names of the columns are missing"),
    "no header, dates": ("2026-05-03;1,5\n2026-05-04;2\n", {}, 1, "the names of the columns are missing"),
    "header in a comment": ("# t,x\n0,1\n1,2\n", {}, 2, "what follows a # is a comment"),
    "nameless": ("t [s],,x\n0,1,2\n1,1,2\n", {}, 1, "column 2 has no name"),
    "only a unit": ("t [s],[m]\n0,1\n1,2\n", {}, 1, "column 2 has no name"),
    "named twice": ("t [s],x [m],x [km]\n0,1,2\n1,1,2\n", {}, 1, "two columns have the name 'x'"),
    "one column": ("t [s],\n0,\n1,\n", {}, 1, "a column or more beside that of the time stamps"),
    "no rows": ("t [s],x\n", {}, 1, "two rows or more below its header, found 0"),
    "one row": ("t [s],x\n0,1\n\n", {}, 1, "two rows or more below its header, found 1"),
    "no unit": ("t,x\n0,1\n1,2\n", {}, 1, "column 't' needs the unit of its time stamps: write [s] or [ms] behind it"),
    "odd unit": ("t [furlong],x\n0,1\n1,2\n", {}, 1, "'furlong' is not one of ns, us, ms"),
    "odd time_unit": (GOOD, dict(time_unit=3), 1, "int 3 is not one of"),
    "no text for a time_unit": (GOOD, dict(time_unit=np.array([])), 1, "ndarray array([], dtype= is not one of ns"),
    "no such time": (GOOD, dict(time="clock"), 1, "there is no column 'clock'; the columns are 't, x'"),
    "no such column": (GOOD, dict(columns=["x", "y"]), 1, "there is no column 'y'"),
    "time no text": (GOOD, dict(time=0), 1, "there is no column int 0"),
    "columns no list": (GOOD, dict(columns=7), None, "columns must be a list of names, got int 7"),
    "columns empty": (GOOD, dict(columns=[]), 1, "a column or more"),
    "columns twice": (GOOD, dict(columns=["x", "x"]), 1, "each named once"),
    "time as column": (GOOD, dict(columns=["t", "x"]), 1, "beside that of the time stamps"),
    "a word": ("t [s],x\n0,1\n1,abc\n2,3\n", {}, 3, "column 'x': 'abc' is no number"),
    "a long word": ("t [s],x\n0,1\n1," + 99 * "ab" + "\n2,3\n", {}, 3, "column 'x': 'abababababababababababa…' is"),
    "infinite": ("t [s],x\n0,1\n1,inf\n2,3\n", {}, 3, "'inf' is no number"),
    "too large": ("t [s],x\n0,1\n1,1e999\n2,3\n", {}, 3, "'1e999' is too large"),
    "underscore": ("t [s],x\n0,1\n1,1_000\n2,3\n", {}, 3, "'1_000' is no number"),
    "other digits": ("t [s],x\n0,1\n1,٣\n2,3\n", {}, 3, "'٣' is no number"),
    "with its unit": ("t [s],x\n0,1\n1,3 m\n2,3\n", {}, 3, "'3 m' is no number"),
    "a formula": ("t [s],x\n0,1\n1,=1+1\n2,3\n", {}, 3, "'=1+1' is no number"),
    "thousands": ('t [s],x\n0,1\n1,"1,234.5"\n2,3\n', {}, 3, "'1,234.5' has separators of thousands"),
    "thousands, European": ("t [s];x\n0;1\n1;1.234,5\n2;3\n", {}, 3, "'1.234,5' has separators of thousands"),
    "thousands, spaces": ("t [s];x\n0;1\n1;12 345\n2;3\n", {}, 3, "'12 345' has separators of thousands"),
    "thousands, once": ("t [s];x\n0;1,5\n1;1.234\n2;3\n", {}, 3, "'1.234' has a '.' where others have ','"),
    "quoted comma": ('t [s],x\n0,1\n1,"1,234"\n2,3\n', {}, 3, "has a comma, but commas separate the columns"),
    "decimal comma": ("t [s],x\n0,1\n1,1,5\n2,3\n", {}, 3, "found 3 fields, but the header names 2 columns (decimals"),
    "too short": ("t [s];x;y\n0;1;2\n1;2\n2;3;4\n", {}, 3, "found 2 fields, but the header names 3 columns"),
    "too long": ("t [s];x\n0;1\n1;2;3\n2;3\n", {}, 3, "found 3 fields, but the header names 2 columns"),
    "open quotes": ('t [s],x\n0,1\n1,"2\n2,3\n', {}, 3, "its quotation marks do not match"),
    "odd quotes": ('t [s],x\n0,1\n1,"2"3\n2,3\n', {}, 3, "its quotation marks do not match"),
    "quotes in the header": ('t [s],"x\n0,1\n1,2\n2,3\n', {}, 1, "its quotation marks do not match"),
    "no stamp": ("t [s],x\n0,1\n,2\n2,3\n", {}, 3, "the time stamp is missing"),
    "first stamp missing": ("t [s],x\n,1\n1,2\n2,3\n", {}, 2, "the time stamp is missing"),
    "odd stamp": ("t [s],x\n0,1\nsoon,2\n2,3\n", {}, 3, "the time stamp 'soon' is no number"),
    "first stamp odd": ("t [s],x\nsoon,1\n1,2\n2,3\n", {}, 2, "the time stamp 'soon' is no number"),
    "NaN as a stamp": ("t [s],x\n0,1\nNaN,2\n2,3\n", {}, 3, "the time stamp 'NaN' is no number"),
    "repeated": ("t [s],x\n0,1\n1,2\n1.0,2\n2,3\n", {}, 4, "the time stamp '1.0' repeats that of line 3"),
    "backwards": ("t [s],x\n0,1\n2,2\n1,2\n3,3\n", {}, 4, "the time stamp '1' lies before that of line 3"),
    "too far": ("t [d],x\n0,1\n1,2\n1e307,2\n", {}, 4, "is too far from the first"),
    "odd date": ("t;x\n2026-05-03;1\n2026-02-30;2\n2026-05-04;2\n", {}, 3, "'2026-02-30' is no date as in ISO 8601"),
    "other dates": ("t;x\n2026-05-03;1\n4.5.2026;2\n2026-05-05;2\n", {}, 3, "'4.5.2026' is no date as in ISO 8601"),
    "zone lost": ("t;x\n2026-05-03T00:00Z;1\n2026-05-03T01:00;2\n2026-05-03T02:00Z;3\n", {}, 3, "has a time zone"),
    "clock put back": ("t;x\n2026-10-25T02:59:59;1\n2026-10-25T02:00:00;2\n", {}, 3, "lies before that of line 2"),
    "silent": ("t [s],x,y\n0,1,\n1,2,NA\n", {}, 1, "column 'y' holds no reading at all"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "settings", "line", "words"), DAMAGE.values(), ids=DAMAGE)
def test_damage(text, settings, line, words):
    error = error_of(text, **settings)
    assert error.lines == (line,), error
    assert words in str(error)
    assert str(error) == error.faults[0] and str(error).startswith(f"line {line}: " if line else "")
    assert len(str(error)) < 160


def test_only_dates_of_another_kind():
    error = error_of("t;x\n3.5.2026;1\n4.5.2026;2\n")
    assert error.lines == (2, 3) and "like 2026-05-31 14:05:09" in str(error)


def test_all_faults_are_told_in_the_order_of_the_lines():
    error = error_of("t [s],x,y\n0,a,b\n1,2\n0,3,4\n5,1,c\n,1,1\n7,d,1\n")
    assert error.lines == (2, 2, 3, 4, 5, 6, 7)
    assert str(error).splitlines()[:2] == [
        "line 2: column 'x': 'a' is no number",
        "line 2: column 'y': 'b' is no number",
    ]
    assert len(str(error).splitlines()) == 6 and str(error).endswith("… and 2 more")


def test_a_fault_in_a_column_that_is_not_read_does_not_matter():
    assert_array_equal(parse("t [s],x,note\n0,1,a\n1,2,b\n", columns=["x"]).values, [[1], [2]])


@pytest.mark.parametrize("text", [None, b"t [s],x", 3, ["t [s],x"]])
def test_no_text(text):
    with pytest.raises(RecordingError, match="text must be a text, got"):
        parse(text)


# ---- files


def test_files_in_other_encodings(tmp_path):
    path = tmp_path / "room.csv"
    text = "t [s];T [°C]\n0;20,5\n1;21\n"
    for encoding in ("utf-8", "utf-8-sig"):
        path.write_bytes(text.encode(encoding))
        assert read(path).units == ("°C",) and read(str(path)).start == 0
    path.write_bytes(text.encode("cp1252"))
    with pytest.raises(RecordingError, match=r"line 1: this is not text in 'utf-8-sig': save it as \"CSV UTF-8\""):
        read(path)
    assert read(path, encoding="cp1252").units == ("°C",)
    path.write_bytes(text.encode("utf-16"))
    with pytest.raises(RecordingError, match="perhaps cp1252 or utf-16"):
        read(path)
    assert read(path, encoding="utf-16", columns="T").units == ("°C",)
    path.write_bytes(b"t [s],x\n0,1\n1,\xff\n")
    with pytest.raises(RecordingError, match="line 3: this is not text"):
        read(path)
    path.write_bytes(b"t [s],x\n0,1\n1,2")
    for encoding in ("klingon", "", None, 3, "utf\0", "zip", "utf-16"):
        with pytest.raises(RecordingError):
            read(path, encoding=encoding)


@pytest.mark.parametrize("path", ["no such file.csv", ".", "", "a\0b", None, 3, "x" * 5000])
def test_files_that_cannot_be_read(path):
    with pytest.raises(RecordingError, match="cannot be read: ") as caught:
        read(path)
    assert len(str(caught.value)) < 120


# ---- any text at all: a Recording or a RecordingError, nothing else

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


def sound(r):
    assert isinstance(r, Recording)
    assert r.values.shape == (len(r.time), len(r.names)) and len(r.names) == len(r.units) and len(r.lines) == len(r)
    assert len(r) >= 2 and r.time[0] == 0 and (np.diff(r.time) > 0).all() and np.isfinite(r.time).all()
    assert not np.isinf(r.values).any() and not np.isnan(r.values).all(axis=0).any()
    assert (np.diff(r.lines) > 0).all() and str(r)


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


def test_nothing_is_evaluated():
    error = error_of("t [s],x\n0,__import__('os').getcwd()\n1,2\n2,3\n")
    assert error.lines == (2,) and "is no number" in str(error)


# ---- the recordings that come with the course


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples(name):
    sound(read(example(name)))
    assert example(name).stat().st_size < 60_000


def test_what_the_examples_are_for():
    lift, ride, room = (read(example(name)) for name in EXAMPLES)
    assert lift.steps.even and lift.units == ("m", "m/s^2")
    assert np.nanstd(lift["height"][lift.time < 20]) < 0.4
    assert not ride.steps.even and ride.steps.dt.max() > 25 and ride.units == ("m", "m", "km/h")
    assert ride.start.utcoffset() == timedelta(hours=2) and np.isnan(ride.values).any()
    assert room.units == ("°C", "%") and np.isnan(room.on_grid(10).values).all(axis=1).sum() > 15
    with pytest.raises(RecordingError, match="there is no example 'bus'; the examples are lift, cyclist, thermometer"):
        example("bus")


def test_the_script_makes_the_examples_that_are_shipped():
    place = Path(__file__).parent.parent / "tools" / "recordings.py"
    spec = importlib.util.spec_from_file_location("make_recordings", place)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    for make, seed in script.RECORDINGS:
        lines = make(np.random.default_rng(seed))
        assert "\n".join(lines) + "\n" == example(make.__name__).read_bytes().decode()


# ---- the report card


def drifting(rest=300, moving=700, rng=1):
    """A quantity that stands still, then drifts; R = 4, Q = 1."""
    _, z, _ = simulate(random_walk(Q=1, R=4), [0], moving, rng=rng)
    noise = np.random.default_rng(rng).normal(0, 2, (rest, 1))
    return np.concatenate([noise, z]), np.arange(rest + moving) < rest


def follower(Q=1.0, R=4.0, gate=None):
    def follow(z):
        if gate:
            z = np.where(abs(z - np.nanmedian(z)) > gate, nan, z)
        model = random_walk(Q=Q, R=R)
        return model, kalman_filter(model, z[1:], Gaussian(np.nan_to_num(z[0]), R))

    return follow


def found(card, what):
    return next(value for name, value, _, _ in card.tests if name == what)


def failed(card):
    return {name for name, value, low, high in card.tests if not low <= value <= high}


def test_a_right_filter_passes():
    z, _ = drifting(rest=2)
    rest = np.arange(len(z)) < 2
    card = report_card(z, rest, follower())
    assert isinstance(card, ReportCard) and card.passed and not failed(card)
    assert "verdict: can be defended" in str(card) and "✗" not in str(card)


@pytest.mark.parametrize(
    ("settings", "faults"),
    [
        (dict(Q=0.02), {"NIS / m", "neighbours, innovations"}),
        (dict(Q=50), {"NIS / m", "neighbours, innovations"}),
        (dict(R=0.4), {"scatter at rest / R"}),
        (dict(R=40), {"scatter at rest / R"}),
        (dict(gate=5), {"share refused", "refused in a row"}),
    ],
)
def test_a_wrong_filter_fails(settings, faults):
    z, rest = drifting()
    card = report_card(z, rest, follower(**settings))
    assert faults <= failed(card) and not card.passed
    assert "verdict: not yet" in str(card)


def test_a_filter_that_refuses_everything_fails_in_words():
    z, rest = drifting(20, 30)
    card = report_card(z, rest, follower(gate=1e-9))
    assert not card.passed and found(card, "share refused") == 1
    assert "✗ NIS / m" in str(card)
    assert not report_card(np.ones((20, 1)), np.ones(20), follower()).passed


def test_gaps_are_not_refusals_and_change_little():
    z, rest = drifting()
    whole = report_card(z, rest, follower())
    z = z.copy()
    z[1:][np.random.default_rng(3).random(len(z) - 1) < 0.2] = nan
    card = report_card(z, rest, follower())
    assert found(card, "share refused") == 0
    assert found(card, "NIS / m") == pytest.approx(found(whole, "NIS / m"), abs=0.15)


def test_two_columns_of_different_units_and_half_missing_rows():
    z, _ = drifting(rest=2)
    other, _ = drifting(rest=2, rng=2)
    both = np.concatenate([z, 1000 * other], axis=1)
    both[10::7, 1] = nan
    Q, R = np.diag([1, 1e6]), np.diag([4, 4e6])

    def follow(z):
        model = LinearModel(np.eye(2), np.eye(2), Q, R)
        return model, kalman_filter(model, z[1:], Gaussian(np.nan_to_num(z[0]), R))

    card = report_card(both, np.arange(len(z)) < 2, follow)
    assert found(card, "NIS / m") == pytest.approx(1, abs=0.1) and found(card, "share refused") == 0


def test_numbers_of_the_card_by_hand():
    z = np.array([[1.0], [3.0], [2.0], [6.0], [4.0], [8.0], [9.0]])
    model = constant_velocity(1, 1, R=2)
    start = Gaussian([1, 0], np.eye(2))
    card = report_card(z, [1, 1, 1, 0, 0, 0, 0], lambda z: (model, kalman_filter(model, z[1:], start)))
    track = kalman_filter(model, z[1:], start)
    part = np.where(np.arange(7)[:, None] == 4, nan, z)
    ahead = kalman_filter(model, part[1:], start).predicted.mean[3, 0]
    assert found(card, "scatter at rest / R") == pytest.approx(np.var([1, 3, 2], ddof=1) / 2)
    assert found(card, "neighbours at rest") == pytest.approx(-0.5)
    assert found(card, "NIS / m") == pytest.approx(track.nis.mean())
    assert found(card, "miss / last reading's") == pytest.approx(abs(ahead - 4) / 2)
    assert found(card, "miss / all ignored") == pytest.approx(abs(ahead - 4) / 3)


@pytest.mark.parametrize(
    ("z", "rest", "words"),
    [
        (np.ones(9), np.ones(9), "z must have shape"),
        (np.ones((9, 1)), np.ones(8), "rest must have shape"),
        (np.ones((9, 1)), np.zeros(9), "rest must be True for two rows or more with readings in every column"),
        (np.full((9, 1), nan), np.ones(9), "rest must be True for two rows or more"),
        ([[nan], [1], [2], [3], [4], [5]], np.ones(6), "z must begin with a row without gaps"),
        (np.full((9, 1), np.inf), np.ones(9), "z must be finite"),
    ],
)
def test_report_card_refuses(z, rest, words):
    with pytest.raises(ValueError, match=words):
        report_card(z, rest, follower())


def test_neighbours():
    white = np.random.default_rng(1).normal(size=(10_000, 2))
    assert abs(neighbours(white)) < 1.96 / np.sqrt(20_000) * 1.5
    assert neighbours(np.array([[1.0], [-1], [1], [-1]])) == -0.75
    assert neighbours(np.array([[1.0], [nan], [1], [1]])) == pytest.approx(1 / 3)


@given(st.lists(st.booleans(), max_size=30))
def test_longest_run(flags):
    runs = "".join("x" if flag else " " for flag in flags).split(" ")
    assert longest_run(flags) == max(map(len, runs))
