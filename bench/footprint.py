"""What the course costs a learner's machine, and its maintainers: import time, memory of a kernel, time of the tests.

python bench/footprint.py
"""

import asyncio
import re
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path.append(str(ROOT / "tools"))
import load  # noqa: E402

CLOCK = "import time; begun = time.perf_counter(); import {}; print(time.perf_counter() - begun)"


def import_time(module, rounds=7):
    """Seconds that a fresh Python takes to import a module: the median."""
    command = [sys.executable, "-c", CLOCK.format(module)]
    times = [float(subprocess.run(command, check=True, capture_output=True).stdout) for _ in range(rounds)]
    return statistics.median(times)


def kernels(lessons=("05", "14", "20")):
    """{lesson: (RSS, PSS)} in MB of a kernel in which a lesson has run up to its playground and a slider has moved."""
    found = [asyncio.run(load.measure(1, lesson, moves=10, pause=0.0)) for lesson in lessons]
    return {each["lesson"]: (each["rss"], each["pss"]) for each in found}


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
    for lesson, (rss, pss) in kernels().items():
        yield f"| memory of a kernel, lesson {lesson} | RSS {rss:.0f} MB, PSS {pss:.0f} MB |"
    yield "| memory of a JupyterLab server | RSS {:.0f} MB, PSS {:.0f} MB |".format(*load.server_memory())
    if tests:
        seconds, words = test_run()
        yield f"| `pytest -n 2`: {words} | {seconds // 60:.0f} min {seconds % 60:.0f} s |"


if __name__ == "__main__":
    print("\n".join(table(tests=False)))
