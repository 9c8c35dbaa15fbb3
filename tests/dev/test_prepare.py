"""The first command: which Python is taken, what is said when none fits, what happens to an environment half made."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from dev import prepare

ROOT = Path(__file__).parents[2]

PLACES = [(f"3.{minor}.0", "x86_64-manylinux_2_28") for minor in range(11, 15)] + [("3.11.2", "x86_64-manylinux_2_28")]
OTHERS = ["aarch64-manylinux_2_28", "windows", "aarch64-apple-darwin", "x86_64-apple-darwin"]
PLACES += [(python, platform) for platform in OTHERS for python in ("3.11.0", "3.14.0")]


def program(folder, name, says, code=0):
    """A program that prints a line."""
    path = folder / name
    path.write_text(f"#!/bin/sh\necho {says}\nexit {code}\n")
    path.chmod(0o755)
    return path


def old(monkeypatch, path):
    """As if this were Python 3.10.13, with nothing on the PATH but a folder."""
    monkeypatch.setattr(prepare.sys, "version_info", (3, 10, 13))
    monkeypatch.setenv("PATH", str(path))


def test_a_python_that_is_too_old_says_so_before_anything_is_made(monkeypatch, tmp_path):
    old(monkeypatch, tmp_path)
    with pytest.raises(SystemExit) as stopped:
        prepare.new_environment(str(tmp_path / "env"), uv=None)
    assert str(stopped.value).startswith("The course needs Python 3.11 to 3.14; this is Python 3.10.13")
    assert not (tmp_path / "env").exists()


@pytest.mark.skipif(os.name != "posix", reason="programs as Unix has them")
def test_another_python_that_fits_is_taken(monkeypatch, tmp_path, capsys):
    program(tmp_path, "python3.14", "nothing", code=127)  # as pyenv's, when it is not chosen
    program(tmp_path, "python3.12", "3.12.1")
    old(monkeypatch, tmp_path)
    assert prepare.suitable() == str(tmp_path / "python3.12")
    assert "Taking python3.12" in capsys.readouterr().out


def test_the_limits_are_those_of_the_package():
    asked = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["requires-python"]
    (least, minor), (below, top) = (map(int, found) for found in re.findall(r"(\d+)\.(\d+)", asked))
    assert asked == f">={least}.{minor},<{below}.{top}"
    assert ((least, minor), (below, top - 1)) == (prepare.OLDEST, prepare.NEWEST)
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert f"Python 3.{prepare.OLDEST[1]} to 3.{prepare.NEWEST[1]}" in readme
    assert prepare.NEEDS.endswith("3.11 to 3.14")


def test_an_environment_half_made_is_made_anew(tmp_path, capsys):
    folder = tmp_path / "env"
    (folder / "lib" / "python3.10").mkdir(parents=True)
    assert not prepare.complete(str(folder))
    prepare.new_environment(str(folder), uv=None)
    assert "was not complete" in capsys.readouterr().out
    assert not (folder / "lib" / "python3.10").exists()
    assert not prepare.complete(str(folder)), "nothing is installed yet"
    (folder / "ready").touch()
    assert prepare.complete(str(folder))


@pytest.mark.skipif(os.name != "posix", reason="programs as Unix has them")
def test_a_python_without_venv_names_the_package(monkeypatch, tmp_path):
    python = program(tmp_path, "python3", "no module named ensurepip", code=1)
    monkeypatch.setattr(prepare, "suitable", lambda: str(python))
    with pytest.raises(SystemExit, match="sudo apt install python3-venv"):
        prepare.new_environment(str(tmp_path / "env"), uv=None)


@pytest.mark.skipif(os.name != "posix", reason="programs as Unix has them")
def test_what_fails_shows_its_last_lines(monkeypatch, tmp_path):
    (tmp_path / prepare.PROGRAMS).mkdir()
    program(tmp_path / prepare.PROGRAMS, "python", "no matching distribution", code=1)
    monkeypatch.setattr(prepare.time, "sleep", lambda seconds: None)
    with pytest.raises(SystemExit, match=r"(?s)no matching distribution.*Is the Internet reachable") as stopped:
        prepare.install(str(tmp_path), None, ["--requirement", "any.txt"], 1)
    assert "install.log" in str(stopped.value)


def test_progress_is_counted(monkeypatch, tmp_path, capsys):
    (tmp_path / "a.dist-info").mkdir()
    log = tmp_path / "log"
    log.write_text("Collecting one\nCollecting two\n")
    steps = iter([None, None, None, 0])

    class Installer:
        returncode = 0

        def poll(self):
            return next(steps)

    news = iter(["", "b", "c"])

    def wait(seconds):
        if name := next(news):
            (tmp_path / f"{name}.dist-info").mkdir()

    monkeypatch.setattr(prepare.time, "sleep", wait)
    assert prepare.follow(Installer(), str(log), str(tmp_path), 3) == 0
    said = capsys.readouterr().out
    assert [line.strip() for line in said.splitlines() if line.strip()] == [
        "fetched 2 of 3 packages",
        "installed 1 of 3 packages",
        "installed 2 of 3 packages",
        "installed 3 of 3 packages",
    ]


def test_the_version_is_the_same_everywhere():
    import kflearn

    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.search(r"^## (\S+)", changes, re.MULTILINE)[1] == kflearn.__version__
    assert f"\nversion: {kflearn.__version__}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert project["tool"]["setuptools"]["dynamic"]["version"] == {"attr": "kflearn.__version__"}


def names(text):
    """The packages in a list of pins, each with its version."""
    found = re.findall(r"^([\w.-]+)==([^\s;]+)", text, re.MULTILINE)
    return {(name.lower().replace("_", "-"), number) for name, number in found}


@pytest.mark.skipif("KFLEARN_BUILD" not in os.environ, reason="asks PyPI: set KFLEARN_BUILD=1")
@pytest.mark.parametrize(("python", "platform"), PLACES)
def test_the_pins_fit_every_python_and_are_complete(python, platform):
    """uv resolves them, from ready-made files only, and finds nothing that would have to come beside them."""
    files = ["requirements.txt", "requirements-more.txt"]
    options = ["--only-binary", ":all:", "--python-version", python, "--python-platform", platform]
    done = subprocess.run(
        [shutil.which("uv") or Path(sys.executable).with_name("uv"), "pip", "compile", *files, *options, "--quiet"],
        cwd=ROOT,
        env=os.environ | {"MACOSX_DEPLOYMENT_TARGET": "14.0"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    pinned = set().union(*(names((ROOT / file).read_text(encoding="utf-8")) for file in files))
    resolved = names(done.stdout)
    assert resolved <= pinned, "these would be installed in any version"
