"""Progress: noted when right, only then; a file that is lost, damaged or read-only harms nothing."""

import json
import os
from pathlib import Path

import pytest

from kflearn.exercises import gaussian_fusion, progress, voltmeter
from kflearn.exercises.engine import exercises_of

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"
FIRST = exercises_of(gaussian_fusion)[0]
KEY = f"gaussian_fusion.{FIRST.name}"


@pytest.fixture
def file(tmp_path, monkeypatch):
    monkeypatch.setenv("KFLEARN_PROGRESS", str(tmp_path / "progress.json"))
    return tmp_path / "progress.json"


def solve(one):
    return one.check(one._answer())


def test_only_a_right_answer_is_noted(file):
    FIRST.check()
    FIRST.check("nonsense")
    assert not file.exists()
    assert solve(FIRST).status == "right"
    assert progress.solved() == {KEY}
    other = exercises_of(voltmeter)[0]
    solve(other)
    solve(FIRST)
    assert json.loads(file.read_text())["solved"] == sorted([KEY, f"voltmeter.{other.name}"])
    assert os.listdir(file.parent) == [file.name]


@pytest.mark.parametrize(
    "damage", ["", "{", "[1, 2]", "null", '{"solved": 7}', '{"solved": [3, null]}', "\x00\xff", '"x"']
)
def test_damage_is_healed(file, damage):
    file.write_text(damage, encoding="latin-1")
    assert progress.solved() == set()
    assert "0 of" in progress.table(NOTEBOOKS).html()
    assert solve(FIRST).status == "right"
    assert progress.solved() == {KEY}


def test_a_place_that_cannot_be_written(tmp_path, monkeypatch):
    monkeypatch.setenv("KFLEARN_PROGRESS", str(tmp_path / "missing" / "progress.json"))
    assert solve(FIRST).status == "right"
    assert progress.solved() == set()


def test_nothing_is_kept_outside_a_course_folder(tmp_path, monkeypatch):
    monkeypatch.delenv("KFLEARN_PROGRESS", raising=False)
    monkeypatch.chdir(tmp_path)
    assert solve(FIRST).status == "right"
    assert progress.place() is None
    assert os.listdir(tmp_path) == []


def test_the_table_knows_every_lesson_and_its_exercises(file):
    solve(FIRST)
    table = progress.table(NOTEBOOKS)
    rows = progress.lessons(NOTEBOOKS)
    assert [name for name, *_ in rows] == sorted(path.name for path in NOTEBOOKS.glob("[0-9][0-9]-*.ipynb"))
    assert all(len(names) >= 3 for _, _, names, _ in rows)
    html = table.html()
    assert html.count("✓") == 1
    assert html.count("<a href=") == len(rows)
    assert "1 of" in html
    bundle = table._repr_mimebundle_()
    assert bundle["text/plain"] == repr(table)
    assert "application/vnd.jupyter.widget-view+json" in bundle
