"""Lesson 7: is the filter honest?"""

import numpy as np

from kflearn import chi_square_interval
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "The sum of 50 NEES values of a filter with two states follows a chi-square law. With how many degrees of freedom?",
        "With 50 · 2 = 100. Cut off 2.5 % at either end of that law, and remember that the average was asked for.",
        "chi2.ppf([0.025, 0.975], 100) / 50, or chi_square_interval(dof=2, runs=50).",
    ],
    wrong={
        "one-sided": (
            lambda: (0.0, chi_square_interval(2, 50, 0.9)[1]),
            "Your interval has one end only: it would pass every filter that is too modest. Cut off 2.5 % below as well.",
        ),
        "5 % at either end": (
            lambda: chi_square_interval(2, 50, 0.9),
            "You cut off 5 % at either end, which leaves 90 %. For 95 % cut off 2.5 % below and 2.5 % above.",
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
            "You divided by n too: these are limits for NEES/n, about 1. NEES itself averages n = 2.",
        ),
        "four states": (
            lambda: chi_square_interval(4, 50),
            "That is the ship's interval, n = 4. This filter has two states.",
        ),
        "a bell": (
            lambda: (2 - 1.96 * np.sqrt(4 / 50), 2 + 1.96 * np.sqrt(4 / 50)),
            "You took a bell with the right mean and variance. Near, but the chi-square law is lopsided: take its own quantiles.",
        ),
    },
    rtol=5e-3,
)
def interval():
    """The two-sided 95 % interval of the NEES of a filter with two states, averaged over 50 runs."""
    return chi_square_interval(dof=2, runs=50)


def errors_and_claims(rng):
    """An error of two or three components, and a covariance with correlations."""
    n = int(rng.integers(2, 4))
    factor = rng.integers(-2, 3, (n, n)) + 3 * np.eye(n)
    return rng.integers(-6, 7, n) / 2 + 0.25, factor @ factor.T


@exercise(
    hints=[
        "eᵀ P⁻¹ e is one number. Begin at the right: what is P⁻¹ e?",
        "`np.linalg.solve(P, e)` is P⁻¹ e, without forming an inverse. Then multiply by e once more and add up.",
        "return e @ np.linalg.solve(P, e)",
    ],
    inputs=errors_and_claims,
    wrong={
        "without P": (
            lambda e, P: e @ e,
            "That is the squared error alone. It is not normalised: the claim P has not been asked for its opinion.",
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
            "1 / P divides entry by entry; the inverse of a matrix is something else. np.linalg.solve(P, e) is P⁻¹ e.",
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
    },
)
def nees(e, P):
    """The normalised estimation error squared of an error e (n,) with the claimed covariance P (n, n)."""
    return e @ np.linalg.solve(P, e)


@exercise(
    hints=[
        "Take the sign of the neighbours first. Positive: surprised on the same side again, the filter lags. Negative: it overreacts.",
        "Negative, so the gain is too large. Two of the four make it so. Which of them claims too much uncertainty, NIS < m?",
        "A gain is too large when Q is too large or R too small. The first widens every claim, the second narrows it.",
    ],
    wrong={
        "Q too small": (
            "Q too small",
            "With Q too small the gain is too small: neighbours would be alike, with a plus sign, and NIS above 2.",
        ),
        "R too large": (
            "R too large",
            "R too large agrees with NIS below 2. But it makes the gain too small, and neighbours alike: look at the sign.",
        ),
        "R too small": (
            "R too small",
            "R too small agrees with the minus sign. But then the filter would be far too sure, with NIS well above 2.",
        ),
    },
)
def mystery():
    """NIS 1.85 where 2 is honest, neighbouring innovations negatively correlated: Q or R, too small or too large?"""
    return "Q too large"


def errors_and_variances(rng):
    """Sixty errors, each with a variance of its own."""
    P = rng.uniform(0.05, 6, 60)
    return rng.normal(0, 1.3 * np.sqrt(P)), P


@exercise(
    hints=[
        "e is in °C or m. In which unit is P? Can the two be compared?",
        "P is a variance, in °C² or m². The half-width of a ±1σ band is the standard deviation.",
        "return np.mean(abs(e) <= np.sqrt(P))",
    ],
    inputs=errors_and_variances,
    wrong={
        "as published": (
            lambda e, P: np.mean(abs(e) <= P),
            "That is still the published band: it compares metres with square metres. Where P > 1 it is too wide, else too narrow.",
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
            "Now the error is squared and the claim is not. Compare |e| with √P, or e² with P.",
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
    },
)
def share_inside(e, P):
    """The share of the errors e inside the band ±1σ, when the variances P are claimed for them."""
    return np.mean(abs(e) <= np.sqrt(P))


def start_beliefs(rng):
    """A mean, the diagonal of P₀, and standard normal numbers."""
    n = int(rng.integers(2, 5))
    return rng.integers(-100, 200, n).astype(float), rng.integers(4, 40, n) / 2, rng.normal(size=n).round(2)


@exercise(
    hints=[
        "Standard normal numbers scatter with σ = 1 about 0. You want σ = √variance about the mean.",
        "Stretch first, then shift. By what is a number stretched when its variance is to be 9 instead of 1?",
        "`return mean + np.sqrt(variances) * normal`",
    ],
    inputs=start_beliefs,
    wrong={
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
    },
)
def draw_start(mean, variances, normal):
    """A start drawn from N(mean, diag(variances)), made of standard normal random numbers."""
    return mean + np.sqrt(variances) * normal
