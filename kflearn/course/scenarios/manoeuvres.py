"""A target that manoeuvres: several models for one series."""

from dataclasses import dataclass

import numpy as np

from ...models.gaussian import Gaussian
from ...models.state_space import LinearModel
from .base import Scenario

T = 2.0  # seconds from one sample to the next
PLANE = np.eye(2)


@dataclass(frozen=True, eq=False)
class ManyModels(Scenario):
    """A Scenario for imm_filter; `model` is the best single model.

    Attributes
    ----------
    models : tuple of LinearModel
        M models.
    states : tuple of list of int
        Which components of the whole state each of them has.
    transition : ndarray (M, M)
        How probable each model is after each other one.
    mode_probabilities : ndarray (M,)
        Of the models at the start.
    """

    models: tuple = ()
    states: tuple = ()
    transition: np.ndarray = None  # type: ignore[assignment]  # always given, as the next
    mode_probabilities: np.ndarray = None  # type: ignore[assignment]


def manoeuvring() -> ManyModels:
    """[KM] A ship on the radar: position in the plane every 2 s with 100 m of noise, 450 samples.

    State [x, vx, y, vy, ax, ay] (m, s). It sails straight at −15 m/s in y; turns slowly, 0.075 m/s² in both axes, from
    400 to 600 s; sails on; turns fast, −0.3 m/s², from 610 to 660 s; sails on. Models: constant velocity with Q = 0,
    constant acceleration with white noise of variance 0.001 or 0.0114 m²/s⁴ a step. The start is vague: 100 m, 10 m/s.
    """
    steady, *turning, truth = _models()
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


def _models():
    """Constant velocity, constant acceleration with little and with much noise, and the truth."""
    drift, order = [[1, T], [0, 1]], [0, 1, 3, 4, 2, 5]
    steady = LinearModel(np.kron(PLANE, drift), np.kron(PLANE, [[1, 0]]), np.zeros((4, 4)), 1e4 * PLANE)
    F = np.kron(PLANE, [[1, T, T**2 / 2], [0, 1, T], [0, 0, 1]])[np.ix_(order, order)]
    H = np.kron(PLANE, [[1, 0, 0]])[:, order]
    push = np.kron(PLANE, [[T**2 / 4], [T / 2], [1]])[order]
    turning = [LinearModel(F, H, q * push @ push.T, 1e4 * PLANE) for q in (0.001, 0.0114)]
    # The truth: the acceleration is what is set, nothing else acts.
    set_by = np.kron(PLANE, [[T**2 / 2], [T], [1]])[order]
    truth = LinearModel(F * (np.arange(6) < 4), H, np.zeros((6, 6)), 1e4 * PLANE, set_by)
    return steady, *turning, truth
