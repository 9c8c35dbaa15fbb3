"""Lesson 12: linearised and extended."""

import numpy as np

from kflearn.exercises._linearised_and_extended import WRONG
from kflearn.exercises.engine import exercise


def radar_states(rng):
    """A state [x, vx, y, vy] away from the axes, seen from a radar at the origin."""
    return (rng.integers(1, 9, 4) * rng.choice([-1.0, 1.0], 4),)


def radar_slope(x, sign=-1, power=3, other=1):
    """The Jacobian of distance and its rate, with the entries of the second row open to mistakes."""
    r = np.hypot(x[0], x[2])
    turn = x[2] * x[1] - x[0] * x[3]
    bent = other * x[2] * turn / r**power, sign * x[0] * turn / r**power
    return np.array([[x[0] / r, 0, x[2] / r, 0], [bent[0], x[0] / r, bent[1], x[2] / r]])


@exercise(
    hints=[
        "Compare `claimed(x)` with `jacobian(radar, x)` at a state without zeros or symmetries, say [300, 20, 400, -7].",
        "Print the difference of the two: seven entries agree. The eighth has the right size and the wrong sign.",
        "The entry in row 1, column 2 is the one: `J = claimed(x)`, then `J[1, 2] = -J[1, 2]`, then `return J`.",
    ],
    inputs=radar_states,
    wrong={
        "as claimed": (
            lambda x: radar_slope(x, sign=1),
            "That is the claimed Jacobian again. Take its difference from `jacobian(radar, x)`: one entry is not near zero.",
        ),
        "the neighbour": (
            lambda x: radar_slope(x, sign=1, other=-1),
            "You turned the sign in column 0, which was right; the wrong entry is the other one that holds `turn`.",
        ),
        "both": (
            lambda x: radar_slope(x, other=-1),
            "You turned both signs: one was wrong and is mended, the other was right and is now wrong.",
        ),
        "power two": (
            lambda x: radar_slope(x, power=2),
            "The sign is right now, but the third power of the distance was right too: leave it.",
        ),
        "transposed": (
            lambda x: radar_slope(x).T,
            "The numbers are right, but turned on their side: one row a measurement, one column a state.",
        ),
        "negative": (
            lambda x: -radar_slope(x),
            "Every sign is turned: that is the slope of −h. Did you take h(x − step) − h(x + step)?",
        ),
        "double": (
            lambda x: 2 * radar_slope(x),
            "Twice too large: the two points are 2·step apart, so divide by 2·step.",
        ),
        "entry zero": (
            lambda x: radar_slope(x, sign=0),
            "That the entry is wrong is no reason to strike it out: the rate does depend on y. Mend it.",
        ),
        "first row only": (
            lambda x: radar_slope(x)[:1],
            "The radar measures two things, so H has two rows: distance, and its rate.",
        ),
    },
)
def mended_slope(x):
    """The Jacobian (2, 4) of distance and rate of distance for the state [x, vx, y, vy] seen from the origin."""
    r = np.hypot(x[0], x[2])
    turn = x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], [x[2] * turn / r**3, x[0] / r, -x[0] * turn / r**3, x[2] / r]])


def growth_beliefs(rng):
    """An estimate, its variance and an input of the growth model."""
    return float(rng.integers(-40, 41) / 4 + 0.1), float(rng.integers(1, 20) / 4), float(rng.integers(-32, 33) / 4)


def grown(x, u):
    """Where the growth model moves x."""
    return x / 2 + 25 * x / (1 + x**2) + u


def growth_slope(x):
    """Its slope."""
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2


@exercise(
    hints=[
        "The belief's width is stretched by the curve. At which place does the curve meet this belief: where it stood, or where it lands?",
        "A belief stands at x before it moves. So the tangent is needed at the old x, but the first line has overwritten it.",
        "Swap two lines: first `F = move_slope(x)`, then `x = move(x, u)`, then P = F * P * F + 10.",
    ],
    inputs=growth_beliefs,
    wrong={
        "as published": (
            lambda x, P, u: (grown(x, u), growth_slope(grown(x, u)) ** 2 * P + 10),
            "That is the published prediction again: its slope is taken where the belief lands, not where it stood.",
        ),
        "halfway": (
            lambda x, P, u: (grown(x, u), growth_slope((x + grown(x, u)) / 2) ** 2 * P + 10),
            "You took the slope halfway. The belief to be pushed through the curve stands at the old x, nowhere else.",
        ),
        "at the input": (
            lambda x, P, u: (grown(x, u), growth_slope(x + u) ** 2 * P + 10),
            "The input is added after the curve: it shifts the mean and changes no slope.",
        ),
        "Q forgotten": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P),
            "The slope is right now. But P also grows by Q = 10, the variance of what disturbs a step.",
        ),
        "Q stretched too": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * (P + 10)),
            "The disturbance comes after the move, so the curve does not stretch it: F·P·F first, then + 10.",
        ),
        "F once": (
            lambda x, P, u: (grown(x, u), growth_slope(x) * P + 10),
            "P is a variance: stretching by F multiplies it by F twice. With F below zero yours may even be negative.",
        ),
        "deviation for variance": (
            lambda x, P, u: (grown(x, u), np.sqrt(growth_slope(x) ** 2 * P + 10)),
            "You took a root: P is a variance and stays one.",
        ),
        "tangent for the mean": (
            lambda x, P, u: (growth_slope(x) * x + u, growth_slope(x) ** 2 * P + 10),
            "P is right. But the mean travels along the curve itself, `move(x, u)`; the slope is for the width only.",
        ),
        "u forgotten": (
            lambda x, P, u: (grown(x, 0), growth_slope(x) ** 2 * P + 10),
            "P is right. The mean lacks the known input u.",
        ),
        "not moved": (
            lambda x, P, u: (x, growth_slope(x) ** 2 * P + 10),
            "P is right, but the mean has stayed where it was: it moves to `move(x, u)`.",
        ),
    },
)
def mended_prediction(x, P, u):
    """The EKF's prediction of the growth model (coefficient 25, Q = 10): the mean and its variance."""
    F = 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2
    x = x / 2 + 25 * x / (1 + x**2) + u
    return x, F * P * F + 10


