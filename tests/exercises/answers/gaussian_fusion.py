"""Lesson 4: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def on_a_grid(P, R, c):
    gains = np.linspace(0, 1, 21)
    return gains[np.argmin((1 - gains) ** 2 * P + gains**2 * R + 2 * gains * (1 - gains) * c)]


def against_the_reading(var_x, var_z):
    K = var_x / (var_x + var_z)
    both, apart = var_x * (1 - K), var_x + var_z
    return apart / var_z, (1 - K) ** 2 * apart / var_z, apart / both


def one_part(var_x, var_z):
    K = var_x / (var_x + var_z)
    return var_x / var_z, (1 - K) ** 2 * var_x / var_z, var_x / (var_x * (1 - K))


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("common_cause", lambda P, R, c: (P - c) / (P + P - 2 * c), "does not depend on R", "grid"),
    ("common_cause", on_a_grid, "multiples of 0.05 between 0 and 1"),
    ("third_opinion", 61.6667 + 0.8333**0.5 / (0.8333**0.5 + 2) * 4.3333, "two standard deviations"),
    ("third_opinion", 61.6667 + 5 / 6 * 4.3333, "comes from K = 0.8333"),
    ("third_opinion", 63.5, "lies 0.423 of the way"),
    ("third_opinion", 62, "if you have rounded"),
    ("common_cause", lambda P, R, c: min(max((P - c) / (P + R - 2 * c), 0), 1), "between 0 and 1"),
    ("common_cause", lambda P, R, c: 1.7 * (P - c) / (P + R - 2 * c), "is 1.7 times what is wanted"),
    ("common_cause", lambda P, R, c: 1.7 + (P - c) / (P + R - 2 * c), "is larger by 1.7 than"),
    ("readings_needed", 12, "does your counter begin at 1?"),
    ("readings_needed", 67, "Precisions add"),
    ("published_claim", lambda p, r: (p / r, p / (p + r), p / r), "mended variance"),
    ("third_opinion", 61.6667 + 0.8333 / (0.8333 + 16) * (66 - 61.6667), "2² = 4 m², not 16"),
    ("readings_needed", 3, "a variance that each reading divides by 6"),
    ("readings_needed", int(np.ceil(1 / 0.3**4 - 1 / 5)), "124 is 1/0.3⁴"),
    ("published_claim", against_the_reading, "ratios for distances from the *reading*"),
    ("published_claim", one_part, "only the prediction's part of the error"),
    ("readings_needed", 121, "is the square of what is wanted. Is there a square too many"),
    ("readings_needed", 10.911, "a whole number of times"),
    ("fuse", lambda m, v, n, w: ((m + n) / 2, (v + w) / 4), "That is the plain average and its variance"),
    ("third_opinion", 61.67, "before the satellite"),
    ("published_claim", lambda v, w: (v / w, v / w, 1 + v / w), "Anna returns the fused mean"),
    ("common_cause", lambda P, R, c: P / (P + R), "which holds for c = 0"),
]
