"""Lesson 2, `table_length`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

WRONG = {
    "independent": (
        math.sqrt(18),
        "√(9 + 9) holds for errors that have nothing in common. These share most of their error: the corner must be subtracted, twice.",
    ),
    "added": (
        math.sqrt(18 + 14.4),
        "5.69 is √(9 + 9 + 2 · 7.2), the σ of a sum. The length is a difference: A = [−1, 1], and the products of A's entries with the corner are negative.",
    ),
    "variance": (3.6, "3.6 mm² is the variance of the length. σ is its root."),
    "corner once": (math.sqrt(18 - 7.2), "The corner stands twice in P, so it counts twice: 9 + 9 − 2 · 7.2."),
    "σ instead of σ²": (
        math.sqrt(6 - 1.6),
        "2.1 is √(3 + 3 − 2 · 0.8), with σ = 3 mm on the diagonal. A covariance matrix holds variances: 9 mm², and 0.8 · 3 · 3 in the corner.",
    ),
    "correlation as covariance": (
        math.sqrt(18 - 1.6),
        "0.8 is the correlation, a pure number. The corner of P is 0.8 · 3 mm · 3 mm = 7.2 mm².",
    ),
    "correlation on 3": (
        math.sqrt(18 - 2 * 2.4),
        "The corner is the correlation times both σ: 0.8 · 3 · 3, not 0.8 · 3.",
    ),
    "one end": (3.0, "3 mm is the σ of one end. The length depends on both ends and on what their errors share."),
    "added σ": (6.0, "The σ's do not add. Variances do, and here twice the corner is subtracted from their sum."),
    "subtracted σ": (
        0.0,
        "0 would be so if the two errors were equal, with correlation 1. These share only a part: the two variances add up, and twice the corner is subtracted.",
    ),
    "1 − ρ of σ": (
        0.6,
        "0.6 is 3 · (1 − 0.8), or √(1 − 0.8²): a share of one σ is not the σ of a difference. Calculate with variances: A P Aᵀ, then the root.",
    ),
    "√(1 − ρ²)": (
        1.8,
        "1.8 is 3 · √(1 − 0.8²), what is left of one end's σ when the other end's error is known; or 9 − 7.2, one variance less the corner. The difference of the two is asked for: A P Aᵀ, and its root.",
    ),
    "0.9·": (0.8, "That is the correlation. Build P from it and calculate A P Aᵀ with A = [−1, 1]."),
    "corner": (7.2, "7.2 mm² is the corner of P. Go on: 9 + 9 − 2 · 7.2, and the root."),
    "sum of variances": (
        18.0,
        "18 mm² is the sum of the two variances. Subtract twice the corner, then take the root.",
    ),
    "added, not rooted": (
        32.4,
        "32.4 mm² is a variance, and the corner is added in it. For a difference the corner is subtracted, twice; then take the root.",
    ),
    "σ for σ², all through": (
        lambda: math.sqrt(3 + 3 - 2 * 0.8 * 3),
        "1.1 is √(3 + 3 − 2 · 0.8 · 3), with 3 where 3² belongs: 3 mm is a σ. The variances are 9 mm², and the corner is 0.8 · 3 · 3.",
    ),
    "one reading's own part": (
        lambda: np.sqrt(1.8),
        "1.34 is √1.8, and 1.8 is 9 − 7.2, or 9 · (1 − 0.8): what one reading does not share with the other. Both "
        "readings have such a part, and the length has both.",
    ),
    "independent, less 80 %": (
        lambda: 0.2 * np.sqrt(18),
        "0.849 is 0.2 · √18, a fifth of the σ of independent readings. The correlation makes the corner of P: it "
        "is the *variance* 9 + 9 from which something is taken, before the root.",
    ),
    "0.8 of the sum": (
        lambda: np.sqrt(14.4),
        "3.79 is √14.4, and 14.4 mm² is 0.8 · (9 + 9), or twice the corner, 7.2: that is what must be taken away "
        "from 9 + 9.",
    ),
}
