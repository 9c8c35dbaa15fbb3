"""The part `numbers` of make check-hard: it runs, and each of its lines can fail."""

from pathlib import Path

import numpy as np
import pytest

from dev.hard import cards, draws, grid, units, values
from dev.hard.attempt import attempt, refusal
from kflearn import Gaussian, kalman_filter, report_card
from kflearn.filters import linear
from kflearn.results import report
from kflearn.ui import Playground, choice, slider

ROOT = Path(__file__).parents[2]

ship = pytest.fixture(lambda: units.plain("ship"))


@pytest.mark.timeout(300)
def test_the_part_runs():
    lines = list(values.lines(quick=True))
    assert len(lines) == 11 + len(cards.WRONG)
    assert not [line for line in lines if not line.ok]
    assert max(len(line.what) for line in lines) <= 58


@pytest.fixture
def failing(monkeypatch):
    """The lines that fail for the ship, with a quarter of the settings."""
    monkeypatch.setattr(values, "BLOCK", 10)
    return lambda: [line.what for line in values.random_settings(["ship"], 1) if not line.ok]


def test_a_filter_that_is_too_sure_is_found(monkeypatch, failing):
    right = linear.covariance_after
    monkeypatch.setattr(linear, "covariance_after", lambda *arguments: 0.7 * right(*arguments))
    assert ["within ±2σ" in what for what in failing()] == [True, True]


FAULTS = {
    "random settings": np.nan,
    "smallest eigenvalue": 3 - 2 * np.eye(4),  # correlations above 1
    "largest asymmetry": np.triu(np.ones((4, 4))),
}


@pytest.mark.parametrize("line", FAULTS)
def test_a_covariance_that_is_none_is_found(monkeypatch, failing, line):
    right, fault = linear.Walk.each, FAULTS[line]  # the last to touch a covariance
    spoilt = lambda plan, M, T: right(plan, M, T) * (fault if M.shape[-2:] == (4, 4) else 1)  # noqa: E731
    monkeypatch.setattr(linear.Walk, "each", spoilt)
    assert any(line in what for what in failing())


def test_a_filter_that_fails_is_found_and_so_is_one_that_always_refuses(monkeypatch, failing):
    monkeypatch.setitem(draws.LINEAR, "Kalman", lambda case: np.linalg.inv(np.zeros((2, 2))))
    assert failing()[0].startswith("random settings")
    assert not refusal(attempt(np.linalg.inv, np.zeros((2, 2))))

    def refuse(case):
        raise ValueError("R must be larger")

    assert refusal(attempt(refuse, None))
    monkeypatch.setitem(draws.LINEAR, "Kalman", refuse)
    assert failing()[0].startswith("random settings")


def test_a_threshold_in_somebodys_unit_is_found(monkeypatch, ship):
    right = draws.LINEAR["Kalman"]

    def careless(case):
        return right(case._replace(model=case.model.replace(Q=case.model.Q + 1e-9 * np.eye(4))))

    monkeypatch.setitem(draws.LINEAR, "Kalman", careless)
    assert not units.odd_units([ship], "units", [-12, 12], np.ones).ok


def test_a_filter_that_changes_what_it_is_given_is_found(monkeypatch, ship):
    right = draws.LINEAR["Kalman"]

    def careless(case):
        case.z[0] = 0
        return right(case)

    monkeypatch.setattr(units, "KINDS", {"columns first": np.asfortranarray})
    assert units.odd_arrays([ship]).ok
    monkeypatch.setitem(draws.LINEAR, "Kalman", careless)
    assert not units.odd_arrays([ship]).ok


def test_a_setting_between_the_ends_is_found():
    def draw(fig):
        return fig.subplots().plot([0, 1], [0, 1])[0]

    def update(line, a, kind):
        line.set_data([0, 1], [0, np.nan if 6 < a < 9 and kind == "odd" else a])

    board = Playground(draw, update, a=slider(0.0, 10.0, 2.0), kind=choice(["even", "odd"]))
    assert board.sweep() == 6
    assert grid.places(board, 40)[0] == sorted({0.0, 2.0, 10.0, *grid.places(board, 40)[0]})
    with pytest.raises(AssertionError, match="not finite"):
        grid.everywhere(board, 40)


# ---- the report card


def test_an_honest_filter_fails_its_card_in_one_recording_of_twenty():
    """4,080 recordings of twelve kinds."""
    all_kinds, worst = cards.honest(340)
    assert all_kinds.ok and worst.ok, (all_kinds.measured, worst.measured)


def test_bands_that_are_too_wide_or_too_narrow_are_found(monkeypatch):
    short = cards.KINDS[:2]
    for error in (0.005, 0.2):
        monkeypatch.setattr(report, "ERROR", error)
        assert not all(line.ok for line in cards.honest(300, short))


def test_one_of_many_is_what_it_would_be_alone():
    kind = cards.KINDS[7]
    rng = np.random.default_rng(3)
    together = list(kind.cards(rng, 3))
    z, dt = kind.records(np.random.default_rng(3), 3)
    models, start = kind.filters(z, dt, 1, 1)
    for k in range(3):
        model = models.replace(R=models.R[k])
        begin = Gaussian(start.mean[k], start.cov if start.cov.ndim == 2 else start.cov[k])
        alone = report_card(
            z[k],
            np.arange(kind.T) < kind.still,
            lambda z, m=model, b=begin: (m, kalman_filter(m, z[1:], b, gate=kind.gate)),
        )
        for one, other in zip(alone.tests, together[k].tests, strict=True):
            assert one.found == pytest.approx(other.found), one.what
            assert one.low == pytest.approx(other.low) and one.count == other.count


def test_a_card_that_passes_everything_is_found(monkeypatch):
    monkeypatch.setattr(report.ReportCard, "passed", True)
    lines = list(cards.lines(quick=True))
    assert [line.ok for line in lines[2:]] == [False] * len(cards.WRONG)
