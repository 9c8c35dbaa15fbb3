"""The playground of every lesson on a full grid of its controls, not only at their ends.

`lines` executes each lesson in a kernel of its own, up to its last playground; in there `everywhere` does the rest.
"""

import asyncio
import math
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import nbformat

from dev import lessons as course
from dev.hard.line import Line
from kflearn.ui import Playground
from kflearn.ui.controls import Slider

ROOT = Path(__file__).parents[2]
MOST = 250  # settings of a playground
KERNELS = 2  # at once
START = "from dev.hard import grid as _grid"  # a lesson may have a name "grid" of its own
SWEEP = "print(*(_grid.everywhere(thing, {most}) for thing in _grid.shown(globals())))"


def lines(quick):
    lessons = course.lessons()
    lessons, most = (lessons[5:6], 20) if quick else (lessons, MOST)
    with ThreadPoolExecutor(KERNELS) as pool:
        found = list(pool.map(lambda path: attempt(path, most), lessons))
    counts = [count for result in found if isinstance(result, list) for count in result]
    told = zip(lessons, found, strict=True)
    faults = [f"; {path.stem[:2]}: {result}" for path, result in told if isinstance(result, str)]
    yield Line(
        f"{len(counts)} playgrounds on a grid of their controls",
        f"{sum(counts)} settings, {min(counts, default=0)} to {max(counts, default=0)} each",
        f"{len(lessons)} lessons: finite, no warning" + "".join(faults),
        not faults,
    )


def attempt(path, most):
    """How many settings of each playground of a lesson were tried, or what went wrong."""
    try:
        return sweep(path, most)
    except Exception as error:
        return " ".join(str(error).split()[-40:])


def sweep(path, most):
    """The numbers of settings that `everywhere` tried in a lesson."""
    return [int(count) for count in inside(path, START, SWEEP.format(most=most)).split()]


def inside(path, first, last):
    """Run a lesson up to its last playground in a kernel of its own, with code around it; what the end prints."""
    from nbclient import NotebookClient

    from dev.teaching.load import cells_up_to_playground

    sources = [first, *cells_up_to_playground(path), last]
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in sources])
    resources = {"metadata": {"path": str(path.parent)}}
    environment = os.environ | {"PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    how = dict(extra_arguments=["--log-level=ERROR"], coalesce_streams=True, resources=resources)
    client = NotebookClient(notebook, timeout=600, kernel_name="python3", **how)
    asyncio.run(client.async_execute(env=environment))
    return "".join(output.get("text", "") for output in notebook.cells[-1].outputs)


def shown(names):
    """The playgrounds of a lesson."""
    return {id(thing): thing for thing in names.values() if isinstance(thing, Playground)}.values()


def everywhere(playground, most):
    """Try a grid of settings as `Playground.sweep` tries the ends; how many there were."""
    for control, values in zip(playground.controls.values(), places(playground, most), strict=True):
        control.ends = lambda values=values: values
    return playground.sweep()


def places(playground, most):
    """The values of each control: all buttons; of sliders both ends, the start, and as many others as `most` allows."""
    from dev.web.frames import spread

    controls = list(playground.controls.values())
    values = [spread(control, 3) if isinstance(control, Slider) else control.options for control in controls]
    sliders = [i for i, control in enumerate(controls) if isinstance(control, Slider)]
    for count in range(4, most):
        for i in sliders:
            finer = [*values[:i], spread(controls[i], count), *values[i + 1 :]]
            if math.prod(map(len, finer)) > most:
                return values
            values = finer
    return values
