"""Lesson 12: what happens to a filter in a computer with few digits."""

import numpy as np

from kflearn.exercises._hints import tried
from kflearn.exercises._slips import numerics as slips
from kflearn.exercises._slips.numerics.posterior import smaller
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def corrections(rng):
    """Variances of prediction and reading, any gain (not the best one), and what a filter claims afterwards."""
    P, R, claim = (float(number) for number in rng.integers(1, 10, 3))
    return P, int(rng.integers(1, 8)) / 8, R, claim / 2


@exercise(
    hints=[
        "NEES is the squared error divided by the claimed variance. What is the mean of the squared error here?",
        "After the correction the error is (1 − K) times the error before, minus K times the error of the reading.",
        tried(
            (4, 0, 1, 2),
            "average_nees(4, 0, 1, 2)",
            "With K = 0 nothing is corrected: the mean squared error stays P = 4, and the NEES is 4/2.",
            "Try K = 0: nothing is corrected, the mean squared error stays P. And K = 1, where only the reading counts?",
        ),
        "Joseph's form holds for any gain: the mean squared error is (1 − K)²P + K²R.",
        "`return ((1 - K) ** 2 * P + K**2 * R) / claim`",
    ],
    inputs=corrections,
    wrong=slips.average_nees.WRONG,
    then="With the best gain K = P/(P + R) the numerator is (1 − K)P again. If the filter claims just this, the NEES is 1.",
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
    wrong=slips.orders_of_the_root.WRONG,
    then="That is why a root needs half as many digits: in single precision, with seven digits, it holds what P needs fourteen for.",
)
def orders_of_the_root(orders):
    """How many powers of ten a root of P spans, when P spans `orders` of them."""
    return orders / 2


def two_roots(rng, n, apart=0, turned=None):
    """Roots of a covariance before a reading and after it, triangular, with any signs; which comes first is chance.

    apart: the states are independent, and the last one is read (1), so that the others stay as they were, or the
    first (-1), or the difference of two (2), so that their sum stays as it was, or vaguely the sum of all (3).
    """
    before = np.tril(rng.integers(-3, 4, (n, n)), -1) + np.diag(rng.integers(2, 7, n)) * rng.choice([-1.0, 1.0], n)
    h, R = rng.integers(1, 4, n) * rng.choice([-1, 1], n), rng.integers(1, 9) / 4
    if apart:
        before = np.diag(np.diag(before)) if abs(apart) == 1 else float(rng.integers(1, 5)) * np.eye(n)
        h = {1: np.eye(n)[-1], -1: np.eye(n)[0], 2: np.eye(n)[0] - np.eye(n)[1], 3: np.ones(n)}[apart]
        R = 40.0 if apart == 3 else R
    while not apart and not (before @ before.T @ h).all():  # a reading that leaves a variance as it was
        h[rng.integers(n)] += 1
    seen = before.T @ h  # Potter's correction: the reading is h times the state, its variance R
    S = seen @ seen + R
    after = before - np.outer(before @ seen, seen) / (S + np.sqrt(R * S))
    after = np.linalg.cholesky(after @ after.T) * rng.choice([-1.0, 1.0], n)
    return (before, after) if (rng.random() < 0.5 if turned is None else turned) else (after, before)


APART = [(2, 1, 0), (2, 1, 1), (3, 2, 0), (3, 2, 1), (3, -1, 0), (3, -1, 1), (3, 3, 0), (3, 3, 1)]


@exercise(
    hints=[
        "Square both roots. What can a reading do to a variance, and what can it never do?",
        "A reading never makes a variance larger. So the covariance after it is the one with the smaller trace.",
        "Root times transposed root, in this order: L Lᵀ.",
        "`P, other = one @ one.T, two @ two.T`, then `return P if np.trace(P) < np.trace(other) else other`",
    ],
    inputs=in_turn(two_roots, 2, 3, *APART, 4, 1),
    wrong=slips.posterior.WRONG,
    then="The traces tell because a reading never makes a variance larger, whatever H and R are. A prediction may do so.",
)
def posterior(one, two):
    """The covariance after the reading, from two roots: one of the covariance before the reading, one of that after."""
    return smaller(one @ one.T, two @ two.T)
