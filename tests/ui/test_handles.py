"""Taking hold of the picture: a handle's place follows the sliders, and the sliders follow the hand."""

import numpy as np
import pytest

from kflearn import plots
from kflearn.ui import choice, drag, drag_bell, log_slider, slider
from tests.ui.samples import Browser, make

CONTROLS = dict(a=slider(0.0, 10.0, 2.0, step=0.5), b=log_slider(0.01, 100, 1.0, unit="V²"))


def draw(fig):
    """Two axes: a line at a, b; and, below, both of them on decades."""
    ax, below = fig.subplots(2)
    ax.set(xlim=(0, 10), ylim=(0, 100))
    below.set(xlim=(0.01, 100), ylim=(0.01, 100), xscale="log", yscale="log")
    return plots.truth(ax, [0], [0])


def take(*handles, ratio=1.0, controls=CONTROLS):
    """A playground and its browser."""
    lively = make(follow, draw, handles, **controls)
    return lively, Browser(lively, ratio=ratio)


def follow(line, a, b, **others):
    line.set([a], [b])
    return f"{a:g}, {b:g}"


def pixels(lively, ax, x, y):
    """Where a place in some axes is, in device pixels from the top."""
    fig = lively._stage.fig
    right, up = fig.axes[ax].transData.transform((x, y))
    return [float(right), float(fig.bbox.height - up)]


def told(browser, i=0):
    """What the browser was last told about a handle."""
    return browser.heard[-1][0]["handles"][i]


# ---- places and values


@pytest.mark.parametrize("ratio", [1.0, 2.0])
@pytest.mark.parametrize("axes", [0, 1])
def test_a_point_goes_where_the_hand_goes_and_where_the_sliders_are(ratio, axes):
    lively, browser = take(drag("a", "b", axes=axes), ratio=ratio)
    assert told(browser)["at"] == pytest.approx(pixels(lively, axes, 2, 1), abs=1e-6)
    answer = browser.move(drag=[0, *pixels(lively, axes, 6.5, 20)])
    assert answer["values"] == {"a": 6.5, "b": 20}
    assert told(browser)["at"] == pytest.approx(pixels(lively, axes, 6.5, 20), abs=1e-6)
    lively.set(a=3.0, b=4.0)
    assert told(browser)["at"] == pytest.approx(pixels(lively, axes, 3, 4), abs=1e-6)
    left, top, width, height = told(browser)["area"]
    assert [left + width / 2, top + height / 2] == pytest.approx(told(browser)["at"])
    assert width == height == 32 * ratio


@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_lines_are_as_long_as_the_axes(ratio):
    lively, browser = take(drag(x="a"), drag(y="b", axes=1), ratio=ratio)
    boxes = [ax.bbox for ax in lively._stage.fig.axes]
    upright, level = told(browser, 0), told(browser, 1)
    assert (upright["along"], level["along"]) == ("x", "y")
    assert upright["line"] and level["line"]
    assert upright["area"][2:] == pytest.approx([20 * ratio, boxes[0].height])
    assert level["area"][2:] == pytest.approx([boxes[1].width, 20 * ratio])
    assert upright["at"][0] == pytest.approx(pixels(lively, 0, 2, 0)[0])
    assert level["at"][1] == pytest.approx(pixels(lively, 1, 1, 1)[1])
    assert browser.move(drag=[0, *pixels(lively, 0, 7, 90)])["values"] == {"a": 7, "b": 1}
    assert browser.move(drag=[1, *pixels(lively, 1, 50, 0.3)])["values"] == {"a": 7, "b": 0.3}


def test_the_sliders_steps_and_ends_hold_for_the_hand_too():
    lively, browser = take(drag("a", "b"))
    assert browser.move(drag=[0, *pixels(lively, 0, 6.3, 12.345)])["values"] == {"a": 6.5, "b": 12.3}
    assert browser.move(drag=[0, -500, -500])["values"] == {"a": 0, "b": 100}
    assert browser.move(drag=[0, 5000, 5000])["values"] == {"a": 10, "b": 0.01}


def test_what_is_out_of_view_waits_at_the_edge():
    lively, browser = take(drag("a", "b"), controls=dict(a=slider(-50.0, 50.0, 2.0), b=log_slider(0.01, 1e4, 1.0)))
    box = lively._stage.fig.axes[0].bbox
    lively.set(a=50.0, b=1e4)
    assert told(browser)["at"] == pytest.approx([box.x1, lively._stage.fig.bbox.height - box.y1])
    lively.set(a=-50.0)
    assert told(browser)["at"][0] == pytest.approx(box.x0)


# ---- coordinates that are not the values themselves


def test_a_coordinate_may_be_computed():
    behind = drag(x=("a", lambda a, b: 8 - a, lambda x: 8 - x), at=lambda b: 10 * b)
    lively, browser = take(behind)
    assert behind.place(dict(a=2, b=1)) == (6, 10)
    assert told(browser)["at"] == pytest.approx(pixels(lively, 0, 6, 10))
    assert browser.move(drag=[0, *pixels(lively, 0, 3, 77)])["values"] == {"a": 5, "b": 1}
    assert told(browser)["at"] == pytest.approx(pixels(lively, 0, 3, 10))
    assert not told(browser)["line"]
    assert told(browser)["along"] == "x"


