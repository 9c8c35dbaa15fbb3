"""The appendices keep their promises: links, completeness, and numbers that the lessons really print."""

import re
from itertools import pairwise
from pathlib import Path
from urllib.parse import urlparse

import nbformat
import numpy as np
import pytest

from kflearn import Gaussian, correct, kalman_filter, predict, random_walk, start_from

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
NAMES = ("notation", "glossary", "errata-museum", "cheat-sheet", "recordings", "loggers", "libraries")
per_page = pytest.mark.parametrize("name", NAMES)

LINK = r"\]\(([^)\s]+)\)"
QUOTED = r"`([^`]+)`"
HAN = r"[\u4e00-\u9fff]"
NUMBERS = [*map(str, [*range(1, 47), *range(48, 52)]), *(f"E{k}" for k in range(1, 8))]


def read(name):
    return (NOTEBOOKS / f"appendix-{name}.md").read_text(encoding="utf-8")


def prose(text):
    """The text without its blocks of code."""
    return re.sub(r"(?ms)^```.*?^```$", "", text)


def table(text):
    """The rows of the tables, without heads and rules, as lists of cells."""
    rows = re.findall(r"(?m)^\| (.*) \|$", re.sub(r"(?m)^\|.*\|\n(?=\|---)", "", text))
    return [re.split(r"(?<!\\) \| ", row) for row in rows]


def exhibits():
    """What hangs in the museum: heading → text."""
    parts = re.split(r"(?m)^#{2,3} (.*)\n", read("errata-museum"))
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def numbered():
    """The numbered exhibits: number → text."""
    found = [(heading.partition(" · "), text) for heading, text in exhibits().items() if " · " in heading]
    numbers = [number for (number, _, _), _ in found]
    assert len(set(numbers)) == len(numbers)
    return {number: text for (number, _, _), text in found}


def lessons(text):
    return [link for link in re.findall(LINK, text) if re.match(r"\d\d-", link)]


def printed(link):
    """Everything that a lesson's stored outputs say."""
    cells = nbformat.read(NOTEBOOKS / link, as_version=4).cells
    outputs = [output for cell in cells if cell.cell_type == "code" for output in cell.outputs]
    return "\n".join(output.get("text") or output.get("data", {}).get("text/plain", "") for output in outputs)


def says(text, number):
    """Is the number in the text, and not as a part of a longer one?"""
    before, after = (r"(?<![\d.,])" if number[0].isdigit() else ""), (r"(?!\d|\.\d)" if number[-1].isdigit() else "")
    return re.search(before + re.escape(number) + after, text) is not None


# ---- all of them


@per_page
def test_links_lead_somewhere(name):
    links = re.findall(LINK, prose(read(name)))
    assert links
    for link in links:
        assert not urlparse(link).scheme, f"{link}: pages of the course only"
        assert (NOTEBOOKS / link.partition("#")[0]).is_file(), link


@per_page
def test_they_know_each_other(name):
    assert {f"appendix-{other}.md" for other in NAMES if other != name} <= set(re.findall(LINK, read(name)))


