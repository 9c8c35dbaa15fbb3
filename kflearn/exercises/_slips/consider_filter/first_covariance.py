"""Lesson 21, `first_covariance`: wrong answers, each with the sentence that it gets."""

import numpy as np

K = 4 / 5.25


def first(K1, K2=0.0, form="joseph", S=None):
    """P after the reading of exercise 2, with a gain that may be wrong."""
    P, H, K = np.diag([4.0, 1.0]), np.array([[1.0, 1.0]]), np.array([[K1], [K2]])
    keep = np.eye(2) - K @ H
    return {"joseph": keep @ P @ keep.T + K * 0.25 @ K.T, "short": keep @ P, "no R": keep @ P @ keep.T}[form]


def first_gain(k, R=0.25, S=None, kept=1.0):
    """P after the reading of exercise 2 of lesson 21 in Joseph's form, for the gain k of the position."""
    return np.array([[(1 - k) ** 2 * 4 + k**2 * (1 + R), -k], [-k, kept]])


LESSONS_P = "That is the lesson's P after its last reading. Here it is the first, from P⁻ = diag(4, 1)."


def of_sixteen():
    """The first consider correction from P⁻ = diag(16, 1)."""
    k = 16 / 17.25
    kept = np.array([[1 - k, -k], [0, 1]])
    return kept @ np.diag([16, 1]) @ kept.T + 0.25 * np.diag([k**2, 0])


WRONG = {
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
    "bias known": (
        np.array([[4 - 4 * 4 / 5.25, 0], [0, 0]]),
        "Here the variance of the bias is zero. A considered bias keeps its variance, 1, and becomes correlated with the position.",
    ),
    "variance of the bias zero": (
        np.array([[4 - 4 * 4 / 5.25, -4 / 5.25], [-4 / 5.25, 0]]),
        "P₂₂ is not zero. The reading tells the filter nothing about a considered bias: its variance stays 1.",
    ),
    "R squared, short": (
        np.array([[4 - 4 * 4 / 5.0625, -4 / 5.0625], [-4 / 5.0625, 1]]),
        "That is right for R = 0.0625, the square of 0.25. R = 0.25 is a variance already: S = 4 + 1 + 0.25.",
    ),
    "root of R": (
        first_gain(4 / 5.5, 0.5),
        "That is right for R = 0.5, the root of 0.25. R = 0.25 is the variance: S = 4 + 1 + 0.25.",
    ),
    "R not in S": (first_gain(4 / 5), "Your gain lacks R: S = 4 + 1 + 0.25."),
    "R nowhere": (
        np.array([[0.8, -0.8], [-0.8, 1]]),
        "R is left out, in the gain and in the last term of (9J): S = 4 + 1 + 0.25, and K R Kᵀ is added.",
    ),
    "bias not in S, P11": (
        np.array([[4 * 0.25 / 4.25, -4 / 4.25], [-4 / 4.25, 1]]),
        "Your gain lacks the bias: S = 4 + 1 + 0.25, because the innovation holds the bias too.",
    ),
    "bias added": (
        np.array([[4 - 4 * 4 / 5.25 + 1, -4 / 5.25], [-4 / 5.25, 1]]),
        "P₁₁ is larger by 1, the variance of the bias, than it should be. (9J) counts that already.",
    ),
    "root on the diagonal": (
        [[0.976, -0.762], [-0.762, 1]],
        "0.976 is the root of what is wanted. On the diagonal stand variances, in m².",
    ),
    "the gain of the bias": (
        [[0.952, -0.190], [-0.190, 1]],
        "0.190 is the bias's gain, whose row is set to zero. By (9J) P₁₂ is −K₁ times the bias's variance, 1.",
    ),
    "the lesson's last": ([[0.916, -0.866], [-0.866, 1.0]], LESSONS_P),
    "4 squared": (
        of_sixteen,
        "That is right for P⁻ = diag(16, 1), with 4 squared. P⁻ holds variances already: S = 4 + 1 + 0.25.",
    ),
}
