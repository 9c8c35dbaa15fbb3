"""Wrong answers to exercises of lesson 14, each with the sentence that it gets."""

import numpy as np


def powers(e, v, t0, t, low=1, high=3, sign=-1):
    """a tˡ + b tʰ that starts as e, with the slope sign·v against the time to go."""
    a, b = np.linalg.solve([[t0**low, t0**high], [low * t0 ** (low - 1), high * t0 ** (high - 1)]], [e, sign * v])
    return a * t**low + b * t**high


def three(error):
    """The squared lengths of position, velocity and acceleration errors: three arrays (runs, T)."""
    return [np.sum(error[..., k : k + 3] ** 2, axis=-1) for k in (0, 3, 6)]


def fused(sigma, H, across):
    return sigma * across / np.sqrt(sigma**2 * H**2 + across**2)


WRONG = {
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
            "You took a·t alone. That fits the error at t₀, but not its velocity: for that you need b·t³ too.",
        ),
        "cubic alone": (
            lambda e, v, t0, t: e * (t / t0) ** 3,
            "You took b·t³ alone. That fits the error at t₀, but not its velocity: for that you need a·t too.",
        ),
        "velocity forgotten": (
            lambda e, v, t0, t: powers(e, 0, t0, t),
            "You took the error's velocity for zero; it is v, and with v = −e/t₀ the whole error would be a·t.",
        ),
        "velocity taken for a": (
            lambda e, v, t0, t: -v * t + (e + v * t0) / t0**3 * t**3,
            "You took −v for a. But −v is the slope at t₀, where the cubic has a slope as well: −v = a + 3b·t₀².",
        ),
        "square in place of cube": (
            lambda e, v, t0, t: powers(e, v, t0, t, 1, 2),
            "You took a·t + b·t². The powers are 1 and N, and N is 3.",
        ),
        "constant in place of line": (
            lambda e, v, t0, t: powers(e, v, t0, t, 0, 3),
            "You took a + b·t³. The powers are 1 and 3; a constant would not vanish at the impact.",
        ),
        "where it would hit": (
            lambda e, v, t0, t: e + v * t0,
            "e + v·t₀ is the error that coasting would leave at the impact; the law works against it all the way.",
        ),
        "unchanged": (
            lambda e, v, t0, t: e,
            "You handed back the error at t₀. It shrinks as t does, although nothing is measured.",
        ),
        "nothing left": (lambda e, v, t0, t: 0.0, "Zero is right only at t = 0, the impact."),
    },
    "figures": {
        "as published": (
            lambda e: [np.sqrt(s).mean(axis=0) for s in (three(e)[0], three(e)[1], three(e)[1])],
            "Both published faults are still there: mean distances, and a third series that is the velocity's.",
        ),
        "only the third mended": (
            lambda e: [np.sqrt(s).mean(axis=0) for s in three(e)],
            "The third series is mended. But these are mean distances: square first, then the mean, and the root last.",
        ),
        "only the RMS mended": (
            lambda e: [np.sqrt(s.mean(axis=0)) for s in (three(e)[0], three(e)[1], three(e)[1])],
            "The RMS is mended. But your third series is still the velocity's: the acceleration has the indices 6 to 8.",
        ),
        "per axis": (
            lambda e: [np.sqrt(s.mean(axis=0) / 3) for s in three(e)],
            "You averaged over the three axes as well, which gives the RMS *per axis*, smaller by √3. Sum over the axes.",
        ),
        "no root": (
            lambda e: [s.mean(axis=0) for s in three(e)],
            "These are mean squares, in m²: the root is missing.",
        ),
        "over time": (
            lambda e: [np.sqrt(s.mean(axis=1)) for s in three(e)],
            "You averaged over the time, axis 1, which gives one number a run. Asked is one a step: average over the runs, axis 0.",
        ),
        "over everything": (
            lambda e: [np.sqrt(s.mean()) for s in three(e)],
            "You averaged over runs and time. Asked is a series: average over the runs, axis 0, only.",
        ),
        "length of the mean": (
            lambda e: [np.linalg.norm(e[..., k : k + 3].mean(axis=0), axis=-1) for k in (0, 3, 6)],
            "You averaged the errors before squaring them: errors to the left and to the right cancel, and only the bias is left.",
        ),
        "sums": (
            lambda e: [np.sqrt(s.sum(axis=0)) for s in three(e)],
            "You summed over the runs: more runs would make the error larger. Take the mean.",
        ),
        "for each state": (
            lambda e: np.moveaxis(np.sqrt(np.mean(e**2, axis=0)), -1, 0),
            "That is one series for each of the nine states. Put three axes together: add their squares.",
        ),
        "spread": (
            lambda e: [np.sqrt(sum(e[..., k + i].var(axis=0) for i in range(3))) for k in (0, 3, 6)],
            "`var` and `std` take the mean away first: a filter that is off by the same kilometre in every run would score 0.",
        ),
        "one column each": (
            lambda e: np.stack([np.sqrt(s.mean(axis=0)) for s in three(e)], axis=-1),
            "The numbers are right; hand them back as three series, each (T,), not as T rows of three.",
        ),
    },
    "memory": {
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
    "false_range": {
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
}
