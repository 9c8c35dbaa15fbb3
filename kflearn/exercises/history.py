"""Lesson 28: from Gauss to Kalman."""

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._hints import is_about
from kflearn.exercises._history import WRONG, wrong_letters
from kflearn.exercises._slips_data import SLIPS as MORE
from kflearn.exercises._slips_fifth_late import WRONG as FIFTH
from kflearn.exercises._slips_foundations import WRONG as SLIPS
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_data import WRONG as THIRD
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise

CONSTANT_GAIN, SLOW_GAIN = 0.2207, 0.15


@exercise(
    hints=[
        "Q says how far the clock may wander in a night. If it is above zero, the same clock's older readings tell less about tonight. Which rows show that?",
        "Two of the four have Q = 0. One was told that the clock's error is constant; the other that it changes by the same amount every night.",
        "D has equal weights: the mean. In A the weights fall by the same step each night, to below zero: the straight line of least squares.",
    ],
    wrong={", ".join(sorted(picked)): (picked, sentence) for picked, sentence in wrong_letters()},
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
    wrong={
        "the rest": (
            lambda: (1 - SLOW_GAIN) ** 10,
            "That is what lies on all readings older than these ten. The share of the ten is 1 minus it.",
        ),
        "nine readings": (
            lambda: 1 - (1 - SLOW_GAIN) ** 9,
            "That is the share of the newest nine. From j = 0 to 9 there are ten: after the first, 1 − K is left; after ten, (1 − K)¹⁰.",
        ),
        "eleven readings": (
            lambda: 1 - (1 - SLOW_GAIN) ** 11,
            "That is the share of the newest eleven: j = 0 to 9 are ten.",
        ),
        "one weight": (
            lambda: SLOW_GAIN * (1 - SLOW_GAIN) ** 9,
            "That is the weight of the tenth reading alone. Add up all ten.",
        ),
        "relative weight": (
            lambda: SLOW_GAIN * (1 - SLOW_GAIN) ** 10,
            "That is the weight of a single reading, ten nights ago. Add up the ten that are newer.",
        ),
        "ten times K": (
            lambda: 10 * SLOW_GAIN,
            "Only the newest reading has the weight K; and no share is larger than 1.",
        ),
        "the lesson's K": (
            lambda: 1 - (1 - CONSTANT_GAIN) ** 10,
            "That is right for the lesson's K = 0.2207. Here K is 0.15.",
        ),
        "powers of K": (
            lambda: 1 - SLOW_GAIN**10,
            "That is the whole weight, or nearly, but older readings have some of it: after each reading the part 1 − K of the weights before is left.",
        ),
        "per cent": (
            lambda: 100 * (1 - (1 - SLOW_GAIN) ** 10),
            "Right, in per cent. Give the share as a number between 0 and 1.",
        ),
        "as in a mean": (
            lambda: 10 / 40,
            "That would be the mean of forty readings, where all count the same. Here the newest count most.",
        ),
        "the tenth power of K": (
            lambda: SLOW_GAIN**10,
            "That is K to the power ten. After each reading the part 1 − K is left for the older ones.",
        ),
        "K forgotten": (
            lambda: (1 - (1 - SLOW_GAIN) ** 10) / SLOW_GAIN,
            "That is the sum of (1 − K)ʲ, without the factor K. A share is at most 1.",
        ),
        "ten of a hundred": (
            0.1,
            "That is ten of a hundred nights, if all counted the same. Here the newest count most.",
        ),
        "ten nights ago": (
            lambda: 1 - SLOW_GAIN,
            "That is what one reading leaves to all older ones. Ten readings leave (1 − K)¹⁰.",
        ),
        "j from 1": (
            lambda: sum(SLOW_GAIN * (1 - SLOW_GAIN) ** j for j in range(1, 11)),
            "That is the sum for j = 1 to 10. The newest reading has j = 0.",
        ),
        "the newest alone": (0.15, "That is the newest reading alone. Add the nine before it."),
        "as a list": (
            lambda: [SLOW_GAIN * (1 - SLOW_GAIN) ** j for j in range(10)],
            "These are the ten weights. Add them up.",
        ),
        "the rest in per cent": (
            lambda: 100 * (1 - SLOW_GAIN) ** 10,
            "That is the share of all older readings, in per cent. The ten newest have what is left of the whole.",
        ),
    }
    | TENTH["newest_ten"],
    otherwise=facts.older_than_ten,
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
    wrong=WRONG["exponential_weights"]
    | SLIPS["exponential_weights"]
    | MORE["exponential_weights"]
    | FOURTH["exponential_weights"]
    | SEVENTH["exponential_weights"],
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
    wrong={
        "before the reading": (
            lambda: 0.3 / CONSTANT_GAIN,
            "That is the distance *before* the night's reading, d + 0.3. After it the estimate has gone the part K of the way: d = 0.3(1 − K)/K.",
        ),
        "one night": (0.3, "0.3 s is what one night adds. But the estimate has not caught up with the nights before."),
        "the root mean square": (
            1.27,
            "1.27 s is what `compare` printed: the trailing and the noise together. The trailing alone is less.",
        ),
        "first night": (
            lambda: 0.3 * (1 - CONSTANT_GAIN),
            "That is the distance after the first night only. It grows until each night takes away as much as it adds.",
        ),
        "times K": (
            lambda: 0.3 * CONSTANT_GAIN,
            "That is 0.3 times K. With a *small* gain the estimate is far behind: K belongs in the denominator.",
        ),
        "upside down": (
            lambda: 0.3 * CONSTANT_GAIN / (1 - CONSTANT_GAIN),
            "The fraction is upside down: with a gain near 1 the estimate hardly trails, with one near 0 it trails far.",
        ),
        "nights": (
            lambda: (1 - CONSTANT_GAIN) / CONSTANT_GAIN,
            "That is how many *nights* it trails, the mean age of what it knows. Each is worth 0.3 s.",
        ),
        "minus sign": (
            lambda: -0.3 * (1 - CONSTANT_GAIN) / CONSTANT_GAIN,
            "The size is right. How far it *trails* was asked for, a positive number.",
        ),
        "1 − K below": (
            lambda: 0.3 / (1 - CONSTANT_GAIN),
            "That is 0.3 divided by 1 − K. Each night the estimate goes the part K of the way, so K belongs in the denominator.",
        ),
        "nights of 1/K": (
            lambda: 1 / CONSTANT_GAIN,
            "1/K is a number of nights. Each is worth 0.3 s, and the last of them has been caught up with.",
        ),
        "not at all": (
            0,
            "A constant gain never catches up with a steady drift: each night the part 1 − K of the new distance is left.",
        ),
        "two nights": (
            lambda: 0.3 * (1 - CONSTANT_GAIN) + 0.3 * (1 - CONSTANT_GAIN) ** 2,
            "That is the distance after the second night. It goes on growing until each night takes away what it adds.",
        ),
    }
    | MORE["behind"]
    | THIRD["behind"]
    | FOURTH["behind_28"]
    | FIFTH["behind_28"],
    otherwise=facts.next_night,
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
    wrong=WRONG["mended"] | MORE["mended"] | THIRD["mended"],
    then="With K = 0.2207 the published weights lack 8 % after ten readings and less than 0.01 % after forty: in a long series nobody notices.",
)
def mended(z, K):
    """Exponential smoothing of a short series: weights in the ratios of K(1 − K)ʲ that sum to 1."""
    w = K * (1 - K) ** np.arange(len(z))[::-1]
    return np.sum(w * z) / np.sum(w)
