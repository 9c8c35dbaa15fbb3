"""Hand-ins of an assignment: whose a file is, of which lesson, which attempt counts, and the copy that is graded."""

import json

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from dev.teaching.fresh_copy import Sheet, adapted, fresh_copy, makes, mark
from dev.teaching.hand_ins import NOTHING, find, owner, plan
from tests.dev.answers import ASKED, LESSON, answered, by_name, release, save, stripped, the_lesson, without


@pytest.fixture
def sheets(tmp_path_factory):
    folder = tmp_path_factory.mktemp("release")
    return [Sheet(number, save(release(number), folder, f"{number}.ipynb"), LESSON[number]) for number in ASKED]


# ---- whose a file is, and of which lesson


@pytest.mark.parametrize(
    "name, learner",
    [
        ("kim_04-answers.ipynb", "kim"),
        ("Kim Lee_12345_assignsubmission_file_04-answers (1).ipynb", "Kim Lee"),
        ("kim.ipynb", "kim"),
        ("kim.ipynb.txt", "kim"),
        ("04-answers.ipynb", "04-answers"),
        ("_answers.ipynb", "_answers"),
    ],
)
def test_the_name_of_a_file_beside_the_folders_says_whose_it_is(name, learner):
    assert owner(name) == learner


def test_what_is_found_and_what_is_passed_over(tmp_path):
    for name in [
        "ada/deep/er/a b (1).ipynb", "ada/.ipynb_checkpoints/a-checkpoint.ipynb", ".trash/b.ipynb", "kim_x.ipynb",
        "__MACOSX/ada/._a.ipynb", "readme.txt", "all.zip", "ben/answers.zip", "ben/notes.txt",
    ]:  # fmt: skip
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    (tmp_path / "cem").mkdir()
    learners, files, said = find(tmp_path)
    assert learners == ["ada", "ben", "cem", "kim"]
    names = [file.name for file in files]
    assert names == ["ada/deep/er/a b (1).ipynb", "ben/answers.zip", "ben/notes.txt", "kim_x.ipynb"]
    assert len(said) == 3 and "all.zip is packed" in said[0] and said[2].endswith("These learners are: kim.")
    assert said[1] == "readme.txt is no notebook and in no learner's folder. It was not used."
    _, said = plan([], tmp_path)
    assert "ben: ben/answers.zip is packed and was not opened. Unpack it and grade again." in said
    assert "ben: ben/notes.txt is no notebook. It was not used." in said


def test_a_notebook_is_recognised_by_its_cells(sheets):
    four, five = sheets
    cases = {
        "answers": [
            answered("04"),
            stripped(answered("04")),
            stripped(without(answered("04"), *(f"points-{name}" for name in ASKED["04"]))),
            without(answered("04"), "given-0"),
        ],
        "lesson": [the_lesson("04"), nbformat.read(LESSON["04"], as_version=4)],
        "": [
            nbformat.read(LESSON["20"], as_version=4),
            new_notebook(cells=[new_code_cell("print(1)")]),
            answered("05"),
        ],
    }
    for kind, notebooks in cases.items():
        for notebook in notebooks:
            assert four.kind(notebook.cells) == kind
    assert five.kind(answered("05").cells) == "answers"
    both = answered("04")
    both.cells += answered("05").cells
    assert [sheet.kind(both.cells) for sheet in sheets] == ["answers", "answers"], "two lessons in one file"


def test_exercises_of_the_same_name_are_told_apart(sheets):
    name = "exercises.readings_needed.check("
    owners = [number for number, path in LESSON.items() if name in path.read_text(encoding="utf-8")]
    assert len(owners) == 2 and "04" in owners, "else this test can go"
    other = next(number for number in owners if number != "04")
    assert sheets[0].kind(release(other).cells) == "" and sheets[0].kind(release("04").cells) == "answers"


@pytest.mark.parametrize("number", LESSON)
def test_every_lesson_itself_can_be_graded(number, tmp_path):
    sheet = Sheet(number, save(release(number), tmp_path, "release.ipynb"), LESSON[number])
    cells = nbformat.read(LESSON[number], as_version=4).cells
    assert sheet.kind(cells) == "lesson" and sheet.answered(cells, "lesson") == 0
    copy, missing = fresh_copy(sheet, cells, "lesson")
    nbformat.validate(copy)
    names = [mark(cell) for cell in copy.cells]
    assert not missing and [name for name in names if name in sheet.graded] == sheet.graded
    for name in sheet.answers:
        assert makes(by_name(copy)[name].source, sheet.variables[name])
        assert names.index(name) < names.index(f"points-{name}")
    assert names.index("given-0") < min(names.index(name) for name in sheet.answers)


