"""Random settings of every scenario, over the whole range of its lesson's sliders, and every filter that fits them."""

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

import nbformat
import numpy as np

from kflearn import (
    Gaussian,
    LinearModel,
    adaptive_kalman_filter,
    cubature_kalman_filter,
    extended_kalman_filter,
    imm_filter,
    kalman_filter,
    linearized_kalman_filter,
    mmae_filter,
    rts_smoother,
    scenarios,
    schmidt_kalman_filter,
    simulate,
    square_root_kalman_filter,
    two_filter_smoother,
    unscented_kalman_filter,
)

NOTEBOOKS = Path(__file__).parent.parent / "notebooks"
STEPS = 45
NAMES = [name for name in scenarios.__all__ if name.islower()]
# Which slider sets a matrix: its lesson, its name, its value for the scenario's own matrix, and the matrix's power of it.
# What has no slider is drawn over six decades around the scenario's own.
SLIDERS = {
    "cart": {"Q": ("03", "Q11", 4, 1), "R": ("03", "R", 1, 1)},
    "voltmeter": {"Q": ("05", "Q", 4, 1), "R": ("05", "R", 4, 1)},
    "bearing": {"Q": ("08", "Q", 200, 1), "R": ("08", "R", 500, 1)},
    "free_fall": {"Q": ("09", "sigma", 1, 2)},
    "ship": {"Q": ("10", "q", 1, 1), "R": ("10", "R", 100, 1)},
    "bearings_only": {"R": ("13", "noise", 2.394, 2)},
    "homing_missile": {"P": ("14", "sigma", 100, 2)},
    "manoeuvring": {"R": ("16", "noise", 100, 2)},
    "ball": {"Q": ("17", "q", 0.01, 1)},
    "unknown_noise": {"Q": ("21", "sigma", 0.5, 2), "R": ("20", "R", 1, 1)},
}


@cache
def sliders(lesson):
    """{name: (low, high)} of the sliders of a lesson's playgrounds, as its saved outputs tell them."""
    path = next(NOTEBOOKS.glob(f"{lesson}-*.ipynb"))
    outputs = [output for cell in nbformat.read(path, 4).cells for output in cell.get("outputs", [])]
    texts = [output.get("data", {}).get("text/plain", "") for output in outputs]
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
    """The bias of lesson 19, of another size and another duration."""
    sd, keep = slid(rng, "19", "sd"), np.exp(-0.1 / slid(rng, "19", "tau"))
    F, Q, P = model.F.copy(), model.Q.copy(), start.cov.copy()
    F[2, 2], Q[2, 2], P[2, 2] = keep, sd**2 * (1 - keep**2), sd**2
    return model.replace(F=F, Q=Q), Gaussian(start.mean, P)


def changed(model, change):
    """The model with all its matrices changed."""
    matrices = {name: getattr(model, name, None) for name in "FHQRB"}
    return model.replace(**{name: change(M) for name, M in matrices.items() if isinstance(M, np.ndarray)})


def gathered(models):
    """Models of one scenario as one; its matrices (settings, T, rows, columns)."""
    stacks = [dict() for _ in models]
    for model, stack in zip(models, stacks, strict=True):
        changed(model, lambda M, stack=stack: stack.setdefault(len(stack), M) if M.ndim > 2 else stack.setdefault(len(stack), M[None])[0])
    return stacks
