"""The teacher's side: slides, the class server, the load of a class, the guide, the conda environment."""

import os
import re
import shutil
import subprocess
import sys
import tomllib

import nbformat
import pytest
import yaml

from dev.lessons import lessons
from tests.dev.command import ROOT, run

LESSONS = lessons()
GUIDE = (ROOT / "notebooks" / "teaching-guide.md").read_text(encoding="utf-8")


# ---- the load of a class


def test_a_class_of_three_moves_its_sliders():
    printed = run("-m", "dev.teaching.load", "3", "--lesson", "04", "--moves", "6", "--pause", "0.2")
    assert "3 kernels, lesson 04-gaussian-fusion" in printed
    size = re.search(r"memory of a kernel +RSS +(\d+) MB", printed)
    assert 50 < int(size[1]) < 500
    for name in ("at work", "all at once"):
        half, most, moves = map(int, re.search(rf"{name} +(\d+) ms +(\d+) ms +(\d+)", printed).groups())
        assert 0 < half <= most < 10_000
        assert moves >= 12


# ---- Binder and conda


def conda_packages():
    """What environment.yml asks for, in pip's words: (requirements, Python's version)."""
    asked = yaml.safe_load((ROOT / "environment.yml").read_text(encoding="utf-8"))["dependencies"]
    by_pip = next(each["pip"] for each in asked if isinstance(each, dict))
    plain = [each.replace("matplotlib-base", "matplotlib") for each in asked if isinstance(each, str)]
    python = next(each for each in plain if each.startswith("python="))
    packages = [each for each in plain if each not in (python, "pip")]
    return sorted(packages + [each for each in by_pip if each != "--editable ."]), python.partition("=")[2]


def test_conda_and_pip_get_the_same_packages():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    packages, python = conda_packages()
    assert packages == sorted(project["dependencies"] + extras["lessons"] + extras["lab"])
    oldest, below = (int(minor) for minor in re.findall(r"3\.(\d+)", project["requires-python"]))
    assert oldest <= int(python.removeprefix("3.")) < below


@pytest.mark.timeout(900)
@pytest.mark.skipif("KFLEARN_BUILD" not in os.environ, reason="builds a new environment: set KFLEARN_BUILD=1")
def test_the_packages_of_environment_yml_run_a_lesson(tmp_path):
    """A real build of the same packages, by pip: without conda this is as near as one comes."""
    copy, python = tmp_path / "course", tmp_path / "env" / "bin" / "python"
    ignored = shutil.ignore_patterns(".*", "build", "*.egg-info", "__pycache__")
    shutil.copytree(ROOT, copy, ignore=ignored)
    packages, _ = conda_packages()
    for command in (
        [sys.executable, "-m", "venv", tmp_path / "env"],
        [python, "-m", "pip", "install", "--quiet", *packages],
        [python, "-m", "pip", "install", "--quiet", "--no-deps", "--editable", copy],
        [python, "-m", "pip", "check"],
        [python, "-m", "dev.notebooks", "notebooks/04-gaussian-fusion.ipynb"],
    ):
        subprocess.run(list(map(str, command)), cwd=copy, check=True)
    printed = [
        [output.text for cell in nbformat.read(root / "notebooks/04-gaussian-fusion.ipynb", as_version=4).cells
         for output in cell.get("outputs", []) if output.output_type == "stream"]
        for root in (copy, ROOT)
    ]  # fmt: skip
    assert printed[0] == printed[1]


# ---- the guide


def times():
    """{lesson: minutes}, as the lessons say themselves."""
    return {
        path.name: int(re.search(r"\*Time\*: (\d+) minutes", path.read_text(encoding="utf-8"))[1]) for path in LESSONS
    }


def part(heading):
    """A section of the guide, from its heading to the next one of any size."""
    return re.search(rf"^#+ {re.escape(heading)}.*?(?=^#+ |\Z)", GUIDE, re.MULTILINE | re.DOTALL)[0]


def rows(heading):
    """The rows of the table in a section, without its head."""
    lines = [line for line in part(heading).splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def lesson_in(cell):
    found = re.search(r"\]\((\d\d-[\w-]+\.ipynb)\)", cell)
    return found and found[1]


def test_the_guide_tells_every_lesson_and_its_minutes():
    minutes = times()
    told = re.findall(r"\]\((\d\d-[\w-]+\.ipynb)\) (?:·|\|) (\d+)", GUIDE)
    assert {name for name, _ in told} == set(minutes)
    assert [(name, int(number)) for name, number in told] == [(name, minutes[name]) for name, _ in told]
    for path in LESSONS:
        title = nbformat.read(path, as_version=4).cells[0].source.splitlines()[0].removeprefix("# ")
        section = part(f"[{title}]({path.name})")
        assert "**Ask.**" in section and "?" in section
        assert section.partition("**You will hear.**")[2].count("\n- ") >= 2


def test_the_guides_links_lead_somewhere():
    for link in re.findall(r"\]\(([^)\s]+)\)", GUIDE):
        assert (ROOT / "notebooks" / link).exists(), link
    for target in set(re.findall(r"(?:^|`)make (\w+)", GUIDE, re.MULTILINE)):
        assert re.search(rf"^{target}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE), target


def test_the_route_of_90_minutes():
    *lessons, together = rows("90 minutes")
    assert sum(int(row[1]) for row in lessons) == int(together[1]) == 90


def test_the_route_of_one_day():
    def clock(text):
        hours, minutes = map(int, text.split(":"))
        return 60 * hours + minutes

    *steps, end = rows("One day")
    for step, following in zip(steps, [*steps[1:], end], strict=True):
        assert clock(step[0]) + int(step[2]) == clock(following[0])
    assert sum(int(step[2]) for step in steps) == int(end[2]) == clock(end[0]) - clock(steps[0][0])
    assert f"From {steps[0][0]} to {end[0]}" in part("One day")


def test_the_route_of_a_semester():
    *weeks, sums = rows("A semester")
    sessions = [session for week in weeks for session in ((week[1], int(week[2])), (week[3], int(week[4])))]
    assert [int(week[0]) for week in weeks] == list(range(1, 16)) and all(minutes <= 75 for _, minutes in sessions)
    held = [lesson_in(name) for name, _ in sessions]
    assert held == [path.name for path in LESSONS], "every lesson once, in order"
    lessons = sum(minutes for _, minutes in sessions)
    assert int(sums[2]) == lessons
    text = " ".join(part("A semester").split())
    assert f"lessons take {lessons:,}. The {2250 - lessons} that are left" in text
