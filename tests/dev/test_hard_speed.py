"""The speed part of `make check-hard` runs, and can say no."""

from pathlib import Path
from time import sleep

import pytest

from dev.bench import filters, playground
from dev.hard import speed

ROOT = Path(__file__).parents[2]


def test_all_rivals_agree_on_a_part_of_each_race():
    for race in filters.races():
        z = race.z[:2, :40]
        ours = race.ours(z).mean
        for name, (rival, _) in race.rivals.items():
            theirs = rival(z)
            assert abs(ours - theirs).max() <= race.tolerance * abs(theirs).max(), f"{race.name}, {name}"


def test_a_rival_that_disagrees_is_not_timed():
    race = next(filters.races())
    wrong = race._replace(z=race.z[:5], rivals={"wrong": (lambda z: 1.01 * race.ours(z).mean, 5)})
    with pytest.raises(AssertionError, match="wrong disagrees"):
        filters.run(wrong, 1)


def test_slow_is_no():
    race = next(filters.races())
    lines = list(speed.ratios(filters.Result(race, 1.0, {"FilterPy": 999.0, "simdkalman": 2.0}, 1e-12)))
    assert [line.ok for line in lines] == [False, True, True]
    assert lines[0].measured == "999 times as quick" and lines[0].bound == "≥ 2000"
    slow, plain = playground.Round(60, 14.0, 0.5, 6000, 5.0), playground.Round(150, 3.0, 0.1, 150_000, 40.0)
    found = speed.pictures({playground.PLAIN: plain, playground.LIVE: slow})
    assert [line.ok for line in found] == [False, False, False]
    quick = playground.Round(15, 40.0, 0.95, 6000, 3.0)
    assert all(line.ok for line in speed.pictures({playground.PLAIN: plain, playground.LIVE: quick}))


def test_a_hungry_lesson_is_no(monkeypatch):
    monkeypatch.setattr(speed.footprint, "kernels", lambda lessons: {"05-voltmeter": 180.0, "22-adaptive": 1093.0})
    line = speed.memory(None)
    assert not line.ok
    assert line.measured == "1093 MB, 22-adaptive"


def test_a_slow_reader_is_no(monkeypatch):
    monkeypatch.setattr(speed.recordings, "read", lambda path: sleep(0.5))
    assert not speed.reading(1, rows=100).ok
    monkeypatch.setattr(speed.recordings, "read", lambda path: None)
    assert speed.reading(1, rows=100).ok
