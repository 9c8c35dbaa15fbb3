"""Lesson 0, `update_mean`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
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
    "√n": (
        lambda mean, n, z: mean + (z - mean) / np.sqrt(n),
        "You divided by √n. That belongs to the σ of a mean; the weight of one reading among n is 1/n.",
    ),
    "size of the surprise": (
        lambda mean, n, z: mean + abs(z - mean) / n,
        "Your mean never falls: the surprise has a sign, and a reading below the mean has to lower it.",
    ),
    "n²": (
        lambda mean, n, z: mean + (z - mean) / n**2,
        "You divided by n twice. The weight of one reading among n is 1/n.",
    ),
    "z alone divided": (
        lambda mean, n, z: (n - 1) * mean + z / n,
        "Only z is divided by n. Put brackets around the whole sum: ((n − 1)·mean + z)/n.",
    ),
}
