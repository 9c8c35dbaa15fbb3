"""Lesson 6, `three_sigma`: wrong answers, each with the sentence that it gets."""

import numpy as np

HARD = (
    "Half the range (or the largest error), squared, over 3 is the variance of errors that lie evenly between hard limits. Noise has "
    "no such limits, and its range grows with the number of readings. R is the variance of the readings."
)


WRONG = {
    "as published": (
        lambda at_rest: (3 * np.std(at_rest)) ** 2,
        "That is the published R again, nine times too large: a bound for the worst reading is no variance.",
    ),
    "3σ²": (
        lambda at_rest: 3 * np.var(at_rest),
        "Still three times too large. R is σ² itself; no 3 belongs in it.",
    ),
    "σ": (lambda at_rest: np.std(at_rest), "That is σ. R is a variance, σ²."),
    "3σ": (lambda at_rest: 3 * np.std(at_rest), "That is 3σ, a length on the volt axis. R is σ², in V²."),
    "(σ/3)²": (
        lambda at_rest: np.var(at_rest) / 9,
        "Now R is nine times too small. σ was measured here, not read off a sheet with 3σ on it: no 3 is needed.",
    ),
    "mean square": (
        lambda at_rest: np.mean(np.square(at_rest)),
        "You took the mean of the squares, with the 12 V or so still in it. Take off the mean first, as np.var does.",
    ),
    "differences": (
        lambda at_rest: np.mean(np.diff(at_rest) ** 2) / 2,
        "Sound, and what the next exercise wants; but this source rests, and the plain variance uses the readings better.",
    ),
    "differences, not halved": (
        lambda at_rest: np.mean(np.diff(at_rest) ** 2),
        "A difference holds two noises, so this is twice too large; and at rest the plain variance is enough.",
    ),
    "(2σ)²": (
        lambda at_rest: (2 * np.std(at_rest)) ** 2,
        "That is (2σ)². No factor belongs in R: it is σ² itself.",
    ),
    "the sum": (
        lambda at_rest: np.sum((at_rest - np.mean(at_rest)) ** 2),
        "That is the sum of the squared distances. Divide it by their number.",
    ),
    "the range": (
        lambda at_rest: (np.ptp(at_rest) / 6) ** 2,
        "You took the range for six sigmas. How far apart the two extremes lie depends on how many readings there are: use all of them.",
    ),
    "half": (
        lambda at_rest: np.mean(abs(at_rest - np.mean(at_rest))) ** 2,
        "You squared the mean distance. Square each distance first, then take the mean.",
    ),
    "mean": (
        lambda at_rest: np.mean(at_rest),
        "That is the voltage of the source. R is about the scatter of the readings.",
    ),
    "mean distance": (
        lambda at_rest: np.mean(abs(at_rest - np.mean(at_rest))),
        "That is the mean distance from the mean, in volts. R is a variance: square the distances before you take their mean.",
    ),
    "a third": (
        lambda at_rest: np.var(at_rest) / 3,
        "You divided by 3. σ was measured here, not read off a sheet: R is σ² itself.",
    ),
    "of the mean": (
        lambda at_rest: np.var(at_rest) / len(at_rest),
        "That is the variance of the *mean* of all readings. R is the variance of a single one.",
    ),
    "six sigmas": (
        lambda at_rest: (6 * np.std(at_rest)) ** 2,
        "You took the whole width, 6σ. No factor belongs in R: it is σ² itself.",
    ),
    "square of three variances": (
        lambda at_rest: (3 * np.var(at_rest)) ** 2,
        "You squared a variance. R is σ² itself, in V².",
    ),
    "a number": (
        lambda at_rest: 1.0,
        "You return 1 whatever the readings are. That is right for the source of the example only.",
    ),
    "12 V": (
        lambda at_rest: np.mean((at_rest - 12) ** 2),
        "You took 12 V away. Each of these sources rests at a voltage of its own: take away the mean of the readings.",
    ),
    "σ/3": (
        lambda at_rest: np.std(at_rest) / 3,
        "Two things: R is σ², in V², not σ; and σ was measured here, so no 3 is needed.",
    ),
    "median": (
        lambda at_rest: np.median(abs(at_rest - np.median(at_rest))) ** 2,
        "That is the square of the median distance, which is smaller than σ: half of the readings lie nearer than 0.67 σ.",
    ),
    "neighbours, σ": (
        lambda at_rest: np.std(np.diff(at_rest)),
        "That is the σ of a difference of two readings. R is the variance of one.",
    ),
    "hard limits": (lambda at_rest: (np.ptp(at_rest) / 2) ** 2 / 3, HARD),
    "hard limits about the mean": (lambda at_rest: np.max(abs(at_rest - np.mean(at_rest))) ** 2 / 3, HARD),
    "half the range": (
        lambda z: ((np.max(z) - np.min(z)) / 2) ** 2,
        "You square half the range, which grows with the number of readings. R is the variance of the readings.",
    ),
}
