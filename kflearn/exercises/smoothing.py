"""Lesson 23: smoothing."""

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._hints import after
from kflearn.exercises._slips_data import SLIPS
from kflearn.exercises._slips_eleventh import WRONG as ELEVENTH
from kflearn.exercises._slips_fifth_late import WRONG as FIFTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_fourth_words import GAP
from kflearn.exercises._slips_third_data import WRONG as THIRD
from kflearn.exercises._smoothing import WRONG
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
    wrong={
        "Q forgotten": (
            (6.0, 2.0),
            "That is the belief about step k+1, unchanged, as with G = 1. That holds for Q = 0 only; here G = 3/4.",
        ),
        "G = 1": (
            (6.0, 1.0),
            "That is right for G = 1: all of what was wrong at step k+1 would have been wrong at step k. Here Q = 1, and G = P/P⁻ = 3/4.",
        ),
        "G once in the variance, turned": (
            (5.5, 2.25),
            "The mean is right. 2.25 is G times the filter's 3. The variance is 3 + G² (2 − 4).",
        ),
        "gain upside down": (
            (4 + 8 / 3, 3 - 32 / 9),
            "Your gain is P⁻/P, and so the variance has become negative. It is P/P⁻ = 3/4.",
        ),
        "compared with the filter": (
            (5.5, 3 - 9 / 16),
            "The mean is right. Your variance is 3 + G² (2 − 3), with the filter's 3; compare 2 with the predicted 4.",
        ),
        "only Q added": (
            (6.0, 3.0),
            "That is N(6, 2) with Q added, as if walked back from step k+1. It forgets what the filter knew about step k, N(4, 3).",
        ),
        "fused with it": (
            (5.2, 1.2),
            "That is N(4, 3) fused with N(6, 2). But they are not two separate opinions: N(6, 2) already contains what the filter knew about step k. Compare N(6, 2) with the prediction N(4, 4).",
        ),
        "fused, with Q": (
            (5.0, 1.5),
            "That is N(4, 3) fused with N(6, 2 + 1). Q is in its place, but N(6, 2) already contains the filter's N(4, 3), which now counts twice. Use the gain G = 3/4 on the differences.",
        ),
        "G not squared": (
            (5.5, 1.5),
            "The mean is right. In the variance G stands on both sides, G (Pˢ − P⁻) Gᵀ: for a number that is G².",
        ),
        "variance added": (
            (5.5, 4.125),
            "The mean is right. In the variance it is Pˢ − P⁻ = 2 − 4: knowing more makes it smaller, not larger.",
        ),
        "filter's variance": (
            (5.5, 3.0),
            "The mean is right. The variance must fall too, for the end of the record tells something about step k.",
        ),
        "σ for the variance": (
            (5.5, 1.875**0.5),
            "Right up to the last step: that is the standard deviation, and the variance was asked for.",
        ),
        "swapped": (
            (1.875, 5.5),
            "The two numbers are right, in the wrong order: first the mean, then the variance.",
        ),
        "nothing learnt": (
            (4.0, 3.0),
            "That is the filter's belief about step k. The end of the record tells more: move it by G times what "
            "the prediction got wrong.",
        ),
        "variance of the next": (
            (5.5, 2.0),
            "The mean is right. 2 is the variance of step k+1; at step k it is 3 + G² (2 − 4).",
        ),
        "half way": (
            (5.0, 2.5),
            "That is the middle of N(4, 3) and N(6, 2). The gain says how far to go: G = P/P⁻ = 3/4.",
        ),
        "half way, variance of the next": (
            (5.0, 2.0),
            "5 is half way from 4 to 6. The gain says how far: G = P/P⁻ = 3/4; and the variance becomes 3 + G² (2 − 4).",
        ),
        "gain of Q": (
            (4.5, 2.875),
            "Your gain is Q/P⁻ = 1/4. It is the filter's own share, G = P/P⁻ = 3/4.",
        ),
        "sign": (
            (2.5, 1.875),
            "The variance is right. The mean moves towards what is known in the end: 6 − 4 is positive.",
        ),
        "only the change of the variance": (
            (5.5, 1.125),
            "The mean is right. 1.125 is what the variance loses, G² times 2; take it off 3.",
        ),
        "the mean alone": (
            5.5,
            "The mean is right. Hand in two numbers, `(mean, variance)`.",
        ),
        "gain with the next variance": (
            (4 + 3 / 5 * 2, 3 + (3 / 5) ** 2 * -2),
            "That is right for a gain of 3/(3 + 2), with the variance of the next step. The gain is P divided by the *predicted* variance, 3/4.",
        ),
        "gain of two thirds": (
            (4 + 2 / 3 * 2, 3 - 4 / 9 * 2),
            "Your gain is 2/3. It is the filter's variance by the predicted one: 3/4.",
        ),
    }
    | SLIPS["one_step_back"]
    | THIRD["one_step_back"]
    | FIFTH["one_step_back"]
    | ELEVENTH["one_step_back"],
    otherwise=facts.gain_of,
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
    wrong=WRONG["step_back"]
    | SLIPS["step_back"]
    | THIRD["step_back"]
    | FOURTH["step_back"]
    | FIFTH["step_back"]
    | ELEVENTH["step_back"],
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
    wrong=WRONG["smoothed_cov"] | SLIPS["smoothed_cov"] | ELEVENTH["smoothed_cov"],
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
    wrong=WRONG["count_once"]
    | SLIPS["count_once"]
    | THIRD["count_once"]
    | FIFTH["count_once"]
    | ELEVENTH["count_once"],
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
    wrong={
        "half": (
            "A",
            "That was the train. Divide the two errors that are printed here: the smoother's is not half of the line's.",
        ),
        "larger": (
            "C",
            "The difference has a minus: the smoother's error is the smaller one, by about two standard errors.",
        ),
    }
    | FOURTH["real_gap"],
    otherwise=GAP,
    then="Both errors contain the noise of the hidden readings, σ = 0.32 ppm, which no method can remove. Without it about 0.23 ppm are left for the smoother and 0.29 for the line: a fifth less. In six weeks the air changes nearly along a straight line.",
)
def real_gap():
    """Smoother against a straight line in six hidden weeks of carbon dioxide: half, a little smaller, or larger?"""
    return "B"
