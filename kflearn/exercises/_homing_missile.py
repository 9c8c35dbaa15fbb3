"""Wrong answers to exercises of lesson 16, each with the sentence that it gets."""

import numpy as np


def powers(e, v, t0, t, low=1, high=3, sign=-1):
    """a tˡ + b tʰ that starts as e, with the slope sign·v against the time to go."""
    a, b = np.linalg.solve([[t0**low, t0**high], [low * t0 ** (low - 1), high * t0 ** (high - 1)]], [e, sign * v])
    return a * t**low + b * t**high


def three(error):
    """The squared lengths of position, velocity and acceleration errors: three arrays (runs, T)."""
    return [np.sum(error[..., k : k + 3] ** 2, axis=-1) for k in (0, 3, 6)]


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
        "coasting from here": (
            lambda e, v, t0, t: e + v * t,
            "You let the error coast for t seconds. t is the time still to go; and the error does not coast, both are steered.",
        ),
        "coasting, scaled": (
            lambda e, v, t0, t: (e + v * (t0 - t)) * t / t0,
            "You let the error coast and scaled it by t/t₀. Neither part is right alone: fit a·t + b·t³ to e and to v at t₀.",
        ),
        "line plus coasting": (
            lambda e, v, t0, t: e * t / t0 + v * (t0 - t),
            "You added the coasting of v to a straight line. Fit a·t + b·t³: its value at t₀ is e, its slope against t is −v.",
        ),
        "e and v as coefficients": (
            lambda e, v, t0, t: e * t + v * t**3,
            "You took e and v themselves for a and b. They are the error and its velocity at t₀: two equations for a and b.",
        ),
        "time gone": (
            lambda e, v, t0, t: e * (1 - t / t0),
            "You took t for the time that has passed. It is the time to go: at t = t₀ the whole error is still there.",
        ),
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
        "every third": (
            lambda e: [np.sqrt(np.mean(np.sum(e[..., k::3] ** 2, axis=-1), axis=0)) for k in (0, 1, 2)],
            "`k::3` takes every third state, one of the position, one of the velocity, one of the acceleration. The three "
            "of a kind stand side by side: `k : k + 3`.",
        ),
        "in the wrong order": (
            lambda e: [np.sqrt(s.mean(axis=0)) for s in three(e)[::-1]],
            "The three series are right, in the wrong order: position, velocity, acceleration.",
        ),
        "the worst": (
            lambda e: [np.sqrt(s.max(axis=0)) for s in three(e)],
            "You took the worst run. Asked is the root of the *mean* of the squares over the runs.",
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
        "for each run": (
            lambda e: [np.sqrt(s) for s in three(e)],
            "These are the distances of each run. The mean of their squares over the runs is missing, before the root.",
        ),
        "nine rows": (
            lambda e: np.sqrt(np.mean(e**2, axis=0)),
            "That is one column for each of the nine states. Put three axes together: add their squares before the mean.",
        ),
        "two series": (
            lambda e: [np.sqrt(s.mean(axis=0)) for s in three(e)[:2]],
            "The first two are right; the third series, the acceleration's (indices 6 to 8), is missing.",
        ),
        "one axis": (
            lambda e: [np.sqrt(np.mean(e[..., k] ** 2, axis=0)) for k in (0, 3, 6)],
            "You took the first axis of each alone. Position, velocity and acceleration have three axes each: add their squares.",
        ),
        "two axes": (
            lambda e: [np.sqrt(np.mean(np.sum(e[..., k : k + 2] ** 2, axis=-1), axis=0)) for k in (0, 3, 6)],
            "You took two axes of three: `k : k + 2` ends before k + 2.",
        ),
        "mean size": (
            lambda e: [np.mean(abs(e[..., k : k + 3]), axis=(0, 2)) for k in (0, 3, 6)],
            "Those are mean sizes of the errors of an axis. Add the squares of three axes, take the mean over the runs, then the root.",
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
        "rate and time swapped, not squared": (
            lambda lasts, sd, dt: (np.exp(-lasts * dt), sd**2 * (1 - np.exp(-lasts * dt))),
            "Two things: λ is 1/lasts, not lasts; and the variance that survives is part² times sd².",
        ),
    },
}
