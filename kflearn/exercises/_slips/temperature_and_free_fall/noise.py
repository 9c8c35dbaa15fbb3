"""Lesson 10, `noise`: wrong answers, each with the sentence that it gets."""

import numpy as np


def row_of(normal, Q, *rows):
    """Noise in which each row is stretched by such a variance."""
    return np.sqrt(np.array(rows))[:, None] * normal


def by_sample(normal, Q):
    w = np.sqrt(Q) @ normal
    with np.errstate(all="ignore"):
        return w / w.std(axis=1, keepdims=True) * np.sqrt(np.diag(Q))[:, None]


WRONG = {
    "as published": (
        lambda normal, Q: np.array([(np.sqrt(Q) @ normal).T.ravel()[: normal.shape[1]]] * 2),
        "That is the published one again: one number, alternately from height and velocity, added to both.",
    ),
    "first row twice": (
        lambda normal, Q: np.array([(np.sqrt(Q) @ normal)[0]] * 2),
        "Both states still get the same number, now that of the height.",
    ),
    "one draw, stretched twice": (
        lambda normal, Q: np.outer(np.sqrt(np.diag(Q)), normal[0]),
        "The variances are right, but one draw serves both states: they always move together. Each row has draws of its own.",
    ),
    "Q for its root": (
        lambda normal, Q: Q @ normal,
        "You stretched by the variances: the noise would have the covariance Q². Stretch by their roots.",
    ),
    "not stretched": (
        lambda normal, Q: normal,
        "Standard normal numbers have variance 1; bring in Q.",
    ),
    "divided": (
        lambda normal, Q: normal / np.sqrt(np.diag(Q))[:, None],
        "You divided by the deviations; that would make given noise standard normal.",
    ),
    "swapped": (
        lambda normal, Q: np.sqrt(Q)[::-1, ::-1] @ normal,
        "Height and velocity have changed places: the first row belongs to the first entry of Q.",
    ),
    "transposed": (
        lambda normal, Q: (np.sqrt(Q) @ normal).T,
        "The numbers are right, but turned on their side: one column for each step was asked for, (2, N).",
    ),
    "reshaped": (
        lambda normal, Q: (np.sqrt(Q) @ normal).T.ravel().reshape(2, -1),
        "Read down the columns and refilled along the rows: height and velocity are mixed up.",
    ),
    "one σ for both": (
        lambda normal, Q: np.sqrt(Q[0, 0]) * normal,
        "You stretched both rows by the height's deviation. The second row is the velocity's: the root of the second entry of Q.",
    ),
    "added up": (
        lambda normal, Q: np.sqrt(np.diag(Q)) @ normal,
        "You added height's and velocity's noise to one row. Each keeps its own row: stretch them separately.",
    ),
    "first step only": (
        lambda normal, Q: (np.sqrt(Q) @ normal)[:, 0],
        "That is the noise of the first step alone; all N columns are wanted.",
    ),
    "root of the noise": (
        lambda normal, Q: np.sqrt(Q @ normal),
        "You took the root of Q times the numbers. The root is of Q alone; the numbers keep their signs.",
    ),
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
    "diag, no column": (
        lambda normal, Q: np.sqrt(np.diag(Q)) * normal,
        "`np.sqrt(np.diag(Q))` is a row of two numbers, and NumPy lays it along the steps. As a column, `[:, None]`, it stretches the two rows of `normal`.",
        r"diag\(Q\)\)+ *\* *normal|normal *\* *np\.sqrt\(np\.diag",
    ),
    "lesson's numbers": (
        lambda normal, Q: np.array([[0.2], [0.1]]) * normal,
        "0.2 and 0.1 are the deviations of one Q, the lesson's. Take them from the Q that is handed in.",
    ),
    "halved": (
        lambda normal, Q: np.diag(Q)[:, None] / 2 * normal,
        "You halved the variances. The deviation is the root of the variance.",
    ),
    "sum of the variances": (
        lambda normal, Q: np.sqrt(np.trace(Q)) * normal,
        "You stretch both rows by the root of the sum of the variances. Each state has a variance of its own.",
    ),
    "second σ for both": (
        lambda normal, Q: np.sqrt(Q[1, 1]) * normal,
        "You stretched both rows by the velocity's deviation. The first row is the height's: the root of the first entry of Q.",
    ),
    "only the first": (
        lambda normal, Q: np.array([np.sqrt(Q[0, 0]) * normal[0], normal[1]]),
        "The height's row is right. The velocity's is not stretched yet.",
    ),
    "only the second": (
        lambda normal, Q: np.array([normal[0], np.sqrt(Q[1, 1]) * normal[1]]),
        "The velocity's row is right. The height's is not stretched yet.",
    ),
    "variance for the second": (
        lambda normal, Q: np.array([np.sqrt(Q[0, 0]) * normal[0], Q[1, 1] * normal[1]]),
        "The height's row is right. The velocity's is stretched by the variance.",
    ),
    "second row twice": (
        lambda normal, Q: np.array([(np.sqrt(Q) @ normal)[1]] * 2),
        "Both states get the same number, that of the velocity.",
    ),
    "summed": (
        lambda normal, Q: np.cumsum(np.sqrt(Q) @ normal, axis=1),
        "You added the noise up over the steps. Each step has its own.",
    ),
    "rows exchanged": (
        lambda normal, Q: (np.sqrt(Q) @ normal)[::-1],
        "The two rows are exchanged: height comes first, then velocity.",
    ),
    "scaled by the sample": (
        by_sample,
        "Do not divide by the scatter of this sample. The numbers in `normal` are drawn with σ = 1 already: only multiply.",
    ),
    "added": (
        lambda normal, Q: normal + np.sqrt(np.diag(Q))[:, None],
        "These are the random numbers plus the deviations: they are moved, and scatter as before. A deviation "
        "stretches: multiply each row by its own.",
    ),
}
