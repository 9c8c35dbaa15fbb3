"""Lesson 5, `steady_gain`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def forgotten_prediction(Q, R):
    """The fixed point of a recursion that fuses P = Q with R."""
    return Q / (Q + R)


def settled(step):
    """The gain after a hundred rounds of `step(P, Q, R)`, which returns the gain and the new P."""

    def gain(Q, R):
        P = R
        for _ in range(100):
            K, P = step(P, Q, R)
        return K

    return gain


def cut(P, K, Q, R):
    """A round that cuts P by 1 − K."""
    return K, (1 - K) * (P + Q)


def after(Q, R, steps):
    """The gain after some steps of the recursion, which starts at P = R."""
    P = R
    for _ in range(steps):
        gain = (P + Q) / (P + Q + R)
        P = gain * R
    return gain


def recursion(Q, R, steps, grows=True, shrinks=True):
    """The gain after so many steps, with the growth or the cut left out."""
    P, K = R + (not grows) * Q, 0.0
    for _ in range(steps):
        P = P + grows * Q
        K = P / (P + R)
        P = (1 - K) * P if shrinks else P
    return K


def stopped_early(Q, R):
    """The recursion until the gain changes by 0.01 or less."""
    P, old, K = R, 0, 1
    while abs(K - old) > 0.01:
        old, K = K, (P + Q) / (P + Q + R)
        P = K * R
    return K


def in_whole_numbers(Q, R):
    q = Q // R
    return (np.sqrt(q**2 + 4 * q) - q) / 2


WRONG = (
    {
        "Q / (Q + R)": (
            forgotten_prediction,
            "That takes P⁻ for Q alone. But what was left over from the step before is still there: P⁻ = P + Q.",
        ),
        "Q and R swapped": (
            lambda Q, R: (math.sqrt((R / Q) ** 2 + 4 * R / Q) - R / Q) / 2,
            "You swapped Q and R: the larger Q, the more a new reading must count.",
        ),
        "1 − K": (
            lambda Q, R: 1 - (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "That is 1 − K, what the prediction keeps.",
        ),
        "P instead of K": (
            lambda Q, R: R * (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "That is the steady variance P = K·R, in V²; the gain is a pure number.",
        ),
        "golden ratio always": (lambda Q, R: 0.6180339887, "0.618 is the answer for Q = R only."),
        "other root": (
            lambda Q, R: (-math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "The quadratic equation has two roots; a gain lies between 0 and 1.",
        ),
        "R above": (
            lambda Q, R: R / (Q + R),
            "With R on top the gain would be small for a large Q. The variance of the prediction stands on top, and it is P⁻ = P + Q.",
        ),
        "P after in the gain": (
            lambda Q, R: (P := R * (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2) / (P + R),
            "You formed the gain from the variance *after* the reading. Into K goes the one before it, P⁻ = P + Q.",
        ),
        "not halved": (
            lambda Q, R: math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R,
            "The solution of a quadratic equation is divided by 2.",
        ),
        "4 for 4q": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + 4) - Q / R) / 2,
            "That is the solution of K² + qK − 1 = 0. The last term is q: K² + qK − q = 0.",
        ),
        "sign of q": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + 4 * Q / R) + Q / R) / 2,
            "That is P⁻/R, or the solution of K² − qK − q = 0. A gain is a part of the whole, P⁻/(P⁻ + R), and at most 1: K² + qK − q = 0.",
        ),
        "P before the reading": (
            lambda Q, R: R * (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2 + Q,
            "That is P⁻, the variance before the reading, in V². The gain is P⁻/(P⁻ + R), a pure number.",
        ),
        "q": (lambda Q, R: Q / R, "That is the ratio q = Q/R. The gain follows from it: K² + qK − q = 0."),
        "√q": (
            lambda Q, R: math.sqrt(Q / R),
            "√q is nearly right for a small Q only; a gain is never larger than 1. Solve K² + qK − q = 0.",
        ),
        "K Q": (
            lambda Q, R: Q * (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
            "You multiplied the gain by Q. The gain is a pure number.",
        ),
        "ratio of σ": (
            lambda Q, R: (math.sqrt(Q / R + 4 * math.sqrt(Q / R)) - math.sqrt(Q / R)) / 2,
            "Your q is a ratio of standard deviations. Q and R are variances: q = Q/R.",
        ),
        "half": (
            lambda Q, R: 0.5,
            "You return 1/2 whatever Q and R are. The more the source moves, the larger the gain.",
        ),
        "P times K": (
            settled(lambda P, Q, R: ((K := (P + Q) / (P + Q + R)), K * (P + Q))),
            "In your loop P becomes K·P, or P − K·R. What the reading leaves is (1 − K)·P⁻: the larger the gain, the less.",
        ),
        "(1 − K) R": (
            settled(lambda P, Q, R: ((K := (P + Q) / (P + Q + R)), (1 - K) * R)),
            "In your loop P becomes (1 − K)·R. What the reading leaves is (1 − K)·P⁻; that is K·R.",
        ),
        "P by R": (
            settled(lambda P, Q, R: cut(P, (P + Q) / R, Q, R)),
            "Your gain is P⁻/R. It is a part of the whole: P⁻/(P⁻ + R), and never more than 1.",
        ),
        "Q over the sum": (
            settled(lambda P, Q, R: cut(P, Q / (P + Q + R), Q, R)),
            "Your gain has Q on top. The whole variance before the reading stands there: P⁻ = P + Q.",
        ),
        "squared": (
            lambda Q, R: (math.sqrt((Q / R) ** 4 + 4 * (Q / R) ** 2) - (Q / R) ** 2) / 2,
            "Your result is right for Q² and R². Q and R are variances already: they go in as they are.",
        ),
        "minus under the root": (
            lambda Q, R: (math.sqrt(abs((Q / R) ** 2 - 4 * Q / R)) - Q / R) / 2,
            "Under the root it is plus. In K² + qK − q = 0 the last term is −q, so b² − 4ac is q² + 4q.",
        ),
        "half of the root alone": (
            lambda Q, R: math.sqrt((Q / R) ** 2 + 4 * Q / R) / 2 - Q / R,
            "Your result is √(q² + 4q)/2 − q. The 2 divides both: (√(q² + 4q) − q)/2.",
        ),
        "half of q alone": (
            lambda Q, R: math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R / 2,
            "Your result is √(q² + 4q) − q/2. The 2 divides both: (√(q² + 4q) − q)/2.",
        ),
        "1 − K with R / Q": (
            lambda Q, R: 1 - (math.sqrt((R / Q) ** 2 + 4 * R / Q) - R / Q) / 2,
            "Your result is one minus the gain that R/Q would give. The gain itself is asked for, with q = Q/R.",
        ),
        "2q": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + 2 * Q / R) - Q / R) / 2,
            "Under the root stands q² + 4q: the 4 of b² − 4ac stays whole.",
        ),
        "4q²": (
            lambda Q, R: (math.sqrt(5) - 1) / 2 * Q / R,
            "Your result is 0.618·q. Under the root stands q² + 4q, with a q that is not squared in the second term.",
        ),
        "R twice": (
            lambda Q, R: Q / (Q + 2 * R),
            "Your result is Q/(Q + 2R). The gain is P⁻/(P⁻ + R), and P⁻ = P + Q: what was left from before stands on top too.",
        ),
    }
    | {
        f"{steps} steps": (
            lambda Q, R, steps=steps: after(Q, R, steps),
            f"That is the gain of reading {steps + 1}. Where Q is small beside R, it has not yet come to rest: let the recursion run for a hundred readings, or solve K² + qK − q = 0.",
        )
        for steps in range(1, 26)
    }
    | {
        f"no growth in the loop, {steps} steps": (
            lambda Q, R, steps=steps: recursion(Q, R, steps, grows=False),
            "In your loop P does not grow, so the gain goes to zero: add Q in every step.",
        )
        for steps in (50, 99, 100, 101, 200, 500, 1000)
    }
    | {
        f"no cut in the loop, {steps} steps": (
            lambda Q, R, steps=steps: recursion(Q, R, steps, shrinks=False),
            "In your loop P only grows, so the gain goes to 1: after each reading P is multiplied by 1 − K.",
        )
        for steps in (50, 99, 100, 101, 200, 500, 1000)
    }
    | {
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
        "stopped early": (
            stopped_early,
            "It answers as if the recursion stopped once K changes by 0.01 or less. Many small changes can still "
            "follow: ask for a far smaller one, or take a hundred steps.",
        ),
        "whole ratio": (
            in_whole_numbers,
            "It answers as if Q/R were rounded down to a whole number, which is what `//` does: where Q is smaller "
            "than R, that is 0. Divide with `/`.",
        ),
    }
)