def test_a_thing_on_a_curve_sees_both_coordinates_of_the_hand():
    def nearest(x, y):
        return np.degrees(np.arctan2(y / 10, x)) / 9

    turning = drag(
        x=("a", lambda a: 5 * np.cos(np.radians(9 * a)), nearest), at=lambda a: 50 * np.sin(np.radians(9 * a))
    )
    lively, browser = take(turning)
    for a in (0, 2.5, 5, 10):
        there = 5 * np.cos(np.radians(9 * a)), 50 * np.sin(np.radians(9 * a))
        assert browser.move(drag=[0, *pixels(lively, 0, *there)])["values"]["a"] == a
    assert told(browser)["along"] == "xy"


def test_a_place_that_is_not_finite_moves_nothing():
    lively, browser = take(drag(x=("a", lambda a: a, lambda x: np.nan)))
    assert browser.move(drag=[0, *pixels(lively, 0, 3, 3)])["values"] == {"a": 2, "b": 1}


def test_what_is_not_there_cannot_be_taken_hold_of():
    controls = CONTROLS | dict(step=choice(["see", "hide"]))
    _, browser = take(drag(x="a", when=lambda step: step == "see"), drag(x="a", at=lambda a: np.nan), controls=controls)
    assert "hidden" not in told(browser, 0)
    assert told(browser, 1) == dict(hidden=True)
    browser.move(values={"step": "hide"})
    assert told(browser, 0) == dict(hidden=True)
    assert browser.move(nudge=[0, 1, 0])["values"]["a"] == 2


# ---- keys


def test_keys_step_until_something_changes():
    lively, browser = take(drag(x="a"), controls=dict(a=slider(0, 10, 2), b=CONTROLS["b"]))
    assert browser.move(nudge=[0, 1, 0])["values"]["a"] == 3  # a hundredth of the axes would change nothing
    assert browser.move(nudge=[0, -1, 0])["values"]["a"] == 2
    assert browser.move(nudge=[0, 0, 1])["values"]["a"] == 2
    assert browser.move(nudge=[0, 10, 0])["values"]["a"] == 3
    for _ in range(20):
        browser.move(nudge=[0, -1, 0])
    assert lively.values["a"] == 0


def test_keys_go_both_ways_on_decades():
    _, browser = take(drag("b", "a", axes=1), controls=dict(a=log_slider(0.01, 100, 1), b=CONTROLS["b"]))
    assert browser.move(nudge=[0, 5, -5])["values"] == {"a": 1.58, "b": 1.58}
    back = browser.move(nudge=[0, -5, 5])["values"]
    assert back == {"a": pytest.approx(1, rel=0.01), "b": pytest.approx(1, rel=0.01)}


# ---- bells


def test_a_bell_has_a_top_and_a_width():
    bell = dict(a=slider(0.0, 10.0, 4.0), b=slider(0.5, 5.0, 1.0))
    lively, browser = take(*drag_bell("a", "b", height=50), controls=bell)
    assert told(browser, 0)["at"] == pytest.approx(pixels(lively, 0, 4, 50))
    assert told(browser, 1)["at"] == pytest.approx(pixels(lively, 0, 5, 50 * np.exp(-0.5)))
    assert browser.move(drag=[1, *pixels(lively, 0, 7, 0)])["values"] == {"a": 4, "b": pytest.approx(3.02, abs=0.03)}
    assert browser.move(drag=[1, *pixels(lively, 0, 1, 0)])["values"]["b"] == 0.5  # left of the middle
    assert browser.move(drag=[0, *pixels(lively, 0, 6, 0)])["values"] == {"a": 6, "b": 0.5}


def test_a_bell_that_stays_and_one_with_a_variance():
    (flank,) = drag_bell(60, "R", variance=True)
    x, y = flank.place(dict(R=4.0))
    assert x == 62
    assert y == pytest.approx(np.exp(-0.5) / np.sqrt(2 * np.pi * 4))
    lively, browser = take(*drag_bell(3, "b", variance=True))
    assert browser.move(drag=[0, *pixels(lively, 0, 6, 0)])["values"]["b"] == pytest.approx(9, rel=0.01)


# ---- words


def test_words_for_those_who_hear_it():
    lively, browser = take(drag("a", "b", label="the cross"))
    assert told(browser)["words"] == "the cross: a 2, b 1 V²; arrow keys move it"
    lively.set(b=30.0)
    assert told(browser)["words"] == "the cross: a 2, b 30 V²; arrow keys move it"


def test_wrong_names():
    with pytest.raises(ValueError, match="x, y or both"):
        drag()
    with pytest.raises(ValueError, match="name of a slider, got 'c'"):
        take(drag("c"))
    with pytest.raises(ValueError, match="name of a slider, got 'step'"):
        take(drag("step"), controls=CONTROLS | dict(step=choice(["see", "hide"])))
    for wrong in (drag("a", at=lambda c: c), drag(("a", lambda c: c, lambda x: x)), drag("a", when=lambda c: c)):
        with pytest.raises(ValueError, match="takes 'c', but no control is named so"):
            take(wrong)


def test_the_sweep_tries_the_handles_too():
    lively, _ = take(drag("a", at=lambda a: 1 / (a - 10)))
    with pytest.raises(ZeroDivisionError):
        lively.sweep()
