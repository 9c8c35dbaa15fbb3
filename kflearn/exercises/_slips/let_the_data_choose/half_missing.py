"""Lesson 24, `half_missing`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show


def slope_at(R):
    """What a number would mean that is in no row."""
    if R <= 0:
        return "R is a variance, and larger than 0."
    slope = 1 / R - 2 / R**2
    way = "smaller" if slope > 0 else "larger"
    return f"At R = {show(R)} the sum ½·4/R + log R has the slope {show(slope, 2)}: it is still lower for a {way} R."


WRONG = {
    "right library": (
        4.0,
        "That is where a right likelihood comes to. Without the ½ the two parts are no longer in balance.",
    ),
    "other way": (
        8.0,
        "8 is twice 4, and half of 4². It goes the other way: the logarithm, which punishes a large R, has become heavier. And 4 is "
        "the mean of y² already: nothing is squared.",
    ),
    "root": (np.sqrt(2), "That is the σ that belongs to it. R was asked for."),
    "root of eight": (
        np.sqrt(8),
        "That is 4/√2, as a factor of a half would change a σ. Set the derivative −½·4/R² + 1/R to zero.",
    ),
    "root of two up": (
        4 * np.sqrt(2),
        "That is 4·√2. The logarithm, which punishes a large R, has become heavier, so R becomes smaller; and R is a "
        "variance: nothing is rooted. Set the derivative −½·4/R² + 1/R to zero.",
    ),
    "eight squared": (
        64.0,
        "That is 8². R is a variance already, so nothing is squared. And the logarithm, which punishes a large R, has "
        "become heavier: R becomes smaller.",
    ),
    "a quarter": (1.0, "The logarithm is twice as heavy, not four times: ½·4/R² = 1/R."),
    "sixteen": (
        16.0,
        "R is a variance already; nothing is squared. And the logarithm, which punishes a large R, has become heavier.",
    ),
    "factor alone": (0.5, "That is the factor. Multiply the true R by it."),
    "zero": (0.0, "Near R = 0 the part ½·4/R becomes huge. There is a place between."),
    "2π": (
        2 / (2 * np.pi),
        "The 2π inside the logarithm is a constant and does not move the place of the minimum.",
    ),
    "infinity": (
        np.inf,
        "A huge R costs too: log 2πR grows without end. Set the derivative −½·4/R² + 1/R to zero.",
    ),
    "the Nile": (15099, "That is the R of the Nile. Here the true R is 4."),
    "less a half": (
        3.5,
        "3.5 is 4 − ½. The ½ is a factor of one of the two parts; nothing is taken off R. Where is the slope of "
        "½·4/R + log R zero?",
    ),
}
