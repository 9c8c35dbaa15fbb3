"""The race with Stone Soup: what agrees is timed, what does not or is missing is said."""

import numpy as np
import pytest

from dev.bench import report, targets


@pytest.fixture
def race():
    first = next(targets.races())
    return first._replace(z=first.z[:3])


def answer(race, factor=1.0):
    """What Stone Soup would say if it agreed, but for a factor in the means."""
    track = race.ours(race.z[0])
    inside = track.weights[:, 1:] > 0
    return dict(means=factor * track.mean, covs=track.cov, weights=track.weights, inside=inside, seconds=0.5)


def test_what_agrees_gets_its_time(race):
    line = targets.row(race, answer(race), 1)
    assert line.startswith("| calm sea, 8 readings a scan |")
    assert "500.00 ms" in line and line.endswith("| 0e+00 |")
    assert report.short([line]).strip() == "Short of a goal: nothing."


def test_what_is_slow_is_short_of_its_goal(race):
    line = targets.row(race, answer(race) | dict(seconds=1e-9), 1)
    assert "short" in line
    assert "calm sea" in report.short([line]) and "Python starts one by one" in report.short([line])


def test_what_disagrees_is_not_timed(race):
    assert "disagrees by 1.0e-06" in targets.row(race, answer(race, 1 + 1e-6), 1)
    gate = answer(race)
    gate["inside"] = ~gate["inside"]
    assert "disagrees by inf" in targets.row(race, gate, 1)


def test_what_cannot_be_installed_is_said(race, monkeypatch):
    monkeypatch.setattr(targets, "environment", lambda: "no network")
    monkeypatch.setattr(targets, "races", lambda: [race])
    assert "cannot be installed: no network" in list(targets.table(1))[-1]


@pytest.mark.skipif(not targets.MADE.exists(), reason="make bench has not made Stone Soup's environment")
def test_stone_soup_agrees():
    for race in targets.races():
        found = targets.theirs(race)
        assert not isinstance(found, str), found
        assert targets.difference(race.ours(race.z[0]), found) < targets.TOLERANCE
        assert np.isfinite(found["seconds"])
