"""What is read besides tables of text: DataFrames, dicts, GPX, NMEA, several files; what a recording says of itself."""

import contextlib
import pickle
import sys

import numpy as np
import pandas as pd
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from kflearn import RecordingError, recordings
from tests.course.tables import GOOD, nan

GPX = """<?xml version="1.0"?><gpx version="1.1" creator="x" xmlns="http://www.topografix.com/GPX/1/1"><trk><trkseg>
<trkpt lat="48.0" lon="11.0"><ele>500</ele><time>2026-03-01T12:00:00.5Z</time></trkpt>
<trkpt lat="48.001" lon="11.0"><time>2026-03-01T12:00:02Z</time></trkpt></trkseg></trk></gpx>"""


def signed(sentence):
    """An NMEA sentence with its checksum."""
    total = 0
    for sign in sentence:
        total ^= ord(sign)
    return f"${sentence}*{total:02X}\n"


NMEA = signed("GPGGA,115959.00,,,,,0,00,99.99,,M,,M,,")
NMEA += signed("GPRMC,120000.00,V,,,,,,,010426,,,N") + "$GPGSV,1,1,00*79\n"
NMEA += signed("GPGGA,120001.00,4530.1200,N,00030.4400,W,1,05,1.5,312.5,M,,M,,")
NMEA += signed("GPRMC,120001.00,A,4530.1200,N,00030.4400,W,010.0,084.4,010426,,,A")


def fails(*arguments, **settings):
    with pytest.raises(RecordingError) as caught:
        recordings.read(*arguments, **settings)
    return str(caught.value)


def test_frames_of_pandas():
    stamps = pd.date_range("2026-03-01 12:00", periods=3, freq="500ms", tz="Europe/Berlin")
    frame = pd.DataFrame({"when": stamps, "x [m]": [1, 2, 3], "ok": [True, False, True], "n": ["a", "b", "c"]})
    r = recordings.read(frame, time="when")
    assert_array_equal(r.time, [0, 0.5, 1])
    assert r.names == ("x",) and r.units == ("m",) and r.start.utcoffset().total_seconds() == 3600
    assert "ok (words, such as 'true'), n (words, such as 'a')" in str(r)
    by_index = recordings.read(frame.set_index("when")[["x [m]"]])
    assert_array_equal(by_index.values, r.values)
    odd = pd.DataFrame({"t [s]": [0, 1, 2], "x": pd.array([1, None, 3], dtype="Int64"), "y": ["1,5", "", "2"]})
    assert_array_equal(recordings.read(odd.iloc[::1], columns=["x"])["x"], [1, nan, 3])
    assert fails(pd.DataFrame({"t [s]": [0, 1, 1], "x": [1, 2, 3]})).startswith(
        "row 3: the time stamp '1' repeats that"
    )
    assert "there is nothing in it" in fails(pd.DataFrame())
    assert "complex" in fails({"t [s]": [0, 1], "x": [1j, 2]})


def test_dicts_of_arrays():
    r = recordings.read({"t [ms]": np.array([0, 20]), "x": [1.5, None], "y": np.ma.array([1, 2], mask=[0, 1])})
    assert_array_equal(r.time, [0, 0.02])
    assert_array_equal(r.values, [[1.5, 1], [nan, nan]])
    spans = recordings.read({"t": np.array([5, 6], "timedelta64[s]"), "x": [1, 2]})
    assert_array_equal(spans.time, [0, 1])
    assert "the columns have 2 rows ('t') and 3 ('x'): they must be alike" in fails({"t": [0, 1], "x": [1, 2, 3]})
    assert "'x' must be a list or an array of one dimension" in fails({"t [s]": [0, 1], "x": [[1], [2]]})


def test_frames_of_another_library_come_by_narwhals():
    with contextlib.suppress(ImportError):  # not among the course's packages
        import polars

        frame = polars.DataFrame({"when": list(pd.date_range("2026-03-01", periods=2)), "x [m]": [1.5, None]})
        r = recordings.read(frame, time="when")
        assert r.time[1] == 86400 and r["x"][0] == 1.5 and np.isnan(r["x"][1])

    class Table:
        columns = ("t", "x")

    assert "Table is no table: give a file name, a DataFrame or a dict of arrays" in fails(Table())


