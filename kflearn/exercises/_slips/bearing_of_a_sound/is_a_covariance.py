"""Lesson 8, `is_a_covariance`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._combined import combined


def within(P):
    """Symmetric within rounding."""
    return np.allclose(P, P.T)


def minors(P):
    """The smallest of the determinants of the upper left corners."""
    return min(np.linalg.det(P[:k, :k]) for k in range(1, len(P) + 1))


def pairs(P):
    """Whether each two states fit together."""
    n = len(P)
    found = [P[i, i] * P[j, j] - P[i, j] ** 2 >= -1e-9 for i in range(n) for j in range(i)]
    return np.diag(P).min() >= 0 and all(found)


def upper_left(P):
    return P[0, 0] >= 0 and P[1, 1] >= 0 and P[0, 0] * P[1, 1] - P[0, 1] ** 2 >= -1e-9


SIGNS = {
    lambda P: np.linalg.eigvalsh(P).min() >= -1e-9: "",
    lambda P: (
        np.linalg.eigvalsh(P).min() > 1e-12
    ): "You refuse diag(1, 0). No combination has a *negative* variance there: zero is the variance of "
    "a state that is known exactly. (Cholesky's root refuses it as well.)",
    lambda P: (
        True
    ): "You do not find the combinations of states with a negative variance. A symmetric matrix may have a negative variance, or a correlation beyond 1.",
    lambda P: (
        np.diag(P).min() >= 0
    ): "Your function refuses a negative variance on the diagonal, and no other: a correlation beyond 1 gives some combination of the states a negative variance.",
    lambda P: (
        np.diag(P).min() > 0
    ): "Your function asks that the variances on the diagonal are above zero. Zero is the variance of a state that is known. "
    "A correlation beyond 1 gives some combination of the states a negative variance.",
    lambda P: (
        np.linalg.det(P) >= -1e-9
    ): "Your function answers like a test of the determinant, the product of the eigenvalues: two negative ones have a positive product. Look at each of them.",
    lambda P: (
        np.linalg.det(P) > 1e-12
    ): "Your function answers like a test of the determinant, the product of the eigenvalues: two negative ones have a positive product. Look at each of them; "
    "and zero is allowed, for a state that is known exactly.",
    lambda P: (
        np.diag(P).min() >= 0 and np.linalg.det(P) >= -1e-9
    ): "That is right for two states, as far as variances and determinant tell. Of three, two eigenvalues may be negative, "
    "and their product is positive: look at each eigenvalue.",
    lambda P: (
        np.diag(P).min() > 0 and np.linalg.det(P) > 1e-12
    ): "That is right for two states, as far as variances and determinant tell, except where one is zero. Of three, two eigenvalues "
    "may be negative, and their product is positive: look at each eigenvalue.",
    lambda P: (
        np.linalg.eigvalsh(P).max() >= -1e-9
    ): "Your function accepts P if its largest eigenvalue is not negative. The smallest one says whether a combination has a negative variance.",
    lambda P: (
        np.trace(P) >= 0
    ): "Your function answers like a test of the sum of the eigenvalues, the trace. One of them may be negative all the same.",
    lambda P: (
        P.min() >= 0
    ): "A covariance may be negative, a variance may not. Your test refuses matrices with a negative corner.",
    lambda P: (
        P.min() > 0
    ): "A covariance may be negative or zero, a variance may not be negative. Your test refuses matrices with such a corner.",
    lambda P: pairs(
        P
    ): "Your function finds what is wrong between two states. Each pair may fit, and three together contradict one another: look at all combinations, with the eigenvalues.",
    lambda P: (
        minors(P) >= -1e-9
    ): "Your function answers like a test of the determinants of the upper left corners. They decide only where none of them is zero: diag(0, −1) passes. "
    "The eigenvalues decide always.",
    lambda P: (
        P[0, 0] >= 0 and np.linalg.det(P[:2, :2]) >= -1e-9
    ): "Your function answers as if P had two states. P may be of any size.",
    lambda P: upper_left(P): "Your function answers as if P had two states. P may be of any size.",
    lambda P: (
        upper_left(P) and np.diag(P).min() > 0
    ): "Your function answers as if P had two states, and refuses zero. P may be of any size, and a state may be known exactly.",
    lambda P: (
        np.linalg.eigvalsh(P).min() >= -2.0
    ): "Negative variances pass, as with a limit for the eigenvalues far below zero.",
}


def exactly(P):
    return bool((P == P.T).all())


SYMMETRY = {
    within: "",
    exactly: "You refuse a matrix of which two corners differ by 4 · 10⁻¹⁰. That is rounding: allow for it, as `np.allclose(P, P.T)` does.",
    lambda P: (
        abs(P[0, 1] - P[1, 0]) < 1e-9
    ): "Your function lets a P pass of which only the first two states are symmetric. P may be of any size.",
    lambda P: (
        True
    ): "You return True for matrices that are not symmetric. If you look at eigenvalues: `eigvalsh` reads one half of the matrix only. "
    "If you add up P − P.T: plus and minus cancel.",
}


WRONG = {
    "one matrix": (
        lambda P: not np.allclose(P, [[1.03, 0.7], [0.02, 0.51]]),
        "You look for one matrix. Ask of any P: is it symmetric, and is every eigenvalue 0 or more?",
        r"\(P, *(np\.array\()?[\[(]{2}|P *== *(np\.array\()?[\[(]{2}",
    ),
    "the other way round": (
        lambda P: not (within(P) and np.linalg.eigvalsh(P).min() >= -1e-9),
        "You return True for the matrices that cannot be a covariance; it is the other way round.",
    ),
    "one of both": (
        lambda P: within(P) or np.linalg.eigvalsh(P).min() >= -1e-9,
        "It answers as if one of the two were enough: symmetric *or* without negative variances. Both must hold.",
    ),
    "always": (lambda P: True, "You return True whatever P is."),
    "never": (lambda P: False, "You return False whatever P is."),
    "singular": (
        lambda P: within(P) and abs(np.linalg.det(P)) > 1e-12,
        "It answers as if P had to have an inverse. A covariance need not: a state that is known exactly has the variance zero.",
    ),
} | combined(lambda symmetry, signs: lambda P: bool(symmetry(P) and signs(P)), symmetry=SYMMETRY, signs=SIGNS)
