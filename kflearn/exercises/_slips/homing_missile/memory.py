"""Lesson 16, `memory`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
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
    "the part that is lost": (
        lambda lasts, sd, dt: (1 - np.exp(-dt / lasts), sd**2 * (1 - (1 - np.exp(-dt / lasts)) ** 2)),
        "Your first number is the part that is forgotten in a step, 1 − e^(−dt/lasts), and your noise is the one that belongs to it. The part "
        "that survives is e^(−dt/lasts).",
    ),
    "both for short steps": (
        lambda lasts, sd, dt: (1 - dt / lasts, 2 * sd**2 * dt / lasts),
        "Nearly: 1 − dt/lasts and 2·sd²·dt/lasts hold for short steps only. Take the exponential for the part; "
        "the noise then fills part²·sd² up to sd².",
    ),
    "lost and left": (
        lambda lasts, sd, dt: (1 - np.exp(-dt / lasts), sd**2 * np.exp(-2 * dt / lasts)),
        "Your first number is the part that fades in a step, your second the variance that survives it. Asked are "
        "the other two: the part that survives, and the variance that fades and must be added again.",
    ),
}
