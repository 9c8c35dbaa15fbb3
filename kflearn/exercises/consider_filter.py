"""Lesson 21: ignore, inflate, estimate or consider a bias."""

import math
from itertools import cycle

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._consider_by_hand import FIRST_COVARIANCE
from kflearn.exercises._consider_filter import WRONG
from kflearn.exercises._hints import after
from kflearn.exercises._slips_fifth_late import WRONG as FIFTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_data import WRONG as THIRD
from kflearn.exercises._slips_tracking import SLIPS
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "R is a variance. Which of the numbers you were given are standard deviations?",
        "The noise and the bias are independent, so their variances add.",
        "0.3² + 0.5² m².",
    ],
    wrong={
        "standard deviations added": (
            0.8,
            "0.8 is the sum of the standard deviations; R is a variance, so square each first.",
        ),
        "sum squared": (
            0.64,
            "(0.3 + 0.5)² would be right if noise and bias always pushed the same way; they are independent.",
        ),
        "variance plus σ": (
            0.59,
            "0.59 is 0.09 + 0.5, with the bias by its standard deviation: metres to square metres. With σ = 1 m nobody notices.",
        ),
        "root": (math.sqrt(0.34), "That is the standard deviation of a reading. R is its square."),
        "bias alone": (0.25, "That is the bias alone; the white noise has not gone away."),
        "noise alone": (0.09, "That is R without any inflation: the bias is ignored."),
        "variance plus σ of the noise": (
            0.55,
            "0.55 is 0.3 + 0.25, with the noise by its standard deviation: metres to square metres. R is 0.3² + 0.5².",
        ),
        "the planned one": (
            27,
            "R = 27 is the number that the lesson found by trial. The filter inflated by the variance adds the two variances.",
        ),
        "fused": (
            0.09 * 0.25 / 0.34,
            "That is what fusing the two gives, as if each were a reading. Both errors are in the same reading: their variances add.",
        ),
        "difference": (
            0.16,
            "0.16 is 0.25 − 0.09. Variances of independent errors add, whatever the sign of the errors.",
        ),
        "mean of the two": (
            lambda: (0.3**2 + 0.5**2) / 2,
            "0.17 is the mean of the two variances. Both errors are in every reading: their variances add.",
        ),
        "mean of the σ": (
            0.4,
            "0.4 m is the mean of the two standard deviations. Square each first, then add.",
        ),
        "product": (
            0.15,
            "0.15 is the product of the two standard deviations. The two errors are independent: their variances add.",
        ),
        "the lesson's": (
            1.25,
            "That is the lesson's R, with a noise of 0.5 m and a bias of 1 m. Here the numbers are others.",
        ),
    }
    | SLIPS["inflated"]
    | THIRD["inflated"]
    | TENTH["inflated"],
    otherwise=lambda R: SLIPS["inflated"]["by the memory"][1] if 9 < R < 11 else facts.deviation_of(R),
    unit="m²",
    then=(
        "For one reading R = 0.34 m² is right. For the mean of a hundred that share the bias it is not: its "
        "variance is 0.09/100 + 0.25, not 0.34/100."
    ),
)
def inflated():
    """R of the inflated filter for white noise with σ = 0.3 m and a bias with σ = 0.5 m."""
    return 0.3**2 + 0.5**2


@exercise(
    hints=[
        after(
            [[4 - 16 / 5.25, -4 / 5.25], [-4 / 5.25, 1 - 1 / 5.25]],
            "You have estimated the bias. Which row of the gain must be zero, and which form of (9) holds then?",
            "First the gain: which variances does the innovation z − x̂ hold? Three of them.",
        ),
        "K = [K₁, 0] with K₁ = 4 / (4 + 1 + 0.25). This is not the best gain any more: take Joseph's form, (9J).",
        "`gain = np.array([[4 / 5.25], [0]])`, `kept = np.eye(2) - gain @ [[1, 1]]`, then `kept @ np.diag([4, 1]) @ kept.T + gain * 0.25 @ gain.T`.",
    ],
    wrong=FIRST_COVARIANCE | SLIPS["first_covariance"] | THIRD["first_covariance"] | TENTH["first_covariance"],
    unit="m²",
    then="P₁₂ = −0.762 is the same in the augmented filter; the two differ in P₂₂, 1 here and 0.81 there. Considering means: the covariance with the bias is kept, and the bias is not learnt.",
)
def first_covariance():
    """P of position and bias after the first consider correction: P⁻ = diag(4, 1), H = [1, 1], R = 0.25."""
    gain = np.array([[4 / (4 + 1 + 0.25)], [0]])
    kept = np.eye(2) - gain @ [[1, 1]]
    return kept @ np.diag([4, 1]) @ kept.T + gain * 0.25 @ gain.T


