"""Lesson 18: several models that interact."""

import math

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._hints import after
from kflearn.exercises._slips_fifth_late import WRONG as FIFTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_fourth_words import PUSH
from kflearn.exercises._slips_models import MORE
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_data import WRONG as THIRD
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
    wrong={
        "spread forgotten": (
            30.0,
            "30 m is the σ of each Gaussian. The means are apart as well: add the squared distance of each mean from the middle, then take the root.",
        ),
        "spread alone": (
            40.0,
            "40 m is the distance of each mean from the middle. Each Gaussian has a width of its own as well: add its variance, then take the root.",
        ),
        "fused": (
            30 / math.sqrt(2),
            "21.2 m is what fusing them gives, as if both were right. Only one of them is, and nobody knows which: a blend is wider.",
        ),
        "variance": (2500.0, "That is the variance, in m²; σ is its root."),
        "distance between the two": (
            math.hypot(30, 80),
            "That is √(30² + 80²), with the distance between the two means, 80 m. It is the distance to the blend's mean that counts, 40 m.",
        ),
        "distance, not squared": (
            80.0,
            "80 m is the distance between the two means. Add the variance of a Gaussian and the squared distance of its mean from the middle.",
        ),
        "σ and distance added": (
            70.0,
            "70 m is 30 m + 40 m, σ and the distance from the middle. Add their squares, and take the root.",
        ),
    }
    | MORE["blended_sigma"]
    | FOURTH["blended_sigma"],
    otherwise=facts.spread_of,
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


def leaving(stays, T):
    """A transition matrix whose rows leave with T / stays."""
    M = len(stays)
    leave = (T / stays)[:, None]
    return np.where(np.eye(M, dtype=bool), 1 - leave, leave / (M - 1))