@pytest.mark.parametrize(
    "source, expected",
    [
        ("answer = 3\nexercises.a.check(answer)", "\nanswer_a = answer"),
        ("exercises.a.check(\n    (1, 2)\n)", "\nanswer_a = (1, 2)"),
        ("answer_a = 3\nexercises.a.check(answer_a)", ""),
        ("%time x = 3\nexercises.a.check(x)", "\nanswer_a = x"),
        ("print(exercises.a.check(2 * 3))", "\nanswer_a = 2 * 3"),
    ],
)
def test_a_cell_of_the_lesson_gives_its_answer_to_the_check(source, expected):
    assert adapted(source, "a", "answer_a") == source + expected


def test_whether_a_cell_makes_a_name():
    assert makes("x = 1\nfuse = lambda: 1", "fuse") and makes("def fuse(a):\n    return (", "fuse")
    assert makes("fuse: float = 3", "fuse")
    assert (
        not makes("fuse == 3", "fuse") and not makes("refuse = 3", "fuse") and not makes("def fuse_all(): ...", "fuse")
    )


# ---- the fresh copy


def test_a_fresh_copy_has_the_answers_and_the_learners_own_cells_in_order(sheets):
    notebook = answered("04", {"points-fuse": "1", "given-0": "broken", "third_opinion": "answer_third_opinion = 7"})
    place = next(i for i, cell in enumerate(notebook.cells) if mark(cell) == "fuse")
    notebook.cells[place:place] = [new_code_cell("before = 1"), new_code_cell("exercises.fuse.check(fuse)")]
    notebook.cells.insert(place + 3, new_code_cell("after = 1"))
    notebook.cells.append(notebook.cells[1].copy())
    copy, missing = fresh_copy(sheets[0], without(notebook, "points-third_opinion").cells, "answers")
    nbformat.validate(copy)
    cells, made = by_name(copy), by_name(release("04"))
    assert missing == []
    for name in ("points-fuse", "points-third_opinion", "given-0"):
        assert cells[name].source == made[name].source
    assert cells["third_opinion"].source == "answer_third_opinion = 7"
    code = [mark(cell) or cell.source for cell in copy.cells if cell.cell_type == "code"]
    first = code.index("third_opinion")
    assert code[first + 1 : first + 7] == [
        "points-third_opinion", "before = 1", "exercises.fuse.check(fuse)", "fuse", "after = 1", "points-fuse",
    ]  # fmt: skip
    assert code.count("given-0") == 1


def test_an_answer_that_is_there_twice_or_below_its_check(sheets):
    sheet, notebook = sheets[0], release("04")
    notebook.cells.append(by_name(notebook)["fuse"].copy())
    notebook.cells[-1].source = "def fuse(*all):\n    return 1"
    copy, _ = fresh_copy(sheet, notebook.cells, "answers")
    names = [mark(cell) for cell in copy.cells]
    assert names.count("fuse") == 1 and names.index("points-fuse") == names.index("fuse") + 1
    assert by_name(copy)["fuse"].source == notebook.cells[-1].source
    assert sheet.answered(notebook.cells, "answers") == 1
    assert sheet.answered(release("04").cells, "answers") == 0
    assert sheet.answered(nbformat.read(LESSON["04"], as_version=4).cells, "lesson") == 0
    assert sheet.answered(the_lesson("04").cells, "lesson") == len(ASKED["04"])


def test_a_deleted_answer_is_missed_and_a_retyped_one_is_found(sheets):
    notebook = without(answered("04"), "third_opinion", "fuse")
    notebook.cells.insert(3, new_code_cell("def fuse(a, b, c, d):\n    return a, b"))
    copy, missing = fresh_copy(sheets[0], notebook.cells, "answers")
    assert missing == ["third_opinion"]
    assert by_name(copy)["fuse"].source == notebook.cells[3].source


def test_a_deleted_answer_is_named(sheets, tmp_path):
    save(without(answered("04"), "third_opinion", "points-third_opinion"), tmp_path, "cem/a.ipynb")
    assert plan(sheets[:1], tmp_path)[1] == [
        "cem, lesson 04: no answer cell was found, as when it was deleted, for: third_opinion.",
        "cem, lesson 04: locked cells had been deleted and were put back: points-third_opinion.",
    ]


