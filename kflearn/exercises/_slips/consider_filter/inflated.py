"""Lesson 21, `inflated`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

from kflearn.exercises._shown import show

BY_MEMORY = "That is the lesson's other recipe, with the memory of the bias. Inflated by the *variance*, R is the sum of two variances."


def deviation_of(R):
    """What a number would mean that is in no row."""
    if R <= 0:
        return "A variance is larger than 0: the squares of 0.3 m and 0.5 m add."
    return f"That R belongs to an error of σ = {show(R**0.5, 3)} m. Noise (0.3 m) and bias (0.5 m) are independent: their squares add."


WRONG = {
    "standard deviations added": (
        0.8,
        "0.8 is the sum of the standard deviations; R is a variance, so square each first.",
    ),
    "sum squared": (
        0.64,
        "(0.3 + 0.5)² would be right if noise and bias always pushed the same way; they are independent.",
    ),
    "variance plus σ": (
        0.59,
        "0.59 is 0.09 + 0.5, with the bias by its standard deviation: metres to square metres. With σ = 1 m nobody notices.",
    ),
    "root": (math.sqrt(0.34), "That is the standard deviation of a reading. R is its square."),
    "bias alone": (0.25, "That is the bias alone; the white noise has not gone away."),
    "noise alone": (0.09, "That is R without any inflation: the bias is ignored."),
    "variance plus σ of the noise": (
        0.55,
        "0.55 is 0.3 + 0.25, with the noise by its standard deviation: metres to square metres. R is 0.3² + 0.5².",
    ),
    "the planned one": (
        27,
        "R = 27 is the number that the lesson found by trial. The filter inflated by the variance adds the two variances.",
    ),
    "fused": (
        0.09 * 0.25 / 0.34,
        "That is what fusing the two gives, as if each were a reading. Both errors are in the same reading: their variances add.",
    ),
    "difference": (
        0.16,
        "0.16 is 0.25 − 0.09. Variances of independent errors add, whatever the sign of the errors.",
    ),
    "mean of the two": (
        lambda: (0.3**2 + 0.5**2) / 2,
        "0.17 is the mean of the two variances. Both errors are in every reading: their variances add.",
    ),
    "mean of the σ": (
        0.4,
        "0.4 m is the mean of the two standard deviations. Square each first, then add.",
    ),
    "product": (
        0.15,
        "0.15 is the product of the two standard deviations. The two errors are independent: their variances add.",
    ),
    "the lesson's": (
        1.25,
        "That is the lesson's R, with a noise of 0.5 m and a bias of 1 m. Here the numbers are others.",
    ),
    "by the memory": (
        lambda: 0.09 + 0.25 * (1 + math.exp(-0.05)) / (1 - math.exp(-0.05)),
        BY_MEMORY,
    ),
    "the memory's": (
        40.26,
        "That is the lesson's R by the memory of the bias. Here the recipe is the variance, and the numbers are others.",
    ),
    "the lesson's R": (
        0.25 + 0.5**2,
        "0.5 is the σ of the bias, and also 0.25 + 0.25, with the lesson's noise. R is the sum of the variances: "
        "here the noise has σ = 0.3 m.",
    ),
    "fresh part of the bias": (
        lambda: 0.09 + 0.25 * (1 - np.exp(-0.1)),
        "0.114 is 0.09 + 0.25 · (1 − φ²), with what is new in the bias after one step. The whole bias is in each "
        "reading, so its whole variance counts.",
    ),
}
