"""Lesson 7, `nees`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
    "without P": (
        lambda e, P: e @ e,
        "That is the squared error alone. P, what the filter claims, is not used yet: it must divide.",
    ),
    "σ for P": (
        lambda e, P: np.sum(e**2 / np.sqrt(np.diag(P))),
        "You divided squares by standard deviations. A squared error belongs over a variance; and P has covariances too.",
    ),
    "only the diagonal": (
        lambda e, P: np.sum(e**2 / np.diag(P)),
        "You used the variances only. The errors belong together: P⁻¹ takes the covariances beside the diagonal into account.",
    ),
    "P, not its inverse": (
        lambda e, P: e @ P @ e,
        "You multiplied by P. A large claim must make the score small: it is P⁻¹ that stands between the two e.",
    ),
    "entry by entry": (
        lambda e, P: e @ (1 / P) @ e,
        "1 / P, like P ** -1, works entry by entry; the inverse of a matrix is something else. np.linalg.solve(P, e) is P⁻¹ e.",
    ),
    "the root": (
        lambda e, P: np.sqrt(e @ np.linalg.solve(P, e)),
        "You took the root: that is a distance in sigmas. NEES is its square, and only the square follows chi-square.",
    ),
    "divided by n": (
        lambda e, P: e @ np.linalg.solve(P, e) / len(e),
        "You divided by n: that is NEES/n, which averages 1. It is handy in a figure, but NEES averages n.",
    ),
    "not added up": (
        lambda e, P: e * np.linalg.solve(P, e),
        "The pieces are right; add them up: e @ … multiplies and adds in one go.",
    ),
    "a vector": (
        lambda e, P: e @ np.linalg.inv(P),
        "That is P⁻¹ e, one number for each state. Multiply by e once more, with @, and you have one number for all.",
    ),
    "no product": (
        lambda e, P: e**2 / np.diag(P),
        "That is one number for each state, and the covariances are not used. NEES is one number: e stands on both sides of P⁻¹.",
    ),
    "divided by a matrix": (
        lambda e, P: e**2 / P,
        "`/ P` divides by each entry of P and gives a matrix. The inverse of a matrix is something else: np.linalg.solve(P, e) is P⁻¹ e.",
    ),
    "by the trace": (
        lambda e, P: e @ e / np.trace(P),
        "You divided the squared length by the sum of the variances. Each direction has its own variance: use P⁻¹.",
    ),
    "mean over the states": (
        lambda e, P: np.mean(e**2 / np.diag(P)) + 0 * P[0, 0],
        "That is a mean over the states, and the covariances are not used. NEES adds up, with P⁻¹ between two e.",
    ),
    "inverse entry by entry": (
        lambda e, P: e * np.linalg.inv(P) * e,
        "`*` multiplies entry by entry and leaves a matrix. The products with P⁻¹ are matrix products: @.",
    ),
    "one e": (
        lambda e, P: np.sum(e @ np.linalg.inv(P)),
        "You added up the entries of P⁻¹ e. Multiply each by its e first: e stands on both sides of P⁻¹.",
    ),
    "outer product": (
        lambda e, P: np.outer(e, e) @ np.linalg.inv(P),
        "That is a matrix, e eᵀ P⁻¹. NEES is one number, eᵀ P⁻¹ e: it is the trace of your matrix.",
    ),
    "P twice": (
        lambda e, P: e @ np.linalg.inv(P @ P) @ e,
        "That is eᵀ P⁻¹ P⁻¹ e. P holds variances already: P⁻¹ stands once between the two e.",
    ),
    "divided once more": (
        lambda e, P: e @ np.linalg.inv(P) @ e / np.linalg.det(P),
        "eᵀ P⁻¹ e is right. The determinant is contained in P⁻¹ already: do not divide once more.",
    ),
    "first component": (
        lambda e, P: e[0] ** 2 / P[0, 0],
        "You score the first component only. All of them count, with their covariances.",
    ),
    "n itself": (
        lambda e, P: float(len(e)),
        "The number n is what NEES is on average, if the filter is honest. Here the NEES of this one e and P is wanted.",
    ),
    "over the determinant": (
        lambda e, P: e @ e / np.linalg.det(P),
        "You divided by the determinant of P, which is a number of another unit. The inverse of P is a matrix, and e stands on both sides of it.",
    ),
    "squares of e": (
        lambda e, P: np.sum(np.linalg.inv(P) @ e**2),
        "That is Σ P⁻¹ e², as if e were squared first: the products of two different components are lost. `*` multiplies entry by entry; use `@`, with e on both sides of P⁻¹.",
    ),
    "1 over": (
        lambda e, P: 1 / (e @ P @ e),
        "That is 1/(eᵀ P e). It is P that has to be inverted, before it is multiplied.",
    ),
    "over the sum of P": (
        lambda e, P: e @ e / np.sum(P),
        "You divided the squared length by the sum of all entries of P. Each direction has its own variance: use P⁻¹.",
    ),
    "a logarithm too many": (
        lambda e, P: e @ np.linalg.solve(P, e) + np.log(np.linalg.det(P)),
        "eᵀ P⁻¹ e is right. The logarithm of the determinant belongs to the likelihood, not to NEES.",
    ),
    "largest": (
        lambda e, P: np.max(e**2 / np.diag(P)),
        "That is the largest of the squared errors over their variances. All components count, with their covariances.",
    ),
    "the other factor": (
        lambda e, P: np.sum(np.linalg.solve(np.linalg.cholesky(P).T, e) ** 2),
        "You solved with the transposed root. With P = L Lᵀ it is L that e is divided by: solve L y = e, and add up y².",
    ),
    "diagonal of the inverse": (
        lambda e, P: np.diag(np.linalg.inv(P)) @ e**2,
        "That is e² times the diagonal of P⁻¹, added up. The corners of P⁻¹ count too, with the products of two "
        "different components: put the whole P⁻¹ between two e, with `@`.",
    ),
}
