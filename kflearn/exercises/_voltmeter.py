"""Wrong answers to exercises of lesson 5, each with the sentence that it gets."""

import math

import numpy as np


def after(Q, R, steps):
    """The gain after some steps of the recursion, which starts at P = R."""
    P = R
    for _ in range(steps):
        gain = (P + Q) / (P + Q + R)
        P = gain * R
    return gain


def forgotten_prediction(Q, R):
    """The fixed point of a recursion that fuses P = Q with R."""
    return Q / (Q + R)


WRONG = {
    "second_gain": {
        "forgot Q": (
            2 / 11,
            "0.182 comes from a prediction with a variance of 2 V² only. What is left from the first reading and what Q adds belong together: P⁻ = P + Q.",
        ),
        "1 − K": (9 / 14, "That is 1 − K, the weight of the prediction; the gain has P⁻ on top."),
        "σ for σ²": (
            math.sqrt(5) / (math.sqrt(5) + 3),
            "0.427 is √5/(√5 + 3), made of standard deviations; the gain takes variances.",
        ),
        "steady gain": (
            lambda: (math.sqrt((3 / 9) ** 2 + 4 * 3 / 9) - 3 / 9) / 2,
            "That is where the gain settles later. The question is about the second reading, with P⁻ = 2 + 3.",
        ),
        "the lesson's": (
            2 / 3,
            "That is the second gain of the lesson, where P, Q and R are all 4 V². Here they are 2, 3 and 9 V².",
        ),
        "golden": (0.618034, "0.618 is the steady gain for Q = R. Here Q is 3 V² and R is 9 V²."),
        "two predictions": (
            8 / 17,
            "0.471 is 8/17, with Q added twice: only one prediction lies between the first and the second reading.",
        ),
        "P before": (
            5,
            "5 V² is the variance before the second reading. The gain is a pure number: which part of P⁻ + R is it?",
        ),
        "P after": (
            45 / 14,
            "45/14 V² is the variance after the second reading. The gain is a pure number, between 0 and 1.",
        ),
        "third": (
            0.4084,
            "That is the gain for the third reading. P = 2 V² is what the first reading left; there is one prediction before the second.",
        ),
        "R not added": (
            5 / 9,
            "0.556 is P⁻/R. The gain is a part of the whole: P⁻/(P⁻ + R), never more than 1.",
        ),
        "P forgotten": (
            3 / 12,
            "0.25 is Q/(Q + R). What was left from the first reading counts too: P⁻ = P + Q = 5 V².",
        ),
        "P by Q": (0.4, "That is P/(P + Q). The gain compares the prediction with the reading: P⁻/(P⁻ + R)."),
        "Q by R": (1 / 3, "That is the ratio Q/R. The gain is P⁻/(P⁻ + R), with P⁻ = P + Q."),
        "Q and R exchanged": (
            11 / 14,
            "0.786 is (P + R)/(P + R + Q), with Q and R exchanged: Q is what P grows by, R belongs to the reading.",
        ),
        "P after in the gain": (
            9 / 11,
            "That is R/(P + R), and Q does not occur in it. First P grows by Q; then P⁻ stands on top.",
        ),
        "first": (
            1,
            "A gain of 1 would believe the reading alone; that is how the filter starts. Go on to the second reading.",
        ),
        "Q alone": (3, "3 V² is a variance, Q. The gain is a pure number, between 0 and 1."),
        "sum": (14, "14 V² is P⁻ + R, the denominator of the gain."),
        "one half": (
            0.5,
            "A gain of 1/2 would need P⁻ = R = 9 V². Here P⁻ = P + Q is smaller than R.",
        ),
        "P by R": (2 / 9, "That is P/R. First P grows by Q; and the gain is P⁻/(P⁻ + R)."),
    },
    "steady_gain": {
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
    },
    "is_unknown": {
        "as published": (
            lambda x: np.isnan(x).all(),
            "That is the published test again: it says yes only when every entry is unknown.",
        ),
        "not all": (
            lambda x: not np.all(x),
            "Your function says True where an entry is 0, as `not np.all(x)` does: NaN differs from 0. But 0 is a number like any other: ask `np.isnan`.",
        ),
        "not all of what NaN is made": (
            lambda x: not np.all(np.nan_to_num(x)),
            "An entry that is 0 is taken for unknown, too: 0 is a number like any other. Ask np.isnan of the entries as they are.",
        ),
        "the wrong way round": (lambda x: not np.isnan(x).any(), "Your function says yes when the start is known."),
        "the places": (
            lambda x: np.flatnonzero(np.isnan(x)),
            "You return the places of the unknown entries. True or False is wanted: is there any?",
        ),
        "only the first": (
            lambda x: np.isnan(x[0]),
            "NaN is found only where it stands first; it may sit in any entry.",
        ),
        "x == nan": (
            lambda x: (x == np.nan).any(),
            "NaN equals nothing, not even itself, so x == np.nan is always False: use np.isnan.",
            r"== *(np|numpy|math)?\.?nan|nan *==|float\(.nan.\)",
        ),
        "always True": (
            lambda x: True,
            "Your function says True for every state that it was tried on, those without NaN as well: ask each entry with np.isnan.",
        ),
        "each entry": (
            lambda x: np.isnan(x),
            "You return an answer for each entry. One answer for the whole state is wanted: is any of them True?",
        ),
        "how many": (
            lambda x: np.isnan(x).sum(),
            "You return how many entries are unknown. True or False is wanted: is there any?",
        ),
        "only the last": (lambda x: np.isnan(x[-1]), "You look at the last entry only; NaN may sit in any of them."),
        "only two": (
            lambda x: np.isnan(x[:2]).any(),
            "You look at the first two entries only. A state may have more: let np.isnan look at all of them.",
        ),
        "only the middle": (
            lambda x: np.isnan(x[len(x) // 2]),
            "You look at one entry only; NaN may sit in any of them.",
        ),
        "first and last": (
            lambda x: np.isnan(x[0]) or np.isnan(x[-1]),
            "You look at the first and the last entry only; NaN may sit between them.",
        ),
        "finite": (
            lambda x: np.isfinite(x).any(),
            "You ask whether any entry is known, or whether not all are unknown. The question is whether any is unknown.",
        ),
        "each, from a list": (
            lambda x: [bool(np.isnan(value)) for value in x],
            "You return an answer for each entry. One answer for the whole state is wanted: is any of them True?",
        ),
    },
}
