"""The pages on the package, and hints and solutions for readers without a kernel."""

import re

import nbformat
import pytest

import kflearn
from dev.lessons import lessons
from dev.web import about, api, help
from dev.web.build import ROOT, contents


def test_every_public_name_has_one_entry():
    text = "\n".join(api.pages(lessons()).values())
    found = re.findall(r"(?m)^## (\w+)$", text)
    assert sorted({*kflearn.__all__, *api.EXTRA["ui"]} - {"FILTERS"}) == sorted(found)


def test_an_entry_names_the_lessons_that_use_it():
    pages = api.pages(lessons())
    entry = re.search(r"(?s)## disturbances\n(.*?)(\n## |$)", pages["api-filters.md"])[1]
    assert entry.count("](24-let-the-data-choose.ipynb)") == 1 and "04-gaussian" not in entry
    assert "{py:obj}`fit <kflearn.fit>`" in api.names_of(next(p for p in lessons() if p.name[:2] == "24"))


def test_all_filters_stand_in_the_table():
    table = [line for line in api.pages([])["api.md"].splitlines() if line.startswith("| {")]
    assert len(table) == len(kflearn.FILTERS)
    assert any("kalman_filter" in line and "| linear |" in line and line.endswith("| yes |") for line in table)


@pytest.mark.parametrize("path", lessons(), ids=lambda path: path.stem)
def test_each_exercise_is_followed_by_its_help(path):
    cells = help.with_help(nbformat.read(path, as_version=4).cells)
    asked = [
        i
        for i, cell in enumerate(cells)
        if cell.cell_type == "code" and re.search(r"(?m)^exercises\.\w+\.check\(", cell.source)
    ]
    assert asked
    for i in asked:
        text = cells[i + 1].source
        assert text.startswith('<div class="help">') and text.count("<summary>Hint ") >= 2
        name = re.search(r"exercises\.(\w+)\.check", cells[i].source)[1]
        assert f"exercises.{name}.check(" in text


def test_code_in_hints_and_solutions_is_safe_in_a_page():
    assert help.in_words("if `a < b`, b > a") == "if <code>a &lt; b</code>, b &gt; a"


def test_lessons_stand_in_parts():
    text = contents(["00-a.ipynb", "08-b.ipynb", "23-c.ipynb", "api.md", "appendix-d.md"])
    assert re.findall(r":caption: (.*)\n(.*)", text) == [
        ("Foundations", "00-a.ipynb"),
        ("Practice", "08-b.ipynb"),
        ("All the data", "23-c.ipynb"),
        ("The package", "api.md"),
        ("To look up", "appendix-d.md"),
    ]


def test_how_to_cite():
    text = about.citation(ROOT)
    assert f"version = {{{kflearn.__version__}}}" in text and "# Cite this course" in text
