"""Lesson 1: from Gauss to Kalman."""

import numpy as np

from kflearn.exercises.engine import exercise

CONSTANT_GAIN = 0.2207


@exercise(
    hints=[
        "Two lines are wrong. The lesson has all the years you need: in the timeline, and in its text.",
        "Whose report was secret until 1949? And in which century do years such as 1722 and 1750 lie?",
        "Anti-aircraft fire: the Second World War, line 5. The years 1722, 1749 and 1750 are in the 18th century, line 1.",
    ],
    wrong={
        "only Wiener": (
            {5},
            "Line 5 is wrong: the report is from 1942. There is one more. In which century do 1722, 1749 and 1750 lie?",
        ),
        "only the first": (
            {1},
            "Line 1 is wrong: 1722, 1749 and 1750 lie in the 18th century. There is one more: in which war was Wiener's report secret?",
        ),
        "Gauss": (
            {3},
            "Line 3 is right: he printed in 1809, and 1795 is what he says of himself there. A claim about the past is not a date of print.",
        ),
        "Thiele": (
            {4},
            "Line 4 is right, surprising as it is: 1880, and Lauritzen made it known again in 1981.",
        ),
        "Legendre": ({2}, "Line 2 is right: Legendre's book on the orbits of comets came out in 1805."),
        "Kolmogorov": (
            {6},
            "Line 6 is right: a note in 1939, the full paper in 1941, before Wiener's report of 1942.",
        ),
        "Kalman": ({7}, "Line 7 is right: the paper came out in 1960. Kalman and Bucy followed in 1961."),
        "both and Gauss": (
            {1, 3, 5},
            "Lines 1 and 5 are wrong, but line 3 is right: 1809 is the print, 1795 Gauss's own claim.",
        ),
        "both and Thiele": (
            {1, 4, 5},
            "Lines 1 and 5 are wrong, but line 4 is right: Thiele's paper is from 1880.",
        ),
        "both and Kolmogorov": (
            {1, 5, 6},
            "Lines 1 and 5 are wrong, but line 6 is right: Kolmogorov's paper is from 1941.",
        ),
    },
)
def dates():
    """The numbers of the lines with a wrong date."""
    return {1, 5}  # 1722, 1749 and 1750 are in the 18th century; Wiener's report is from 1942


@exercise(
    hints=[
        "Add K(1 − K)ʲ for j = 0 to 9. All weights together, for ever, make 1.",
        "What is left over after ten readings is (1 − K)¹⁰. Each step leaves the part 1 − K of what was left.",
        "`1 - (1 - 0.2207) ** 10`",
    ],
    wrong={
        "the rest": (
            lambda: (1 - CONSTANT_GAIN) ** 10,
            "That is what lies on all readings older than these ten. The share of the ten is 1 minus it.",
        ),
        "nine readings": (
            lambda: 1 - (1 - CONSTANT_GAIN) ** 9,
            "You counted nine readings. From j = 0 to 9 there are ten: after the first, 1 − K is left; after ten, (1 − K)¹⁰.",
        ),
        "eleven readings": (
            lambda: 1 - (1 - CONSTANT_GAIN) ** 11,
            "You counted eleven readings: j = 0 to 9 are ten.",
        ),
        "one weight": (
            lambda: CONSTANT_GAIN * (1 - CONSTANT_GAIN) ** 9,
            "That is the weight of the tenth reading alone. Add up all ten.",
        ),
        "relative weight": (
            lambda: CONSTANT_GAIN * (1 - CONSTANT_GAIN) ** 10,
            "That is the weight of a single reading, ten nights ago. Add up the ten that are newer.",
        ),
        "ten times K": (
            lambda: 10 * CONSTANT_GAIN,
            "Only the newest reading has the weight K; and no share is larger than 1.",
        ),
        "powers of K": (
            lambda: 1 - CONSTANT_GAIN**10,
            "You took K to the power ten. What is left after each reading is the part 1 − K.",
        ),
        "per cent": (
            lambda: 100 * (1 - (1 - CONSTANT_GAIN) ** 10),
            "Right, in per cent. Give the share as a number between 0 and 1.",
        ),
        "as in a mean": (
            lambda: 10 / 40,
            "That would be the mean of forty readings, where all count the same. Here the newest count most.",
        ),
    },
)
def newest_ten():
    """The share of the whole weight that lies on the newest ten readings, with K = 0.2207 and weights K(1 − K)ʲ."""
    K = CONSTANT_GAIN
    return 1 - (1 - K) ** 10


def gains_and_lengths(rng):
    """A constant gain and a number of readings."""
    return int(rng.integers(1, 10)) / 10, int(rng.integers(3, 8))


def with_last(w, last):
    """The weights w with another one for the oldest reading."""
    return np.append(np.asarray(w)[:-1], last)


