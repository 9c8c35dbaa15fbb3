"""Lesson 9: temperature and free fall."""

import numpy as np

from kflearn import rmse
from kflearn.exercises._temperature_and_free_fall import WRONG
from kflearn.exercises.engine import exercise


def rooms(rng):
    """An estimate and its variance, the true temperature, a reading, Q and R."""
    x, room, reading = (float(value) for value in rng.integers(200, 300, 3) / 10)
    P, Q, R = (float(value) for value in rng.integers(1, 60, 3) / 100)
    return x, P, room, reading, Q, R


def step(x, P, reading, Q, R):
    """One step of the random walk's filter: the estimate, its variance, its predicted variance."""
    predicted = P + Q
    K = predicted / (predicted + R)
    return x + K * (reading - x), (1 - K) * predicted, predicted


@exercise(
    hints=[
        "Which of the six arguments may a filter look at, in a real room? And in which unit is `(1 - K) * P`?",
        "The innovation is reading minus prediction. (1 − K)P is in °C²; a standard deviation is in °C.",
        "Two changes: `K * (reading - x)` and `np.sqrt((1 - K) * P)`.",
    ],
    inputs=rooms,
    wrong={
        "as published": (
            lambda x, P, room, reading, Q, R: (
                step(x, P, room, Q, R)[0],
                step(x, P, room, Q, R)[1],
            ),
            "That is the published step again: it corrects with the room's true temperature, and it hands back a variance.",
        ),
        "still the truth": (
            lambda x, P, room, reading, Q, R: (step(x, P, room, Q, R)[0], np.sqrt(step(x, P, room, Q, R)[1])),
            "The deviation is right now. But the estimate is still corrected with `room`, the truth, which no filter is ever shown.",
        ),
        "still the variance": (
            lambda x, P, room, reading, Q, R: step(x, P, reading, Q, R)[:2],
            "The estimate is right now. But (1 − K)P is a variance, in °C²; its root is the deviation.",
        ),
        "predicted deviation": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], np.sqrt(step(x, P, reading, Q, R)[2])),
            "That is the deviation before the reading; the factor 1 − K under the root is missing.",
        ),
        "root of the old P": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], np.sqrt(P)),
            "You took the root of the P that came in. P has since grown by Q and shrunk by 1 − K.",
        ),
        "root of P alone": (
            lambda x, P, room, reading, Q, R: (
                step(x, P, reading, Q, R)[0],
                (1 - (P + Q) / (P + Q + R)) * np.sqrt(P + Q),
            ),
            "The factor 1 − K belongs under the root: it shrinks the variance, and the deviation by its root only.",
        ),
        "Q forgotten": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, 0, R)[0], np.sqrt(step(x, P, reading, 0, R)[1])),
            "You forgot to predict: P grows by Q before the gain is formed.",
        ),
        "1 − K for K": (
            lambda x, P, room, reading, Q, R: (
                reading + (P + Q) / (P + Q + R) * (x - reading),
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "K and 1 − K have changed places in the correction: start at the prediction and walk the fraction K towards the reading.",
        ),
        "average of truth and reading": (
            lambda x, P, room, reading, Q, R: (
                step(x, P, (room + reading) / 2, Q, R)[0],
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "Half a truth is still a truth that no filter is shown: correct with the reading alone.",
        ),
        "sign of the innovation": (
            lambda x, P, room, reading, Q, R: (
                2 * x - step(x, P, reading, Q, R)[0],
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "The innovation has the wrong sign: your estimate walks away from the reading.",
        ),
    },
)
def mended_step(x, P, room, reading, Q, R):
    """One step of the random walk's filter: the estimate and its standard deviation. `room` is the truth."""
    P = P + Q
    K = P / (P + R)
    x = x + K * (reading - x)
    return x, np.sqrt((1 - K) * P)


def days(rng):
    """A short series of readings, Q and R."""
    z = rng.integers(220, 280, int(rng.integers(3, 7))) / 10
    Q, R = (float(value) for value in rng.integers(1, 60, 2) / 100)
    return z, Q, R


def loop(x, P, z, Q, R):
    """The random walk's filter from a given start."""
    for reading in z:
        x, P, _ = step(x, P, reading, Q, R)
    return x, P


@exercise(
    hints=[
        "What is the variance of a single reading, before anything else is known? And which readings are still to come?",
        "Start with the variance of a reading, R. The first reading is used up by the start: the loop runs over `z[1:]`.",
        "`x, P = z[0], R`, then for each reading in `z[1:]`: P = P + Q, K = P / (P + R), x = x + K * (reading - x), P = (1 - K) * P.",
    ],
    inputs=days,
    wrong={
        "as published": (
            lambda z, Q, R: loop(z[0], Q, z[1:], Q, R),
            "That is the published start again: Q says how far the room moves in a step, not how good a reading is.",
        ),
        "published number": (
            lambda z, Q, R: loop(z[0], 0.01, z[1:], Q, R),
            "0.01 is the published number. What does the first reading deserve, for any R?",
        ),
        "first reading twice": (
            lambda z, Q, R: loop(z[0], R, z, Q, R),
            "The first reading counts twice: it makes the start, and then the loop corrects with it once more. Begin the loop at z[1].",
        ),
        "published, and twice": (
            lambda z, Q, R: loop(z[0], Q, z, Q, R),
            "Two faults: the start claims Q instead of a reading's variance, and the first reading is used again in the loop.",
        ),
        "certain": (
            lambda z, Q, R: loop(z[0], 0.0, z[1:], Q, R),
            "P = 0 says that the first reading is exact: worse than the published start.",
        ),
        "R + Q": (
            lambda z, Q, R: loop(z[0], R + Q, z[1:], Q, R),
            "At the moment of the first reading nothing has moved yet: P = R. The first prediction, in the loop, adds Q.",
        ),
        "σ for variance": (
            lambda z, Q, R: loop(z[0], np.sqrt(R), z[1:], Q, R),
            "P is a variance: start it with R itself, not with its root.",
        ),
        "Q forgotten": (
            lambda z, Q, R: loop(z[0], R, z[1:], 0, R),
            "The start is right. But without Q this is the plain average of all readings, right for a room that never changes.",
        ),
        "ignores": (
            lambda z, Q, R: (z[0], R),
            "That is the start alone: the other readings are still to be filtered.",
        ),
    },
)
def room_filter(z, Q, R):
    """The random walk's filter over the series z, started at its first reading: the last estimate and its variance."""
    x, P = z[0], R
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x = x + K * (reading - x)
        P = (1 - K) * P
    return x, P


@exercise(
    hints=[
        "Two clues: the innovations lie on one side, and there are more surprises than promised. Which suspects explain the first?",
        "A wrong R leaves the innovations even on both sides. So it is g. Where does the filter expect the stone: too high or too low?",
        "Innovation = reading − expected. It is positive, so the filter expects the stone too low: it lets it fall too fast.",
    ],
    wrong={
        "g too small": (
            "g too small",
            "With g too small the filter expects the stone too high; the readings would lie below, with a minus sign.",
        ),
        "R too small": (
            "R too small",
            "That would explain a NIS above 1. But the innovations would fall evenly on both sides and average zero.",
        ),
        "R too large": (
            "R too large",
            "With R too large the NIS would lie below 1, and the innovations would average zero.",
        ),
    },
)
def suspect():
    """Innovations of +1.5 m on average in the last second, NIS 1.7: what is the filter of a falling stone told wrongly?"""
    return "g too large"


def draws(rng):
    """Standard normal numbers for two states, and a diagonal Q."""
    return rng.normal(size=(2, int(rng.integers(3, 7)))).round(2), np.diag(rng.integers(1, 30, 2) / 100)


@exercise(
    hints=[
        "Column k of the array is the noise of step k: how many numbers should it have?",
        "Stretch the first row by the root of Q₁₁ and the second by the root of Q₂₂; leave the array (2, N).",
        "`return np.sqrt(Q) @ normal` (the root entry by entry is right, because Q is diagonal).",
    ],
    inputs=draws,
    wrong={
        "as published": (
            lambda normal, Q: np.array([(np.sqrt(Q) @ normal).T.ravel()[: normal.shape[1]]] * 2),
            "That is the published one again: one number, alternately from height and velocity, added to both.",
        ),
        "first row twice": (
            lambda normal, Q: np.array([(np.sqrt(Q) @ normal)[0]] * 2),
            "Both states still get the same number, now that of the height.",
        ),
        "one draw, stretched twice": (
            lambda normal, Q: np.outer(np.sqrt(np.diag(Q)), normal[0]),
            "The variances are right, but one draw serves both states: they always move together. Each row has draws of its own.",
        ),
        "Q for its root": (
            lambda normal, Q: Q @ normal,
            "You stretched by the variances: the noise would have the covariance Q². Stretch by their roots.",
        ),
        "not stretched": (
            lambda normal, Q: normal,
            "Standard normal numbers have variance 1; bring in Q.",
        ),
        "divided": (
            lambda normal, Q: normal / np.sqrt(np.diag(Q))[:, None],
            "You divided by the deviations; that would make given noise standard normal.",
        ),
        "swapped": (
            lambda normal, Q: np.sqrt(Q)[::-1, ::-1] @ normal,
            "Height and velocity have changed places: the first row belongs to the first entry of Q.",
        ),
        "transposed": (
            lambda normal, Q: (np.sqrt(Q) @ normal).T,
            "The numbers are right, but turned on their side: one column for each step was asked for, (2, N).",
        ),
        "reshaped": (
            lambda normal, Q: (np.sqrt(Q) @ normal).T.ravel().reshape(2, -1),
            "Read down the columns and refilled along the rows: height and velocity are mixed up.",
        ),
    },
)
def noise(normal, Q):
    """Noise with the diagonal covariance Q for N steps, (2, N), from standard normal numbers (2, N)."""
    return np.sqrt(Q) @ normal


def published_falls(rng):
    """A fall that goes underground: truth, readings, estimates, states predicted without readings, covariances."""
    T = int(rng.integers(6, 9))
    x = np.stack([20 - np.arange(T) ** 2 * rng.integers(12, 30) / 10 + 0.25, -np.arange(T, dtype=float)], axis=1)
    noisy = x[:, None] + rng.integers(-20, 20, (T, 3, 2)) / 10 + 0.05
    variances = rng.integers(1, 90, (T, 2)) / 10
    cov = variances[:, :, None] * np.eye(2) + 0.05 * (1 - np.eye(2))
    return x, noisy[:, 0, :1], noisy[:, 1], noisy[:, 2], cov


@exercise(
    hints=[
        "Three faults: which moments count, what the filter is compared with, and which entry of P is the velocity's.",
        "`above = x[:, 0] > 0` chooses the moments, as in `mean[above, 0]`. The velocity is state 1; the ± of a number is a root.",
        "`rmse(mean[above, 0], x[above, 0])`, the same with `ignored`, and `np.sqrt(cov[above][-1, 1, 1])`.",
    ],
    inputs=published_falls,
    wrong=WRONG["honest_report"],
)
def honest_report(x, z, mean, ignored, cov):
    """Errors (rms, m) of the height while it is truly above 0: filter's, and when all readings are ignored; then σ of the velocity at the last such moment."""
    above = x[:, 0] > 0
    return rmse(mean[above, 0], x[above, 0]), rmse(ignored[above, 0], x[above, 0]), np.sqrt(cov[above][-1, 1, 1])
