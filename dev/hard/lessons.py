"""The lessons as learners run them, on the machines that learners have.

Skipped: random cells are left out, some are run twice, and the kernel is restarted half-way. A cell may then fail, but
only because a name is missing that a cell left out would have defined: plain Python, which a learner can read. Twice:
all cells, and all again in the same kernel, print what is stored in the lesson. Machines: the oldest and the newest of
what pyproject.toml allows, with a Chinese locale, a folder of lessons that cannot be written to, and no network.
"""

import json
import random
import re
import shutil
import subprocess
import symtable
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from jupyter_core.utils import ensure_event_loop
from nbclient.exceptions import DeadKernelError

from dev.hard.kernels import ROOT, Machine, code_cells, environment, kernel, newest_python, oldest_pins, python
from dev.hard.line import Line, none
from dev.lessons import lessons

LESSONS = lessons()
AT_ONCE = 2  # kernels beside each other
PLAIN = "errors: only NameError of what was left out"
FORGETFUL = {"hint()"}  # what gives more each time it is asked, as it should
SOLVED = """
from kflearn.exercises.engine import exercises_of
print(sum(each.check(each._answer()).status != "right" for each in exercises_of(exercises)))
"""
STAINLESS = """
from kflearn.ui import Playground
print(sum(value.errors for value in globals().values() if isinstance(value, Playground)))
"""


def each(task, lessons=LESSONS):
    """What a task finds in every lesson, a few lessons at a time: one list of faults."""

    def tidily(lesson):
        try:
            return task(lesson)
        finally:
            ensure_event_loop().close()  # the one nbclient made for this thread

    with ThreadPoolExecutor(AT_ONCE) as pool:
        return [fault for faults in pool.map(tidily, lessons) for fault in faults]


# ---- cells


def run(client, cell):
    """Run a cell of the client's notebook; its error (name, value), or None."""
    client.execute_cell(cell, client.nb.cells.index(cell))
    return next(((o.ename, o.evalue) for o in cell.outputs if o.output_type == "error"), None)


def printed(cell):
    """The words of a cell's outputs: what it prints, and its value."""
    outputs = (o for o in cell.outputs if o.get("name") != "stderr")
    return "".join(o.get("text") or o.get("data", {}).get("text/plain", "") for o in outputs)


def ask(client, code):
    """What a piece of code prints that stands in no cell."""
    cell = client.nb.cells[-1].copy()
    cell.update(cell_type="code", source=code, outputs=[], execution_count=None)
    client.nb.cells.append(cell)
    error = run(client, cell)
    return str(error) if error else printed(cell).strip()


def defined(cell):
    """The names that a cell binds."""
    names = symtable.symtable(cell.source, "cell", "exec").get_symbols()
    return {name.get_name() for name in names if name.is_assigned() or name.is_imported()}


# ---- as learners run them


def skipping(path):
    """Run the playground alone, then half of the cells, one in five of them twice; restart, and carry on somewhere."""
    rng, faults = random.Random(path.stem), []
    with kernel(path) as client:
        cells = code_cells(client.nb)
        half = [cell for cell in cells if "Playground(" in cell.source or rng.random() < 0.5]
        alone = [cell for cell in half if "Playground(" in cell.source]
        twice = [cell for cell in half for _ in range(rng.choice([1, 1, 1, 1, 2]))]
        faults += unexplained(client, cells, [*alone, *twice])
    with kernel(path) as client:
        cells, start = code_cells(client.nb), rng.randrange(len(cells))
        faults += unexplained(client, cells, cells[start : start + 8])
    return [f"{path.stem[:2]} {fault}" for fault in faults]


def unexplained(client, cells, chosen):
    """The errors of the chosen cells other than that a name is missing which no cell has defined that ran so far."""
    faults = []
    missing = set().union(*map(defined, cells))
    for cell in chosen:
        try:
            error = run(client, cell)
        except DeadKernelError:
            return [*faults, "the kernel died"]
        if not error:
            missing -= defined(cell)
            continue
        name = re.match(r"name '(\w+)' is not defined", error[1])
        if not (error[0] == "NameError" and name and name[1] in missing):
            faults.append(f"cell {cells.index(cell)}, {error[0]}: {error[1]}"[:60])
    return faults


# ---- on their machines


def all_cells(path, machine, folder, times=1):
    """Run all cells, `times` times in a kernel: nothing fails, all print what is stored.

    In the end all exercises can be solved, and no picture has met an error.
    """
    faults = []
    with kernel(path, machine, folder) as client:
        cells = code_cells(client.nb)
        stored = [printed(cell) for cell in cells]
        for time in range(times):
            for i, cell in enumerate(cells):
                if error := run(client, cell):
                    faults.append(f"cell {i}, {error[0]}: {error[1]}"[:60])
                elif printed(cell) != stored[i] and not (time and any(word in cell.source for word in FORGETFUL)):
                    faults.append(f"cell {i} prints {printed(cell)[:20]!r}")
        for code, wrong in ((STAINLESS, "errors in pictures"), (SOLVED, "exercises not solved")):
            if (found := ask(client, code)) != "0":
                faults.append(f"{wrong}: {found}")
    return [f"{path.stem[:2]} {fault}" for fault in faults]


