"""Libraries that are no Python: their files, and their numbers for a problem, from a script in their own language.

A file in `libraries/` begins with comments: its title, remarks, and where they apply two lines that say what it
`needs:` from npm, and that it takes `one:` number for the `reading` or even for the `state`. The lines under the
comment `plain` hand the belief and NaN over as they are; those under `same` stand on the page.
"""

import os
import re
import shutil
import subprocess
import tempfile
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np

from dev.atlas.languages import LANGUAGES


class Stopped(Exception):
    """The program ended with an error and without numbers."""


class Library(NamedTuple):
    """A library's file: what the page says of it, what it needs, what it takes only one of, and its lines."""

    title: str
    remarks: str
    needs: str
    one: str
    plain: str
    same: str


def read(path):
    """The parts of a library's file."""
    comment = LANGUAGES[path.suffix].comment
    text = path.read_text(encoding="utf-8")
    head, plain, same = re.split(rf"^{comment} (?:plain|same)\n", text, flags=re.M)
    said = [line.removeprefix(comment).strip() for line in head.splitlines()]
    keys = dict(line.split(": ") for line in said if line.startswith(("needs: ", "one: ")))
    remarks = " ".join(line for line in said[1:] if line and line.split(": ")[0] not in keys)
    return Library(said[0], remarks, keys.get("needs", ""), keys.get("one", ""), plain.strip(), same.strip())


def version(path):
    """The library's version, None where its program is not installed."""
    command = LANGUAGES[path.suffix].version
    program = shutil.which(command[0])
    if program is None or shutil.which(LANGUAGES[path.suffix].start[0]) is None:
        return None
    done = subprocess.run([program, *command[1:]], capture_output=True, text=True, check=False)
    found = re.search(r"\d[\w.]+", done.stdout)
    if done.returncode or found is None:
        return None
    return read(path).needs.partition("@")[2] or found[0]


@contextmanager
def functions(path):
    """`plain` and `same` of a library as functions of a problem."""
    library = read(path)
    with tempfile.TemporaryDirectory() as folder:
        if library.needs:
            npm = [shutil.which("npm"), "install", "--silent", "--no-save", "--prefix", folder, library.needs]
            subprocess.run(npm, check=True, stdout=subprocess.DEVNULL)
        yield tuple(partial(answer, Path(folder), path.suffix, code) for code in (library.plain, library.same))


def answer(folder, suffix, code, **problem):
    """(means, covs) or (means, covs, log-likelihood) of a problem, as flat arrays that the script has printed."""
    language = LANGUAGES[suffix]
    script = folder / f"script{suffix}"
    given = [written(language, name, value) for name, value in problem.items()]
    script.write_text("\n".join([*given, code, language.tail]), encoding="utf-8")
    command = [shutil.which(language.start[0]), *language.start[1:], script.name]
    home = os.environ | {"HOME": str(folder)}  # some of them write settings there
    done = subprocess.run(
        command, cwd=folder, env=home, capture_output=True, encoding="utf-8", errors="replace", check=False
    )
    said = dict(re.findall(r"^(means|covs|log_likelihood) (.*)$", done.stdout, re.M))
    if done.returncode or not {"means", "covs"} <= set(said):
        raise Stopped(done.stdout + done.stderr)
    return [np.array([number(word) for word in said[name].split()]) for name in said]


def written(language, name, value):
    """A quantity of the problem as a line of the language; a vector is a column."""
    value = np.reshape(value, (len(value), -1))
    rows = [", ".join(language.missing if np.isnan(part) else repr(float(part)) for part in row) for row in value]
    return language.matrix.format(name=name, rows=language.between.join(rows), count=len(rows))


def number(word):
    return float("nan" if word == "NA" else word.replace("Infinity", "inf"))
