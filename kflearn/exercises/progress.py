"""The learner's progress: which exercises are solved, in one small file beside the notebooks.

The file may be deleted, or damaged, or be read-only: then progress starts anew, or is not kept, and nothing else
changes. Several notebooks may note at one instant: one writes, the others wait for it. Only exercises solved in a
notebook's kernel are noted, beside lesson 0 (looked for in the kernel's folder, in those above it and in their folders
`notebooks`), or wherever the environment variable KFLEARN_PROGRESS names a file.
"""

import contextlib
import html
import json
import os
import re
import sys
import time
from importlib import import_module
from pathlib import Path

NAME, FIRST = ".progress.json", "00-start-here.ipynb"
NOT_KEPT = f"(The tick is not kept: this kernel was not started in the folder of {FIRST}.)"
PATIENCE = 6.0  # seconds to wait for other notebooks that are writing; then the tick is not kept
ABANDONED = 3.0  # seconds after which a lock belongs to a kernel that has died: writing takes a thousandth of that


def place() -> Path | None:
    """The file, or None where progress is not kept."""
    if named := os.environ.get("KFLEARN_PROGRESS"):
        return Path(named)
    home = folder() if in_notebook() else None
    return home and home / NAME


def in_notebook() -> bool:
    """Does this run in a notebook's kernel?"""
    return "ipykernel" in sys.modules


def folder() -> Path | None:
    """The folder of the lessons: the kernel's own, one above it, or `notebooks` in one of these."""
    here = Path.cwd()
    near = (each for above in (here, *list(here.parents)[:3]) for each in (above, above / "notebooks"))
    return next((each for each in near if (each / FIRST).exists()), None)


def solved() -> set[str]:
    """The names "lesson.exercise" of all that is solved; an empty set where the file is missing or damaged."""
    file = place()
    try:
        names = json.loads(file.read_text(encoding="utf-8"))["solved"]
        return {name for name in names if isinstance(name, str)}
    except (AttributeError, OSError, ValueError, KeyError, TypeError):
        return set()


def note(module, name) -> None:
    """Note an exercise as solved; where the file cannot be written, nothing happens.

    Parameters
    ----------
    module : str
        The module of the lesson's exercises, such as "kflearn.exercises.voltmeter".
    name : str
        The exercise's name.
    """
    file, key = place(), f"{module.rpartition('.')[2]}.{name}"
    if file is None or key in solved():
        return
    with contextlib.suppress(OSError), _alone(file):
        known = solved() | {key}  # read again, now that nobody else writes
        new = file.with_name(f"{file.name}.{os.getpid()}.new")
        try:
            new.write_text(json.dumps({"solved": sorted(known)}, indent=1), encoding="utf-8")
            os.replace(new, file)
        finally:
            new.unlink(missing_ok=True)


@contextlib.contextmanager
def _alone(file):
    """Hold the lock beside a file: the lock is a file too, and only one can make it. TimeoutError when it stays held."""
    lock, deadline = file.with_name(f"{file.name}.lock"), time.monotonic() + PATIENCE
    while True:
        try:
            os.close(os.open(lock, os.O_CREAT | os.O_EXCL))
            break
        except FileExistsError:
            if time.monotonic() > deadline:
                raise TimeoutError(f"{lock} is held") from None
            with contextlib.suppress(OSError):
                if time.time() - lock.stat().st_mtime > ABANDONED:
                    lock.unlink()
            time.sleep(0.002)
    try:
        yield
    finally:
        lock.unlink(missing_ok=True)


def lessons(folder=".") -> list[tuple]:
    """What each lesson in a folder asks.

    Parameters
    ----------
    folder : str or Path
        Where the notebooks are.

    Returns
    -------
    list of (file name, title, [exercise names], module)
        Only of lessons that have exercises.
    """
    found = []
    for path in sorted(Path(folder).glob("[0-9][0-9]-*.ipynb")):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        text = "\n".join("".join(cell["source"]) for cell in cells)
        module = re.search(r"^from kflearn\.exercises import (\w+) as exercises$", text, re.MULTILINE)
        if module:
            names = list(dict.fromkeys(re.findall(r"exercises\.(\w+)\.check\(", text)))
            found.append((path.name, text.splitlines()[0].lstrip("# "), names, module[1]))
    return found


def table(where=None) -> "Table":
    """What is solved and what is not, lesson by lesson, with links.

    Parameters
    ----------
    where : str or Path, optional
        The folder of the notebooks; found by itself when not given.

    Returns
    -------
    Table
        To be shown by the last line of a cell.

    Examples
    --------
    >>> from kflearn.exercises import progress
    >>> progress.table()
    Run this cell in JupyterLab: a table of the exercises you have solved, lesson by lesson.
    """
    return Table(where or folder() or ".")


class Table:
    """Rows of lessons with ticks; its words never change, so that a stored notebook stays true."""

    def __init__(self, folder):
        self.folder = folder

    def __repr__(self):
        return "Run this cell in JupyterLab: a table of the exercises you have solved, lesson by lesson."

    def html(self) -> str:
        """The table as HTML."""
        if not (found := lessons(self.folder)):
            return f"<p>No lessons here: open this notebook beside {FIRST}, and run the cell again.</p>"
        known, rows, total = solved(), [], 0
        for file, title, names, module in found:
            done = [f"{module}.{name}" in known for name in names]
            total += len(names)
            ticks = " ".join("✓" if one else "○" for one in done)
            link = f'<a href="{html.escape(file)}" target="_blank">{html.escape(title)}</a>'
            rows.append(f"<tr><td>{link}</td><td>{ticks}</td><td>{sum(done)} of {len(done)}</td></tr>")
        mine = sum(f"{m}.{n}" in known for _, _, names, m in found for n in names)
        return f"<table>{''.join(rows)}<tr><td>all</td><td></td><td>{mine} of {total}</td></tr></table>"

    def _repr_mimebundle_(self, **_):
        ipywidgets = import_module("ipywidgets")
        return ipywidgets.HTML(self.html())._repr_mimebundle_() | {"text/plain": repr(self)}
