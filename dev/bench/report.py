"""All benchmarks in one run: `make bench`. Prints them, and writes BENCHMARKS.md with a description of the machine."""

import os
import platform
import re
import sys
from importlib.metadata import version
from pathlib import Path

from dev.bench import filters, fitting, footprint, gaps, goals, online, playground, rival_races, targets

TARGET = footprint.ROOT / "BENCHMARKS.md"
PACKAGES = (
    "numpy",
    "scipy",
    "matplotlib",
    "anywidget",
    "ipywidgets",
    "jupyterlab",
    "filterpy",
    "simdkalman",
    "statsmodels",
)
HEAD = "# Benchmarks\n\nWritten by `make bench`, not by hand. {machine}\n\nLoad average at the start: {load}.\n"
SPEED = """## Filters

Time for all runs; ratio: time of the rival / time of kflearn. Agreement is checked before. The goal is the ratio to
FilterPy; to the others it is 1. What is short of its goal is in bold, with the word "short".
"""
GAPS = "\n## Gaps\n\nWhole readings are missing; the same rivals. FilterPy's smoother is timed on a part.\n"
ONLINE = "\n## One reading at a time\n\nOne step; FilterPy's predict_update takes its Jacobian before the prediction.\n"
OTHERS = """
## Rivals with an environment of their own

{versions}. Ratio: time of the rival / time of kflearn, in bold where the rival is quicker. The first call compiles,
where JAX is used; the time is the best of three calls after it. Processor: how much of one the rival had; far below
100 % the machine was busy with other things. "The end only": it keeps the last estimate, not all.
"""
TARGETS = """
## Whose reading is it? Beside Stone Soup

{versions}. One boat among false readings. The gate, the weights, means and covariances agree before a time is told.
Stone Soup takes one run at a time; the goal is 30 for a scan.
"""
FITS = (
    "\n## Parameters from data\n\nA random walk without a start; statsmodels loops over the series, timed on 20 of "
    "them, pykalman on 3.\n"
)
PICTURES = (
    "## From slider to picture\n\nIn JupyterLab, in headless Chromium; a filter over 200 steps, two axes, 800 × 500. "
    "Medians of five rounds.\n"
)


def processor():
    """The name of the processor, as far as the system tells."""
    try:
        found = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    except OSError:
        found = None
    return found[1] if found else platform.processor() or platform.machine()


def machine():
    """The machine and the versions, in a sentence."""
    memory = f", {os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 1e9:.0f} GB" if os.name == "posix" else ""
    packages = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    where = f"{processor()}, {os.cpu_count()} cores{memory}; {platform.system()}"
    return f"Machine: {where}. Python {platform.python_version()}, {packages}."


def load_average():
    return ", ".join(f"{each:.1f}" for each in os.getloadavg()) if hasattr(os, "getloadavg") else "unknown"


def report(tests=True):
    """The lines of BENCHMARKS.md; without the time of the whole test run, if that was asked for."""
    yield HEAD.format(machine=machine(), load=load_average())
    yield SPEED
    yield from filters.table(map(filters.run, filters.races()))
    yield GAPS
    yield from gaps.table()
    yield ONLINE
    yield from online.table()
    yield FITS
    yield from fitting.table()
    yield OTHERS.format(versions=rival_races.versions())
    yield from rival_races.table()
    yield TARGETS.format(versions=targets.versions())
    yield from targets.table()
    yield f"\n{PICTURES}"
    yield from playground.table(playground.race())
    yield "\n## Footprint\n"
    yield from footprint.table(tests)


WHY = {
    "fit": "the filter's steps are array operations, which Python starts one by one where statsmodels' are compiled; "
    "and the search looks at first values wrong by many powers of ten before it climbs, and once more at the end",
    "sea": "with few readings a scan of one run is some thirty small array operations, which Python starts one by one",
    "memory": "its cells keep the tracks of several filters over 500 runs, with all predictions and innovations",
    "smoothed": "the smoother's passes over all means, several for each step of every run, take most of the time",
    "IMM": "three filters and their mixing are many small array operations a step, which Python starts one by one",
    "EKF": "the Jacobians are called from Python at every step, as a learner's own would be",
    "UKF": "the sigma points go through Python functions at every step; dynamax compiles them",
    "kflearn's filter": "after a gap the gains are computed anew until they rest again",
    "gap": "after a gap the gains are computed anew until they rest again",
    "missing": "after a gap the gains are computed anew until they rest again",
    "GPS: 1,000 x 80$": "the ratio depends on the processor: on another one, the same day, it was 777",
    "velocity: 1 x 100,000$": "the ratio depends on the processor: on another one, the same day, it was 357",
    "key": "the kernel's own time is a tenth of it; the rest is Jupyter's and the browser's, on two processors",
    "kernel's milliseconds": "several programs share two processors here; most of it is the filter over 200 steps",
    "pictures for each movement": "it follows from the kernel's time: two requests at most are under way",
}


def short(lines):
    """A paragraph that names the rows in which something is short of its goal, and what is known of the reason."""
    names = [line.split("|")[1].strip() for line in lines if re.search(rf"\*\*[^|]*, {goals.SHORT}\*\*", line)]
    reasons = [f"- {name}: {why}." for name in names for key, why in WHY.items() if re.search(key, name)]
    return "\n".join([f"\nShort of a goal: {'; '.join(names) or 'nothing'}.", *dict.fromkeys(reasons)])


def main():
    lines = []
    for line in report(tests="quick" not in sys.argv):
        print(line, flush=True)
        lines.append(line)
    lines.append(short(lines))
    print(lines[-1])
    TARGET.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
