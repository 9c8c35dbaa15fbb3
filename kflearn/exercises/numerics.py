"""Lesson 12: what happens to a filter in a computer with few digits."""

import numpy as np

from kflearn.exercises._hints import tried
from kflearn.exercises._slips_digits import WRONG as MORE
from kflearn.exercises._slips_fifth_early import WRONG as FIFTH
from kflearn.exercises._slips_fourth import WRONG as FOURTH
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_third_filters import WRONG as THIRD
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
        "not divided": (
            lambda P, K, R, claim: (1 - K) ** 2 * P + K**2 * R,
            "That is the mean squared error, as Joseph's form gives it. NEES is that, divided by the variance that the filter claims.",
        ),
        "one": (
            lambda P, K, R, claim: 1.0,
            "1 would be the answer if the claim were honest. Here it is any number: work out the mean squared error first.",
        ),
        "P over claim": (
            lambda P, K, R, claim: P / claim,
            "You divided the predicted variance. The error that is tested is the one after the correction with K.",
        ),
        "claim squared": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) / claim**2,
            "The numerator is right. `claim` is a variance already: divide by it once.",
        ),
        "the best gain": (
            lambda P, K, R, claim: P * R / (P + R) / claim,
            "P·R/(P + R) is for the best gain. The filter uses the K that is handed in.",
        ),
        "K of R not squared": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K * R) / claim,
            "The first half is right. The reading's error is multiplied by K, so its variance by K².",
        ),
        "K and 1 − K swapped": (
            lambda P, K, R, claim: (K**2 * P + (1 - K) ** 2 * R) / claim,
            "K and 1 − K have changed places: the state's error is multiplied by 1 − K, the reading's by K.",
        ),
        "plain, upside down": (
            lambda P, K, R, claim: claim / ((1 - K) * P),
            "Two things: NEES is the error by the claim, not upside down; and (1 − K)P is the variance for the best gain only.",
        ),
        "1 − K not squared": (
            lambda P, K, R, claim: ((1 - K) * P + K**2 * R) / claim,
            "The second half is right. The state's error is multiplied by 1 − K, so its variance by (1 − K)².",
        ),
        "R without K": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + R) / claim,
            "The first half is right. Only K times the reading's error comes in, so its variance counts as K²R.",
        ),
    }
    | MORE["average_nees"]
    | FOURTH["average_nees"],
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
    wrong={
        "as published": (
            lambda orders: orders - 2,
            "That is the published sentence again: true for four orders, and for no other number.",
        ),
        "no gain": (
            lambda orders: orders,
            "Then a root would save nothing. The root of 10¹² is 10⁶.",
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
            "That is the way from the root to P: squares double the exponent, roots halve it.",
        ),
        "ratio": (
            lambda orders: 10 ** (orders / 2),
            "That is the ratio of the largest to the smallest number; asked is how many powers of ten it is.",
        ),
        "half, and cut off": (
            lambda orders: orders // 2,
            "The half is cut off, as by `//`: for 9 orders the root spans 4.5.",
        ),
        "five fewer": (
            lambda orders: orders - 5,
            "That is right for ten orders, as in the lesson, and for no other number.",
        ),
        "a quarter": (lambda orders: orders / 4, "That is halved twice. One root halves the exponent once."),
        "five": (
            lambda orders: 5.0 + 0 * orders,
            "5 is right for the ten orders of the lesson. The function is to answer for any number of orders.",
        ),
        "squared": (
            lambda orders: orders**2,
            "You squared the count. Taking the root of 10ⁿ changes the exponent n; into what?",
        ),
        "logarithm": (
            lambda orders: np.log10(orders) / 2,
            "`orders` is the exponent already, so no logarithm is needed.",
        ),
        "root, then half": (
            lambda orders: orders**0.5 / 2,
            "You took the root of the count of orders. It is an exponent: the root of 10ⁿ is 10 to the power of what?",
        ),
    }
    | MORE["orders_of_the_root"]
    | THIRD["orders_of_the_root"]
    | FOURTH["orders_of_the_root"]
    | FIFTH["orders_of_the_root"]
    | SEVENTH["orders_of_the_root"],
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
    inputs=in_turn(two_roots, 2, 3, *APART, 4, 1),
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
    }
    | MORE["posterior"]
    | THIRD["posterior"]
    | FOURTH["posterior"],
    then="The traces tell because a reading never makes a variance larger, whatever H and R are. A prediction may do so.",
)
def posterior(one, two):
    """The covariance after the reading, from two roots: one of the covariance before the reading, one of that after."""
    return smaller(one @ one.T, two @ two.T)
