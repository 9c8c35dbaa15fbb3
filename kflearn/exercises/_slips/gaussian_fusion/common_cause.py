"""Lesson 4, `common_cause`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np

BOTH_PLACES = "The term 2K(1 − K)c changes both: c is taken away on top, and 2c below the line."


def on_a_grid(results, rights):
    """What is said of gains that are steps of a grid, the nearest to the right ones between 0 and 1."""
    if np.ptp(results) == 0:
        return None
    for count in range(2, 2001):
        steps = results * count
        if np.allclose(steps, np.round(steps), rtol=0, atol=1e-7):
            if np.all(abs(results - np.clip(rights, 0, 1)) <= 1.001 / count):
                return (
                    f"Your gains are multiples of {1 / count:.4g} between 0 and 1, as on a grid. The lowest point of the parabola "
                    "lies between them, or beyond 0 and 1: solve slope = 0 for K."
                )
            return None
    return None


WRONG = {
    "c ignored": (
        lambda P, R, c: P / (P + R),
        "That is (12), which holds for c = 0. The variance of the sum (1 − K) e⁻ + K v has a third term, twice their covariance.",
    ),
    "below the line only": (
        lambda P, R, c: P / (P + R - 2 * c),
        "Below the line is right. The term 2K(1 − K)c has a slope at K = 0 as well, so c appears on top too.",
    ),
    "on top only": (
        lambda P, R, c: (P - c) / (P + R),
        "On top is right. The term 2K(1 − K)c contains −2K²c, so c appears below the line too.",
    ),
    "one c below": (
        lambda P, R, c: (P - c) / (P + R - c),
        "On top is right. Below the line c stands twice: the covariance is counted twice in the variance of a sum.",
    ),
    "wrong sign": (
        lambda P, R, c: (P + c) / (P + R + 2 * c),
        "The sign of c is wrong. The error is (1 − K) e⁻ + K v, with a plus between the two parts, so P(K) has + 2K(1 − K)c. Take its slope again.",
    ),
    "1 − K": (
        lambda P, R, c: (R - c) / (P + R - 2 * c),
        "That is 1 − K, the share of the prediction. K is the share of the reading.",
    ),
    "c once": (
        lambda P, R, c: (P - c / 2) / (P + R - c),
        "The covariance of the two parts is counted once in your parabola. In the variance of a sum it counts twice: + 2K(1 − K)c.",
    ),
    "the lowest variance": (
        lambda P, R, c: (P * R - c**2) / (P + R - 2 * c),
        "That is the lowest variance itself, and it is right. The gain is wanted.",
    ),
    "c added below": (
        lambda P, R, c: (P - c) / (P + R + 2 * c),
        "On top is right. Below the line the sign of c is wrong: the factor of K² in the parabola is P + R − 2c.",
    ),
    "c as the variance of a sum": (
        lambda P, R, c: P / (P + R + 2 * c),
        "The innovation is v − e⁻, a difference: its variance is P + R − 2c. And c appears on top as well.",
    ),
    "correlation": (
        lambda P, R, c: (P - c * math.sqrt(P * R)) / (P + R - 2 * c * math.sqrt(P * R)),
        "You took c for a correlation and multiplied it by the two σ. c is the covariance itself.",
    ),
    "twice on top": (
        lambda P, R, c: (P - 2 * c) / (P + R - 2 * c),
        "Below the line is right. On top c stands once: half of the slope at K = 0 is c − P.",
    ),
    "corner over sum": (
        lambda P, R, c: c / (P + R),
        "That is c alone over P + R. On top belongs the prediction's variance too, and c appears below the line.",
    ),
    "corner over sum, below right": (
        lambda P, R, c: c / (P + R - 2 * c),
        "Below the line is right. On top belongs the prediction's variance, less c.",
    ),
    "plus on top, no c below": (
        lambda P, R, c: (P + c) / (P + R),
        "The sign of c on top is wrong, and below the line c is missing.",
    ),
    "plus on top": (
        lambda P, R, c: (P + c) / (P + R - 2 * c),
        "Below the line is right. On top the sign of c is wrong.",
    ),
    "between 0 and 1": (
        lambda P, R, c: min(max((P - c) / (P + R - 2 * c), 0), 1),
        "The formula is right, but you keep K between 0 and 1. With a large covariance the best gain lies beyond: leave it as it is.",
    ),
    "not below 0": (
        lambda P, R, c: max((P - c) / (P + R - 2 * c), 0),
        "The formula is right, but you keep K from falling below 0. With a large covariance it does.",
    ),
    "not above 1": (
        lambda P, R, c: min((P - c) / (P + R - 2 * c), 1),
        "The formula is right, but you keep K from rising above 1. With a large covariance it does.",
    ),
    "c squared": (
        lambda P, R, c: (P - c**2) / (P + R - 2 * c**2),
        "You squared c. It is a covariance, a square already.",
    ),
    "c below": (lambda P, R, c: P / (P + R + c), f"That is (12) with c added below the line. {BOTH_PLACES}"),
    "c off below": (
        lambda P, R, c: P / (P + R - c),
        f"That is (12) with c taken away below the line. {BOTH_PLACES}",
    ),
    "c in both": (
        lambda P, R, c: (P + c) / (P + R + c),
        f"That is (12) with c added in both places. {BOTH_PLACES}",
    ),
    "c below, taken away on top": (
        lambda P, R, c: (P - c) / (P + R + c),
        "On top is right. Below the line 2c is taken away, and not c added.",
    ),
} | {
    f"c²/{name} on top": (
        lambda P, R, c, i=i: (P - c**2 / (P, R)[i]) / (P + R - 2 * c),
        f"Below the line it is right. On top c²/{name} is taken away from P; it is c that belongs there.",
    )
    for i, name in enumerate("PR")
}
