"""Keyboard, pointer, touch and typed numbers: what hands do in the browser, and what the playground makes of it."""

import pytest

from kflearn.ui import choice, drag, log_slider, slider, toggle
from tests.ui.alone import Alone
from tests.ui.samples import make

pytestmark = pytest.mark.browser


HANDLES = (
    drag(y="R", label="the level"),
    drag(x="Q", y="R", label="the point"),
)


@pytest.fixture
def alone(chromium):
    found = Alone(chromium, make(handles=HANDLES))
    yield found
    found.close()


# ---- sliders


@pytest.mark.parametrize(
    ("keys", "values"),
    [
        (["ArrowRight"], [1.12, 0.5]),
        (["ArrowUp", "ArrowLeft", "ArrowLeft"], [0.891, 0.5]),
        (["PageUp"], [2.51, 0.5]),  # a tenth of the whole length
        (["PageDown"], [0.398, 0.5]),
        (["Home"], [0.01, 0.5]),
        (["End", "ArrowDown"], [89.1, 0.5]),
    ],
)
def test_keys_on_a_slider(alone, keys, values):
    for key in keys:
        alone.slider().press(key)
        alone.carry()
    assert alone.numbers() == values
    assert alone.is_right()


def test_a_slider_is_dragged_and_clicked(alone):
    track = alone.slider(1).bounding_box()
    alone.page.mouse.click(track["x"] + track["width"] / 2, track["y"] + track["height"] / 2)
    alone.carry()
    assert alone.numbers() == [1.0, 1.0]
    alone.drag(alone.slider(1), 0.3 * (track["width"] - 16), 0)
    assert alone.numbers()[1] == pytest.approx(1.6, abs=0.021)
    assert alone.is_right()
    alone.drag(alone.slider(1), 2000, 0)
    assert alone.numbers() == [1.0, 2.0]


def test_what_a_finger_does(chromium):
    """A tap on a slider, and a finger that drags the level in the picture without the page scrolling away."""
    alone = Alone(chromium, make(handles=HANDLES), has_touch=True, viewport=dict(width=420, height=300))
    track = alone.slider(0).bounding_box()
    alone.page.touchscreen.tap(track["x"] + track["width"] / 4, track["y"] + track["height"] / 2)
    alone.carry()
    assert 0.05 < alone.numbers()[0] < 0.2
    finger, box = alone.page.context.new_cdp_session(alone.page), alone.handle().bounding_box()
    x, y = box["x"] + 20, box["y"] + box["height"] / 2
    for kind, down in [
        ("touchStart", 0),
        ("touchMove", -5),
        ("touchMove", -12),
        ("touchMove", -20),
        ("touchEnd", None),
    ]:
        points = [] if down is None else [{"x": x, "y": y + down}]
        finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        alone.carry()
    assert alone.numbers()[1] > 1
    assert alone.page.evaluate("scrollY") == 0
    assert alone.handle().bounding_box()["y"] == pytest.approx(box["y"] - 20, abs=1.5)
    assert alone.is_right()
    alone.close()


@pytest.mark.parametrize(
    ("text", "taken"),
    [
        ("1.23456", 1.23456),
        ("0,25", 0.25),  # as one types it in half of Europe
        (" 3e1 ", 30.0),
        ("1e9", 100.0),
        ("-4", 0.01),
        ("", 1.0),
        ("much", 1.0),
        ("1e999", 1.0),
        ("0x10; alert(1)", 1.0),
    ],
)
def test_numbers_are_typed(alone, text, taken):
    alone.type(0, text)
    assert alone.numbers() == [taken, 0.5]
    assert alone.is_right()


def test_whole_numbers_choices_and_switches(chromium):
    lively = make(
        lambda live, **values: repr(values),
        n=slider(1, 50, 10),
        far=log_slider(1, 1e12, 1e3),
        step=choice(["predict", "measure"]),
        band=toggle(True),
    )
    alone = Alone(chromium, lively)
    alone.type(0, "17.9")
    assert lively.values["n"] == 17 and alone.numbers()[0] == 17
    alone.type(0, "99")
    alone.type(1, "1e12")
    assert alone.numbers() == [50, 1e12]
    assert alone.box(1).evaluate("box => box.scrollWidth <= box.clientWidth"), "the number is cut"
    alone.page.get_by_role("radio", name="measure").press("Space")
    alone.page.get_by_role("checkbox").press("Space")
    alone.carry()
    assert (lively.values["step"], lively.values["band"]) == ("measure", False)
    alone.page.get_by_role("radio", name="measure").press("ArrowLeft")
    alone.carry()
    assert lively.values["step"] == "predict"
    alone.page.get_by_role("button", name="Reset").click()
    alone.carry()
    assert lively.values == {"n": 10, "far": 1e3, "step": "predict", "band": True}
    assert alone.page.get_by_role("checkbox").is_checked()
    assert alone.is_right()
    alone.close()


# ---- the picture itself


def test_the_picture_is_taken_hold_of(alone):
    """The level goes up and down only; the point moves both sliders; both stop at the ends of the sliders."""
    level, height = alone.handle(0), 300 * (1 - 0.11 - 0.12)
    alone.drag(level, 50, -height / 12)
    assert alone.numbers()[0] == 1
    assert 0.9 < alone.numbers()[1] < 1.2
    assert alone.is_right()
    before = alone.numbers()
    alone.drag(alone.handle(1), 60, 20)
    after = alone.numbers()
    assert after[0] > before[0] + 5 and after[1] < before[1]
    alone.drag(alone.handle(1), 900, -600)
    assert alone.numbers() == [100, 2]
    assert alone.is_right()


def test_the_picture_follows_the_sliders_and_the_keys(alone):
    before = alone.handle(0).bounding_box()["y"]
    alone.slider(1).press("End")
    alone.carry()
    assert alone.handle(0).bounding_box()["y"] < before - 30
    assert "R 2" in alone.handle(0).get_attribute("aria-label")
    alone.handle(1).focus()
    for key in ("ArrowDown", "ArrowDown", "ArrowRight"):
        alone.page.keyboard.press(key)
        alone.carry()
    q, r = alone.numbers()
    assert r < 2 and q > 1
    alone.page.keyboard.press("Shift+ArrowRight")
    alone.carry()
    assert alone.numbers()[0] > q + 5
    assert alone.page.evaluate("document.activeElement.className").startswith("kf-handle")
    assert alone.is_right()


def test_quick_keys_on_a_handle_are_all_counted(alone):
    alone.handle(0).focus()
    for _ in range(10):
        alone.page.keyboard.press("ArrowUp")
    assert alone.page.evaluate("sent.length") == 2
    sent = alone.carry()
    assert sum(message["nudge"][2] for message in sent) == -10
    assert alone.is_right()
