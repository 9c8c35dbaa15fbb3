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
            0.5,
            "0.5 comes from a prediction with a variance of 4 V² only. What is left from the first reading and what Q adds belong together: P⁻ = P + Q.",
        ),
        "1 − K": (1 / 3, "That is 1 − K, the weight of the prediction; the gain has P on top."),
        "σ for σ²": (
            math.sqrt(8) / (math.sqrt(8) + 2),
            "You weighed with standard deviations; the gain takes variances.",
        ),
        "steady gain": (0.618034, "That is where the gain comes to rest later; the second reading meets a larger one."),
        "Q twice": (0.75, "Q was added twice: only one prediction lies between the first and the second reading."),
        "P before": (
            8,
            "8 V² is the variance before the second reading. The gain is a pure number: which part of P⁻ + R is it?",
        ),
        "P after": (
            8 / 3,
            "8/3 V² is the variance after the second reading. The gain is a pure number, between 0 and 1.",
        ),
        "third": (
            0.625,
            "That is the gain for the third reading. The first reading made the start, so there is one prediction before the second.",
        ),
        "R not added": (
            2,
            "You divided P⁻ by R alone. The gain is a part of the whole: P⁻/(P⁻ + R), never more than 1.",
        ),
        "first": (
            1,
            "A gain of 1 would believe the reading alone; that is how the filter starts. Go on to the second reading.",
        ),
        "Q alone": (4, "4 V² is a variance. The gain is a pure number, between 0 and 1."),
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
            "Nearly: the solution of a quadratic equation is divided by 2.",
        ),
        "4 for 4q": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + 4) - Q / R) / 2,
            "You solved K² + qK − 1 = 0. The last term is q: K² + qK − q = 0.",
        ),
        "sign of q": (
            lambda Q, R: (math.sqrt((Q / R) ** 2 + 4 * Q / R) + Q / R) / 2,
            "You solved K² − qK − q = 0. Look at the sign of the middle term: a gain is at most 1.",
        ),
        "P before the reading": (
            lambda Q, R: R * (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2 + Q,
            "That is P⁻, the variance before the reading, in V². The gain is P⁻/(P⁻ + R), a pure number.",
        ),
        "1 steps": (
            lambda Q, R: after(Q, R, 1),
            "After 1 steps the recursion has not yet come to rest, where Q is small beside R. Let it run for a hundred.",
        ),
        "2 steps": (
            lambda Q, R: after(Q, R, 2),
            "After 2 steps the recursion has not yet come to rest, where Q is small beside R. Let it run for a hundred.",
        ),
        "5 steps": (
            lambda Q, R: after(Q, R, 5),
            "After 5 steps the recursion has not yet come to rest, where Q is small beside R. Let it run for a hundred.",
        ),
        "10 steps": (
            lambda Q, R: after(Q, R, 10),
            "After 10 steps the recursion has not yet come to rest, where Q is small beside R. Let it run for a hundred.",
        ),
        "20 steps": (
            lambda Q, R: after(Q, R, 20),
            "After 20 steps the recursion has not yet come to rest, where Q is small beside R. Let it run for a hundred.",
        ),
        "30 steps": (
            lambda Q, R: after(Q, R, 30),
            "After 30 steps the recursion has not yet come to rest, where Q is small beside R. Let it run for a hundred.",
        ),
    },
    "is_unknown": {
        "as published": (
            lambda x: np.isnan(x).all(),
            "That is the published test again: it says yes only when every entry is unknown.",
        ),
        "the wrong way round": (lambda x: not np.isnan(x).any(), "Your function says yes when the start is known."),
        "only the first": (lambda x: np.isnan(x[0]), "You look at the first entry only; NaN may sit in any of them."),
        "x == nan": (
            lambda x: (x == np.nan).any(),
            "NaN equals nothing, not even itself, so x == np.nan is always False: use np.isnan.",
            "==",
        ),
        "always False": (
            lambda x: False,
            "Your function says False whatever the state is. Ask each entry with np.isnan first, and any() afterwards.",
        ),
        "always True": (lambda x: True, "Your function says True whatever the state is."),
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
    },
    "auto_start": {
        "H⁻¹R only": (
            lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R)),
            "Your x is right. P lacks its right-hand factor: H⁻¹R is not symmetric, and no covariance; multiply by H⁻ᵀ.",
        ),
        "P = R": (
            lambda z, H, R: (np.linalg.solve(H, z), R),
            "Your x is right. R is the covariance of z; that of x = H⁻¹z is H⁻¹RH⁻ᵀ.",
        ),
        "H⁻¹RH⁻¹": (
            lambda z, H, R: (np.linalg.solve(H, z), np.linalg.solve(H, R) @ np.linalg.inv(H)),
            "Your x is right. In P the second inverse must be transposed: H⁻¹RH⁻ᵀ.",
        ),
        "HRHᵀ": (
            lambda z, H, R: (np.linalg.solve(H, z), H @ R @ H.T),
            "Your x is right. HRHᵀ goes from states to measurements; here you go back, with inverses.",
        ),
        "z itself": (
            lambda z, H, R: (z, R),
            "You returned z and R. They belong to the measurement, not to the state: undo H first. The two agree only for H = 1.",
        ),
        "Hz": (
            lambda z, H, R: (H @ z, H @ R @ H.T),
            "You applied H once more instead of undoing it: z = Hx, so x = H⁻¹z.",
        ),
        "z for x": (
            lambda z, H, R: (z, np.linalg.inv(H) @ R @ np.linalg.inv(H).T),
            "P is right. But z is the measurement: for the state, undo H here too.",
        ),
        "transposes exchanged": (
            lambda z, H, R: (np.linalg.inv(H) @ z, np.linalg.inv(H).T @ R @ np.linalg.inv(H)),
            "Your x is right. In P the transpose is on the wrong side: the error of x is H⁻¹v, so H⁻¹ stands on the left.",
        ),
        "H⁻¹RH": (
            lambda z, H, R: (np.linalg.inv(H) @ z, np.linalg.inv(H) @ R @ H),
            "Your x is right. In P both sides undo H: the right-hand factor is the transpose of H⁻¹.",
        ),
        "Hᵀ for H⁻¹": (lambda z, H, R: (H.T @ z, H.T @ R @ H), "You used Hᵀ where the inverse of H is needed."),
        "divided": (
            lambda z, H, R: (z / np.diag(H), R / np.outer(np.diag(H), np.diag(H))),
            "You divided by the diagonal of H. The corners count too: use the inverse of the matrix.",
        ),
        "entry by entry": (
            lambda z, H, R: ((z / H), R / H**2),
            "You divided by H entry by entry. A matrix is undone by its inverse: np.linalg.inv or np.linalg.solve.",
        ),
    },
}
