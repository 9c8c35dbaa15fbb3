"""Lesson 7, `interval`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn import chi_square_interval


def of_interval(limits):
    """How many of the averages lie between two limits; None where they are none."""
    from scipy.stats import chi2

    low, high = limits
    if not low < high:
        return None
    share = 100 * np.ptp(chi2.cdf(np.multiply(limits, 50), 100))
    if share > 99.5:
        single = np.allclose(limits, chi2.ppf([0.025, 0.975], 2), rtol=0.02)
        words = (
            "Those are the limits for a single run."
            if single
            else "Practically every average lies between these limits."
        )
        return f"{words} An average of 50 runs scatters far less: chi-square with 50 · 2 degrees of freedom, divided by 50."
    return f"Between {low:.4g} and {high:.4g} lie {share:.3g} % of the averages. 95 % are wanted, and 2.5 % on either side."


WRONG = {
    "one-sided": (
        lambda: (0.0, chi_square_interval(2, 50, 0.9)[1]),
        "Your interval has one end only: it would pass every filter that is too modest. Cut off 2.5 % below as well.",
    ),
    "5 % at either end": (
        lambda: chi_square_interval(2, 50, 0.9),
        "5 % are cut off at either end, which leaves 90 %. For 95 % cut off 2.5 % below and 2.5 % above.",
    ),
    "the sum": (
        lambda: tuple(np.multiply(chi_square_interval(2, 50), 50)),
        "Those are the limits of the sum of 50 runs; the average was asked for, so divide by 50.",
    ),
    "n forgotten": (
        lambda: chi_square_interval(1, 50),
        "These limits lie about 1, so they belong to a single state. Two states bring 2 · 50 degrees of freedom.",
    ),
    "one run": (
        lambda: chi_square_interval(2, 1),
        "Those are the limits for a single run. Averages of 50 scatter far less: 50 · 2 degrees of freedom, divided by 50.",
    ),
    "divided by n as well": (
        lambda: tuple(np.divide(chi_square_interval(2, 50), 2)),
        "These limits are about 1: those of NEES/n, divided by n too. NEES itself averages n = 2.",
    ),
    "four states": (
        lambda: chi_square_interval(4, 50),
        "That is the ship's interval, n = 4. This filter has two states.",
    ),
    "a bell": (
        lambda: (2 - 1.96 * np.sqrt(4 / 50), 2 + 1.96 * np.sqrt(4 / 50)),
        "That is 2 ± 1.96 · 2/√50, a normal distribution with the right mean and variance. Near, but chi-square is lopsided: take its own quantiles.",
    ),
    "arguments swapped": (
        lambda: chi_square_interval(50, 2),
        "The sum of 50 runs is divided by 2 here, and the average of 50 runs by 50. In `chi_square_interval` `dof` is the number of states, `runs` the number of runs.",
    ),
    "degrees of freedom of the runs alone": (
        lambda: tuple(np.multiply(chi_square_interval(1, 50), 50) / 100),
        "The 50 runs have 50 · 2 degrees of freedom, and the sum is divided by the 50 runs only.",
    ),
    "a narrow bell": (
        lambda: (2 - 1.96 / np.sqrt(50), 2 + 1.96 / np.sqrt(50)),
        "That is 2 ± 1.96/√50, as if a single NEES had variance 1. With two states it is 4, and the distribution is lopsided: take chi-square's own quantiles.",
    ),
    "seconds as runs": (
        lambda: chi_square_interval(2, 50 * 79),
        "Those are the limits for 50 · 79 runs, one for each second of 50 voyages. Within a run neighbouring errors are alike, so the average over 50 runs is that of 50 independent values.",
    ),
    "99 %": (
        lambda: chi_square_interval(2, 50, 0.99),
        "That interval holds 99 % of the averages; it should hold 95 %.",
    ),
    "90 % of twice": (
        lambda: chi_square_interval(2, 100),
        "Those are the limits for 100 runs. 50 · 2 are the degrees of freedom; the runs are 50.",
    ),
    "a bell, 2σ": (
        lambda: (2 - 4 / np.sqrt(50), 2 + 4 / np.sqrt(50)),
        "That is 2 ± 2 · 2/√50, ±2σ of a bell shape. The distribution is lopsided: take chi-square's own quantiles.",
    ),
    "one run, divided": (
        lambda: tuple(np.divide(chi_square_interval(2, 1), 50)),
        "Those are the limits for one run, divided by 50. The sum of 50 has a distribution of its own, with 50 · 2 degrees of freedom.",
    ),
    "their distance": (
        lambda: (2.0, 2.0),
        "2 is what the average should be. Chance moves it: between which limits?",
    ),
    "79 seconds": (
        lambda: chi_square_interval(2, 79),
        "79 is the number of seconds of the ship's voyage. Here the average is over 50 runs.",
    ),
}
