"""More wrong answers to exercises of lessons 17 and 18, each with the sentence that it gets."""

import math

import numpy as np


def image(degrees):
    """The y-coordinate at a distance of 100 m."""
    return 100 * np.sin(np.radians(degrees))


def points(mean, covariance, scale):
    """The points of a belief."""
    rows = np.linalg.cholesky(scale * covariance).T
    return np.vstack([mean, mean + rows, mean - rows])


def pushed(mean, P, Q, scale):
    """The points of P, each outer one moved by the diagonal of Q."""
    push = np.diag(np.diag(Q))
    return points(mean, P, scale) + np.vstack([0 * mean, push, -push])


def chances(stays, T, leave):
    """A transition matrix whose rows leave with given chances."""
    M, leave = len(stays), leave[:, None]
    return np.where(np.eye(M, dtype=bool), 1 - leave, leave / (M - 1))


MORE = {
    "blended_sigma": {
        "half of it": (
            15.0,
            "15 m is half of a σ. Take the mean of the two variances, add the squared distance of each mean from the middle, then take the root.",
        ),
        "spread for one only": (
            math.sqrt(30**2 + 40**2 / 2),
            "You counted the spread for one of the two Gaussians only, or halved it: each of the two means is 40 m from the middle.",
        ),
        "everything added": (
            110.0,
            "You added σ and the distance of the means. Variances and squared distances add; the root comes last.",
        ),
        "both variances": (
            math.sqrt(2 * 30**2 + 40**2),
            "You added both variances in full. The blend takes their weighted mean, half of each.",
        ),
        "both variances, both spreads": (
            math.sqrt(2 * 30**2 + 2 * 40**2),
            "You added everything for both models. Each counts with its weight, one half.",
        ),
        "half the variance": (
            math.sqrt(30**2 / 2 + 40**2),
            "You halved the variance. The mean of two equal variances, half of each, is one of them: 900 m².",
        ),
    },
    "three_points": {
        "the root of κ": (
            lambda: 2 / 3 * 100 + 1 / 3 * image(90 + np.sqrt(2) * 30),
            "Your outer points sit at ±√2 · 30°: you took the root of κ. The scale is α²(n + κ) = 3, so they sit at "
            "±√3 · 30°.",
        ),
        "equal weights, one sigma": (
            lambda: (100 + 2 * image(120)) / 3,
            "Two things: the outer points sit at ±√3 · 30°, not at ±30°; and the weights are not equal: 2/3 for the "
            "centre, 1/6 for each of the others.",
        ),
        "outer points alone": (
            lambda: image(90 + np.sqrt(3) * 30),
            "That is the mean of the two outer points. The centre counts as well, with a weight of 2/3.",
        ),
        "a third each way": (
            lambda: 100 / 3 + image(90 + np.sqrt(3) * 30) / 3,
            "The points are right. Your weights sum to 2/3: the centre has 2/3 by itself, the other two 1/6 each.",
        ),
        "how much it sinks": (
            lambda: 100 / 3 * (1 - np.sin(np.radians(90 + np.sqrt(3) * 30))),
            "That is how far the mean sinks below 100 m. The question asks for the mean itself.",
        ),
    },
    "redrawn": {
        "Q twice": (
            lambda mean, P, Q, scale: points(mean, P + 2 * Q, scale),
            "You added Q twice. The belief was widened once: its covariance is P + Q.",
        ),
        "Q on the points": (
            pushed,
            "You moved the points of P by the diagonal of Q. Q is a covariance: add it to P first, then draw the points.",
        ),
        "centre last": (
            lambda mean, P, Q, scale: np.roll(points(mean, P + Q, scale), -1, axis=0),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "variances only": (
            lambda mean, P, Q, scale: points(mean, np.diag(np.diag(P + Q)), scale),
            "You used the variances only. The other entries of P + Q belong to the belief too: take the root of all of it.",
        ),
        "root entry by entry": (
            lambda mean, P, Q, scale: np.vstack(
                [mean, *(mean + side * np.sqrt(abs(scale * (P + Q))) for side in (1, -1))]
            ),
            "You took the root entry by entry. The root of a matrix L fulfils L Lᵀ = scale · (P + Q): `np.linalg.cholesky`.",
        ),
    },
    "start_nees": {
        "all a hundredth": (
            0.06,
            "You took 1/100 for all six. For the accelerations the ratio is 0.0001/0.1, which is 1/1000.",
        ),
        "inverse of the claim": (
            2 * (0.01 + 1 + 10),
            "You added the inverses of what P₀ claims, as if e² were 1 for all. Each is to be multiplied by its real "
            "variance in Q.",
        ),
        "one": (
            1.0,
            "1 would be an honest start, as a mean of the six. Asked is the sum of six ratios, and here each of them is small.",
        ),
    },
    "transition": {
        "stays over T, at most 1": (
            lambda stays, T: chances(stays, T, np.minimum(1, stays / T)),
            "You divided stays by T. The chance to leave in one step is T / stays: the longer the stay, the smaller it is.",
        ),
        "whole steps": (
            lambda stays, T: chances(stays, T, 1 / (stays / T + 1)),
            "You counted one step more. A mode that lasts `stays / T` steps on average is left with the chance T / stays.",
        ),
        "half": (
            lambda stays, T: chances(stays, T, T / stays / 2),
            "You halved the chance to leave. It is T / stays, and the other M − 1 modes share it.",
        ),
        "the first for all": (
            lambda stays, T: chances(stays, T, T / stays[0] + 0 * stays),
            "You took the first length for all rows. Each mode has its own: row i belongs to `stays[i]`.",
        ),
    },
}
