"""Lesson 8, `right_update`: wrong answers, each with the sentence that it gets."""

import numpy as np


def row_by_row(P, K):
    """The second row is made of the first one when that is changed already."""
    M = np.array(P, float)
    M[0] = (1 - K[0]) * M[0]
    M[1] = M[1] - K[1] * M[0]
    return M


WRONG = {
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
    "1 for I": (
        lambda P, K: (1 - np.outer(K, [1, 0])) @ P,
        "`1 - K H` takes K H from a matrix full of ones. I is the identity, `np.eye(2)`.",
    ),
    "K * H": (
        lambda P, K: (np.eye(2) - K * np.array([1, 0])) @ P,
        "`K * H` of two vectors multiplies entry by entry: that is [K₀, 0], which NumPy then takes from each row. K H is a matrix, a column times a row.",
    ),
    "own gain": (
        lambda P, K: (np.eye(2) - np.outer(P[:, 0] / (P[0, 0] + 1e-6), [1, 0])) @ P,
        "You work out a gain of your own. The update is wanted for the K that is handed in.",
    ),
    "own gain, R = 1": (
        lambda P, K: (np.eye(2) - np.outer(P[:, 0] / (P[0, 0] + 1), [1, 0])) @ P,
        "You work out a gain of your own, with R = 1. The update is wanted for the K that is handed in.",
    ),
    "on the right": (
        lambda P, K: P - np.outer(P[:, 0], K),
        "You took P HᵀKᵀ away: the bracket on the right, transposed. Here (I − KH) stands on the left of P.",
    ),
    "upper left for all": (
        lambda P, K: P - K * P[0, 0],
        "`K * P[0, 0]` is two numbers, taken from each row. What is taken away is a matrix: the column K times the first row of P.",
    ),
    "K @ P": (
        lambda P, K: P - K @ P,
        "`K @ P` is a row, taken from both rows of P. K H P is a matrix: the column K times the first row of P.",
    ),
    "P added": (
        lambda P, K: np.eye(2) - np.outer(K, [1, 0]) + P,
        "The bracket is to be multiplied by P, not added.",
    ),
    "other column": (
        lambda P, K: (np.eye(2) - np.outer(K, [0, 1])) @ P,
        "That is H = [0, 1], as if the rate were read. Here the angle is: H = [1, 0].",
    ),
    "first row too early": (
        row_by_row,
        "Your second row takes the first row when that is already changed. It needs the old one, P[0].",
    ),
    "only the diagonal": (
        lambda P, K: P - np.diag(np.diag(P) * K),
        "You shrink the diagonal only, and P₁₁ by 1 − K₁. Every entry of the row i loses K_i times the first row of P: the last "
        "one becomes P₁₁ − K₁·P₀₁.",
    ),
    "1 − K₀ in the second column": (
        lambda P, K: P * np.array([[1 - K[0], 1 - K[0]], [1 - K[1], 1 - K[0]]]),
        "Your first row is right. The second is P[1] − K[1] · P[0]: what is taken off is made of the *first* row of P.",
    ),
}
