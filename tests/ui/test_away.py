"""An arrow at the edge of the axes says where a line is that has left them."""

import pytest

from kflearn import plots
from kflearn.ui.away import HALF, short


def words(line, ax):
    """What stands at the edge, and where its arrow is in the axes, from 0 to 1."""
    ax.figure.canvas.draw()
    note = line.artists[-1]
    box, half = note.get_window_extent(), HALF * ax.figure.dpi / 72
    x = box.x0 + half if note.get_text()[:1] in "▲▼" else box.x1 - half
    return note.get_text(), ax.transAxes.inverted().transform((x, note.get_position()[1]))


@pytest.fixture
def ax():
    _, ax = plots.figure(size=(6, 3))
    ax.set(xlim=(0, 10), ylim=(-1, 1))
    return ax


def test_nothing_while_the_line_is_inside(ax):
    line = plots.estimate(ax, [0, 5, 10], [0, 1, -1], away=True)
    assert words(line, ax)[0] == ""


@pytest.mark.parametrize("draw", [plots.estimate, plots.truth, plots.prediction])
def test_the_furthest_point_is_told(ax, draw):
    line = draw(ax, [0, 5, 10], [0, 0, 0], away=True)
    line.set([0, 5, 10], [3, 12.5, 0])
    text, (x, y) = words(line, ax)
    assert text == "▲ 12.5"
    assert x == pytest.approx(0.5, abs=0.01)
    assert 0.9 < y < 1
    line.set([0, 5, 10], [-1353, 12.5, 0])
    text, (x, y) = words(line, ax)
    assert text == "▼ −1353"
    assert 0 <= x < 0.02, "at its side, but whole"
    assert 0 < y < 0.1
    line.set([], [])
    assert words(line, ax)[0] == ""


@pytest.mark.parametrize("at", [0, 0.3, 3, 5, 7, 9.7, 10])
@pytest.mark.parametrize("size", [2, -1353, 12.34, -3e9])
def test_the_arrow_is_at_its_time_and_the_number_inside_the_axes(ax, at, size):
    line = plots.truth(ax, [at - 0.01, at, at + 0.01], [0, size, 0], away=True)
    text, (x, _) = words(line, ax)
    assert text.strip("▲▼ ") == short(size)
    assert x == pytest.approx(at / 10, abs=0.012)
    box, axes = line.artists[-1].get_window_extent(), ax.bbox
    assert axes.x0 - 1 <= box.x0 and box.x1 <= axes.x1 + 1


def test_what_is_beside_the_axes_does_not_count(ax):
    line = plots.truth(ax, [0, 20], [0, 5], away=True)
    assert words(line, ax)[0] == ""


def test_decades_and_gaps(ax):
    ax.set(yscale="log", ylim=(0.1, 10))
    line = plots.prediction(ax, [0, 5, 10], [1, float("nan"), 3e7], away=True)
    assert words(line, ax)[0] == "3e+07 ▲"


def test_it_stands_below_a_legend_that_is_there(ax):
    line = plots.truth(ax, [0, 5, 10], [0, 9, 0], away=True)
    free = words(line, ax)[1][1]
    ax.legend(loc="upper center")
    assert words(line, ax)[1][1] < free - 0.1


def test_numbers_are_short():
    assert [short(value) for value in (1353, -0.0412, 12.34, 3e9)] == ["1353", "−0.0412", "12.3", "3e+09"]
