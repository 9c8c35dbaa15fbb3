"""Lesson 22, `matrix_R`: wrong answers, each with the sentence that it gets."""

import numpy as np


def estimate(y, H, P, C=None):
    C = y.T @ y / len(y) if C is None else C(y)
    return C - H @ P @ H.T


WRONG = {
    "mean removed": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.cov(y.T, bias=True)),
        "Here the mean of the innovations is taken off. They should average 0, and if they do not, that belongs to C.",
    ),
    "np.cov": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.cov(y.T)),
        "The mean is taken off, and the divisor is N − 1, as in `np.cov`. The mean is known to be 0: `y.T @ y / len(y)`.",
    ),
    "summed": (
        lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y),
        "Your C is the sum of the y yᵀ. It is their mean: divide by the number of rows.",
    ),
    "divided by m": (
        lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y / y.shape[1]),
        "Your C is the sum of the y yᵀ divided by the number of sensors. It is a mean over the innovations, the rows: `len(y)`.",
    ),
    "N − 1": (
        lambda y, H, P: estimate(y, H, P, lambda y: y.T @ y / (len(y) - 1)),
        "Your C is divided by N − 1. No mean was estimated: divide by N.",
    ),
    "variances only": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.diag(np.mean(y**2, axis=0))),
        "Your C has only the variances. Two sensors may err together, and y yᵀ shows it: keep the other entries.",
    ),
    "one number": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.mean(y**2)),
        "Your C is a single number. Each sensor has its own scatter: C is a matrix, `y.T @ y / len(y)`.",
    ),
    "added": (
        lambda y, H, P: y.T @ y / len(y) + H @ P @ H.T,
        "You added H P Hᵀ. C measures S = H P Hᵀ + R, and R is what remains when H P Hᵀ comes off.",
    ),
    "C alone": (
        lambda y, H, P: y.T @ y / len(y),
        "That is C. Take off what the prediction explains by itself, H P Hᵀ.",
    ),
    "H forgotten": (
        lambda y, H, P: y.T @ y / len(y) - P[: len(H), : len(H)],
        "A corner of P is taken off C here. What the sensors see of the prediction's doubt is H P Hᵀ.",
    ),
    "mean times mean": (
        lambda y, H, P: estimate(y, H, P, lambda y: np.outer(y.mean(axis=0), y.mean(axis=0))),
        "You multiplied the mean innovation by itself. C is the mean of the products y yᵀ: first multiply, then "
        "average.",
    ),
    "diagonal of the whole": (
        lambda y, H, P: np.diag(np.diag(estimate(y, H, P))),
        "The variances are right. The other entries are not 0: they tell what the sensors' errors have in common. Keep them.",
    ),
    "y yᵀ of all": (
        lambda y, H, P: y @ y.T / len(y) - H @ P @ H.T,
        "Your C has one row for each innovation, as `y @ y.T` or `y.T * y` has. The rows of y are the innovations, so the sum of all y yᵀ is `y.T @ y`.",
    ),
    "with a floor": (
        lambda y, H, P: np.maximum(estimate(y, H, P), 0.01),
        "No entry of your R̂ is below a floor. The text asks for R̂ without one; and a floor belongs under variances only, not under every entry.",
    ),
    "made positive": (
        lambda y, H, P: abs(estimate(y, H, P)),
        "You took the size of each entry. What the sensors' errors have in common may be negative; and no floor is asked for.",
    ),
    "diagonals": (
        lambda y, H, P: np.mean(y**2, axis=0) - np.diag(H @ P @ H.T),
        "Those are the variances of the sensors, and they are right. R̂ is a matrix: its other entries tell what "
        "the sensors' errors have in common.",
    ),
    "row for matrix": (
        lambda y, H, P: np.mean(y**2, axis=0) - H @ P @ H.T,
        "Here H P Hᵀ, a matrix, is taken off a row of variances. C is a matrix: `y.T @ y / len(y)`.",
    ),
    "all numbers": (
        lambda y, H, P: y.T @ y / y.size - H @ P @ H.T,
        "You divided by the number of all entries of y. C is a mean over the innovations, the rows: `len(y)`.",
    ),
    "the wrong way": (
        lambda y, H, P: H @ P @ H.T - y.T @ y / len(y),
        "You took C off H P Hᵀ. C is the larger one: R is what remains of it.",
    ),
    "identity for H": (
        lambda y, H, P: y.T @ y / len(y) - H @ H.T,
        "P is missing between H and Hᵀ: the prediction's doubt, seen by the sensors, is H P Hᵀ.",
    ),
    "the last thirty": (
        lambda y, H, P: estimate(y[-30:], H, P),
        "You use the last 30 innovations only. Here C is the mean over all that are given.",
    ),
    "P for H P Hᵀ": (
        lambda y, H, P: y.T @ y / len(y) - P,
        "You took P off C. The sensors see P as H P Hᵀ, which has as many rows as there are sensors.",
    ),
}
