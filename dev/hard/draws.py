"""Random settings of every scenario, over the whole range of its lesson's sliders, and every filter that fits them."""

import json
import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from kflearn import (
    FILTERS,
    Gaussian,
    LinearModel,
    adaptive_kalman_filter,
    imm_filter,
    mmae_filter,
    rts_smoother,
    scenarios,
    schmidt_kalman_filter,
    simulate,
    two_filter_smoother,
    unscented_kalman_filter,
)

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
STEPS = 30
NAMES = [name for name in scenarios.__all__ if name.islower()]
# Which slider sets a matrix (P is the start's): its lesson, its name, its value for the scenario's own matrix, and the
# power in which the matrix follows it. What has no slider is drawn over six decades around the scenario's own.
SLIDERS = {
    "cart": {"Q": ("03", "Q11", 4, 1), "R": ("03", "R", 1, 1)},
    "voltmeter": {"Q": ("05", "Q", 4, 1), "R": ("05", "R", 4, 1)},
    "bearing": {"Q": ("08", "Q", 200, 1), "R": ("08", "R", 500, 1)},
    "free_fall": {"Q": ("10", "sigma", 1, 2)},
    "ship": {"Q": ("11", "q", 1, 1), "R": ("11", "R", 100, 1)},
    "bearings_only": {"R": ("15", "noise", 2.394, 2)},
    "homing_missile": {"P": ("16", "sigma", 100, 2)},
    "manoeuvring": {"R": ("18", "noise", 100, 2)},
    "ball": {"Q": ("19", "q", 0.01, 1)},
    "unknown_noise": {"Q": ("23", "sigma", 0.5, 2), "R": ("22", "R", 1, 1)},
}


@cache
def sliders(lesson):
    """{name: (low, high)} of the sliders of a lesson's playgrounds, as its saved outputs tell them."""
    path = next(NOTEBOOKS.glob(f"{lesson}-*.ipynb"))
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    texts = ["".join(out.get("data", {}).get("text/plain", "")) for cell in cells for out in cell.get("outputs", [])]
    found = re.findall(r"(\w+) from (\S+) to ([\d.e+-]+)", " ".join(t for t in texts if t.startswith("Playground:")))
    return {name: (float(low), float(high)) for name, low, high in found}


def between(rng, low, high):
    """A number from the range of a slider; one over decades where there are some."""
    return np.exp(rng.uniform(*np.log([low, high]))) if 0 < low < high / 10 else rng.uniform(low, high)


def slid(rng, lesson, name):
    """What a slider is drawn to."""
    return between(rng, *sliders(lesson)[name])


def factor(rng, name, matrix):
    """How many times the scenario's own Q, R or P (the start's) is taken."""
    if matrix not in SLIDERS.get(name, {}):
        return between(rng, 1e-3, 1e3)
    lesson, slider, own, power = SLIDERS[name][matrix]
    return (slid(rng, lesson, slider) / own) ** power


@cache
def own(name):
    """The scenario's own model, start and control inputs."""
    scene = scenarios.free_fall("physical") if name == "free_fall" else getattr(scenarios, name)()
    model = changed(scene.model, lambda M: M[:STEPS] if M.ndim > 2 else M)
    if name == "free_fall":
        model = model.replace(Q=model.B @ model.B.T)  # an unknown acceleration of 1 m/s²
    u = scene.simulate(rng=0).u if name == "inertial_navigation" else scene.u
    return model, scene.initial, None if u is None else u[:STEPS]


def one(name, rng):
    """One setting of a scenario: model and start."""
    model, start, _ = own(name)
    Q, R, P = (factor(rng, name, matrix) for matrix in "QRP")
    model, start = model.replace(Q=Q * model.Q, R=R * model.R), Gaussian(start.mean, P * start.cov)
    return faulty_sensor(model, start, rng) if name == "biased_sensor" else (model, start)


def faulty_sensor(model, start, rng):
    """The bias of lesson 21, of another size and another duration."""
    sd, keep = slid(rng, "21", "sd"), np.exp(-0.1 / slid(rng, "21", "tau"))
    F, Q, P = model.F.copy(), model.Q.copy(), start.cov.copy()
    F[2, 2], Q[2, 2], P[2, 2] = keep, sd**2 * (1 - keep**2), sd**2
    return model.replace(F=F, Q=Q), Gaussian(start.mean, P)


def matrices(model):
    """{name: matrix} of a model."""
    found = {name: getattr(model, name, None) for name in "FHQRB"}
    return {name: M for name, M in found.items() if isinstance(M, np.ndarray)}


def changed(model, change):
    """The model with all its matrices changed."""
    return model.replace(**{name: change(M) for name, M in matrices(model).items()})


def gathered(models):
    """Models of one scenario as one, whose matrices are (settings, T or 1, rows, columns)."""
    along_time = [{name: M if M.ndim > 2 else M[None] for name, M in matrices(model).items()} for model in models]
    return models[0].replace(**{name: np.stack([Ms[name] for Ms in along_time]) for name in along_time[0]})


