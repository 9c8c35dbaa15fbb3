"""The command `kflearn`: the lessons in a folder of the learner's own, without a clone of the course.

    kflearn open [FOLDER]       copies the lessons into the folder (kalman-course) and opens them in JupyterLab
    kflearn reset 05 [FOLDER]   a lesson as it came; what you made of it is kept beside it
    kflearn update [FOLDER]     what is new in the installed version; your answers stay

In a clone, `make course`, `make reset` and `make update` do the same.
"""

import argparse
import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from . import shipped
from .copies import OPEN, aside, merge, own_work, put_back

FOLDER = "kalman-course"
CAME = ".kflearn"  # in the learner's folder: each lesson as it was when it was copied, for the next update
NO_LAB = 'JupyterLab is not installed here. Say: pip install "kflearn[lessons,lab]". The lessons are in {}.'
NO_COPY = "There are no lessons in {}: `kflearn open` puts them there."


def copied(path, folder):
    """Copy one shipped lesson into the learner's folder, and remember how it was."""
    shutil.copyfile(path, folder / path.name)
    remember(path, folder)


def remember(path, folder):
    (folder / CAME).mkdir(exist_ok=True)
    shutil.copyfile(path, folder / CAME / path.name)


def copy_others(folder):
    """Appendices and pictures: nobody writes in them, so they are always those of this version."""
    for name in shipped.others():
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copyfile(shipped.notebooks() / name, folder / name)


def place(folder) -> str:
    """Put into the folder what is not there yet; returns a sentence about it."""
    folder.mkdir(parents=True, exist_ok=True)
    missing = [path for path in shipped.lessons() if not (folder / path.name).exists()]
    for path in missing:
        copied(path, folder)
    copy_others(folder)
    return f"{len(missing)} lessons are new in {folder}." if missing else f"The lessons are in {folder}."


def open_lessons(folder):
    """Copy what is missing, and open JupyterLab, until it is stopped."""
    print(place(folder))
    if find_spec("jupyterlab") is None:
        sys.exit(NO_LAB.format(folder))
    paths = [str(shipped.settings()), os.environ.get("JUPYTER_CONFIG_PATH", "")]
    env = os.environ | {"JUPYTER_CONFIG_PATH": os.pathsep.join(filter(None, paths))}
    root = ["--allow-root"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    first = f"--LabApp.default_url=/lab/tree/{shipped.FIRST}"
    sys.exit(subprocess.call([sys.executable, "-m", "jupyterlab", *root, first, str(folder)], env=env))


def reset(number, folder):
    """Put one lesson back."""
    path = next((path for path in shipped.lessons() if path.name.startswith(f"{number:0>2}-")), None)
    if path is None:
        sys.exit(f"There is no lesson {number}.")
    if not folder.exists():
        sys.exit(NO_COPY.format(folder))
    print(put_back(folder / path.name, path.read_bytes()))
    remember(path, folder)


def bring(path, folder) -> bool:
    """Bring one lesson in the folder up to date; was anything to be done?"""
    import nbformat  # it comes with Jupyter

    mine, came = folder / path.name, folder / CAME / path.name
    if not mine.exists():
        copied(path, folder)
        return True
    if came.exists() and came.read_bytes() == path.read_bytes():
        return False
    base = nbformat.read(came if came.exists() else path, as_version=4)
    try:
        own = nbformat.read(mine, as_version=4)
    except Exception:  # whatever is wrong with a damaged file
        kept = aside(mine)
        mine.rename(kept)
        print(f"{mine.name} could not be read: it is kept as {kept.name}, and the new lesson is in its place.")
        own = base
    if own_work(base, own):
        nbformat.write(merge(base, own, nbformat.read(path, as_version=4)), mine)
        remember(path, folder)
    else:
        copied(path, folder)
    return True


def update(folder):
    """Bring all lessons up to date."""
    if not folder.exists():
        sys.exit(NO_COPY.format(folder))
    if find_spec("nbformat") is None:
        sys.exit(NO_LAB.format(folder))
    changed = sum([bring(path, folder) for path in shipped.lessons()])
    copy_others(folder)
    if not changed:
        print("Nothing is new in this version. A newer one comes with: pip install --upgrade kflearn")
        return
    print(f"Lessons that were new or changed: {changed}. Your answers are where they were. {OPEN}")


def main(arguments=None):
    """Read the command line and do what it says."""
    parser = argparse.ArgumentParser("kflearn", description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("what", choices=["open", "reset", "update"])
    parser.add_argument("rest", nargs="*", metavar="LESSON, FOLDER")
    told = parser.parse_args(arguments)
    if told.what == "reset" and not told.rest:
        sys.exit("Which lesson? For instance: kflearn reset 05")
    number = told.rest.pop(0) if told.what == "reset" else None
    if len(told.rest) > 1:
        sys.exit(f"One folder, please, found {len(told.rest)}.")
    folder = Path(*told.rest) if told.rest else Path(FOLDER)
    if told.what == "reset":
        reset(number, folder)
    else:
        {"open": open_lessons, "update": update}[told.what](folder)
