"""Wrong answers to exercises of lesson 0, each with the sentence that it gets."""

import math

import numpy as np


def sigma_of(counts):
    """What σ so many readings bring."""
    words = "{} readings bring σ down to {:.3g} m. Solve 2/√n = 0.25 for n."
    more = {
        3: " Three halvings lead from 2 m to 0.25 m, and each takes four times as many readings. (3 is also √8, rounded up. The square of 8 is wanted, not its root.)",
        100: " Fewer are enough: 100 belongs to another σ.",
    }
    return {str(n): (n, words.format(f"{n:,}", 2 / math.sqrt(n)) + more.get(n, "")) for n in counts}


WRONG = {
    "readings_needed": {
        "σ/n": (8, "Eight readings give 2/√8 = 0.71 m: the standard deviation falls with √n, not with n."),
        "σ = 1 m": (
            16,
            "Sixteen readings give 2/√16 = 0.5 m. Two mistakes lead to 16: (1/0.25)² leaves out that each reading has σ = 2 m, "
            "and 2²/0.25 takes the 0.25 m for a variance.",
        ),
        "±2σ": (
            256,
            "256 readings bring 2σ down to 0.25 m, but σ itself was asked for. 256 is also (4/0.25)², with the variance, 2² = 4, where σ = 2 m belongs.",
        ),
        "root of eight": (
            lambda: math.sqrt(8),
            "2.83 is √8, a root where a square is needed: from √n = 8 follows n = 8², not n = √8.",
        ),
        "the variance": (
            lambda: 0.25**2,
            "0.0625 m² is the variance the mean must have. How many readings bring 4 m² down to it?",
        ),
        "σ for its square": (
            32,
            "32 is 2/0.25², or 2 · 4²: one of the two numbers is squared, the other is not. Divide variance by variance, or σ by σ and then square.",
        ),
        "squared twice": (
            4096,
            "4,096 readings give 2/√4096 = 0.03 m: more than was asked for. 4,096 is 8⁴, and 8² is enough.",
        ),
        "one too many": (65, "65 is more than needed: 0.25 m itself is allowed."),
        "one too few": (63, "With 63 readings σ is 0.252 m: just not there yet."),
        "what is wanted": (0.25, "0.25 m is the σ that is wanted. How many readings bring it about?"),
        "ratio upside down": (
            0.125,
            "0.125 is 0.25/2, the ratio the wrong way round. 2/0.25 = 8 says how many times smaller σ must become.",
        ),
        "1/0.25": (
            4,
            "Four readings only halve σ, from 2 m to 1 m. In 1/0.25 the 2 m are left out, and so is the square: σ must become eight times smaller.",
        ),
        "three halvings": (
            12,
            "Four readings halve σ, and it must be halved three times. The factors multiply, they do not add up to 12.",
        ),
        "eight halvings": (
            24,
            "24 readings give 2/√24 = 0.41 m. Eight times smaller is three halvings, and each of them takes four times as many readings.",
        ),
        **sigma_of((2, 3, 5, 10, 20, 25, 36, 40, 48, 49, 50, 60, 80, 81, 100, 128, 200, 400, 512, 640, 1000)),
        "one": (1, "One reading has σ = 2 m. The mean of n readings has 2/√n m."),
    },
    "update_mean": {
        "n + 1": (
            lambda mean, n, z: mean + (z - mean) / (n + 1),
            "You divided by n + 1, but n counts the new reading already: with the second reading the gain is 1/2.",
        ),
        "n − 1": (
            lambda mean, n, z: mean + (z - mean) / (n - 1),
            "You divided by the number of the old readings, n − 1. The new one counts too: with the second reading the gain is 1/2.",
        ),
        "halfway": (
            lambda mean, n, z: (mean + z) / 2,
            "You go halfway every time. The old mean stands for n − 1 readings, the new reading for one.",
        ),
        "wrong sign": (
            lambda mean, n, z: mean + (mean - z) / n,
            "Your mean walks away from the reading: add a part of measured minus expected, z - mean.",
        ),
        "weights swapped": (
            lambda mean, n, z: z + (mean - z) / n,
            "You gave the new reading the weight of all the old ones. Start at mean and walk the part 1/n towards z.",
        ),
        "surprise forgotten": (
            lambda mean, n, z: mean + z / n,
            "That is mean + z/n: the old mean counts n times, and it stands for n − 1 readings. Add a part of the surprise, z - mean.",
        ),
        "sum over n": (
            lambda mean, n, z: (mean + z) / n,
            "The old mean stands for n − 1 readings, so it counts n − 1 times: ((n − 1)·mean + z)/n. Or use the form with the gain.",
        ),
        "not divided": (
            lambda mean, n, z: (n - 1) * mean + z,
            "That is the sum of all n readings. Divide it by n.",
        ),
        "the new reading": (
            lambda mean, n, z: z,
            "You return the new reading and forget all the old ones: that is a gain of 1.",
        ),
        "the old mean": (
            lambda mean, n, z: mean,
            "You return the old mean, so nothing was learnt: that is a gain of 0.",
        ),
        "whole numbers": (
            lambda mean, n, z: mean + (z - mean) // n,
            "// rounds down to a whole number. Divide with a single /.",
        ),
        "only the step": (lambda mean, n, z: (z - mean) / n, "That is the step alone. Add it to the old mean."),
        "times n": (
            lambda mean, n, z: mean + n * (z - mean),
            "You multiplied the surprise by n. A single reading among many must move the mean less, not more.",
        ),
        "zn over all": (
            lambda mean, n, z: z / n,
            "That is the share of the new reading. The share of the old mean is missing.",
        ),
        "divided by n − 1": (
            lambda mean, n, z: ((n - 1) * mean + z) / (n - 1),
            "That is ((n − 1)·mean + z)/(n − 1). Above the line stands the sum of n readings, so divide by n.",
        ),
        "no brackets": (
            lambda mean, n, z: mean + z - mean / n,
            "Here z counts in full, and only a part of it should: in (z - mean) / n the whole surprise is divided.",
        ),
        "a fixed gain": (
            lambda mean, n, z: mean + 0.2 * (z - mean),
            "You took the same gain for every n. In a mean the gain falls with n: the more readings, the less each of them counts.",
        ),
        "median": (
            lambda mean, n, z: max(mean, z),
            "You return the larger of the two. The new mean lies between the old one and the new reading.",
        ),
    },
    "root_mean_square": {
        "as published": (
            lambda error: np.mean(abs(error)),
            "That is still the mean absolute error. The square must come before the mean, and the root after it.",
        ),
        "root forgotten": (
            lambda error: np.mean(error**2),
            "That is the mean square, in m². Take the root to come back to metres.",
        ),
        "standard deviation": (
            lambda error: np.std(error),
            "That is the standard deviation (`np.std`). It leaves out the mean error, so no offset shows: the torn tape would look as good as a whole one.",
        ),
        "variance": (
            lambda error: np.var(error),
            "That is the variance (`np.var`). It leaves out the mean error, so no offset shows; and it is in m².",
        ),
        "root of the sum": (
            lambda error: np.sqrt(np.sum(error**2)),
            "That is the root of the sum of the squares, which grows with every reading. Take their mean.",
        ),
        "root of the sum, divided": (
            lambda error: np.sqrt(np.sum(error**2)) / len(error),
            "You divided by the number of errors twice, or after the root. Divide once, before the root: that is the mean of the squares.",
        ),
        "n − 1": (
            lambda error: np.sqrt(np.sum(error**2) / (len(error) - 1)),
            "Dividing by n − 1 is for distances from a mean of the same readings. These are errors against the truth: divide by n.",
        ),
        "plain mean": (
            lambda error: np.mean(error),
            "In the plain mean errors of +5 and −5 m cancel. Square first, and nothing cancels.",
        ),
        "size of the mean": (
            lambda error: np.sqrt(np.mean(error) ** 2),
            "That is the size of the mean error, in which errors of +5 and −5 m cancel. Square each error first; then take the mean, and the root.",
        ),
        "largest": (
            lambda error: np.max(abs(error)),
            "That is the largest error: one bad reading decides everything.",
        ),
        "mean squared": (
            lambda error: np.mean(error) ** 2,
            "That is the square of the mean error, in which errors of +5 and −5 m cancel. Square each error, then take the mean, then the root.",
        ),
        "no square": (
            lambda error: np.sqrt(np.mean(abs(error))),
            "You took the root, but nothing was squared before: square each error first.",
        ),
        "variance for the mean square": (
            lambda error: np.sqrt(np.var(error, ddof=1) if len(error) > 1 else 0.0),
            "You took the scatter about the mean error. An error that all readings share does not show in it: do not subtract the mean.",
        ),
        "sum of squares": (
            lambda error: np.sum(error**2),
            "That is the sum of the squares: take their mean, and then the root.",
        ),
        "root of the mean": (
            lambda error: np.sqrt(abs(np.mean(error))),
            "You never squared: in the plain mean errors of +5 and −5 m cancel. Square each error first.",
        ),
        "median": (
            lambda error: np.median(abs(error)),
            "That is the median of the sizes. The name says: root, of the mean, of the squares.",
        ),
    },
}
