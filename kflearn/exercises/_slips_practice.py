"""More wrong answers to exercises of lessons 6 to 10, each with the sentence that it gets: those that a stranger tried."""

import numpy as np


def moved(P, dt):
    """F P Fᵀ for an angle and its rate."""
    F = np.array([[1, dt], [0, 1]])
    return F @ P @ F.T


def stepped(x, P, reading, Q, R):
    """One right step of the random walk's filter: the estimate, the gain, P before the reading."""
    before = P + Q
    K = before / (before + R)
    return x + K * (reading - x), K, before


def row_of(normal, Q, *rows):
    """Noise in which each row is stretched by such a variance."""
    return np.sqrt(np.array(rows))[:, None] * normal


WRONG = {
    "R_with_drift": {
        "mean, then square": (
            lambda readings: np.mean(np.diff(readings)) ** 2 / 2,
            "You took the mean first and squared then: positive and negative differences cancel. Square each of them, then take the mean.",
        ),
        "no mean": (
            lambda readings: np.diff(readings) ** 2 / 2,
            "That is one number for each pair of neighbours. Take their mean.",
        ),
        "second differences, halved": (
            lambda readings: np.mean(np.diff(readings, n=2) ** 2) / 2,
            "A second difference, z₂ − 2z₁ + z₀, holds R + 4R + R = 6R: divide its mean square by 6.",
        ),
        "first ten": (
            lambda readings: np.var(readings[:10]),
            "You took the variance of the first ten readings: ten are few, and the drift is in it. Use the differences of all neighbours.",
        ),
        "products": (
            lambda readings: np.mean(readings[1:] * readings[:-1]) / 2,
            "You multiplied neighbours with one another. Take their difference, and square that.",
        ),
    },
    "nees": {
        "one e": (
            lambda e, P: np.sum(e @ np.linalg.inv(P)),
            "You added up the entries of P⁻¹ e. Multiply each by its e first: e stands on both sides of P⁻¹.",
        ),
        "outer product": (
            lambda e, P: np.outer(e, e) @ np.linalg.inv(P),
            "That is a matrix, e eᵀ P⁻¹. NEES is one number, eᵀ P⁻¹ e: it is the trace of your matrix.",
        ),
        "P twice": (
            lambda e, P: e @ np.linalg.inv(P @ P) @ e,
            "That is eᵀ P⁻¹ P⁻¹ e. P holds variances already: P⁻¹ stands once between the two e.",
        ),
        "divided once more": (
            lambda e, P: e @ np.linalg.inv(P) @ e / np.linalg.det(P),
            "eᵀ P⁻¹ e is right. The determinant is contained in P⁻¹ already: do not divide once more.",
        ),
        "first component": (
            lambda e, P: e[0] ** 2 / P[0, 0],
            "You score the first component only. All of them count, with their covariances.",
        ),
        "n itself": (
            lambda e, P: float(len(e)),
            "The number n is what NEES is on average, if the filter is honest. Here the NEES of this one e and P is wanted.",
        ),
    },
    "share_inside": {
        "expected": (
            lambda e, P: 0.683,
            "68.3 % is what to expect of an honest filter. Count how many of these errors are really inside.",
        ),
        "half of σ": (
            lambda e, P: np.mean(abs(e) <= np.sqrt(P) / 2),
            "Your band is half as wide as it should be: ±σ, with σ = √P.",
        ),
        "mean error": (
            lambda e, P: np.mean(abs(e)) <= np.sqrt(np.mean(P)),
            "You compare the mean error with a mean σ, once. Compare each error with its own σ, and take the share.",
        ),
        "first P": (
            lambda e, P: np.mean(abs(e) <= np.sqrt(P[0])),
            "You use the first variance for all. Each error has a variance of its own.",
        ),
    },
    "draw_start": {
        "root of all": (
            lambda mean, variances, normal: mean + np.sqrt(variances * abs(normal)),
            "The random number stands under the root, and its sign is lost. Stretch it by √variance: the root is of the variance alone.",
        ),
        "one side": (
            lambda mean, variances, normal: mean + np.sqrt(variances) * abs(normal),
            "All your starts lie above the mean: you took the size of the random number. It has a sign of its own.",
        ),
        "sum of the variances": (
            lambda mean, variances, normal: mean + np.sqrt(np.sum(variances)) * normal,
            "You stretch each number by the root of the *sum*. Each state has a variance of its own.",
        ),
        "first variance": (
            lambda mean, variances, normal: mean + np.sqrt(variances[0]) * normal,
            "You use the first variance for all. Each state has a variance of its own.",
        ),
    },
    "right_prediction": {
        "corners mended, q as published": (
            lambda P, Q, dt: moved(P, dt) - np.diag([dt**2 * P[1, 1], 0]) + Q[0, 0] * np.eye(2),
            "The corners of F P Fᵀ are right. In the upper left dt²·P₁₁ is missing, and of Q you add the first entry twice: add the whole Q.",
        ),
        "dt² P₁₁ forgotten": (
            lambda P, Q, dt: moved(P, dt) - np.diag([dt**2 * P[1, 1], 0]) + Q,
            "Three entries are right. In the upper left one dt²·P₁₁ is missing: the rate's own variance, carried to the angle.",
        ),
        "a symmetric P taken for granted": (
            lambda P, Q, dt: moved(P, dt) + Q + np.diag([dt * (P[0, 1] - P[1, 0]), 0]),
            "You took P₀₁ twice. This P need not be symmetric: in the upper left stands P₀₁ + P₁₀.",
        ),
        "symmetric throughout": (
            lambda P, Q, dt: moved(np.array([[P[0, 0], P[0, 1]], [P[0, 1], P[1, 1]]]), dt) + Q,
            "You took P₀₁ for P₁₀ as well. This P need not be symmetric: use both.",
        ),
        "upper left and q as published": (
            lambda P, Q, dt: moved(P, dt) - np.diag([dt * P[0, 1] + dt**2 * P[1, 1], 0]) + Q[0, 0] * np.eye(2),
            "The corners of F P Fᵀ are right. In the upper left dt·P₀₁ and dt²·P₁₁ are missing, and of Q you add the first entry twice: add the whole Q.",
        ),
        "Q squared": (
            lambda P, Q, dt: moved(P, dt) + Q**2,
            "F P Fᵀ is right. Q is a covariance already: it is not squared.",
        ),
    },
    "mended_step": {
        "1 − K times the old P": (
            lambda x, P, room, reading, Q, R: (
                stepped(x, P, reading, Q, R)[0],
                np.sqrt((1 - stepped(x, P, reading, Q, R)[1]) * P),
            ),
            "The estimate is right. In (1 − K)P you used the P that came in: take the one that has grown by Q.",
        ),
        "K": (
            lambda x, P, room, reading, Q, R: stepped(x, P, reading, Q, R)[:2],
            "The estimate is right. The second number is K; wanted is the deviation, the root of (1 − K)P.",
        ),
        "√K": (
            lambda x, P, room, reading, Q, R: (
                stepped(x, P, reading, Q, R)[0],
                np.sqrt(stepped(x, P, reading, Q, R)[1]),
            ),
            "The estimate is right. The second number is the root of K; wanted is the root of (1 − K)P, in °C.",
        ),
        "variance squared": (
            lambda x, P, room, reading, Q, R: (
                stepped(x, P, reading, Q, R)[0],
                ((1 - stepped(x, P, reading, Q, R)[1]) * stepped(x, P, reading, Q, R)[2]) ** 2,
            ),
            "The estimate is right. You squared the variance; the deviation is its root.",
        ),
        "true error": (
            lambda x, P, room, reading, Q, R: (
                stepped(x, P, reading, Q, R)[0],
                abs(stepped(x, P, reading, Q, R)[0] - room),
            ),
            "The estimate is right. The second number is its true error, which takes the truth, `room`, to know. A filter claims the root of (1 − K)P.",
        ),
    },
    "noise": {
        "entry by entry": (
            lambda normal, Q: np.sqrt(Q) * normal,
            "`*` multiplies entry by entry, and the shapes (2, 2) and (2, N) do not fit. The product of matrices is `@`: np.sqrt(Q) @ normal.",
            r"sqrt\(Q\) *\* *normal|normal *\* *np\.sqrt\(Q",
        ),
        "the order": (
            lambda normal, Q: normal @ np.sqrt(Q),
            "The shapes do not fit: Q (2, 2) stands on the left of the numbers (2, N).",
            r"normal *@",
        ),
        "mean variance": (
            lambda normal, Q: row_of(normal, Q, np.trace(Q) / 2, np.trace(Q) / 2),
            "You stretch both rows by the root of the mean variance. Each state has a variance of its own.",
        ),
        "Q twice": (
            lambda normal, Q: Q @ Q @ normal,
            "You stretched by the squares of the variances. Stretch by their roots.",
        ),
        "rows of the numbers exchanged": (
            lambda normal, Q: np.sqrt(Q) @ normal[::-1],
            "The deviations are right, but the rows of the random numbers have changed places: the first belongs to the height.",
        ),
    },
}
