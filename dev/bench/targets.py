"""One boat among false readings, beside Stone Soup: the same scans, gate, models and weights, in one run.

    python -m dev.bench.targets          makes build/bench-targets when it is first asked for: some 400 MB

Stone Soup is installed, as pinned in targets.txt, in an environment of its own, and `stone_soup.py` runs there, with
one thread. Agreement is checked before a time is told: which readings are inside the gate, the weights, means and
covariances. Where it cannot be installed the table says so.
"""

import json
import os
import subprocess
import sys
import tempfile
import venv
from pathlib import Path
from typing import NamedTuple

import numpy as np

from dev.bench.filters import best
from dev.bench.goals import judged
from dev.bench.rival_races import LIMIT, last_line
from kflearn import Gaussian, boats, pda_filter, scan_targets, simulate

HERE, FOLDER = Path(__file__).parent, Path(__file__).parents[2] / "build" / "bench-targets"
PINS, SCRIPT, MADE = HERE / "targets.txt", HERE / "stone_soup.py", FOLDER / "made.json"
TOLERANCE, GOAL = 1e-9, 30  # relative to the largest number; times as quick for a scan
SENSOR = dict(detection=0.9, gate=0.99)
START = Gaussian([0, 7, 0, 3], np.diag([25.0, 1, 25, 1]))
STEPS, RUNS = 40, 200


class Race(NamedTuple):
    """Scans z (runs, T, N, 2) of a boat among false readings, λ of them per m²."""

    name: str
    z: np.ndarray
    clutter: float

    def ours(self, z):
        return pda_filter(boats.plane(), z, START, clutter=self.clutter, **SENSOR)


def races():
    """A calm sea and a rough one."""
    for name, clutter in (("calm sea", 2e-5), ("rough sea", 4e-4)):
        x = simulate(boats.plane(), START, STEPS, runs=RUNS, rng=1).x
        z = scan_targets(boats.plane(), x[:, :, None], SENSOR["detection"], clutter, boats.AREA, rng=1).z
        yield Race(name, z, clutter)


def python():
    return FOLDER / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def environment():
    """Why Stone Soup could not be installed, in words; empty when it was. Made anew when targets.txt is another one."""
    key = f"{sys.version_info[:2]} {PINS.read_text(encoding='utf-8')}"
    if MADE.exists() and json.loads(MADE.read_text(encoding="utf-8")) == key:
        return ""
    venv.create(FOLDER, with_pip=True, clear=True)
    command = [python(), "-m", "pip", "install", "--quiet", "--constraint", PINS, "stonesoup"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=2 * LIMIT)
    except subprocess.TimeoutExpired:
        return f"it took more than {2 * LIMIT} seconds"
    if done.returncode:
        return last_line(done.stderr)
    MADE.write_text(json.dumps(key), encoding="utf-8")
    return ""


def theirs(race):
    """What stone_soup.py finds for the first run, by name; or in words why there is nothing."""
    model = boats.plane()
    with tempfile.TemporaryDirectory() as folder:
        given, found = Path(folder) / "race.npz", Path(folder) / "result.npz"
        matrices = dict(F=model.F, H=model.H, Q=model.Q, R=model.R, mean=START.mean, cov=START.cov)
        np.savez(given, z=race.z[0], clutter=race.clutter, **SENSOR, **matrices)
        try:
            command = [python(), SCRIPT, given, found]
            done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return f"not within {LIMIT} seconds"
        if done.returncode:
            return last_line(done.stderr)
        with np.load(found) as file:
            return {name: file[name] for name in file.files}


def difference(track, found):
    """The largest relative difference of weights, means and covariances; infinite where a gate differs."""
    if ((track.weights[:, 1:] > 0) != found["inside"]).any():
        return np.inf
    pairs = (track.weights, found["weights"]), (track.mean, found["means"]), (track.cov, found["covs"])
    return max(abs(ours - other).max() / abs(other).max() for ours, other in pairs)


def row(race, found, rounds):
    """One line of the table."""
    if isinstance(found, str):
        return f"| {race.name} | | | {found} | | | |"
    off = difference(race.ours(race.z[0]), found)
    if not off < TOLERANCE:
        return f"| {race.name} | | | disagrees by {off:.1e}, so it is not timed | | | |"
    alone = best(lambda: race.ours(race.z[0]), rounds) / STEPS
    scans = np.prod(race.z.shape[:2])
    together = best(lambda: race.ours(race.z), max(2, rounds // 5)) / scans
    readings = (~np.isnan(race.z[..., 0])).sum() / scans
    times = f"{1e3 * alone:.3f} ms | {1e3 * together:.3f} ms | {1e3 * found['seconds']:.2f} ms"
    ratios = f"{judged(found['seconds'] / alone, GOAL)} | {judged(found['seconds'] / together, GOAL)}"
    return f"| {race.name}, {readings:.0f} readings a scan | {times} | {ratios} | {off:.0e} |"


def table(rounds=25):
    """The lines of a table in Markdown."""
    ours = f"kflearn, one run | kflearn, {RUNS} runs"
    yield f"| PDA, a scan | {ours} | Stone Soup | ratio, one run | ratio, {RUNS} runs | difference |"
    yield "|---|---:|---:|---:|---:|---:|---:|"
    why = environment()
    for race in races():
        yield row(race, f"cannot be installed: {why}" if why else theirs(race), rounds)


def versions():
    """The pinned versions of Stone Soup and of what it computes with."""
    lines = PINS.read_text(encoding="utf-8").splitlines()
    pins = dict(line.split("==") for line in lines if "==" in line)
    return ", ".join(f"{name} {pins[name]}" for name in ("stonesoup", "numpy", "scipy"))


if __name__ == "__main__":
    for line in table():
        print(line, flush=True)
