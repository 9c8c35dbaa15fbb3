"""Lesson 28: from Gauss to Kalman."""

import numpy as np

from kflearn.exercises._hints import is_about
from kflearn.exercises._slips import history as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "Q says how far the clock may wander in a night. If it is above zero, the same clock's older readings tell less about tonight. Which rows show that?",
        "Two of the four have Q = 0. One was told that the clock's error is constant; the other that it changes by the same amount every night.",
        "D has equal weights: the mean. In A the weights fall by the same step each night, to below zero: the straight line of least squares.",
    ],
    wrong=slips.undisturbed.WRONG,
    then="D was told of a constant, A of a constant rate, and with Q = 0 nothing else may happen. B and C differ in how far the "
    "clock may wander: in B nearly all of the weight lies on the newest night.",
)
def undisturbed():
    """Which of the four filters, of which the weights are given, were told Q = 0?"""
    return {"A", "D"}


@exercise(
    hints=[
        "Add K(1 − K)ʲ for j = 0 to 9. All weights together, for ever, make 1.",
        "What is left over after ten readings is (1 − K)¹⁰. Each step leaves the part 1 − K of what was left.",
        "`1 - (1 - 0.15) ** 10`",
    ],
    wrong=slips.newest_ten.WRONG,
    otherwise=slips.newest_ten.older_than_ten,
    then="With the lesson's K = 0.2207 it is 0.92, and with a tenth of that gain only 0.20. The smaller the gain, the longer the past must be before it counts as infinite.",
)
def newest_ten():
    """The share of the whole weight that lies on the newest ten readings, with K = 0.15 and weights K(1 − K)ʲ."""
    gain = 0.15
    return 1 - (1 - gain) ** 10


def gains_and_lengths(rng, n):
    """A constant gain and a number of readings."""
    return int(rng.integers(1, 10)) / 10, n


@exercise(
    hints=[
        "The newest reading has the weight K. Everything before it is multiplied by 1 − K. And again, for the one before.",
        "So K(1 − K)ʲ for all but the first reading. The estimate *starts* there: it was not reached with the part K.",
        "The oldest of n readings has the weight (1 − K)ⁿ⁻¹, without a K in front. Check that the sum is 1.",
        "`w = K * (1 - K) ** np.arange(n)`, then `w[-1] = (1 - K) ** (n - 1)`, then `return w`",
    ],
    inputs=in_turn(gains_and_lengths, 2, 4, 3, 7, 1),
    wrong=slips.exponential_weights.WRONG,
    then="They sum to 1 for every n; for n = 1 the single weight is 1, since the first reading is all there is.",
)
def exponential_weights(K, n):
    """The n weights, newest first, of exponential smoothing that starts at its first reading."""
    w = K * (1 - K) ** np.arange(n)
    w[-1] = (1 - K) ** (n - 1)
    return w


@exercise(
    hints=[
        lambda last: (
            "The distance shrinks when the night's reading comes. Yours is the one before it: which is the one after it?"
            if is_about(last, 0.3 / 0.2207)
            else "In the end the distance to the clock is the same every night. Call it d, measured after the reading."
        ),
        "Each night the clock first runs 0.3 s further ahead, then the estimate goes the part K of the way: d = (1 − K)(d + 0.3).",
        "Solve for d: K d = (1 − K) · 0.3. Put in the numbers.",
        "`0.3 * (1 - 0.2207) / 0.2207`",
    ],
    wrong=slips.behind.WRONG,
    otherwise=slips.behind.next_night,
    unit="s",
    then="With twice the gain it would trail by 0.38 s only, but it would follow the noise more. Lesson 6 weighs one against the other.",
)
def behind():
    """How far a constant gain of 0.2207 trails behind a clock that gains 0.3 s every night, in the end."""
    gain = 0.2207
    return 0.3 * (1 - gain) / gain


def readings_and_gain(rng, n):
    """Some readings, a constant gain."""
    return rng.integers(-20, 61, n).astype(float), int(rng.integers(1, 10)) / 10


@exercise(
    hints=[
        "Which number must the result be divided by, so that ten readings of 60 s give 60 s?",
        "By the sum of the weights. `np.sum(w * z) / np.sum(w)` does it for any weights w.",
        "`w = (1 - K) ** np.arange(len(z))[::-1]`, then `return np.sum(w * z) / np.sum(w)`",
    ],
    inputs=in_turn(readings_and_gain, 3, 5, 8, 1),
    wrong=slips.mended.WRONG,
    then="With K = 0.2207 the published weights lack 8 % after ten readings and less than 0.01 % after forty: in a long series nobody notices.",
)
def mended(z, K):
    """Exponential smoothing of a short series: weights in the ratios of K(1 − K)ʲ that sum to 1."""
    w = K * (1 - K) ** np.arange(len(z))[::-1]
    return np.sum(w * z) / np.sum(w)
