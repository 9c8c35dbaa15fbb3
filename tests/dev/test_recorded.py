"""Playgrounds on the web page: what is recorded, how it is packed, and what a browser makes of it."""

import base64
import io
import json
import shutil

import nbformat
import numpy as np
import pytest
from PIL import Image

from dev.canvas import different
from dev.web import build, frames, named
from kflearn import plots
from kflearn.ui import Playground, choice, drag, log_slider, slider, toggle

pytestmark = pytest.mark.timeout(300)


def make(size=(2, 1), handles=(), **controls):
    """A playground whose picture and sentence depend on every control."""

    def draw(fig):
        ax = fig.subplots()
        ax.set(xlim=(0, 1), ylim=(0, 1))
        line = plots.truth(ax, [0, 1], [0, 1])
        return line, ax.plot([0.5], [0.5], "o")[0], ax.text(0.1, 0.8, "")

    def update(drawn, **values):
        numbers = [len(value) if isinstance(value, str) else value for value in values.values()]
        drawn[0].set([0, 1], [0, sum(number * 0.1**i for i, number in enumerate(numbers, 1))])
        drawn[1].set_data([numbers[0]], [numbers[1]])
        drawn[2].set_text(f"{numbers[0]:g}")
        return str(values)

    return Playground(draw, update, size=size, handles=handles, **controls)


# ---- which settings


def recording(count, *names, **controls):
    """What the page is told about a playground, and the recorded settings."""
    page, script = frames.recording(make(**controls), count, dict(names))
    return page, page["spec"]["controls"], script


def test_two_sliders_move_together():
    page, (a, b), _ = recording(121, a=slider(0.0, 1.0, 0.3), b=log_slider(0.1, 10, 1))
    assert page["together"] and page["settings"] == 121 == len(a["places"]) * len(b["places"])
    assert a["places"][page["start"][0]] == 0.3 and b["places"][page["start"][1]] == 1


def test_many_sliders_move_two_at_a_time_and_buttons_with_each():
    controls = dict(a=slider(0, 9, 2), b=slider(0, 5, 5), c=slider(0.0, 1.0, 0.5), d=choice(["x", "yy"]))
    page, told, _ = recording(60, **controls)
    assert not page["together"]
    start, stops = page["start"], [control["places"] for control in told]
    found = frames.settings(stops, start, [0, 1, 2], 2)
    assert len(found) == page["settings"] == len(set(found)) < 150
    assert {sum(place != start[i] for i, place in enumerate(setting[:3])) for setting in found} == {0, 1, 2}
    assert {setting[3] for setting in found} == {0, 1}


@pytest.mark.parametrize(
    "control", [slider(1, 15, 1, step=2), slider(0.25, 2.5, 0.5, step=0.25), log_slider(1e-6, 1, 1e-4), slider(0, 1, 1)]
)
def test_places_of_a_slider_are_its_own(control):
    values = frames.spread(control, 7)
    assert {control.low, control.start, control.high} <= set(values)
    assert values == sorted(set(values)) and 2 <= len(values) <= 7
    assert all(isinstance(value, control.number) for value in values)
    if not control.log:
        steps = (np.array(values) - control.low) / control.step
        assert np.allclose(steps, np.round(steps))


def test_wanted_values_take_the_place_of_others():
    control = log_slider(0.001, 1000, 4)
    values = frames.spread(control, 11, [0.01, 123.4])
    assert {0.001, 0.01, 4, 123.4, 1000} <= set(values) and len(values) == 11


