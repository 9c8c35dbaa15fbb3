"""A lesson as it was when it came; what the learner had made of it is kept beside it: `make reset LESSON=05`."""

import sys

from dev.lessons import lessons, original
from kflearn.lessons.copies import put_back

NO_CLONE = """This folder was not made by `git clone`, so the original lesson is not in it.
Fetch the course again: its lessons are as they came."""


def main(number):
    path = next((path for path in lessons() if path.name.startswith(f"{number:0>2}-")), None)
    if path is None:
        sys.exit(f"There is no lesson {number}.")
    new = original(path) or sys.exit(NO_CLONE)
    print(put_back(path, new))


if __name__ == "__main__":
    main(sys.argv[1]) if len(sys.argv) == 2 else sys.exit("Which lesson? For instance: make reset LESSON=05")
