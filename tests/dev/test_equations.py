"""Equations by their names: the table, the page made of it, and a search that leads to where they are derived."""

import json
import re
from collections import Counter

import nbformat
import pytest
from nbformat.v4 import new_markdown_cell

from dev.lessons import lessons
from dev.web import equations
from tests.dev.web import FUSION, LESSONS

pytestmark = pytest.mark.timeout(300)
TABLE, CELLS = equations.table(), {path.name[:2]: nbformat.read(path, as_version=4).cells for path in lessons()}
TEXTS = [cell.source for cells in CELLS.values() for cell in cells if cell.cell_type == "markdown"]
PLACES = {page[:2]: page.removesuffix(".html") for page in LESSONS}


# ---- the table


def test_every_line_of_the_table_is_read():
    lines = [line for line in equations.TABLE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    assert len(TABLE) == len([line for line in lines if not line.startswith("| names")]) > 80
    assert len({each.label + each.formula for each in TABLE}) == len(TABLE)


def test_every_number_of_the_course_is_in_it_once():
    numbers = {number.replace(r"\mathrm ", "") for text in TEXTS for number in re.findall(r"quad\((\d+.*?)\)", text)}
    assert Counter(each.number for each in TABLE if each.number) == Counter(numbers)
    assert {"1", "7", "9J", "14"} <= numbers


@pytest.mark.parametrize("each", TABLE, ids=lambda each: each.label)
def test_a_name_leads_to_the_cell_that_has_the_formula(each):
    near = [i for i, cell in enumerate(CELLS[each.lesson]) if cell.id == each.cell]
    assert len(near) == 1 and CELLS[each.lesson][near[0]].cell_type == "markdown"
    beside = [cell.source for cell in CELLS[each.lesson][near[0] - 2 : near[0] + 2] if cell.cell_type == "markdown"]
    for formula in re.findall(r"\$(.+?)\$", each.formula) or [each.formula]:
        numbered = re.escape(formula) + r"[,.\s]*(\\q?quad\s*)+\(" + each.number  # where the number stands
        assert any(formula in text for text in beside) or (each.number and any(re.search(numbered, t) for t in TEXTS))


def test_no_name_leads_to_two_places():
    owners = Counter(word for word, _ in {(word, each.label) for each in TABLE for word in equations.words(each)})
    both = {word for word, count in owners.items() if count > 1}
    assert both == {"chapman", "kolmogorov"}  # for Gaussians, and for modes


def test_the_ways_to_ask_for_an_equation():
    gain = next(each for each in TABLE if each.number == "7")
    assert {"kalman gain", "(7)", "equation 7", "equation (7)", "eq. 7"} <= equations.words(gain)
    assert {"cramer-rao bound", "cramér–rao bound", "cramer rao bound"} <= {*equations.spellings("cramér–rao bound")}
    assert "normalized innovation squared" in {*equations.spellings("normalised innovation squared")}
    assert "bayes rule" in {*equations.spellings("bayes' rule")}


def test_a_mark_stands_under_the_last_heading():
    cells = [new_markdown_cell("## One\n\ntext\n\n## Two\n\nderived", id="fus-square"), new_markdown_cell("x", id="y")]
    equations.mark(cells, "04")
    assert cells[0].source == "## One\n\ntext\n\n## Two\n\n(eq-04-fus-square)=\nderived" and cells[1].source == "x"
    cells = [new_markdown_cell("derived", id="fus-square")]
    equations.mark(cells, "04")
    assert cells[0].source == "(eq-04-fus-square)=\nderived"


def test_the_page_names_lessons_that_are_not_built_without_a_link():
    text = equations.page([path for path in lessons() if path.name[:2] == "04"])
    assert "{ref}`4 · For any matrices <eq-04-fus-square>`" in text
    assert "| lesson 12 |" in text and "{ref}`12" not in text


# ---- the page and the search


def test_the_page_leads_to_every_place(site, pages):
    wanted = {f"{PLACES[each.lesson]}.html#{each.label}" for each in TABLE if each.lesson in PLACES}
    assert len(wanted) >= 8 and wanted <= set(pages["equations.html"].links)
    for link in wanted:
        page, _, label = link.partition("#")
        assert label in pages[page].ids
    assert "equations.html" in pages[FUSION].links  # in the navigation


def test_the_index_leads_from_every_name_to_its_place(site):
    index = json.loads((site / "searchindex.js").read_text(encoding="utf-8")[len("Search.setIndex(") : -1])
    for each in TABLE:
        for word in equations.words(each) if each.lesson in PLACES else ():
            found = [[index["docnames"][page], place, main] for page, place, main in index["indexentries"][word]]
            assert [PLACES[each.lesson], each.label, True] in found, word


FIRST = """query => {
  history.replaceState(null, "", "?q=" + encodeURIComponent(query));
  return (Search._performSearch(...Search._parseQuery(query)).at(-1) || []).slice(0, 3);
}"""
ASKED = {  # what readers type → the lessons where it is derived
    "Kalman gain": "04",
    "kalman gain ": "04",
    "equation 7": "04",
    "(7)": "04",
    "Eq. (10)": "04",
    "innovation covariance": "05",
    "Joseph": "12",
    "Joseph form": "12",
    "(9J)": "12",
    "predicted covariance": "03",
    "Chapman": "18 03",
    "RTS": "23",
    "Rauch-Tung-Striebel smoother": "23",
    "Cramer-Rao bound": "15",
    "MMSE gain": "04",
}


@pytest.mark.browser
def test_what_is_typed_finds_the_derivation_first(tab):
    page = tab("search.html?q=gain")
    page.wait_for_function("() => Search.hasIndex()")
    places = {}
    for each in TABLE:
        for word in equations.words(each) if each.lesson in PLACES else ():
            places.setdefault(word, []).append((PLACES[each.lesson], f"#{each.label}"))
    found = {word: page.evaluate(FIRST, word) for word in places}
    assert not {word: place for word, place in found.items() if (place[0], place[2]) not in places[word]}
    for query, numbers in ASKED.items():
        there = [number for number in numbers.split() if number in PLACES]
        assert not there or page.evaluate(FIRST, query)[0].startswith(there[0]), query


@pytest.mark.browser
def test_a_reader_lands_at_the_derivation(tab):
    page = tab("index.html")
    page.locator("input[name=q]").first.fill("(10)")
    page.locator("input[name=q]").first.press("Enter")
    first = page.locator("#search-results li a").first
    first.wait_for()
    page.wait_for_function("() => document.querySelector('#search-results .context')")
    first.click()
    page.wait_for_url(f"**/{FUSION}#eq-04-cell-16a")
    in_sight = "() => { const { y } = document.querySelector('%s').getBoundingClientRect(); return 0 < y && y < 850 }"
    for place in ("#the-algebra-once h2", "#eq-10"):
        page.wait_for_function(in_sight % place)


# ---- a glance


@pytest.mark.browser
def test_a_number_shows_its_equation_under_the_mouse(tab):
    page = tab(FUSION)
    link = page.locator("article p > a[href='#eq-12']").first
    glance = link.locator(".glance")
    assert not glance.is_visible() and link.inner_text() == "(12)"
    link.hover()
    assert glance.is_visible() and glance.locator("mfrac").count() == 1
    box, width = glance.bounding_box(), page.evaluate("document.documentElement.clientWidth")
    assert box["x"] > 0 and box["x"] + box["width"] < width and box["y"] > link.bounding_box()["y"]
    page.mouse.move(0, 0)
    assert not glance.is_visible()
    link.focus()
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Tab")
    assert glance.is_visible()
