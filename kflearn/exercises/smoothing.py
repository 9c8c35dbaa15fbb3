"""Lesson 23: smoothing."""

import numpy as np

from kflearn.exercises._hints import after
from kflearn.exercises._slips import smoothing as slips
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        after(
            (5.2, 1.2),
            "N(6, 2) holds the filter's N(4, 3) already: do not fuse, compare it with the prediction N(4, 4). G = P F / P⁻, with F = 1.",
            "First the gain: which part of what the prediction got wrong was wrong at step k already? G = P F / P⁻, with F = 1.",
        ),
        "G = 3/4. The mean moves by G times (known in the end − predicted); the variance changes by G² times a difference.",
        "`(4 + 3/4 * (6 - 4), 3 + (3/4)**2 * (2 - 4))`",
    ],
    wrong=slips.one_step_back.WRONG,
    otherwise=slips.one_step_back.gain_of,
    then="The filter said 3, the smoother says 1.875: what came later was worth a reading of step k with variance 5.",
)
def one_step_back():
    """Filtered N(4, 3), Q = 1, predicted N(4, 4), known in the end about the next step N(6, 2): (mean, variance)?"""
    gain = 3 / 4
    return 4 + gain * (6 - 4), 3 + gain**2 * (2 - 4)


def covariance(rng, n):
    factor = rng.integers(-2, 3, (n, n)) / 2 + 1.5 * np.eye(n)
    return factor @ factor.T + np.eye(n) / 2


def steps_back(rng):
    """A belief, a model with a lopsided F, and a smoothed belief about the next step that is surer than predicted."""
    n = int(rng.choice([4, 3, 2]))
    P, Q, F = covariance(rng, n), covariance(rng, n) / 2, np.eye(n) + np.triu(rng.integers(1, 4, (n, n)) / 4, 1)
    x, x_next = rng.integers(-9, 10, (2, n)) / 2
    P_pred = F @ P @ F.T + Q
    return x, P, F, Q, x_next, P_pred - P_pred @ np.linalg.solve(P_pred + covariance(rng, n), P_pred)


@exercise(
    hints=[
        "Three steps: predict step k+1 again from x and P; the gain; then mean and covariance, as in the five lines above.",
        "The prediction is F x with P⁻ = F P Fᵀ + Q. The gain G = P Fᵀ (P⁻)⁻¹ is `np.linalg.solve(P_pred, F @ P).T`.",
        "`return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred) @ G.T`",
    ],
    inputs=steps_back,
    wrong=slips.step_back.WRONG,
    then=(
        "No reading stands in these lines: the smoother uses only what the filter has stored, so the readings may "
        "be thrown away after the filter has run."
    ),
)
def step_back(x, P, F, Q, x_next, P_next):
    """One step of the RTS smoother: the smoothed mean (n,) and covariance (n, n) at step k."""
    P_pred = F @ P @ F.T + Q
    G = np.linalg.solve(P_pred, F @ P).T
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred) @ G.T


def two_filters(rng):
    """The covariances of a forward and a backward filter, of which now one is surer and now the other."""
    n = int(rng.choice([4, 3, 2]))
    return covariance(rng, n), covariance(rng, n) * rng.integers(1, 9) / 4


@exercise(
    hints=[
        "Two separate opinions about the same thing. What adds up when opinions are fused: covariances, or something else?",
        "Information adds up, and information is the inverse of a covariance. Or lesson 4: K = P (P + P_back)⁻¹.",
        "`return np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(P_back))`",
    ],
    inputs=two_filters,
    wrong=slips.smoothed_cov.WRONG,
    then=(
        "With P_back = P it is half of P: “half of the data” is right in the one place where both filters know "
        "equally much."
    ),
)
def smoothed_cov(P, P_back):
    """The smoother's covariance, from the forward filter's after zₖ and the backward filter's before zₖ, (n, n)."""
    gain = np.linalg.solve(P + P_back, P).T
    return gain @ P_back


def corrected_beliefs(rng):
    """Two beliefs about a number, both corrected with the same reading z of variance R."""
    R, z = rng.integers(2, 9) / 2, rng.integers(-8, 9) / 2
    before, back = rng.integers(2, 12, 2) / 2
    x, x_back = rng.integers(-8, 9, 2) / 2
    return x, before * R / (before + R), x_back, back * R / (back + R), z, R


@exercise(
    hints=[
        "Think in information: 1/P is how much a belief knows. 1/P + 1/P_back counts z twice. How much did z bring each time?",
        "A reading with variance R brings 1/R. Take it out once. The mean is a sum weighted in the same way: x/P + x_back/P_back − …",
        "`information = 1/P + 1/P_back - 1/R`, then `return (x/P + x_back/P_back - z/R) / information, 1 / information`",
    ],
    inputs=corrected_beliefs,
    wrong=slips.count_once.WRONG,
    then=(
        "Where the backward filter knows nothing but z, so that P_back = R and x_back = z, the result is the "
        "forward filter's N(x, P): z has already been used."
    ),
)
def count_once(x, P, x_back, P_back, z, R):
    """Mean and variance of two beliefs that have both used z, with z counted once."""
    information = 1 / P + 1 / P_back - 1 / R
    return (x / P + x_back / P_back - z / R) / information, 1 / information


@exercise(
    hints=[
        "Divide the first printed error by the second. For the train of this lesson it was 0.443 m by 0.920 m.",
        "A straight line has the noise of the two readings at its ends. In which of the two records is this noise the larger part?",
        "0.39 by 0.43 is a little more than nine tenths: B.",
    ],
    wrong=slips.real_gap.WRONG,
    otherwise=slips.real_gap.GAP,
    then="Both errors contain the noise of the hidden readings, σ = 0.32 ppm, which no method can remove. Without it about 0.23 ppm are left for the smoother and 0.29 for the line: a fifth less. In six weeks the air changes nearly along a straight line.",
)
def real_gap():
    """Smoother against a straight line in six hidden weeks of carbon dioxide: half, a little smaller, or larger?"""
    return "B"
