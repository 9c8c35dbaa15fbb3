"""What the course costs a learner's machine, and its maintainers: import time, memory of a kernel, time of the tests.

python -m dev.bench.footprint
"""

import re
import statistics
import subprocess
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from dev import lessons
from dev.bench.goals import SHORT
from dev.teaching import load

ROOT = Path(__file__).parents[2]

CLOCK = "import time; begun = time.perf_counter(); import {}; print(time.perf_counter() - begun)"
PEAK = r"""
import re, resource
try:
    with open("/proc/self/status") as status:
        print(1024 * int(re.search(r"VmHWM:\s*(\d+)", status.read())[1]))  # its own; that of `resource` is inherited
except OSError:  # macOS
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""
LARGEST = 3  # lessons in the table
MEMORY = 450  # MB that a whole lesson's kernel may take


def import_time(module, rounds=7):
    """Seconds that a fresh Python takes to import a module: the median."""
    command = [sys.executable, "-c", CLOCK.format(module)]
    times = [float(subprocess.run(command, check=True, capture_output=True).stdout) for _ in range(rounds)]
    return statistics.median(times)


def kernels(chosen=None):
    """{lesson: megabytes} that a kernel has needed at most when a whole lesson has run in it; by default of all."""
    paths = lessons.lessons()
    return {path.stem: most_memory(path) for path in paths if chosen is None or path.stem[:2] in chosen}


def most_memory(path):
    """Megabytes, the largest RSS of a kernel while it runs all cells of a lesson."""
    notebook = nbformat.read(path, as_version=4)
    notebook.cells.append(nbformat.v4.new_code_cell(PEAK))
    resources = {"metadata": {"path": str(path.parent)}}
    how = dict(extra_arguments=["--log-level=ERROR"], coalesce_streams=True, resources=resources)
    NotebookClient(notebook, timeout=600, kernel_name="python3", **how).execute(env=load.ENVIRONMENT)
    return float(notebook.cells[-1].outputs[0].text) / 1e6


def test_run():
    """Seconds of the whole test run, and its last words. Raises CalledProcessError when a test fails."""
    begun = time.monotonic()
    command = [sys.executable, "-m", "pytest", "-q", "-n", "2"]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    return time.monotonic() - begun, re.search(r"\d+ passed[^=\n]*?(?= in )", done.stdout)[0]


def table(tests=True):
    """The lines of a table in Markdown."""
    yield "| | |"
    yield "|---|---:|"
    numpy, ours = import_time("numpy"), import_time("kflearn")
    yield f"| import numpy | {1e3 * numpy:.0f} ms |"
    yield f"| import kflearn, NumPy included | {1e3 * ours:.0f} ms |"
    whole = kernels()
    for lesson in sorted(whole, key=whole.get)[-LARGEST:]:
        used = f"{whole[lesson]:.0f} MB" if whole[lesson] <= MEMORY else f"**{whole[lesson]:.0f} MB, {SHORT}**"
        yield f"| memory of a kernel, the whole of lesson {lesson}, goal {MEMORY} MB | {used} |"
    yield f"| the same, the median of all {len(whole)} lessons | RSS {statistics.median(whole.values()):.0f} MB |"
    yield "| memory of a JupyterLab server | RSS {:.0f} MB, PSS {:.0f} MB |".format(*load.server_memory())
    if tests:
        seconds, words = test_run()
        yield f"| `pytest -n 2`: {words} | {seconds // 60:.0f} min {seconds % 60:.0f} s |"


if __name__ == "__main__":
    print("\n".join(table(tests=False)))
