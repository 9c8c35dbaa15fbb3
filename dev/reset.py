"""A lesson as it was when it came; what the learner had made of it is kept beside it: `make reset LESSON=05`."""

import itertools
import sys

from dev.lessons import lessons, original
from dev.update import OPEN

NO_CLONE = """This folder was not made by `git clone`, so the original lesson is not in it.
Fetch the course again: its lessons are as they came."""


def aside(path):
    """A free name for the learner's version."""
    names = itertools.chain([f"mine-{path.stem}"], (f"mine-{path.stem}-{i}" for i in itertools.count(2)))
    return next(free for name in names if not (free := path.with_name(f"{name}.ipynb")).exists())


def main(number):
    path = next((path for path in lessons() if path.name.startswith(f"{number:0>2}-")), None)
    if path is None:
        sys.exit(f"There is no lesson {number}.")
    new = original(path) or sys.exit(NO_CLONE)
    if path.read_bytes() == new:
        print(f"{path.name} is as it came: nothing to reset.")
        return
    kept = aside(path)
    path.rename(kept)
    path.write_bytes(new)
    print(f"{path.name} is as it came. Yours is {kept.name}, beside it. {OPEN}")


if __name__ == "__main__":
    main(sys.argv[1]) if len(sys.argv) == 2 else sys.exit("Which lesson? For instance: make reset LESSON=05")
