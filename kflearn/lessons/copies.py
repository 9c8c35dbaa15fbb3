"""A learner's copy of a lesson: put back as it came, or brought up to date with the learner's cells kept."""

import itertools
from pathlib import Path

OPEN = "If a lesson is open and JupyterLab says File Changed, choose Revert."


def aside(path) -> Path:
    """A free name for the learner's version, beside it: mine-05-…, mine-05-…-2."""
    names = itertools.chain([f"mine-{path.stem}"], (f"mine-{path.stem}-{i}" for i in itertools.count(2)))
    return next(free for name in names if not (free := path.with_name(f"{name}{path.suffix}")).exists())


def put_back(path, original) -> str:
    """Write the bytes `original` to the path, and keep what was there beside it; returns a sentence that says so."""
    if path.exists() and path.read_bytes() == original:
        return f"{path.name} is as it came: nothing to reset."
    if not path.exists():
        path.write_bytes(original)
        return f"{path.name} was not there. Now it is, as it came."
    kept = aside(path)
    path.rename(kept)
    path.write_bytes(original)
    return f"{path.name} is as it came. Yours is {kept.name}, beside it. {OPEN}"


def merge(base, mine, new):
    """The new notebook with the learner's cells in it. All three are nbformat nodes; `new` is changed and returned."""
    known = {cell.id: cell.source for cell in base.cells}
    sources, place = set(known.values()), 0
    for cell in mine.cells:
        at = next((i for i, other in enumerate(new.cells) if other.id == cell.id), None)
        if cell.source == known.get(cell.id) or (cell.id not in known and cell.source in sources):
            pass  # not the learner's work
        elif at is not None:
            new.cells[at] = cell
        elif cell.source.strip():
            at = place
            new.cells.insert(at, cell)
        place = place if at is None else at + 1
    return new


def own_work(base, mine) -> bool:
    """Has the learner changed or added a cell, or taken one away? Both are nbformat nodes."""
    return [(cell.id, cell.source) for cell in base.cells] != [(cell.id, cell.source) for cell in mine.cells]
