"""Wrong answers to exercises of is_the_filter_honest, each with the sentence that it gets."""

import numpy as np

from kflearn import chi_square_interval

WRONG = {
    "interval": {
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
    },
    "nees": {
        "without P": (
            lambda e, P: e @ e,
            "That is the squared error alone. P, what the filter claims, is not used yet: it must divide.",
        ),
        "σ for P": (
            lambda e, P: np.sum(e**2 / np.sqrt(np.diag(P))),
            "You divided squares by standard deviations. A squared error belongs over a variance; and P has covariances too.",
        ),
        "only the diagonal": (
            lambda e, P: np.sum(e**2 / np.diag(P)),
            "You used the variances only. The errors belong together: P⁻¹ takes the covariances beside the diagonal into account.",
        ),
        "P, not its inverse": (
            lambda e, P: e @ P @ e,
            "You multiplied by P. A large claim must make the score small: it is P⁻¹ that stands between the two e.",
        ),
        "entry by entry": (
            lambda e, P: e @ (1 / P) @ e,
            "1 / P, like P ** -1, works entry by entry; the inverse of a matrix is something else. np.linalg.solve(P, e) is P⁻¹ e.",
        ),
        "the root": (
            lambda e, P: np.sqrt(e @ np.linalg.solve(P, e)),
            "You took the root: that is a distance in sigmas. NEES is its square, and only the square follows chi-square.",
        ),
        "divided by n": (
            lambda e, P: e @ np.linalg.solve(P, e) / len(e),
            "You divided by n: that is NEES/n, which averages 1. It is handy in a figure, but NEES averages n.",
        ),
        "not added up": (
            lambda e, P: e * np.linalg.solve(P, e),
            "The pieces are right; add them up: e @ … multiplies and adds in one go.",
        ),
        "a vector": (
            lambda e, P: e @ np.linalg.inv(P),
            "That is P⁻¹ e, one number for each state. Multiply by e once more, with @, and you have one number for all.",
        ),
        "no product": (
            lambda e, P: e**2 / np.diag(P),
            "That is one number for each state, and the covariances are not used. NEES is one number: e stands on both sides of P⁻¹.",
        ),
        "divided by a matrix": (
            lambda e, P: e**2 / P,
            "`/ P` divides by each entry of P and gives a matrix. The inverse of a matrix is something else: np.linalg.solve(P, e) is P⁻¹ e.",
        ),
        "by the trace": (
            lambda e, P: e @ e / np.trace(P),
            "You divided the squared length by the sum of the variances. Each direction has its own variance: use P⁻¹.",
        ),
        "mean over the states": (
            lambda e, P: np.mean(e**2 / np.diag(P)) + 0 * P[0, 0],
            "That is a mean over the states, and the covariances are not used. NEES adds up, with P⁻¹ between two e.",
        ),
        "inverse entry by entry": (
            lambda e, P: e * np.linalg.inv(P) * e,
            "`*` multiplies entry by entry and leaves a matrix. The products with P⁻¹ are matrix products: @.",
        ),
    },
    "share_inside": {
        "as published": (
            lambda e, P: np.mean(abs(e) <= P),
            "That is still the band ±P: it compares metres with square metres. Where P > 1 it is too wide, else too narrow.",
        ),
        "±2σ": (
            lambda e, P: np.mean(abs(e) <= 2 * np.sqrt(P)),
            "The root is right. But that is the band ±2σ, which holds 95.4 %; ±1σ was asked for.",
        ),
        "one side": (
            lambda e, P: np.mean(e <= np.sqrt(P)),
            "You forgot the lower edge: errors far below zero count as inside. Take abs(e).",
        ),
        "e² against σ": (
            lambda e, P: np.mean(e**2 <= np.sqrt(P)),
            "That is e² against √P. Compare |e| with √P, or e² with P.",
        ),
        "P²": (
            lambda e, P: np.mean(abs(e) <= P**2),
            "You squared the variance; the standard deviation is its root.",
        ),
        "a count": (
            lambda e, P: np.sum(abs(e) <= np.sqrt(P)),
            "The band is right, and you counted those inside. A share is that count divided by how many there are: np.mean.",
        ),
        "outside": (
            lambda e, P: np.mean(abs(e) > np.sqrt(P)),
            "The band is right, but that is the share outside.",
        ),
        "per cent": (
            lambda e, P: 100 * np.mean(abs(e) <= np.sqrt(P)),
            "The band is right. Leave the share between 0 and 1: the format `.1%` makes per cent of it.",
        ),
        "not averaged": (
            lambda e, P: abs(e) <= np.sqrt(P),
            "The comparison is right. It says True or False for each error; the share of True is their mean.",
        ),
        "one σ": (
            lambda e, P: np.mean(abs(e) <= np.sqrt(np.mean(P))),
            "You compare all errors with one σ. Each error has a variance of its own: take its root, entry by entry.",
        ),
        "1": (
            lambda e, P: np.mean(abs(e) <= 1),
            "You compare with 1, whatever is claimed. ±1σ means: one standard deviation, which is the root of P.",
        ),
        "scatter of the errors": (
            lambda e, P: np.mean(abs(e) <= np.std(e)),
            "You compare with the scatter of the errors themselves. The question is about what was claimed: the variances P.",
        ),
        "1.96 σ": (
            lambda e, P: np.mean(abs(e) <= 1.96 * np.sqrt(P)),
            "The root is right. 1.96 σ is the band that holds 95 %; ±1σ was asked for.",
        ),
        "3 σ": (
            lambda e, P: np.mean(abs(e) <= 3 * np.sqrt(P)),
            "The root is right. But that is the band ±3σ; ±1σ was asked for.",
        ),
        "published, one side": (
            lambda e, P: np.mean(e <= P),
            "Two faults: P is a variance, its root belongs here; and without abs(e) all errors below count as inside.",
        ),
    },
    "draw_start": {
        "as published": (
            lambda mean, variances, normal: mean,
            "That is the published start: every run begins where the filter believes, and P₀ is an empty claim.",
        ),
        "variance for σ": (
            lambda mean, variances, normal: mean + variances * normal,
            "You stretched by the variance, so the start scatters with variance². Stretch by its root.",
        ),
        "P₀ = I": (
            lambda mean, variances, normal: mean + normal,
            "That is right for P₀ = I only: the variances are not used yet.",
        ),
        "no chance": (
            lambda mean, variances, normal: mean + np.sqrt(variances),
            "Every run would start one σ away, on the same side. Multiply σ by the random numbers.",
        ),
        "no mean": (
            lambda mean, variances, normal: np.sqrt(variances) * normal,
            "The scatter is right, but about zero; it belongs about the mean.",
        ),
        "divided": (
            lambda mean, variances, normal: mean + normal / np.sqrt(variances),
            "You divided by σ: that makes a number standard normal. Here it goes the other way.",
        ),
        "one number for all": (
            lambda mean, variances, normal: mean + np.sqrt(variances) @ normal,
            "All states are moved by the same number, the sum of the products, as `@` makes it. Multiply entry by entry, with `*`.",
        ),
        "the same number for all": (
            lambda mean, variances, normal: mean + np.sqrt(variances) * normal[0],
            "All states share one random number, so they are always wrong together. Each has a number of its own.",
        ),
        "variance squared": (
            lambda mean, variances, normal: mean + variances**2 * normal,
            "You squared the variances; σ is their root.",
        ),
        "mean stretched too": (
            lambda mean, variances, normal: mean * np.sqrt(variances) * normal,
            "You multiplied the mean as well. The mean shifts the scatter, it is added.",
        ),
        "shifted first": (
            lambda mean, variances, normal: (mean + normal) * np.sqrt(variances),
            "You shifted first and stretched afterwards, so the mean was stretched too. First stretch, then add the mean.",
        ),
        "2σ": (
            lambda mean, variances, normal: mean + 2 * np.sqrt(variances) * normal,
            "Twice too wide: a standard normal number times σ has the standard deviation σ already.",
        ),
    },
}
