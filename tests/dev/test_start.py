"""What README and the Makefile say to a newcomer, and what they do: one address, one number, what is kept."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from dev import prepare
from tests.dev.command import ROOT, make, run

README = (ROOT / "README.md").read_text(encoding="utf-8")
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
HEAVY = ["ipywidgets", "filterpy", "jupyterlab", "jupyter_server", "nbformat", "nbclient"]


def test_every_way_opens_the_same_page():
    (first,) = re.findall(r"^FIRST := (\S+)$", MAKEFILE, re.MULTILINE)
    (opened,) = re.findall(r"/jupyter lab .*?(--LabApp.*)", MAKEFILE)
    ways = re.findall(r"^\S*jupyter lab (.*)$", README, re.MULTILINE)
    assert len(ways) == 3, "without make, on Windows, with conda"
    assert set(ways) == {opened.replace("$(FIRST)", first)}
    assert (ROOT / "notebooks" / first).exists()


def test_readme_and_screen_say_the_same_numbers():
    for text in (prepare.MAKING, prepare.ADDING):
        (minutes,) = re.findall(r"\w+ to \w+ minutes", text)
        assert minutes in README
    more = prepare.pins("requirements-more.txt")
    assert f"{more} more packages" in README
    assert "python3 -m dev.prepare" in README
    (site,) = re.findall(r"^site:.*?(about \w+ minutes on two cores)", MAKEFILE, re.MULTILINE)
    assert site in re.search(r"(?m)^\| `make site`.*$", README)[0]


def test_readme_names_all_that_an_update_does_to_a_clone():
    messages = re.findall(r'"--message", "(.*?)"', (ROOT / "dev/update.py").read_text(encoding="utf-8"))
    assert len(messages) == 2
    for message in messages:
        assert f"*{message}*" in README


def test_the_example_runs_without_what_the_lessons_need():
    (example,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    blocked = f"import sys; sys.modules.update(dict.fromkeys({HEAVY}))\n"
    everything = "import kflearn\nfor name in kflearn.__all__:\n    getattr(kflearn, name)\n"
    printed = run("-c", blocked + example + everything)
    assert re.fullmatch(r"\d+\.\d m raw, \d+\.\d m filtered\n", printed)


@pytest.mark.parametrize("goal", ["test", "quick"])
def test_whether_lessons_hold_somebodys_work_is_asked_first(goal):
    commands = make(ROOT, "--dry-run", goal, "MORE=", "CI=").splitlines()
    assert commands[0].endswith("-m dev.lessons")
    assert len(commands) > 3


@pytest.fixture
def built(tmp_path):
    for name in ("Makefile", "build/site/index.html", ".venv/bin/python", ".ruff_cache/any"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(MAKEFILE if name == "Makefile" else "")
    return tmp_path


def test_clean_says_what_it_removes_and_leaves_nothing_empty(built):
    printed = make(built, "clean")
    assert printed.startswith("removing .venv")
    assert [path.name for path in built.iterdir()] == ["Makefile"]
    assert make(built, "clean") == ""


def test_what_the_outer_make_was_told_is_not_handed_on(built, monkeypatch):
    monkeypatch.setenv("MAKEFLAGS", " -- VENV=.venv-system")
    assert make(built, "clean").startswith("removing .venv:")


def test_clean_keeps_a_class(built):
    (built / "build/assignment").mkdir()
    assert "build/ keeps what belongs to a class: assignment" in make(built, "clean")
    assert [path.name for path in (built / "build").iterdir()] == ["assignment"]


# ---- the environment


@pytest.fixture
def asked(monkeypatch, tmp_path):
    """An environment that is complete, and a list of what would be installed into it."""
    found = []
    monkeypatch.setattr(prepare, "install", lambda folder, uv, what, wanted: found.append(what[-1]))
    monkeypatch.setattr(prepare, "complete", lambda folder: Path(folder, "ready").exists())
    monkeypatch.setattr(prepare, "new_environment", lambda folder, uv: None)
    return found


def test_what_is_there_is_not_announced_again(asked, tmp_path, capsys):
    folder = str(tmp_path)
    prepare.bring(folder, None, [])
    assert asked == ["requirements.txt", "."] and "is being made" in capsys.readouterr().out
    asked.clear()
    prepare.bring(folder, None, ["requirements-more.txt"])
    said = capsys.readouterr().out
    assert asked == ["requirements-more.txt", "."]
    assert f"{prepare.pins('requirements-more.txt')} more packages" in said and "this once" not in said


def test_an_older_environment_is_brought_up_to_date(asked, tmp_path, capsys, monkeypatch):
    prepare.bring(str(tmp_path), None, [])
    assert not prepare.outdated(str(tmp_path))
    monkeypatch.setattr(prepare, "ROOT", str(tmp_path))
    for name in ("requirements.txt", "pyproject.toml", "requirements-more.txt"):
        (tmp_path / name).write_text("any==1\n")
    old = (tmp_path / "requirements.txt").stat().st_mtime - 10
    prepare.os.utime(tmp_path / "ready", (old, old))
    asked.clear()
    prepare.bring(str(tmp_path), None, ["requirements-more.txt"])
    assert asked == ["requirements.txt", "requirements-more.txt", "."]
    assert "brought up to date" in capsys.readouterr().out
    assert not prepare.outdated(str(tmp_path))


# ---- lessons in which somebody has worked: here the ruff of the tests sees what `make test` would


def test_ruff_leaves_out_what_learners_make(tmp_path):
    (tmp_path / "pyproject.toml").write_text((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (tmp_path / "notebooks").mkdir()
    cells = '{"cells": [{"cell_type": "code", "id": "a", "metadata": {}, "outputs": [], "execution_count": null, '
    bad = cells + '"source": ["import os,  sys"]}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}'
    for name in ("mine-05-voltmeter", "Untitled", "my notes", "05-voltmeter-Copy1"):
        (tmp_path / "notebooks" / f"{name}.ipynb").write_text(bad)
    ruff = [sys.executable, "-m", "ruff"]
    for command in (["check", "."], ["format", "--check", "."]):
        done = subprocess.run([*ruff, *command], cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
    (tmp_path / "notebooks" / "05-voltmeter.ipynb").write_text(bad)
    assert subprocess.run([*ruff, "check", "."], cwd=tmp_path, capture_output=True).returncode == 1
