"""All benchmarks in one run: `make bench`. Prints them, and writes BENCHMARKS.md with a description of the machine."""

import os
import platform
import re
from importlib.metadata import version
from pathlib import Path

from dev.bench import filters, footprint, playground

TARGET = footprint.ROOT / "BENCHMARKS.md"
PACKAGES = "numpy", "scipy", "matplotlib", "ipywidgets", "jupyterlab", "filterpy", "simdkalman", "statsmodels"
HEAD = "# Benchmarks\n\nWritten by `make bench`, not by hand. {machine}\n\nLoad average at the start: {load}.\n"
SPEED = "## Filters\n\nTime for all runs; ratio: time of the rival / time of kflearn. Agreement is checked before.\n"
PICTURES = (
    "## From slider to picture\n\nIn JupyterLab, in headless Chromium; a filter over 200 steps, two axes, 800 × 500.\n"
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


def report():
    """The lines of BENCHMARKS.md."""
    yield HEAD.format(machine=machine(), load=load_average())
    yield SPEED
    yield from filters.table(map(filters.run, filters.races()))
    yield f"\n{PICTURES}"
    yield from playground.table(playground.race())
    yield "\n## Footprint\n"
    yield from footprint.table()


def main():
    lines = []
    for line in report():
        print(line, flush=True)
        lines.append(line)
    TARGET.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