@per_page
def test_markdown_is_sound(name):
    text = prose(read(name))
    assert "!" not in text.replace("![", "")
    assert not re.search(r"/(home|root|work|tmp|Users)/|https?:", text)
    assert text.count("$") % 2 == 0
    levels = [len(marks) for marks in re.findall(r"(?m)^(#+) ", text)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    for block in re.findall(r"(?m)(?:^\|.*\|\n)+", text):
        columns = {len(re.findall(r"(?<!\\)\|", line)) for line in block.splitlines()}
        assert len(columns) == 1, block.splitlines()[0]


# ---- notation


def test_every_equation_is_written_out():
    blocks = "".join(re.findall(r"(?s)\$\$.*?\$\$", read("notation")))
    numbers = re.findall(r"\\quad\((\d+|9\\mathrm J)\)", blocks)
    assert numbers == [*map(str, range(1, 15)), r"9\mathrm J"]


def test_every_symbol_says_where_it_comes_first():
    for row in table(read("notation").partition("## The symbols")[2].partition("## What books")[0]):
        assert len(row) in (4, 5)
        assert lessons(row[-1]), row[0]


def test_the_two_starts():
    """What the text says of a random walk with Q = R = 1, told N(0, 1), that reads 2."""
    model, told = random_walk(1, 1), Gaussian(0, 1)
    before, at = kalman_filter(model, [2.0], told), correct(model, told, [2.0])
    assert f"N({before.mean[0, 0]:.2f}, {before.cov[0, 0, 0]:.2f})" in read("notation")
    assert f"N({at.mean[0]:g}, {at.cov[0, 0]:g})" in read("notation")
    z = np.array([2.0, 1.0, 3.0])
    first = correct(model, predict(model, told), z[:1])
    assert np.allclose(kalman_filter(model, z[1:], first).mean, kalman_filter(model, z, told).mean[1:])
    assert np.allclose(start_from(model, z[0]).cov, model.R)


# ---- glossary


def test_glossary():
    rows = table(read("glossary"))
    assert 90 <= len(rows) <= 135  # five a lesson
    terms = ["".join(filter(str.isalnum, english.casefold())) for english, *_ in rows]
    assert terms == sorted(terms)
    assert len(set(terms)) == len(terms)
    for english, chinese, meaning, lesson in rows:
        assert re.search(HAN, chinese), english
        assert not re.search(HAN, english + meaning), english
        assert len(meaning.split()) >= 3, english
        assert lessons(lesson), english
        assert [f"{int(link[:2])}" for link in lessons(lesson)] == re.findall(r"\[(\d+)\]", lesson), english


GENERAL = """data equation error estimate filter matrix method model noise order point process state system test two
walk"""


def stems(english):
    """The beginnings of a term's own words: of "whiteness test" only "white"; all of them if each is general."""
    words = re.findall(r"[a-zé]+", english.lower())
    own = [word for word in words if word not in GENERAL.split() and len(word) > 2] or words
    return [word[: max(4, len(word) - 4)] for word in own]


def said(name):
    """What a lesson says, in small letters."""
    cells = nbformat.read(NOTEBOOKS / name, as_version=4).cells
    return "\n".join(cell.source for cell in cells if cell.cell_type == "markdown").lower()


def test_what_the_glossary_names_occurs_in_its_lessons():
    missing = [
        (english, name)
        for english, _, _, lesson in table(read("glossary"))
        for name in lessons(lesson)
        if not any(stem in said(name) for stem in stems(english))
    ]
    assert not missing


# ---- the errata museum


def test_every_erratum_hangs_once():
    assert list(numbered()) == NUMBERS


@pytest.mark.parametrize("number", NUMBERS)
def test_every_label_is_complete(number):
    text = numbered()[number]
    for label in ("Printed", "Right", "Costs", "Lesson"):
        assert text.count(f"- **{label}:** ") == 1, label
    where = text.partition("**Lesson:**")[2]
    assert lessons(where) or "told here only" in where


@pytest.mark.parametrize("heading", [heading for heading, text in exhibits().items() if lessons(text)])
def test_quoted_numbers_are_printed_by_the_lesson(heading):
    """Set as `code`: it stands in the stored outputs of a lesson to which the exhibit leads."""
    text = exhibits()[heading]
    outputs = "\n".join(map(printed, sorted(set(lessons(text)))))
    names = r"`(?:isnan|P_post|plot_covariance)`"
    missing = [number for number in re.findall(QUOTED, re.sub(names, "", text)) if not says(outputs, number)]
    assert not missing


def test_quoted_numbers_need_a_lesson():
    for heading, text in exhibits().items():
        if not lessons(text):
            assert not re.findall(QUOTED, text), heading


def test_the_museum_quotes_enough():
    assert sum(len(re.findall(QUOTED, text)) for text in numbered().values()) > 100


def test_sources_are_named():
    text = read("errata-museum")
    for source in ("xiahouzuoxin", "2014", "zhangquan2015", "2018, CC BY-SA", "Chen Qijin", "2022"):
        assert source in text


# ---- the cheat sheet


def test_cheat_sheet_is_one_page():
    assert sum(1 for line in read("cheat-sheet").splitlines() if line.strip()) <= 60


def test_cheat_sheet_calls_exist():
    import kflearn

    (code,) = re.findall(r"(?ms)^```python\n(.*?)^```$", read("cheat-sheet"))
    compile(code.replace("…", "_"), "cheat sheet", "exec")
    called = set(re.findall(r"(?<![.\w])(\w+)\(", re.sub(r"#.*", "", code)))
    assert called
    assert not [name for name in called if not hasattr(kflearn, name)]
    track = kalman_filter(random_walk(1, 1), [1.0, 2.0], Gaussian(0, 1))
    assert not [name for name in re.findall(r"track\.(\w+)", code) if not hasattr(track, name)]
