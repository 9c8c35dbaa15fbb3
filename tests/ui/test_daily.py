"""The daily check, innovations inside ±2√S, and the diagram of a step."""

import numpy as np
import pytest

from kflearn import Gaussian, kalman_filter, plots, random_walk, simulate


def test_an_honest_filter_has_one_in_twenty_outside():
    model = random_walk(1, 4)
    track = kalman_filter(model, simulate(model, [0], steps=4000, rng=5).z, Gaussian(0, 1))
    y, std = track.innovation.mean[:, 0], track.innovation.std[:, 0]
    drawn = plots.innovations(plots.figure()[1], np.arange(4000), y, std)
    assert drawn.outside == pytest.approx(np.mean(abs(y) > 2 * std))
    assert drawn.outside == pytest.approx(0.0455, abs=3 * np.sqrt(0.0455 * 0.9545 / 4000))


def test_rings_stand_around_what_is_outside_and_gaps_do_not_count():
    drawn = plots.innovations(plots.figure()[1], [0, 1, 2, 3, 4], [1, np.nan, -3, 9, 0], [1, 1, 1, 5, 1])
    rings = drawn.artists[2]
    assert rings.get_xydata().tolist() == [[2, -3]]
    assert drawn.outside == 0.25
    assert drawn.set([0, 1], [2.1, 1.9], [1, 1]) is drawn
    assert rings.get_xydata().tolist() == [[0, 2.1]]
    assert drawn.outside == 0.5


def test_nothing_measured_is_nothing_outside():
    drawn = plots.innovations(plots.figure()[1], [0, 1], [np.nan, np.nan], [1, 1])
    assert drawn.outside == 0


def test_the_diagram_fills_what_it_is_told_to_mark(monkeypatch):
    shown = []
    monkeypatch.setattr("kflearn.ui.step.show", lambda fig, alt: shown.append((plots.pixels(fig), alt)))
    for mark in ((), ("belief",), ("predict",), ("innovation",), ("gain",), ("correct",), ("gain", "correct")):
        plots.step_diagram(*mark)
    plain = shown[0][0]
    changed = [(picture != plain).any(axis=(0, 2)) for picture, _ in shown[1:]]
    starts = [int(np.flatnonzero(columns)[0]) for columns in changed[:5]]
    assert starts == sorted(starts) and len(set(starts)) == 5
    assert (changed[5] == changed[3] | changed[4]).all()
    assert shown[0][1].endswith("leads back to the belief.")
    assert shown[-1][1].endswith("Marked: gain, correct.")


def test_the_diagram_knows_its_parts():
    with pytest.raises(ValueError, match="there is no 'update'"):
        plots.step_diagram("update")
