"""Lesson 28, `mended`: wrong answers, each with the sentence that it gets."""

import numpy as np


def powers(z, K):
    """The weights K(1 − K)ʲ in the order of the readings, oldest first."""
    return K * (1 - K) ** np.arange(len(z))[::-1]


def from_the_first(z, K):
    """Exponential smoothing that starts at the first reading."""
    x = z[0]
    for reading in z[1:]:
        x = x + K * (reading - x)
    return x


def published(z, K):
    """The published sum of lesson 28, with weights K(1 − K)ʲ."""
    return np.sum(K * (1 - K) ** np.arange(len(z))[::-1] * z)


def weights(z, K):
    return (1 - K) ** np.arange(len(z))[::-1]


WRONG = {
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
    "divided by 0.917": (
        lambda z, K: np.sum(powers(z, K) * z) / 0.917,
        "0.917 is the sum of the weights for ten readings and the lesson's K. Divide by the sum of *these* weights, which depends on K and on the number of readings.",
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
    "divided by the rest": (
        lambda z, K: np.sum(powers(z, K) * z) / (1 - K) ** len(z),
        "You divided by the weight that is missing. Divide by the weight that is there, the sum of the n weights.",
    ),
    "the weights": (
        lambda z, K: powers(z, K) / np.sum(powers(z, K)),
        "These are the mended weights. The smoothed value is wanted: multiply by the readings and add up.",
    ),
    "not added up": (
        lambda z, K: powers(z, K) * z / np.sum(powers(z, K)),
        "These are the readings with their weights. Add them up: one number is wanted.",
    ),
    "order of the powers": (
        lambda z, K: np.sum((1 - K) ** (np.arange(len(z)) + 1) * z) / np.sum(K * (1 - K) ** (np.arange(len(z)) + 1)),
        "The powers run the wrong way: the last reading is the newest, so its power is 0. And divide by the sum of the very weights that you used.",
    ),
    "the first reading": (lambda z, K: z[0], "You return the first reading. All readings have a weight."),
    "the newest reading": (lambda z, K: z[-1], "You return the newest reading. The older ones have a weight too."),
    "K and 1 − K swapped": (
        lambda z, K: np.sum(K ** np.arange(len(z))[::-1] * z) / np.sum(K ** np.arange(len(z))),
        "K and 1 − K are swapped: the weight falls by the factor 1 − K from a reading to the one before.",
    ),
    "rest spread": (
        lambda z, K: published(z, K) + (1 - K) ** len(z) * np.mean(z),
        "The sum is 1, but the missing part was spread evenly: the ratios have changed. Divide by the sum of the weights.",
    ),
    "divided by the sum of z": (
        lambda z, K: published(z, K) / np.sum(z),
        "You divided by the sum of the readings. Divide by the sum of the weights.",
    ),
    "divided by a power": (
        lambda z, K: published(z, K) / (1 - (1 - K) ** (len(z) + 1)),
        "Close: n weights sum to 1 − (1 − K)ⁿ, with n = len(z), not n + 1.",
    ),
    "the missing part": (
        lambda z, K: published(z, K) + (1 - K) ** len(z),
        "You added the missing weight by itself. A weight multiplies a reading: divide by the sum of the weights.",
    ),
    "by their number": (
        lambda z, K: np.sum(weights(z, K) * z) / len(z),
        "Divide by the sum of the weights, not by how many there are.",
    ),
    "five seconds added": (
        lambda z, K: np.sum(K * weights(z, K) * z) + 5,
        "What is missing depends on K, on the length and on z. Divide by the sum of the weights.",
    ),
}
