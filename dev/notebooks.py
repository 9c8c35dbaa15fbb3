"""Execute lessons again, in place, so that doing it twice changes nothing.

    python -m dev.notebooks                        all lessons that git knows
    python -m dev.notebooks notebooks/04-*.ipynb   some

Each notebook runs in a fresh kernel. Kept are outputs and execution counts; dropped is what differs from run to run or
from machine to machine: timings, kernel details, and the ids of widgets, which mean nothing without their kernel (the
picture beside them stays, and that is what GitHub, print and a reopened notebook show).
"""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from dev.lessons import FOLDER, METADATA, WIDGET, notebooks


def execute(notebook, folder=FOLDER):
    """Run all cells of a notebook (a nbformat node) in place; an error in a cell is raised."""
    NotebookClient(
        notebook,
        timeout=60,
        kernel_name="python3",
        resources={"metadata": {"path": str(folder)}},
        extra_arguments=["--log-level=ERROR"],  # the kernel's own log
        record_timing=False,
        store_widget_state=False,
        coalesce_streams=True,
    ).execute()
    return notebook


def tidy(notebook):
    """Drop what is different each time."""
    notebook.metadata = nbformat.from_dict(METADATA)
    for cell in notebook.cells:
        cell.metadata = nbformat.from_dict({k: v for k, v in cell.metadata.items() if k == "tags"})
        for output in cell.get("outputs", []):
            if "data" in output:
                output.data.pop(WIDGET, None)
    return notebook


def main(paths):
    for path in paths or notebooks():
        notebook = nbformat.read(path, as_version=4)
        nbformat.write(tidy(execute(notebook)), path)
        print(Path(path).name)


if __name__ == "__main__":
    main([Path(p) for p in sys.argv[1:]])
