"""Lesson 7: is the filter honest?"""

import numpy as np

from kflearn import chi_square_interval
from kflearn.exercises._is_the_filter_honest import WRONG
from kflearn.exercises._turns import sized
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "The sum of 50 NEES values of a filter with two states follows a chi-square distribution. With how many degrees of freedom?",
        "With 50 · 2 = 100. Cut off 2.5 % at either end of that distribution, and remember that the average was asked for.",
        "chi2.ppf([0.025, 0.975], 100) / 50, or chi_square_interval(dof=2, runs=50).",
    ],
    wrong=WRONG["interval"],
    rtol=5e-3,
    then="Runs pay off slowly: with 1,000 of them the limits are 1.88 and 2.13, so smaller faults are found.",
)
def interval():
    """The two-sided 95 % interval of the NEES of a filter with two states, averaged over 50 runs."""
    return chi_square_interval(dof=2, runs=50)


def errors_and_claims(rng, n):
    """An error of n components, and a covariance with correlations."""
    factor = rng.integers(-2, 3, (n, n)) + 3 * np.eye(n)
    return rng.integers(-6, 7, n) / 2 + 0.25, factor @ factor.T + np.eye(n)


@exercise(
    hints=[
        "eᵀ P⁻¹ e is one number. Begin at the right: what is P⁻¹ e?",
        "`np.linalg.solve(P, e)` is P⁻¹ e, without forming an inverse. Then multiply by e once more and add up.",
        "return e @ np.linalg.solve(P, e)",
    ],
    inputs=sized(errors_and_claims, 2, 3, 4, 2, 1),
    wrong=WRONG["nees"],
    then="It has no unit: give e in centimetres and P in cm², and the number stays the same.",
)
def nees(e, P):
    """The normalised estimation error squared of an error e (n,) with the claimed covariance P (n, n)."""
    return e @ np.linalg.solve(P, e)


@exercise(
    hints=[
        "Take the sign of the neighbours first. Positive: one innovation is followed by another on the same side, because the filter lags. Negative: it moves too far each time.",
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
    then="NIS below 2 says that the filter claims too large an error; the minus sign, that its gain is too large. "
    "Of the four, only a Q that is too large does both.",
)
def mystery():
    """NIS 1.85 where 2 is honest, neighbouring innovations negatively correlated: Q or R, too small or too large?"""
    return "Q too large"


def errors_and_variances(rng, count):
    """Some errors, each with a variance of its own; none lies just on the edge of its band."""
    P = rng.integers(1, 60, count) / 10
    return rng.normal(0, 1.3 * np.sqrt(P)).round(1) + 0.05, P


@exercise(
    hints=[
        "e is in °C or m. In which unit is P? Can the two be compared?",
        "P is a variance, in °C² or m². The half-width of a ±1σ band is the standard deviation.",
        "return np.mean(abs(e) <= np.sqrt(P))",
    ],
    inputs=sized(errors_and_variances, 5, 12, 60, 7),
    wrong=WRONG["share_inside"],
    then="Of one number 68.3 % should be inside. Of a state with two components only 39 % belong inside its 1σ ellipse: why fewer?",
)
def share_inside(e, P):
    """The share of the errors e inside the band ±1σ, when the variances P are claimed for them."""
    return np.mean(abs(e) <= np.sqrt(P))


def start_beliefs(rng, n):
    """A mean, the diagonal of P₀, and standard normal numbers."""
    return rng.integers(-100, 200, n).astype(float), rng.integers(4, 40, n) / 2, rng.normal(size=n).round(2)


@exercise(
    hints=[
        "Standard normal numbers scatter with σ = 1 about 0. You want σ = √variance about the mean.",
        "Stretch first, then shift. By what is a number stretched when its variance is to be 9 instead of 1?",
        "`return mean + np.sqrt(variances) * normal`",
    ],
    inputs=sized(start_beliefs, 2, 4, 3, 1),
    wrong=WRONG["draw_start"],
    then="With starts like this the NEES before the first reading is n on average; with the published start it is 0.",
)
def draw_start(mean, variances, normal):
    """A start drawn from N(mean, diag(variances)), made of standard normal random numbers."""
    return mean + np.sqrt(variances) * normal
