"""What a wheel carries besides the package, and the forms for those who have found something."""

import os
import subprocess
import tomllib

import yaml

from tests.dev.command import ROOT, run


def test_the_wheel_carries_the_lessons_and_the_settings(tmp_path):
    run("setup.py", "--quiet", "build_py", "--build-lib", tmp_path)
    carried = tmp_path / "kflearn" / "lessons"
    for folder, patterns in {
        "notebooks": ("[0-9][0-9]-*.ipynb", "appendix-*.md", "teaching-guide.md", "pictures/*.png"),
        ".": ("jupyter_server_config.py", "labconfig/*.json"),
    }.items():
        there = carried / ("settings" if folder == "." else folder)
        for pattern in patterns:
            ours = sorted((ROOT / folder).glob(pattern))
            assert ours
            for path in ours:
                assert (there / path.relative_to(ROOT / folder)).read_bytes() == path.read_bytes()
    assert not list(carried.glob("notebooks/mine-*")), "somebody's own work"
    assert (tmp_path / "kflearn" / "course" / "data").is_dir()


def test_a_kernel_needs_no_jupyterlab_and_the_command_is_there():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lessons = project["optional-dependencies"]["lessons"]
    assert not any(name.startswith("jupyterlab") for name in lessons)
    assert any(name.startswith("ipykernel") for name in lessons)
    assert project["scripts"]["kflearn"] == "kflearn.lessons.command:main"


def test_forms_can_be_read():
    forms = sorted((ROOT / ".github" / "ISSUE_TEMPLATE").glob("[!c]*.yml"))
    assert len(forms) == 3
    for path in forms:
        form = yaml.safe_load(path.read_text(encoding="utf-8"))
        assert form["name"] and form["description"]
        for part in form["body"]:
            assert part["type"] in ("input", "textarea") and part["id"] and part["attributes"]["label"]


def test_the_workflow_tries_every_python_that_the_project_names():
    flow = yaml.safe_load((ROOT / ".github" / "workflows" / "test.yml").read_text(encoding="utf-8"))
    assert flow["jobs"]["test"]["strategy"]["matrix"]["python"] == ["3.11", "3.12", "3.13", "3.14"]


def test_findings_are_told_one_a_line_and_a_change_is_an_error(tmp_path):
    """With two scripts of our own in place of the real ones, which install packages."""
    (tmp_path / "findings").mkdir()
    (tmp_path / "findings" / "a.sh").write_text("echo all the same\n")
    (tmp_path / "findings" / "b.sh").write_text("echo this has changed\nexit 1\n")
    (tmp_path / "Makefile").write_bytes((ROOT / "Makefile").read_bytes())
    told = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS"))}
    done = subprocess.run(["make", "findings"], cwd=tmp_path, env=told, capture_output=True, text=True)
    assert done.returncode != 0
    assert "as described  findings/a.sh\n" in done.stdout
    assert "CHANGED       findings/b.sh\nthis has changed\n" in done.stdout


def test_each_finding_says_what_it_must():
    scripts = sorted((ROOT / "findings").glob("*.sh"))
    assert len(scripts) >= 12
    for path in scripts:
        text = path.read_text(encoding="utf-8")
        assert path.stat().st_mode & 0o100, f"{path.name} cannot be run"
        for word in ("# Expected:", "# Seen", "# Who is hurt:", "# Exit status 0:", "set -eu", "trap ", "=="):
            assert word in text, f"{path.name} lacks {word}"
        assert "kflearn" not in text
        assert "this has changed" in text
