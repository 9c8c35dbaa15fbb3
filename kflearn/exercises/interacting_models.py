"""Lesson 18: several models that interact."""

import math

import numpy as np

from kflearn.exercises._hints import after
from kflearn.exercises._slips import interacting_models as slips
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        after(
            30,
            "30 m is what each of the two models claims. Where is the blend's mean, and how far is each model from it?",
            "The blend's mean is halfway, at 40 m. How far is each model from it?",
        ),
        "Variance of the blend: the mean of the two variances plus the mean of the two squared distances to the blend's mean.",
        "`np.sqrt(30**2 + 40**2)`, because each of the two means is 40 m from the middle.",
    ],
    wrong=slips.blended_sigma.WRONG,
    otherwise=slips.blended_sigma.spread_of,
    unit="m",
    then="The blend of two that disagree is wider than either of them: 50 m. Fusing them, as two opinions that are both right, would have given 21.2 m.",
)
def blended_sigma():
    """The σ of the blend of two equally probable Gaussians, 0 m and 80 m, each with σ = 30 m."""
    return math.sqrt(30**2 + 40**2)


def stays_and_clock(rng):
    """How long each of three to five modes lasts, and the time between readings, in seconds."""
    modes = int(rng.choice([5, 4, 3]))
    return rng.integers(20, 600, modes).astype(float), float(rng.integers(1, 6))


@exercise(
    hints=[
        "A mode that is left with chance p at each step lasts 1/p steps on average. How many steps are `stays[i]` seconds?",
        "p = T / stays, one for each row. On the diagonal stands 1 − p; the rest of the row shares p equally.",
        "`p = (T / stays)[:, None]; M = len(stays); return np.where(np.eye(M, dtype=bool), 1 - p, p / (M - 1))`",
    ],
    inputs=stays_and_clock,
    wrong=slips.transition.WRONG,
    then=(
        "A ship that stays 100 s, read every 2 s, has 0.98 on the diagonal. Halve the time between readings, and "
        "the diagonal moves closer to 1."
    ),
)
def transition(stays, T):
    """Π for modes that last `stays` seconds on average, with a step every T seconds, a change only with a step and no favourite."""
    M = len(stays)
    leave = (T / stays)[:, None]
    return np.where(np.eye(M, dtype=bool), 1 - leave, leave / (M - 1))


def readings(rng):
    """Positions (runs, T, 2) in round numbers, three or more samples of two or more runs, and the time between them."""
    runs, samples = rng.choice([5, 3, 2]), rng.choice([3, 5])
    return rng.integers(-9, 10, (runs, samples, 2)) * 100.0, float(rng.integers(2, 6))


@exercise(
    hints=[
        "Read the three indices aloud: run, sample, component. `z[:, 1, 0]` is the second sample's east. Is that a north?",
        "In the line with `speed` the first index is a 0: whose readings are these? Put a colon there.",
        "`first = z[:, 0]`; `speed = (z[:, 1] - z[:, 0]) / T`; the last line stays.",
    ],
    inputs=readings,
    wrong=slips.mended_start.WRONG,
    then="Run 1 had the right speed all the time: only a test with several runs can show the second fault.",
)
def mended_start(z, T):
    """First positions (runs, 2) and states [x, vx, y, vy] (runs, 4) at the second of the readings z (runs, T, 2)."""
    first = z[:, 0]
    speed = (z[:, 1] - z[:, 0]) / T
    return first, np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


@exercise(
    hints=[
        "The matrix, call it G, is used in one place only: Q = G q Gᵀ. What is q for the straight model?",
        "The straight model expects no turn, ever: its q is 0. What is G · 0 · Gᵀ?",
        "G · 0 · Gᵀ is zero with the wrong G and with the right one: “nothing”.",
    ],
    wrong=slips.wrong_push.WRONG,
    otherwise=slips.wrong_push.PUSH,
    then=(
        "The straight model has q = 0, so Q = G · 0 · Gᵀ is zero with either G. The fault shows as soon as "
        "somebody gives this model a q."
    ),
)
def wrong_push():
    """What does mending G = [T/2, 1] to [T²/2, T] do to the error, where Q = G q Gᵀ with q = 0?"""
    return "nothing"
