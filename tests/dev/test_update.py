"""`make update`, `make reset` and `make clear`, with a course of two lessons and a learner who has cloned it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import nbformat
import pytest

from dev.lessons import METADATA
from tests.dev.command import make

ROOT = Path(__file__).parents[2]
LESSON = "notebooks/05-voltmeter.ipynb"


def git(folder, *command):
    """A git command in a folder, by somebody without any settings of their own."""
    who = ["-c", "user.name=founder", "-c", "user.email=founder@localhost"]
    done = subprocess.run(["git", *who, *command], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def lesson(*cells, **outputs):
    """A notebook of cells given as id=source; an output for those that have one."""
    notebook = nbformat.v4.new_notebook()
    for name, source in cells:
        new = nbformat.v4.new_markdown_cell if source.startswith("#") else nbformat.v4.new_code_cell
        notebook.cells.append(new(source, id=name))
        if name in outputs:
            notebook.cells[-1].outputs = [nbformat.v4.new_output("stream", text=outputs[name])]
    return notebook


def write(folder, notebook, name=LESSON):
    nbformat.write(notebook, folder / name)


def read(folder, name=LESSON):
    """{id: source} and {id: what was printed} of a lesson."""
    notebook = nbformat.read(folder / name, as_version=4)
    nbformat.validate(notebook)
    printed = {cell.id: cell.outputs[0].text for cell in notebook.cells if cell.get("outputs")}
    return {cell.id: cell.source for cell in notebook.cells}, printed


OLD = [("title", "# 5 · The voltmeter"), ("run", "print(run())"), ("task", "answer = ..."), ("end", "# Sources")]


@pytest.fixture
def course(tmp_path):
    """The founders' course."""
    folder = tmp_path / "course"
    (folder / "notebooks").mkdir(parents=True)
    (folder / "dev").mkdir()
    for name in ("__init__", "lessons", "update", "reset"):
        shutil.copy(ROOT / "dev" / f"{name}.py", folder / "dev")
    write(folder, lesson(*OLD, run="1.60"))
    (folder / "README.md").write_text("read me\n")
    git(folder, "init", "--quiet", "--initial-branch=main")
    commit(folder)
    return folder


def commit(folder):
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--message", "course")


@pytest.fixture
def learner(course, tmp_path):
    """A learner's clone of it."""
    git(tmp_path, "clone", "--quiet", str(course), "learner")
    return tmp_path / "learner"


