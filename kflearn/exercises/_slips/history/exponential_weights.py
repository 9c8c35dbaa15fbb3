"""Lesson 28, `exponential_weights`: wrong answers, each with the sentence that it gets."""

import numpy as np


def with_last(w, last):
    """The weights w with another one for the oldest reading."""
    return np.append(np.asarray(w)[:-1], last)


def smoothed(K, n):
    """The right weights of exponential smoothing, newest first."""
    return np.append(K * (1 - K) ** np.arange(n - 1), (1 - K) ** (n - 1))


def from_one(K, n):
    w = K * (1 - K) ** np.arange(1, n + 1)
    w[-1] = 1 - w[:-1].sum()
    return w


def powers_from_one(K, n):
    return np.append(K * (1 - K) ** np.arange(1, n), (1 - K) ** n)


WRONG = {
    "infinite past": (
        lambda K, n: K * (1 - K) ** np.arange(n),
        "These are Wiener's, for an infinite past: their sum is not 1. The estimate starts at the oldest reading, so its weight has no factor K: it is (1 − K)ⁿ⁻¹.",
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
    "the other end": (
        lambda K, n: np.append((1 - K) ** (n - 1), (K * (1 - K) ** np.arange(n))[1:]),
        "You gave the weight without K to the newest reading. It belongs to the oldest, where the estimate starts.",
    ),
    "infinite past, oldest first": (
        lambda K, n: (K * (1 - K) ** np.arange(n))[::-1],
        "Two things: newest first was asked for, and the weights do not sum to 1, as the oldest reading has no K in front.",
    ),
    "their sum": (
        lambda K, n: 1.0,
        "That is the sum of the weights. Return the n weights themselves, as an array.",
    ),
    "too few": (
        lambda K, n: K * (1 - K) ** np.arange(n - 1),
        "One weight is missing: the oldest reading, at which the estimate starts, has one too.",
    ),
    "too many": (
        lambda K, n: np.append(K * (1 - K) ** np.arange(n), (1 - K) ** n),
        "That is one weight too many: there are n readings, the oldest included.",
    ),
    "1 − K last": (
        lambda K, n: with_last(K * (1 - K) ** np.arange(n), 1 - K),
        "For n = 2 it is right. For more readings the oldest has been multiplied by 1 − K once for each reading after it.",
    ),
    "powers of K": (
        lambda K, n: K ** np.arange(n),
        "Those are powers of K. Each new reading leaves the part 1 − K of what was there.",
    ),
    "K for all": (
        lambda K, n: with_last(np.full(n, K), 1 - K),
        "An older reading counts less than a newer one: its weight is multiplied by 1 − K for each reading after it.",
    ),
    "K last": (
        lambda K, n: with_last(K * (1 - K) ** np.arange(n), K),
        "The oldest reading is where the estimate starts; it was multiplied by 1 − K for each reading after it.",
    ),
    "K in the oldest": (
        lambda K, n: np.append(K * (1 - K) ** np.arange(n - 1), K * (1 - K) ** (n - 2.0)),
        "The oldest weight is not right: it is (1 − K)ⁿ⁻¹, without K in front. Check that the sum is 1.",
    ),
    "powers from 1": (
        lambda K, n: np.append(K * (1 - K) ** np.arange(1, n), (1 - K) ** (n - 1)),
        "The oldest weight is right. The others begin with K itself for the newest reading: the power of 1 − K starts at 0.",
    ),
    "K and 1 − K exchanged": (
        lambda K, n: (1 - K) * K ** np.arange(n),
        "K and 1 − K are exchanged: K is the weight of the newest reading. And the weights do not sum to 1, because the oldest lacks its part.",
    ),
    "all K": (
        lambda K, n: np.append(np.full(n - 1, K), (1 - K) ** (n - 1)),
        "The oldest weight is right. The others must become smaller: each reading that follows multiplies them by 1 − K.",
    ),
    "oldest 1": (
        lambda K, n: np.append(K * (1 - K) ** np.arange(n - 1), 1),
        "The oldest reading does start with the weight 1. But each reading after it multiplies that by 1 − K.",
    ),
    "rest to the newest": (
        lambda K, n: K * (1 - K) ** np.arange(n) + np.eye(n)[0] * (1 - K) ** n,
        "The sum is 1, but the missing part went to the newest reading. It belongs to the oldest, where the estimate starts.",
    ),
    "rest to all": (
        lambda K, n: K * (1 - K) ** np.arange(n) + (1 - K) ** n / n,
        "The sum is 1, but the missing part was spread over all. It belongs to the oldest reading, where the estimate starts.",
    ),
    "added up": (
        lambda K, n: np.cumsum(smoothed(K, n)),
        "Those are running sums of the weights. Return the weights themselves.",
    ),
    "from 1": (from_one, "The newest reading has K itself: the exponents begin at 0, not at 1."),
    "powers from one": (
        powers_from_one,
        "Each of your weights has one factor 1 − K too many, so their sum is 1 − K: the powers begin at 1. The newest reading has the power 0, "
        "which leaves K.",
    ),
    "two numbers at least": (
        lambda K, n: np.array([*(K * (1 - K) ** np.arange(max(n - 1, 1))), (1 - K) ** max(n - 1, 1)]),
        "Right for two readings and more. For n = 1 you return two weights: a single reading has the whole weight, [1].",
    ),
    "K in any case": (
        lambda K, n: np.array([K, 1.0]) if n == 1 else with_last(K * (1 - K) ** np.arange(n), (1 - K) ** (n - 1)),
        "Right for two readings and more. For n = 1 you return two weights: a single reading has the whole weight, [1].",
    ),
}
