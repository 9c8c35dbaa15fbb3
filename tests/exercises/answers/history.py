"""Lesson 28: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def rest_to_the_newest(K, n):
    w = K * (1 - K) ** np.arange(n)
    w[0] += 1 - w.sum()
    return w


def two_at_least(K, n):
    w = [K]
    for _ in range(1, n - 1):
        w.append(w[-1] * (1 - K))
    w.append(w[-1] * (1 - K) / K)
    return np.array(w)


def K_in_any_case(K, n):
    w = [K]
    for j in range(1, n - 1):
        w.append(K * (1 - K) ** j)
    w.append((1 - K) ** (n - 1))
    return np.array(w)


def falling(z, K):
    return (1 - K) ** np.arange(len(z))[::-1]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("mended", lambda z, K: np.mean(falling(z, K) * z) / np.sum(falling(z, K)), "missing or one too many"),
    ("newest_ten", 0.7, "That leaves 0.3 to the readings older"),
    ("behind", 2.0, "the reading leaves 1.792 s"),
    ("behind", np.inf, "It does not grow for ever"),
    ("undisturbed", {"A", "B", "C", "D"}, "B was told a large Q"),
    ("exponential_weights", rest_to_the_newest, "the missing part went to the newest"),
    ("behind", 1.3, "mean innovation"),
    ("undisturbed", "A", 'several are handed in as a set, such as {"X", "Y"}'),
    ("newest_ten", sum(0.15 * 0.85**j for j in range(1, 10)), "0.653 is the sum for j = 1 to 9"),
    ("exponential_weights", lambda K, n: (1 - K) * K ** np.arange(n), "K and 1 − K are exchanged"),
    ("exponential_weights", two_at_least, "a single reading has the whole weight"),
    ("exponential_weights", K_in_any_case, "a single reading has the whole weight"),
]
