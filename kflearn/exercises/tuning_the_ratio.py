"""Lesson 6: tuning the ratio."""

import math

import numpy as np

from kflearn.exercises.engine import exercise


def balance(Q, R):
    """The steady gain of the scalar random walk."""
    q = Q / R
    return (math.sqrt(q**2 + 4 * q) - q) / 2


@exercise(
    hints=[
        "First the ratio q = Q/R, then the gain at the balance, then the variance, and last its root.",
        "q = 0.04. K solves K² + qK − q = 0, and the variance after a reading is K·R.",
        "K = (√(0.0016 + 0.16) − 0.04)/2 = 0.1810; P = 0.1810 · 0.25 = 0.04525 °C²; σ = √P = 0.2127 °C.",
    ],
    wrong={
        "variance": (
            lambda: balance(0.01, 0.25) * 0.25,
            "That is the variance P = K·R, in °C². The question asks for σ, its root.",
        ),
        "gain": (lambda: balance(0.01, 0.25), "That is the gain K, a pure number. Go on: P = K·R, then the root."),
        "before the reading": (
            lambda: math.sqrt(balance(0.01, 0.25) * 0.25 + 0.01),
            "That is √(P + Q), what the filter claims before the next reading; after it, it is √P with P = K·R.",
        ),
        "√(KQ)": (
            lambda: math.sqrt(balance(0.01, 0.25) * 0.01),
            "You multiplied the gain with Q. At the balance P = K·R: (9) with the K of (7).",
        ),
        "forgotten memory": (
            lambda: math.sqrt(0.01 * 0.25 / 0.26),
            "You fused Q with R, as if the filter knew nothing from before. What was left over is still there: P⁻ = P + Q.",
        ),
        "ratio upside down": (
            lambda: math.sqrt(balance(0.25, 0.01) * 0.25),
            "Your ratio is upside down: q = Q/R = 0.04, not 25.",
        ),
        "R alone": (0.5, "That is the thermometer alone, √R. The filter remembers earlier readings and does better."),
    },
    unit="°C",
)
def steady_sigma():
    """The standard deviation a random-walk filter with Q = 0.01 °C² and R = 0.25 °C² comes to claim."""
    q = 0.01 / 0.25
    K = (math.sqrt(q**2 + 4 * q) - q) / 2
    return math.sqrt(K * 0.25)


@exercise(
    hints=[
        "For each sheet first σ, then its square. (c) has hard limits: how far can a rounded reading be from the truth?",
        "(a) gives σ itself. In (b) the limit is 2σ. In (c) the error lies anywhere within ±a with a = a quarter of a volt, "
        "and σ = a/√3.",
        "(a) 2.5² = 6.25 m²; (b) 0.3² = 0.09 °C²; (c) 0.25²/3 = 0.0208 V².",
    ],
    wrong={
        "σ for σ²": (
            (2.5, 0.3, 0.25 / math.sqrt(3)),
            "Three right standard deviations. R is a variance: square each of them.",
        ),
        "limits squared": (
            (6.25, 0.36, 0.0625),
            "You squared the numbers of the sheets as they stand. (a) is right; (b) is 2σ, and (c) a hard limit: σ = a/√3.",
        ),
        "95 % taken for 1σ": (
            (6.25, 0.36, 0.25**2 / 3),
            "(a) and (c) are right. In (b), 95 % of readings lie within 2σ, so σ is half of 0.6 °C.",
        ),
        "95 % taken for 3σ": (
            (6.25, 0.04, 0.25**2 / 3),
            "(a) and (c) are right. In (b) you divided by 3; within 3σ lie 99.7 % of readings, within 2σ 95 %.",
        ),
        "halved after squaring": (
            (6.25, 0.18, 0.25**2 / 3),
            "(a) and (c) are right. In (b) halve first, then square: (0.6/2)², not 0.6²/2.",
        ),
        "whole step as limit": (
            (6.25, 0.09, 0.5**2 / 3),
            "(a) and (b) are right. In (c), rounding to the nearest half volt errs by a quarter of a volt at most: a = 0.25 V.",
        ),
        "limit as σ": (
            (6.25, 0.09, 0.0625),
            "(a) and (b) are right. In (c), 0.25 V is the largest error there can be; most are smaller: σ = a/√3.",
        ),
        "limit as 2σ": (
            (6.25, 0.09, 0.25**2 / 4),
            "(a) and (b) are right. In (c) you took the limit for 2σ; a rounding error lies anywhere within it with equal chance: σ = a/√3.",
        ),
        "limit as 3σ": (
            (6.25, 0.09, 0.25**2 / 9),
            "(a) and (b) are right. In (c) you took the limit for 3σ; a rounding error lies anywhere within it with equal chance: σ = a/√3.",
        ),
        "√3 not squared": (
            (6.25, 0.09, 0.25**2 / math.sqrt(3)),
            "(a) and (b) are right. In (c) the √3 is squared too: R = a²/3.",
        ),
    },
    rtol=1e-2,
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
    wrong={
        "Q up": (
            "A",
            "A larger Q changes the ratio, and so the estimate, which is nearly the best already. Only the band needs mending.",
        ),
        "R up": (
            "B",
            "A larger R widens the band, but it changes the ratio too: the estimate becomes late. Keep Q/R.",
        ),
        "both down": ("D", "That makes the band narrower still. The claim, 0.09 V, is too small already."),
        "P₀ up": ("E", "P₀ is forgotten after a few readings; the claim settles at √(K·R) whatever the start was."),
    },
)
def which_knob():
    """rms 0.27 V, best possible 0.26 V, claimed 0.09 V: what to do?"""
    return "C"


