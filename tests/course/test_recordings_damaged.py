"""The learner's own files: each kind of damage gets one clear sentence with its line."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from kflearn.course.recordings import RecordingError, parse, read
from tests.course.tables import GOOD, error_of

# What is wrong: (text, settings, line, words)
DAMAGE = {
    "nothing": ("", {}, None, "there is nothing in it"),
    "comments only": ("# a\n\n  # b\n ;;; \n", {}, None, "nothing but empty lines and comments"),
    "no separator": ("t x\n0 1\n1 2\n", {}, 1, "no comma, semicolon or tab separates columns here: 't x'"),
    "no header": ("# note\n0,1\n1,2\n2,3\n", {}, 2, "the names of the columns are missing"),
    "no header, dates": ("2026-05-03;1,5\n2026-05-04;2\n", {}, 1, "the names of the columns are missing"),
    "header in a comment": ("# t,x\n0,1\n1,2\n", {}, 2, "what follows a # is a comment"),
    "named twice": ("t [s],x,x\n0,1,2\n1,1,2\n", dict(columns=["x"]), 1, "two columns have the name 'x': ask for"),
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
    "words only": ("t [s],from\n0,gps\n1,\n2,gps\n", {}, 1, "'from' holds words, such as 'gps'"),
    "silent": ("t [s],x,y\n0,1,\n1,2,NA\n", dict(columns=["x", "y"]), 1, "column 'y' holds no reading at all"),
    "clock put back": ("t;x\n2026-10-25T02:59:59;1\n2026-10-25T02:00:00;2\n", {}, 3, "lies before that of line 2"),
    "clock put back, Europe": ("t;x\n2026-10-25T02:59:59;1\n2026-10-25T02:00:00;2\n", {}, 3, "did the clocks change"),
    "clock put back, America": ("t;x\n2026-11-01T01:59:59;1\n2026-11-01T01:00:00;2\n", {}, 3, "did the clocks change"),
}  # fmt: skip


@pytest.mark.parametrize(("text", "settings", "line", "words"), DAMAGE.values(), ids=DAMAGE)
def test_damage(text, settings, line, words):
    error = error_of(text, **settings)
    assert error.lines == (line,), error
    assert words in str(error)
    assert str(error) == error.faults[0] and str(error).startswith(f"line {line}: " if line else "")
    assert len(str(error)) < 160


def local(*clocks, day="2026-03-29", zone=""):
    return "t;x\n" + "".join(f"{day}T{clock}{zone};1\n" for clock in clocks)


FORWARD = ("01:30", "01:40", "01:50", "03:00", "03:10")  # every ten minutes, and no hour from two to three


@pytest.mark.parametrize("day", ["2026-03-29", "2026-03-08", "2025-03-30", "2025-03-09"])
def test_clocks_that_were_put_forward(day):
    error = error_of(local(*FORWARD, day=day))
    assert error.lines == (5,) and "did the clocks change here? write stamps with a zone" in str(error)


@pytest.mark.parametrize(
    "text",
    [
        local(*FORWARD, zone="Z"),
        local(*FORWARD, day="2026-03-22"),
        local("01:30", "01:40", "01:50", "02:00", "02:10"),
        local("01:30", "01:40", "01:50", "04:00", "04:10"),  # a hole of two hours
        local("11:30", "11:40", "11:50", "13:00", "13:10"),  # by day
        "t;x\n2026-03-27;1\n2026-03-28;2\n2026-03-29;3\n2026-03-30;4\n",
    ],
)
def test_other_holes_in_march_are_holes(text):
    assert len(parse(text)) >= 4


def test_seconds_and_hours_across_the_change():
    assert error_of(local("01:59:57", "01:59:58", "01:59:59", "03:00:00")).lines == (5,)
    assert error_of(local("00:00", "01:00", "03:00", "04:00", "05:00")).lines == (4,)


def test_only_dates_of_another_kind():
    error = error_of("t;x\n3.5.2026;1\n4.5.2026;2\n")
    assert error.lines == (2,) and "dayfirst=True or dayfirst=False" in str(error)
    for dayfirst, month in ((True, 5), (False, 3)):
        assert parse("t;x\n3.5.2026;1\n4.5.2026;2\n", dayfirst=dayfirst).start.month == month


def test_all_faults_are_told_in_the_order_of_the_lines():
    error = error_of("t [s],x,y\n0,a,b\n1,2\n0,3,4\n5,1,c\n,1,1\n7,d,1\n")
    assert error.lines == (2, 2, 3, 4, 5, 6, 7)
    assert str(error).splitlines()[:2] == [
        "line 2: column 'x': 'a' is no number (no reading? missing=['a'])",
        "line 2: column 'y': 'b' is no number (no reading? missing=['b'])",
    ]
    assert len(str(error).splitlines()) == 6 and str(error).endswith("… and 2 more")


def test_a_fault_in_a_column_that_is_not_read_does_not_matter():
    assert_array_equal(parse("t [s],x,note\n0,1,a\n1,2,b\n", columns=["x"]).values, [[1], [2]])


def test_columns_that_nobody_asked_for_do_not_matter():
    r = parse("t [s],x,from,y\n0,1,gps,\n1,2,,NA\n2,3,gps,\n")
    assert r.names == ("x",) and r.notes == ("not read: from (words, such as 'gps'), y (no reading)",)
    assert r.notes[0] in str(r)
    assert parse("t [s],,x\n0,1,2\n1,1,2\n").names == ("column 2", "x")
    assert parse("t [s],[m]\n0,1\n1,2\n").names == ("[m]",)
    both = parse("t [s],x [m],x [km]\n0,1,2\n1,1,2\n")
    assert both.names == ("x [m]", "x [km]") and both.units == ("m", "km")


@pytest.mark.parametrize("text", [None, b"t [s],x", 3, ["t [s],x"]])
def test_no_text(text):
    with pytest.raises(RecordingError, match="text must be a text, got"):
        parse(text)


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
