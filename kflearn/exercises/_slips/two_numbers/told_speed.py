"""Lesson 2, `told_speed`: wrong answers, each with the sentence that it gets."""

import math

WRONG = {
    "nothing learnt": (
        10.0,
        "10 m/s was expected before. The position and the velocity err together, so a cart that is further ahead is, on average, faster.",
    ),
    "deviation": (
        6 / 13 * 3,
        "That is how much faster these carts are than expected. The velocity itself was asked for: add the 10 m/s.",
    ),
    "minus": (
        10 - 6 / 13 * 3,
        "That is slower than the average cart. The corner is positive, so carts that are further ahead are faster: 10 m/s and the step, not 10 m/s less the step.",
    ),
    "corner": (
        10 + 6 * 3,
        "28 is 10 + 6 · 3. The corner must be divided by the variance of the position, 13 m².",
    ),
    "over the velocity's variance": (
        10 + 6 / 4 * 3,
        "14.5 is 10 + 6/4 · 3, with the variance of the velocity below the line. What was told is the position: divide by its variance, 13 m².",
    ),
    "the reciprocal": (
        10 + 13 / 6 * 3,
        "That is variance over corner. Corner over variance has the unit that turns metres into m/s.",
    ),
    "roots": (
        10 + 6 / math.sqrt(13) * 3,
        "14.99 is 10 + 6/√13 · 3, with σ of the position below the line. The step is corner over variance: 6 / 13.",
    ),
    "correlation": (
        10 + 6 / math.sqrt(52) * 3,
        "12.5 is 10 + 0.832 · 3. 0.832 is the correlation, 6/√(13 · 4), which has no unit. Corner over variance of the position has (m/s)/m.",
    ),
    "both σ": (
        10 + math.sqrt(4 / 13) * 3,
        "That would be so if the two were tied completely, one σ of the velocity for each σ of the position. Use the corner: 6 / 13.",
    ),
    "for one metre": (
        10 + 6 / 13,
        "10 + 6/13 is for a cart 1 m further ahead; this one is 3 m further. (10 · 63/60, in proportion, leaves the corner out.)",
    ),
    "ratio alone": (6 / 13, "That is how much faster for each metre. Go on: 3 m, and on top of 10 m/s."),
    "3 m in a second": (
        13.0,
        "13 is 10 + 3, metres added to metres per second; or it is the variance of the position. Take corner over variance, 6/13 (m/s)/m, for each of the 3 m, on top of 10 m/s.",
    ),
    "R = 1": (
        lambda: 10 + 6 / 14 * 3,
        "11.29 is 10 + 6/14 · 3, with 1 m² added to the variance of the position. This tape is perfect: the variance of its error is 0.",
    ),
    "0.9": (
        lambda: 10 + 0.9 * 3,
        "0.9 belongs to other numbers. Here the step for each metre is the corner of P over the variance of the position.",
    ),
    "variances": (
        lambda: 10 + 4 / 13 * 3,
        "10.92 is 10 + 4/13 · 3: that is the variance of the velocity over that of the position. On top belongs what the two share, the corner.",
    ),
    "the whole position": (
        10 + 6 / 13 * 63,
        "39.08 is 10 + 6/13 · 63, with the whole position. Only what was not expected tells something new: the 3 "
        "m beyond the 60 m.",
    ),
}
