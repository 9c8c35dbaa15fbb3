"""Lesson 29, `with_the_constant`: wrong answers, each with the sentence that it gets."""

import numpy as np

CONSTANT = np.log(2 * np.pi) / 2

LOG_L = -31.40


WRONG = {
    "added": (
        LOG_L + 80 * CONSTANT,
        "The size is right, the sign is not. 1/√(2π) is smaller than 1, so its logarithm is negative and log L becomes smaller.",
    ),
    "all rows": (
        LOG_L - 100 * CONSTANT,
        "You counted all 50 rows. Where nothing was used, there is no density and no constant: leave the gaps and the half readings out.",
    ),
    "half readings counted": (
        LOG_L - 84 * CONSTANT,
        "You counted the 4 half readings with one number each. simdkalman and the other library drop them.",
    ),
    "half readings counted whole": (
        LOG_L - 88 * CONSTANT,
        "That is right for 88 numbers, with the 4 half readings counted whole: simdkalman drops the whole row, so they count as gaps.",
    ),
    "gaps counted": (
        LOG_L - 92 * CONSTANT,
        "You left the 4 half readings out, but not the 6 rows in which nothing was read.",
    ),
    "one a row": (
        LOG_L - 40 * CONSTANT,
        "That is 40 times ½ log 2π off, one for each whole row. Each row has two numbers, and each of them its own ½ log 2π.",
    ),
    "one a row, of all rows": (
        LOG_L - 50 * CONSTANT,
        "That is 50 times ½ log 2π off, one for each of the 50 rows. Each number that was used has its own: two in a whole row, none in a gap or a half reading.",
    ),
    "one a row, half readings counted": (
        LOG_L - 44 * CONSTANT,
        "You took ½ log 2π once for each of 44 rows. Each row has two numbers, and the 4 half readings are dropped: count the numbers of the other rows.",
    ),
    "one off in ten rows": (
        LOG_L - 90 * CONSTANT,
        "You left out one number in each of the ten rows that are not whole. Nothing of them was used: leave out two in each.",
    ),
    "no half": (
        LOG_L - 160 * CONSTANT,
        "You took log 2π off for each number. It is ½ log 2π: the density has the root of 2π.",
    ),
    "decimal logarithm": (
        LOG_L - 40 * np.log10(2 * np.pi),
        "That is the decimal logarithm. log L has natural ones, `np.log`.",
    ),
    "log π": (LOG_L - 40 * np.log(np.pi), "You took log π. In the density stands 2π."),
    "unchanged": (LOG_L, "That is simdkalman's own number, which has no log 2π in it."),
    "constant alone": (-80 * CONSTANT, "That is what has to be added to −31.40: the constant alone."),
    "once": (
        -31.40 - np.log(2 * np.pi) / 2,
        "You took ½ log 2π off once. It stands in the density of each number that was used: how many are there?",
    ),
}
