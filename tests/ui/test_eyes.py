"""What is seen and heard: sharp at each ratio, names for screen readers, dark theme, room, axe-core."""

import json
import re

import pytest

from dev import axe
from kflearn.ui import choice, drag, log_slider, slider, toggle
from tests.ui.alone import Alone
from tests.ui.samples import make, update

pytestmark = pytest.mark.browser


def everything(ratio=1, chromium=None, **how):
    """A playground with each kind of control."""
    lively = make(
        lambda live, Q, R, **others: update(live, Q, R),
        handles=[drag(y="R", label="the level")],
        Q=log_slider(0.01, 100, 1, label=r"$\sigma_x^2$", unit="V²"),
        R=slider(0.0, 2.0, 0.5),
        step=choice(["predict", "measure", "correct"], label="the step"),
        band=toggle(True, label="show the band"),
    )
    return Alone(chromium, lively, ratio=ratio, **how)


@pytest.mark.parametrize("ratio", [1, 1.5, 2])
def test_the_canvas_is_as_fine_as_the_screen(chromium, ratio):
    alone = everything(ratio, chromium)
    canvas = alone.page.locator(".kf-picture canvas")
    box = canvas.bounding_box()
    assert (box["width"], box["height"]) == (600, 300)
    assert canvas.evaluate("canvas => [canvas.width, canvas.height]") == [600 * ratio, 300 * ratio]
    level = alone.handle().bounding_box()
    alone.drag(alone.handle(), 0, -30)
    assert alone.handle().bounding_box()["y"] == pytest.approx(level["y"] - 30, abs=1.5)
    assert alone.is_right()
    alone.close()


def test_a_window_moved_to_a_finer_screen(chromium):
    alone = everything(1, chromium)
    tape = alone.page.context.new_cdp_session(alone.page)
    for ratio, width in ((2, 900), (1, 1000)):  # Chromium tells of another ratio only when the size is another
        screen = dict(width=width, height=800, mobile=False, deviceScaleFactor=ratio)
        tape.send("Emulation.setDeviceMetricsOverride", screen)
        alone.page.wait_for_function("() => sent.length == 1")
        alone.carry()
        assert alone.page.locator(".kf-picture canvas").evaluate("canvas => canvas.width") == 600 * ratio
        assert alone.is_right()
    alone.close()


def test_two_screens_show_one_playground(chromium):
    """The finer of the two decides, and neither stands still."""
    lively = make()
    fine = Alone(chromium, lively, ratio=2)
    hear, lively.widget.send = lively.widget.send, lambda *message: None
    coarse = Alone(chromium, lively, ratio=1)
    lively.widget.send = lambda *message: (hear(*message), coarse.hear(*message))
    coarse.slider().press("End")
    coarse.carry()
    assert fine.numbers() == coarse.numbers() == [100, 0.5]
    assert fine.picture() == coarse.picture()
    fine.close()
    coarse.close()


def test_names_values_and_units_for_who_does_not_see(chromium):
    alone = everything(1, chromium)
    bar = alone.page.get_by_role("slider", name="sigma x^2")
    assert bar.get_attribute("aria-valuetext") == "1 V²"
    bar.press("PageUp")
    alone.carry()
    assert bar.get_attribute("aria-valuetext") == "2.51 V²"
    alone.page.get_by_role("textbox", name="sigma x^2").wait_for()
    alone.page.get_by_role("radiogroup", name="the step").get_by_role("radio", name="measure").wait_for()
    alone.page.get_by_role("checkbox", name="show the band").wait_for()
    alone.page.get_by_role("button", name="the level: R 0.5; arrow keys move it").wait_for()
    said = alone.page.get_by_role("img").first.get_attribute("aria-label")
    assert said.startswith("Playground: Q from 0.01 to 100 V²") and said.endswith("Q = 2.51, R = 0.5")
    alone.page.wait_for_function("document.querySelector('[role=status]').textContent.startsWith('Q = 2.51')")
    assert alone.page.locator("[role=status]").get_attribute("aria-live") == "polite"
    alone.close()


def test_focus_goes_round_and_is_seen(chromium):
    alone = everything(1, chromium)
    seen = []
    for _ in range(8):
        alone.page.keyboard.press("Tab")
        seen.append(
            alone.page.evaluate("""() => {
              const at = document.activeElement, shown = at.type == "radio" ? at.nextElementSibling : at;
              return [at.type, getComputedStyle(shown).outlineStyle];
            }""")
        )
    assert [kind for kind, _ in seen] == ["text", "range", "text", "range", "radio", "checkbox", "button", "button"]
    assert {style for _, style in seen} == {"solid"}
    alone.close()


@pytest.mark.parametrize("width", [1000, 420])
def test_all_fits_on_the_screen(chromium, width):
    alone = everything(1, chromium, viewport=dict(width=width, height=700))
    assert alone.page.evaluate("document.documentElement.scrollWidth <= innerWidth"), "it scrolls sideways"
    assert alone.page.locator(".kf-playground").bounding_box()["height"] <= 600
    alone.close()


DARK = """body { background: #111 }
:root { --jp-content-font-color1: #fff; --jp-layout-color1: #111; --jp-border-color0: #bbb }"""


@pytest.mark.parametrize("theme", ["body { background: #fff }", DARK], ids=["light", "dark"])
def test_axe_finds_no_serious_fault(chromium, theme):
    if not axe.source():
        pytest.skip("axe-core is neither in build/axe nor to be had from npm")
    alone = everything(1, chromium)
    alone.page.add_style_tag(content=theme)
    assert axe.faults(alone.page) == []
    alone.slider(0).focus()
    alone.page.get_by_role("radio", name="measure").check()
    alone.carry()
    assert axe.faults(alone.page) == []
    alone.page.evaluate("document.querySelector('[type=range]').removeAttribute('aria-label')")
    assert re.search("label|name", json.dumps(axe.faults(alone.page))), "axe sees when a name is missing"
    alone.close()
