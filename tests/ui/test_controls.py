"""Sliders, number boxes, choices and check boxes without a browser."""

import asyncio
import math

import pytest

from kflearn.ui import choice, log_slider, slider, toggle
from tests.ui.samples import make


def test_number_box_and_slider():
    lively = make()
    control = lively.controls["Q"]
    control.box.value = 1.2345  # typed
    assert lively.values["Q"] == 1.2345
    assert control.slider.value == pytest.approx(1.2345, rel=0.07)
    control.slider.value = 10**0.1  # the browser moves the handle to its nearest step: not a new value
    assert lively.values["Q"] == 1.2345
    control.slider.value = 10**0.55  # dragged
    assert lively.values["Q"] == control.box.value == 3.55
    control.box.value = 1e9
    assert lively.values["Q"] == 100
    assert lively.errors == 0


def test_number_box_waits_for_the_picture():
    async def drag():
        lively = make()
        control = lively.controls["Q"]
        control.slider.value = 10**0.55
        first = control.box.value
        await asyncio.sleep(0.05)
        return first, control.box.value

    assert asyncio.run(drag()) == (1, 3.55)


def test_whole_numbers():
    lively = make(lambda live, n: f"{n!r}", n=slider(1, 50, 10))
    lively.controls["n"].slider.value = 17.0
    assert lively.status == "17"
    assert lively.controls["n"].ends() == (1, 25, 50)
    for typed, taken in ((17.7, 17), (18.2, 18), (18.9, 18)):  # also when it is the number that was there before
        lively.controls["n"].box.value = typed
        assert lively.values["n"] == lively.controls["n"].box.value == taken


def test_choice_and_toggle():
    def steps(live, step, band):
        return f"{step} {band}"

    lively = make(steps, step=choice(["predict", "measure", "correct"]), band=toggle(True, label="show the band"))
    assert lively.status == "predict True"
    lively.controls["step"].buttons.value = "correct"
    lively.controls["band"].widget.value = False
    assert lively.status == "correct False"
    lively.reset()
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


def test_names_for_those_who_do_not_see():
    control = make().controls["Q"]
    assert control.box.description == "$Q$"
    assert control.box.tooltip == "Q from 0.01 to 100 V²"
    assert 'role="status" aria-live="polite"' in make()._status.value
