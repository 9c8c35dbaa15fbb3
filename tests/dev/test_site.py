"""The web page of the course: built from three lessons, read as files, then used in a real browser.

`make site` sets KFLEARN_SITE to the folder of the page it has built: then all of that page is tested.
"""

import json
import re
import sys
from urllib.parse import unquote, urlsplit

import nbformat
import numpy as np
import pytest
from nbformat.v4 import new_markdown_cell, new_notebook

from dev.web import build, frames
from kflearn.ui import Playground, choice, log_slider, slider
from tests.dev.web import FUSION, LESSONS, VOLTMETER

pytestmark = pytest.mark.timeout(300)  # half a minute on an idle machine; less when the pictures are in build/frames


# ---- before anything is built


def test_a_missing_heading_is_told_in_one_sentence(tmp_path, monkeypatch):
    (notebooks := tmp_path / "notebooks").mkdir()
    (notebooks / "appendix.md").write_text("# Appendix\n", encoding="utf-8")
    assert build.without_heading(notebooks) == "" == build.without_heading(build.NOTEBOOKS)
    nbformat.write(new_notebook(cells=[new_markdown_cell("Mine")]), notebooks / "23-mine.ipynb")
    assert "notebooks/23-mine.ipynb needs a heading in its first cell" in build.without_heading(notebooks)
    (notebooks / "notice.md").write_text("No class on Friday.\n", encoding="utf-8")
    (notebooks / "23-mine.ipynb").unlink()
    monkeypatch.setattr(build, "NOTEBOOKS", notebooks)
    monkeypatch.setattr(sys, "argv", ["build.py"])
    with pytest.raises(SystemExit, match=r"^notebooks/notice.md needs a heading in its first line, such as: # News$"):
        build.main()


# ---- the pictures of a playground


def make(**controls):
    def draw(fig):
        return fig.subplots().plot([0, 1], [0, 1])[0]

    def update(line, **values):
        numbers = [len(value) if isinstance(value, str) else value for value in values.values()]
        line.set_ydata([0, sum(number * 0.1**i for i, number in enumerate(numbers))])
        return str(values)

    return Playground(draw, update, size=(2, 1), **controls)


def test_two_sliders_move_together():
    page, pictures = frames.film(make(a=slider(0.0, 1.0, 0.3), b=log_slider(0.1, 10, 1)), 121)
    assert page["together"]
    assert len(page["frames"]) == 121
    assert 100 < len(pictures) <= 121
    assert page["frames"]["0,10"][1] == "{'a': 0.0, 'b': 10.0}"
    assert page["controls"][1]["texts"][0] == "0.1"
    assert page["controls"][0]["texts"][page["start"][0]] == "0.3"


def test_many_sliders_move_one_at_a_time_and_buttons_with_each():
    playground = make(a=slider(0, 9, 2), b=slider(0, 5, 5), c=slider(0.0, 1.0, 0.5), d=choice(["x", "yy"]))
    page, _ = frames.film(playground, 61)
    assert not page["together"]
    places = [tuple(map(int, key.split(","))) for key in page["frames"]]
    away = [sum(place != start for place, start in zip(p[:3], page["start"], strict=False)) for p in places]
    assert max(away) == 1
    assert {p[3] for p in places} == {0, 1}
    assert 50 <= len(places) <= 61


@pytest.mark.parametrize(
    "control", [slider(1, 15, 1, step=2), slider(0.25, 2.5, 0.5, step=0.25), log_slider(1e-6, 1, 1e-4), slider(0, 1, 1)]
)
def test_places_of_a_slider_are_its_own(control):
    values = frames.spread(control, 7)
    assert {control.low, control.start, control.high} <= set(values)
    assert values == sorted(set(values))
    assert all(isinstance(value, control.number) for value in values)
    if not control.log:
        steps = (np.array(values) - control.low) / control.step
        assert np.allclose(steps, np.round(steps))


