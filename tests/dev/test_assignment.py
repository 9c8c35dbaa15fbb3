"""Assignments: the notebooks for learners, and grading a class of eleven with nbgrader."""

import csv
import os
import re
import sys

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from dev.teaching.assignment import assignment, main
from dev.teaching.grading import Course
from kflearn.exercises import gaussian_fusion
from tests.dev.answers import (
    ASKED,
    LESSON,
    answered,
    by_name,
    helped,
    release,
    right,
    save,
    stripped,
    the_lesson,
    without,
)
from tests.dev.command import run

# ---- the notebooks


@pytest.mark.parametrize("path", LESSON.values(), ids=lambda path: path.stem)
def test_the_exercises_of_every_lesson_become_an_assignment(path):
    lesson = nbformat.read(path, as_version=4).cells
    start = next(i for i, cell in enumerate(lesson) if "## Exercises" in cell.source)
    asked = re.findall(r"exercises\.(\w+)\.check\(", "\n".join(cell.source for cell in lesson[start:]))
    notebook = assignment(path)
    nbformat.validate(notebook)
    marks = [cell.metadata["nbgrader"] for cell in notebook.cells if "nbgrader" in cell.metadata]
    assert [each["grade_id"] for each in marks if each["solution"]] == asked
    assert [each["grade_id"] for each in marks if each["grade"]] == [f"points-{name}" for name in asked]
    assert all(each["points"] == 1 and each["locked"] for each in marks if each["grade"])
    assert len({each["grade_id"] for each in marks}) == len(marks)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            compile(cell.source, path.name, "exec")
            assert not re.search(r"\banswer\b", cell.source), "an answer that two exercises would share"


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """Lessons 4 and 5 as an assignment: the nbgrader course's folder."""
    folder = tmp_path_factory.mktemp("course")
    folder.chmod(0o755)  # as an ordinary folder is
    run("-m", "dev.teaching.assignment", "04", "05", "--out", folder, timeout=280)
    return folder


def read(course, version, number):
    return nbformat.read(course / version / "lessons-04-05" / f"{number}-answers.ipynb", as_version=4)


def test_the_learners_version_has_no_solutions(course):
    teachers, learners = by_name(read(course, "source", "04")), by_name(read(course, "release", "04"))
    assert learners.keys() == teachers.keys()
    made = by_name(release("04"))
    assert all(learners[name].source.strip() == made[name].source.strip() for name in made), (
        "what other tests take for it"
    )
    assert "return my_fuse(" in teachers["fuse"].source
    assert "SOLUTION" not in str(learners) and "my_fuse" not in str(learners)
    assert learners["third_opinion"].source.strip() == "answer_third_opinion = ..."
    assert learners["fuse"].source.rstrip().endswith("# your lines in place of the dots\n    ...")
    for name in ("points-fuse", "given-0"):  # what must not be changed
        assert not learners[name].metadata.editable and not learners[name].metadata.deletable


def test_the_file_has_a_name_of_its_own(course):
    names = sorted(path.name for path in (course / "release" / "lessons-04-05").iterdir())
    assert names == ["04-answers.ipynb", "05-answers.ipynb"]
    assert "04-answers.ipynb" in read(course, "release", "04").cells[0].source


@pytest.mark.skipif(os.name != "posix", reason="rights of files as Unix has them")
def test_only_the_teacher_looks_into_the_course(course):
    assert course.stat().st_mode & 0o077 == 0, "solutions and grades"


# ---- a class of eleven


def hand_in_all(folder):
    """What eleven learners hand in, of lessons 4 and 5."""
    save(answered("04"), folder, "ada mary/04-answers.ipynb")
    save(answered("05"), folder, "ada mary/05-answers.ipynb")
    save(helped(answered("04")), folder, "hal/04-answers (1).ipynb", day=1)
    save(release("04"), folder, "hal/04-answers.ipynb", day=2)
    save(answered("05"), folder, "hal/05-answers (1).ipynb")
    save(answered("04"), folder, "ida/second try/04-answers.ipynb", day=2)
    save(answered("04", {"fuse": "fuse = 1"}), folder, "ida/first try/04-answers.ipynb", day=1)
    save(new_notebook(cells=[new_code_cell("1 + 1")]), folder, "ida/essay.ipynb")
    for number in ("04", "05"):
        save(the_lesson(number), folder, f"jan/{LESSON[number].name}")
    save(answered("04"), folder, "kim_04-answers.ipynb")
    hand_in_broken(folder)
    hand_in_changed(folder)


