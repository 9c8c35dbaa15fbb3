"""What every lesson promises: its measure, its outputs, its links, and sliders that work at their ends.

That the outputs are true is nbval's part, which runs on notebooks/ in the same pytest command.
"""

import re
import shutil
import statistics
from itertools import pairwise
from pathlib import Path
from urllib.parse import urlparse

import nbformat
import pytest

from dev import canvas, minutes
from dev.lab import CHROMIUM, browser
from dev.lessons import WIDGET, lessons
from dev.notebooks import execute

ROOT = Path(__file__).parents[2]

LESSONS = lessons()
OPEN = "open-text", "open-answer"  # a filter from nothing: these two cells come on top of the measure
per_lesson = pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)

SWEEP = """
from runpy import run_path
from kflearn.ui import Playground
_found = [value for value in globals().values() if isinstance(value, Playground)]
assert _found, "the lesson has no playground"
for _playground in _found:
    assert _playground.errors == 0
    assert _playground.sweep() >= 3
from kflearn.exercises.engine import exercises_of
for _each in exercises_of(exercises):  # the solutions, as they are shown, in the lesson's own notebook
    *_code, _check = _each.solution().text.splitlines()
    _names = dict(globals())
    exec("\\n".join(_code), _names)
    _outcome = eval(_check, _names)
    assert _outcome.status == "right", f"{{_each.name}}: {{_outcome}}"
run_path({script!r})["keep_all"]({{id(each): each for each in _found}}.values(), {folder!r})
"""


def load(path):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    return notebook


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def texts(notebook):
    return [cell.source for cell in notebook.cells if cell.cell_type == "markdown"]


def words(text):
    return len(re.findall(r"\w+", text))


def lines(cell):
    return [line for line in cell.source.splitlines() if line.strip()]


LIVE = "*The outputs below are stored from an earlier run. Run the cells from the top"


@per_lesson
def test_the_first_lines_say_how_to_make_it_live(path):
    first = load(path).cells[0].source
    assert (LIVE in first) or (path.name[:2] == "00" and "stored from an earlier run" in first)


def test_there_are_lessons():
    assert len(LESSONS) >= 4
    assert [path.name[:2] for path in LESSONS] == sorted({path.name[:2] for path in LESSONS})


@per_lesson
def test_measure(path):
    notebook = load(path)
    notebook.cells = [cell for cell in notebook.cells if cell.id not in OPEN]
    code, prose = code_cells(notebook), texts(notebook)
    lengths = sorted(len(lines(cell)) for cell in code)
    assert len(notebook.cells) <= 70
    assert len([cell for cell in code if ".check(" not in cell.source]) <= (24 if path.name[:2] <= "08" else 28)
    assert statistics.median(lengths) <= 4
    assert lengths[int(0.9 * len(lengths))] <= 10
    assert lengths[-1] <= 20
    total = sum(words(text) for text in prose)
    assert 1500 <= total <= 4000
    assert total / sum(lengths) >= 12
    assert max(map(words, prose)) <= 200
    kinds = "".join(cell.cell_type[0] for cell in notebook.cells)
    assert "ccc" not in kinds, "three code cells without prose"


@per_lesson
def test_the_minutes_are_counted(path):
    """As `python -m dev.minutes` writes them, in the lesson and in the README's table."""
    notebook = load(path)
    (said,) = re.findall(
        r"\*Time\*: (\d+) minutes in class, (\d+) alone with the exercises", "\n".join(texts(notebook))
    )
    assert int(said[1]) == minutes.alone(notebook.cells)
    row = rf"\]\(notebooks/{re.escape(path.name)}\) \|.*\| {said[0]} / {said[1]} \|"
    assert re.search(row, (ROOT / "README.md").read_text(encoding="utf-8"))


@per_lesson
def test_code_is_a_readers_code(path):
    code = "\n".join(cell.source for cell in code_cells(load(path)))
    for unwanted in (
        "import *",
        "sys" + ".path",
        "!pip",
        "%pip",
        "requests",
        "urllib",
        "open(",
        "time.time",
        "warnings",
    ):
        assert unwanted not in code, unwanted
    assert code.count(".check(") >= 3, "three exercises at least"
    assert "filterpy" in code or path.stem.startswith("00"), "the same in FilterPy"


