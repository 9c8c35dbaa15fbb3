"""Wrong answers to exercises of lesson 16, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises import _rms_figures


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


WRONG = {
    "figures": _rms_figures.WRONG,
    "left_over": {
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
    },
    "memory": {
        "as published": (
            lambda lasts, sd, dt: (np.exp(-1e4 * dt), 0.1),
            "That is the published pair: a memory of a ten-thousandth of a second, and 0.1 whatever the manoeuvre. λ is 1/lasts.",
        ),
        "rate and time swapped": (
            lambda lasts, sd, dt: (np.exp(-lasts * dt), sd**2 * (1 - np.exp(-2 * lasts * dt))),
            "That is right for λ = lasts. A rate is one over a time: the longer a manoeuvre lasts, the *smaller* λ.",
        ),
        "what fades": (
            lambda lasts, sd, dt: (1 - np.exp(-dt / lasts), sd**2 * (1 - np.exp(-2 * dt / lasts))),
            "Your first number is what fades in a step; asked is what survives. The variance is right.",
        ),
        "part not squared": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * (1 - np.exp(-dt / lasts))),
            "The part is right. The acceleration is multiplied by `part`, so its variance by part²: part²·sd² + noise = sd².",
        ),
        "(1 − part)²": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * (1 - np.exp(-dt / lasts)) ** 2),
            "The part is right. Variances add up, not standard deviations: part²·sd² + noise = sd².",
        ),
        "sd not squared": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd * (1 - np.exp(-2 * dt / lasts))),
            "The part is right, but the noise is a variance: sd² and not sd.",
        ),
        "standard deviation": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd * np.sqrt(1 - np.exp(-2 * dt / lasts))),
            "That is the noise's standard deviation; Q wants its variance.",
        ),
        "sd² every step": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2),
            "With sd² added at every step the variance would grow beyond sd², for part of the old one survives.",
        ),
        "sd² dt": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * dt),
            "The part is right, the noise does not know how long a manoeuvre lasts: what fades must be filled up, sd²(1 − part²).",
        ),
        "straight line": (
            lambda lasts, sd, dt: (1 - dt / lasts, sd**2 * (1 - (1 - dt / lasts) ** 2)),
            "Nearly: 1 − dt/lasts is the tangent to e^(−dt/lasts), good for short steps only. Use the exponential.",
        ),
        "short steps": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), 2 * sd**2 * dt / lasts),
            "Nearly: 2·sd²·dt/lasts holds for short steps only. The exact variance is sd²(1 − part²).",
        ),
        "other way round": (
            lambda lasts, sd, dt: (sd**2 * (1 - np.exp(-2 * dt / lasts)), np.exp(-dt / lasts)),
            "Both are right, in the wrong order: first the part, then the variance.",
        ),
        "what is left of sd²": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * np.exp(-2 * dt / lasts)),
            "The part is right. Your second number is the variance that survives; the noise is what is missing to sd².",
        ),
        "part of sd²": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * np.exp(-dt / lasts)),
            "The part is right. The noise must fill up what fades, to sd² again: part²·sd² + noise = sd².",
        ),
        "grows": (
            lambda lasts, sd, dt: (np.exp(dt / lasts), sd**2 * (1 - np.exp(-2 * dt / lasts))),
            "The sign of the exponent: what survives is less than 1.",
        ),
        "sd not squared, part not squared": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd * (1 - np.exp(-dt / lasts))),
            "The part is right. In the noise both are variances: sd² and part².",
        ),
        "sd": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd),
            "The part is right. The noise only fills up what fades in a step, and it is a variance: sd²(1 − part²).",
        ),
        "both grow": (
            lambda lasts, sd, dt: (np.exp(dt / lasts), sd**2 * (1 - np.exp(2 * dt / lasts))),
            "The sign of the exponent: what survives is less than 1. With a part above 1 your variance is negative.",
        ),
        "part alone": (
            lambda lasts, sd, dt: np.exp(-dt / lasts),
            "Your part is right. Return two numbers: the part, and the variance of the noise.",
        ),
        "noise alone": (
            lambda lasts, sd, dt: sd**2 * (1 - np.exp(-2 * dt / lasts)),
            "Your variance is right. Return two numbers: first the part that survives, then the variance.",
        ),
        "part squared": (
            lambda lasts, sd, dt: (np.exp(-2 * dt / lasts), sd**2 * (1 - np.exp(-2 * dt / lasts))),
            "The variance is right. But the first number is what survives of an acceleration, not of its square.",
        ),
        "λ": (
            lambda lasts, sd, dt: (1 / lasts, sd**2 * (1 - np.exp(-2 * dt / lasts))),
            "The variance is right. Your first number is λ, a rate per second. What survives a step is e^(−λ·dt).",
        ),
        "λ dt": (
            lambda lasts, sd, dt: (dt / lasts, sd**2 * (1 - (dt / lasts) ** 2)),
            "Your part is dt/lasts, which is nearly what *fades* in a step. What survives is e^(−dt/lasts).",
        ),
        "half-life": (
            lambda lasts, sd, dt: (0.5 ** (dt / lasts), sd**2 * (1 - 0.25 ** (dt / lasts))),
            "That is right if `lasts` were a half-life. Singer's rate is λ = 1/lasts, and what survives a step is e^(−λ·dt).",
        ),
        "noise times dt": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * (1 - np.exp(-2 * dt / lasts)) * dt),
            "The part is right. The noise is for one step already: sd² · (1 − part²) needs no dt.",
        ),
        "noise over dt": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * (1 - np.exp(-2 * dt / lasts)) / dt),
            "The part is right. The noise is for one step already: sd² · (1 − part²) needs no dt.",
        ),
        "divided by 1 − part²": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 / (1 - np.exp(-2 * dt / lasts))),
            "The part is right. sd²/(1 − part²) is the variance which noise of sd² would lead to. Asked is the noise which leads to sd².",
        ),
        "density": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), 2 * sd**2 / lasts),
            "The part is right. 2·sd²/lasts is the strength of the noise per second. Asked is the variance that one step of dt adds.",
        ),
        "rate and time swapped, not squared": (
            lambda lasts, sd, dt: (np.exp(-lasts * dt), sd**2 * (1 - np.exp(-lasts * dt))),
            "Two things: λ is 1/lasts, not lasts; and the variance that survives is part² times sd².",
        ),
    },
}
