"""Lesson 3, `speedometer`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
    "the prediction": (
        60,
        "A reading of the velocity does change the position, because the corner of P⁻ is not 0.",
    ),
    "velocity": (12.4, "That is the new velocity, 10 + 4/5 · 3 m/s. The position is wanted."),
    "K₂ for K₁": (
        62.4,
        "62.4 is 60 + 4/5 · 3, and 4/5 is K₂, the gain of the velocity. For the position it is K₁, made from the corner.",
    ),
    "R forgotten": (
        64.5,
        "64.5 is 60 + 6/4 · 3. The variance of the innovation is H P⁻Hᵀ + R = 4 + 1, not 4 alone.",
    ),
    "variance for the corner": (
        72,
        "72 is 60 + 20/5 · 3, with the variance of the position on top. P⁻Hᵀ is the second column of P⁻: for the position it has the corner, 6.",
    ),
    "H = [1, 0]": (
        lambda: 60 + 20 / 21 * (13 - 60),
        "15.24 comes from H = [1, 0], as if the speedometer read a position. It reads the second number of the state: H = [0, 1].",
    ),
    "H = [1, 0], right innovation": (
        lambda: 60 + 20 / 21 * 3,
        "62.86 is 60 + 20/21 · 3, and 20/21 is the gain for H = [1, 0], that of the tape. The speedometer reads the second number of the state: H = [0, 1].",
    ),
    "moved on": (
        73,
        "73 is 60 + 13, one more second at the speed that is read. x̂⁻ is predicted already, so only the correction is wanted.",
    ),
    "the speed added": (
        63,
        "63 is 60 + 3, the innovation of 3 m/s added to the position. Multiply it by K₁ first.",
    ),
    "the step": (
        3.6,
        "3.6 is the correction K₁ · 3 m/s alone, which is added to the predicted 60 m. It is also 60 + K₁ · (13 − 60), but a speed is compared with the predicted speed.",
    ),
    "wrong sign": (
        56.4,
        "56.4 is 60 − 3.6: the step has the right size and goes the wrong way. The speedometer reads more than predicted, and the corner is positive: the cart is further ahead.",
    ),
    "K": (1.2, "That is the gain K₁. Go on: 60 m plus K₁ times the innovation."),
    "corner over the position's variance": (
        lambda: 60 + 6 / 21 * 3,
        "60.86 is 60 + 6/21 · 3, with the variance of the position below the line. Here the velocity is read: divide by the variance of the innovation, 4 + 1.",
    ),
    "both numbers": (lambda: (63.6, 12.4), "Both numbers are right. Give the position alone."),
    "gain added": (
        61.2,
        "61.2 is 60 + K₁. K₁ is a gain, in m for each m/s: multiply it by the innovation first.",
    ),
    "whole reading": (
        lambda: 60 + 1.2 * 13,
        "75.6 is 60 + K₁ · 13, with the whole reading. What counts is the innovation: the reading less what was expected of it.",
    ),
    "6/10": (
        lambda: 60 + 0.6 * 3,
        "61.8 is 60 + 0.6 · 3, and 0.6 is not K₁. K₁ is the corner over the variance of the innovation, and that is made from the velocity's variance and R.",
    ),
    "moved on, new speed": (
        lambda: 60 + 12.4,
        "72.4 is 60 + 12.4, one more second at the new speed. x̂⁻ is predicted already: only the correction is wanted.",
    ),
    "the lesson's estimate": (
        61.6667,
        "61.67 m is the lesson's estimate, with the tape. Here a speedometer reads, and P⁻ is another.",
    ),
    "moved on, and corrected": (
        73.6,
        "73.6 is 10 m too far. 60 m is the prediction already: the cart is not moved on by 10 m/s once more.",
    ),
    "moved on, not corrected": (
        70,
        "70 is 60 + 10, one more second at the speed of before. x̂⁻ is predicted already: only the correction is wanted.",
    ),
    "correlation": (
        lambda: 60 + 3 * 6 / np.sqrt(20 * 4),
        "62.01 is 60 + 0.671 · 3, and 0.671 is the correlation, 6/√(20 · 4), which has no unit. K₁ turns m/s into "
        "metres: the corner over the variance of the innovation.",
    ),
}
