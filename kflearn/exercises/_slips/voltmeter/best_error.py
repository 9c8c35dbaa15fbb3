"""Lesson 5, `best_error`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def of_best_error(error):
    """What the error of lesson 5's drawn source would mean."""
    if abs(error - 1.63) < 0.015:
        return (
            f"{error:.3g} V is about what the filter with its random walk is off by here. The best answer does not use older "
            "readings: fuse N(12, 4) with the reading alone."
        )
    return (
        f"An error of {error:.3g} V is a variance of {error**2:.3g} V². Which variance is left when N(12, 4) is fused with "
        "a reading of variance 4?"
    )


WRONG = {
    "variance": (
        2.0,
        "2 V² is the variance that is left; the error in volts is its root. (By chance 2 V is the error of a single reading too: the best answer must be better than that.)",
    ),
    "K": (
        0.5,
        "0.5 is K, and also the sum of the two precisions, in 1/V². The question goes on: what error is left?",
    ),
    "filter's claim": (
        1.5723,
        "That is what the Kalman filter claims with its random walk. An answer that knows the 12 V is better.",
    ),
    "filter's error": (
        1.63,
        "That is what the Kalman filter reaches; the formula that knows the right world gets better.",
    ),
    "K times σ": (
        1.0,
        "1 V is half of a reading's σ: that part alone, K · 2 V, is left of the reading's error. The 12 V miss too, by (1 − K) · 2 V, and the squares add.",
    ),
    "one variance": (4.0, "4 V² is the variance of each of the two. Together they are better than each alone."),
    "root of K": (
        lambda: math.sqrt(0.5),
        "0.707 is √0.5. That 0.5 is K, or the sum of the two precisions in 1/V²; neither is a variance. Take the root of the variance that is left, 4(1 − K).",
    ),
    "variances added": (
        lambda: math.sqrt(8),
        "2.83 V is √8 V. Two mistakes lead to it. Either you added the variances: fusing two opinions makes the variance smaller "
        "than each. Or you took the 4 in both places for a standard deviation: both are variances, 4 V².",
    ),
    "variance of the random walk": (
        lambda: 4 * 0.618034,
        "2.47 V² is the variance that the Kalman filter with its random walk comes to, and its gain is 0.618. Here the "
        "reading is fused with N(12, 4), whose gain is another; and the error is a root.",
    ),
    "one part weighed": (
        lambda: math.sqrt(5),
        "2.24 is the root of (½)²·4 + 4, with one part weighed. Both parts are weighed with ½: (½)²·4 + (½)²·4.",
    ),
    "sum of the variances": (
        8.0,
        "8 V² is the sum of the two variances. Fusing makes the variance smaller than each.",
    ),
    "12 V": (12, "12 V is the mean of the source. How far off is the best answer?"),
    "golden": (
        0.618034,
        "That is the gain of the filter with its random walk. Here the reading is fused with N(12, 4), by lesson 4.",
    ),
    "in the constant world": (
        1.35,
        "1.35 V is the filter's error for a source that does not move. Here it jumps about 12 V.",
    ),
    "filter's gain": (
        lambda: 2 * math.hypot(0.381966, 0.618034),
        "That is the error with the gain 0.618 of the filter with its random walk. Here the gain comes from N(12, 4) and a reading with the variance 4.",
    ),
    "4 taken for a σ": (
        lambda: math.sqrt(64 / 20),
        "1.79 is √3.2, and 3.2 is left when a variance of 4 is fused with one of 4² = 16. In N(12, 4) the 4 is a variance, and the reading's 4 V² is one too.",
    ),
    "average's error": (
        0.739,
        "0.739 V is the error of an average where the source does not move. Here it is drawn anew each time.",
    ),
    "measured": (
        1.416,
        "1.416 V is what the simulation measured. Asked is the exact value: four digits of it are enough.",
    ),
    "K and error": (lambda: (0.5, math.sqrt(2)), "Both are right. Give the second alone: how far off, in volts."),
    "K squared": (
        3.0,
        "3 is 4(1 − K²), with K = ½. What is left is 4(1 − K), in V²; and the error is its root.",
    ),
    "root with K squared": (
        lambda: math.sqrt(3),
        "1.73 is √3, and 3 is 4(1 − K²) with K = ½. What is left is 4(1 − K).",
    ),
    "product": (
        16.0,
        "16 is the product of the two variances, 4 · 4. What is left is 4 · 4/(4 + 4), and the error is its root.",
    ),
    "sixteen and sixteen": (
        lambda: math.sqrt(32),
        "5.66 is √(16 + 16), or 4√2. The two variances are 4 V² each, and fusing them gives a smaller one.",
    ),
    "a third": (
        lambda: math.sqrt(4 / 3),
        "1.155 is √(4/3): so much would be left if three opinions of variance 4 were fused. Here there are two.",
    ),
    "a quarter": (
        0.25,
        "0.25 is K², or 1/4, the precision of one reading. What variance is left, 4(1 − K), and what is its root?",
    ),
    "4 more": (
        lambda: np.sqrt(8 / 3),
        "1.633 is √(8/3): 8/3 is left when a variance of 8 is fused with one of 4. The source has the variance 4, "
        "and nothing is added to it here: each voltage is drawn anew.",
    ),
    "error of a reading": (
        2.002,
        "2.002 V is the error of believing each reading, as with K = 1. With the K of lesson 4 less is left.",
    ),
}
