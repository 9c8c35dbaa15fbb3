"""Wrong answers to exercises of lesson 6, each with the sentence that it gets."""

import math

import numpy as np


def balance(Q, R):
    """The steady gain of the scalar random walk."""
    q = Q / R
    return (math.sqrt(q**2 + 4 * q) - q) / 2


WRONG = {
    "steady_sigma": {
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
            "0.098 °C is less than the filter can know. Did you exchange Q and R, or fuse Q with R alone? R = 0.25 belongs to the thermometer, and what was left over counts too: P⁻ = P + Q.",
        ),
        "ratio upside down": (
            lambda: math.sqrt(balance(0.25, 0.01) * 0.25),
            "Your ratio is upside down: q = Q/R = 0.04, not 25.",
        ),
        "R alone": (0.5, "That is the thermometer alone, √R. The filter remembers earlier readings and does better."),
        "sum": (
            lambda: math.sqrt(0.26),
            "You added Q and R. The filter's variance is smaller than that of a single reading, not larger.",
        ),
        "K σ": (
            lambda: balance(0.01, 0.25) * 0.5,
            "You multiplied the gain by σ. It is the variance that is K·R: take the root after that.",
        ),
        "√K": (lambda: math.sqrt(balance(0.01, 0.25)), "You took the root of the gain. First multiply by R: P = K·R."),
        "√Q": (
            0.1,
            "0.1 °C is √Q, what the temperature wanders in a minute. What the filter knows of it also depends on R.",
        ),
        "P before": (
            lambda: balance(0.01, 0.25) * 0.25 + 0.01,
            "That is P⁻ = P + Q, a variance, before the reading. The question asks for σ after it.",
        ),
    },
    "data_sheets": {
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
        "(a) not squared": (
            lambda: (2.5, 0.09, 0.25**2 / 3),
            "(b) and (c) are right. In (a) the sheet gives σ; R is its square.",
        ),
        "(a) halved": (
            lambda: (1.25**2, 0.09, 0.25**2 / 3),
            "(b) and (c) are right. In (a) the sheet says one sigma: 2.5 m is σ already.",
        ),
        "(b) not squared": (
            lambda: (6.25, 0.3, 0.25**2 / 3),
            "(a) and (c) are right. In (b) you have σ; R is its square.",
        ),
        "(c) not squared": (
            lambda: (6.25, 0.09, 0.25 / math.sqrt(3)),
            "(a) and (b) are right. In (c) you have σ; R is its square.",
        ),
        "(c) the limit itself": (
            (6.25, 0.09, 0.25),
            "(a) and (b) are right. In (c) the error is never larger than a = 0.25 V, half of a step. The variance is neither a nor the step squared: it is a²/3.",
        ),
        "(c) the step squared": (
            (6.25, 0.09, 0.125),
            "(a) and (b) are right. In (c) the limit is a = 0.25 V, half of a step, and the variance is a²/3.",
        ),
    },
    "three_sigma": {
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
        "(2σ)²": (
            lambda at_rest: (2 * np.std(at_rest)) ** 2,
            "You put 2σ in place of 3σ. No factor belongs in R: it is σ² itself.",
        ),
        "the sum": (
            lambda at_rest: np.sum((at_rest - np.mean(at_rest)) ** 2),
            "That is the sum of the squared distances. Divide it by their number.",
        ),
        "the range": (
            lambda at_rest: (np.ptp(at_rest) / 6) ** 2,
            "You took the range for six sigmas. How far apart the two extremes lie depends on how many readings there are: use all of them.",
        ),
        "half": (
            lambda at_rest: np.mean(abs(at_rest - np.mean(at_rest))) ** 2,
            "You squared the mean distance. Square each distance first, then take the mean.",
        ),
    },
    "R_with_drift": {
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
        "σ of the differences, halved": (
            lambda readings: np.std(np.diff(readings)) / 2,
            "That is half the σ of a difference. Work with squares: the mean *square* of a difference is 2R.",
        ),
        "not squared": (
            lambda readings: np.mean(np.diff(readings)) / 2,
            "You did not square the differences: positive and negative ones cancel. Square first, then take the mean.",
        ),
        "sum": (lambda readings: np.sum(np.diff(readings) ** 2) / 2, "You added the squares up. Take their mean."),
        "absolute": (
            lambda readings: np.mean(abs(np.diff(readings))) / 2,
            "That is a mean distance, in volts. R is in V²: square the differences before you take the mean.",
        ),
        "published": (
            lambda readings: (3 * np.std(readings)) ** 2,
            "That is (3σ)² again, with the drift in it as well. Look at the differences of neighbours.",
        ),
    },
}
