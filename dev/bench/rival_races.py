"""Rivals that need other packages than the course: ssfortran, fast-kalman, kalman-py, dynamax.

    python -m dev.bench.rival_races          makes build/bench-rivals when it is first asked for: some 650 MB

They are installed, as pinned in rivals.txt, in an environment of their own, and `rivals.py` runs there in a process for
each rival and race, with one thread. Agreement is checked before a time is told. A package that cannot be installed, or
has no such filter, gets a row that says so.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import venv
from pathlib import Path
from typing import NamedTuple

import numpy as np

from dev.bench import filters
from dev.bench.filters import best
from dev.bench.goals import judged

HERE, FOLDER = Path(__file__).parent, Path(__file__).parents[2] / "build" / "bench-rivals"
PINS, SCRIPT, MADE = HERE / "rivals.txt", HERE / "rivals.py", FOLDER / "made.json"
PACKAGES = {  # what is installed for each rival
    "ssfortran": "ssfortran",
    "fast-kalman": "fast-kalman",
    "fast-kalman, the end only": "fast-kalman",
    "kalman-py": "kalman-py",
    "dynamax": "dynamax",
}
MORE = {"kalman-py": "kalman-py[jax]"}
TOLERANCE = {"filter": 1e-9, "smoother": 1e-9, "UKF": 1e-6, "EKF": 1e-6}  # relative to the largest number
DYNAMAX = 1e-6  # it adds 1e-9 to the diagonal of S
SAMPLE = 200  # runs on which a rival is timed that takes one at a time
LIMIT = 300  # seconds for one rival in one race


class Answer(NamedTuple):
    """What a rival did in a race, or in words why it did not."""

    words: str = ""
    seconds: float = 0.0  # for all runs
    first: float = 0.0  # of the first call, with compiling
    cpu: float = 0.0  # seconds of all threads for one of the clock
    difference: float = 0.0


# ---- the environment


def python():
    return FOLDER / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def last_line(text):
    """The last words of a program that failed."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1].replace("|", "/")[:160] if lines else "no reason given"


def install(package):
    """Why a package could not be installed, in words; empty when it was."""
    uv = shutil.which("uv") or shutil.which("uv", path=Path(sys.executable).parent)
    way = [uv, "pip", "install", "--python", python()] if uv else [python(), "-m", "pip", "install"]
    command = [*way, "--quiet", "--constraint", PINS, MORE.get(package, package)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=2 * LIMIT)
    except subprocess.TimeoutExpired:
        return f"it took more than {2 * LIMIT} seconds"
    return "" if done.returncode == 0 else last_line(done.stderr)


def environment():
    """{package: why it could not be installed, or empty}. Made anew when rivals.txt or our Python is another one.

    What could not be installed is tried again each time.
    """
    key = f"{sys.version_info[:2]} {PINS.read_text(encoding='utf-8')}"
    made = json.loads(MADE.read_text(encoding="utf-8")) if MADE.exists() else {"key": None}
    if made["key"] != key:
        shutil.rmtree(FOLDER, ignore_errors=True)
        venv.create(FOLDER, with_pip=True)
        made["failed"] = dict.fromkeys(PACKAGES.values(), "not tried yet")
    failed = {package: why and install(package) for package, why in made["failed"].items()}
    MADE.write_text(json.dumps({"key": key, "failed": failed}), encoding="utf-8")
    return failed


def versions():
    """The pinned versions of the rivals and of what they compute with."""
    lines = PINS.read_text(encoding="utf-8").splitlines()
    pins = dict(line.split("==") for line in lines if "==" in line)
    return ", ".join(f"{name} {pins[name]}" for name in dict.fromkeys([*PACKAGES.values(), "jax", "numpy"]))


# ---- the races


def write(race, file, sample=SAMPLE):
    """A race of `filters` as rivals.py reads it; f is linear in all of them."""
    model, initial = race.model, race.initial
    matrices = dict(F=model.move_slope(initial.mean), Q=model.Q, R=model.R)
    if hasattr(model, "H"):
        matrices["H"] = model.H
    F = matrices["F"]
    first = dict(first_mean=F @ initial.mean, first_cov=F @ initial.cov @ F.T + model.Q)
    np.savez(file, kind=race.kind, z=race.z, sample=sample, mean=initial.mean, cov=initial.cov, **matrices, **first)


def ask(rival, race_file):
    """A rival's means and an Answer without the difference, or None and an Answer in words."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "result.npz"
        command = [python(), SCRIPT, rival, race_file, result]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return None, Answer(f"not within {LIMIT} seconds")
        if done.returncode:
            return None, Answer(last_line(done.stderr))
        with np.load(result) as found:
            numbers = {name: float(found[name]) for name in ("seconds", "first", "cpu")}
            return found["means"], Answer(**numbers)


def compare(rival, race, mean, race_file):
    """Answer of a rival whose means agree with ours; in words where they do not."""
    theirs, answer = ask(rival, race_file)
    if theirs is None:
        return answer
    ours = mean[: len(theirs), -theirs.shape[1] :]
    difference = abs(ours - theirs).max() / abs(theirs).max()
    tolerance = DYNAMAX if rival == "dynamax" else TOLERANCE[race.kind]
    if not difference < tolerance:
        return Answer(f"disagrees by {difference:.1e}; at most {tolerance:.0e} is allowed, so it is not timed")
    return answer._replace(difference=difference)


def run(race, rounds=25, rivals=tuple(PACKAGES)):
    """Seconds of ours, and {rival: Answer}; ours is timed before and after the rivals."""
    failed, mean, answers = environment(), race.ours(race.z).mean, {}
    seconds = best(lambda: race.ours(race.z), rounds)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "race.npz"
        write(race, file)
        for rival in rivals:
            why = failed[PACKAGES[rival]]
            answers[rival] = Answer(f"cannot be installed: {why}") if why else compare(rival, race, mean, file)
    return min(seconds, best(lambda: race.ours(race.z), rounds)), answers


def table(races=None, rounds=25):
    """The lines of a table in Markdown."""
    yield "| | kflearn | rival | its time | ratio | its first call | processor | largest difference |"
    yield "|---|---:|---|---:|---:|---:|---:|---:|"
    for race in filters.races() if races is None else races:
        if race.kind:
            ours, answers = run(race, rounds)
            yield from (row(race, ours, rival, answer) for rival, answer in answers.items())


def row(race, ours, rival, answer):
    head = f"| {race.name} | {1e3 * ours:.2f} ms | {rival} |"
    if answer.words:
        return f"{head} {answer.words} | | | | |"
    cells = f"{1e3 * answer.seconds:,.1f} ms | {judged(answer.seconds / ours, None)}"
    return f"{head} {cells} | {answer.first:.2f} s | {answer.cpu:.0%} | {answer.difference:.0e} |"


if __name__ == "__main__":
    for line in table():
        print(line, flush=True)
