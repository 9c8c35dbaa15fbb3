"""Lesson 19, `first_velocity`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

WRONG = {
    "half": (
        lambda p, s, R, y: y / 2,
        "Half of the innovation is what p = s and R = 0 give. In general all three variances decide.",
    ),
    "position share": (
        lambda p, s, R, y: p / (p + s + R) * y,
        "You have p on top. The corner of F P Fᵀ is s: the velocity is corrected only as far as its own variance s allows.",
    ),
    "position gain": (
        lambda p, s, R, y: (p + s) / (p + s + R) * y,
        "That is the gain of the *place*. For the velocity take the corner of F P Fᵀ, which is s, over the same S.",
    ),
    "not predicted": (
        lambda p, s, R, y: s / (p + R) * y,
        "S is too small. After the prediction with F the variance of the place is p + s, because an uncertain velocity makes the place uncertain.",
    ),
    "no correlation": (
        lambda p, s, R, y: 0.0,
        "Zero would be right if P were not predicted first. F makes place and velocity correlated: the covariance in the corner becomes s.",
    ),
    "R forgotten": (
        lambda p, s, R, y: s / (p + s) * y,
        "That is right for R = 0: S = H P Hᵀ + R.",
    ),
    "all of it": (
        lambda p, s, R, y: y,
        "That takes the whole innovation for velocity, as if the starting place had been exact and R zero.",
    ),
    "deviations": (
        lambda p, s, R, y: np.sqrt(s) / np.sqrt(p + s + R) * y,
        "That is the root of the gain, times y, as if standard deviations were weighed. Gains are ratios of variances.",
    ),
    "sign": (
        lambda p, s, R, y: -s / (p + s + R) * y,
        "The sign: the ball is further left than expected (y < 0), so it is believed to move left.",
    ),
    "the gain alone": (
        lambda p, s, R, y: s / (p + s + R),
        "That is the gain. The velocity is the gain times the innovation y.",
    ),
    "own share": (
        lambda p, s, R, y: s / (s + R) * y,
        "That is right for p = 0. The variance of the place belongs in S: it keeps the velocity's gain small.",
    ),
    "place alone": (
        lambda p, s, R, y: p / (p + R) * y,
        "That is the gain of the place without any prediction, and also what Fᵀ P F makes. Write F P Fᵀ. The velocity's share is the corner of F P Fᵀ, "
        "which is s, over S = p + s + R.",
    ),
    "twice s in S": (
        lambda p, s, R, y: s / (p + 2 * s + R) * y,
        "One s too many: the place's variance after the prediction is p + s, so S = p + s + R.",
    ),
    "R for s": (
        lambda p, s, R, y: R / (p + s + R) * y,
        "You have R on top. The corner of F P Fᵀ belongs there, which is s, the variance of the velocity.",
    ),
    "Q there": (
        lambda p, s, R, y: s / (p + s + R) * y / 2,
        "That is half of it. Nothing is shared between place and velocity: both get their own gain times y.",
    ),
    "R squared": (
        lambda p, s, R, y: s * y / (p + s + R**2),
        "That is right for R². R is a variance already, like p and s.",
    ),
    "roots": (
        lambda p, s, R, y: math.sqrt(s) * y / (math.sqrt(p) + math.sqrt(s) + math.sqrt(R)),
        "Roots of p, s or R are in it. Variances add, not standard deviations: take none.",
    ),
    "place and velocity squared": (
        lambda p, s, R, y: s**2 * y / (p**2 + s**2 + R**2),
        "Squares of the variances are in it. p, s and R are variances already.",
    ),
    "R alone below": (
        lambda p, s, R, y: s * y / R,
        "You divided by R alone. S is the variance of the whole innovation: of place, velocity and reading.",
    ),
    "s missing above": (
        lambda p, s, R, y: y / (p + s + R),
        "The denominator is S, and it is right. What stands above it is the covariance of place and velocity after the prediction.",
    ),
    "turned over": (
        lambda p, s, R, y: (p + s + R) / s * y,
        "Your gain is upside down: S belongs below.",
    ),
    "root of p s": (
        lambda p, s, R, y: np.sqrt(p * s) / (p + s + R) * y,
        "S below is right. On top you have √(p·s), as if place and velocity had erred together before. Only the "
        "prediction ties them: F P Fᵀ has s in its corner.",
    ),
    "place and velocity": (
        lambda p, s, R, y: np.array([p + s, s]) / (p + s + R) * y,
        "Those are the corrections of place and velocity. The velocity's alone is asked for, the second.",
    ),
}
