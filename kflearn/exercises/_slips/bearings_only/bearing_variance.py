"""Lesson 15, `bearing_variance`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

WRONG = {
    "as published": (
        lambda sd: math.radians(sd),
        "That is the standard deviation in radians. Handed over as a variance, 0.1° becomes √(0.1·π/180) rad = 2.394°.",
    ),
    "degrees squared": (
        lambda sd: sd**2,
        "That is the variance in degrees squared; the filter's innovations are radians.",
    ),
    "squared before": (
        lambda sd: math.radians(sd**2),
        "That is sd² · π/180. The factor π/180 must be squared too.",
    ),
    "degrees": (lambda sd: sd, "That is σ, in degrees: neither a variance nor radians."),
    "backwards": (
        lambda sd: math.degrees(sd) ** 2,
        "That is (sd · 180/π)². From degrees to radians it is the other way, sd · π/180; `np.degrees` turns radians into degrees.",
    ),
    "root": (
        lambda sd: math.sqrt(math.radians(sd)),
        "That is the root of σ in radians; from σ to the variance one squares.",
    ),
    "180 not squared": (
        lambda sd: (sd * math.pi) ** 2 / 180,
        "Square the whole of sd·π/180, the 180 as well.",
    ),
    "sd not squared": (
        lambda sd: sd * math.radians(1) ** 2,
        "The factor (π/180)² is right. `sd` is squared as well: (sd · π/180)².",
    ),
    "180 squared, π not": (
        lambda sd: sd**2 * math.pi / 180**2,
        "That is sd² · π/180², with π not squared: `**` is worked out before `*` and `/`. Square the whole of sd·π/180.",
    ),
    "half": (
        lambda sd: math.radians(sd) ** 2 / 2,
        "That is half of the right number. R is the square of the standard deviation, in rad².",
    ),
    "of one turn": (
        lambda sd: (sd * 2 * math.pi) ** 2,
        "That is (sd · 2π)². A whole turn, 2π, is 360°: one degree is 2π/360.",
    ),
    "even spread": (
        lambda sd: math.radians(sd) ** 2 / 12,
        "The 12 belongs to errors that are spread evenly over a known width. Here `sd` is the standard deviation itself: square it.",
    ),
    "a whole turn": (
        lambda sd: (sd * math.pi / 360) ** 2,
        "That is a quarter of the right number. π radians are 180°, not 360°, and `sd` is one σ, not two.",
    ),
    "twice σ": (
        lambda sd: 2 * math.radians(sd),
        "That is twice the standard deviation in radians. The variance is its square.",
    ),
    "converted twice": (
        lambda sd: math.radians(math.radians(sd) ** 2),
        "That is (sd · π/180)² · π/180: once σ is in radians, its square is in rad² already.",
    ),
    "the notebook's number": (
        lambda sd: math.radians(0.1) ** 2,
        "That is R for 0.1°. Write it for any σ: use `sd`.",
    ),
    "2σ": (
        lambda sd: (2 * math.radians(sd)) ** 2,
        "That is four times the right number, (2 sd · π/180)². `sd` is one standard deviation, and 180° are π radians, not 2π.",
    ),
    "180 squared": (
        lambda sd: sd * np.pi / 180**2,
        "The square reaches only the 180. Put brackets round the whole: `(sd * np.pi / 180) ** 2`.",
    ),
    "in full turns": (
        lambda sd: (sd / 360) ** 2,
        "That is the variance in full turns, squared: (sd / 360)². The filter counts in radians, and a full turn "
        "has 2π of them.",
    ),
    "of 39 readings": (
        lambda sd: np.radians(sd) ** 2 / 39,
        "That is the right number divided by 39. R says how far *one* reading scatters, however many there are.",
    ),
    "the published R as a factor": (
        lambda sd: 0.1 * np.pi / 180 * sd**2,
        "That is 0.1 · π/180 times sd². The 0.1 is one sensor's σ, and `sd` stands in its place. "
        "Square the whole: the factor π/180 too.",
    ),
}