def averages(rng):
    """A number of readings, and the variances of noise and bias."""
    return int(rng.integers(2, 200)), float(rng.integers(1, 9) / 4), float(rng.integers(1, 9) / 2)


@exercise(
    hints=[
        "Write the average's error: the mean of N noises, plus the mean of N times the same bias.",
        "The mean of N equal numbers is that number. Only the noise becomes smaller.",
        "`return np.sqrt(R / N + B)`",
    ],
    inputs=averages,
    wrong=WRONG["honest_average"] | THIRD["honest_average"] | FOURTH["honest_average"] | FIFTH["honest_average"],
    then="With R = 0.25 and B = 1 ten readings give 1.012 m and a hundred 1.001 m: soon the bias is all that is left.",
)
def honest_average(N, R, B):
    """The standard deviation of the average of N readings that share one constant bias: noise variance R, bias B."""
    return math.sqrt(R / N + B)


def beliefs(rng):
    """A state of three to five numbers, its P, a reading, H, R, and which of the states is considered."""
    n = int(rng.choice([5, 4, 3]))
    root = rng.integers(-3, 4, (n, n)) / 2 + 2 * np.eye(n)
    H = np.append(np.append(1.0, rng.integers(0, 3, n - 2) / 2), 1.0)[None]
    z, R = rng.integers(-9, 10, 1).astype(float), np.array([[rng.integers(1, 9) / 4]])
    return rng.integers(-9, 10, n).astype(float), root @ root.T, z, H, R, int(rng.integers(0, n))


@exercise(
    hints=[
        "Which gain corrects x, and which gain makes P smaller? They must be the same one.",
        "So zero the row first. But then K is not the best gain any more, and (9) holds for the best gain only.",
        "Zero the row; then `keep = np.eye(len(x)) - K @ H` and `P = keep @ P @ keep.T + K @ R @ K.T`.",
    ],
    inputs=beliefs,
    fixed=dict.fromkeys(("z", "R"), "one sensor, as in the lesson: its gain divides by the number S"),
    wrong=WRONG["late_row"] | SLIPS["late_row"],
    then=(
        "The variance of the considered state is what it was, to the last digit; what the reading changed is its "
        "covariance with the others."
    ),
)
def late_row(x, P, z, H, R, considered):
    """One consider correction for any number of states: state and covariance after the reading z, with no gain for one."""
    K = P @ H.T / (H @ P @ H.T + R)
    K[considered] = 0
    keep = np.eye(len(x)) - K @ H
    return x + K @ (z - H @ x), keep @ P @ keep.T + K @ R @ K.T


SIZES = cycle([(2, 2), (2, 2), (2, 2), (4, 3), (3, 2), (4, 2), (2, 1), (3, 1)])  # three alike: what fits at first only


def blocks(rng):
    """P of two to four states, their covariance C with one to three biases of covariance B, and how all of them move."""
    n, m = next(SIZES)
    root = rng.integers(-3, 4, (n + m, n + m)) / 2 + 2 * np.eye(n + m)
    whole, push = root @ root.T, rng.integers(1, 5, n) / 4
    F = np.eye(n) + np.triu(rng.integers(1, 9, (n, n)) / 8, 1)
    q = np.diag(rng.integers(1, 9, m) / 4)
    return whole[:n, :n], whole[:n, n:], whole[n:, n:], F, float(rng.integers(1, 8) / 8), np.outer(push, push), q


@exercise(
    hints=[
        "Lay out the whole F, with F at the upper left, `fading` at the lower right and zeros elsewhere. What is FPFᵀ?",
        "The error of the states is multiplied by F, that of the bias by `fading`. C is the mean of their product.",
        "`return F @ P @ F.T + Q, fading * F @ C, fading**2 * B + q`",
    ],
    inputs=blocks,
    wrong=WRONG["economical"]
    | SLIPS["economical"]
    | FOURTH["economical"]
    | FIFTH["economical"]
    | SEVENTH["economical"],
    then=(
        "C is what a consider filter remembers. With fading = 0 the bias is new at every step, C is zero, and the "
        "inflated filter would be right."
    ),
)
def economical(P, C, B, F, fading, Q, q):
    """The prediction in blocks: P of the states, C of states and bias, B of the bias."""
    return F @ P @ F.T + Q, fading * F @ C, fading**2 * B + q