def recordings_at_rest(rng):
    """Readings of a source at rest."""
    return (rng.uniform(5, 20) + rng.uniform(0.2, 2) * rng.standard_normal(300),)


@exercise(
    hints=[
        "What is R, in one word? And what is the number that `np.std` gives?",
        "R is the variance of the noise. At three sigmas the squared number is nine times the variance.",
        "return np.var(at_rest)",
    ],
    inputs=recordings_at_rest,
    rtol=5e-3,
    wrong={
        "as published": (
            lambda at_rest: (3 * np.std(at_rest)) ** 2,
            "That is the published R again, nine times too large: a bound for the worst reading is no variance.",
        ),
        "3σ²": (
            lambda at_rest: 3 * np.var(at_rest),
            "Still three times too large. R is σ² itself; no 3 belongs in it.",
        ),
        "σ": (lambda at_rest: np.std(at_rest), "That is σ. R is a variance, σ²."),
        "3σ": (lambda at_rest: 3 * np.std(at_rest), "That is 3σ, a length on the volt axis. R is σ², in V²."),
        "(σ/3)²": (
            lambda at_rest: np.var(at_rest) / 9,
            "Now R is nine times too small. σ was measured here, not read off a sheet with 3σ on it: no 3 is needed.",
        ),
        "mean square": (
            lambda at_rest: np.mean(np.square(at_rest)),
            "You took the mean of the squares, with the 12 V or so still in it. Take off the mean first, as np.var does.",
        ),
        "differences": (
            lambda at_rest: np.mean(np.diff(at_rest) ** 2) / 2,
            "Sound, and what the next exercise wants; but this source rests, and the plain variance uses the readings better.",
        ),
        "differences, not halved": (
            lambda at_rest: np.mean(np.diff(at_rest) ** 2),
            "A difference holds two noises, so this is twice too large; and at rest the plain variance is enough.",
        ),
    },
)
def three_sigma(at_rest):
    """R from readings of a source at rest, which a published text takes as (3σ)²."""
    return np.var(at_rest)


def drifting_recordings(rng):
    """Readings of a source that drifts by a few σ, up and down, in 400 readings."""
    sigma = rng.uniform(0.2, 2)
    drift = rng.uniform(1.5, 4) * sigma * np.sin(np.linspace(0, 2 * np.pi, 400) + rng.uniform(0, 2 * np.pi))
    return (rng.uniform(5, 20) + drift + sigma * rng.standard_normal(400),)


@exercise(
    hints=[
        "Between two neighbours the drift is tiny, so their difference is nearly all noise. Whose noise?",
        "z₂ − z₁ holds two independent noises: its variance is 2R. `np.diff` gives all differences of neighbours.",
        "`return np.mean(np.diff(readings) ** 2) / 2`",
    ],
    inputs=drifting_recordings,
    rtol=1e-2,
    wrong={
        "variance": (
            lambda readings: np.var(readings),
            "The plain variance takes the drift for noise. Look at the differences of neighbours, in which it hardly shows.",
        ),
        "not halved": (
            lambda readings: np.mean(np.diff(readings) ** 2),
            "Nearly: a difference holds the noise of two readings, so its mean square is 2R. Halve it.",
        ),
        "half of σ": (
            lambda readings: (np.std(np.diff(readings)) / 2) ** 2,
            "You halved before squaring. The variance of a difference is 2R, so its σ is √2 times the meter's, not 2 times.",
        ),
        "standard deviation": (
            lambda readings: np.sqrt(np.mean(np.diff(readings) ** 2) / 2),
            "That is the meter's σ. R is its square.",
        ),
        "σ of the differences": (
            lambda readings: np.std(np.diff(readings)),
            "That is the σ of a difference. R is a variance, and a difference holds two noises.",
        ),
        "mean of the differences": (
            lambda readings: np.mean(np.diff(readings)),
            "That is the drift for each reading: the noises cancel. Square the differences before you take their mean.",
        ),
        "straight line removed": (
            lambda readings: np.var(
                readings - np.polyval(np.polyfit(range(len(readings)), readings, 1), range(len(readings)))
            ),
            "You removed a straight line, but this drift is not straight. Differences of neighbours need no shape for it.",
        ),
        "second half only": (
            lambda readings: np.var(readings[len(readings) // 2 :]),
            "Half of the drift is still in there. Differences of neighbours hold next to none of it.",
        ),
    },
)
def R_with_drift(readings):
    """R from readings of a source that drifts slowly."""
    return np.mean(np.diff(readings) ** 2) / 2
