"""Lesson 17, `redrawn`: wrong answers, each with the sentence that it gets."""

import numpy as np


def around(mean, rows):
    """The points mean, mean + rows, mean − rows."""
    return np.vstack([mean, mean + rows, mean - rows])


def columns(P):
    """The columns of the Cholesky root, as rows."""
    return np.linalg.cholesky(P).T


def spread(mean, rows):
    """The points mean, mean + rows, mean − rows."""
    return np.vstack([mean, mean + rows, mean - rows])


def symmetric(P):
    """The symmetric root of a covariance."""
    sizes, directions = np.linalg.eigh(P)
    return (directions * np.sqrt(np.maximum(sizes, 0))) @ directions.T


def along_axes(P):
    """The axes of the ellipse, as rows."""
    sizes, directions = np.linalg.eigh(P)
    return (directions * np.sqrt(np.maximum(sizes, 0))).T


def points(mean, covariance, scale):
    """The points of a belief."""
    rows = np.linalg.cholesky(scale * covariance).T
    return np.vstack([mean, mean + rows, mean - rows])


def pushed(mean, P, Q, scale):
    """The points of P, each outer one moved by the diagonal of Q."""
    push = np.diag(np.diag(Q))
    return points(mean, P, scale) + np.vstack([0 * mean, push, -push])


def around_scaled(mean, covariance):
    """The points of a covariance that is scaled already."""
    rows = np.linalg.cholesky(covariance).T
    return np.vstack([mean, mean + rows, mean - rows])