def test_too_many_bytes_make_fewer_settings(tmp_path, monkeypatch):
    playground = make(a=slider(0.0, 1.0, 0.3), b=log_slider(0.1, 10, 1))
    monkeypatch.setattr(frames, "MOST", 400)
    _, script = frames.recording(playground, 400, {})
    monkeypatch.setattr(frames, "BYTES", len(script) * 2 // 3)
    frames.record(playground, tmp_path / "0")
    assert (tmp_path / "0" / "recorded.js").stat().st_size < frames.BYTES
    page = json.loads((tmp_path / "0" / "page.json").read_text())
    assert 50 < page["settings"] < 300 and page["status"] == "{'a': 0.3, 'b': 1.0}"
    assert playground.values == {"a": 0.3, "b": 1}


# ---- settings that a lesson names

TEXT = """Try three things. R to 100 and Q = R = 4, then the gate up to 3,000: see (9). A turn of 180° with a gauge
of 3°. Back to 0.25 (lesson 5), σ_a up to 1.5·10² m. [lesson 8](08-x.ipynb) has frames 18 to 21."""
CONTROLS = dict(
    Q=log_slider(0.1, 10, 1),
    R=log_slider(0.1, 1000, 1),
    gate=log_slider(10, 1e4, 100),
    turn=slider(0, 180, 90, unit="°"),
    noise=log_slider(0.1, 5, 1, unit="°"),
    sigma=log_slider(0.1, 200, 1, label=r"$\sigma_a$", unit="m"),
    frame=slider(15, 59, 25),
)


def test_the_settings_that_a_text_names():
    code = "dials = Playground(draw, update, **sliders)\ndials.gallery(dict(Q=0.5), some | dict(R=7))\nsome = dict(Q=2)"
    cells = [
        nbformat.v4.new_code_cell(code),
        nbformat.v4.new_markdown_cell("dials"),
        nbformat.v4.new_code_cell("dials"),
    ]
    cells += [nbformat.v4.new_markdown_cell(f"{TEXT}\n\n## Next\n\nQ to 0.3")]
    found = named.settings(make(**CONTROLS), cells, "dials")
    assert found["Q"] == [0.5, 2, 4]
    assert found["R"] == [0.25, 4, 7, 100]
    assert found["gate"] == [3000] and 180 in found["turn"] and 3 in found["noise"] and found["sigma"][-1] == 150
    assert found["frame"] == [18, 19, 20, 21]


# ---- in a browser


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    """The address of a page on the disk with a playground of which two sliders move at a time, and the playground."""
    folder, patch = tmp_path_factory.mktemp("own"), pytest.MonkeyPatch()
    controls = dict(a=slider(0.0, 1.0, 0.3), b=slider(0.0, 1.0, 0.6), c=slider(0.0, 1.0, 0.5), d=toggle(label="D"))
    playground = make((4, 2), handles=[drag("a", "b", label="the point")], **controls)
    patch.setattr(frames, "MOST", 120)
    frames.record(playground, folder / "_static/recorded/own/0", dict(a=[0.77]))
    patch.undo()
    shutil.copy(build.PACKAGE / "ui" / "playground.css", folder)
    (folder / "live.js").write_text(build.live_script(), encoding="utf-8")
    head = '<meta charset="utf-8"><link rel="stylesheet" href="playground.css"><script defer src="live.js"></script>'
    figure = build.figure(folder / "_static/recorded/own/0", "own/0")
    (folder / "page.html").write_text(f"<!doctype html>{head}{figure}", encoding="utf-8")
    return (folder / "page.html").as_uri(), playground


@pytest.fixture
def page(own, chromium):
    """The page opened from the disk, when its picture is there; nothing may go wrong in the browser."""
    troubles, page = [], chromium.new_page(viewport={"width": 900, "height": 700})
    page.on("console", lambda message: troubles.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.goto(own[0])
    page.wait_for_function("() => !document.querySelector('img')")
    yield page
    page.close()
    assert not troubles


def said(page, words):
    """Wait for a sentence."""
    wanted = "words => document.querySelector('.kf-sentence').textContent.includes(words)"
    page.wait_for_function(wanted, arg=words)


def numbers(page):
    return page.locator(".kf-box").evaluate_all("all => all.map(box => Number(box.value))")


def is_agg(page, playground, **values):
    """Is the canvas what matplotlib draws at a setting?"""
    bytes_ = base64.b64decode(page.evaluate("document.querySelector('canvas').toDataURL().split(',')[1]"))
    ours = np.asarray(Image.open(io.BytesIO(bytes_)).convert("RGB"))
    stage = playground._stage
    stage.show_at(frames.RATIO)
    playground.update(stage.artists, **playground.values | values)
    theirs = stage.pixels()[..., :3].copy()
    stage.show_at(1.0)
    return different(ours, theirs).mean() < 0.001


@pytest.mark.browser
def test_a_page_from_a_disk_is_live(own, page):
    assert numbers(page) == [0.3, 0.6, 0.5] and is_agg(page, own[1])
    page.get_by_role("slider").first.press("End")
    said(page, "'a': 1.0")
    assert numbers(page) == [1, 0.6, 0.5] and is_agg(page, own[1], a=1.0)
    page.get_by_role("checkbox").check()
    said(page, "'d': True")
    assert is_agg(page, own[1], a=1.0, d=True)
    page.get_by_role("button", name="Reset").click()
    said(page, "{'a': 0.3, 'b': 0.6, 'c': 0.5, 'd': False}")
    assert is_agg(page, own[1])


@pytest.mark.browser
def test_each_key_is_one_place_and_a_typed_number_goes_to_the_nearest(own, page):
    places = json.loads(page.locator("figure script").text_content())["spec"]["controls"][0]["places"]
    bar, box = page.get_by_role("slider").first, page.locator(".kf-box").first
    bar.press("Home")
    for place in places[1:]:
        bar.press("ArrowRight")
        said(page, f"'a': {place},")
    for typed, place in (("0.771", 0.77), ("0,29", 0.3), ("7", 1), ("0.77", 0.77)):
        box.fill(typed)
        box.press("Enter")
        said(page, f"'a': {float(place)},")
        assert numbers(page)[0] == place


@pytest.mark.browser
def test_the_slider_that_was_moved_longest_ago_goes_back(own, page):
    sliders = page.get_by_role("slider")
    assert "the one that was moved longest ago goes back" in page.locator("figcaption").inner_text()
    for i, told in ((0, [1, 0.6, 0.5]), (1, [1, 1, 0.5]), (2, [0.3, 1, 1]), (0, [1, 0.6, 1])):
        sliders.nth(i).press("End")
        page.wait_for_function(
            "told => [...document.querySelectorAll('.kf-box')].every((box, i) => box.value == told[i])", arg=told
        )
    assert is_agg(page, own[1], a=1.0, c=1.0)


@pytest.mark.browser
def test_what_is_dragged_goes_to_the_nearest_recorded_place(own, page):
    places = [
        control["places"] for control in json.loads(page.locator("figure script").text_content())["spec"]["controls"]
    ]
    page.get_by_role("slider").nth(2).press("End")
    said(page, "'c': 1.0")
    handle = page.locator(".kf-handle")
    box = handle.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 130, box["y"] - 40, steps=10)
    page.mouse.up()
    said(page, "'c': 0.5")
    a, b, _ = numbers(page)
    assert a in places[0] and b in places[1] and a > 0.4 and b > 0.7
    assert f"a {a:g}, b {b:g}" in handle.get_attribute("aria-label")
    assert is_agg(page, own[1], a=a, b=b)
    handle.press("ArrowLeft")
    page.wait_for_function(f"() => document.querySelector('.kf-box').value < {a}")
    assert numbers(page) == [places[0][places[0].index(a) - 1], b, 0.5]


@pytest.mark.browser
def test_an_old_browser_shows_the_picture(own, chromium):
    page = chromium.new_page()
    page.add_init_script("delete window.DecompressionStream")
    page.goto(own[0])
    assert page.locator("figure img").is_visible() and page.locator(".kf-sentence").inner_text() == own[1].status
    assert page.locator("input, button").count() == 0
    page.close()
