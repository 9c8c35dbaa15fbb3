"""The command `kflearn`: the lessons in a learner's own folder, put back, and brought up to date."""

import re
from pathlib import Path

import nbformat
import pytest

from kflearn.lessons import command, shipped

ROOT = Path(__file__).parents[2]
NAME = "05-voltmeter.ipynb"
OLD = [("title", "# 5"), ("run", "print(1)"), ("task", "answer = ...")]
NEW = [("title", "# 5, mended"), ("run", "print(1)"), ("extra", "print(2)"), ("task", "answer = ...")]


def notebook(cells):
    made = nbformat.v4.new_notebook()
    made.cells = [nbformat.v4.new_code_cell(source, id=name) for name, source in cells]
    return made


def ship(package, cells, name=NAME):
    """Put a lesson into what came with the package."""
    nbformat.write(notebook(cells), package / "notebooks" / name)


@pytest.fixture
def package(tmp_path, monkeypatch):
    """An installed package with two lessons, an appendix and a picture."""
    folder = tmp_path / "package"
    (folder / "notebooks" / "pictures").mkdir(parents=True)
    (folder / "notebooks" / "appendix-notation.md").write_text("# Notation\n")
    (folder / "notebooks" / "pictures" / "one.png").write_bytes(b"png")
    monkeypatch.setattr(shipped, "PACKAGE", folder)
    monkeypatch.setattr(shipped, "CLONE", tmp_path / "nowhere")
    ship(folder, OLD)
    ship(folder, OLD, "00-start-here.ipynb")
    return folder


@pytest.fixture
def folder(package, tmp_path):
    mine = tmp_path / "mine"
    command.place(mine)
    return mine


def sources(folder, name=NAME):
    return {cell.id: cell.source for cell in nbformat.read(folder / name, as_version=4).cells}


def write(folder, cells):
    nbformat.write(notebook(cells), folder / NAME)


def test_open_copies_what_is_missing_and_starts_jupyterlab_with_the_settings(package, tmp_path, monkeypatch):
    calls = []
    monkeypatch.setattr(command.subprocess, "call", lambda line, env: calls.append((line, env)) or 0)
    monkeypatch.chdir(tmp_path)
    (package / "settings").mkdir()
    with pytest.raises(SystemExit):
        command.main(["open"])
    made = tmp_path / "kalman-course"
    assert sources(made) == dict(OLD)
    assert (made / "appendix-notation.md").exists() and (made / "pictures" / "one.png").exists()
    ((line, env),) = calls
    assert line[1:3] == ["-m", "jupyterlab"] and line[-2:] == [
        "--LabApp.default_url=/lab/tree/00-start-here.ipynb", "kalman-course"
    ]  # fmt: skip
    assert env["JUPYTER_CONFIG_PATH"].split(":")[0] == str(package / "settings")


def test_open_leaves_what_is_there(folder):
    write(folder, [*OLD, ("mine", "my = 1")])
    assert command.place(folder) == f"The lessons are in {folder}."
    assert sources(folder)["mine"] == "my = 1"


def test_without_jupyterlab_it_says_what_to_install(package, tmp_path, monkeypatch):
    monkeypatch.setattr(command, "find_spec", lambda name: None)
    with pytest.raises(SystemExit, match=r'pip install "kflearn\[lessons,lab\]"'):
        command.main(["open", str(tmp_path / "mine")])


def test_reset_keeps_what_was_made_of_it(folder, capsys):
    write(folder, [*OLD, ("mine", "my = 1")])
    command.main(["reset", "5", str(folder)])
    assert sources(folder) == dict(OLD)
    assert sources(folder, f"mine-{NAME}")["mine"] == "my = 1"
    assert f"Yours is mine-{NAME}" in capsys.readouterr().out
    command.main(["reset", "05", str(folder)])
    assert "nothing to reset" in capsys.readouterr().out
    write(folder, OLD[:1])
    command.main(["reset", "05", str(folder)])
    assert (folder / f"mine-{NAME[:-6]}-2.ipynb").exists()


def test_update_takes_the_new_lesson_where_nobody_has_worked(package, folder, capsys):
    ship(package, NEW)
    ship(package, NEW, "06-tuning.ipynb")
    command.main(["update", str(folder)])
    assert sources(folder) == dict(NEW) == sources(folder, "06-tuning.ipynb")
    assert "new or changed: 2" in capsys.readouterr().out
    command.main(["update", str(folder)])
    assert "Nothing is new" in capsys.readouterr().out


def test_update_keeps_answers_and_cells_of_ones_own(package, folder):
    write(folder, [*OLD[:2], ("task", "answer = 7"), ("mine", "my = 1")])
    ship(package, NEW)
    command.main(["update", str(folder)])
    assert sources(folder) == dict(NEW) | {"task": "answer = 7", "mine": "my = 1"}
    ship(package, OLD)  # and once more, from the version of that update
    command.main(["update", str(folder)])
    assert sources(folder) == dict(OLD) | {"task": "answer = 7", "mine": "my = 1"}


def test_update_keeps_a_damaged_lesson_beside_the_new_one(package, folder, capsys):
    (folder / NAME).write_text("{")
    ship(package, NEW)
    command.main(["update", str(folder)])
    assert sources(folder) == dict(NEW) and (folder / f"mine-{NAME}").read_text() == "{"
    assert "could not be read" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["reset"], "Which lesson"),
        (["reset", "77", "."], "There is no lesson 77"),
        (["reset", "5", "nowhere-at-all"], "There are no lessons in nowhere-at-all"),
        (["update", "nowhere-at-all"], "There are no lessons in nowhere-at-all"),
        (["update", "a", "b"], "One folder, please, found 2"),
    ],
)
def test_what_it_cannot_do_it_says(package, words, said):
    with pytest.raises(SystemExit, match=said):
        command.main(words)


def test_in_a_clone_the_lessons_are_the_clones_own():
    assert shipped.notebooks() == ROOT / "notebooks"
    assert shipped.settings() == ROOT
    assert [path.name[:2] for path in shipped.lessons()][:3] == ["00", "01", "02"]
    assert {"appendix-notation.md", "teaching-guide.md"} <= {path.name for path in shipped.others()}


def test_the_first_lesson_is_that_of_the_makefile():
    (first,) = re.findall(r"^FIRST := (\S+)$", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    assert first == shipped.FIRST