def hand_in_broken(folder):
    """What raises, lacks cells, never ends or is no notebook."""
    crashing = {
        "third_opinion": "raise RuntimeError('lost')",
        "fuse": "def fuse(mx, vx, mz, vz)\n    return mx",
        "readings_needed": "answer_readings_needed = (56",
    }
    save(answered("04", crashing), folder, "ben/04-answers.ipynb")
    save(without(answered("04"), "third_opinion", "points-fuse"), folder, "cem/04-answers.ipynb")
    save(answered("04", {"readings_needed": "while True:\n    pass"}), folder, "dan/04-answers.ipynb")
    (folder / "eva").mkdir()
    (folder / "eva" / "04-answers.ipynb").write_text('{"cells": [', encoding="utf-8")
    (folder / "eva" / ".ipynb_checkpoints").mkdir()
    (folder / "eva" / ".ipynb_checkpoints" / "04-answers-checkpoint.ipynb").write_text("{}", encoding="utf-8")


def hand_in_changed(folder):
    """Right under other names, and wrong."""
    renamed = {name: right("04")[name].replace("answer_", "my_") for name in ("third_opinion", "readings_needed")}
    renamed["fuse"] = right("04")["fuse"].replace("def fuse(", "def my_fuse(")
    save(answered("04", renamed), folder, "fay/04-answers.ipynb")
    save(stripped(answered("05")), folder, "fay/my lesson five.ipynb")
    wrong = {
        "third_opinion": "answer_third_opinion = 61,897",
        "fuse": "def fuse(mx, vx, mz, vz):\n    return mx + vx / (vx + vz) * (mz - mx), vx + vz",
        "points-fuse": "1",  # whoever writes the point into the locked cell does not have it
        "readings_needed": f"answer_readings_needed = {WRONG[0]!r}",
    }
    save(answered("04", wrong), folder, "gus/04-answers.ipynb")
    save(answered("05", {"second_gain": 'answer_second_gain = "2/3"'}), folder, "gus/05-answers.ipynb")


WRONG = next(iter(gaussian_fusion.readings_needed.wrong.values()))  # an answer, and the sentence about it
SUMS = {
    "ada mary": 11, "ben": 2, "cem": 4, "dan": 4, "eva": 0, "fay": 8, "gus": 7, "hal": 11, "ida": 5, "jan": 11,
    "kim": 5,
}  # fmt: skip


