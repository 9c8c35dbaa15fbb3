"""The table of what other libraries find for the Nile: its rows, and those that can be made again here."""

import pytest

from dev import who_fits_nile
from kflearn import examples


def test_who_fits_the_nile_is_what_the_programs_here_say():
    """Those that are installed beside the course: fit, statsmodels and pykalman."""
    table = {row["library"]: row for row in examples.who_fits_nile()}
    series = who_fits_nile.three(examples.load("nile")["flow"])
    found = {"kflearn": who_fits_nile.ours(series)}
    for name in ("statsmodels", "statsmodels exact", "pykalman EM"):
        pytest.importorskip(who_fits_nile.LIBRARIES[name].package)
        found[name] = who_fits_nile.asked(name, series)
    for name, said in found.items():
        columns = who_fits_nile.COLUMNS
        for column, cell in zip(columns, who_fits_nile.row(name, "-", "-", said), strict=True):
            if column in ("version", "call", "also", "seen"):
                continue
            stored = table[name][column]
            if isinstance(stored, str):
                assert cell == stored, (name, column)
            else:
                assert float(cell) == pytest.approx(float(stored), rel=1e-3, abs=1e-3, nan_ok=True), (name, column)


def test_who_fits_the_nile_has_a_row_for_each_library_with_its_pinned_version():
    table = examples.who_fits_nile()
    assert list(table["library"]) == ["kflearn", *who_fits_nile.LIBRARIES]
    pins = dict(
        line.split("==") for line in who_fits_nile.PINS.read_text(encoding="utf-8").splitlines() if "==" in line
    )
    for row in table[1:]:
        package = who_fits_nile.LIBRARIES[row["library"]].package
        assert package == "R" or row["version"] == pins[package]
    good = table[(abs(table["R"] / 15098.5 - 1) < 0.02) & (abs(table["Q"] / 1469.2 - 1) < 0.02)]
    assert len(good) == 9  # of the fourteen; the lesson counts them
    assert list(table["library"][table["converged_white"] == "boundary"]) == ["kflearn"]


def test_a_library_that_raises_is_a_row_in_words(monkeypatch):
    broken = who_fits_nile.LIBRARIES["pykalman EM"]._replace(ask=lambda z: 1 / 0, package="numpy")
    monkeypatch.setitem(who_fits_nile.LIBRARIES, "broken", broken)
    cells = who_fits_nile.row("broken", "-", "-", who_fits_nile.asked("broken", [None] * 3))
    assert cells.count("ZeroDivisionError") == 3 and cells.count("nan") == 8
