"""Lesson 4, `fuse`: wrong answers, each with the sentence that it gets."""

import math

from kflearn.exercises._slips.gaussian_fusion.shared import fused


def weighed(mx, vx, mz, vz):
    """The right mean of two opinions."""
    return (mx * vz + mz * vx) / (vx + vz)


FUSE = {
    "variance of a plain average": (
        lambda mx, vx, mz, vz: ((mx + mz) / 2, (vx + vz) / 4),
        "That is the plain average and its variance, (var_x + var_z)/4. It is honest, but not the best: weigh the two, so that the less certain one counts less.",
    ),
    "that variance, mean right": (
        lambda mx, vx, mz, vz: (weighed(mx, vx, mz, vz), (vx + vz) / 4),
        "The mean is right. Your variance is that of a plain average; the weighed one is more certain.",
    ),
    "the smaller variance": (
        lambda mx, vx, mz, vz: (weighed(mx, vx, mz, vz), min(vx, vz)),
        "The mean is right. You took the smaller of the variances; the fused one is smaller than both.",
    ),
}


def moved(mx, mz, K):
    """A mean, moved by a gain."""
    return mx + K * (mz - mx)


WRONG = (
    {
        "weights swapped": (
            lambda mx, vx, mz, vz: (mx + vz / (vx + vz) * (mz - mx), vx * vz / (vx + vz)),
            "Your variance is right, but the mean has 1 − K in place of K: the less certain the prediction, the further you must move.",
        ),
        "σ for σ²": (
            lambda mx, vx, mz, vz: (
                mx + math.sqrt(vx) / (math.sqrt(vx) + math.sqrt(vz)) * (mz - mx),
                vx * vz / (vx + vz),
            ),
            "You weighed with standard deviations; (12) wants the variances themselves.",
        ),
        "variances added": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx + vz),
            "You added the variances. That is what a prediction does; a measurement makes the variance smaller: σx²(1 − K).",
        ),
        "variance not reduced": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx),
            "The mean is right, but the variance is still the prediction's: (14) multiplies it by 1 − K.",
        ),
        "K times the variance": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx * vx / (vx + vz)),
            "The mean is right, but you kept the part K of the variance; what remains is the part 1 − K.",
        ),
        "innovation backwards": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mx - mz), vx * vz / (vx + vz)),
            "Your mean moves away from the tape: (13) adds K times measured minus expected, mean_z − mean_x.",
        ),
        "plain average": (
            lambda mx, vx, mz, vz: ((mx + mz) / 2, vx * vz / (vx + vz)),
            "The variance is right, but the mean is the plain average: weigh with K.",
        ),
        "standard deviation returned": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), math.sqrt(vx * vz / (vx + vz))),
            "The mean is right; the second number is a standard deviation, and a variance was asked for.",
        ),
        "K swapped in both": (
            lambda mx, vx, mz, vz: (mx + vz / (vx + vz) * (mz - mx), vx * vx / (vx + vz)),
            "Your K has var_z on top: that is 1 − K. In (12) the prediction's variance is on top: a less certain prediction gets less weight, and K becomes larger.",
        ),
        "σ in K, everywhere": (
            lambda mx, vx, mz, vz: (
                mx + math.sqrt(vx) / (math.sqrt(vx) + math.sqrt(vz)) * (mz - mx),
                vx * math.sqrt(vz) / (math.sqrt(vx) + math.sqrt(vz)),
            ),
            "You formed K from standard deviations; (12) wants the variances themselves.",
        ),
        "the tape's variance times 1 − K": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vz * vz / (vx + vz)),
            "The mean is right. In (14) it is the prediction's variance that is multiplied by 1 − K, not the tape's.",
        ),
        "precision": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), 1 / vx + 1 / vz),
            "The mean is right. Your second number is the sum of the precisions, in 1/m². Turn it over: 1 divided by it is the variance.",
        ),
        "K z added": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * mz, vx * vz / (vx + vz)),
            "The variance is right. To the mean you added a part of mean_z itself: add a part of the difference, mean_z − mean_x.",
        ),
        "only the step": (
            lambda mx, vx, mz, vz: (vx / (vx + vz) * (mz - mx), vx * vz / (vx + vz)),
            "The variance is right. The first number is the step alone: add it to mean_x.",
        ),
        "the average": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), (vx + vz) / 2),
            "The mean is right. The variance is not the average of the two: it is smaller than each of them.",
        ),
        "variance squared": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx * (1 - vx / (vx + vz)) ** 2),
            "The mean is right. In (14) the factor 1 − K stands once, not squared: the tape's own error adds the rest.",
        ),
        "averages of both": (
            lambda mx, vx, mz, vz: ((mx + mz) / 2, (vx + vz) / 2),
            "You took plain averages. Weigh with K, so that the less certain opinion counts less.",
        ),
        "K returned": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx / (vx + vz)),
            "The mean is right. The second number is K itself; the variance is var_x times 1 − K.",
        ),
        "1 − K returned": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vz / (vx + vz)),
            "The mean is right. The second number is 1 − K; multiply var_x by it.",
        ),
        "ratio for K": (
            lambda mx, vx, mz, vz: (mx + vx / vz * (mz - mx), vx * (1 - vx / vz)),
            "Your K is a ratio of the two variances. It is a part of their sum: var_x / (var_x + var_z).",
        ),
        "squares": (
            lambda mx, vx, mz, vz: (mx + vx**2 / (vx**2 + vz**2) * (mz - mx), vx * (1 - vx**2 / (vx**2 + vz**2))),
            "You squared the variances. They are squares already: use them as they are.",
        ),
        "squares, variance right": (
            lambda mx, vx, mz, vz: (mx + vx**2 / (vx**2 + vz**2) * (mz - mx), vx * vz / (vx + vz)),
            "In K you squared the variances. They are squares already: use them as they are.",
        ),
        "no brackets": (
            lambda mx, vx, mz, vz: (mx + vx / vx + vz * (mz - mx), vx * vz / (vx + vz)),
            "Brackets are missing: var_x / (var_x + var_z), or Python divides first and adds afterwards.",
        ),
        "product": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vx * vz),
            "The mean is right. The product of the variances is in m⁴: divide it by their sum.",
        ),
        "σ times 1 − K": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), math.sqrt(vx) * (1 - vx / (vx + vz))),
            "The mean is right. In (14) it is the variance that is multiplied by 1 − K, not its root.",
        ),
    }
    | FUSE
    | {
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
        "variances averaged": (
            lambda a, P, b, R: (a + P / (P + R) * (b - a), P + P / (P + R) * (R - P)),
            "The mean is right. Your variance is twice the fused one, as is (1 − K)·var_x + K·var_z. By (14) it is var_x · (1 − K).",
        ),
        "variance of the reading": (
            lambda mx, vx, mz, vz: (mx + vx / (vx + vz) * (mz - mx), vz),
            "The mean is right. The variance that you return is that of the second number alone, var_z. Both together know more: K times var_z.",
        ),
    }
)
