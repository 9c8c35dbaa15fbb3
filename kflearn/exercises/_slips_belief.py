"""More wrong answers to exercises of lesson 4, each with its sentence: those that a second stranger tried."""

import math

FUSED = "Begin with N(61.6667, 0.8333) and weigh."


def third(share):
    """The mean that lies this share of the way to the satellite."""
    return 61.6667 + share * (66 - 61.6667)


def fused(vx, vz):
    """The right variance of two opinions."""
    return vx * vz / (vx + vz)


def moved(mx, mz, K):
    """A mean, moved by a gain."""
    return mx + K * (mz - mx)


WRONG = {
    "third_opinion": {
        "both σ": (
            lambda: third(math.sqrt(0.8333) / (math.sqrt(0.8333) + 2)),
            "63.02 comes from a K of two standard deviations, √0.8333 and 2. (12) takes variances: 0.8333 m² is one already, and the satellite's is 2².",
        ),
        "mean of three": (
            lambda: (60 + 62 + 66) / 3,
            f"That is the plain mean of all three. They are not equally certain. {FUSED}",
        ),
        "the lesson's gain": (
            lambda: third(5 / 6),
            "65.28 comes from K = 0.8333: that was the lesson's gain, and is a variance here. Form K anew, from both variances.",
        ),
        "a third": (
            lambda: third(1 / 3),
            "63.11 is a third of the way, as in the mean of three readings. The three are not equally certain: form K.",
        ),
        "own variances": (
            (60 * 5 + 62 * 1 + 66 * 4) / 10,
            "62.6 is (5 · 60 + 1 · 62 + 4 · 66)/10, where the least certain number weighs most. Weights are precisions, 1 divided by the variance.",
        ),
        "ratio": (
            lambda: third(0.8333 / 4),
            "62.57 comes from a gain of 0.8333/4, the ratio of the two variances. K is a part of their sum: add 0.8333 below the line.",
        ),
        "wrong part of σ": (
            lambda: third(2 / (0.8333 + 2)),
            "Two things: K has the prediction's variance on top, and the satellite's variance is 2², not 2.",
        ),
    },
    "fuse": {
        "var_x squared throughout": (
            lambda mx, vx, mz, vz: (
                moved(mx, mz, vx**2 / (vx**2 + vz**2)),
                vx**2 * vz**2 / (vx**2 + vz**2),
            ),
            "You squared the variances everywhere. They are squares already: use them as they are.",
        ),
        "no brackets, in both": (
            lambda mx, vx, mz, vz: (moved(mx, mz, vx / vx + vz), vx * (1 - (vx / vx + vz))),
            "Brackets are missing in K: var_x / (var_x + var_z), or Python divides first and adds afterwards.",
        ),
        "weights without their sum": (
            lambda mx, vx, mz, vz: (mx / vx + mz / vz, fused(vx, vz)),
            "The variance is right. The mean lacks a division: two means weighed with 1/variance are divided by the sum of the weights.",
        ),
        "means added": (
            lambda mx, vx, mz, vz: (mx + mz, fused(vx, vz)),
            "The variance is right. The mean is not the sum of the two: it lies between them.",
        ),
        "means added, variances too": (
            lambda mx, vx, mz, vz: (mx + mz, vx + vz),
            "That is the sum of two uncertain numbers. Here two opinions about one number are fused: the mean lies between them.",
        ),
        "mean alone": (
            lambda mx, vx, mz, vz: moved(mx, mz, vx / (vx + vz)),
            "The mean is right. The variance is wanted as well: return both, the mean first.",
        ),
        "roots in both": (
            lambda mx, vx, mz, vz: (
                moved(mx, mz, vx / (vx + vz)),
                math.sqrt(vx) * math.sqrt(vz) / (math.sqrt(vx) + math.sqrt(vz)),
            ),
            "The mean is right. In the variance you used standard deviations: take var_x and var_z themselves.",
        ),
        "less certain wins": (
            lambda mx, vx, mz, vz: (mx if vx < vz else mz, min(vx, vz)),
            "You kept the more certain of the two. Both say something: weigh them.",
        ),
    },
    "published_claim": {
        "Ben's error is the tape's": (
            lambda p, r: (p / r, p / (p + r), r / fused(p, r)),
            "Two are right. Ben returns μx: its mean squared error is var_x, not var_z.",
        ),
        "published claims the fused one": (
            lambda p, r: (p / fused(p, r), p / (p + r), p / fused(p, r)),
            "Two are right. The published version returns μx and claims σz²: its ratio is var_x over var_z, without a sum or a fused variance.",
        ),
        "published is honest": (
            lambda p, r: (1.0, p / (p + r), p / fused(p, r)),
            "Two are right. The published version returns μx and claims σz²: these are variances of two different numbers.",
        ),
        "sums for μx": (
            lambda p, r: ((p + r) / r, p / (p + r), (p + r) / fused(p, r)),
            "Anna's is right. In the other two stands var_x + var_z, as for μx minus the reading. Wanted is μx minus the truth: var_x.",
        ),
        "differences": (
            lambda p, r: (p - r, fused(p, r) - r, p - fused(p, r)),
            "You subtracted the claim. Divide by it.",
        ),
        "Anna is honest": (
            lambda p, r: (p / r, 1.0, p / fused(p, r)),
            "Two are right. Anna returns the fused mean, whose error is smaller than σz², which she claims.",
        ),
        "Anna with μx": (
            lambda p, r: (p / r, p / fused(p, r), p / fused(p, r)),
            "Two are right. Anna mends the mean alone: her error is the fused variance, and she claims σz².",
        ),
    },
    "common_cause": {
        "correlation": (
            lambda P, R, c: (P - c * math.sqrt(P * R)) / (P + R - 2 * c * math.sqrt(P * R)),
            "You took c for a correlation and multiplied it by the two σ. c is the covariance itself.",
        ),
        "twice on top": (
            lambda P, R, c: (P - 2 * c) / (P + R - 2 * c),
            "Below the line is right. On top c stands once: half of the slope at K = 0 is c − P.",
        ),
        "corner over sum": (
            lambda P, R, c: c / (P + R),
            "That is c alone over P + R. On top belongs the prediction's variance too, and c appears below the line.",
        ),
        "corner over sum, below right": (
            lambda P, R, c: c / (P + R - 2 * c),
            "Below the line is right. On top belongs the prediction's variance, less c.",
        ),
        "plus on top, no c below": (
            lambda P, R, c: (P + c) / (P + R),
            "The sign of c on top is wrong, and below the line c is missing.",
        ),
        "plus on top": (
            lambda P, R, c: (P + c) / (P + R - 2 * c),
            "Below the line is right. On top the sign of c is wrong.",
        ),
        "between 0 and 1": (
            lambda P, R, c: min(max((P - c) / (P + R - 2 * c), 0), 1),
            "The formula is right, but you keep K between 0 and 1. With a large covariance the best gain lies beyond: leave it as it is.",
        ),
        "not below 0": (
            lambda P, R, c: max((P - c) / (P + R - 2 * c), 0),
            "The formula is right, but you keep K from falling below 0. With a large covariance it does.",
        ),
        "not above 1": (
            lambda P, R, c: min((P - c) / (P + R - 2 * c), 1),
            "The formula is right, but you keep K from rising above 1. With a large covariance it does.",
        ),
        "c squared": (
            lambda P, R, c: (P - c**2) / (P + R - 2 * c**2),
            "You squared c. It is a covariance, a square already.",
        ),
    },
}
