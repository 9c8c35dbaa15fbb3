"""Lesson 16, `start_sigma`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

from kflearn.exercises._shown import show


def nees_of(sigma):
    """What a number would mean that is in no row."""
    return f"With σ = {show(sigma)} m on each axis the NEES is {show(341600 / sigma**2, 3)}, where 3 is wanted. It goes with 1/σ²."


WRONG = {
    "NEES of one": (
        lambda: math.hypot(500, 300, 40),
        "With σ equal to the whole distance the NEES is 1. Three axes share the error, so 3 is expected.",
    ),
    "variance": (
        lambda: (500**2 + 300**2 + 40**2) / 3,
        "That is the variance, in m²; asked is its root.",
    ),
    "a third of the distance": (
        lambda: math.hypot(500, 300, 40) / 3,
        "That is the distance divided by 3. It is the *square* of the distance that three axes share: divide by √3.",
    ),
    "as published": (
        lambda: 100,
        "That is the published 100 m again, with a NEES of 34.",
    ),
    "100 times 34/3": (
        lambda: 100 * 34.16 / 3,
        "That is 100 m times 34/3. The NEES goes with 1/σ²: scale σ by the root of it.",
    ),
    "400, as in the lesson": (
        lambda: 400,
        "400 m is the lesson's round number, a little on the safe side: its NEES is 2.1.",
    ),
    "mean of the errors": (
        lambda: (500 + 300 + 40) / 3,
        "That is the mean of the three errors. The NEES adds their squares.",
    ),
    "three times the distance": (
        lambda: math.hypot(500, 300, 40) * math.sqrt(3),
        "That is the distance times √3, and with this σ the NEES is a third. Divide the distance by √3.",
    ),
    "root of the mean error": (
        lambda: 100 * math.sqrt(3 / 34),
        "That σ is smaller than the claimed one. The errors are larger than claimed, so σ must grow, by the root of 34/3.",
    ),
    "a third": (
        lambda: 34 / 3,
        "That is how many times too large the NEES is. σ grows by its root, beginning at 100 m.",
    ),
    "two axes": (
        lambda: math.sqrt((500**2 + 300**2) / 2),
        "That is √((500² + 300²)/2), from two axes. There are three.",
    ),
    "σ of the largest error": (
        500,
        "500 m is the largest error. All three axes count: the mean of their squares, and its root.",
    ),
    "half of the sum of squares": (
        lambda: math.hypot(500, 300, 40) / 2,
        "That is half of the distance. Three axes share the squared distance.",
    ),
    "root of the sum": (
        lambda: math.sqrt(840 / 3),
        "That is the root of the mean of 500, 300 and 40. The NEES adds their *squares*: 500², 300² and 40².",
    ),
    "root of the sum, not divided": (
        lambda: math.sqrt(840),
        "That is the root of 500 + 300 + 40. The NEES adds their *squares*; then three axes share the sum.",
    ),
    "by √3": (
        lambda: 100 * math.sqrt(3),
        "That is 100 m times √3. The NEES is 34 and should be 3, so it must shrink by 34/3, and it goes with 1/σ².",
    ),
    "three times": (
        300,
        "300 m is three times the claim, and also the second error. With this σ the NEES is 3.8: it goes with 1/σ².",
    ),
    "100 times 34": (
        lambda: 3400,
        "That is 100 m times the NEES. It should be 3, not 1, and it goes with 1/σ²: scale σ by the root of 34/3.",
    ),
    "the sum of the errors": (840, "840 is the sum of the three errors. The NEES adds their squares."),
    "the sum of the squares": (
        lambda: 500**2 + 300**2 + 40**2,
        "That is the squared length of the error. Divided by σ² it must give 3: solve for σ.",
    ),
    "largest axis, shared": (
        lambda: 500 / math.sqrt(3),
        "That is 500 m divided by √3, the largest error alone. Put the squares of all three together first.",
    ),
    "100 times 34/3, rounded": (
        lambda: 100 * 34 / 3,
        "That is 100 m times 34/3. The NEES goes with 1/σ²: scale σ by the root of it.",
    ),
    "root of 34": (
        100 * np.sqrt(34),
        "With that σ the NEES is 1, and 3 is wanted: scale 100 m by √(34/3).",
    ),
    "about the mean": (
        lambda: np.std([-500, -300, -40]),
        "188 m is the scatter of the three errors about their mean, as `np.std` gives it. The errors count from zero: the root of the mean of their squares.",
    ),
    "the factor": (
        np.sqrt(34.16 / 3),
        "3.37 is √(34.16/3), the factor by which σ must be larger. What is asked is σ itself, 100 m times that.",
    ),
    "34.16 upside down": (
        100 * np.sqrt(3 / 34.16),
        "29.6 m is 100 m times √(3/34). A smaller σ makes the NEES larger: times √(34/3).",
    ),
    "added before squaring": (
        np.sqrt(840**2 / 3),
        "485 m is √(840²/3), with the sum of the three errors squared. The NEES adds the squares of the single errors.",
    ),
}