def graded(course):
    """The sums and the files of the table of points, and what was said in the table of answers."""
    with open(course / "points-04-05.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    asked = [f"{number} {name}" for number in ASKED for name in ASKED[number]]
    assert list(rows[0]) == ["learner", *asked, "sum", "04 file", "05 file"]
    assert all(int(row["sum"]) == sum(int(row[name]) for name in asked) for row in rows)
    with open(course / "answers-04-05.csv", encoding="utf-8", newline="") as file:
        said = {(row["learner"], row["exercise"]): row["said"] for row in csv.DictReader(file)}
    files = {(row["learner"], number): row[f"{number} file"] for row in rows for number in ASKED}
    return {row["learner"]: int(row["sum"]) for row in rows}, files, said


@pytest.fixture(scope="module")
def eleven(course, tmp_path_factory):
    """The class of eleven, graded in one run: (printed, sums, files, said)."""
    folder, progress = tmp_path_factory.mktemp("answers"), course / "progress.json"
    hand_in_all(folder)
    command = ["-m", "dev.teaching.assignment", "04", "05", "--out", course, "--grade", folder, "--seconds", "4"]
    printed = run(*command, timeout=280, KFLEARN_PROGRESS=str(progress))
    assert not progress.exists(), "grading is not the teacher's own progress"
    return printed, *graded(course)


@pytest.mark.timeout(300)
def test_the_points_of_the_eleven(eleven):
    _, sums, files, _ = eleven
    assert sums == SUMS
    assert files["jan", "05"] == f"jan/{LESSON['05'].name} (from the lesson itself)"
    assert files["kim", "04"] == "kim_04-answers.ipynb" and files["kim", "05"] == ""
    assert files["eva", "04"] == "eva/04-answers.ipynb (handed in, not usable)"
    assert files["fay", "05"] == "fay/my lesson five.ipynb"


@pytest.mark.timeout(300)
def test_what_the_eleven_are_told(eleven):
    said = eleven[3]
    assert said["ada mary", "fuse"].startswith("✓ Right.") and said["jan", "third_opinion"].startswith("✓ Right.")
    assert said["ben", "third_opinion"] == "The cell stopped with RuntimeError: lost"
    for name in ("fuse", "readings_needed"):
        assert said["ben", name].startswith("The cell stopped with SyntaxError")
    missed = "No answer cell was found: nothing in the notebook makes the name answer_third_opinion."
    assert said["cem", "third_opinion"] == missed and said["cem", "fuse"].startswith("✓ Right.")
    assert said["dan", "readings_needed"] == "The cell stopped at the time limit."
    assert said["dan", "second_gain"] == said["eva", "second_gain"] == "Nothing was handed in."
    assert said["eva", "fuse"] == "Handed in, not usable: eva/04-answers.ipynb is no notebook. It was not used."
    for name, variable in (("third_opinion", "answer_third_opinion"), ("fuse", "fuse")):
        stopped = f"The cell stopped with NameError: name '{variable}' is not defined."
        assert said["fay", name] == f"{stopped} The check looks for the name {variable}: was it renamed?"
    assert "a tuple of 2 items" in said["gus", "third_opinion"]
    assert gaussian_fusion.fuse.wrong["variances added"][1] in said["gus", "fuse"]
    assert WRONG[1] in said["gus", "readings_needed"]
    assert "leave out the quotation marks" in said["gus", "second_gain"]


@pytest.mark.timeout(300)
def test_what_is_printed_of_the_eleven(eleven):
    printed = eleven[0]
    progress = re.findall(r"^\[(\d+)/15\] .*, lesson 0[45]: .* …$", printed, re.MULTILINE)
    assert progress == [str(number) for number in range(1, 16)]
    assert "Notebooks: 15. Learners: 11. A cell may run for 4 s" in printed
    table = printed.partition("\nlearner")[2]
    assert re.search(r"^ben +0 +0 +0 +1 +1 +0 +0 +0 +0 +0 +0 +2/11   05 nothing handed in$", table, re.MULTILINE)
    assert re.search(r"^jan .* 11/11   04 from the lesson itself; 05 from the lesson itself$", table, re.MULTILINE)
    useless = "04 handed in, not usable: eva/04-answers.ipynb; 05 nothing handed in"
    assert re.search(rf"^eva .* 0/11   {useless}$", table, re.MULTILINE)
    assert "04.2 fuse: 7 of 11 right" in table
    lines = table.partition("What was done:")[2].splitlines()
    assert lines[0] == " 15 graded, of these from the lesson itself: 2."
    absent = [f"{name} (lesson 05)" for name in ("ben", "cem", "dan", "eva", "kim")]
    assert lines[2] == "- Handed in, not usable, by eva (lesson 04), ida (lesson 05)."
    assert lines[1] == f"- Nothing was handed in by {', '.join(absent)}."
    for about in [
        "For files beside the folders, the file's name says whose they are. These learners are: kim.",
        "eva: eva/04-answers.ipynb is no notebook. It was not used.",
        "cem, lesson 04: no answer cell was found, as when it was deleted, for: third_opinion.",
        "cem, lesson 04: locked cells had been deleted and were put back: points-fuse.",
        "gus, lesson 04: locked cells had been changed and were graded as handed out: points-fuse.",
        "hal, lesson 04: hal/04-answers.ipynb was set aside: nothing is answered in it, though it is newer.",
        "ida: ida/essay.ipynb has no exercise of this assignment. It was not used.",
        f"jan, lesson 05: graded from the lesson itself, jan/{LESSON['05'].name}.",
    ]:
        assert f"- {about}" in lines
    assert sum("was graded, saved 2026-01-0" in line for line in lines) == 2  # hal and ida
    assert sum("ida/first try/04-answers.ipynb was set aside: it is older" in line for line in lines) == 1
    assert not re.search(r"checkpoint|\d+\.py", printed)


def test_a_folder_that_is_not_there_or_empty(course, tmp_path, monkeypatch):
    monkeypatch.setenv("KFLEARN_PROGRESS", "")  # grading takes it out of the environment
    for folder, sentence in ((tmp_path / "none", "there is no folder"), (tmp_path, "has no notebooks and no folders")):
        command = ["assignment.py", "04", "05", "--out", str(course), "--grade", str(folder)]
        monkeypatch.setattr(sys, "argv", command)
        with pytest.raises(SystemExit, match=sentence):
            main()


def test_points_in_a_folder_of_an_older_version_are_kept(course, tmp_path, monkeypatch):
    release = tmp_path / "release" / "lessons-04"
    save(read(course, "release", "04"), release, LESSON["04"].name)
    (tmp_path / "submitted" / "ada" / "lessons-04").mkdir(parents=True)
    monkeypatch.setattr(sys, "argv", ["assignment.py", "04", "--out", str(tmp_path)])
    with pytest.raises(SystemExit, match="move that folder away"):
        main()
    assert Course(tmp_path, [LESSON["04"]]).sheets()[0].answers == ASKED["04"], "it can still be graded"
