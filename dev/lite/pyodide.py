"""Pyodide without its compiled packages, for the tests: its core from npm, and what it has of pure Python from PyPI.

With it a browser boots Python, and installs what has no compiled code, without any public server at that moment.
"""

import hashlib
import json
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path

from dev.lite import pure

BOOT = ("micropip", "packaging", "ipython", "jedi")  # what JupyterLite's kernel itself asks of Pyodide
NEEDED = ("matplotlib", "narwhals", "pandas", "scipy", "traitlets", "typing-extensions")  # of which some are compiled


def core(version, folder):
    """Pyodide's core from npm into a folder; returns whether npm gave it."""
    npm = shutil.which("npm")
    if not npm:
        return False
    with tempfile.TemporaryDirectory() as here:
        command = [npm, "pack", "--silent", "--fetch-retries=0", "--fetch-timeout=60000", f"pyodide@{version}"]
        if subprocess.run(command, cwd=here, capture_output=True, timeout=120).returncode:
            return False
        with tarfile.open(Path(here, f"pyodide-{version}.tgz")) as files:
            files.extractall(here, filter="data")
        shutil.move(Path(here, "package"), folder)
    return True


def all_of(names, packages):
    """These packages of Pyodide and all that they depend on."""
    found, left = {}, list(names)
    while left:
        name = left.pop().lower().replace("_", "-")
        if name not in found:
            found[name] = packages[name]
            left += packages[name]["depends"]
    return found


def add_pure(folder):
    """Give that folder the wheels without compiled code that a lesson asks for, and say so in its list of packages."""
    lock = folder / "pyodide-lock.json"
    listed = json.loads(lock.read_text(encoding="utf-8"))
    for each in all_of((*BOOT, *NEEDED), listed["packages"]).values():
        if each["file_name"].endswith("-none-any.whl"):
            with tempfile.TemporaryDirectory() as here:
                pure.pip("download", "--quiet", *pure.ANY, "--dest", here, f"{each['name']}=={each['version']}")
                (wheel,) = Path(here).iterdir()
                shutil.copy(wheel, folder)
            each["file_name"] = wheel.name
            each["sha256"] = hashlib.sha256((folder / wheel.name).read_bytes()).hexdigest()
    lock.write_text(json.dumps(listed), encoding="utf-8")


def without_compiled(version, folder):
    """Both; returns whether npm gave the core."""
    if not core(version, folder):
        return False
    add_pure(folder)
    return True
