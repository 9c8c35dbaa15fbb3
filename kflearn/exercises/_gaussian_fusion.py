"""Wrong answers to exercises of lesson 4, each with the sentence that it gets."""

import math

PRECISIONS = "Precisions add: 1/5 of the prediction, and 1 for each reading."
CLUES = {
    6: "Precisions add: 1/5 of the prediction, not 5. And a reading does not halve the variance each time.",
    7: "Did you take 5 for the precision of the prediction? 5 m² is its variance.",
    8: "Did you divide one σ by the other? It is precisions that add, 1/σ².",
    9: "Did you round 0.3² up, or take more than 1/5 away? 1/0.09 is 11.1.",
    16: "Did you add 5 for the prediction? Its precision is 1/5, and it is there already: it saves readings.",
}


def far_off():
    """What σ so many readings would give."""
    for_each = {n: 1 / math.sqrt(1 / 5 + n) for n in range(1, 31) if n not in (3, 4, 10, 11, 12)}
    verdict = {True: "more than is allowed", False: "good enough, but fewer would do"}
    return {
        str(n): (n, f"With {n} reading{'s' * (n > 1)} σ is {s:.2f} m: {verdict[s > 0.3]}. {CLUES.get(n, PRECISIONS)}")
        for n, s in for_each.items()
    }


WRONG = {
    "third_opinion": {
        "nothing done": (
            61.6667,
            "61.67 m is where the cart was believed to be before the satellite. In which direction does 66 m move it, and how far?",
        ),
        "σ for σ²": (
            lambda: 61.6667 + 0.8333 / (0.8333 + 2) * (66 - 61.6667),
            "62.94 comes from K = 0.8333 / (0.8333 + 2). (12) takes variances: the satellite's is 2² = 4 m², and 0.8333 m² is one already.",
        ),
        "1 − K": (
            lambda: 61.6667 + 4 / (0.8333 + 4) * (66 - 61.6667),
            "65.25 is the mean with the two weights exchanged: K has the prediction's variance on top, K = 0.8333 / (0.8333 + 4).",
        ),
        "halfway": (
            lambda: (61.6667 + 66) / 2,
            "That is the plain average. The satellite (variance 4) knows less than the fused cart (variance 0.83) and must count less.",
        ),
        "old prediction": (
            lambda: 60 + 5 / 9 * 6,
            "63.33 is the satellite fused with the old prediction N(60, 5), so the tape is left out: begin with N(61.6667, 0.8333).",
        ),
        "satellite alone": (
            66,
            "66 m is the satellite alone. The 61.6667 m count more than it, as their variance is smaller.",
        ),
        "wrong sign": (
            lambda: 61.6667 - 0.8333 / (0.8333 + 4) * (66 - 61.6667),
            "The size of the step is right, but it goes away from the satellite: 66 is above 61.6667.",
        ),
        "variance": (lambda: 0.8333 * 4 / (0.8333 + 4), "That is the fused variance, in m². The mean was asked for."),
        "K": (lambda: 0.8333 / (0.8333 + 4), "That is the gain K. Go on: 61.6667 plus K times the way to 66."),
        "tape and satellite": (
            62.8,
            "62.8 is the tape N(62, 1) fused with the satellite, so the prediction is left out: begin with N(61.6667, 0.8333).",
        ),
        "1 − K itself": (
            lambda: 4 / (0.8333 + 4),
            "That is 1 − K. Form K, and then 61.6667 plus K times the way to 66.",
        ),
        "tape": (62, "62 m is the tape's reading. Begin with N(61.6667, 0.8333), which contains it already."),
        "tape and satellite halfway": (
            64,
            "64 m is halfway between the tape and the satellite. Begin with N(61.6667, 0.8333), and weigh.",
        ),
        "the step": (lambda: 0.8333 / (0.8333 + 4) * (66 - 61.6667), "That is the step alone. Add it to 61.6667 m."),
        "prediction and satellite halfway": (
            63,
            "63 m is halfway between 60 and 66 m. Begin with N(61.6667, 0.8333), which contains the tape, and weigh.",
        ),
        "prediction": (60, "60 m was the prediction before the tape was read. Begin with N(61.6667, 0.8333)."),
        "variances as precisions": (
            lambda: 61.6667 + 0.8333**2 / (0.8333**2 + 4**2) * (66 - 61.6667),
            "61.85 comes from K = 0.8333² / (0.8333² + 4²). 0.8333 m² and 4 m² are variances already.",
        ),
        "0.8333 taken as σ": (
            lambda: 61.6667 + 0.8333**2 / (0.8333**2 + 4) * (66 - 61.6667),
            "62.31 comes from K = 0.8333² / (0.8333² + 4). In N(61.6667, 0.8333) the second number is a variance already; only the satellite's 2 m is a σ.",
        ),
        "mean and variance": (lambda: (62.4138, 0.6897), "Both are right. Give the mean alone: one number."),
    },
    "fuse": {
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
    },
    "readings_needed": {
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
        **far_off(),
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
    },
}
