"""Lesson 6, `R_with_drift`: wrong answers, each with the sentence that it gets."""

import numpy as np

DEGREES = range(3, 11)


def without_polynomial(degree):
    """The variance of what is left beside a polynomial."""

    def of(readings):
        k = np.linspace(-1, 1, len(readings))
        return np.var(readings - np.polynomial.Polynomial.fit(k, readings, degree)(k))

    return of


WRONG = (
    {
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
        "mean, then square": (
            lambda readings: np.mean(np.diff(readings)) ** 2 / 2,
            "You took the mean first and squared then: positive and negative differences cancel. Square each of them, then take the mean.",
        ),
        "no mean": (
            lambda readings: np.diff(readings) ** 2 / 2,
            "That is one number for each pair of neighbours. Take their mean.",
        ),
        "second differences, halved": (
            lambda readings: np.mean(np.diff(readings, n=2) ** 2) / 2,
            "A second difference, z₂ − 2z₁ + z₀, holds R + 4R + R = 6R: divide its mean square by 6.",
        ),
        "first ten": (
            lambda readings: np.var(readings[:10]),
            "You took the variance of the first ten readings: ten are few, and the drift is in it. Use the differences of all neighbours.",
        ),
        "products": (
            lambda readings: np.mean(readings[1:] * readings[:-1]) / 2,
            "You multiplied neighbours with one another. Take their difference, and square that.",
        ),
        "Q taken away": (
            lambda readings: (np.mean(np.diff(readings) ** 2) - 0.04) / 2,
            "The differences and the 2 are right. You took 0.04 away, a Q of other numbers: this drift adds next to nothing to a difference.",
        ),
        "from the first": (
            lambda readings: np.mean((readings - readings[0]) ** 2) / 2,
            "You took the difference to the first reading each time: that holds all of the drift. Take neighbours.",
        ),
        "doubled": (
            lambda readings: 2 * np.mean(np.diff(readings) ** 2),
            "You doubled where you should halve: the mean square of a difference is 2R.",
        ),
        "pairs, not halved": (
            lambda readings: np.mean((readings[1::2] - readings[: len(readings) // 2 * 2 : 2]) ** 2),
            "A difference holds the noise of two readings, so its mean square is 2R: halve it. And use all neighbours, not every other pair.",
        ),
    }
    | {
        f"polynomial, {degree}": (
            without_polynomial(degree),
            "You took a polynomial away. That may fit this drift or not. Asked is what the differences of neighbours say: they need no shape.",
        )
        for degree in DEGREES
    }
    | {
        "mean of three": (
            lambda z: np.var(z[1:-1] - np.convolve(z, np.ones(3) / 3, mode="valid")),
            "You take the mean of three readings off, and the reading itself is one of the three: only 2/3 of its noise's variance is left. Divide by 2/3, or "
            "work with differences of neighbours.",
        ),
        "differences of squares": (
            lambda z: np.mean(abs(np.diff(z**2))) / 2,
            "That is half the mean size of the differences of *squares*, which also grows with the voltage itself. "
            "First the difference of two neighbours, then its square.",
        ),
    }
)