def test_gpx(tmp_path):
    (tmp_path / "walk.gpx").write_text(GPX)
    r = recordings.read(tmp_path / "walk.gpx", time="time")
    assert_array_equal(r.time, [0, 1.5])
    assert r.start.isoformat() == "2026-03-01T12:00:00.500000+00:00"
    assert_array_equal(r["height"], [500, nan])
    flat = r.in_metres()
    assert flat.names == ("north", "east", "height") and flat.units[:2] == ("m", "m")
    assert_allclose(flat.values[:, :2], [[0, 0], [111.19, 0]], atol=0.02)
    assert "in a plane from 48.000000°, 11.000000°: at 111.2 m distances are 5.6e-09 m too short" in str(flat)
    assert "two are needed" in fails(_file(tmp_path, GPX.replace("<time>2026-03-01T12:00:02Z</time>", "")))
    assert "this GPX cannot be read" in fails(_file(tmp_path, GPX[:-20]))


def _file(folder, text):
    path = folder / "own.txt"
    path.write_text(text)
    return path


def test_nmea(tmp_path):
    r = recordings.read(_file(tmp_path, NMEA))
    assert_array_equal(r.time, [0, 1])
    assert_allclose(r.values, [[nan] * 5, [45.502, -0.507333, 312.5, 5.14444, 84.4]], rtol=1e-6)
    assert_array_equal(r.lines, [2, 4])
    wrong = NMEA.replace("084.4", "084.5")
    assert fails(_file(tmp_path, wrong)).startswith("line 5: the checksum does not match")
    assert recordings.read(_file(tmp_path, wrong), checksum=False)["course"][1] == 84.5


@pytest.mark.parametrize("package", ["gpxpy", "pynmea2", "pymap3d", "pandas"])
def test_a_package_that_is_not_there_is_named(package, tmp_path, monkeypatch):
    r = recordings.read(_file(tmp_path, GPX))
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(RecordingError, match=f"needs the package {package}: pip install {package}"):
        recordings.read(_file(tmp_path, NMEA if package == "pynmea2" else GPX))
        r.in_metres()


def test_degrees_that_are_none():
    r = recordings.read({"t [s]": [0, 1], "lat": [48, 91], "lon": [11, 181]})
    with pytest.raises(
        RecordingError, match=r"line 2: column 'lat' has 91, which is no angle up to 90 degrees: missing="
    ):
        r.in_metres()
    with pytest.raises(RecordingError, match="there is no column 'east'"):
        r.in_metres(lon="east")
    with pytest.raises(RecordingError, match="origin must be latitude and longitude"):
        recordings.read({"t [s]": [0, 1], "lat": [48, 9], "lon": [11, 18]}).in_metres(origin="Rome")


def test_files_that_are_no_text(tmp_path):
    for head, word in (
        (b"PK\x03\x04", "Excel"),
        (b"PAR1", "Parquet"),
        (b"\x0e\x10\x00\x00.....FIT", "FIT"),
        (b"\xb5b", "UBX"),
    ):
        path = tmp_path / "own.bin"
        path.write_bytes(head + b"\0" * 20)
        assert word in fails(path) and "read(" in fails(path)


def test_several_files_of_one_clock(tmp_path):
    (tmp_path / "gps.csv").write_text("t [ms],east [m]\n15300,1.0\n16300,2.1\n")
    (tmp_path / "imu.csv").write_text("t [ms],acc\n0,0.1\n15300,0.2\n")
    both = recordings.read([tmp_path / "gps.csv", tmp_path / "imu.csv"], time="t")
    assert_array_equal(both.time, [0, 15.3, 16.3])
    assert_array_equal(both.values, [[nan, 0.1], [1, 0.2], [2.1, nan]])
    assert both.start == 0 and both.names == ("east", "acc") and both.units == ("m", "")
    dated = recordings.parse("t,x\n2026-01-01,1\n2026-01-02,2\n")
    assert recordings.merge(dated, dated).names == ("x", "x 2")
    with pytest.raises(RecordingError, match="cannot be compared: dates without a zone and numbers"):
        recordings.merge(dated, both)
    with pytest.raises(RecordingError, match="merge takes recordings, got 'x'"):
        recordings.merge(dated, "x")


