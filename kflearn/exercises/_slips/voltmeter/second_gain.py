"""Lesson 5, `second_gain`: wrong answers, each with the sentence that it gets."""

import math

WRONG = {
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
    "as in the lesson": (
        0.625,
        "0.625 is the lesson's gain for the third reading, where Q = R. Here Q = 3 V² and R = 9 V²: work out P⁻ anew.",
    ),
    "Q twice": (
        5 / 17,
        "0.294 is 5/(5 + 3 + 9): P⁻ = 5 contains Q already. Below the line stands P⁻ + R.",
    ),
    "started at R": (
        12 / 21,
        "0.571 is (9 + 3)/(9 + 3 + 9): it starts with P = R = 9 V². Here the filter has P = 2 V² after its first reading.",
    ),
}
