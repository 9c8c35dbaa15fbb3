"""Lesson 17, `start_nees`: wrong answers, each with the sentence that it gets."""

import numpy as np


def six_ratios(sum_of_them):
    """What a number would mean that is in no row."""
    if sum_of_them > 6:
        return "More than 6 would mean real errors that are larger than P₀ claims. Here they are much smaller: add up six ratios, real to claimed."
    if sum_of_them > 0.06:
        return "Six ratios are added, real to claimed, and none of them is larger than 1/100: the sum is at most 0.06."
    return "Six ratios are added, real to claimed. Four of them are 1/100, the other two are smaller: the sum is between 0.04 and 0.06."


WRONG = {
    "honest": (
        6.0,
        "That would be an honest start, each component contributing 1. Here each contributes far less.",
    ),
    "the wrong way": (2400.0, "2400 is the sum of the ratios of claim to real variance. Divide Q by P₀."),
    "per state": (
        0.042 / 6,
        "That is the mean of the six ratios, to be compared with 1; their sum was asked for, to be compared with 6.",
    ),
    "with standard deviations": (
        lambda: 2 * (0.1 + 0.1 + np.sqrt(0.001)),
        "That is the sum of the ratios of standard deviations; eᵀP₀⁻¹e is made of squares, so take ratios of variances.",
    ),
    "squared twice": (
        2 * (1e-4 + 1e-4 + 1e-6),
        "That is the sum of the squared ratios, but Q and P₀ hold variances already.",
    ),
    "position only": (0.02, "0.02 is twice 1/100, as of the positions alone. All six ratios belong to it."),
    "one axis": (0.021, "That is one axis, x or y; each entry stands twice on the diagonal."),
    "acceleration forgotten": (0.04, "The accelerations are missing: they bring 0.0001/0.1 twice."),
    "quotient of the sums": (
        2.0202 / 202.2,
        "That is the quotient of the sums. Each component has its own unit and its own claim: divide each, then add all six.",
    ),
    "real variances": (
        2.0202,
        "That is the sum of the real variances. Each of them is to be divided by the variance that P₀ claims for it.",
    ),
    "claimed variances": (
        202.2,
        "That is the sum of the claimed variances. Divide the real one of each component by its claimed one, then add.",
    ),
    "upside down, as a factor": (
        6 / 0.042,
        "That is how many times too small it is. The question asks for the average of eᵀP₀⁻¹e itself.",
    ),
    "six times the sum": (
        6 * 0.042,
        "That is six times the sum. The six terms are added, and that is all: an honest start has 6 because each of its terms is 1.",
    ),
    "six times the quotient": (
        6 * 2.0202 / 202.2,
        "That is six times the quotient of the two sums of variances. Each component has its own unit and its own claim: divide each, then add all six.",
    ),
    "one ratio": (
        0.01,
        "That is the ratio of the positions, or of the velocities. Add up the ratios of all six components.",
    ),
    "one acceleration": (
        0.041,
        "One of the two accelerations is missing: each entry stands twice on the diagonal.",
    ),
    "four with two": (
        0.022,
        "Two of the ratios of 1/100 are missing: the ratios are 1/100, 0.01/1 and 0.0001/0.1, each twice.",
    ),
    "accelerations alone": (0.002, "Those are the two accelerations. Position and velocity belong to the sum too."),
    "one of the first two": (0.032, "One ratio is missing: each entry stands twice on the diagonal."),
    "mean of three": (
        0.042 / 3,
        "That is a third of the sum. eᵀP₀⁻¹e adds the six ratios.",
    ),
    "all a hundredth": (
        0.06,
        "0.06 is six times 1/100. For the accelerations the ratio is 0.0001/0.1, which is 1/1000.",
    ),
    "inverse of the claim": (
        2 * (0.01 + 1 + 10),
        "That is the sum of the inverses of what P₀ claims, as if e² were 1 for all. Each is to be multiplied by its real variance in Q.",
    ),
    "one": (
        1.0,
        "1 would be an honest start, as a mean of the six. Asked is the sum of six ratios, and here each of them is small.",
    ),
    "added to 6": (
        6.042,
        "6 is what an honest start would have. Nothing is added to it: the sum of the six ratios is the answer.",
    ),
    "not inverted": (
        200.02,
        "200.02 is the trace of P₀ Q. In eᵀP₀⁻¹e P₀ divides: add up the ratios of Q to P₀.",
    ),
    "factors in the mean": (
        400,
        "400 is the mean of the six ratios of claim to real variance. Turn each of them over, and add all six.",
    ),
    "what is missing to 6": (5.958, "That is 6 minus the sum. The sum of the six ratios itself is the answer."),
    "P₀ as σ": (
        0.0402,
        "That is what comes of P₀ squared. P₀ holds variances already: each ratio is Q to P₀, as they are.",
    ),
    "Q as σ": (
        0.0202,
        "That is what comes of Q squared. Q holds variances already: each ratio is Q to P₀, as they are.",
    ),
    "one of each, all a hundredth": (
        0.03,
        "That is three times 1/100. There are six ratios, and those of the accelerations are 0.0001/0.1 = 1/1000.",
    ),
    "traces upside down": (
        202.2 / 2.0202,
        "That is the sum of all claims by the sum of all real variances. Divide each real variance by its own claim, then add all six.",
    ),
    "six ratios": (
        [0.01, 0.01, 0.01, 0.01, 0.001, 0.001],
        "These are the six ratios, and they are right. eᵀP₀⁻¹e is their sum.",
    ),
    "three ratios": ([0.01, 0.01, 0.001], "These are the ratios of one axis. eᵀP₀⁻¹e is the sum of all six."),
}
