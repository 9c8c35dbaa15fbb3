"""Sliders, number boxes, choices and check boxes without a browser."""

import math

import ipywidgets
import pytest
from traitlets import TraitError, link

from kflearn.ui import choice, log_slider, slider, toggle
from tests.ui.samples import Browser, make


def test_a_move_is_answered_with_values_and_picture():
    lively = make()
    answer = Browser(lively).move(values={"Q": 1.2345})
    assert lively.values["Q"] == answer["values"]["Q"] == 1.2345
    assert answer["status"] == "Q = 1.2345, R = 0.5"
    assert answer["ops"]
    assert answer["n"] == 1


@pytest.mark.parametrize("wrong", [{"Q": 1e9}, {"Q": "much"}, {"S": 1}, {"Q": None}])
def test_what_a_control_cannot_take_is_left_out(wrong):
    lively = make()
    answer = Browser(lively).move(values={"R": 1.0, **wrong})
    assert lively.values == answer["values"] == {"Q": 1.0, "R": 1.0}
    assert lively.errors == 0


def test_whole_numbers():
    lively = make(lambda live, n: f"{n!r}", n=slider(1, 50, 10))
    assert Browser(lively).move(values={"n": 17.0})["values"] == {"n": 17}
    assert lively.status == "17"
    assert lively.controls["n"].ends() == (1, 25, 50)


def test_choice_and_toggle():
    def steps(live, step, band):
        return f"{step} {band}"

    lively = make(steps, step=choice(["predict", "measure", "correct"]), band=toggle(True, label="show the band"))
    browser = Browser(lively)
    assert lively.status == "predict True"
    browser.move(values={"step": "correct"})
    browser.move(values={"band": False})
    assert lively.status == "correct False"
    browser.move(reset=True)
    assert lively.status == "predict True"
    assert lively.sweep() == 6
    assert str(lively) == "Playground: step: predict, measure, correct; band: on or off"


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda: log_slider(0, 1, 0.5), "0 < low < high"),
        (lambda: log_slider(1, 10, 20), "from 1 to 10 cannot be 20"),
        (lambda: slider(3, 2, 2), "low < high"),
        (lambda: slider(0, 2, math.nan), "cannot be nan"),
        (lambda: choice(["a", "b"], "c"), "a choice of a, b cannot be 'c'"),
        (lambda: make().set(S=1), "no control is named 'S'; this playground has Q, R"),
        (lambda: make().set(Q="much"), "cannot be 'much'"),
        (lambda: make().set(Q=1e9), "from 0.01 to 100 cannot be"),
    ],
)
def test_wrong_values_are_named(wrong, words):
    with pytest.raises(ValueError, match=words):
        wrong()


def test_two_playgrounds_share_a_description_not_a_value():
    q = log_slider(0.1, 10, 1)
    one, two = make(lambda live, Q: "", Q=q), make(lambda live, Q: "", Q=q)
    one.set(Q=5)
    assert two.values == {"Q": 1}


def test_values_are_traits_that_other_widgets_can_follow():
    lively, other, seen = make(), ipywidgets.FloatText(3.0), []
    browser = Browser(lively)
    lively.controls["Q"].observe(lambda change: seen.append(change["new"]), "value")
    link((other, "value"), (lively.controls["Q"], "value"))
    assert lively.status == "Q = 3, R = 0.5"
    browser.move(values={"Q": 7.0})
    assert other.value == 7
    other.value = 20
    assert browser.heard[-1][0]["values"]["Q"] == lively.values["Q"] == 20
    assert seen == [3, 7, 20]
    with pytest.raises(TraitError, match=r"from 0\.01 to 100 cannot be 1000"):
        lively.controls["Q"].value = 1000


def test_a_widget_nests_in_layouts():
    assert ipywidgets.VBox([make().widget]).children[0].spec["size"] == [600, 300]


def test_names_for_those_who_do_not_see():
    q = make(Q=log_slider(0.01, 100, 1, label=r"$\sigma_x$", unit="V²"), update=lambda live, Q: "").widget.spec
    (spec,) = q["controls"]
    assert spec["plain"] == "sigma x"
    assert spec["range"] == "from 0.01 to 100 V²"
    assert spec["label"].startswith('<svg aria-hidden="true"')


@pytest.mark.parametrize(
    ("control", "value", "near"),
    [
        (log_slider(0.01, 100, 1), 3.14159, 3.14),
        (log_slider(0.01, 100, 1), 1e9, 100),
        (slider(0.0, 2.0, 1.0), 0.777, 0.78),
        (slider(1, 50, 10), 7.6, 8),
        (slider(1, 15, 1, step=2), 7.6, 7),
    ],
)
def test_the_nearest_value_a_hand_could_choose(control, value, near):
    assert control.near(value) == near
    assert type(control.near(value)) is type(control.start)
