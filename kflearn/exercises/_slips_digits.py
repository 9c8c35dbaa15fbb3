"""Wrong answers to exercises of lesson 12 that a second stranger tried, and more of their kind."""

import numpy as np


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
    "first variance": (lambda L: squared(L)[0, 0], "Your function chooses as if it compared the variance of the first state only. A reading may leave that as it was: compare all of them, as the trace does."),
    "last variance": (lambda L: squared(L)[-1, -1], "Your function chooses as if it compared the variance of the last state only. A reading may leave that as it was: compare all of them, as the trace does."),
    "determinant of the roots": (np.linalg.det, "Your function chooses as if it compared the determinants of the *roots*, which may have a minus sign. Compare those of L Lᵀ."),
    "largest entry of the roots": (np.max, "Your function chooses as if it compared the largest entries of the *roots*, which may have minus signs. Square them first: compare variances."),
    "sum of the roots": (np.sum, "Your function chooses as if it compared numbers of the *roots*, their traces or their sums. A root may have minus signs, so these say little: compare the traces of L Lᵀ."),
    "sum of the sizes": (lambda L: abs(L).sum(), "Your function chooses as if it compared the sizes of the entries of the roots. What a reading makes smaller are the variances: compare the traces of L Lᵀ."),
    "sum of all entries": (lambda L: squared(L).sum(), "Your function chooses as if it compared the sums of all entries. That is the variance of the sum of the states, and a reading may leave it as it was: compare the traces."),
    "largest variance": (lambda L: np.diag(squared(L)).max(), "Your function chooses as if it compared the largest variance only. A reading may leave that as it was: compare all of them, as the trace does."),
}  # fmt: skip


WRONG = {
    "average_nees": {
        "1 − K²": (
            lambda P, K, R, claim: ((1 - K**2) * P + K**2 * R) / claim,
            "You squared the K alone. The state's error is multiplied by 1 − K, so its variance by (1 − K)², all of it squared.",
        ),
        "bracket": (
            lambda P, K, R, claim: (1 - K) ** 2 * P + K**2 * R / claim,
            "A bracket is missing: the whole sum is divided by the claim, not K²R alone.",
        ),
        "bracket, first half": (
            lambda P, K, R, claim: (1 - K) ** 2 * P / claim + K**2 * R,
            "A bracket is missing: the whole sum is divided by the claim, not its first half alone.",
        ),
        "over the innovation": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) / (claim + R),
            "You divide by claim + R, as for the NIS. NEES is divided by the variance that the filter claims for its state.",
        ),
        "over S": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) / (P + R),
            "You divide by P + R. NEES is divided by the variance that the filter claims for its state.",
        ),
        "over P": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) / P,
            "You divide by the variance before the reading. NEES is divided by the variance that the filter claims after it.",
        ),
        "over what is right for the best gain": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) / ((1 - K) * P),
            "The numerator is right. You divide by (1 − K)P, but this filter claims `claim`.",
        ),
        "P + R": (
            lambda P, K, R, claim: (P + R) / claim,
            "You added both variances as they are. The state's error is multiplied by 1 − K, the reading's by K.",
        ),
        "product": (
            lambda P, K, R, claim: (1 - K) ** 2 * P * K**2 * R / claim,
            "You multiplied the two parts. The two errors are independent: their variances add up.",
        ),
        "(1 + K)²": (
            lambda P, K, R, claim: ((1 + K) ** 2 * P + K**2 * R) / claim,
            "The sign in the first half: after the correction the part 1 − K of the old error is left.",
        ),
        "added after": (
            lambda P, K, R, claim: ((1 - K) * P + K**2 * R) / claim**2,
            "Two things: 1 − K is to be squared, and `claim` is a variance already: divide by it once.",
        ),
        "error added, then squared": (
            lambda P, K, R, claim: ((1 - K) * np.sqrt(P) + K * np.sqrt(R)) ** 2 / claim,
            "You added standard deviations and squared the sum. The two errors are independent: their variances add up.",
        ),
        "error subtracted, then squared": (
            lambda P, K, R, claim: ((1 - K) * np.sqrt(P) - K * np.sqrt(R)) ** 2 / claim,
            "You subtracted standard deviations and squared. The two errors are independent: their variances add up.",
        ),
        "claim in the numerator": (
            lambda P, K, R, claim: ((1 - K) ** 2 * claim + K**2 * R) / claim,
            "You took the claim for the variance before the reading. That is P; the claim is what the filter says afterwards.",
        ),
        "P squared": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P**2 + K**2 * R**2) / claim,
            "You squared the variances as well. P and R are variances already: only the factors 1 − K and K are squared.",
        ),
        "without R": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2) / claim,
            "The first half is right. In the second R is missing: K times the reading's error has the variance K²R.",
        ),
        "K²P taken away": (
            lambda P, K, R, claim: (P - K**2 * (P + R)) / claim,
            "P − K²S is the variance for the best gain only. Here K is any gain: (1 − K)² times the one, K² times the other.",
        ),
        "distance from 1": (
            lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) / claim - 1,
            "Nearly: you took 1 away. NEES itself is wanted; 1 is what it would be for an honest claim.",
        ),
    },
    "orders_of_the_root": {
        "half, minus two": (
            lambda orders: orders / 2 - 2,
            "Half of the orders is what a root spans. Nothing is to be taken off: a root of 10ⁿ is 10 to the power of n/2.",
        ),
        "half of the rest": (
            lambda orders: (orders - 2) / 2,
            "Half is right, of all orders: nothing is taken off before.",
        ),
        "logarithm": (lambda orders: np.log10(orders), "`orders` is the exponent already, so no logarithm is needed."),
        "natural logarithm": (lambda orders: np.log(orders), "`orders` is the exponent already, so no logarithm is needed."),
        "logarithm by 2": (lambda orders: np.log2(orders), "`orders` is the exponent already, so no logarithm is needed."),
        "rounded up": (lambda orders: -(-orders // 2), "You rounded up to a whole number: for 9 orders the root spans 4.5."),
        "rounded": (lambda orders: round(orders / 2), "You rounded to a whole number: for 9 orders the root spans 4.5."),
        "half and one": (lambda orders: orders / 2 + 1, "Half of the orders is what a root spans. Nothing is to be added."),
        "rest of ten": (lambda orders: 10 - orders, "You took the orders away from ten. The root of 10ⁿ is 10 to the power of what?"),
        "a third": (lambda orders: orders / 3, "A third belongs to the cube root. A square root halves the exponent."),
        "powers of two": (lambda orders: 2.0 ** (orders / 2), "That is a power of two. Asked is how many powers of ten the root spans."),
        "a power": (lambda orders: 10.0**orders, "That is the ratio for P itself. Asked is how many powers of ten its root spans."),
        "squares": (lambda orders: orders * np.log10(np.sqrt(orders)), "`orders` is the exponent already: the root of 10ⁿ is 10 to the power of what?"),
    },
    "posterior": {
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
    },
}  # fmt: skip
