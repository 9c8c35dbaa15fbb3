"""Lesson 14: the homing missile."""

import math

import numpy as np

from kflearn.exercises._homing_missile import WRONG
from kflearn.exercises.engine import exercise


def errors_on_the_way(rng):
    """An error (m) and its velocity (m/s), and two times to go (s)."""
    t0 = float(rng.integers(4, 9) / 2)
    return float(rng.integers(-600, 601)), float(rng.integers(-300, 301)), t0, t0 * float(rng.integers(1, 8) / 8)


@exercise(
    hints=[
        "The error is a·t + b·t³. Two numbers are wanted, a and b, and two are known, at t₀: the error itself and its velocity.",
        "At t₀: a·t₀ + b·t₀³ = e. The velocity is the change per second that passes, and t shrinks: v = −(a + 3b·t₀²).",
        "Multiply the second by t₀ and add it to the first: e + v·t₀ = −2b·t₀³.",
        "`b = -(e + v * t0) / (2 * t0**3)`, then `a = e / t0 - b * t0**2`, then `return a * t + b * t**3`.",
    ],
    inputs=errors_on_the_way,
    wrong=WRONG["left_over"],
)
def left_over(e, v, t0, t):
    """The error (m) with t seconds to go, when with t0 seconds to go it is e (m) and its velocity v (m/s); blind."""
    b = -(e + v * t0) / (2 * t0**3)
    a = e / t0 - b * t0**2
    return a * t + b * t**3


def manoeuvres(rng):
    """How long a manoeuvre lasts (s), its standard deviation (m/s²), a time step (s)."""
    return float(rng.integers(1, 20) / 4), float(rng.integers(2, 40)), float(rng.integers(1, 11) / 100)


