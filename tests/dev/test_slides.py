"""Slides: what stands on them, and that every one fits a projector of 1280 × 720."""

import re
import subprocess
import sys

import nbformat
import pytest

from dev.lab import CHROMIUM, browser
from dev.lessons import lessons
from dev.teaching import slides

LESSONS = lessons()
per_lesson = pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)

MEASURE = """() => Reveal.getSlides().map(slide => {
  const {h, v} = Reveal.getIndices(slide);
  Reveal.slide(h, v);
  const lines = [...slide.querySelectorAll("pre")], boxes = [...slide.querySelectorAll("pre, img, table, math")];
  return {
    words: slide.innerText.slice(0, 60), high: slide.scrollHeight, shrunk: slide.style.zoom != "",
    wide: Math.max(slide.scrollWidth, ...boxes.map(box => box.getBoundingClientRect().right)),
    cut: lines.some(box => getComputedStyle(box).whiteSpace != "pre" || box.scrollWidth > box.clientWidth),
  };
})"""


def load(path):
    return nbformat.read(path, as_version=4)


def test_slides_are_built(tmp_path):
    command = [sys.executable, "-m", "dev.teaching.slides", "04", "--out", tmp_path]
    subprocess.run(command, check=True, capture_output=True)
    page = (tmp_path / "04.slides.html").read_text(encoding="utf-8")
    assert "<title>4 · Two opinions, one belief</title>" in page
    assert 15 <= page.count("<section") <= 60
    assert page.count("data:image/png") + page.count("image/png;base64") >= 6
    assert "third_opinion" not in page, "the exercises stay in the notebook"
    assert not re.search(r'(src|href)="https?:', page), "nothing is loaded from a network"
    assert "<math" in page and "Reveal.initialize" in page
    assert ".ipynb" not in page, "there is no lesson beside the slides"
    assert "Continue in the notebook <strong>04-gaussian-fusion</strong>" in page


@per_lesson
def test_each_piece_has_its_place(path):
    pieces = list(slides.pieces(load(path)))
    pages = slides.pages(pieces)
    assert [piece for page in pages for piece in page] == pieces, "nothing is lost"
    assert all(sum(piece.height for piece in page) <= slides.ROOM for page in pages)
    assert not any(piece.begins for page in pages for piece in page[1:]), "a heading begins a slide"
    assert not any("stored from an earlier run. Run" in piece.cell.source for piece in pieces)
    text = " ".join(piece.cell.source for piece in pieces if piece.cell.cell_type == "markdown")
    assert not re.search(r"Now you; press|Now move|Tab to a slider|(Then t|T)ry three", text), "slides have no sliders"


@per_lesson
def test_a_picture_takes_the_room_that_is_left(path):
    for page in slides.pages(list(slides.pieces(load(path)))):
        slides.enlarge(page)
        outputs = [output for piece in page for output in piece.cell.get("outputs", []) if slides.picture(output)]
        others = sum(piece.height for piece in page if not any(map(slides.picture, piece.cell.get("outputs", []))))
        sizes = [output.metadata["image/png"] for output in outputs]
        assert others + sum(20 + size["height"] for size in sizes) <= slides.ROOM + 1
        assert all(size["width"] <= slides.WIDE for size in sizes)


@pytest.mark.browser
@pytest.mark.timeout(240)  # half a minute on an idle machine
@pytest.mark.skipif(not CHROMIUM, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_every_slide_fits_a_projector(tmp_path):
    found = []
    with browser() as chromium:
        screen = chromium.new_page(viewport={"width": 1280, "height": 720})
        for path in LESSONS:
            page = tmp_path / f"{path.stem}.html"
            page.write_text(slides.slides(path), encoding="utf-8")
            screen.goto(page.as_uri())
            screen.wait_for_function("() => Reveal.isReady()")
            found += [{"lesson": path.stem, "slide": i + 1} | one for i, one in enumerate(screen.evaluate(MEASURE))]
    assert len(found) > 500
    assert not [one for one in found if one["high"] > 720 or one["wide"] > 1280 or one["cut"] or one["shrunk"]]
