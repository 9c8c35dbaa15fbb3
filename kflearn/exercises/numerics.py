"""Lesson 11: what happens to a filter in a computer with few digits."""

import numpy as np

from kflearn.exercises.engine import exercise


def corrections(rng):
    """Variances of prediction and reading, any gain (not the best one), and what a filter claims afterwards."""
    P, R, claim = (float(number) for number in rng.integers(1, 10, 3))
    return P, int(rng.integers(1, 8)) / 8, R, claim / 2


@exercise(
    hints=[
        "NEES is the squared error divided by the claimed variance. What is the mean of the squared error here?",
        "After the correction the error is (1 − K) times the error before, minus K times the error of the reading.",
        "Joseph's form holds for any gain: the mean squared error is (1 − K)²P + K²R.",
        "`return ((1 - K) ** 2 * P + K**2 * R) / claim`",
    ],
    inputs=corrections,
    wrong={
        "plain": (
            lambda P, K, R, claim: (1 - K) * P / claim,
            "Above the line stands (1 − K)P: true for the best gain only, and here K is any gain.",
        ),
        "upside down": (
            lambda P, K, R, claim: claim / ((1 - K) ** 2 * P + K**2 * R),
            "That is claimed by actual variance, upside down: NEES above 1 must mean too sure.",
        ),
        "K²R forgotten": (
            lambda P, K, R, claim: (1 - K) ** 2 * P / claim,
            "The first half is right. The reading has an error too, and the gain lets K times that in: add K²R.",
        ),
        "K²R subtracted": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P - K**2 * R) / claim,
            "Both halves are there, but the reading's error makes the mean squared error larger: add.",
        ),
        "K not squared": (
            lambda P, K, R, claim: ((1 - K) * P + K * R) / claim,
            "Variances go with the squares: an error times 1 − K has (1 − K)² times the variance, and K counts as K².",
        ),
        "K²S": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * (P + R)) / claim,
            "In the second half stands R, the variance of the reading alone, not S: the state's part is counted already.",
        ),
        "root": (
            lambda P, K, R, claim: (((1 - K) ** 2 * P + K**2 * R) / claim) ** 0.5,
            "That is a ratio of standard deviations. NEES compares squares: leave the root out.",
        ),
    },
)
def average_nees(P, K, R, claim):
    """The average NEES of a filter of one state (H = 1) that uses the gain K and claims the variance `claim`."""
    return ((1 - K) ** 2 * P + K**2 * R) / claim


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
    """Roots of a covariance before and after a correction, lower triangular; which comes first is chance."""
    before = np.tril(rng.integers(1, 7, (2, 2))).astype(float)
    after = before * rng.choice([-0.75, -0.5, 0.25, 0.5], 2)
    return (before, after) if rng.random() < 0.5 else (after, before)


def smaller(first, second):
    """Of two covariances the one with the smaller trace."""
    return first if np.trace(first) < np.trace(second) else second


@exercise(
    hints=[
        "Square both roots. What can a reading do to a variance, and what can it never do?",
        "A reading never makes a variance larger. So the covariance after it is the one with the smaller trace.",
        "Root times transposed root, in this order: L Lᵀ.",
        "`P, other = one @ one.T, two @ two.T`, then `return P if np.trace(P) < np.trace(other) else other`",
    ],
    inputs=two_roots,
    wrong={
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
    },
)
def posterior(one, two):
    """The covariance after the reading, from two roots: one of the covariance before the reading, one of that after."""
    return smaller(one @ one.T, two @ two.T)