def believed_starts(rng):
    """A mean, a diagonal P₀ and standard normal numbers for a few runs."""
    mean = rng.integers(-200, 200, 4).astype(float)
    return mean, np.diag(rng.integers(2, 60, 4) / 2 + 0.5), rng.normal(size=(int(rng.integers(2, 4)), 4)).round(2)


@exercise(
    hints=[
        "A filter that starts with N(mean, P0) says that the truth lies about `mean`, with the variances of P0. Let it be so.",
        "Standard normal numbers have variance 1. Stretch column i by the *root* of P0[i, i], then move it to mean[i].",
        "`return mean + normal * np.sqrt(np.diag(P0))` (one row a run; P0 is diagonal).",
    ],
    inputs=believed_starts,
    wrong={
        "as published": (
            lambda mean, P0, normal: mean + 0 * normal,
            "That is the published study again: every truth starts where the filter believes, exactly, while P0 claims otherwise.",
        ),
        "variance for its root": (
            lambda mean, P0, normal: mean + normal @ P0,
            "You stretched by the variances. The starts would scatter with covariance P0², not P0: take the roots.",
        ),
        "not stretched": (
            lambda mean, P0, normal: mean + normal,
            "That scatters with variance 1 in every state: honest for P0 = I, and for nothing else.",
        ),
        "about zero": (
            lambda mean, P0, normal: normal * np.sqrt(np.diag(P0)),
            "The scatter is right, but it lies about zero: add the mean.",
        ),
        "one draw for all states": (
            lambda mean, P0, normal: mean + normal[:, :1] * np.sqrt(np.diag(P0)),
            "One draw serves all four states of a run, so they are always wrong together. P0 is diagonal: each has its own.",
        ),
        "one draw for all runs": (
            lambda mean, P0, normal: mean + 0 * normal + normal[0] * np.sqrt(np.diag(P0)),
            "Every run starts at the same wrong place. The belief speaks of many starts: each run has its own row.",
        ),
        "other side": (
            lambda mean, P0, normal: mean - normal * np.sqrt(np.diag(P0)),
            "As a draw that is just as good, for a bell is symmetric; but please add, so that the numbers can be compared.",
        ),
        "divided": (
            lambda mean, P0, normal: mean + normal / np.sqrt(np.diag(P0)),
            "You divided by the deviations: the vaguest state would scatter least.",
        ),
        "transposed": (
            lambda mean, P0, normal: (mean + normal * np.sqrt(np.diag(P0))).T,
            "The numbers are right, but turned on their side: one row a run, one column a state.",
        ),
    },
)
def true_starts(mean, P0, normal):
    """True starts (runs, 4) drawn from the belief N(mean, P0), P0 diagonal, by standard normal numbers (runs, 4)."""
    return mean + normal * np.sqrt(np.diag(P0))


def on_the_rail(rng):
    """An estimate, its variance, a reading and a nominal place on the rail."""
    x, nominal = (float(value) / 2 for value in rng.integers(5, 60, 2))
    return x, float(rng.integers(2, 40) / 2), float(rng.integers(20, 40)), nominal + 0.25


@exercise(
    hints=[
        "Two lines change. Where is the tangent drawn, and what does it expect at x?",
        "The slope is that at `nominal`. At x the line stands at: its height at the nominal, plus slope times the way from there to x.",
        "With `height = np.hypot(nominal, 20)`: `H = nominal / height` and `expected = height + H * (x - nominal)`; the rest as before.",
    ],
    inputs=on_the_rail,
    wrong=WRONG["linearised_correction"],
)
def linearised_correction(x, P, reading, nominal):
    """A correction of the cart on the rail (R = 4), with the tangent at `nominal`: the estimate and its variance."""
    H = nominal / np.hypot(nominal, 20)
    expected = np.hypot(nominal, 20) + H * (x - nominal)
    K = P * H / (H * P * H + 4)
    return x + K * (reading - expected), (1 - K * H) * P


@exercise(
    hints=[
        "Two things decide: does the path run away from the nominal, and is the sag of the tangent large beside a reading's σ of 2.24 m?",
        "The speeds are as in the start that was 30 m off. The sag grows with the square of σ: 100²/(2·316), which is 16 m.",
        "Seven times a reading's σ: each tangent is badly wrong. Which of the two filters draws the more of them, and counts each as news?",
    ],
    wrong={
        "EKF": (
            "EKF",
            "So says the slide. But each of its first corrections is sharp and bent, and it takes its own changes of mind for news.",
        ),
        "neither": (
            "no difference",
            "There was a difference at 30 m already, and the sag is eleven times as large now.",
        ),
    },
)
def winner():
    """Which filter errs less with a start wrong by 100 m and 1 m/s: "LKF", "EKF" or "no difference"?"""
    return "LKF"