WRONG = (
    {
        "as published": (
            lambda mean, P, Q, scale: around(mean, columns(scale * P)),
            "Those are points for P alone, as published. Q has made the belief wider, and the points must have the covariance P + Q.",
        ),
        "Q alone": (
            lambda mean, P, Q, scale: around(mean, columns(scale * Q)),
            "Those points carry only Q; the belief before it, P, is lost.",
        ),
        "roots added": (
            lambda mean, P, Q, scale: around(mean, np.sqrt(scale) * (columns(P) + columns(Q))),
            "You added the roots. Variances add, their roots do not: take the root of P + Q.",
        ),
        "Q not scaled": (
            lambda mean, P, Q, scale: around(mean, columns(scale * P + Q)),
            "The scale must stretch Q as well: the root of scale · (P + Q).",
        ),
        "no scale": (
            lambda mean, P, Q, scale: around(mean, columns(P + Q)),
            "The covariance is right, but the points sit at ±1σ: the scale is missing.",
        ),
        "scale without its root": (
            lambda mean, P, Q, scale: around(mean, scale * columns(P + Q)),
            "The covariance is right, but the root is stretched by the scale; stretch it by √scale, or the covariance by the scale.",
        ),
        "rows for columns": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q)).T),
            "Your points go along the rows of the (lower) Cholesky root; they go along its columns, the rows of `np.linalg.cholesky(…).T`.",
        ),
        "covariance for its root": (
            lambda mean, P, Q, scale: around(mean, scale * (P + Q)),
            "You went along the columns of the covariance itself; take its Cholesky root first.",
        ),
        "minus first": (
            lambda mean, P, Q, scale: around(mean, -columns(scale * (P + Q))),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "plus and minus by turns": (
            lambda mean, P, Q, scale: np.vstack(
                [mean, *(mean + side * row for row in columns(scale * (P + Q)) for side in (1, -1))]
            ),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "around zero": (
            lambda mean, P, Q, scale: around(0 * mean, columns(scale * (P + Q))),
            "The spread is right, but the points lie around zero: add the mean.",
        ),
        "turned": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q))).T,
            "The right points, turned on their side: one row for each point was asked for, (2n + 1, n).",
        ),
        "centre missing": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q)))[1:],
            "The outer points are right. The centre, the mean itself, is a point too: put it first.",
        ),
        "minus missing": (
            lambda mean, P, Q, scale: around(mean, columns(scale * (P + Q)))[: len(mean) + 1],
            "Half of the points: each column goes both ways, mean + column and mean − column.",
        ),
        "scale divides": (
            lambda mean, P, Q, scale: around(mean, columns((P + Q) / scale)),
            "Those are the points of (P + Q)/scale. The scale multiplies the covariance: the points lie √scale standard deviations away.",
        ),
        "symmetric root": (
            lambda mean, P, Q, scale: spread(mean, symmetric(scale * (P + Q))),
            "The covariance of your points is right, but you took the symmetric root. Here the points are wanted that `sigma_points` draws, with the Cholesky root.",
        ),
        "axes of the ellipse": (
            lambda mean, P, Q, scale: spread(mean, along_axes(scale * (P + Q))),
            "The covariance of your points is right, but they lie on the axes of the ellipse. Here the points are wanted that `sigma_points` draws, with the Cholesky root.",
        ),
        "Q taken off": (
            lambda mean, P, Q, scale: points(mean, P - Q, scale),
            "You took Q off P. Q has made the belief wider: its covariance is P + Q.",
            r"P *- *Q|Q *- *P",
        ),
        "n for the scale": (
            lambda mean, P, Q, scale: points(mean, P + Q, len(mean)),
            "The covariance is right. It is multiplied by n; use `scale`, which is handed in.",
        ),
        "√scale in the covariance": (
            lambda mean, P, Q, scale: points(mean, P + Q, np.sqrt(scale)),
            "The covariance is right. It is multiplied by √scale: the covariance is multiplied by the scale, or its root by √scale.",
        ),
        "mean of both": (
            lambda mean, P, Q, scale: points(mean, (P + Q) / 2, scale),
            "Those are the points of (P + Q)/2. The widened belief has the sum of P and Q, and the scale as it is.",
        ),
        "P, Q apart": (
            lambda mean, P, Q, scale: np.vstack([points(mean, P, scale), points(mean, Q, scale)[1:]]),
            "You drew points for P and for Q. One set of 2n + 1 points must represent the widened belief, whose covariance is P + Q.",
        ),
        "Q squared": (
            lambda mean, P, Q, scale: points(mean, P + Q @ Q, scale),
            "Those are the points of P + Q Q. Q is a covariance already: add it as it is.",
        ),
        "fused": (
            lambda mean, P, Q, scale: points(mean, np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(Q)), scale),
            "Those are the points of P and Q fused, which is narrower than both. A push with covariance Q makes the belief wider: P + Q.",
        ),
        "Q twice": (
            lambda mean, P, Q, scale: points(mean, P + 2 * Q, scale),
            "Those are the points of P + 2Q. The belief was widened once: its covariance is P + Q.",
        ),
        "Q on the points": (
            pushed,
            "Those are the points of P, moved by the diagonal of Q. Q is a covariance: add it to P first, then draw the points.",
        ),
        "centre last": (
            lambda mean, P, Q, scale: np.roll(points(mean, P + Q, scale), -1, axis=0),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "variances only": (
            lambda mean, P, Q, scale: points(mean, np.diag(np.diag(P + Q)), scale),
            "Those are the points of the variances alone. The other entries of P + Q belong to the belief too: take the root of all of it.",
        ),
        "root entry by entry": (
            lambda mean, P, Q, scale: np.vstack(
                [mean, *(mean + side * np.sqrt(abs(scale * (P + Q))) for side in (1, -1))]
            ),
            "You took the root entry by entry. The root of a matrix L fulfils L Lᵀ = scale · (P + Q): `np.linalg.cholesky`.",
        ),
        "n + scale": (
            lambda mean, P, Q, scale: around_scaled(mean, (len(mean) + scale) * (P + Q)),
            "The covariance is right. It is multiplied by n + scale; `scale` is α²(n + κ), with the n in it already.",
        ),
        "n times scale": (
            lambda mean, P, Q, scale: around_scaled(mean, len(mean) * scale * (P + Q)),
            "The covariance is right. It is multiplied by n · scale; `scale` is α²(n + κ), with the n in it already.",
        ),
        "both squared": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + Q) @ (P + Q)),
            "Those points belong to the square of P + Q. P and Q are covariances already: add them, and take the root.",
        ),
        "Q scaled twice": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + scale * Q)),
            "Q has the scale twice in these points, P once: both need it once, scale · (P + Q).",
        ),
        "half as far": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + Q) / 4),
            "The directions are right, but your points are half as far from the mean as they should be.",
        ),
        "twice as far": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + Q) * 4),
            "The directions are right, but your points are twice as far from the mean as they should be.",
        ),
    }
    | {
        f"scale {fixed}": (
            lambda mean, P, Q, scale, fixed=fixed: around_scaled(mean, fixed * (P + Q)),
            f"The covariance is right, and your points sit at ±√{fixed} σ in every trial: use the `scale` that is handed in.",
        )
        for fixed in (2, 3, 4, 5, 6, 9)
    }
    | {
        "the belief": (
            lambda mean, P, Q, scale: (mean, P + Q),
            "That is the widened belief, and it is right. What is wanted are its 2n + 1 points: `sigma_points` draws them, with `scale`.",
        ),
        "the covariance": (
            lambda mean, P, Q, scale: P + Q,
            "That is the covariance of the widened belief, and it is right. Wanted are its 2n + 1 points: `sigma_points` draws them.",
        ),
        "centre twice": (
            lambda mean, P, Q, scale: np.vstack([mean, around_scaled(mean, scale * (P + Q))]),
            "The centre stands there twice. There are 2n + 1 points: the centre, n with plus, n with minus.",
        ),
        "centre in the middle": (
            lambda mean, P, Q, scale: np.roll(around_scaled(mean, scale * (P + Q)), len(mean), axis=0),
            "The right points in another order: first the centre, then all with plus, then all with minus.",
        ),
        "in one row": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + Q)).ravel(),
            "The right numbers in one long row. One row for each point is wanted, (2n + 1, n): `np.vstack`.",
        ),
        "covariance of the points, unweighted": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (np.cov(around_scaled(mean, scale * P).T) + Q)),
            "P has been worked out anew from points, as a plain sample's covariance, and that is not P: the points have weights. P is handed in.",
        ),
        "covariance of the points, over all": (
            lambda mean, P, Q, scale: around_scaled(
                mean, scale * (np.cov(around_scaled(mean, scale * P).T, ddof=0) + Q)
            ),
            "P has been worked out anew from points, as a plain sample's covariance, and that is not P: the points have weights. P is handed in.",
        ),
        "root of Q": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + np.sqrt(abs(Q)))),
            "Q stands there with roots of its entries. Q is a covariance already: add it as it is.",
        ),
        "first of Q": (
            lambda mean, P, Q, scale: around_scaled(mean, scale * (P + Q[0, 0] * np.eye(len(mean)))),
            "Of Q the first entry stands there alone, for all states. Q is a matrix: add all of it.",
        ),
    }
)
