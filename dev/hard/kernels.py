"""Kernels for lessons: in which Python, with which packages and variables."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import NamedTuple

import nbformat
from jupyter_client import AsyncKernelManager
from jupyter_client.kernelspec import KernelSpecManager
from nbclient import NotebookClient

ROOT = Path(__file__).parents[2]
GUARD = Path(__file__).parent / "guard"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = "lessons", "lab"
NEEDED = [*PROJECT["dependencies"], *(each for extra in EXTRAS for each in PROJECT["optional-dependencies"][extra])]


class Machine(NamedTuple):
    """Where lessons run: an interpreter, what stands before its name, and variables that are set there."""

    python: str = sys.executable
    prefix: tuple = ()
    env: dict = {}  # noqa: RUF012

    def variables(self):
        """All variables. Where HARD_LOG is set, the guard comes with them."""
        return os.environ | self.env | ({"PYTHONPATH": str(GUARD)} if "HARD_LOG" in self.env else {})


@contextmanager
def kernel(path, machine=None, folder=ROOT / "notebooks"):
    """A client of nbclient for a lesson, with a fresh kernel; errors in cells stay in their outputs."""
    machine = machine or Machine()
    with tempfile.TemporaryDirectory() as home:
        argv = [*machine.prefix, machine.python, "-m", "ipykernel_launcher", "-f", "{connection_file}"]
        place = Path(home, "kernels", "lesson", "kernel.json")
        place.parent.mkdir(parents=True)
        place.write_text(json.dumps(dict(argv=argv, display_name="lesson", language="python")), encoding="utf-8")
        specs = KernelSpecManager(kernel_dirs=[str(place.parent.parent)])
        how = dict(env=machine.variables() | {"IPYTHONDIR": home}, stderr=subprocess.DEVNULL)  # the kernel's own log
        with ExitStack() as stack:
            yield started(stack, path, specs, folder, how)


def started(stack, path, specs, folder, how, attempts=3):
    """A client with its kernel. One that dies at once, as when another has just taken its port, gets a successor."""
    client = NotebookClient(
        nbformat.read(path, as_version=4),
        km=AsyncKernelManager(kernel_name="lesson", kernel_spec_manager=specs),
        timeout=300,
        allow_errors=True,
        store_widget_state=False,
        coalesce_streams=True,
        resources={"metadata": {"path": str(folder)}},
    )
    try:
        stack.enter_context(client.setup_kernel(cleanup_kc=True, **how))
    except RuntimeError:
        if attempts == 1:
            raise
        return started(stack, path, specs, folder, how, attempts - 1)
    return client


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


# ---- environments


def version(python):
    """(3, 12, 1) of an interpreter, or None where the command does not work."""
    show = "import sys, venv, ensurepip; print(*sys.version_info[:3])"
    done = subprocess.run([python, "-c", show], capture_output=True, text=True)
    return tuple(map(int, done.stdout.split())) if done.returncode == 0 else None


def pythons():
    """{version: interpreter} of all that can be found: on the path, and those of pyenv."""
    found = [shutil.which(f"python3.{minor}") for minor in range(11, 30)]
    if shutil.which("pyenv"):
        root = subprocess.run(["pyenv", "root"], capture_output=True, text=True).stdout.strip()
        found += sorted(map(str, Path(root, "versions").glob("3.*/bin/python3")))
    found = {version(python): python for python in [*filter(None, found), sys.executable]}
    return {which: python for which, python in found.items() if which and which >= (3, 11)}


def newest_python():
    """The newest interpreter that this machine has."""
    return max(pythons().items())[1]


def python(which):
    """The interpreter of a version such as "3.11"."""
    return max((v, path) for v, path in pythons().items() if which == ".".join(map(str, v[:2])))[1]


def oldest_pins():
    """The lower ends of the ranges in pyproject.toml: "numpy>=2.2" gives "numpy==2.2.*"."""
    return [re.sub(r"^([\w-]+)>=([\d.]+).*", r"\1==\2.*", each) for each in NEEDED]


def environment(python, pins=()):
    """The interpreter of an environment in build/ with the course and its dependencies, made if there is none yet."""
    wanted = repr((version(python), sorted(NEEDED), sorted(pins)))
    place = ROOT / "build" / f"environment-{hashlib.sha256(wanted.encode()).hexdigest()[:12]}"
    inside = place / "bin" / "python"
    if not (place / "ready").exists():
        shutil.rmtree(place, ignore_errors=True)
        subprocess.run([python, "-m", "venv", place], check=True)
        install = [inside, "-m", "pip", "install", "--quiet", "--editable", f"{ROOT}[{','.join(EXTRAS)}]", *pins]
        subprocess.run(install, check=True, capture_output=True)
        (place / "ready").touch()
    return str(inside)
