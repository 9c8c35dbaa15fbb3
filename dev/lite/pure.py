"""The packages without compiled code that lessons need: their wheels fit every Python, that in a browser too."""

import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]
SITE = ("anywidget", "comm", "filterpy", "gpxpy", "ipywidgets", "jupyterlab_widgets", "psygnal", "pykalman", "pymap3d")
SITE = (*SITE, "pynmea2", "scikit-base", "simdkalman")
ANY = [
    "--no-deps",
    "--only-binary=:all:",
    "--platform=any",
    "--implementation=py",
    "--abi=none",
    "--python-version=3.14",
]


def pins():
    """{name: version} of all packages of the course's environment."""
    lines = (ROOT / "requirements.txt").read_text(encoding="utf-8").splitlines()
    return dict(line.partition(";")[0].strip().split("==") for line in lines if "==" in line)


def needed():
    """What a lesson imports besides kflearn: the names in the extra `lessons`, without the kernel, which is there."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    names = [re.split(r"[<>=!~\[ ]", line)[0] for line in project["optional-dependencies"]["lessons"]]
    return [name for name in names if name != "ipykernel"]


def pip(*command):
    """Run pip in this environment; stops with its words if it fails."""
    done = subprocess.run([sys.executable, "-m", "pip", *map(str, command)], cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"pip {' '.join(map(str, command))}\n{done.stdout}\n{done.stderr}")


def fetch(names, folder):
    """Wheels of packages, in the versions of the course, into a folder."""
    versions = pins()
    pip("download", "--quiet", *ANY, "--dest", folder, *(f"{name}=={versions[name]}" for name in names))


def wheel(folder):
    """The wheel of kflearn as it is here, into a folder; made from a copy, because setuptools leaves traces."""
    with tempfile.TemporaryDirectory() as here:
        copy = Path(here, "course")
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".*", "build", "*.egg-info", "__pycache__"))
        pip("wheel", "--quiet", "--no-deps", "--wheel-dir", folder, copy)