def chosen(sheet, folder):
    """Which file counts, and the sentences about all of a learner's files."""
    jobs, said = plan([sheet], folder)
    return jobs[0].attempt.file.name, said


def test_the_newest_attempt_counts_and_the_others_have_a_line(sheets, tmp_path):
    sheet, full = sheets[0], answered("04")
    save(answered("04", {"fuse": "fuse = 1"}), tmp_path, "ida/b second/x.ipynb", day=2)
    save(full, tmp_path, "ida/a first/x.ipynb", day=3)
    name, said = chosen(sheet, tmp_path)
    assert name == "ida/a first/x.ipynb" and len(said) == 2
    assert said[1].startswith("ida, lesson 04: ida/b second/x.ipynb was set aside: it is older, saved 2026-01-0")

    save(release("04"), tmp_path, "ida/c.ipynb", day=4)
    name, said = chosen(sheet, tmp_path)
    assert name == "ida/a first/x.ipynb"
    assert "ida, lesson 04: ida/c.ipynb was set aside: nothing is answered in it, though it is newer." in said

    save(the_lesson("04"), tmp_path, "ida/04-gaussian-fusion.ipynb", day=5)
    name, said = chosen(sheet, tmp_path)
    assert name == "ida/a first/x.ipynb" and "it is the lesson itself, and there is a file of the assignment" in str(
        said
    )

    save(full, tmp_path, "ida/copy.ipynb", day=2)
    assert "ida, lesson 04: ida/copy.ipynb was set aside: it is an exact copy." in chosen(sheet, tmp_path)[1]


def test_attempts_that_are_equally_old(sheets, tmp_path):
    sheet = sheets[0]
    save(answered("04", {"fuse": "fuse = 1"}), tmp_path, "ida/04-answers (10).ipynb")
    save(answered("04", {"fuse": "fuse = 2"}), tmp_path, "ida/04-answers (9).ipynb")
    save(answered("04", {"fuse": "fuse = 3"}), tmp_path, "ida/04-answers.ipynb")
    name, said = chosen(sheet, tmp_path)
    assert name == "ida/04-answers (10).ipynb"
    assert "ida, lesson 04: ida/04-answers (9).ipynb was set aside: it is as old, and its name comes first." in said
    save(without(answered("04"), "fuse"), tmp_path, "ida/04-answers (11).ipynb")
    name, said = chosen(sheet, tmp_path)
    assert (
        name == "ida/04-answers (10).ipynb"
        and "(11).ipynb was set aside: it is as old, and has fewer answers." in str(said)
    )


@pytest.mark.parametrize("text", ["", "{", "[]", '{"cells": 3}', "PK\x03", "null", '{"nbformat": 4, "cells": [{}]}'])
def test_a_broken_file_is_told_of(sheets, tmp_path, text):
    (tmp_path / "eva").mkdir()
    (tmp_path / "eva" / "homework.ipynb").write_text(text, encoding="utf-8")
    jobs, said = plan(sheets, tmp_path)
    assert [job.trouble for job in jobs] == [useless("eva/homework.ipynb", "is no notebook")] * 2
    assert "eva: eva/homework.ipynb is no notebook. It was not used." in said
    (tmp_path / "eva" / "homework.ipynb").rename(tmp_path / "eva" / "05-answers (10).ipynb")
    jobs, _ = plan(sheets, tmp_path)
    assert [job.trouble for job in jobs] == [NOTHING, useless("eva/05-answers (10).ipynb", "is no notebook")]


def useless(name, why):
    return f"Handed in, not usable: {name} {why}. It was not used."


def test_odd_metadata_does_no_harm(sheets, tmp_path):
    notebook = answered("04")
    notebook.cells[0].metadata = {"nbgrader": ["?"]}
    notebook.cells[4].metadata = {"nbgrader": {"grade_id": ["?"]}}
    notebook.cells.insert(5, new_code_cell("x = '\ud800'"))
    text = json.dumps(notebook).replace('"cell_type": "markdown", ', '"cell_type": "markdown", "id": 3, ', 1)
    (tmp_path / "eva").mkdir()
    (tmp_path / "eva" / "odd.ipynb").write_text("\ufeff" + text, encoding="utf-8")
    job = plan(sheets[:1], tmp_path)[0][0]
    copy, missing = fresh_copy(sheets[0], job.attempt.file.cells, "answers")
    assert not missing and job.attempt.answered == len(ASKED["04"])
    nbformat.write(copy, tmp_path / "copy.ipynb")
