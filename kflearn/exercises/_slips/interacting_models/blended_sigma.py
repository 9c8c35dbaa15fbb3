"""Lesson 18, `blended_sigma`: wrong answers, each with the sentence that it gets."""

import math

from kflearn.exercises._shown import show


def spread_of(sigma):
    """What a number would mean that is in no row."""
    if sigma <= 30:
        return "The blend is wider than each of the two, 30 m: their means are apart as well."
    return (
        f"Its square is 900 m² and {show(sigma**2 - 900)} m² more. What is added to 900 m² is the squared distance of each mean "
        "from the middle."
    )


WRONG = {
    "spread forgotten": (
        30.0,
        "30 m is the σ of each Gaussian. The means are apart as well: add the squared distance of each mean from the middle, then take the root.",
    ),
    "spread alone": (
        40.0,
        "40 m is the distance of each mean from the middle. Each Gaussian has a width of its own as well: add its variance, then take the root.",
    ),
    "fused": (
        30 / math.sqrt(2),
        "21.2 m is what fusing them gives, as if both were right. Only one of them is, and nobody knows which: a blend is wider.",
    ),
    "variance": (2500.0, "That is the variance, in m²; σ is its root."),
    "distance between the two": (
        math.hypot(30, 80),
        "That is √(30² + 80²), with the distance between the two means, 80 m. It is the distance to the blend's mean that counts, 40 m.",
    ),
    "distance, not squared": (
        80.0,
        "80 m is the distance between the two means. Add the variance of a Gaussian and the squared distance of its mean from the middle.",
    ),
    "σ and distance added": (
        70.0,
        "70 m is 30 m + 40 m, σ and the distance from the middle. Add their squares, and take the root.",
    ),
    "both σ": (
        60.0,
        "60 m is the sum of the two σ. Add squares instead: the variance of a Gaussian, and the squared distance of its mean from the middle.",
    ),
    "variance of one": (
        900.0,
        "900 m² is the variance of one Gaussian. What is missing is the squared distance to the blend's mean, and then the root.",
    ),
    "variances added": (
        math.sqrt(1800),
        "That is √(30² + 30²), as for a sum of two errors. The blend takes the mean of the two variances, and adds the squared distance of each mean from the middle.",
    ),
    "spread not halved": (
        math.sqrt(900 + 3200),
        "That is √(900 + 3200). 900 m² is the variance of each, but 3200 m² is the sum of the two squared distances from the middle: take their mean.",
    ),
    "distance not squared": (
        math.sqrt(940),
        "That is √(900 + 40). The distance from the middle must be squared as well.",
    ),
    "nothing squared": (
        math.sqrt(70),
        "That is √(30 + 40). Square both first.",
    ),
    "all of it halved": (
        math.sqrt(1250),
        "That is √(2500/2), half once too often: the mean of the two variances is 900 m², the mean of the two squared distances 1600 m².",
    ),
    "weights squared": (
        math.sqrt(900 + 400),
        "That is √(900 + 400). 900 m² is the variance of each, but 400 m² belongs to a distance of 20 m: each mean is 40 m from the middle.",
    ),
    "half of it": (
        15.0,
        "15 m is half of a σ. Take the mean of the two variances, add the squared distance of each mean from the middle, then take the root.",
    ),
    "spread for one only": (
        math.sqrt(30**2 + 40**2 / 2),
        "That is √(900 + 800), with the spread of one of the two Gaussians only, or half of it: each of the two means is 40 m from the middle.",
    ),
    "everything added": (
        110.0,
        "110 m is 30 m + 80 m, σ and the distance of the means. Variances and squared distances add; the root comes last.",
    ),
    "both variances": (
        math.sqrt(2 * 30**2 + 40**2),
        "That is √(900 + 900 + 1600), with both variances in full. The blend takes their weighted mean, half of each.",
    ),
    "both variances, both spreads": (
        math.sqrt(2 * 30**2 + 2 * 40**2),
        "That is √(2 · 900 + 2 · 1600), everything for both models. Each counts with its weight, one half.",
    ),
    "half the variance": (
        math.sqrt(30**2 / 2 + 40**2),
        "That is √(450 + 1600), with half of the variance. The mean of two equal variances, half of each, is one of them: 900 m².",
    ),
    "100": (100, "Wider than each, but not so wide: √(30² + the squared distance of each mean from the middle)."),
}
