"""Wrong answers to the exercise of lesson 21 that is done by hand, each with the sentence that it gets."""

import numpy as np


def first(K1, K2=0.0, form="joseph", S=None):
    """P after the reading of exercise 2, with a gain that may be wrong."""
    P, H, K = np.diag([4.0, 1.0]), np.array([[1.0, 1.0]]), np.array([[K1], [K2]])
    keep = np.eye(2) - K @ H
    return {"joseph": keep @ P @ keep.T + K * 0.25 @ K.T, "short": keep @ P, "no R": keep @ P @ keep.T}[form]


K = 4 / 5.25
FIRST_COVARIANCE = {
    "estimated": (
        first(K, 1 / 5.25),
        "In your P the bias has been learnt, P₂₂ = 0.81. That is the augmented filter. Here the bias is "
        "considered: its row of K is zero, and its variance stays 1.",
    ),
    "P12 alone": (
        -K,
        "That is the entry P₁₂, and it is right; but an estimated bias would have it too. Hand in the whole "
        "matrix P, two rows of two numbers.",
    ),
    "P12, sign": (
        K,
        "Mind the sign. A positive bias pulls the estimate up, so position *minus* estimate goes down. And hand "
        "in the whole matrix P.",
    ),
    "short form": (
        first(K, form="short"),
        "Your P is not symmetric. That is what (I − KH)P⁻ gives, which holds for the best gain only, and here the gain "
        "has a row of zeros. Use (9J).",
    ),
    "symmetrised": (
        np.array([[4 * (1 - K), -K / 2], [-K / 2, 1]]),
        "Making (I − KH)P⁻ symmetric does not make it right: it holds for the best gain only. Use (9J).",
    ),
    "no R": (
        first(K, form="no R"),
        "The term KRKᵀ is missing: the noise of the reading came in through K as well.",
    ),
    "no covariance": (
        np.array([[4 * (1 - K), 0], [0, 1]]),
        "It was diagonal before the reading. The reading brought the bias into the estimate, so the two are "
        "correlated now: P₁₂ is not zero.",
    ),
    "sign": (
        np.array([[4 * (1 - K), K], [K, 1]]),
        "Mind the sign of P₁₂. A positive bias pulls the estimate up, so position *minus* estimate goes down.",
    ),
    "bias not in S": (
        first(4 / 4.25),
        "Your gain lacks the bias: S = 4 + 1 + 0.25, because the innovation holds the bias too.",
    ),
    "only the position": (
        np.diag([4 * 0.25 / 4.25, 1.0]),
        "Here the position is corrected as if there were no bias. H = [1, 1]: the reading holds the bias too, so S = 5.25, and the two become correlated.",
    ),
    "nothing": (
        np.diag([4.0, 1.0]),
        "That is P⁻, before the reading. The position was corrected: its variance falls, and it is now correlated"
        " with the bias.",
    ),
    "zero": (
        0.0,
        "It was zero before the reading. The reading brought the bias into the estimate, so the two are "
        "correlated now. Hand in the whole matrix P.",
    ),
    "both rows swapped": (
        first(0.0, 1 / 5.25),
        "Here the position keeps its variance, 4, and the bias is learnt. The bias, the second state, is the one that is considered: its row of K is zero.",
    ),
    "bias not in S, P12": (
        -4 / 4.25,
        "Your innovation variance lacks the bias: S = 4 + 1 + 0.25. And hand in the whole matrix P.",
    ),
    "K times P": (
        -16 / 5.25,
        "−3.05 is −K₁ times the variance of the position, 4; what comes into the estimate is the bias, with variance 1. And hand in the whole matrix P.",
    ),
    "gain of the bias": (
        -1 / 5.25,
        "−1/5.25 holds the gain that the bias is not given. Take the row of zeros for it, and hand in the whole "
        "matrix P.",
    ),
    "position's variance": (
        4 * (1 - K),
        "That is P₁₁, and it is right. Hand in the whole matrix P, two rows of two numbers.",
    ),
}
