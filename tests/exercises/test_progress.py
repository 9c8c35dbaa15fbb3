"""Progress: noted when right, only then; a file that is lost, damaged or read-only harms nothing."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kflearn.exercises import gaussian_fusion, progress, voltmeter
from kflearn.exercises.engine import exercises_of

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
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


def test_the_folder_of_the_lessons_is_found_from_around_it(tmp_path, monkeypatch):
    monkeypatch.delenv("KFLEARN_PROGRESS", raising=False)
    monkeypatch.setitem(sys.modules, "ipykernel", object())
    (tmp_path / "course" / "notebooks" / "mine").mkdir(parents=True)
    (tmp_path / "course" / "notebooks" / "00-start-here.ipynb").touch()
    for start in ("course", "course/notebooks", "course/notebooks/mine"):
        monkeypatch.chdir(tmp_path / start)
        assert progress.place() == tmp_path / "course" / "notebooks" / ".progress.json"


def test_where_a_tick_is_not_kept_it_is_said(tmp_path, monkeypatch):
    monkeypatch.delenv("KFLEARN_PROGRESS", raising=False)
    monkeypatch.setitem(sys.modules, "ipykernel", object())
    monkeypatch.chdir(tmp_path)
    outcome = solve(FIRST)
    assert outcome.status == "right"
    assert outcome.text.endswith("this kernel was not started in the folder of 00-start-here.ipynb.)")
    assert "No lessons here" in progress.table().html()


HAMMER = """
import sys
from kflearn.exercises import progress
print("ready", flush=True)
sys.stdin.readline()
for i in range(50):
    progress.note("kflearn.exercises.lesson", f"{sys.argv[1]}_{i}")
"""


def test_no_tick_is_lost_when_several_notebooks_solve_at_one_instant(file):
    """Three processes note fifty exercises each, as fast as they can, in one file."""
    command = [sys.executable, "-c", HAMMER]
    writers = [
        subprocess.Popen([*command, who], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) for who in "abc"
    ]
    assert [writer.stdout.readline() for writer in writers] == ["ready\n"] * 3
    for writer in writers:
        writer.stdin.write("go\n")
        writer.stdin.flush()
    for writer in writers:
        writer.communicate()
    assert [writer.returncode for writer in writers] == [0, 0, 0]
    assert progress.solved() == {f"lesson.{who}_{i}" for who in "abc" for i in range(50)}
    assert os.listdir(file.parent) == [file.name]


def test_the_lock_of_a_kernel_that_died_is_taken_away(file):
    lock = file.with_name(file.name + ".lock")
    lock.touch()
    long_ago = time.time() - 60
    os.utime(lock, (long_ago, long_ago))
    assert solve(FIRST).status == "right"
    assert progress.solved() == {KEY}
    assert not lock.exists()


def test_a_lock_that_stays_held_costs_a_tick_and_nothing_else(file, monkeypatch):
    monkeypatch.setattr(progress, "PATIENCE", 0.05)
    lock = file.with_name(file.name + ".lock")
    lock.touch()
    assert solve(FIRST).status == "right"
    assert progress.solved() == set()
    assert lock.exists()


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
