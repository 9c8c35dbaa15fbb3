"""The real recordings: what they say of themselves, and numbers that somebody else has published."""

import copy
import pickle
import re
from pathlib import Path

import numpy as np
import pytest

from kflearn import RecordingError, examples
from kflearn.course.recordings import Recording

ROOT = Path(__file__).parents[2]
DATA = ROOT / "kflearn" / "course" / "data"
per_recording = pytest.mark.parametrize("name", examples.NAMES)


@per_recording
def test_it_says_where_it_is_from(name):
    found = examples.load(name)
    assert isinstance(found, Recording)
    assert min(len(found.title), len(found.source), len(found.licence)) > 10
    assert all(part == part.strip() for part in (found.title, found.source, found.licence))
    assert len(found) >= 100 and np.isfinite(found.values).mean() > 0.95


@per_recording
def test_the_file_is_small_and_names_all_that_must_be_said(name):
    text = (DATA / f"{name}.csv").read_text(encoding="utf-8")
    assert len(text.encode()) <= 200_000
    for what in ("title", "source", "licence", "units", "left out", "made"):
        assert text.count(f"\n# {what}: ") + text.startswith(f"# {what}: ") == 1, what
    assert not re.search(r"(?i)serial|ssid|\bmac\b|latitude|longitude|https?:", text)


@per_recording
@pytest.mark.parametrize("again", [copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
def test_a_copy_is_as_read_only(name, again):
    one = examples.load(name)
    other = again(one)
    np.testing.assert_array_equal(one.values, other.values)
    assert other.source == one.source
    assert not one.values.flags.writeable and not other.values.flags.writeable


@per_recording
def test_the_page_has_a_section(name):
    page = (ROOT / "notebooks" / "appendix-recordings.md").read_text(encoding="utf-8")
    (section,) = re.findall(rf"(?ms)^## `{name}` · .*?(?=^## |\Z)", page)
    for label in ("Source", "Licence", "Units", "Left out", "Made", "Beware", "Lesson"):
        assert section.count(f"- **{label}:** ") == 1, label
    assert f"{len(examples.load(name)):,} rows" in section


def test_an_unknown_name():
    with pytest.raises(RecordingError, match="there is no real recording 'lift'; they are light, nile"):
        examples.load("lift")


def test_michelson_as_certified():
    """NIST, Statistical Reference Datasets, Michelso: mean, standard deviation, correlation of neighbours."""
    speed = examples.load("light")["speed"] / 1000
    away = speed - speed.mean()
    np.testing.assert_allclose(speed.mean(), 299.8524, rtol=0, atol=1e-10)
    np.testing.assert_allclose(speed.std(ddof=1), 0.0790105478190518, rtol=1e-9)
    np.testing.assert_allclose(np.sum(away[1:] * away[:-1]) / np.sum(away**2), 0.535199668621283, rtol=1e-9)


def test_the_nile_as_in_the_reference():
    table = np.genfromtxt(ROOT / "tests" / "reference" / "nile.csv", skip_header=1)
    np.testing.assert_array_equal(examples.load("nile")["flow"], table)


def test_the_hurricane_and_the_gaps():
    spring, air = examples.load("spring"), examples.load("co2")
    day = np.nanargmax(np.diff(spring["level"])) + 1
    assert f"{spring.start:%Y-%m-%d}" == "2010-10-01" and day == 2537  # 11 September 2017, hurricane Irma
    assert np.isnan(air["co2"]).sum() == 59 and air.steps.even


def test_the_sensor_comes_to_rest():
    board = examples.load("imu")
    rest = board.time > 4
    assert board["gyro x"][~rest].std() > 20 and board["gyro x"][rest].std() < 0.2
    assert abs(board["acceleration z"][rest].mean() - 1) < 0.01
