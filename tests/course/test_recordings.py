"""The learner's own files: what is right is read exactly; so are the recordings that come with the course."""

import importlib.util
import math
from datetime import datetime, timedelta
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from kflearn.course.recordings import EXAMPLES, RecordingError, example, parse, read
from tests.course.tables import GOOD, nan, sound


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
    place = Path(__file__).parents[2] / "dev" / "recordings.py"
    spec = importlib.util.spec_from_file_location("make_recordings", place)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    for make, seed in script.RECORDINGS:
        lines = make(np.random.default_rng(seed))
        assert "\n".join(lines) + "\n" == example(make.__name__).read_bytes().decode()
