"""Lesson 14, `mended_prediction`: wrong answers, each with the sentence that it gets."""

import numpy as np


def grown(x, u):
    """Where the growth model moves x."""
    return x / 2 + 25 * x / (1 + x**2) + u


def growth_slope(x):
    """Its slope."""
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2


def moved(x, P, u, F):
    """The growth model's prediction with a slope."""
    return x / 2 + 25 * x / (1 + x**2) + u, F * P * F + 10


def slope(x):
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2


def growth(x):
    """The slope of the growth model, and where it moves a place without a push."""
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2, x / 2 + 25 * x / (1 + x**2)


def two_slopes(x, P, u):
    """The mean of the slopes at the old and at the new place."""
    new = growth(x)[1] + u
    F = (growth(x)[0] + growth(new)[0]) / 2
    return new, F * P * F + 10


WRONG = {
    "as published": (
        lambda x, P, u: (grown(x, u), growth_slope(grown(x, u)) ** 2 * P + 10),
        "That is the published prediction again: its slope is taken at the new x, where the belief is after the move. Take it at the old x.",
    ),
    "halfway": (
        lambda x, P, u: (grown(x, u), growth_slope((x + grown(x, u)) / 2) ** 2 * P + 10),
        "You took the slope halfway. The belief that is moved is at the old x, so take the slope there.",
    ),
    "at the input": (
        lambda x, P, u: (grown(x, u), growth_slope(x + u) ** 2 * P + 10),
        "The input is added after the curve: it shifts the mean and changes no slope.",
    ),
    "slope at u": (
        lambda x, P, u: (grown(x, u), growth_slope(u) ** 2 * P + 10),
        "You took the slope at u, the input. It is taken at x, where the belief was before the move.",
    ),
    "slope with 2.5": (
        lambda x, P, u: (grown(x, u), (0.5 + 2.5 * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10),
        "The mean is right. In the slope the coefficient is 25, as in the model, not 2.5.",
    ),
    "2.5 in both": (
        lambda x, P, u: (
            x / 2 + 2.5 * x / (1 + x**2) + u,
            (0.5 + 2.5 * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10,
        ),
        "The coefficient of the growth model is 25, in the curve and in its slope; you took 2.5.",
    ),
    "mean alone": (
        lambda x, P, u: grown(x, u),
        "The mean is right. Return its variance as well: F P F + 10.",
    ),
    "Q squared": (
        lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P + 100),
        "You squared Q. Q = 10 is the variance of the disturbance already.",
    ),
    "slope at the move without u": (
        lambda x, P, u: (grown(x, u), growth_slope(grown(x, 0)) ** 2 * P + 10),
        "You took the slope at the moved place, without u. The belief that is moved is at the old x: take the slope there, before the move.",
    ),
    "quotient not squared": (
        lambda x, P, u: (grown(x, u), (0.5 + 25 * (1 - x**2) / (1 + x**2)) ** 2 * P + 10),
        "In your slope the divisor is not squared. `move_slope(x)` of the notebook has it right.",
    ),
    "½ left out": (
        lambda x, P, u: (grown(x, u), (25 * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10),
        "In your slope the ½ of x/2 is missing. `move_slope(x)` of the notebook has it right.",
    ),
    "quotient rule left out": (
        lambda x, P, u: (grown(x, u), (0.5 + 25 / (1 + x**2)) ** 2 * P + 10),
        "In your slope only the numerator is differentiated: x stands in the divisor as well. `move_slope(x)` of the notebook has it right.",
    ),
    "variance alone": (
        lambda x, P, u: growth_slope(x) ** 2 * P + 10,
        "The variance is right. Return the mean as well, first: `return x, P`.",
    ),
    "P as it was": (
        lambda x, P, u: (grown(x, u), P),
        "The mean is right. P must be stretched by the curve, F on both sides, and grow by Q = 10.",
    ),
    "Q forgotten": (
        lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P),
        "The slope is right now. But P also grows by Q = 10, the variance of what disturbs a step.",
    ),
    "Q stretched too": (
        lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * (P + 10)),
        "The disturbance comes after the move, so it is not multiplied by the slope: F·P·F first, then + 10.",
    ),
    "F once": (
        lambda x, P, u: (grown(x, u), growth_slope(x) * P + 10),
        "P is a variance: stretching by F multiplies it by F twice. With F below zero yours may even be negative.",
    ),
    "deviation for variance": (
        lambda x, P, u: (grown(x, u), np.sqrt(growth_slope(x) ** 2 * P + 10)),
        "You took a root: P is a variance and stays one.",
    ),
    "tangent for the mean": (
        lambda x, P, u: (growth_slope(x) * x + u, growth_slope(x) ** 2 * P + 10),
        "P is right. But the mean travels along the curve itself, `move(x, u)`; the slope is for the width only.",
    ),
    "u forgotten": (
        lambda x, P, u: (grown(x, 0), growth_slope(x) ** 2 * P + 10),
        "P is right. The mean lacks the known input u.",
    ),
    "not moved": (
        lambda x, P, u: (x, growth_slope(x) ** 2 * P + 10),
        "P is right, but the mean has stayed where it was: it moves to `move(x, u)`.",
    ),
    "swapped": (
        lambda x, P, u: (growth_slope(x) ** 2 * P + 10, grown(x, u)),
        "Both are right, in the wrong order: first the mean, then its variance.",
    ),
    "root of Q": (
        lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P + np.sqrt(10)),
        "You added the root of 10. Q = 10 is the variance of the disturbance already.",
    ),
    "input taken off": (
        lambda x, P, u: (grown(x, u), growth_slope(x - u) ** 2 * P + 10),
        "You shifted the place of the slope by u. The belief that is moved is at the old x, whatever the input is.",
    ),
    "P squared": (
        lambda x, P, u: (grown(x, u), (growth_slope(x) * P) ** 2 + 10),
        "You squared P as well: only F stands twice, P once in the middle.",
    ),
    "not stretched": (
        lambda x, P, u: (grown(x, u), P + 10),
        "The mean is right. P must be stretched by the curve: F on both sides, then + 10.",
    ),
    "Q = 1": (
        lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P + 1),
        "The slope is right now. The reading's variance is 1, but the disturbance of the move has Q = 10.",
    ),
    "one slope at each place": (
        lambda x, P, u: (grown(x, u), growth_slope(x) * P * growth_slope(grown(x, u)) + 10),
        "One of the two slopes is still taken at the new x. Both belong to the old x.",
    ),
    "|F| once": (
        lambda x, P, u: (grown(x, u), abs(growth_slope(x)) * P + 10),
        "P is a variance: stretching by F multiplies it by F twice, which is never negative, without abs.",
    ),
    "push in the slope": (
        lambda x, P, u: moved(x, P, u, slope(x) + u),
        "The mean is right. u moves every x by the same amount, so it does not change the slope: leave it out of F.",
    ),
    "two slopes": (two_slopes, "Half of your slope still comes from the new place. Take the one at the old x alone."),
    "u for 25": (
        lambda x, P, u: (x / 2 + 25 * x / (1 + x**2) + u, (0.5 + u * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10),
        "The mean is right. In your slope u stands where 25 belongs: the second argument of `move_slope` is c, not u. "
        "Call `move_slope(x)`.",
    ),
}
