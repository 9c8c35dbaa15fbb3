"""Lesson 12, `average_nees`: wrong answers, each with the sentence that it gets."""

import numpy as np

WRONG = {
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
    "squared again": (
        lambda P, K, R, claim: ((1 - K) ** 2 * P + K**2 * R) ** 2 / claim,
        "(1 − K)²P + K²R is a mean squared error already: do not square it again.",
    ),
}
