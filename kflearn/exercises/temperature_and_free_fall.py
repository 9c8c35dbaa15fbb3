"""Lesson 10: temperature and free fall."""

import numpy as np

from kflearn import rmse
from kflearn.exercises._hints import of_choice
from kflearn.exercises._slips import temperature_and_free_fall as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def rooms(rng):
    """An estimate and its variance, the true temperature, a reading, Q and R."""
    x, room, reading = (float(value) for value in rng.integers(200, 300, 3) / 10)
    P, Q, R = (float(value) for value in rng.integers(1, 60, 3) / 100)
    return x, P, room, reading, Q, R


@exercise(
    hints=[
        "Which of the six arguments may a filter look at, in a real room? And in which unit is `(1 - K) * P`?",
        "The innovation is reading minus prediction. (1 − K)P is in °C²; a standard deviation is in °C.",
        "Two changes: `K * (reading - x)` and `np.sqrt((1 - K) * P)`.",
    ],
    inputs=rooms,
    wrong=slips.mended_step.WRONG,
    fixed={"room": "the truth, at which the right step does not look"},
    then="With the truth in place of the reading the error looks clearly smaller than it would in a real room, where nobody knows the truth.",
)
def mended_step(x, P, room, reading, Q, R):
    """One step of the random walk's filter: the estimate and its standard deviation. `room` is the truth."""
    P = P + Q
    K = P / (P + R)
    x = x + K * (reading - x)
    return x, np.sqrt((1 - K) * P)


def days(rng, count):
    """A short series of readings, two at least; Q and R."""
    z = rng.integers(220, 280, count) / 10
    Q, R = (float(value) for value in rng.integers(1, 60, 2) / 100)
    return z, Q, R


@exercise(
    hints=[
        "Before the second reading, only the first one is known. What variance has an estimate that is a single reading? And which readings are still to come?",
        "Start with the variance of a reading, R. The first reading is used up by the start: the loop runs over `z[1:]`.",
        "`x, P = z[0], R`, then for each reading in `z[1:]`: P = P + Q, K = P / (P + R), x = x + K * (reading - x), P = (1 - K) * P.",
    ],
    inputs=in_turn(days, 3, 6, 4, 2, 9),
    wrong=slips.room_filter.WRONG,
    otherwise=lambda results, rights: slips.room_filter.of_a_start(results, room_filter.cases),
    then="A start at x = 0 with P = 10⁶ and a loop over all readings would give nearly the same: from so vague a start, the first correction makes x the first reading and P nearly R.",
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
        "There are two clues: the innovations are on one side of zero, and the NIS is above 1. Which of the four answers explains the first clue?",
        of_choice(
            {
                "g too small": "It is g. Now find the direction: where does a filter with too small a g expect the stone, too high or too low?",
                "r too small": "That explains the NIS. Does it also explain that the innovations are all on one side?",
                "r too large": "Does too large an R make the NIS larger or smaller than 1? And which of the four pushes the innovations to one side?",
            },
            "Take the four answers one by one: what does each do to the mean innovation, and what to the NIS?",
        ),
        "A wrong R leaves the innovations even on both sides. So it is g. Where does the filter expect the stone: too high or too low?",
        "The innovation is the reading minus the expected height. It is positive, so the filter expects the stone too low: in the filter it falls too fast.",
    ],
    wrong=slips.suspect.WRONG,
    also=["gravity too large"],
    otherwise=slips.suspect.SUSPECT,
    then="With a wrong R the innovations are on both sides of zero. Only a wrong g pushes them to one side. With too large a g "
    "the expected stone falls too fast, so the readings are above it and the innovations are positive.",
)
def suspect():
    """Innovations of +1.5 m on average in the last second, NIS 1.7: what is the filter of a falling stone told wrongly?"""
    return "g too large"


def draws(rng, steps):
    """Standard normal numbers for two states, and a diagonal Q."""
    return rng.normal(size=(2, steps)).round(2), np.diag(rng.integers(1, 30, 2) / 100)


@exercise(
    hints=[
        "Column k of the array is the noise of step k. How many numbers should it have?",
        "Stretch the first row by the root of Q₁₁ and the second by the root of Q₂₂; leave the array (2, N).",
        "`return np.sqrt(Q) @ normal` (the root entry by entry is right, because Q is diagonal).",
    ],
    inputs=in_turn(draws, 3, 5, 2, 1, 6),
    wrong=slips.noise.WRONG,
    fixed={"Q": "height and velocity are two states, so Q is always two by two"},
    then="For a Q with corners the root entry by entry is wrong: then take np.linalg.cholesky(Q) @ normal.",
)
def noise(normal, Q):
    """Noise with the diagonal covariance Q for N steps, (2, N), from standard normal numbers (2, N)."""
    return np.sqrt(Q) @ normal


def published_falls(rng, T):
    """A fall that goes underground: truth, readings, estimates, states predicted without readings, covariances."""
    x = np.stack([20 - np.arange(T) ** 2 * rng.integers(12, 30) / 10 + 0.25, -np.arange(T, dtype=float)], axis=1)
    noisy = x[:, None] + rng.integers(-20, 20, (T, 3, 2)) / 10 + 0.05
    variances = rng.integers(1, 90, (T, 2)) / 10
    cov = variances[:, :, None] * np.eye(2) + 0.05 * (1 - np.eye(2))
    return x, noisy[:, 0, :1], noisy[:, 1], noisy[:, 2], cov


@exercise(
    hints=[
        "There are three faults: which moments count, what the filter is compared with, and which entry of P belongs to the velocity.",
        "`above = x[:, 0] > 0` chooses the moments, as in `mean[above, 0]`. The velocity is state 1, and σ is the root of a variance.",
        "`rmse(mean[above, 0], x[above, 0])`, the same with `ignored`, and `np.sqrt(cov[above][-1, 1, 1])`.",
    ],
    inputs=in_turn(published_falls, 6, 8, 7, 10),
    wrong=slips.honest_report.WRONG,
    fixed={"z": "the raw readings, which an honest report of these three numbers does not need"},
    then="Always print the error of ignoring all readings beside that of the filter. The published report leaves it out.",
)
def honest_report(x, z, mean, ignored, cov):
    """Errors (rms, m) of the height while it is truly above 0: filter's, and when all readings are ignored; then σ of the velocity at the last such moment."""
    above = x[:, 0] > 0
    return rmse(mean[above, 0], x[above, 0]), rmse(ignored[above, 0], x[above, 0]), np.sqrt(cov[above][-1, 1, 1])
