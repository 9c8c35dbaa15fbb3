"""Lesson 21: ignore, inflate, estimate or consider a bias."""

import math
from itertools import cycle

import numpy as np

from kflearn.exercises._hints import after
from kflearn.exercises._slips import consider_filter as slips
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "R is a variance. Which of the numbers you were given are standard deviations?",
        "The noise and the bias are independent, so their variances add.",
        "0.3² + 0.5² m².",
    ],
    wrong=slips.inflated.WRONG,
    otherwise=lambda R: slips.inflated.BY_MEMORY if 9 < R < 11 else slips.inflated.deviation_of(R),
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
    wrong=slips.first_covariance.WRONG,
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
    wrong=slips.honest_average.WRONG,
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
    wrong=slips.late_row.WRONG,
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
    wrong=slips.economical.WRONG,
    then=(
        "C is what a consider filter remembers. With fading = 0 the bias is new at every step, C is zero, and the "
        "inflated filter would be right."
    ),
)
def economical(P, C, B, F, fading, Q, q):
    """The prediction in blocks: P of the states, C of states and bias, B of the bias."""
    return F @ P @ F.T + Q, fading * F @ C, fading**2 * B + q
