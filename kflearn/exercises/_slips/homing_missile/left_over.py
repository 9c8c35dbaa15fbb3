"""Lesson 16, `left_over`: wrong answers, each with the sentence that it gets."""

import numpy as np


def powers(e, v, t0, t, low=1, high=3, sign=-1):
    """a tˡ + b tʰ that starts as e, with the slope sign·v against the time to go."""
    a, b = np.linalg.solve([[t0**low, t0**high], [low * t0 ** (low - 1), high * t0 ** (high - 1)]], [e, sign * v])
    return a * t**low + b * t**high


def bent(e, v, t0, t, a=1, b=-1):
    """a·t + b·t³ with mistakes: b of another sign or size, a from another share of b."""
    b = b * (e + v * t0) / (2 * t0**3)
    return (e / t0 - a * b * t0**2) * t + b * t**3


def speed(e, v, t0, t):
    """The velocity of the error with t seconds to go."""
    b = -(e + v * t0) / (2 * t0**3)
    return -(e / t0 - b * t0**2 + 3 * b * t**2)


def slope_of(t0, e, v, t):
    a, b = np.linalg.solve([[t0, t0**3], [-1, -3 * t0]], [e, v])
    return a * t + b * t**3


def held(factor):
    """An error under the acceleration of the law at t0, which is kept from then on."""

    def left(e, v, t0, t):
        passed, pull = t0 - t, factor / t0**2 * (e + v * t0)
        return e + v * passed - pull * passed**2 / 2

    return left


