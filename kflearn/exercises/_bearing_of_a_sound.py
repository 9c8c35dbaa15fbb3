"""Wrong answers to exercises of bearing_of_a_sound, each with the sentence that it gets."""

import math

import numpy as np


def rows(dt):
    return np.array([[1, dt], [0, 1]])


def as_published(P, Q, dt):
    """The published prediction."""
    return np.array([[P[0, 0] + dt * P[1, 0] + Q[0, 0], P[0, 1] + P[1, 1]], [dt * P[1, 0], P[1, 1] + Q[1, 1]]])


WRONG = {
    "wrap": {
        "untouched": (
            lambda d: d,
            "That hands the difference back as it came: 8 − 339 is still −331, the long way round.",
        ),
        "% 360": (
            lambda d: d % 360,
            "That lies between 0 and 360, as by `% 360`: 3° to the left become 357° to the right.",
        ),
        "absolute value": (
            lambda d: abs((d + 180) % 360 - 180),
            "The size is right, but the sign is lost: the filter would turn the same way for a reading on the left and one on the right.",
        ),
        "absolute value first": (
            lambda d: abs(d) % 360,
            "The direction is lost, as by `abs`; and the result still goes up to 360.",
        ),
        "absolute value only": (
            lambda d: abs(d),
            "The direction is lost, as by `abs`, and nothing shortened: 331 is as long a way as −331.",
        ),
        "radians": (
            lambda d: (d + math.pi) % (2 * math.pi) - math.pi,
            "That wraps at π, as for radians; these are degrees, a turn is 360.",
        ),
        "radians returned": (
            lambda d: math.radians((d + 180) % 360 - 180),
            "It is wrapped as it should be, but in radians; the filter works in degrees.",
        ),
        "from 0 to 360 with half a turn": (
            lambda d: (d + 180) % 360,
            "A difference of 0 becomes 180: after the remainder half a turn must come off.",
        ),
        "half a turn as period": (
            lambda d: (d + 90) % 180 - 90,
            "That wraps with a period of 180: a voice behind is then taken for one in front.",
        ),
        "only downwards": (
            lambda d: d - 360 if d > 180 else d,
            "You mend differences above 180 only; 8 − 339 = −331 needs a turn added.",
        ),
        "only upwards": (
            lambda d: d + 360 if d < -180 else d,
            "You mend differences below −180 only; 339 − 8 = 331 needs a turn taken off.",
        ),
        "one turn only": (
            lambda d: d - 360 if d > 180 else d + 360 if d < -180 else d,
            "Right for one turn. But the estimate itself is never wrapped and may be several turns on: use the remainder, `%`.",
        ),
        "C's remainder": (
            lambda d: math.fmod(d + 180, 360) - 180,
            "What lies below −180 becomes too low: `fmod` and `int` cut towards zero, as C does; Python's `%` does not.",
        ),
        "the other way round": (
            lambda d: -((d + 180) % 360 - 180),
            "The size is right and the sign is the opposite: the filter would walk away from the sound.",
        ),
        "arcsine of the sine": (
            lambda d: math.degrees(math.asin(math.sin(math.radians(d)))),
            "The arcsine knows only −90 to 90: that is the front/back ambiguity of the two microphones again.",
        ),
        "moved down only": (
            lambda d: d % 360 - 180,
            "After the remainder you moved down by half a turn, so a difference of 0 becomes −180. What must be done before the remainder?",
        ),
        "half turns taken off": (
            lambda d: d % 180,
            "That takes off half turns: a difference of 190 becomes 10, though that is on the other side. A turn is 360.",
        ),
        "up twice": (
            lambda d: (d + 180) % 360 + 180,
            "A difference of 0 becomes 360: after the remainder half a turn must come off, not be added.",
        ),
        "two turns": (
            lambda d: next((d + 360 * k for k in (0, -1, 1, -2, 2) if abs(d + 360 * k) <= 180), d),
            "Right for two turns. After three the difference is beyond 900, and you leave it there: the remainder, `%`, takes off any number of turns.",
        ),
    },
    "offset": {
        "one push": (
            lambda x1, K, dt: dt * x1,
            "One step adds dt·x₁. The correction takes a part away, and what it leaves piles up.",
        ),
        "one push, corrected once": (
            lambda x1, K, dt: (1 - K) * dt * x1,
            "That is the offset after the first step. What is left of it is there when the next push comes: let it pile up until it rests.",
        ),
        "before the correction": (
            lambda x1, K, dt: dt * x1 / K,
            "That is the offset of the prediction; the correction leaves the part 1 − K of it.",
        ),
        "dt forgotten": (
            lambda x1, K, dt: x1 * (1 - K) / K,
            "dt is missing: one step adds dt·x₁, not x₁.",
        ),
        "K and 1 − K swapped": (
            lambda x1, K, dt: dt * x1 * K / (1 - K),
            "K and 1 − K have changed places: with K near 1 the correction takes nearly all of the push away, so the offset is small.",
        ),
        "negative": (
            lambda x1, K, dt: -dt * x1 * (1 - K) / K,
            "The sign: a rate that is stuck at a positive value pushes the estimate above the readings. Offset means estimate minus truth.",
        ),
        "divided by dt": (
            lambda x1, K, dt: x1 * (1 - K) / (K * dt),
            "You divided by dt; degrees per second times seconds give degrees.",
        ),
        "sum of pushes": (
            lambda x1, K, dt: dt * x1 / (1 - K),
            "That is for pushes of which the part K survives a correction; it is the part 1 − K.",
        ),
        "what is taken away": (
            lambda x1, K, dt: K * dt * x1,
            "K·dt·x₁ is what the first correction takes away; 1 − K is left of each push, and the pushes pile up.",
        ),
        "dt forgotten, before the correction": (
            lambda x1, K, dt: x1 / K,
            "Two things are missing: dt, and the factor 1 − K that the correction leaves.",
        ),
        "none": (
            lambda x1, K, dt: 0.0,
            "A zero offset would need a rate of zero, or a gain of 1. Here each step pushes by dt·x₁.",
        ),
    },
    "right_prediction": {
        "as published": (
            as_published,
            "That is the published one again: its corners use F₀₀ and F₁₁ where F₀₁ belongs, and there is no Fᵀ.",
        ),
        "F P + Q": (
            lambda P, Q, dt: rows(dt) @ P + Q,
            "Half of the published fault is still there: Fᵀ is missing on the right, so the result is not symmetric.",
        ),
        "P Fᵀ + Q": (
            lambda P, Q, dt: P @ rows(dt).T + Q,
            "Fᵀ on the right is there, but F on the left is missing.",
        ),
        "F P F + Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt) + Q,
            "The right-hand F must be transposed. A covariance is symmetric; print yours and look at its corners.",
        ),
        "Fᵀ P F + Q": (
            lambda P, Q, dt: rows(dt).T @ P @ rows(dt) + Q,
            "Fᵀ P F, or dt in the wrong corner: here an uncertain angle makes the rate uncertain. It is the other way round.",
        ),
        "forgot Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T,
            "F P Fᵀ is right, but the jolts of the step are missing: add Q.",
        ),
        "forgot F": (
            lambda P, Q, dt: P + Q,
            "That is P + Q. An uncertain rate makes the angle more uncertain with every dt: F P Fᵀ.",
        ),
        "entry by entry": (
            lambda P, Q, dt: rows(dt) * P * rows(dt).T + Q,
            "P's corners are gone, as by *, entry by entry. The matrix product is @.",
        ),
        "dt forgotten": (
            lambda P, Q, dt: rows(1) @ P @ rows(1).T + Q,
            "That is F with a 1 in its corner; there belongs dt, the time between two readings.",
        ),
        "Q scaled": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T + dt * Q,
            "F P Fᵀ is right. Q is given per step already: add it as it is.",
        ),
        "minus Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T - Q,
            "Q is taken away: time makes a belief wider, never sharper.",
        ),
        "diagonal of Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T + np.diag(np.diag(Q)),
            "F P Fᵀ is right. Of Q you add the diagonal only; it may have corners, so add the whole matrix.",
        ),
        "first entry of Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T + Q[0, 0] * np.eye(2),
            "F P Fᵀ is right. You add Q's first entry twice, as in the published program; here Q is a whole matrix.",
        ),
        "Q added first": (
            lambda P, Q, dt: rows(dt) @ (P + Q) @ rows(dt).T,
            "F acts on the jolts of this step too, as if Q were added before the move. First F P Fᵀ, then + Q.",
        ),
        "upper left by hand": (
            lambda P, Q, dt: (rows(dt) @ P @ rows(dt).T + Q) - np.diag([dt * P[0, 1] + dt**2 * P[1, 1], 0]),
            "The corners are right. The upper left entry is not: it takes dt·P₁₀, dt·P₀₁ and dt²·P₁₁. Let F P Fᵀ do it.",
        ),
        "P on both sides": (
            lambda P, Q, dt: P @ rows(dt) @ P.T + Q,
            "F and P have changed places: F stands on both sides, P in the middle.",
        ),
    },
    "right_update": {
        "as published": (
            lambda P, K: P * (1 - np.outer(K, [1, 0])),
            "That is the published one again: entry by entry. The rate's variance (lower right) never shrinks, whatever is heard.",
        ),
        "(I − KH) entry by entry": (
            lambda P, K: (np.eye(2) - np.outer(K, [1, 0])) * P,
            "The bracket is right, but * multiplies entry by entry: use @.",
        ),
        "rows scaled": (
            lambda P, K: (1 - K)[:, None] * P,
            "You scaled each row with its own 1 − K. But the rate learns *through the angle*: row 1 loses K₁ times row 0.",
        ),
        "one gain for all": (
            lambda P, K: (1 - K[0]) * P,
            "That is the scalar filter's line: right for the first row, but the rate's own variance shrinks by K₁·P₀₁.",
        ),
        "P (I − KH)": (
            lambda P, K: P @ (np.eye(2) - np.outer(K, [1, 0])),
            "The bracket stands on the wrong side: (I − KH) comes before P.",
        ),
        "plus": (
            lambda P, K: P + np.outer(K, P[0]),
            "The sign: hearing something makes the belief sharper, so KHP is taken away.",
        ),
        "KHP": (
            lambda P, K: np.outer(K, P[0]),
            "That is KHP, what the reading takes away; what is left is P − KHP.",
        ),
        "squared gains": (
            lambda P, K: P - np.outer(K, K),
            "You subtracted K Kᵀ. It should be K H P; K Kᵀ lacks the factor S.",
        ),
        "H transposed": (
            lambda P, K: (np.eye(2) - np.outer([1, 0], K)) @ P,
            "You formed Hᵀ Kᵀ. K is the column, H the row: np.outer(K, [1, 0]).",
        ),
        "unchanged": (
            lambda P, K: P,
            "P is handed back unchanged: then it only grows from reading to reading, and the gain of the angle goes towards 1.",
        ),
        "columns scaled": (
            lambda P, K: P - K * P,
            "Each column is scaled, as by `K * P`. What is taken away is the matrix K H P: the column K times the first row of P.",
        ),
        "K @ H is a number": (
            lambda P, K: (np.eye(2) - K[0]) @ P,
            "K₀ is taken from all entries, as by `K @ H`. K H is a matrix, a column times a row: np.outer(K, [1, 0]).",
        ),
        "column for row": (
            lambda P, K: P - np.outer(K, P[:, 0]),
            "Right for a symmetric P. H P is the first *row* of P, you took the first column; and this P is not symmetric.",
        ),
        "both sides": (
            lambda P, K: (np.eye(2) - np.outer(K, [1, 0])) @ P @ (np.eye(2) - np.outer(K, [1, 0])).T,
            "You multiplied by (I − KH) on both sides. That is the first half of Joseph's form, which also needs K R Kᵀ. Here it is once, on the left.",
        ),
        "P forgotten": (
            lambda P, K: np.eye(2) - np.outer(K, [1, 0]),
            "I − KH is right; it still has to be multiplied by P, with @.",
        ),
        "symmetrised": (
            lambda P, K: (lambda Q: (Q + Q.T) / 2)(P - np.outer(K, P[0])),
            "You made the result symmetric afterwards. For this P and K the product (I − KH)P is not symmetric: leave it as it is.",
        ),
        "second gain unused": (
            lambda P, K: P - np.outer([K[0], P[1, 0] / P[0, 0] * K[0]], P[0]),
            "You worked out the second gain from P and did not use K[1]. The update must work for any gain: use both numbers of K.",
        ),
        "outer turned round": (
            lambda P, K: P - np.outer(P[0], K),
            "Yours is the transpose of K H P. In `np.outer` the column comes first: K, then the row H P.",
        ),
        "K Kᵀ": (
            lambda P, K: (np.eye(2) - np.outer(K, K)) @ P,
            "You formed K Kᵀ. In the bracket stands K H, with the row H = [1, 0].",
        ),
    },
}