@per_lesson
def test_outputs_are_stored(path):
    notebook = load(path)
    code = code_cells(notebook)
    assert [cell.execution_count for cell in code] == list(range(1, len(code) + 1))
    outputs = [output for cell in code for output in cell.outputs]
    assert not [o for o in outputs if o.output_type == "error" or o.get("name") == "stderr"]
    assert not [o for o in outputs if WIDGET in o.get("data", {})]
    stored = str(outputs)
    assert not re.search(r"/(home|root|work|tmp|Users)/|0x[0-9a-f]{8,}|object at|np\.float64", stored)
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    assert 4 <= len(pictures) <= 9
    for picture in pictures:
        assert len(picture.data["image/png"]) * 3 / 4 < 80_000
        assert len(picture.metadata["image/png"]["alt"]) > 20
    assert path.stat().st_size < 1_000_000


@per_lesson
def test_lines_of_output_are_not_cut(path):
    """A line of 78 signs is whole on a slide, in print and in a narrow window; a longer row of a table would break.

    Counted is what is seen as plain text. An exercise's reply is a sentence, which may wrap.
    """
    replies = r"\.(check|hint|solution)\(|progress\.table\("
    outputs = [o for cell in code_cells(load(path)) if not re.search(replies, cell.source) for o in cell.outputs]
    shown = [o.get("text", "") for o in outputs if o.output_type == "stream"]
    shown += [o.data["text/plain"] for o in outputs if list(o.get("data", {})) == ["text/plain"]]
    assert not [line for text in shown for line in text.splitlines() if len(line) > 78]


@per_lesson
def test_equal_cells_have_equal_ids_next_time(path):
    ids = [cell.id for cell in load(path).cells]
    assert len(set(ids)) == len(ids)


@per_lesson
def test_links_lead_somewhere(path):
    links = re.findall(r"\]\(([^)\s]+)\)", "\n".join(texts(load(path))))
    assert links
    for link in links:
        if not urlparse(link).scheme:
            assert (path.parent / link.partition("#")[0]).exists(), link


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """Runs a lesson and moves its sliders, once; gives what its playgrounds drew there, a folder for `dev.canvas`."""
    folders = {}

    def run(path):
        if path not in folders:
            folder, notebook = tmp_path_factory.mktemp(path.stem), load(path)
            code = SWEEP.format(script=canvas.__file__, folder=str(folder))
            notebook.cells.append(nbformat.v4.new_code_cell(code))
            execute(notebook)
            assert not [o for o in notebook.cells[-1].outputs if o.output_type == "error"]
            folders[path] = folder
        return folders[path]

    return run


@per_lesson
def test_every_slider_works_at_its_ends(path, ran):
    ran(path)


@per_lesson
@pytest.mark.browser
@pytest.mark.skipif(not CHROMIUM, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_the_browser_draws_what_matplotlib_draws(path, ran):
    folder = ran(path)
    with browser() as chromium:
        found = dict(canvas.shares(canvas.page(chromium), folder))
    shutil.rmtree(folder)
    assert found
    assert not {words: share for words, share in found.items() if share > canvas.MOST}


@pytest.mark.parametrize("page", ["README.md", "notebooks/00-start-here.ipynb"])
def test_the_map_is_complete(page):
    text = (ROOT / page).read_text(encoding="utf-8")
    found = re.findall(r"\]\((?:notebooks/)?(\d\d-[\w-]+\.ipynb)\)", text)
    assert sorted(set(found)) == sorted(path.name for path in LESSONS)


def test_each_lesson_leads_to_the_next():
    for path, following in pairwise(LESSONS):
        last, first = (re.findall(r"\]\((\d\d-[\w-]+\.ipynb)\)", load(p).cells[-1].source) for p in (path, following))
        assert following.name in last, f"{path.name} does not lead to {following.name}"
        assert path.name in first, f"{following.name} does not lead back to {path.name}"


@per_lesson
def test_every_exercise_has_its_text(path):
    notebook = load(path)
    prose = "\n".join(texts(notebook))
    assert prose.count("\n## Exercises\n") + prose.startswith("## Exercises\n") == 1
    numbers = re.findall(r"(?m)^\*\*(\d+)\. ", prose.partition("## Exercises\n")[2])
    start = next(i for i, cell in enumerate(notebook.cells) if "## Exercises\n" in cell.source)
    checks = sum(cell.source.count(".check(") for cell in notebook.cells[start:] if cell.cell_type == "code")
    assert list(map(int, numbers)) == list(range(1, checks + 1))