def test_too_many_bytes_make_fewer_pictures(tmp_path, monkeypatch):
    playground = make(a=slider(0.0, 1.0, 0.3), b=log_slider(0.1, 10, 1))
    _, pictures = frames.film(playground, 121)
    monkeypatch.setattr(frames, "BYTES", sum(map(len, pictures)) // 2)
    frames.record(playground, tmp_path / "0")
    assert 30 < len(list(tmp_path.glob("0/*.webp"))) < 61
    assert playground.values == {"a": 0.3, "b": 1}


# ---- the pages as files


def test_everything_referred_to_is_there(site, pages):
    assert set(pages) >= {"index.html", *LESSONS}
    for name, page in pages.items():
        for link in page.links + page.parts:
            where = urlsplit(link)
            if not where.scheme:
                target = unquote(where.path) or name
                assert (site / target).is_file(), f"{name} refers to {link}"
                if where.fragment and target.endswith(".html"):
                    assert where.fragment in pages[target].ids, f"{name} refers to {link}"


def test_nothing_is_loaded_from_elsewhere(site, pages):
    for name, page in pages.items():
        for part in page.parts:
            assert not urlsplit(part).scheme and not part.startswith("//"), f"{name} loads {part}"
    for style in site.rglob("*.css"):
        text = style.read_text(encoding="utf-8")
        for address in re.findall(r"url\(([^)]*)\)|@import\s+([^;]*);", text):
            assert not re.match(r"""["']?(https?:)?//""", "".join(address)), f"{style.name} loads {address}"


def test_pictures_have_words(pages):
    for name in LESSONS:
        assert len(pages[name].images) >= 4
        for image in pages[name].images:
            assert len(image.get("alt", "")) > 20, f"{name}: {image}"


def test_playgrounds_are_small(site):
    folders = {path.parent for path in site.glob("_static/frames/*/*/*.webp")}
    assert len(folders) >= len(LESSONS)
    for folder in folders:
        assert sum(path.stat().st_size for path in folder.iterdir()) <= 2_000_000


def test_formulas_and_references(site, pages):
    text = (site / FUSION).read_text(encoding="utf-8")
    assert text.count("<math") > 5
    assert not re.search(r"\$\$|\\frac", text)
    assert {"eq-10", "eq-14"} <= pages[FUSION].ids
    assert "#eq-12" in pages[FUSION].links
    assert FUSION in pages[VOLTMETER].links


def test_the_words_can_be_searched(site):
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    assert "innov" in index and "voltmet" in index


# ---- the pages in a browser


SEEN = """async figure => {
  const image = figure.querySelector('img');
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height});
  canvas.getContext('2d').drawImage(image, 0, 0);
  return [canvas.toDataURL(), image.src, image.alt, figure.querySelector('[role=status]').textContent];
}"""


def wait_for(figure, source):
    """Until a playground shows a picture."""
    image = figure.locator("img").element_handle()
    figure.page.wait_for_function("([image, source]) => image.src == source", arg=[image, source])


@pytest.mark.browser
def test_a_slider_moves_the_picture(tab):
    page = tab(VOLTMETER)
    figure = page.locator("figure.playground")
    first = figure.evaluate(SEEN)
    slider = figure.get_by_role("slider").first
    shown = figure.locator("output").first.inner_text()
    slider.press("ArrowRight")
    second = figure.evaluate(SEEN)
    assert all(before != after for before, after in zip(first, second, strict=True))
    assert figure.locator("output").first.inner_text() == slider.get_attribute("aria-valuetext") != shown
    second_slider = figure.get_by_role("slider").nth(1)
    second_slider.scroll_into_view_if_needed()
    box = second_slider.bounding_box()
    second_slider.click(position={"x": 0.9 * box["width"], "y": box["height"] / 2})
    third = figure.evaluate(SEEN)
    assert third[0] != second[0] and third[3] != second[3]
    figure.get_by_role("button", name="Reset").click()
    wait_for(figure, first[1])
    assert figure.evaluate(SEEN) == first


def moves(frames, index):
    """Whether a control changes the picture, at least with some of the buttons pressed."""
    pictures = {}
    for setting, (number, _) in frames.items():
        others = setting.split(",")
        del others[index]
        pictures.setdefault(tuple(others), set()).add(number)
    return max(map(len, pictures.values())) > 1


@pytest.mark.browser
@pytest.mark.parametrize("name", LESSONS)
def test_every_slider_moves_its_picture(tab, name):
    for figure in tab(name).locator("figure.playground").all():
        data = json.loads(figure.locator("script").text_content())
        first, fields = figure.evaluate(SEEN), figure.locator("form input[type=range], form fieldset").all()
        assert len(fields) == len(data["start"])
        for index, field in enumerate(fields):
            if field.get_attribute("type") != "range":
                continue
            pictures, numbers = set(), set()
            for key in ("Home", "End", "ArrowLeft"):
                field.press(key)
                setting = [*data["start"][:index], int(field.input_value()), *data["start"][index + 1 :]]
                number, sentence = data["frames"][",".join(map(str, setting))]
                picture, source, _, said = figure.evaluate(SEEN)
                assert said == sentence and source.endswith(f"/{number}.webp")
                pictures.add(picture)
                numbers.add(number)
            assert len(pictures) == len(numbers)
            assert moves(data["frames"], index), f"{field.get_attribute('aria-label')} moves nothing"
            figure.get_by_role("button", name="Reset").click()
            wait_for(figure, first[1])


@pytest.mark.browser
def test_a_slider_has_a_name(tab):
    sliders = tab(FUSION).locator("figure.playground").get_by_role("slider").all()
    assert [box.get_attribute("aria-label") for box in sliders] == ["sigma_x", "mu_z", "sigma_z"]


@pytest.mark.browser
def test_without_script_there_is_a_picture(tab):
    page = tab(VOLTMETER, java_script_enabled=False)
    assert page.locator("figure.playground img").bounding_box()["width"] > 600
    assert not page.locator("figure.playground form").is_visible()


@pytest.mark.browser
@pytest.mark.parametrize("name", ["index.html", *LESSONS, "teaching-guide.html", "appendix-errata-museum.html"])
def test_on_a_phone(tab, name):
    page = tab(name, width=390, has_touch=True)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    sizes = page.locator("article p, article li").evaluate_all(
        "all => all.filter(p => p.innerText).map(p => parseFloat(getComputedStyle(p).fontSize))"
    )
    assert min(sizes) >= 13
    code = page.locator("article pre").evaluate_all("all => all.map(p => parseFloat(getComputedStyle(p).fontSize))")
    assert min(code, default=11) >= 11
    for image in page.locator("article img").all():
        box = image.bounding_box()
        assert box["width"] > 250
        assert box["x"] + box["width"] <= 390
    for image in page.locator(".playground img").all():
        image.tap()
        assert image.bounding_box()["width"] == int(image.get_attribute("width")) >= 700
    assert page.evaluate("document.documentElement.scrollWidth") <= 390


@pytest.mark.browser
def test_search_finds(tab):
    page = tab("search.html?q=innovation")
    found = page.locator("#search-results li a")
    found.first.wait_for()
    page.wait_for_function(
        "() => document.querySelector('.search-summary, #search-results p')?.innerText.includes('found')"
    )
    assert any(FUSION in link.get_attribute("href") for link in found.all())
