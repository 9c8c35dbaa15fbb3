"""Lesson 12, `posterior`: wrong answers, each with the sentence that it gets."""

import numpy as np


def smaller(first, second):
    """Of two covariances the one with the smaller trace."""
    return first if np.trace(first) < np.trace(second) else second


def chosen(measure, larger=False, root=False, ties=False):
    """The covariance whose root is the smaller one by some measure of the root, of two alike the first or the second."""

    def answer(one, two):
        first = (measure(one) < measure(two)) != larger or (ties and np.isclose(measure(one), measure(two)))
        L = one if first else two
        return L if root else L @ L.T

    return answer


def squared(P):
    return P @ P.T


MEASURES = {
    "first variance": (
        lambda L: squared(L)[0, 0],
        "Your function chooses as if it compared the variance of the first state only. A reading may leave that as it was: compare all of them, as the trace does.",
    ),
    "last variance": (
        lambda L: squared(L)[-1, -1],
        "Your function chooses as if it compared the variance of the last state only. A reading may leave that as it was: compare all of them, as the trace does.",
    ),
    "determinant of the roots": (
        np.linalg.det,
        "Your function chooses as if it compared the determinants of the *roots*, which may have a minus sign. Compare those of L Lᵀ.",
    ),
    "largest entry of the roots": (
        np.max,
        "Your function chooses as if it compared the largest entries of the *roots*, which may have minus signs. Square them first: compare variances.",
    ),
    "sum of the roots": (
        np.sum,
        "Your function chooses as if it compared numbers of the *roots*, their traces or their sums. A root may have minus signs, so these say little: compare the traces of L Lᵀ.",
    ),
    "sum of the sizes": (
        lambda L: abs(L).sum(),
        "Your function chooses as if it compared the sizes of the entries of the roots. What a reading makes smaller are the variances: compare the traces of L Lᵀ.",
    ),
    "sum of all entries": (
        lambda L: squared(L).sum(),
        "Your function chooses as if it compared the sums of all entries. That is the variance of the sum of the states, and a reading may leave it as it was: compare the traces.",
    ),
    "largest variance": (
        lambda L: np.diag(squared(L)).max(),
        "Your function chooses as if it compared the largest variance only. A reading may leave that as it was: compare all of them, as the trace does.",
    ),
}


def entries_added(one, two):
    L = one if one.sum() < two.sum() else two
    return L * L


WRONG = (
    {
        "as published": (
            lambda one, two: one @ one.T,
            "That is the published line: it takes the first root, whichever it is. Look at the sizes of both.",
        ),
        "always the second": (
            lambda one, two: two @ two.T,
            "You took the second root, whichever it is. Look at the sizes of both.",
        ),
        "the larger": (
            lambda one, two: -smaller(-one @ one.T, -two @ two.T),
            "You took the larger one: that is the covariance before the reading. A reading makes variances smaller.",
        ),
        "mixed": (
            lambda one, two: one @ two.T,
            "You mixed the two roots: both factors must be the one after the reading.",
        ),
        "transpose first": (
            lambda one, two: smaller(one.T @ one, two.T @ two),
            "The right root, but in the wrong order: P = L Lᵀ. Lᵀ L has the same trace and is another matrix.",
        ),
        "no transpose": (
            lambda one, two: smaller(one @ one, two @ two),
            "The second factor must be transposed: P = L Lᵀ is symmetric, L L is not.",
        ),
        "the root": (
            lambda one, two: one if np.trace(one @ one.T) < np.trace(two @ two.T) else two,
            "That is the root. The property promises the covariance, L Lᵀ.",
        ),
        "elementwise": (
            lambda one, two: smaller(one * one, two * two),
            "You squared each element; `*` is not the matrix product `@`.",
        ),
        "the roots' traces": (
            lambda one, two: one @ one.T if np.trace(one) < np.trace(two) else two @ two.T,
            "Your function chooses as if it compared numbers of the *roots*, their traces or their sums. A root may have minus signs, so these say little: compare the traces of L Lᵀ.",
        ),
        "smaller entries": (
            lambda one, two: np.minimum(one @ one.T, two @ two.T),
            "You took the smaller number entry by entry: that mixes two matrices. Choose one of the two as a whole.",
        ),
        "difference": (
            lambda one, two: one @ one.T - two @ two.T,
            "That is what the reading has taken away, or its negative. Asked is what is left: one of the two products.",
        ),
        "first entry of the roots": (
            lambda one, two: one @ one.T if one[0, 0] < two[0, 0] else two @ two.T,
            "Your function chooses as if it compared the first entries of the *roots*, which may have minus signs. Square them first: compare variances.",
        ),
        "sum": (
            lambda one, two: one @ one.T + two @ two.T,
            "You added both covariances. Only one of them is that after the reading: choose.",
        ),
        "mean": (
            lambda one, two: (one @ one.T + two @ two.T) / 2,
            "You averaged both covariances. Only one of them is that after the reading: choose.",
        ),
        "fused": (
            lambda one, two: np.linalg.inv(np.linalg.inv(one @ one.T) + np.linalg.inv(two @ two.T)),
            "You fused the two, as if they were independent. The reading is in one of them already: choose that one.",
        ),
        "larger first variance": (
            chosen(lambda L: squared(L)[0, 0], larger=True),
            "Your function chooses the one with the larger first variance: that is the covariance before the reading. And the first state alone does not tell.",
        ),
        "the larger root": (
            chosen(lambda L: np.trace(squared(L)), larger=True, root=True),
            "Two things: that is the *root*, and the one of before the reading: a reading makes variances smaller.",
        ),
        "larger, Lᵀ L": (
            lambda one, two: (lambda L: L.T @ L)(max(one, two, key=np.linalg.norm)),
            "Two things: a reading makes variances smaller, so it is the other root; and P = L Lᵀ, in this order.",
        ),
        "variances only": (
            lambda one, two: np.diag(np.diag(squared(min(one, two, key=np.linalg.norm)))),
            "The variances are right. The covariances beside the diagonal belong to L Lᵀ too.",
        ),
        "variances as a row": (
            lambda one, two: np.diag(squared(min(one, two, key=np.linalg.norm))),
            "Those are the variances alone. Wanted is the whole covariance, L Lᵀ.",
        ),
        "its trace": (
            lambda one, two: min(np.trace(squared(one)), np.trace(squared(two))),
            "That is the smaller trace. Wanted is the covariance that has it.",
        ),
        "which": (
            lambda one, two: np.trace(squared(one)) < np.trace(squared(two)),
            "That says which of the two it is. Return the covariance itself, L Lᵀ of that root.",
        ),
        "squared twice": (
            lambda one, two: (lambda P: P @ P.T)(squared(min(one, two, key=np.linalg.norm))),
            "You squared twice. One square of the root, L Lᵀ, is the covariance.",
        ),
    }
    | {
        f"{label}, {ties}": (chosen(measure, ties=ties), words)
        for label, (measure, words) in MEASURES.items()
        for ties in (False, True)
    }
    | {
        "difference, the other sign": (
            lambda one, two: two @ two.T - one @ one.T,
            "That is the difference of the two covariances. One of them, the smaller, is the answer as it stands.",
        ),
        "sums of entries": (
            entries_added,
            "A root's entries may be negative: compare the traces of L Lᵀ. And `*` multiplies entry by entry: `L @ L.T`.",
        ),
        "difference of the squares": (
            lambda one, two: abs(one @ one.T - two @ two.T),
            "The difference is what the reading took away. Return the smaller of the two covariances itself.",
        ),
    }
)
