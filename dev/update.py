"""Bring the course up to date, and keep the learner's answers: `make update`.

Git merges. Of a lesson it takes the new text and the new outputs; the cells that the learner has changed or added stay
as the learner left them (cells are recognised by their ids). What was there before is in a commit of its own.
"""

import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

from kflearn.lessons.copies import OPEN, merge

ROOT = Path(__file__).parent.parent
NAME = ["-c", "user.name=learner", "-c", "user.email=learner@localhost"]
NO_CLONE = """This folder was not made by `git clone`, so there is nothing to update it from.
Fetch the course again, into a new folder; your answers stay in this one."""


def git(*command, check=True):
    """What a git command prints."""
    done = subprocess.run(["git", "-C", ROOT, *command], capture_output=True, text=True, check=False)
    if check and done.returncode:
        sys.exit(f"git {command[0]}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout.strip()


# ---- one lesson


def merge_files(base, mine, new, path):
    """Git's merge driver: writes the merged lesson into the file `mine`."""
    import nbformat  # only here: whoever is up to date need not wait for it

    notebooks = [nbformat.read(file, as_version=4) for file in (base, new)]
    try:
        own = nbformat.read(mine, as_version=4)
    except Exception:  # whatever is wrong with a damaged file
        spare = Path(ROOT, path).with_name(f"mine-{Path(path).name}")
        spare.write_bytes(Path(mine).read_bytes())
        print(f"{path} could not be read: it is kept as {spare.name}, and the new lesson is in its place.")
        own = notebooks[0]
    nbformat.write(merge(notebooks[0], own, notebooks[1]), mine)


# ---- the whole course


def step_aside():
    """Rename files of the learner's own that have the names of new files of the course."""
    for name in git("diff", "--name-only", "--diff-filter=A", "HEAD...@{upstream}").splitlines():
        path = ROOT / name
        if path.exists() and not git("ls-files", name):
            path.rename(path.with_name(f"mine-{path.name}"))
            print(f"{name} is new in the course. Your file of that name is now mine-{path.name}.")


def settle():
    """End a merge in which a file was deleted on one side and changed on the other: the changed one stays."""
    for line in git("status", "--porcelain").splitlines():
        state, name = line[:2], line[3:]
        if state in ("DU", "UD"):
            git("checkout", "--theirs" if state == "DU" else "--ours", "--", name)
            git("add", "--", name)
    git(*NAME, "commit", "--no-edit", "--quiet")


def update():
    if not git("rev-parse", "--abbrev-ref", "@{upstream}", check=False):
        sys.exit(NO_CLONE)
    git("fetch", "--quiet")
    changed = git("diff", "--name-only", "HEAD...@{upstream}").splitlines()
    if not changed:
        print("Nothing is new.")
        return
    if git("status", "--porcelain", "--untracked-files=no"):
        git(*NAME, "commit", "--all", "--quiet", "--message", "My work before an update")
    step_aside()
    driver = f"{shlex.quote(sys.executable)} {shlex.quote(__file__)} --merge %O %A %B %P"
    with tempfile.TemporaryDirectory() as folder:
        attributes = Path(folder, "attributes")
        attributes.write_text("*.ipynb merge=lesson\n", encoding="utf-8")
        own = ["-c", f"merge.lesson.driver={driver}", "-c", f"core.attributesFile={attributes}"]
        git(*NAME, *own, "merge", "--quiet", "-X", "ours", "--message", "Update", "@{upstream}", check=False)
    if git("rev-parse", "-q", "--verify", "MERGE_HEAD", check=False):
        settle()
    lessons = [name for name in changed if name.endswith(".ipynb")]
    print(
        f"The course is up to date. Files that were new or changed: {len(changed)}, lessons among them: {len(lessons)}."
    )
    print(f"Your answers are where they were. What is new is told in CHANGELOG.md. {OPEN}")


if __name__ == "__main__":
    os.chdir(ROOT)
    merge_files(*sys.argv[2:]) if sys.argv[1:2] == ["--merge"] else update()