@exercise(
    hints=[
        "The newest reading has the weight K. Everything before it is multiplied by 1 − K. And again, for the one before.",
        "So K(1 − K)ʲ for all but the first reading. The estimate *starts* there: it was not reached with the part K.",
        "The oldest of n readings has the weight (1 − K)ⁿ⁻¹, without a K in front. Check that the sum is 1.",
        "`w = K * (1 - K) ** np.arange(n)`, then `w[-1] = (1 - K) ** (n - 1)`, then `return w`",
    ],
    inputs=gains_and_lengths,
    wrong={
        "infinite past": (
            lambda K, n: K * (1 - K) ** np.arange(n),
            "These are Wiener's, for an infinite past: their sum is not 1. The oldest reading is where the estimate starts, so its K is missing.",
        ),
        "oldest first": (
            lambda K, n: with_last(K * (1 - K) ** np.arange(n), (1 - K) ** (n - 1))[::-1],
            "The weights are right, but the oldest comes first. Newest first was asked for: turn them round with `[::-1]`.",
        ),
        "scaled": (
            lambda K, n: K * (1 - K) ** np.arange(n) / (1 - (1 - K) ** n),
            "These sum to 1, but by stretching all of them. `exponential` gives the missing part to its first reading alone.",
        ),
        "one power too many": (
            lambda K, n: with_last(K * (1 - K) ** np.arange(n), (1 - K) ** n),
            "Nearly: after the first reading there are n − 1 steps, so the oldest weight is (1 − K)ⁿ⁻¹.",
        ),
        "shifted": (
            lambda K, n: K * (1 - K) ** np.arange(1, n + 1),
            "The newest reading has the weight K itself: j begins at 0, not at 1.",
        ),
        "K and 1 − K swapped": (
            lambda K, n: with_last((1 - K) * K ** np.arange(n), K ** (n - 1)),
            "K and 1 − K are swapped: K is the part of the way towards the *new* reading.",
        ),
        "mean": (
            lambda K, n: np.full(n, 1 / n),
            "Those are the weights of the mean. With a constant gain the newest reading counts most.",
        ),
        "without K": (
            lambda K, n: (1 - K) ** np.arange(n),
            "These are relative to the newest. Multiply by K (all but the oldest), and check that the sum is 1.",
        ),
    },
)
def exponential_weights(K, n):
    """The n weights, newest first, of exponential smoothing that starts at its first reading."""
    w = K * (1 - K) ** np.arange(n)
    w[-1] = (1 - K) ** (n - 1)
    return w


@exercise(
    hints=[
        "In the end the distance to the clock stays the same from night to night. Call it d, measured after the reading.",
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
            "You multiplied by K. A *small* gain trails far behind: K belongs below the line.",
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
    },
    unit="s",
    rtol=5e-3,
)
def behind():
    """How far a constant gain of 0.2207 trails behind a clock that gains 0.3 s every night, in the end."""
    K = CONSTANT_GAIN
    return 0.3 * (1 - K) / K


def readings_and_gain(rng):
    """Some readings, a constant gain."""
    return rng.integers(-20, 61, int(rng.integers(3, 8))).astype(float), int(rng.integers(1, 10)) / 10


def powers(z, K):
    """The weights K(1 − K)ʲ in the order of the readings, oldest first."""
    return K * (1 - K) ** np.arange(len(z))[::-1]


def from_the_first(z, K):
    """Exponential smoothing that starts at the first reading."""
    x = z[0]
    for reading in z[1:]:
        x = x + K * (reading - x)
    return x


@exercise(
    hints=[
        "Which number must the result be divided by, so that ten readings of 60 s give 60 s?",
        "By the sum of the weights. `np.sum(w * z) / np.sum(w)` does it for any weights w.",
        "`w = (1 - K) ** np.arange(len(z))[::-1]`, then `return np.sum(w * z) / np.sum(w)`",
    ],
    inputs=readings_and_gain,
    wrong={
        "as published": (
            lambda z, K: np.sum(powers(z, K) * z),
            "That is still the published sum: its weights add up to 1 − (1 − K)ⁿ, as if a clock that is right had gone before.",
        ),
        "start at the first reading": (
            from_the_first,
            "Its weights do sum to 1, so this is honest as well. But it puts all that is missing on the first reading; the question wants the ratios kept.",
        ),
        "divided by n": (
            lambda z, K: np.sum(powers(z, K) * z) / len(z),
            "You divided by the number of readings. The weights are in the sum already; divide by *their* sum.",
        ),
        "newest and oldest swapped": (
            lambda z, K: np.sum(powers(z, K)[::-1] * z) / np.sum(powers(z, K)),
            "The sum is 1 now, but the oldest reading counts most: the order of the weights is turned round.",
        ),
        "plain mean": (
            lambda z, K: np.mean(z),
            "That is the mean: all readings count the same. Keep the ratio of neighbouring weights at 1 − K.",
        ),
        "one power too few": (
            lambda z, K: np.sum(powers(z, K) * z) / (1 - (1 - K) ** (len(z) - 1)),
            "Close: n weights sum to 1 − (1 − K)ⁿ, with n = len(z), not n − 1.",
        ),
        "missing part added": (
            lambda z, K: np.sum(powers(z, K) * z) + (1 - K) ** len(z) * z[-1],
            "You gave the missing part to the newest reading: the sum is 1, but the ratios have changed.",
        ),
        "multiplied": (
            lambda z, K: np.sum(powers(z, K) * z) * (1 - (1 - K) ** len(z)),
            "You multiplied by the sum of the weights. It is too small; divide by it.",
        ),
        "without K": (
            lambda z, K: np.sum((1 - K) ** np.arange(len(z))[::-1] * z),
            "Without K the weights sum to more than 1. Divide by their sum.",
        ),
    },
)
def mended(z, K):
    """Exponential smoothing of a short series: weights in the ratios of K(1 − K)ʲ that sum to 1."""
    w = K * (1 - K) ** np.arange(len(z))[::-1]
    return np.sum(w * z) / np.sum(w)
