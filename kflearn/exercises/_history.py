"""Wrong answers to exercises of lesson 28, each with the sentence that it gets."""

import itertools

import numpy as np

DISTURBED = {
    "B": "B was told a large Q: the newest night has nearly all the weight, because the clock may wander far in a night.",
    "C": "C was told a small Q, but not 0: its weights become a little smaller with every night, as the clock may have wandered since.",
}
CALM = {
    "A": "One of the others belongs to it as well: in which row do the weights fall by equal steps, as on a ruler?",
    "D": "One of the others belongs to it as well: in which row does the age of a reading make no difference at all?",
}


def wrong_letters():
    """Every choice of up to three letters but the right one, with what to say: first what is too much, then what is missing."""
    for letters in (set(c) for size in (1, 2, 3, 4) for c in itertools.combinations("ABCD", size)):
        too_many = [text for letter, text in DISTURBED.items() if letter in letters]
        missing = [text for letter, text in CALM.items() if letter not in letters]
        if too_many:
            yield letters, " ".join(too_many)
        elif missing:
            yield letters, f"{min(letters)} is right. {missing[0]}"


def with_last(w, last):
    """The weights w with another one for the oldest reading."""
    return np.append(np.asarray(w)[:-1], last)


def powers(z, K):
    """The weights K(1 − K)ʲ in the order of the readings, oldest first."""
    return K * (1 - K) ** np.arange(len(z))[::-1]


def from_the_first(z, K):
    """Exponential smoothing that starts at the first reading."""
    x = z[0]
    for reading in z[1:]:
        x = x + K * (reading - x)
    return x


WRONG = {
    "exponential_weights": {
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
    },
    "mended": {
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
            lambda z, K: (
                np.sum((1 - K) ** (np.arange(len(z)) + 1) * z) / np.sum(K * (1 - K) ** (np.arange(len(z)) + 1))
            ),
            "The powers run the wrong way: the last reading is the newest, so its power is 0. And divide by the sum of the very weights that you used.",
        ),
        "the first reading": (lambda z, K: z[0], "You return the first reading. All readings have a weight."),
        "the newest reading": (lambda z, K: z[-1], "You return the newest reading. The older ones have a weight too."),
        "K and 1 − K swapped": (
            lambda z, K: np.sum(K ** np.arange(len(z))[::-1] * z) / np.sum(K ** np.arange(len(z))),
            "K and 1 − K are swapped: the weight falls by the factor 1 − K from a reading to the one before.",
        ),
    },
}
