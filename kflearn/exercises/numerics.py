"""Lesson 11: what happens to a filter in a computer with few digits."""

import numpy as np

from kflearn.exercises.engine import exercise


def corrections(rng):
    """A predicted covariance, any gain (not the best one), one row of H and R."""
    half = rng.integers(-3, 4, (2, 2)).astype(float)
    P = half @ half.T + np.diag(rng.integers(1, 4, 2))
    K = rng.integers(1, 9, (2, 1)) / 8
    H = np.array([[1.0, rng.integers(1, 4) / 2]])
    return P, K, H, np.array([[float(rng.integers(1, 5))]])


def keep(P, K, H):
    """I − KH."""
    return np.eye(len(P)) - K @ H


@exercise(
    hints=[
        "After the correction the error is (I − KH) times the error before, minus K times the error of the reading.",
        "The two errors are independent, so their covariances add; a matrix A turns a covariance C into A C Aᵀ.",
        "`keep = np.eye(len(P)) - K @ H`, then `return keep @ P @ keep.T + K @ R @ K.T`",
    ],
    inputs=corrections,
    wrong={
        "plain": (
            lambda P, K, H, R: keep(P, K, H) @ P,
            "That is the plain form (I − KH)P: true for the best gain only, and here K is any gain.",
        ),
        "symmetrised": (
            lambda P, K, H, R: (keep(P, K, H) @ P + P @ keep(P, K, H).T) / 2,
            "That is the plain form, symmetrised: it looks better, and is as wrong as before for any gain but the best.",
        ),
        "KRKᵀ forgotten": (
            lambda P, K, H, R: keep(P, K, H) @ P @ keep(P, K, H).T,
            "The first half is right. The reading has an error too, and the gain lets K times that in: add KRKᵀ.",
        ),
        "KRKᵀ subtracted": (
            lambda P, K, H, R: keep(P, K, H) @ P @ keep(P, K, H).T - K @ R @ K.T,
            "Both halves are there, but the reading's error makes P larger: add, and nothing can become negative.",
        ),
        "transpose forgotten": (
            lambda P, K, H, R: keep(P, K, H) @ P @ keep(P, K, H) + K @ R @ K.T,
            "On the right of P belongs the transpose of I − KH: a covariance C becomes A C Aᵀ.",
        ),
        "P − KSKᵀ": (
            lambda P, K, H, R: P - K @ (H @ P @ H.T + R) @ K.T,
            "P − KSKᵀ is another subtraction that is true for the best gain only.",
        ),
        "KHPHᵀKᵀ": (
            lambda P, K, H, R: keep(P, K, H) @ P @ keep(P, K, H).T + K @ (H @ P @ H.T + R) @ K.T,
            "In the second half stands R, the variance of the reading alone, not S: the state's part is counted already.",
        ),
    },
)
def joseph(P, K, H, R):
    """The covariance after a correction with any gain K, in Joseph's form."""
    keep = np.eye(len(P)) - K @ H
    return keep @ P @ keep.T + K @ R @ K.T


@exercise(
    hints=[
        "What adds up in a prediction are the variances, F P Fᵀ + Q. What are they here?",
        "3² + 4², and L is the root of that: the array [3  4] is rotated into [L  0].",
        "The root of 9 + 16 = √25.",
    ],
    wrong={
        "roots added": (
            7.0,
            "You added the roots. Variances add; roots go by Pythagoras, as the two short sides of a right triangle.",
        ),
        "variance": (25.0, "25 is the variance P⁻. The filter carries its root."),
        "L and Q mixed": (
            lambda: np.sqrt(3 + 4),
            "3 and 4 are roots already: square them before you add.",
        ),
        "half a root": (
            lambda: np.sqrt(9 + 4),
            "3 was squared, 4 was not: 4 is a root of Q, so Q is 16.",
        ),
        "variance added to the root": (19.0, "You added the variance 16 to the root 3; add squares to squares."),
        "Q forgotten": (3.0, "That is L, with F = 1 and without Q: a prediction makes the belief vaguer."),
    },
)
def predicted_root():
    """The root after a prediction with F = 1, when the root before is 3 and Q has the root 4."""
    return np.hypot(3, 4)


@exercise(
    hints=[
        "If P = 10ⁿ, what is the number that gives P when it is multiplied with itself?",
        "The root of 10ⁿ is 10 to the power of n/2. Now compare the largest with the smallest.",
        "`return orders / 2`",
    ],
    inputs=lambda rng: (int(rng.integers(1, 20)),),
    wrong={
        "as published": (
            lambda orders: orders - 2,
            "That is the published sentence again: true for four orders, and for no other number.",
        ),
        "no gain": (
            lambda orders: orders,
            "Then nothing would be won. The root of 10¹² is 10⁶.",
        ),
        "root of the exponent": (
            lambda orders: np.sqrt(orders),
            "The root is taken of the numbers, not of their exponents: √(10ⁿ) is 10 to the power of n/2.",
        ),
        "a factor, not an order": (
            lambda orders: orders / 100,
            "An order of magnitude is a power of ten; you divided the count of them by a hundred.",
        ),
        "the wrong way": (
            lambda orders: 2 * orders,
            "You went from the root to P: squares double the exponent, roots halve it.",
        ),
        "ratio": (
            lambda orders: 10 ** (orders / 2),
            "That is the ratio of the largest to the smallest number; asked is how many powers of ten it is.",
        ),
    },
)
def orders_of_the_root(orders):
    """How many powers of ten a root of P spans, when P spans `orders` of them."""
    return orders / 2


def two_roots(rng):
    """Roots of a covariance before and after a correction: lower triangular, as the square-root filter keeps them."""
    before = np.tril(rng.integers(1, 7, (2, 2))).astype(float)
    after = np.tril(rng.integers(-6, 7, (2, 2))) / 4
    return before, after + np.diag([1.75, -1.75])


@exercise(
    hints=[
        "Which of the two roots does the published line use, the one before the reading or the one after it?",
        "`P_post` is the covariance after the reading. Root times transposed root, in which order?",
        "`return root_post @ root_post.T`",
    ],
    inputs=two_roots,
    wrong={
        "as published": (
            lambda prior, post: prior @ prior.T,
            "That is the published line: the covariance before the reading. Look at the name of what is multiplied.",
        ),
        "mixed": (
            lambda prior, post: prior @ post.T,
            "You mixed the two roots: both factors must be the one after the reading.",
        ),
        "transpose first": (
            lambda prior, post: post.T @ post,
            "The right root, but in the wrong order: P = L Lᵀ. Lᵀ L has the same trace and is another matrix.",
        ),
        "no transpose": (
            lambda prior, post: post @ post,
            "The second factor must be transposed: P = L Lᵀ is symmetric, L L is not.",
        ),
        "the root": (
            lambda prior, post: post,
            "That is the root. The property promises the covariance, L Lᵀ.",
        ),
        "difference": (
            lambda prior, post: prior @ prior.T - post @ post.T,
            "That is by how much the reading has reduced P; asked is what is left.",
        ),
        "elementwise": (
            lambda prior, post: post * post,
            "You squared each element; `*` is not the matrix product `@`.",
        ),
    },
)
def posterior(root_prior, root_post):
    """The covariance after the reading, from the roots before and after it."""
    return root_post @ root_post.T
