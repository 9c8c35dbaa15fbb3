"""The part "inputs" of `make check-hard`: it works, and it sees a fault where there is one."""

import numpy as np
import pytest

from dev.hard import inputs, wrong_calls
from dev.hard.junk import Junk, print_of
from kflearn import recordings
from kflearn.exercises.engine import Exercise


@pytest.fixture(autouse=True)
def few(monkeypatch):
    for area in ("EXERCISES", "TABLES", "CALLS"):
        monkeypatch.setattr(inputs, area, 6000)


def failed():
    return [line.what for line in inputs.lines(True) if not line.ok]


def test_it_works():
    found = list(inputs.lines(True))
    assert [line.what for line in found if not line.ok] == ["inputs in all"], "fewer than the part promises"
    assert all(len(line.what) <= 58 for line in found) and len(found) == 7


def test_it_sees_what_raises_and_what_overwrites(monkeypatch):
    def check(self, answer=...):
        raise LookupError

    def parse(text, time=None, columns=None, time_unit=None, **options):
        if isinstance(columns, list):
            columns.append("t")
        raise recordings.RecordingError((None, "no"))

    def call(given):
        if given.dof != 2:
            raise ZeroDivisionError
        given.z[...] = 0

    monkeypatch.setattr(Exercise, "check", check)
    monkeypatch.setattr(recordings, "parse", parse)
    monkeypatch.setattr(wrong_calls, "CALLS_TRIED", [call])
    ends = [line.ok for line in inputs.lines(True)]
    assert ends == [False, True, True, False, False, False, False]


def test_junk_is_the_same_again_and_a_print_sees_a_change():
    assert [type(Junk(5).thing()) for _ in range(3)] == [type(Junk(5).thing()) for _ in range(3)]
    one = [np.arange(3.0), {"a": np.ma.array([1, 2], mask=[0, 1])}]
    before = print_of(one)
    one[0][1] = np.nan
    assert print_of(one) != before
