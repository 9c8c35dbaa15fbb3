"""Build the package as it would be published, and try it in new environments, far from the clone: `make wheel`.

The two files come into build/dist. Needs a package index, and some five minutes.
"""

import os
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).parent.parent
DIST = ROOT / "build" / "dist"
PROGRAMS = "Scripts" if os.name == "nt" else "bin"
TRY = """
import importlib.util as find, pathlib, sys
import anywidget, filterpy, ipykernel, kflearn, kflearn.ui
from kflearn.lessons import shipped
came, clone = pathlib.Path(kflearn.__file__).parent, pathlib.Path(sys.argv[1])
assert came not in clone.parents and clone not in came.parents, "this is the clone's kflearn"
assert not find.find_spec("jupyterlab"), "a kernel does not need JupyterLab"
lessons, theirs = shipped.lessons(), sorted((clone / "notebooks").glob("[0-9][0-9]-*.ipynb"))
assert [path.name for path in lessons] == [path.name for path in theirs], "not all lessons came"
assert all(one.read_bytes() == two.read_bytes() for one, two in zip(lessons, theirs)), "a lesson came changed"
assert (shipped.settings() / "labconfig" / "page_config.json").exists(), "Jupyter's settings did not come"
print(f"kflearn {kflearn.__version__}: {len(lessons)} lessons came with it")
"""


def new_environment(folder) -> Path:
    """The folder of the programs of a new environment."""
    venv.create(folder, with_pip=True)
    return Path(folder, PROGRAMS)


def say(*command, cwd, **options):
    """Run a command away from the clone; stops with its output if it fails."""
    env = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run([str(part) for part in command], cwd=cwd, env=env, capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def build(folder):
    """The wheel, made from the sdist, and the sdist; both are looked at by twine."""
    tools = new_environment(folder / "tools")
    say(tools / "pip", "install", "--quiet", "build", "twine", cwd=folder)
    for old in DIST.glob("kflearn-*"):
        old.unlink()
    say(tools / "python", "-m", "build", "--outdir", DIST, ROOT, cwd=folder)
    print(say(tools / "twine", "check", "--strict", *sorted(DIST.glob("kflearn-*")), cwd=folder).strip())
    (wheel,), (sdist,) = DIST.glob("*.whl"), DIST.glob("*.tar.gz")
    return wheel, sdist


def attempt(file, folder):
    """Install a file with what a lesson's kernel needs, and use the command where it needs no JupyterLab."""
    new = new_environment(folder / file.suffix.strip("."))
    say(new / "pip", "install", "--quiet", f"kflearn[lessons] @ {file.as_uri()}", cwd=folder)
    print(
        f"{file.name}: {file.stat().st_size / 1e6:.1f} MB; {say(new / 'python', '-c', TRY, ROOT, cwd=folder).strip()}"
    )
    mine = folder / f"mine-{file.suffix}"
    opened = subprocess.run([new / "kflearn", "open", mine], cwd=folder, capture_output=True, text=True)
    if "pip install" not in opened.stderr:
        sys.exit(f"kflearn open does not say that JupyterLab is missing: {opened.stderr}")
    (lesson,) = mine.glob("05-*.ipynb")
    lesson.write_text("{}", encoding="utf-8")
    print(say(new / "kflearn", "reset", "05", mine, cwd=folder).strip())


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder).resolve()
        for file in build(folder):
            attempt(file, folder)


if __name__ == "__main__":
    main()