@exercise(
    hints=[
        "The lower right corner of F says which part survives: e to the power −λ·dt. What is λ for a manoeuvre that lasts so long?",
        "λ = 1/lasts. Then think of variances: after the step part²·sd² is left, and noise fills it up to sd² again.",
        "`part = np.exp(-dt / lasts)`, and `return part, sd**2 * (1 - part**2)`.",
    ],
    inputs=manoeuvres,
    wrong={
        "as published": (
            lambda lasts, sd, dt: (np.exp(-1e4 * dt), 0.1),
            "That is the published pair: a memory of a ten-thousandth of a second, and 0.1 whatever the manoeuvre. λ is 1/lasts.",
        ),
        "rate and time swapped": (
            lambda lasts, sd, dt: (np.exp(-lasts * dt), sd**2 * (1 - np.exp(-2 * lasts * dt))),
            "You used λ = lasts. A rate is one over a time: the longer a manoeuvre lasts, the *smaller* λ.",
        ),
        "what fades": (
            lambda lasts, sd, dt: (1 - np.exp(-dt / lasts), sd**2 * (1 - np.exp(-2 * dt / lasts))),
            "Your first number is what fades in a step; asked is what survives. The variance is right.",
        ),
        "part not squared": (
            lambda lasts, sd, dt: (np.exp(-dt / lasts), sd**2 * (1 - np.exp(-dt / lasts))),
            "The part is right. But a variance that is multiplied by `part` on the way through F is multiplied by part².",
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
    },
)
def memory(lasts, sd, dt):
    """The part of an acceleration that survives a step of dt, and the noise variance that keeps its standard deviation."""
    part = np.exp(-dt / lasts)
    return part, sd**2 * (1 - part**2)


@exercise(
    hints=[
        "With the same σ on each axis the NEES is (500² + 300² + 40²)/σ².",
        "Set it equal to the number of axes, and solve for σ: it is a standard deviation in metres, not a variance.",
        "`np.sqrt((500**2 + 300**2 + 40**2) / 3)`.",
    ],
    wrong={
        "NEES of one": (
            lambda: math.hypot(500, 300, 40),
            "With σ equal to the whole distance the NEES is 1. Three axes share the error, so 3 is expected.",
        ),
        "variance": (
            lambda: (500**2 + 300**2 + 40**2) / 3,
            "That is the variance, in m²; asked is its root.",
        ),
        "a third of the distance": (
            lambda: math.hypot(500, 300, 40) / 3,
            "You divided the distance by 3. It is the *square* of the distance that three axes share: divide by √3.",
        ),
        "as published": (
            lambda: 100,
            "That is the published 100 m again, with a NEES of 34.",
        ),
        "100 times 34/3": (
            lambda: 100 * 34.16 / 3,
            "You scaled σ by 34/3. The NEES goes with 1/σ²: scale σ by the root of it.",
        ),
        "400, as in the lesson": (
            lambda: 400,
            "400 m is the lesson's round number, a little on the safe side: its NEES is 2.1.",
        ),
        "mean of the errors": (
            lambda: (500 + 300 + 40) / 3,
            "That is the mean of the three errors. The NEES adds their squares.",
        ),
        "three times the distance": (
            lambda: math.hypot(500, 300, 40) * math.sqrt(3),
            "You multiplied by √3 where you should divide: that σ makes the NEES a third.",
        ),
    },
    unit="m",
)
def start_sigma():
    """The σ (m) on each axis that makes the NEES of a position error of (−500, −300, −40) m equal to 3."""
    return np.sqrt((500**2 + 300**2 + 40**2) / 3)


def needles(rng):
    """The length of a needle (m), a turn in degrees, the noise across (m)."""
    return float(rng.integers(50, 800)), float(rng.integers(5, 300) / 10), float(rng.integers(1, 50) / 10)


def fused(sigma, H, across):
    return sigma * across / np.sqrt(sigma**2 * H**2 + across**2)


@exercise(
    hints=[
        "One state: the place s along the needle, with variance σ². Its reading is s·sin(turn), across the new line.",
        "P after a reading is 1/(1/σ² + H²/R), with H = sin(turn) and R = across². NumPy's sine wants radians.",
        "`H = np.sin(np.radians(turn))`, and `return 1 / np.sqrt(1 / sigma**2 + H**2 / across**2)`.",
    ],
    inputs=needles,
    wrong={
        "degrees as radians": (
            lambda s, turn, r: fused(s, np.sin(turn), r),
            "NumPy's sine wants radians: `np.sin(np.radians(turn))`.",
        ),
        "cosine": (
            lambda s, turn, r: fused(s, np.cos(np.radians(turn)), r),
            "You took the cosine. A needle that is not turned at all shows nothing of its length across the line: H is the sine.",
        ),
        "tangent": (
            lambda s, turn, r: fused(s, np.tan(np.radians(turn)), r),
            "You took the tangent of the turn; the length σ along the needle shows σ·sin(turn) across the new line.",
        ),
        "no turn": (
            lambda s, turn, r: fused(s, 1, r),
            "You fused as if the reading saw the needle at full length: H is the sine of the turn, not 1.",
        ),
        "variance": (
            lambda s, turn, r: fused(s, np.sin(np.radians(turn)), r) ** 2,
            "That is the variance; asked is the standard deviation.",
        ),
        "the reading alone": (
            lambda s, turn, r: r / np.sin(np.radians(turn)),
            "Nearly: that is what the reading alone says, across/sin(turn). The needle's own σ knows something too; fuse them.",
        ),
        "as seen across": (
            lambda s, turn, r: s * np.sin(np.radians(turn)),
            "σ·sin(turn) is how broad the needle seems before the reading. What is left of σ after it?",
        ),
        "what is left across": (
            lambda s, turn, r: np.sin(np.radians(turn)) * fused(s, np.sin(np.radians(turn)), r),
            "That is the doubt left *across the new line*; asked is the one along the needle, 1/sin(turn) times as long.",
        ),
        "standard deviations for variances": (
            lambda s, turn, r: s * r / (s * np.sin(np.radians(turn)) + r),
            "You added standard deviations. Variances add: σ² sin² + across², and then the root.",
        ),
        "H not squared": (
            lambda s, turn, r: fused(s, np.sqrt(np.sin(np.radians(turn))), r),
            "H P Hᵀ has the sine twice: sin² times σ².",
        ),
        "across taken for a variance": (
            lambda s, turn, r: fused(s, np.sin(np.radians(turn)), np.sqrt(r)),
            "`across` is a standard deviation; R is its square.",
        ),
        "unchanged": (
            lambda s, turn, r: s,
            "That would be right for a turn of 0. Here the filter believes that it sees the needle from the side.",
        ),
    },
)
def false_range(sigma, turn, across):
    """What is left of a needle's sigma (m) after a reading across a line turned by `turn` degrees, good to `across` m."""
    H = np.sin(np.radians(turn))
    return sigma * across / np.sqrt((sigma * H) ** 2 + across**2)


def some_errors(rng):
    """Errors of a few runs, steps and nine states."""
    return (rng.integers(-9, 10, (4, 5, 9)).astype(float) * [5, 5, 5, 2, 2, 2, 1, 1, 1],)


@exercise(
    hints=[
        "Root of the mean of the squares, read from the back: square, mean, root. The mean goes over the runs, axis 0.",
        "The squared length of the position error is the sum of its three squares. Velocity has indices 3 to 5, acceleration 6 to 8.",
        "`return [np.sqrt(np.mean(np.sum(error[..., k : k + 3] ** 2, axis=-1), axis=0)) for k in (0, 3, 6)]`.",
    ],
    inputs=some_errors,
    wrong=WRONG["figures"],
)
def figures(error):
    """The root mean square errors of position, velocity and acceleration, (3, T), of errors (runs, T, 9)."""
    return np.array([np.sqrt(np.mean(np.sum(error[..., k : k + 3] ** 2, axis=-1), axis=0)) for k in (0, 3, 6)])
