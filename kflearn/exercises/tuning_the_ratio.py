"""Lesson 6: tuning the ratio."""

import math

import numpy as np

from kflearn.exercises._hints import is_about
from kflearn.exercises._slips import tuning_the_ratio as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        lambda last: (
            "You have the variance. Which number is in °C?"
            if is_about(last, 0.04525)
            else "First the ratio q = Q/R, then the gain at the balance, then the variance, and last its root."
        ),
        "q = 0.04. K solves K² + qK − q = 0, and the variance after a reading is K·R.",
        "K = (√(0.0016 + 0.16) − 0.04)/2 = 0.1810; P = 0.1810 · 0.25 = 0.04525 °C²; σ = √P = 0.2127 °C.",
    ],
    wrong=slips.steady_sigma.WRONG,
    unit="°C",
    otherwise=slips.steady_sigma.of_sigma,
    then="The filter claims ±0.43 °C (two sigmas), where the thermometer alone has ±1 °C.",
)
def steady_sigma():
    """The standard deviation a random-walk filter with Q = 0.01 °C² and R = 0.25 °C² comes to claim."""
    ratio = 0.01 / 0.25
    gain = (math.sqrt(ratio**2 + 4 * ratio) - ratio) / 2
    return math.sqrt(gain * 0.25)


@exercise(
    hints=[
        "For each sheet first σ, then its square. (c) has hard limits: how far can a rounded reading be from the truth?",
        "(a) gives σ itself. In (b) the limit is 2σ. In (c) the error lies anywhere within ±a with a = a quarter of a volt, "
        "and σ = a/√3.",
        "(a) 2.5² = 6.25 m²; (b) 0.3² = 0.09 °C²; (c) 0.25²/3 = 0.0208 V².",
    ],
    wrong=slips.data_sheets.WRONG,
    rtol=5e-3,
    otherwise=slips.data_sheets.sheet_by_sheet,
    then="With 1.96 in place of 2, (b) is 0.0937 °C², which is right as well. The σ of the rounding, 0.144 V, is less than a third of the step.",
    also=[(2.5**2, (0.6 / 1.96) ** 2, 0.25**2 / 3)],
)
def data_sheets():
    """R for "2.5 m, one sigma", for "±0.6 °C, 95 %", and for rounding to half volts, in m², °C² and V²."""
    return 2.5**2, (0.6 / 2) ** 2, 0.25**2 / 3


@exercise(
    hints=[
        "Two numbers are to be judged separately: the rms against the best possible, and the claim against the rms.",
        "The estimate is nearly as good as it can be, so leave the line alone. What may move the band and not the line?",
        "The ratio must stay. The claim is three times too small, so Q and R are nine times too small.",
    ],
    wrong=slips.which_knob.WRONG,
    otherwise=slips.which_knob.KNOB,
    then="Q and R multiplied by the same factor leave the gain as it was, and so the line; σ grows by the root of the factor. Nine times both turns 0.09 V into 0.27 V.",
)
def which_knob():
    """rms 0.27 V, best possible 0.26 V, claimed 0.09 V: what to do?"""
    return "C"


def recordings_at_rest(rng, n):
    """Readings of a source at rest."""
    return (rng.uniform(5, 20) + rng.uniform(0.2, 2) * rng.standard_normal(n),)


@exercise(
    hints=[
        "What is R, in one word? And what is the number that `np.std` gives?",
        "R is the variance of the noise. At three sigmas the squared number is nine times the variance.",
        "`return np.var(at_rest)`",
    ],
    inputs=in_turn(recordings_at_rest, 250, 400, 1000),
    rtol=5e-3,
    wrong=slips.three_sigma.WRONG,
    then="With R nine times too large the gain at Q = R falls from 0.62 to 0.28, and the estimate comes late.",
)
def three_sigma(at_rest):
    """R from readings of a source at rest, which a published text takes as (3σ)²."""
    return np.var(at_rest)


def drifting_recordings(rng, n):
    """Readings of a source that drifts by a few σ, up and down, in n readings."""
    sigma = rng.uniform(0.2, 2)
    drift = rng.uniform(1.5, 4) * sigma * np.sin(np.linspace(0, 2 * np.pi, n) + rng.uniform(0, 2 * np.pi))
    return (rng.uniform(5, 20) + drift + sigma * rng.standard_normal(n),)


@exercise(
    hints=[
        "Between two neighbours the drift is tiny, so their difference is nearly all noise. Whose noise?",
        "z₂ − z₁ holds two independent noises: its variance is 2R. `np.diff` gives all differences of neighbours.",
        "`return np.mean(np.diff(readings) ** 2) / 2`",
    ],
    inputs=in_turn(drifting_recordings, 300, 400, 900),
    rtol=7e-3,
    also=[
        lambda readings: np.mean(np.diff(readings, n=2) ** 2) / 6,
        lambda readings: np.mean(np.diff(readings, n=3) ** 2) / 20,
        lambda readings: np.mean(abs(np.diff(readings))) ** 2 * np.pi / 4,
        lambda readings: (1.4826 * np.median(abs(np.diff(readings)))) ** 2 / 2,
    ],
    wrong=slips.R_with_drift.WRONG,
    then="It works as long as the drift from one reading to the next is small beside the noise. What would a sudden step of the source do to it?",
)
def R_with_drift(readings):
    """R from readings of a source that drifts slowly."""
    return np.mean(np.diff(readings) ** 2) / 2