class Case(NamedTuple):
    """Some settings of a scenario, each run some times: arrays (settings, runs, ...), with 1 for what all runs share.

    x, z: truth and measurements that the models themselves made. knobs: the settings of the filters, the same for all.
    """

    name: str
    model: object
    initial: Gaussian
    x: np.ndarray
    z: np.ndarray
    u: np.ndarray | None
    knobs: dict

    def alone(self, i):
        """One of the settings."""
        model = changed(self.model, lambda M: M[i : i + 1])
        initial = Gaussian(self.initial.mean, self.initial.cov[i : i + 1])
        return self._replace(model=model, initial=initial, x=self.x[i : i + 1], z=self.z[i : i + 1])


def case(name, settings, runs, rng):
    """Random settings of a scenario, and runs of each. In every second case some measurements are missing."""
    models, starts = zip(*(one(name, rng) for _ in range(settings)), strict=True)
    model, mean, P, u = gathered(models), starts[0].mean, np.stack([start.cov for start in starts]), own(name)[2]
    each = changed(model, lambda M: np.repeat(M, runs, axis=0))
    x, z, _ = simulate(each, Gaussian(mean, np.repeat(P, runs, axis=0)), STEPS, u, settings * runs, rng)
    x, z = (array.reshape(settings, runs, STEPS, -1) for array in (x, z))
    if rng.random() < 0.5:
        z[..., 10:14, :] = z[..., 20, 0] = np.nan
    return Case(name, changed(model, lambda M: M[:, None]), Gaussian(mean, P[:, None]), x, z, u, knobs(name, rng))


def knobs(name, rng):
    """The settings of the filters that have some: lessons 17, 18 and 22."""
    drawn = dict(alpha=slid(rng, "17", "alpha"), kappa=slid(rng, "17", "kappa"), leave=slid(rng, "18", "leave"))
    return drawn | dict(window=int(slid(rng, "22", "window")), floor=slid(rng, "22", "floor"))


def unscented(case):
    k = case.knobs
    return unscented_kalman_filter(case.model, case.z, case.initial, case.u, alpha=k["alpha"], kappa=k["kappa"])


def consider(case):
    """Without estimating the last state, where there is another."""
    last = [case.model.n - 1] if case.model.n > 1 else []
    return schmidt_kalman_filter(case.model, case.z, case.initial, case.u, considered=last)


def adaptive(adapt):
    def run(case):
        k = {name: case.knobs[name] for name in ("window", "floor")}
        return adaptive_kalman_filter(case.model, case.z, case.initial, case.u, adapt=adapt, **k)

    return run


def bank(case):
    """Models for the filters that have several: the scenario's own, or the model and one with nine times its R."""
    if case.name == "manoeuvring":
        scene = scenarios.manoeuvring()
        return [model.replace(R=case.model.R) for model in scene.models], dict(states=list(scene.states))
    return [case.model, case.model.replace(R=9 * case.model.R)], {}


def imm(case):
    models, states = bank(case)
    M, leave = len(models), case.knobs["leave"]
    chain = np.full((M, M), leave / (M - 1)) + (1 - leave - leave / (M - 1)) * np.eye(M)
    weights = np.full(M, 1 / M)
    return imm_filter(models, case.z, case.initial, case.u, transition=chain, mode_probabilities=weights, **states)


def mmae(case):
    models, states = bank(case)
    return mmae_filter(models, case.z, case.initial, case.u, **states)


def smoothed(run):
    """The smoother after a filter."""
    return lambda case: rts_smoother(case.model, run(case))


# What is not called with the case alone: {name: {title: function of a case}}.
DRAWN = {
    "unscented_kalman_filter": {"unscented Kalman": unscented},
    "schmidt_kalman_filter": {"schmidt Kalman": consider},
    "adaptive_kalman_filter": {"adaptive R": adaptive("R"), "adaptive Q": adaptive("Q")},
    "imm_filter": {"IMM": imm},
    "mmae_filter": {"MMAE": mmae},
}


def plain(row):
    """{title: function of a case} of a filter that is called with nothing but what it needs."""
    title = row.name.removesuffix("_filter").replace("_", " ").replace("kalman", "Kalman")
    return {title: lambda case: row.run(case.model, case.z, case.initial, case.u)}


def tried(rows):
    """{title: function of a case} of some rows of FILTERS, with their smoothers."""
    found = {}
    for row in rows:
        runs = DRAWN.get(row.name) or plain(row)
        found |= runs
        if row.smoothed:
            found |= {f"smoothed {title}": smoothed(run) for title, run in runs.items()}
    return found


def claims(row):
    """Does a filter promise 2σ where the model is right? Not one that adapts, or mixes several models."""
    return row.exact and not row.several


LINEAR = tried(row for row in FILTERS if claims(row) and row.models == "linear")
LINEAR["two-filter smoother"] = lambda case: two_filter_smoother(case.model, case.z, case.initial, case.u)
BOTH = tried(row for row in FILTERS if claims(row) and row.models == "both")
MORE = tried(row for row in FILTERS if not claims(row))


def filters(model):
    """{title: function of a case} of all filters for a model."""
    return (LINEAR if isinstance(model, LinearModel) else {}) | BOTH | MORE
