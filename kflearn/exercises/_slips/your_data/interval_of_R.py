"""Lesson 27, `interval_of_R`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show
from kflearn.results.consistency import chi_square_interval

LOW, HIGH = chi_square_interval(1, 40)

ONE_SIGMA = 0.09 * np.array([1 - np.sqrt(2 / 40), 1 + np.sqrt(2 / 40)])


def limits_of(limits):
    """What a number would mean that is in no row."""
    from scipy.stats import chi2

    low, high = limits
    if not 0 < low < high:
        return "Two variances are wanted, both larger than 0, the lower limit first."
    parts = [100 * chi2.sf(40 * 0.09 / low, 40), 100 * chi2.cdf(40 * 0.09 / high, 40)]
    return (
        f"If R were your lower limit, a sample variance of 0.09 m² or more would have a probability of {show(parts[0], 2)} %; if R were "
        f"the upper one, 0.09 m² or less one of {show(parts[1], 2)} %. At 95 % both are 2.5 %."
    )


WRONG = {
    "multiplied": (
        (0.09 * LOW, 0.09 * HIGH),
        "That is 0.09 times the chi-square numbers. They are sample variance / R, so R = 0.09 / number, and large numbers give the lower limit.",
    ),
    "ends swapped": ((0.09 / LOW, 0.09 / HIGH), "The two are right; hand in the lower limit first."),
    "41 degrees": (
        lambda: tuple(0.09 / end for end in chi_square_interval(1, 41)[::-1]),
        "Almost. The mean was estimated from the same readings, which costs one degree of freedom: 40.",
    ),
    "standard deviations": (
        lambda: tuple((0.09 / end) ** 0.5 for end in (HIGH, LOW)),
        "Those are the limits of σ. The question asks for R, the variance.",
    ),
    "σ taken for σ²": (
        lambda: tuple(0.3 / end for end in (HIGH, LOW)),
        "That is right for 0.3, the standard deviation in m. 0.09 m² is the variance already.",
    ),
    "limits of one reading": (
        lambda: tuple(0.09 / end for end in chi_square_interval(1, 1)[::-1]),
        "That is what a single squared deviation would say. Forty of them say more: `runs=40`.",
    ),
    "40 dimensions": (
        lambda: tuple(0.09 / end for end in chi_square_interval(40)[::-1]),
        "`chi_square_interval(40)` is the interval of a sum of 40 squares, its middle is 40. You want their average: "
        "`chi_square_interval(1, 40)`.",
    ),
    "straight normal": (
        (0.09 * (1 - 1.96 * (2 / 40) ** 0.5), 0.09 * (1 + 1.96 * (2 / 40) ** 0.5)),
        "That is the rule of thumb R (1 ± 1.96 √(2/40)), symmetric about 0.09. The true interval is lopsided: it "
        "reaches further up than down.",
    ),
    "the interval itself": (
        (LOW, HIGH),
        "That is the interval of (sample variance) / R. Solve for R: 0.09 divided by each end, the larger end first.",
    ),
    "two columns": (
        lambda: tuple(0.09 / end for end in chi_square_interval(2, 40)[::-1]),
        "That is what `chi_square_interval(2, 40)` gives, for two columns. Here it is one: `chi_square_interval(1, 40)`.",
    ),
    "eighty": (
        lambda: tuple(0.09 / end for end in chi_square_interval(1, 80)[::-1]),
        "That is the number for two columns together. One column of 41 readings has 40 degrees of freedom.",
    ),
    "41 degrees, multiplied": (
        lambda: tuple(0.09 * end for end in chi_square_interval(1, 41)),
        "Two things: one degree of freedom goes to the mean, which leaves 40; and R = 0.09 divided by the "
        "chi-square number.",
    ),
    "interval of the mean": (
        (0.09 - 2 * 0.3 / 41**0.5, 0.09 + 2 * 0.3 / 41**0.5),
        "That is how well the *mean* is known, ±2σ/√n, about the wrong middle. The variance has its own "
        "interval: chi-square.",
    ),
    "90 %": (
        lambda: tuple(0.09 / end for end in chi_square_interval(1, 40, 0.9)[::-1]),
        "That is the interval at 90 %. The question asks for 95 %, which is what `chi_square_interval` takes "
        "by itself.",
    ),
    "99 %": (
        lambda: tuple(0.09 / end for end in chi_square_interval(1, 40, 0.99)[::-1]),
        "That is the interval at 99 %. The question asks for 95 %, which is what `chi_square_interval` takes by itself.",
    ),
    "41 in the numerator": (
        lambda: tuple(0.09 * 41 / 40 / end for end in (HIGH, LOW)),
        "That is 41/40 of the right limits. The sample variance is the sum of squares by 40 already: 0.09 · 40 is that sum.",
    ),
    "chi-square itself": (
        (40 * LOW, 40 * HIGH),
        "Those are the limits of chi-square with 40 degrees of freedom. Divide the sum of squares, 0.09 · 40, by each.",
    ),
    "one number": (0.09, "That is the sample variance. Hand in two limits, `(low, high)`."),
    "interval of the mean, 1.96": (
        (0.09 - 1.96 * 0.3 / 41**0.5, 0.09 + 1.96 * 0.3 / 41**0.5),
        "That is how well a *mean* is known, 1.96 σ/√n, and a variance cannot be negative. The variance has its own interval: chi-square.",
    ),
    "interval of the mean, 40": (
        (0.09 - 1.96 * 0.3 / 40**0.5, 0.09 + 1.96 * 0.3 / 40**0.5),
        "That is how well a *mean* is known, 1.96 σ/√n, and a variance cannot be negative. The variance has its own interval: chi-square.",
    ),
    "mean, with the variance": (
        (0.09 - 1.96 * 0.09 / 41**0.5, 0.09 + 1.96 * 0.09 / 41**0.5),
        "That would be the interval of a mean whose standard deviation is 0.09. The variance has its own interval: chi-square.",
    ),
    "squared": (
        (0.09**2 / HIGH, 0.09**2 / LOW),
        "That is right for 0.09². 0.09 m² is a variance already.",
    ),
    "the factors": (
        (1 / HIGH, 1 / LOW),
        "Those are the factors, and they are right. Multiply each by the sample variance, 0.09 m².",
    ),
    "rule with 41": (
        (0.09 * (1 - 1.96 * (2 / 41) ** 0.5), 0.09 * (1 + 1.96 * (2 / 41) ** 0.5)),
        "That is the rule of thumb R (1 ± 1.96 √(2/n)), symmetric about 0.09. The true interval is lopsided: it reaches further up than down.",
    ),
    "rule with 2": (
        (0.09 * (1 - 2 * (2 / 40) ** 0.5), 0.09 * (1 + 2 * (2 / 40) ** 0.5)),
        "That is the rule of thumb R (1 ± 2 √(2/n)), symmetric about 0.09. The true interval is lopsided: it reaches further up than down.",
    ),
    "the lesson's ride": (
        (7.2, 13.1),
        "That is the interval of the lesson's ride. Here the sample variance is 0.09 m², with 40 degrees of freedom.",
    ),
    "one standard error": (
        ONE_SIGMA,
        "That is one standard error each way, 68 %. At 95 % use chi-square with 40 degrees of freedom.",
    ),
    "16 %": (
        (0.09 * 0.84, 0.09 * 1.16),
        "16 % belongs to the lesson's number of readings. With 41 readings R is known less well.",
    ),
    "as in the lesson": (
        (0.025, 0.0344),
        "Those are the lesson's limits. Here the sample variance is 0.09 m², of 41 readings.",
    ),
    "drawn in by √41": (
        (0.09 - (0.09 - 0.0607) / np.sqrt(41), 0.09 + (0.147 - 0.09) / np.sqrt(41)),
        "These are the right limits, drawn in towards 0.09 by a factor √41. All 41 readings are counted in "
        "chi-square already: nothing is divided by √41.",
    ),
}
