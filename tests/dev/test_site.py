"""The web page of the course: built from three lessons, read as files, then used in a real browser.

`make site` sets KFLEARN_SITE to the folder of the page it has built: then all of that page is tested.
"""

import re
import sys
from urllib.parse import unquote, urlsplit

import nbformat
import pytest
from nbformat.v4 import new_markdown_cell, new_notebook

from dev.web import build
from tests.dev.web import FUSION, LESSONS, VOLTMETER

pytestmark = pytest.mark.timeout(300)  # a minute on an idle machine; less when the recordings are in build/frames


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
            is_here = urlsplit(part).scheme in ("", "data") and not part.startswith("//")
            assert is_here, f"{name} loads {part}"
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
    recorded = list(site.glob("_static/recorded/*/*/recorded.js"))
    assert len(recorded) >= len(LESSONS)
    for path in recorded:
        assert path.stat().st_size <= 1_000_000
        assert path.with_name("start.webp").stat().st_size <= 100_000


def test_recordings_are_where_the_pages_look_for_them(site):
    for name in ("index.html", *LESSONS):
        places = re.findall(r'data-recorded="(.*?)"', (site / name).read_text(encoding="utf-8"))
        assert places and all((site / place).is_file() for place in places), name


def test_a_page_without_playground_loads_nothing_for_one(pages):
    parts = {part.split("?")[0] for part in pages["appendix-glossary.html"].parts}
    assert "_static/reach.js" in parts and not parts & {"_static/recorded.js", "_static/playground.css"}


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


SEEN = """figure => [figure.querySelector('canvas').toDataURL(), figure.querySelector('.kf-sentence').textContent]"""


def live(tab, number=0):
    """A playground of a page when its picture is there."""
    figure = tab.locator("figure.playground").nth(number)
    figure.scroll_into_view_if_needed()
    figure.locator("img").wait_for(state="detached")
    return figure


def change(figure, act, *how, **options):
    """Do something, and wait until the picture has come."""
    figure.evaluate(
        "figure => { figure.came = false; figure.addEventListener('kf-picture', () => figure.came = true) }"
    )
    act(*how, **options)
    figure.page.wait_for_function("figure => figure.came", arg=figure.element_handle())
    return figure.evaluate(SEEN)


def at_both_ends(figure, slider):
    """The pictures at a slider's ends."""
    keys = ["End"] if slider.input_value() == slider.get_attribute("min") else ["Home", "End"]
    return {change(figure, slider.press, key)[0] for key in keys}


@pytest.mark.browser
def test_a_slider_moves_the_picture(tab):
    figure = live(tab(VOLTMETER))
    first, slider = figure.evaluate(SEEN), figure.get_by_role("slider").first
    box = figure.locator(".kf-box").first
    shown = box.input_value()
    second = change(figure, slider.press, "ArrowRight")
    assert all(before != after for before, after in zip(first, second, strict=True))
    assert f"{box.input_value()} V²" == slider.get_attribute("aria-valuetext") != f"{shown} V²"
    size = figure.get_by_role("slider").nth(1).bounding_box()
    place = {"x": 0.9 * size["width"], "y": size["height"] / 2}
    third = change(figure, figure.get_by_role("slider").nth(1).click, position=place)
    assert third[0] != second[0] and third[1] != second[1]
    assert change(figure, figure.get_by_role("button", name="Reset").click) == first


@pytest.mark.browser
def test_a_playground_is_loaded_when_it_comes_into_view(tab):
    page = tab(VOLTMETER)
    assert page.locator("figure img").count() == 1 and page.locator("script[src*='/recorded/']").count() == 0
    page.wait_for_timeout(2000)
    assert [box.input_value() for box in page.locator("figure .kf-box").all()] == ["4", "4"]
    assert "steady gain" in page.locator("figure .kf-sentence").text_content()
    figure = live(page)
    assert page.locator("script[src*='/recorded/']").count() == 1
    page.wait_for_timeout(2000)
    assert "steady gain" in figure.locator(".kf-sentence").text_content()


@pytest.mark.browser
@pytest.mark.parametrize("name", LESSONS)
def test_every_slider_moves_its_picture(tab, name):
    page = tab(name)
    for number in range(page.locator("figure.playground").count()):
        figure = live(page, number)
        first = figure.evaluate(SEEN)
        for slider in figure.get_by_role("slider").all():
            seen = {first[0]} | at_both_ends(figure, slider)
            for button in figure.locator("input[type=radio], input[type=checkbox]").all():
                if len(seen) == 1 and not button.is_checked():  # some sliders need a button
                    seen = {change(figure, button.click)[0]} | at_both_ends(figure, slider)
            assert len(seen) > 1, f"{slider.get_attribute('aria-label')} moves nothing"
            assert change(figure, figure.get_by_role("button", name="Reset").click) == first


@pytest.mark.browser
def test_a_slider_has_a_name(tab):
    sliders = tab(FUSION).locator("figure.playground").get_by_role("slider").all()
    assert [box.get_attribute("aria-label") for box in sliders] == ["sigma x", "mu z", "sigma z"]


@pytest.mark.browser
def test_without_script_there_is_a_picture(tab):
    page = tab(VOLTMETER, java_script_enabled=False)
    assert page.locator("figure.playground img").bounding_box()["width"] > 600
    assert "steady gain" in page.locator("figure.playground .kf-sentence").inner_text()
    assert page.locator("figure.playground input").count() == 0


@pytest.mark.browser
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_controls_can_be_read_in_both_themes(tab, scheme):
    box = live(tab(VOLTMETER, color_scheme=scheme)).locator(".kf-box").first
    ink, paper = (box.evaluate(f"box => getComputedStyle(box).{what}") for what in ("color", "backgroundColor"))
    light, dark = (sum(map(int, re.findall(r"\d+", colour)[:3])) for colour in (ink, paper))
    assert abs(light - dark) > 400 and (light > dark) == (scheme == "dark")


@pytest.mark.browser
@pytest.mark.parametrize("width", [360, 390])
@pytest.mark.parametrize("name", ["index.html", *LESSONS, "teaching-guide.html", "appendix-errata-museum.html"])
def test_on_a_phone(tab, name, width):
    page = tab(name, width=width, has_touch=True)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    sizes = page.locator("article p, article li").evaluate_all(
        "all => all.filter(p => p.innerText).map(p => parseFloat(getComputedStyle(p).fontSize))"
    )
    assert min(sizes) >= 13
    code = page.locator("article pre").evaluate_all("all => all.map(p => parseFloat(getComputedStyle(p).fontSize))")
    assert min(code, default=11) >= 11
    figures = [live(page, number) for number in range(page.locator("figure.playground").count())]
    for image in page.locator("article :is(img, canvas, input, button:not(.kf-handle))").all():
        box = image.bounding_box()
        assert box["width"] > 250 or image.evaluate("image => !['IMG', 'CANVAS'].includes(image.tagName)")
        assert box["x"] + box["width"] <= width
    for figure in figures:
        canvas = figure.locator("canvas")
        canvas.tap(position={"x": 5, "y": 5})
        assert 2 * canvas.bounding_box()["width"] == canvas.evaluate("canvas => canvas.width") >= 1400
    assert page.evaluate("document.documentElement.scrollWidth") <= width


@pytest.mark.browser
def test_search_finds(tab):
    page = tab("search.html?q=innovation")
    found = page.locator("#search-results li a")
    found.first.wait_for()
    page.wait_for_function(
        "() => document.querySelector('.search-summary, #search-results p')?.innerText.includes('found')"
    )
    assert any(FUSION in link.get_attribute("href") for link in found.all())
