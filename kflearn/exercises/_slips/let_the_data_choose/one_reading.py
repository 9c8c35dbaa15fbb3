"""Lesson 24, `one_reading`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show

LOG = np.log(2 * np.pi * 5)


def density_of(log_likelihood):
    """What a number would mean."""
    top = -np.log(2 * np.pi * 5) / 2
    if log_likelihood > top:
        return f"{show(log_likelihood)} is more than the bell of variance 5 V² has in its middle, {show(top, 3)}. The reading is 3 V off: −½(log 2πS + y²/S)."
    return (
        f"In its middle the bell of variance 5 V² has {show(top, 3)}, and your number is lower by {show(top - log_likelihood, 3)}. For "
        "a reading that is off by y it is lower by ½·y²/S."
    )


def near_the_density(answer):
    """What is said of a rounded density."""
    if 0.07 < answer < 0.075:
        return (
            "That is about the probability density itself, 0.0725. Its logarithm was asked for, which is negative here."
        )
    return density_of(answer)


WRONG = {
    "the ½ forgotten": (-(LOG + 1.8), "That is twice the right number: the ½ before the bracket is missing."),
    "plus": (
        0.5 * (LOG + 1.8),
        "The sign: both parts of the bracket are positive here, and minus a half of it is asked for.",
    ),
    "the ½ before the logarithm only": (-(0.5 * LOG + 1.8), "The ½ belongs to both parts, also to y²/S."),
    "the ½ before the NIS only": (-(LOG + 0.9), "The ½ belongs to both parts, also to log 2πS."),
    "minus between": (-0.5 * (LOG - 1.8), "Inside the bracket the two parts are added."),
    "σ for S in the logarithm": (
        -0.5 * (np.log(2 * np.pi * 5**0.5) + 1.8),
        "In the logarithm stands S, 5 V², and not √S.",
    ),
    "divided by σ": (-0.5 * (LOG + 9 / 5**0.5), "The squared innovation is divided by S, 5 V², and not by √S."),
    "y not squared": (-0.5 * (LOG + 0.6), "The innovation is squared: 3²/5."),
    "y over σ": (-0.5 * (LOG + 3 / 5**0.5), "The quotient y/√S is to be squared: 3²/5."),
    "√S for S in both": (
        -0.5 * (np.log(2 * np.pi * 5**0.5) + 9 / 5**0.5),
        "That is right for S = √5, in both places. S is a variance, 5 V².",
    ),
    "S squared in both": (
        -0.5 * (np.log(2 * np.pi * 25) + 9 / 25),
        "That is right for S = 25. S is 5 V², a variance already.",
    ),
    "2π forgotten": (-0.5 * (np.log(5) + 1.8), "2π is missing in the logarithm."),
    "π for 2π": (-0.5 * (np.log(np.pi * 5) + 1.8), "It is 2π in the logarithm, not π."),
    "no NIS": (
        -0.5 * LOG,
        "That is the number of a reading exactly as expected, y = 0. This one is 3 V off: its y²/S counts too. (The logarithm of the "
        "probability to be so far off, or further, is by chance about the same; wanted is that of the bell's height.)",
    ),
    "only the NIS": (-0.9, "That is the second part alone. log 2πS is missing."),
    "the NIS": (1.8, "That is the NIS alone. It is the second part of the bracket."),
    "the density": (
        float(np.exp(-0.5 * (LOG + 1.8))),
        "That is the probability density itself. Its logarithm was asked for.",
    ),
    "log10 of the density": (
        -0.5 * (LOG + 1.8) / np.log(10),
        "That comes of a logarithm to the base of ten. The natural one is meant, `np.log`.",
    ),
    "sign of the logarithm": (
        0.5 * LOG - 0.9,
        "The sign of the logarithm is the opposite: a half of log 2πS is taken off, as is a half of y²/S.",
    ),
    "log10": (
        -0.5 * (np.log10(2 * np.pi * 5) + 1.8),
        "That comes of a logarithm to the base of ten. The natural one is meant, `np.log`.",
    ),
    "S and y exchanged": (
        -0.5 * (np.log(2 * np.pi * 3) + 25 / 3),
        "That is right for S = 3 V² and y = 5 V. S, the variance, is 5 V², and y, the innovation, is 3 V.",
    ),
    "as in the lesson": (
        -640.23,
        "That is the sum over a whole record of the lesson. Here it is one reading: y = 3, S = 5.",
    ),
    "chi-square": (
        -0.5 * (np.log(2 * np.pi * 1.8) + 1.8),
        "−2.11 is the logarithm of the chi-square density of y²/S = 1.8. Wanted is the density of the reading "
        "itself: a bell with the variance S = 5 V².",
    ),
    "in units of σ": (
        -0.5 * (np.log(2 * np.pi) + 1.8),
        "−1.82 is right for a bell of variance 1, as if y were counted in units of √S. In volts the bell is wider, "
        "and so lower: the logarithm is that of 2πS.",
    ),
    "per cent": (
        100 * np.exp(-0.9) / np.sqrt(2 * np.pi * 5),
        "7.25 is the density itself, times 100. Its natural logarithm was asked for, which is negative here.",
    ),
}