WRONG = {
    "velocity with the wrong sign": (
        lambda e, v, t0, t: powers(e, v, t0, t, sign=1),
        "The sign of the velocity: t is the time *to go*, it shrinks. The slope of a·t + b·t³ at t₀ is −v.",
    ),
    "coasting": (
        lambda e, v, t0, t: e + v * (t0 - t),
        "That is an error left to itself. But estimate and truth are both steered, each by its own state: use a·t + b·t³.",
    ),
    "straight line": (
        lambda e, v, t0, t: e * t / t0,
        "That is e·t/t₀, a·t alone. It fits the error at t₀, but not its velocity: for that you need b·t³ too.",
    ),
    "cubic alone": (
        lambda e, v, t0, t: e * (t / t0) ** 3,
        "That is e·(t/t₀)³, b·t³ alone. It fits the error at t₀, but not its velocity: for that you need a·t too.",
    ),
    "velocity forgotten": (
        lambda e, v, t0, t: powers(e, 0, t0, t),
        "That is right for v = 0. The error's velocity is v; with v = −e/t₀, for example, the whole error would be a·t.",
    ),
    "velocity taken for a": (
        lambda e, v, t0, t: -v * t + (e + v * t0) / t0**3 * t**3,
        "Here a is −v. But −v is the slope at t₀, where the cubic has a slope as well: −v = a + 3b·t₀².",
    ),
    "square in place of cube": (
        lambda e, v, t0, t: powers(e, v, t0, t, 1, 2),
        "That is a·t + b·t², fitted to e and v. The powers are 1 and N, and N is 3.",
    ),
    "constant in place of line": (
        lambda e, v, t0, t: powers(e, v, t0, t, 0, 3),
        "That is a + b·t³, fitted to e and v. The powers are 1 and 3; a constant would not vanish at the impact.",
    ),
    "where it would hit": (
        lambda e, v, t0, t: e + v * t0,
        "e + v·t₀ is the error that coasting would leave at the impact; the law works against it all the way.",
    ),
    "unchanged": (
        lambda e, v, t0, t: e,
        "That is e, the error at t₀. It shrinks as t does, although nothing is measured.",
    ),
    "nothing left": (lambda e, v, t0, t: 0.0, "Zero is right only at t = 0, the impact."),
    "coasting from here": (
        lambda e, v, t0, t: e + v * t,
        "That is e + v·t, an error that coasts for t seconds. t is the time still to go; and the error does not coast, both are steered.",
    ),
    "coasting, scaled": (
        lambda e, v, t0, t: (e + v * (t0 - t)) * t / t0,
        "That is the coasting error times t/t₀. Neither part is right alone: fit a·t + b·t³ to e and to v at t₀.",
    ),
    "line plus coasting": (
        lambda e, v, t0, t: e * t / t0 + v * (t0 - t),
        "That is e·t/t₀ + v·(t₀ − t), a straight line and the coasting of v. Fit a·t + b·t³: its value at t₀ is e, its slope against t is −v.",
    ),
    "e and v as coefficients": (
        lambda e, v, t0, t: e * t + v * t**3,
        "That is e·t + v·t³. e and v are not a and b themselves, but the error and its velocity at t₀: two equations for a and b.",
    ),
    "each by itself": (
        lambda e, v, t0, t: e * t / t0 - v * t**3 / (3 * t0**2),
        "Here a comes of e alone, e/t₀, and b of v alone. But the error at t₀ is a·t₀ + b·t₀³ and its velocity −(a + 3b·t₀²): each of them holds both. Solve the two together.",
    ),
    "time gone in both": (
        lambda e, v, t0, t: powers(e, v, t0, t0 - t),
        "Your a and b are right. But you inserted t₀ − t, the time that has passed. In a·t + b·t³ the t is the time to go.",
    ),
    "slope of the cube": (
        lambda e, v, t0, t: bent(e, v, t0, t, b=-2),
        "Your b is twice as large as it should be. Multiply −v = a + 3b·t₀² by t₀ and take e = a·t₀ + b·t₀³ off: 2b·t₀³ is left. (The slope of t³ is 3t².)",
    ),
    "b with the wrong sign": (
        lambda e, v, t0, t: bent(e, v, t0, t, b=1),
        "The sign of b: multiply −v = a + 3b·t₀² by t₀ and take e = a·t₀ + b·t₀³ off it.",
    ),
    "a without b": (
        lambda e, v, t0, t: bent(e, v, t0, t, a=0),
        "Your b is right. But a·t₀ is what is left of e when b·t₀³ is taken off: a = e/t₀ − b·t₀².",
    ),
    "a plus b": (
        lambda e, v, t0, t: bent(e, v, t0, t, a=-1),
        "Your b is right. In a the sign is wrong: e = a·t₀ + b·t₀³, so a = e/t₀ − b·t₀².",
    ),
    "velocity": (
        speed,
        "That is the error's velocity with t seconds to go. Asked is the error itself, a·t + b·t³.",
    ),
    "fourth power": (
        lambda e, v, t0, t: powers(e, v, t0, t, 1, 4),
        "That is a·t + b·t⁴, fitted to e and v. The powers are 1 and N, and N is 3.",
    ),
    "square and cube": (
        lambda e, v, t0, t: powers(e, v, t0, t, 2, 3),
        "That is a·t² + b·t³, fitted to e and v. The powers are 1 and N, and N is 3.",
    ),
    "time gone": (
        lambda e, v, t0, t: e * (1 - t / t0),
        "That is a·t alone, with the time that has passed. t is the time to go: at t = t₀ the whole error is still "
        "there. And b·t³ is missing.",
    ),
    "t0 not squared": (
        lambda e, v, t0, t: slope_of(t0, e, v, t),
        "The slope of b·t³ is 3·b·t²: in the second row t₀ needs a square.",
        r"slope_of|3(\.0)? *\* *t0\b(?! *\*\*)|t0 *\* *3\b",
    ),
    "acceleration held": (
        held(3),
        "That is the error under one acceleration, the law's at t₀, kept for the whole time. The law works it out anew at each moment: "
        "the error is a·t + b·t³.",
    ),
    "acceleration held, 1": (
        held(1),
        "That is the error under one acceleration, kept for the whole time. The law works it out anew at each moment, with N = 3: the "
        "error is a·t + b·t³.",
    ),
    "e and v for a and b": (
        lambda e, v, t0, t: v * t + e * (t / t0) ** 3,
        "Your error is v·t + e·(t/t₀)³. With t = t₀ that is e + v·t₀, and it should be e. In a·t + b·t³ neither number is e or v: find a and b "
        "from the error and from the velocity at t₀.",
    ),
    "miss times the cube": (
        lambda e, v, t0, t: (e + v * t0) * (t / t0) ** 3,
        "That is b·t³ alone, with (e + v·t₀)/t₀³ for b. At t = t₀ it should be e. Fit a·t + b·t³ to both: its "
        "value at t₀ is e, its slope against t is −v.",
    ),
    "e and v each with its own power": (
        lambda e, v, t0, t: e * (t / t0) + v * (t / t0) ** 3,
        "Your error is e·t/t₀ + v·(t/t₀)³. With t = t₀ that is e + v, metres plus metres per second, and it should be e. Find a and b "
        "from two conditions: the value at t₀ is e, the slope against t is −v.",
    ),
}