@pytest.mark.parametrize(
    ("readings", "code", "who"),
    [
        ([84.2, 511, 90, 350.1], 511, "AIS"),
        ([10.1, 9.8, 102.3, 12], 102.3, "AIS"),
        ([48.1, 48.2, 91, 48], 91, "AIS"),
        ([11.1, 181, 11.2, 11.4], 181, "AIS"),
        ([60, 70, 255, 80], 255, "FIT"),
        ([812, 830, 65535, 815], 65535, "FIT"),
        ([2200, 2300, 4294967295, 2250], 4294967295, "UBX"),
        ([2.6, -200, 2.0, 2.2], -200, "gas analysers"),
        ([7.1, -999, 6.8, 6.5], -999, ""),
        ([7.1, 6.9, -9999, 6.5], -9999, ""),
        ([7, 9, 32767, 6], 32767, "the type's largest"),
    ],
)
def test_codes_for_not_available_are_named(readings, code, who):
    table = {"t [s]": range(len(readings)), "x": readings}
    r = recordings.read(table)
    ((name, found, count, said),) = r.suspects
    assert (name, found, count) == ("x", code, 1) and who in said
    assert f"missing={{'x': [{code:.12g}]}}" in str(r)
    cleaned = recordings.read(table, missing={"x": [code]})
    assert cleaned.suspects == [] and np.isnan(cleaned["x"]).sum() == 1


def test_ordinary_numbers_are_no_codes():
    for readings in (np.arange(256), [0, 91, 180, 270, 359], [-201, -200, -199], [255, 255, 255]):
        assert recordings.read({"t [s]": np.arange(len(readings)), "x": readings}).suspects == []


def test_what_a_recording_says():
    r = recordings.read({"t [s]": np.arange(10) / 5, "x [m]": np.repeat([1.5, 1.75], 5)})
    assert "median 0.2 s, 5 a second, even" in str(r)
    assert "x: 1.5 to 1.75 m, gaps: 0, resolution 0.25, 89% repeat the reading before" in str(r)
    again = pickle.loads(pickle.dumps(r))
    assert str(again) == str(r)
    assert "resolution" not in str(recordings.read({"t [s]": range(9), "x": np.sqrt(np.arange(9))}))


def test_on_grid_says_how_far_it_moved_readings():
    t = 0.1 * np.arange(50) + 0.0095 * (np.arange(50) % 2)
    grid = recordings.read({"t [s]": t, "x [m]": 10 * t}).on_grid(0.1)
    assert_allclose(grid.moved, [0.095**2 / 2], rtol=0.01)
    assert "rows moved by up to 0.0095 s; this adds to R about: x 0.0045 m²" in str(grid)
    assert recordings.parse(GOOD).on_grid(0.5).moved is None


def test_missing_marks_and_rows_of_one_object():
    text = "t [s],id,x,y\n0,1,-999,--\n1,1,2,3\n1,2,8,9\n2,1,3,4\n"
    r = recordings.parse(text, missing=[-999, "--"], where={"id": 1}, columns=["x", "y"])
    assert_array_equal(r.values, [[nan, nan], [2, 3], [3, 4]])
    with pytest.raises(RecordingError, match="there is no such row; column 'id' has '1, 2'"):
        recordings.parse(text, where={"id": 3})


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (dict(tme="t"), "there is no option 'tme'; the options are time, columns"),
        (dict(zone=3), "zone must be the name of a time zone such as 'Europe/Berlin', got int 3"),
        (dict(equal="last"), "equal must be one of"),
        (dict(where="id"), "where must be a dict"),
        (dict(pivot="name"), "pivot must be two names"),
        (dict(missing=[None]), "missing must be a list of marks"),
        (dict(wraps=0), "wraps must be where the counter begins again"),
        (dict(header=0), "header must be the number of the line"),
        (dict(header=99), "header=99: there is nothing in this line"),
        (dict(dayfirst="yes"), "dayfirst must be True or False"),
        (dict(separator=";;"), "separator must be one sign"),
    ],
)
def test_options_are_checked(options, words):
    with pytest.raises(RecordingError) as caught:
        recordings.parse(GOOD, **options)
    assert words in str(caught.value)


def test_zones():
    night = "t,x\n2026-03-29 02:30,1\n2026-03-29 03:30,2\n"
    with pytest.raises(
        RecordingError, match=r"line 2: .* does not exist in Europe/Berlin: the clocks were put forward"
    ):
        recordings.parse(night, zone="Europe/Berlin")
    with pytest.raises(RecordingError, match="zone='Mars/Olympus' is not known; such as 'Europe/Berlin'"):
        recordings.parse(night, zone="Mars/Olympus")
    once = "t,x\n2026-10-25 01:30,1\n2026-10-25 02:30,2\n2026-10-25 03:30,2\n"
    with pytest.raises(RecordingError, match="happened twice in Europe/Berlin when the clocks were put back"):
        recordings.parse(once, zone="Europe/Berlin")
    r = recordings.parse("t,x\n2026-07-01 12:00,1\n2026-07-01 12:30,2\n", zone="Europe/Berlin")
    assert r.start.utcoffset().total_seconds() == 7200 and "local time of Europe/Berlin" in str(r)
