"""More wrong answers to exercises of lessons 5 and 6, each with its sentence: those that a second stranger tried."""

import math

import numpy as np

from kflearn.exercises._tuning_the_ratio import balance

DEGREES = range(3, 11)  # of polynomials that are taken away


def recursion(Q, R, steps, grows=True, shrinks=True):
    """The gain after so many steps, with the growth or the cut left out."""
    P, K = R + (not grows) * Q, 0.0
    for _ in range(steps):
        P = P + grows * Q
        K = P / (P + R)
        P = (1 - K) * P if shrinks else P
    return K


def without_polynomial(degree):
    """The variance of what is left beside a polynomial."""

    def of(readings):
        k = np.linspace(-1, 1, len(readings))
        return np.var(readings - np.polynomial.Polynomial.fit(k, readings, degree)(k))

    return of


WRONG = {
    "second_gain": {
        "Q on top only": (
            5 / 11,
            "On top is right. Below the line Q is missing: there stands the same P⁻, and R.",
        ),
        "Q below only": (
            2 / 14,
            "Below the line is right. On top Q is missing: there stands the same P⁻.",
        ),
        "squared": (
            lambda: 13 / 94,
            "0.138 is (2² + 3²)/(2² + 3² + 9²). P, Q and R are given in V², so they are variances already.",
        ),
        "minus Q": (
            0.1,
            "0.1 is 1/(1 + 9), and 1 is the difference of Q and P. Between two readings the source moves, so P grows by Q: P⁻ is their sum.",
        ),
        "P over the sum of all, 1 − K": (
            12 / 14,
            "0.857 is (Q + R)/(P + Q + R). On top stands P⁻ = P + Q, and R joins it below.",
        ),
        "Q/(P + Q + R)": (
            3 / 14,
            "Below the line is right. On top stands all of P⁻ = P + Q, not Q alone.",
        ),
    },
    "steady_gain": {
        **{
            f"no growth in the loop, {steps} steps": (
                lambda Q, R, steps=steps: recursion(Q, R, steps, grows=False),
                "In your loop P does not grow, so the gain goes to zero: add Q in every step.",
            )
            for steps in (50, 99, 100, 101, 200, 500, 1000)
        },
        **{
            f"no cut in the loop, {steps} steps": (
                lambda Q, R, steps=steps: recursion(Q, R, steps, shrinks=False),
                "In your loop P only grows, so the gain goes to 1: after each reading P is multiplied by 1 − K.",
            )
            for steps in (50, 99, 100, 101, 200, 500, 1000)
        },
        "gain before the growth": (
            lambda Q, R: math.sqrt(Q * R) / (math.sqrt(Q * R) + R),
            "Your gain is √Q/(√Q + √R). Two mistakes lead to it: standard deviations instead of variances, or a loop in which K is formed before P grows by Q. First P grows, then K is formed, then P is cut.",
        ),
        "K² + K = q": (
            lambda Q, R: (math.sqrt(1 + 4 * Q / R) - 1) / 2,
            "That is the solution of K² + K − q = 0. The factor of K is q: K² + qK − q = 0.",
        ),
        "no 4": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + Q / R) - Q / R) / 2,
            "The 4 of the formula for quadratic equations is missing: √(q² + 4q).",
        ),
        "minus forgotten": (
            lambda Q, R: math.sqrt((Q / R) ** 2 + 4 * Q / R) / 2,
            "The root is right. Before it is halved, q is subtracted from it.",
        ),
    },
    "is_unknown": {
        "truth of entries": (
            lambda x: np.any(x),
            "`any` asks here whether an entry is not zero, and NaN is not zero either. Ask each entry with np.isnan first.",
            r"any\(x\)|x\.any\(",
        ),
        "is nan": (
            lambda x: any(value is np.nan for value in x),
            "`is` asks whether two names stand for the same object. A NaN in an array is another one: use np.isnan.",
            r"\bis +(not +)?(np|math|numpy|float)\b",
        ),
    },
    "steady_sigma": {
        "4 for 4q": (
            lambda: math.sqrt((math.sqrt(0.04**2 + 4) - 0.04) / 2 * 0.25),
            "0.495 comes from K = 0.98. Under the root in K stands q² + 4q: does the 4 lack its q?",
        ),
        "not halved": (
            lambda: math.sqrt((math.sqrt(0.04**2 + 0.16) - 0.04) * 0.25),
            "0.301 is the root of 2P. Either K is not divided by 2 at its end, or it is multiplied by σ = 0.5 °C in place of R = 0.25 °C².",
        ),
        "squared": (
            lambda: math.sqrt(balance(0.0001, 0.0625)) * 0.25,
            "0.0495 comes from 0.01² and 0.25². Q and R are given in °C², so they are variances already.",
        ),
        "golden": (
            lambda: math.sqrt(0.618034 * 0.25),
            "0.618 is the gain for Q = R. Here Q/R is 0.04: solve for K again.",
        ),
        "golden, variance": (
            lambda: 0.618034 * 0.25,
            "0.618 is the gain for Q = R. Here Q/R is 0.04; and σ is a root.",
        ),
    },
    "three_sigma": {
        "12 V": (
            lambda at_rest: np.mean((at_rest - 12) ** 2),
            "You took 12 V away. Each of these sources rests at a voltage of its own: take away the mean of the readings.",
        ),
        "σ/3": (
            lambda at_rest: np.std(at_rest) / 3,
            "Two things: R is σ², in V², not σ; and σ was measured here, so no 3 is needed.",
        ),
        "median": (
            lambda at_rest: np.median(abs(at_rest - np.median(at_rest))) ** 2,
            "That is the square of the median distance, which is smaller than σ: half of the readings lie nearer than 0.67 σ.",
        ),
        "neighbours, σ": (
            lambda at_rest: np.std(np.diff(at_rest)),
            "That is the σ of a difference of two readings. R is the variance of one.",
        ),
    },
    "R_with_drift": {
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
        **{
            f"polynomial, {degree}": (
                without_polynomial(degree),
                "You took a polynomial away. That may fit this drift or not. Asked is what the differences of neighbours say: they need no shape.",
            )
            for degree in DEGREES
        },
    },
}