def without_rights(folder):
    """A copy of the lessons in a folder that cannot be written to, and what has to stand before a command so that this
    holds for root too: there the right to ignore the rights of files is given up."""
    shutil.copytree(ROOT / "notebooks", folder, ignore=shutil.ignore_patterns("kernel-*", ".*"))
    for place in (folder, *folder.rglob("*")):
        place.chmod(0o555 if place.is_dir() else 0o444)
    give_up = [(), ("setpriv", "--bounding-set=-dac_override")]
    return next((list(prefix) for prefix in give_up if not writable(folder, prefix)), None)


def writable(folder, prefix):
    """Can a process write into a folder?"""
    attempt = [*prefix, sys.executable, "-c", f"open({str(folder / 'new')!r}, 'x', encoding='utf-8')"]
    done = subprocess.run(attempt, capture_output=True) if shutil.which(attempt[0]) else None
    (folder / "new").unlink(missing_ok=True)
    return done is None or done.returncode == 0


def chinese(folder, charmap):
    """Variables for a Chinese locale. Where the machine has none it is made; where it cannot be, there is plain ASCII,
    which is stricter still."""
    name = f"zh_CN.{charmap}"
    if shutil.which("localedef"):
        command = ["localedef", "--no-archive", "-i", "zh_CN", "-f", charmap, str(folder / name)]
        subprocess.run(command, capture_output=True)
    return dict(LC_ALL=name, LANG=name, LANGUAGE="zh", LOCPATH=str(folder), PYTHONUTF8="0", PYTHONCOERCECLOCALE="0")


def output(machine, code):
    """What a machine prints for a piece of code."""
    command = [*machine.prefix, machine.python, "-c", code]
    return subprocess.run(command, env=machine.variables(), capture_output=True, text=True).stdout.strip()


ENCODING = "import locale; print(locale.getencoding())"
CALL = """
import socket
for reach in (lambda: socket.create_connection(("192.0.2.1", 80), 1), lambda: socket.getaddrinfo("example.org", 80)):
    try:
        reach()
        print("reached")
    except PermissionError:
        print("refused")
"""


def on_machine(what, interpreter, charmap, lessons, times):
    """The lines for a machine: lessons, and what was taken from them."""
    with tempfile.TemporaryDirectory() as place:
        place = Path(place)
        log, folder = place / "log", place / "notebooks"
        prefix = without_rights(folder)
        guarded = chinese(place, charmap) | dict(HARD_LOG=str(log), PYTHONWARNDEFAULTENCODING="1")
        machine = Machine(interpreter, tuple(prefix or ()), guarded)
        refused, own = output(machine, CALL).split() == ["refused"] * 2, calls(log)
        faults = each(partial(all_cells, machine=machine, folder=folder, times=times), lessons)
        tried = calls(log)[len(own) :]
        language = f"{charmap} locale ({output(machine, ENCODING)})"
        tried_on = f"{len(lessons)} lessons" + " twice" * (times > 1)
        kept = prefix is not None and not writable(folder, machine.prefix) and not list(folder.glob(".prog*"))
        yield none(f"{what}, {language}", faults, tried_on, "same words, no error")
        yield Line("    the folder of the lessons", "read-only" if kept else "writable", "read-only", kept)
        yield Line("    network: attempts", f"{len(tried)}, {len(own)} of ours refused", "0", refused and not tried)
        for path in (folder, *folder.rglob("*")):
            path.chmod(0o755)


def calls(log):
    """The attempts to reach another machine that were noted."""
    return log.read_text(encoding="utf-8").splitlines() if log.exists() else []


def unnamed_encodings(*places):
    """Files opened without an encoding, as ruff finds them."""
    ruff = [Path(sys.executable).with_name("ruff"), "check", "--isolated", "--preview", "--select", "PLW1514"]
    command = [*ruff, "--no-cache", "--output-format", "json", *places]
    found = json.loads(subprocess.run(command, cwd=ROOT, capture_output=True, text=True).stdout)
    return [f"{Path(each['filename']).name}:{each['location']['row']}" for each in found]


def lines(quick):
    """The lines of the table."""
    lessons = LESSONS[5:6] if quick else LESSONS
    found = each(skipping, lessons)
    yield none("playground alone; random cells, some twice; restart", found, f"{len(lessons)} lessons", PLAIN)
    found = unnamed_encodings("kflearn", "dev", "class")
    yield none("files opened without an encoding", found, "kflearn, dev, class")
    if quick:
        yield from on_machine("here", sys.executable, "GBK", lessons, 1)
        return
    yield from on_machine("newest", environment(newest_python()), "GBK", lessons, 2)
    yield from on_machine("oldest", environment(python("3.11"), oldest_pins()), "UTF-8", lessons, 1)
