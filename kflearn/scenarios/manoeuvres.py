"""A target that changes its mind: several models for one series."""

from dataclasses import dataclass

import numpy as np

from ..gaussian import Gaussian
from ..models import LinearModel
from .base import Scenario


@dataclass(frozen=True, eq=False)
class ManyModels(Scenario):
    """A Scenario for imm_filter: its `models`, which components of the whole state each has (`states`), and the Markov
    chain between them: transition (M, M) and mode_probabilities (M,) at the start. `model` is the best single one.
    """

    models: tuple = ()
    states: tuple = ()
    transition: np.ndarray = None
    mode_probabilities: np.ndarray = None


def manoeuvring():
    """[KM] A ship on the radar: position in the plane every 2 s with 100 m of noise, 450 samples.

    State [x, vx, y, vy, ax, ay] (m, s). It sails straight at −15 m/s in y; turns slowly, 0.075 m/s² in both axes, from
    400 to 600 s; sails on; turns fast, −0.3 m/s², from 610 to 660 s; sails on. Models: constant velocity with Q = 0,
    constant acceleration with white noise of variance 0.001 or 0.0114 m²/s⁴ a step. The start is vague: 100 m, 10 m/s.
    """
    T, plane = 2.0, np.eye(2)
    drift, order = [[1, T], [0, 1]], [0, 1, 3, 4, 2, 5]
    steady = LinearModel(np.kron(plane, drift), np.kron(plane, [[1, 0]]), np.zeros((4, 4)), 1e4 * plane)
    F = np.kron(plane, [[1, T, T**2 / 2], [0, 1, T], [0, 0, 1]])[np.ix_(order, order)]
    H = np.kron(plane, [[1, 0, 0]])[:, order]
    push = np.kron(plane, [[T**2 / 4], [T / 2], [1]])[order]
    turning = [LinearModel(F, H, q * push @ push.T, 1e4 * plane) for q in (0.001, 0.0114)]
    # The truth: the acceleration is what is set, nothing else acts.
    set_by = np.kron(plane, [[T**2 / 2], [T], [1]])[order]
    truth = LinearModel(F * (np.arange(6) < 4), H, np.zeros((6, 6)), 1e4 * plane, set_by)
    t = T * np.arange(1, 451)
    acceleration = np.select([(t > 400) & (t <= 600), (t > 610) & (t <= 660)], [0.075, -0.3], 0.0)
    start = np.array([2000.0, 0, 10_000, -15, 0, 0])
    return ManyModels(
        "A ship sails straight, turns, and is watched by radar.",
        turning[0],
        Gaussian(start, np.diag([100.0, 10, 100, 10, 0, 0]) ** 2),
        truth,
        start,
        450,
        truth_u=np.column_stack([acceleration] * 2),
        models=(steady, *turning),
        states=([0, 1, 2, 3], list(range(6)), list(range(6))),
        transition=np.full((3, 3), 0.025) + 0.925 * np.eye(3),
        mode_probabilities=np.array([0.8, 0.1, 0.1]),
    )
