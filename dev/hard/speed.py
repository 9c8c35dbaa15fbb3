"""Speed: as quick as promised, and never quicker than right: agreement is checked before anything is timed.

The measurements are those of `make bench`, which also times the tests and writes BENCHMARKS.md.
"""

from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import numpy as np
import pandas as pd

from dev.bench import filters, footprint, playground
from dev.hard.line import Line
from kflearn import recordings

FEWER = ("voltmeter", "EKF")  # races of a quick run
IMPORT = 1.0  # kflearn's own share, in times of NumPy's
READING = 1.5  # times pandas' own time for the same table
KERNEL = 800  # MB; the class server gives each process 2 GB of data, of which not all is in memory


def lines(quick):
    for race in filters.races():
        if not quick or race.name.startswith(FEWER):
            yield from ratios(filters.run(race, 5 if quick else 25))
    if not quick:
        yield from pictures(playground.race())
    yield import_line()
    yield reading(5 if quick else 15)
    yield memory(["05"] if quick else None)


def ratios(result):
    """FilterPy must be slower by the race's goal; the other rivals are named, and must be slower at all."""
    race = result.race
    for rival, seconds in result.rivals.items():
        ratio, goal = seconds / result.ours, race.goal if rival == "FilterPy" else 1
        yield Line(f"{race.name}, beside {rival}", f"{ratio:,.0f} times as quick", f"≥ {goal:g}", ratio >= goal)
    yield Line(
        "  largest difference",
        f"{result.difference:.0e}",
        f"< {race.tolerance:.0e}",
        result.difference < race.tolerance,
    )


def pictures(results):
    """The playground in JupyterLab beside `interact`, and beside the one before."""
    for what, figure, goal, at_most in playground.ratios(results):
        good = figure <= goal if at_most else figure >= goal
        yield Line(what, f"{figure:.2g}", f"{'≤' if at_most else '≥'} {goal:g}", good)


def import_line():
    numpy, ours = footprint.import_time("numpy"), footprint.import_time("kflearn")
    share = (ours - numpy) / numpy
    words = f"{1e3 * (ours - numpy):.0f} ms, {share:.2f} of NumPy's"
    return Line("import kflearn, after NumPy", words, f"< {IMPORT:g} of NumPy's", share < IMPORT)


def reading(times, rows=1_000_000):
    """A million rows of a time and three columns, beside pandas alone; the quickest of several."""
    table = np.random.default_rng(0).normal(size=(rows, 3)).round(4)
    frame = pd.DataFrame(table, columns=["x", "y", "z"]).set_axis(np.arange(rows) / 100)
    with TemporaryDirectory() as folder:
        path = Path(folder, "big.csv")
        frame.to_csv(path, index_label="t [s]")
        seconds = [[_seconds(f, path) for f in (pd.read_csv, recordings.read)] for _ in range(times)]
    pandas, ours = np.min(seconds, axis=0)
    words = f"{ours / pandas:.2f} of pandas' {pandas:.2f} s"
    return Line(
        f"recordings.read, {rows:,} rows of 4 columns", words, f"≤ {READING:g} of pandas'", ours <= READING * pandas
    )


def _seconds(function, path):
    begin = perf_counter()
    function(path)
    return perf_counter() - begin


def memory(lessons):
    sizes = footprint.kernels(lessons)
    largest = max(sizes, key=sizes.get)
    what = f"memory of a learner's kernel, most of {len(sizes)} whole lessons"
    return Line(what, f"{sizes[largest]:.0f} MB, {largest}", f"< {KERNEL} MB", sizes[largest] < KERNEL)
