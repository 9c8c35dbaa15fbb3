"""Lesson 7: is the filter honest?"""

import numpy as np

from kflearn import chi_square_interval
from kflearn.exercises._hints import of_choice
from kflearn.exercises._judge import inside, rms, track
from kflearn.exercises._judge import nees as nees_of_all
from kflearn.exercises._slips import is_the_filter_honest as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises._unknown_receiver import FAILING, PASSING, honest_share, look, recording
from kflearn.exercises.engine import Mark, exercise, judged


@exercise(
    hints=[
        "The sum of 50 NEES values of a filter with two states follows a chi-square distribution. With how many degrees of freedom?",
        "With 50 · 2 = 100. Cut off 2.5 % at either end of that distribution, and remember that the average was asked for.",
        "chi2.ppf([0.025, 0.975], 100) / 50, or chi_square_interval(dof=2, runs=50).",
    ],
    wrong=slips.interval.WRONG,
    otherwise=slips.interval.of_interval,
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
    inputs=in_turn(errors_and_claims, 2, 3, 4, 2, 1),
    wrong=slips.nees.WRONG,
    then="It has no unit: give e in centimetres and P in cm², and the number stays the same.",
)
def nees(e, P):
    """The normalised estimation error squared of an error e (n,) with the claimed covariance P (n, n)."""
    return e @ np.linalg.solve(P, e)


@exercise(
    hints=[
        "Take the sign of the neighbours first. Positive: one innovation is followed by another on the same side, because the filter lags. Negative: it moves too far each time.",
        of_choice(
            {
                "r too large": "NIS below 2 you have used. Now use the sign: does R too large make the gain too large or too small?",
                "r too small": "The sign you have used. Now use the NIS: does R too small make the claims too large or too small?",
                "q too small": "Look at both clues again: is this filter too sure or too modest, is its gain too small or too large?",
            },
            "Make two columns, as in the lesson's table: what does each of the four do to NIS, what to the gain?",
        ),
        "Negative, so the gain is too large. Two of the four make it so. Which of them claims too much uncertainty, NIS < m?",
        "A gain is too large when Q is too large or R too small. The first widens every claim, the second narrows it.",
    ],
    wrong=slips.mystery.WRONG,
    otherwise=slips.mystery.MYSTERY,
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
    inputs=in_turn(errors_and_variances, 5, 12, 60, 7),
    wrong=slips.share_inside.WRONG,
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
    inputs=in_turn(start_beliefs, 2, 4, 3, 1),
    wrong=slips.draw_start.WRONG,
    also=[lambda mean, variances, normal: mean - np.sqrt(variances) * normal],
    then="With starts like this the NEES before the first reading is n on average; with the published start it is 0.",
)
def draw_start(mean, variances, normal):
    """A start drawn from N(mean, diag(variances)), made of standard normal random numbers."""
    return mean + np.sqrt(variances) * normal


@judged(
    hints=[
        "The lesson's filter with any R gives innovations. What would their NIS be on average, if R were right?",
        "With R too small the average NIS is above 1, with R too large below 1. Try some R, or multiply R by the average NIS "
        "and run again. Or look at the readings alone: the ship hardly turns in two seconds, so what do second differences hold?",
        "`np.diff(z, 2)` is z₂ − 2z₁ + z₀: its variance is R + 4R + R = 6R, for the ship itself adds hardly anything.",
    ],
    recording=recording,
    marks=[
        Mark(
            "position error (rms)",
            rms(0),
            high=7.5,
            above=look("That is more than a filter with the right R needs."),
            unit="m",
        ),
        Mark(
            "true position inside ±2σ",
            inside(0),
            90,
            98,
            below=look("The claim is too small: a P without an inverse is no covariance."),
            above=look("The claim is too large: fewer would be inside with an honest σ."),
            unit="%",
        ),
        Mark(
            "NEES / n",
            nees_of_all(),
            0.75,
            1.35,
            below=look("Too modest: the squared errors are smaller than claimed."),
            above=look("The claim is too small: a P without an inverse is no covariance."),
        ),
        Mark(
            "recordings whose own NEES / n is between 0.4 and 2.5",
            honest_share(0.4, 2.5),
            low=80,
            below=look(
                "Each recording is judged by itself here: a mean over all can hide that some are too sure and others too modest."
            ),
            unit="%",
        ),
    ],
    form=track(2),
    passing=PASSING,
    failing=FAILING,
    then="R was learnt without the truth, from the readings alone. Could the same have been done for Q?",
)
def unknown_sensor(z):
    """Write a filter `(z) → mean, covariance` that finds out how accurate its sensor is.

    z (100,): readings of a ship's position east in metres, one a second. Their standard deviation is the same through a
    recording, and different in each: anything from 2 to 40 m. The state is position and speed, F = [[1, 1], [0, 1]],
    Q = diag(0.005, 0.01), the start one second before the first reading N([0, 0], diag(50², 5²)). Return the means
    (100, 2) and the covariances (100, 2, 2) after each reading.
    """
    R = np.var(np.diff(z, 2)) / 6
    F, Q, H = np.array([[1, 1], [0, 1]]), np.diag([0.005, 0.01]), np.array([[1.0, 0.0]])
    x, P, means, covs = np.zeros(2), np.diag([50.0**2, 5.0**2]), [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        K = P @ H.T / (H @ P @ H.T + R)
        x, P = x + K @ (reading - H @ x), (np.eye(2) - K @ H) @ P
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)