def call(folder, tool, *arguments, fails=False):
    """What a tool prints in somebody's folder, called by somebody whom git does not know."""
    nobody = {"GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull, "HOME": str(folder)}
    done = subprocess.run(
        [sys.executable, "-m", f"dev.{tool}", *arguments],
        cwd=folder,
        env=os.environ | nobody,
        capture_output=True,
        text=True,
    )
    assert (done.returncode != 0) == fails, done.stdout + done.stderr
    assert "Traceback" not in done.stderr and "Aborting" not in done.stderr
    return done.stdout + done.stderr


def work(folder):
    """The learner runs the lesson, answers the task and adds a cell."""
    cells = [*OLD[:2], ("task", "answer = 12.1"), ("own", "2 * answer"), OLD[3]]
    notebook = lesson(*cells, run="1.60", task="right", own="24.2")
    notebook.metadata.widgets = {"state": "of a slider"}
    write(folder, notebook)


NEW = [("title", "# 5 · The voltmeter"), ("more", "# A new paragraph"), ("run", "print(run(), 'V')"), *OLD[2:]]


def test_new_text_comes_and_answers_stay(course, learner):
    work(learner)
    write(course, lesson(*NEW, run="1.61 V"))
    commit(course)
    assert "new or changed: 1, lessons among them: 1." in call(learner, "update")
    sources, printed = read(learner)
    assert list(sources) == ["title", "more", "run", "task", "own", "end"]
    assert sources["task"] == "answer = 12.1" and sources["own"] == "2 * answer"
    assert sources["run"] == "print(run(), 'V')" and printed["run"] == "1.61 V"
    assert call(learner, "update") == "Nothing is new.\n"
    write(course, lesson(*NEW, ("last", "# One more"), run="1.62 V"))
    commit(course)
    call(learner, "update")
    sources, printed = read(learner)
    assert sources["task"] == "answer = 12.1" and "last" in sources and printed["run"] == "1.62 V"


def test_a_cell_that_both_have_changed_is_the_learners(course, learner):
    work(learner)
    write(course, lesson(*OLD[:2], ("task", "answer = ...  # in volts"), OLD[3]))
    commit(course)
    call(learner, "update")
    sources, printed = read(learner)
    assert sources["task"] == "answer = 12.1" and printed["task"] == "right"


def test_commits_of_the_learners_own_and_a_removed_cell(course, learner):
    work(learner)
    commit(learner)
    write(course, lesson(*OLD[:2], OLD[3]))
    (course / "README.md").write_text("read me again\n")
    commit(course)
    call(learner, "update")
    assert list(read(learner)[0]) == ["title", "run", "task", "own", "end"]
    assert (learner / "README.md").read_text() == "read me again\n"


def test_files_of_the_same_name_and_files_deleted(course, learner):
    other = "notebooks/06-tuning.ipynb"
    write(learner, lesson(("mine", "my = 1")), other)
    (learner / "README.md").write_text("my remarks\n")
    write(course, lesson(("theirs", "# 6 · Tuning")), other)
    (course / "README.md").unlink()
    commit(course)
    printed = call(learner, "update")
    assert "Your file of that name is now mine-06-tuning.ipynb" in printed
    assert list(read(learner, "notebooks/mine-06-tuning.ipynb")[0]) == ["mine"]
    assert list(read(learner, other)[0]) == ["theirs"]
    assert (learner / "README.md").read_text() == "my remarks\n"
    assert call(learner, "update") == "Nothing is new.\n"


def test_a_lesson_that_the_learner_has_deleted_comes_back(course, learner):
    (learner / LESSON).unlink()
    write(course, lesson(*NEW))
    commit(course)
    call(learner, "update")
    assert "more" in read(learner)[0]


def test_a_damaged_notebook_is_kept_beside_the_new_one(course, learner):
    (learner / LESSON).write_text("{ broken")
    write(course, lesson(*NEW))
    commit(course)
    call(learner, "update")
    assert (learner / "notebooks/mine-05-voltmeter.ipynb").read_text() == "{ broken"
    assert "more" in read(learner)[0]


def test_a_folder_that_is_no_clone(course):
    assert "not made by `git clone`" in call(course, "update", fails=True)


def test_a_notebook_without_ids_keeps_its_answers(course, learner):
    work(learner)
    notebook = nbformat.read(learner / LESSON, as_version=4)
    for number, cell in enumerate(notebook.cells):
        cell.id = f"other-{number}"  # as a program writes that does not keep ids
    write(learner, notebook)
    write(course, lesson(*NEW))
    commit(course)
    call(learner, "update")
    sources = list(read(learner)[0].values())
    assert sources.count("answer = 12.1") == 1 and sources.count("# Sources") == 1 and "# A new paragraph" in sources


def test_reset_gives_the_lesson_as_it_came(course, learner):
    work(learner)
    write(course, lesson(*NEW, run="1.61 V"))
    commit(course)
    call(learner, "update")
    assert "Yours is mine-05-voltmeter.ipynb" in call(learner, "reset", "5")
    assert (learner / LESSON).read_bytes() == (course / LESSON).read_bytes()
    assert read(learner, "notebooks/mine-05-voltmeter.ipynb")[0]["task"] == "answer = 12.1"
    assert "nothing to reset" in call(learner, "reset", "05")
    work(learner)
    assert "mine-05-voltmeter-2.ipynb" in call(learner, "reset", "05")
    assert "There is no lesson 99." in call(learner, "reset", "99", fails=True)
    assert "LESSON=05" in call(learner, "reset", fails=True)


def test_the_tests_say_first_which_lessons_hold_somebodys_work(course, learner):
    notebook = lesson(*OLD, run="1.60")
    notebook.metadata.update(METADATA)
    for number, cell in enumerate((cell for cell in notebook.cells if cell.cell_type == "code"), 1):
        cell.execution_count = number
    write(course, notebook)
    commit(course)
    call(learner, "update")
    assert call(learner, "lessons") == ""
    notebook.cells[1].source += "  # changed by whoever writes lessons"
    write(learner, notebook)
    assert call(learner, "lessons") == ""
    work(learner)
    shutil.copy(learner / LESSON, learner / "notebooks/05-voltmeter-Copy1.ipynb")
    said = call(learner, "lessons", fails=True)
    assert "05-voltmeter.ipynb\n" in said and "make reset LESSON=05" in said and "Copy" not in said
    git(learner, "commit", "--all", "--quiet", "--message", "My work before an update")
    assert call(learner, "lessons", fails=True) == said
    call(learner, "reset", "05")
    said = call(learner, "lessons")
    assert "Not tested" in said and "05-voltmeter-Copy1.ipynb, mine-05-voltmeter.ipynb" in said
    (learner / LESSON).write_text("{ broken")
    assert "05-voltmeter.ipynb" in call(learner, "lessons", fails=True)
    shutil.rmtree(learner / ".git")
    said = call(learner, "lessons", fails=True)
    assert "Fetch the course again" in said and "make reset" not in said


def test_clear_writes_lessons_without_outputs(tmp_path):
    shutil.copytree(
        ROOT / "notebooks", tmp_path / "notebooks", ignore=shutil.ignore_patterns("[1-9]*", "0[1-9]*", ".*")
    )
    shutil.copy(ROOT / "Makefile", tmp_path)
    make(tmp_path, "clear", "READY=", f"BIN={Path(sys.executable).parent}")
    cells = nbformat.read(tmp_path / "build/clear/00-start-here.ipynb", as_version=4).cells
    code = [cell for cell in cells if cell.cell_type == "code"]
    assert len(code) > 20 and not any(cell.outputs or cell.execution_count for cell in code)
    assert (tmp_path / "build/clear/pictures/voltmeter.png").exists()
