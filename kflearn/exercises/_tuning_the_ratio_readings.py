"""Wrong answers to lesson 6's exercises on readings, each with the sentence that it gets."""

import numpy as np

WRONG = {
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
            "That is (2σ)². No factor belongs in R: it is σ² itself.",
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
        "mean": (
            lambda at_rest: np.mean(at_rest),
            "That is the voltage of the source. R is about the scatter of the readings.",
        ),
        "mean distance": (
            lambda at_rest: np.mean(abs(at_rest - np.mean(at_rest))),
            "That is the mean distance from the mean, in volts. R is a variance: square the distances before you take their mean.",
        ),
        "a third": (
            lambda at_rest: np.var(at_rest) / 3,
            "You divided by 3. σ was measured here, not read off a sheet: R is σ² itself.",
        ),
        "of the mean": (
            lambda at_rest: np.var(at_rest) / len(at_rest),
            "That is the variance of the *mean* of all readings. R is the variance of a single one.",
        ),
        "six sigmas": (
            lambda at_rest: (6 * np.std(at_rest)) ** 2,
            "You took the whole width, 6σ. No factor belongs in R: it is σ² itself.",
        ),
        "square of three variances": (
            lambda at_rest: (3 * np.var(at_rest)) ** 2,
            "You squared a variance. R is σ² itself, in V².",
        ),
        "a number": (
            lambda at_rest: 1.0,
            "You return 1 whatever the readings are. That is right for the source of the example only.",
        ),
    },
    "R_with_drift": {
        "variance": (
            lambda readings: np.var(readings),
            "The plain variance takes the drift for noise. Look at the differences of neighbours, in which it hardly shows.",
        ),
        "not halved": (
            lambda readings: np.mean(np.diff(readings) ** 2),
            "A difference holds the noise of two readings, so its mean square is 2R. Halve it.",
        ),
        "half of σ": (
            lambda readings: (np.std(np.diff(readings)) / 2) ** 2,
            "You divided by 4, or halved before squaring. The variance of a difference is 2R, so its σ is √2 times the meter's, not 2 times.",
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
        "half of the variance": (
            lambda readings: np.var(readings) / 2,
            "The halving belongs to the differences of neighbours. The plain variance has the drift in it.",
        ),
        "deviation": (
            lambda readings: np.std(readings),
            "That is the scatter of all readings, with the drift in it, and in volts. Look at the squared differences of neighbours.",
        ),
        "parabola removed": (
            lambda readings: np.var(
                readings - np.polyval(np.polyfit(range(len(readings)), readings, 2), range(len(readings)))
            ),
            "You removed a parabola, but this drift has another shape. Differences of neighbours need no shape for it.",
        ),
        "√2": (
            lambda readings: np.mean(np.diff(readings) ** 2) / np.sqrt(2),
            "The σ of a difference is √2 times that of a reading, so its variance is 2 times as large: divide by 2.",
        ),
        "mean distance, squared": (
            lambda readings: np.mean(abs(np.diff(readings))) ** 2 / 2,
            "You squared the mean distance. Square each difference first, then take the mean.",
        ),
        "first hundred": (
            lambda readings: np.var(readings[:100]),
            "You took the variance of the first hundred readings. A part of the drift is still in there; differences of neighbours hold next to none of it.",
        ),
        "every other": (
            lambda readings: np.mean((readings[2:] - readings[:-2]) ** 2) / 2,
            "You took the difference to the reading after the next: that holds more of the drift. Take neighbours.",
        ),
    },
}
