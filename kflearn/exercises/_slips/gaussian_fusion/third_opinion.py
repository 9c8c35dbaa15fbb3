"""Lesson 4, `third_opinion`: wrong answers, each with the sentence that it gets."""

import math


def third(share):
    """The mean that lies this share of the way to the satellite."""
    return 61.6667 + share * (66 - 61.6667)


FUSED = "Begin with N(61.6667, 0.8333) and weigh."


WRONG = {
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
    "σ squared twice": (
        61.6667 + 0.8333 / (0.8333 + 16) * 4.3333,
        "61.88 comes from K = 0.8333 / (0.8333 + 16). The satellite's σ is 2 m, so its variance is 2² = 4 m², not 16.",
    ),
}