@exercise(
    hints=[
        "A mode that is left with chance p at each step lasts 1/p steps on average. How many steps are `stays[i]` seconds?",
        "p = T / stays, one for each row. On the diagonal stands 1 − p; the rest of the row shares p equally.",
        "`p = (T / stays)[:, None]; M = len(stays); return np.where(np.eye(M, dtype=bool), 1 - p, p / (M - 1))`",
    ],
    inputs=stays_and_clock,
    wrong={
        "columns sum to one": (
            lambda stays, T: leaving(stays, T).T,
            "Your columns sum to one. Row i is “from mode i”: each way out of it leads somewhere, so the rows must.",
        ),
        "clock forgotten": (
            lambda stays, T: leaving(stays, 1.0),
            "That is right for steps of one second. In `stays[i]` seconds there are `stays[i] / T` steps.",
        ),
        "clock upside down": (
            lambda stays, T: leaving(stays, 1 / T),
            "T stands in the denominator: the longer a step, the more likely a change within it.",
        ),
        "shared among all": (
            lambda stays, T: np.where(
                np.eye(len(stays), dtype=bool), 1 - (T / stays)[:, None], (T / stays)[:, None] / len(stays)
            ),
            "Each entry off the diagonal is T/(stays·M), and the rows fall short of 1. Who leaves passes to one of the other M − 1.",
        ),
        "not shared": (
            lambda stays, T: np.where(np.eye(len(stays), dtype=bool), 1 - (T / stays)[:, None], (T / stays)[:, None]),
            "Each off-diagonal entry has the whole chance to leave; the others must share it, or the rows exceed 1.",
        ),
        "stay and leave swapped": (
            lambda stays, T: np.where(
                np.eye(len(stays), dtype=bool), (T / stays)[:, None], (1 - T / stays)[:, None] / (len(stays) - 1)
            ),
            "The diagonal is the chance to stay, 1 − T / stays; you put the chance to leave there.",
        ),
        "one for all": (
            lambda stays, T: leaving(np.full(len(stays), stays.mean()), T),
            "Each mode has its own length: row i belongs to `stays[i]`.",
        ),
        "exponential": (
            lambda stays, T: np.where(
                np.eye(len(stays), dtype=bool),
                np.exp(-T / stays)[:, None],
                (1 - np.exp(-T / stays))[:, None] / (len(stays) - 1),
            ),
            "exp(−T / stays) is right for changes at any moment; here a change can come only with a step, and a mean of "
            "`stays / T` steps asks for 1 − T / stays.",
        ),
        "shared by two": (
            lambda stays, T: np.where(
                np.eye(len(stays), dtype=bool), 1 - (T / stays)[:, None], (T / stays)[:, None] / 2
            ),
            "Each entry off the diagonal is T/(2·stays), which is right for three modes. There may be more: share by len(stays) − 1.",
        ),
        "diagonal only": (
            lambda stays, T: np.diag(1 - T / stays),
            "The diagonal is right. Who leaves a mode passes to another one: the rest of each row shares T / stays.",
        ),
        "ratio upside down": (
            lambda stays, T: leaving(T / stays, 1.0),
            "You divided stays by T. The chance to leave in one step is T / stays: the longer the stay, the "
            "smaller it is.",
        ),
        "all alike": (
            lambda stays, T: np.full((len(stays), len(stays)), 1 / len(stays)),
            "That says that every step begins anew, with all modes equally likely. A mode lasts: most of each row"
            " stands on the diagonal.",
        ),
    }
    | MORE["transition"]
    | FIFTH["transition"],
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


def assembled(first, place, speed):
    """What a start returns: the first positions, and the states [x, vx, y, vy] at the second sample."""
    return first, np.stack([place[:, 0], speed[:, 0], place[:, 1], speed[:, 1]], axis=-1)


def for_all(speed, z):
    """The speed of run 1 for all runs."""
    return np.tile(speed[0], (len(z), 1))


def swapped(z):
    """The first position with the index of the sample where the index of the component should be."""
    return np.stack([z[:, 0, 0], z[:, 1, 0]], axis=-1)


@exercise(
    hints=[
        "Read the three indices aloud: run, sample, component. `z[:, 1, 0]` is the second sample's east. Is that a north?",
        "In the line with `speed` the first index is a 0: whose readings are these? Put a colon there.",
        "`first = z[:, 0]`; `speed = (z[:, 1] - z[:, 0]) / T`; the last line stays.",
    ],
    inputs=readings,
    wrong={
        "as published": (
            lambda z, T: assembled(swapped(z), z[:, 1], for_all((z[:, 1] - z[:, 0]) / T, z)),
            "That is still the published start: an east in place of a north, and run 1's speed for all.",
        ),
        "only the position mended": (
            lambda z, T: assembled(z[:, 0], z[:, 1], for_all((z[:, 1] - z[:, 0]) / T, z)),
            "The first position is mended. All runs still start with the speed of run 1.",
        ),
        "only the speed mended": (
            lambda z, T: assembled(swapped(z), z[:, 1], (z[:, 1] - z[:, 0]) / T),
            "Each run has its own speed now. The first position still has the second sample's east in place of a north.",
        ),
        "wrong sample": (
            lambda z, T: assembled(np.stack([z[:, 0, 0], z[:, 1, 1]], axis=-1), z[:, 1], (z[:, 1] - z[:, 0]) / T),
            "It is a north now, but that of the second sample: both parts of the first position come from sample 0.",
        ),
        "speed backwards": (
            lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 0] - z[:, 1]) / T),
            "Your ships sail backwards: later minus earlier.",
        ),
        "T forgotten": (
            lambda z, T: assembled(z[:, 0], z[:, 1], z[:, 1] - z[:, 0]),
            "Both faults are mended, but a difference of positions is no speed until it is divided by T.",
        ),
        "mean speed of all runs": (
            lambda z, T: assembled(z[:, 0], z[:, 1], np.tile(((z[:, 1] - z[:, 0]) / T).mean(axis=0), (len(z), 1))),
            "Each run is a ship of its own that knows nothing of the others: do not average over the runs.",
        ),
        "state at the first sample": (
            lambda z, T: assembled(z[:, 0], z[:, 0], (z[:, 1] - z[:, 0]) / T),
            "Both faults are mended, but the state belongs to the second sample: its position is z[:, 1].",
        ),
        "order of the states": (
            lambda z, T: (z[:, 0], np.concatenate([z[:, 1], (z[:, 1] - z[:, 0]) / T], axis=-1)),
            "The numbers are right, the order is not: the state is [east, its speed, north, its speed].",
        ),
        "first is the second": (
            lambda z, T: assembled(z[:, 1], z[:, 1], (z[:, 1] - z[:, 0]) / T),
            "The state is right. The first positions are those of the first sample, z[:, 0], both components.",
        ),
        "two steps": (
            lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 2] - z[:, 0]) / (2 * T)),
            "Your speed is that from the first to the third sample. The start uses the first two.",
        ),
        "later speed": (
            lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 2] - z[:, 1]) / T),
            "That is the speed between the second and the third sample. The start uses the first two.",
        ),
        "state at the third": (
            lambda z, T: assembled(z[:, 0], z[:, 2], (z[:, 1] - z[:, 0]) / T),
            "The state belongs to the second sample: its position is z[:, 1].",
        ),
        "velocity of the last pair": (
            lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, -1] - z[:, -2]) / T),
            "The last two readings are not there yet at the start. The speed comes from the first two.",
        ),
        "times T": (
            lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 1] - z[:, 0]) * T),
            "You multiplied by T. A speed is a difference of positions divided by the time between them.",
        ),
        "the first positions alone": (
            lambda z, T: z[:, 0],
            "The first positions are right. Return two things: the first positions, and then the states.",
        ),
        "the state alone": (
            lambda z, T: assembled(z[:, 0], z[:, 1], (z[:, 1] - z[:, 0]) / T)[1],
            "The states are right. Return two things: the first positions, and then the states.",
        ),
    }
    | MORE["mended_start"]
    | THIRD["mended_start"]
    | FIFTH["mended_start"]
    | SEVENTH["mended_start"]
    | TENTH["mended_start"],
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
    wrong={
        "smaller": (
            "smaller",
            "One might expect that. But G enters only by Q = G q Gᵀ, and for this model q = 0: Q is zero with any G.",
        ),
        "larger": (
            "larger",
            "Mending does no harm here either: G enters only by Q = G q Gᵀ, and for this model q = 0.",
        ),
    },
    otherwise=PUSH,
    then=(
        "The straight model has q = 0, so Q = G · 0 · Gᵀ is zero with either G. The fault shows as soon as "
        "somebody gives this model a q."
    ),
)
def wrong_push():
    """What does mending G = [T/2, 1] to [T²/2, T] do to the error, where Q = G q Gᵀ with q = 0?"""
    return "nothing"
