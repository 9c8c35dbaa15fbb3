"""Lesson 4, `published_claim`: wrong answers, each with the sentence that it gets."""

import math

from kflearn.exercises._slips.gaussian_fusion.shared import fused


def against_the_reading(vx, vz):
    S = vx + vz
    return S / vz, vz / S, S**2 / (vx * vz)


WRONG = {
    "turned over": (
        lambda p, r: (r / p, r * (p + r) / (p * r), p * r / (p + r) / p),
        "All three are turned over: divide the real mean squared error by the claimed variance.",
    ),
    "all means are the fused one": (
        lambda p, r: (p / (p + r), p / (p + r), 1.0),
        "Only Anna returns the fused mean. The other two return μx, and its mean squared error is the prediction's variance.",
    ),
    "all means are μx": (
        lambda p, r: (p / r, p / r, (p + r) / r),
        "Two are right. Anna returns the fused mean, so her real mean squared error is the fused variance.",
    ),
    "Anna and Ben exchanged": (
        lambda p, r: (p / r, (p + r) / r, p / (p + r)),
        "The first is right. Anna's and Ben's are exchanged (the order is published, Anna's, Ben's), or you added the variances where the fused one is needed.",
    ),
    "Ben's claim for all": (
        lambda p, r: (p / (p * r / (p + r)), 1.0, p / (p * r / (p + r))),
        "Only Ben's is right: he claims the fused variance. The published version returns μx, Anna's the fused mean, and both claim σz².",
    ),
    "the errors alone": (
        lambda p, r: (p, p * r / (p + r), p),
        "These are the three real mean squared errors, and they are right. Divide each by the variance that its version claims.",
    ),
    "the claims alone": (
        lambda p, r: (r, r, p * r / (p + r)),
        "These are the three claims. What is wanted is the real mean squared error divided by the claim.",
    ),
    "deviations": (
        lambda p, r: (math.sqrt(p / r), math.sqrt(p / (p + r)), math.sqrt((p + r) / r)),
        "You took roots. The ratio of the variances is wanted, not of the standard deviations.",
    ),
    "1 − K for Anna": (
        lambda p, r: (p / r, r / (p + r), (p + r) / r),
        "Two are right. For Anna's, the fused variance var_x · var_z / (var_x + var_z) is divided by var_z: var_z drops out on top.",
    ),
    "the tape's error": (
        lambda p, r: (1.0, p / (p + r), (p + r) / p),
        "Anna's is right. In the other two the mean is μx. Its mean squared error is var_x, not var_z.",
    ),
    "Ben claims var_z": (
        lambda p, r: (p / r, p / (p + r), p / r),
        "Two are right. Ben returns μx with the mended variance, the fused one. Divide his var_x by that.",
    ),
    "Ben is honest": (
        lambda p, r: (p / r, p / (p + r), 1.0),
        "Two are right. Ben returns μx, so his real mean squared error is var_x, not the fused variance that he claims.",
    ),
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
    "mended is honest": (
        lambda vx, vz: (vx / vz, 1, 1),
        "The first number is right. 1 would mean honest; a filter of which one half is mended is not. Divide again: the real mean squared error "
        "of the mean that it returns by the variance that it claims.",
    ),
    "against the reading": (
        against_the_reading,
        "These are the ratios for distances from the *reading*: μx − z, for example, has the variance var_x + "
        "var_z. An error is the distance from the truth, and μx has var_x.",
    ),
    "the tape's part left out": (
        lambda vx, vz: (vx / vz, vz * vx / (vx + vz) ** 2, (vx + vz) / vz),
        "Two are right. In Anna's only the prediction's part of the error counts, (1 − K)²·var_x. The reading "
        "errs too, with the weight K: that part comes on top.",
    ),
}
