"""Lesson 4, `readings_needed`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

CLUES = {
    6: "Precisions add: 1/5 of the prediction, not 5. And a reading does not halve the variance each time.",
    7: "Did you take 5 for the precision of the prediction? 5 m² is its variance.",
    8: "Did you divide one σ by the other? It is precisions that add, 1/σ².",
    9: "Did you round 0.3² up, or take more than 1/5 away? 1/0.09 is 11.1.",
    16: "Did you add 5 for the prediction? Its precision is 1/5, and it is there already: it saves readings.",
}

PRECISIONS = "Precisions add: 1/5 of the prediction, and 1 for each reading."


def far_off():
    """What σ so many readings would give."""
    for_each = {n: 1 / math.sqrt(1 / 5 + n) for n in range(1, 31) if n not in (3, 4, 10, 11, 12)}
    verdict = {True: "more than is allowed", False: "good enough, but fewer would do"}
    return {
        str(n): (n, f"With {n} reading{'s' * (n > 1)} σ is {s:.2f} m: {verdict[s > 0.3]}. {CLUES.get(n, PRECISIONS)}")
        for n, s in for_each.items()
    }


WRONG = (
    {
        "variances added": (
            67,
            "67 is (5 + 1)/0.3², rounded up: there the variances of the prediction and of a reading are added. "
            "Precisions add: 1/5 of the prediction, and 1 for each reading.",
        ),
        "0.3 taken as a variance": (
            4,
            "Four readings bring the *variance* below 0.3 m². The question says σ below 0.3 m: a variance below 0.09 m².",
        ),
        "prediction forgotten": (
            12,
            "Twelve readings are enough, but fewer will do. The prediction brings a precision of 1/5, to be taken away from 1/0.09. (5 m² is a variance already: it is not squared.) Or does your counter begin at 1? Before the first reading none is counted.",
        ),
        "rounded down": (10, "With 10 readings σ is 0.313 m: not yet below 0.3 m. Round up."),
        "not rounded": (
            lambda: 1 / 0.09 - 0.2,
            "The calculation is right, but you can only read the tape a whole number of times.",
        ),
    }
    | far_off()
    | {
        "variance, rounded down": (
            3,
            "With 3 readings σ is 0.56 m. Two mistakes lead to 3: 0.3 in place of 0.3² (the precision that is wanted is 1/0.09), or a variance that each reading divides by 6, as the first one does. Precisions add: 1/5 of the prediction, and 1 for each reading.",
        ),
        "not rounded, prediction forgotten": (
            lambda: 1 / 0.09,
            "1/0.09 is the precision that is wanted. The prediction brings a part of it, and readings come in whole numbers.",
        ),
        "5/0.09": (
            lambda: 5 / 0.09,
            "55.6 is 5/0.09, one variance over the other. With every reading *precisions* add: 1/5 + n.",
        ),
        "variance, not rounded": (
            lambda: 1 / 0.3 - 1 / 5,
            "3.13 is 1/0.3 − 1/5, with 0.3 in place of 0.3²: a variance below 0.09 m² is wanted, a precision of 1/0.09. And readings come in whole numbers.",
        ),
        "1/σ": (
            lambda: 1 / 0.3,
            "3.33 is 1/σ. Precision is 1/σ², and the prediction brings a part of what is wanted.",
        ),
        "5/0.09, rounded up": (
            56,
            "56 is 5/0.09, one variance over the other, rounded up. With every reading *precisions* add: 1/5 + n.",
        ),
        "σ": (0.3, "0.3 m is the σ that is wanted. How many readings bring it about?"),
        "hundred": (
            100,
            "100 readings give σ = 0.1 m, a variance of 0.01 m²: far fewer are enough. σ has to be below 0.3 m.",
        ),
        "prediction's precision added": (
            lambda: 1 / 0.09 + 0.2,
            "The prediction's precision is there already, and saves readings: take 1/5 away from 1/0.09. And readings come in whole numbers.",
        ),
        "prediction's precision 5": (
            lambda: 1 / 0.09 - 5,
            "6.11 is 1/0.09 − 5, with 5 for the precision of the prediction. 5 m² is its variance: the precision is 1/5.",
        ),
        "2σ": (45, "With 45 readings 2σ is below 0.3 m. σ itself was asked for."),
        "σ that is reached": (
            lambda: np.sqrt(1 / 11.2),
            "0.299 m is a σ, and it is below 0.3 m. Asked is how many readings reach it.",
        ),
        "variance that is reached": (
            lambda: 1 / 11.2,
            "0.0893 m² is a variance, and it is below 0.09 m². Asked is how many readings reach it.",
        ),
        "precision that is reached": (
            11.2,
            "11.2 is a precision, in 1/m², and it is above 1/0.09. Asked is how many readings reach it.",
        ),
        "squared twice": (
            124,
            "124 is 1/0.3⁴, with or without the 1/5, rounded up. σ = 0.3 m is squared once: the precision that is "
            "wanted is 1/0.3².",
        ),
    }
)
