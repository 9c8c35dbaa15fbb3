"""Lesson 14, `true_starts`: wrong answers, each with the sentence that it gets."""

import numpy as np


def some_drawn(mean, P0, normal, first):
    """Starts of which only two states are drawn."""
    starts = np.tile(np.asarray(mean, float), (len(normal), 1))
    starts[:, first::2] += (normal * np.sqrt(np.diag(P0)))[:, first::2]
    return starts


WRONG = {
    "times the mean": (
        lambda mean, P0, normal: mean * (1 + np.sqrt(np.diag(P0)) * normal),
        "You multiplied the scatter by the mean. It is added: a truth is the mean plus a random part whose covariance is P0.",
    ),
    "as published": (
        lambda mean, P0, normal: mean + 0 * normal,
        "That is the published study again: every truth starts where the filter believes, exactly, while P0 claims otherwise.",
    ),
    "variance for its root": (
        lambda mean, P0, normal: mean + normal @ P0,
        "You stretched by the variances. The starts would scatter with covariance P0², not P0: take the roots.",
    ),
    "not stretched": (
        lambda mean, P0, normal: mean + normal,
        "That scatters with variance 1 in every state: honest for P0 = I, and for nothing else.",
    ),
    "about zero": (
        lambda mean, P0, normal: normal * np.sqrt(np.diag(P0)),
        "The scatter is right, but it is centred on zero: add the mean.",
    ),
    "one draw for all states": (
        lambda mean, P0, normal: mean + normal[:, :1] * np.sqrt(np.diag(P0)),
        "One draw serves all four states of a run, so they are always wrong together. P0 is diagonal: each has its own.",
    ),
    "one draw for all runs": (
        lambda mean, P0, normal: mean + 0 * normal + normal[0] * np.sqrt(np.diag(P0)),
        "Every run starts at the same wrong place. Each run has its own start, and its own row of `normal`.",
    ),
    "√P0 as it is": (
        lambda mean, P0, normal: mean + normal * np.sqrt(P0),
        "`np.sqrt(P0)` is a matrix, (4, 4), and each run is a row of `normal`: take the four variances off the diagonal first, or `normal @ np.sqrt(P0)`.",
        r"sqrt\(P0\)|cholesky\(P0\)",
    ),
    "one σ for all": (
        lambda mean, P0, normal: mean + normal * np.sqrt(np.trace(P0)),
        "You gave all four states the same σ, from the trace. Each state has its own variance: column i is stretched by the root of P0[i, i].",
    ),
    "mean variance": (
        lambda mean, P0, normal: mean + normal * np.sqrt(np.trace(P0) / 4),
        "You gave all four states the same σ. Each state has its own variance: column i is stretched by the root of P0[i, i].",
    ),
    "first σ for all": (
        lambda mean, P0, normal: mean + normal * np.sqrt(P0[0, 0]),
        "You gave all four states the σ of the first. Each state has its own variance: column i is stretched by the root of P0[i, i].",
    ),
    "two σ": (
        lambda mean, P0, normal: mean + 2 * normal * np.sqrt(np.diag(P0)),
        "You stretched by two σ. A standard normal number already reaches beyond one σ in a third of the runs: multiply it by σ.",
    ),
    "not random": (
        lambda mean, P0, normal: mean + 0 * normal + np.sqrt(np.diag(P0)),
        "Every run would start one σ away, always on the same side, and `normal` is not used. Multiply each σ by its random number.",
    ),
    "published covariance": (
        lambda mean, P0, normal: normal,
        "Those are the random numbers as they are given: stretch each column by its σ, and add the mean.",
    ),
    "divided": (
        lambda mean, P0, normal: mean + normal / np.sqrt(np.diag(P0)),
        "You divided by the standard deviations: the least certain state would scatter least.",
    ),
    "transposed": (
        lambda mean, P0, normal: (mean + normal * np.sqrt(np.diag(P0))).T,
        "The numbers are right, but turned on their side: one row a run, one column a state.",
    ),
    "the same wrong place": (
        lambda mean, P0, normal: mean + normal[0] * np.sqrt(np.diag(P0)),
        "You use the first row of `normal` only. Each run has a row of its own: multiply the whole array.",
    ),
    "σ added, one row": (
        lambda mean, P0, normal: mean + np.sqrt(np.diag(P0)),
        "Every run would start one σ away, always on the same side, and `normal` is not used. Multiply each σ by its random number.",
    ),
    "variance squared": (
        lambda mean, P0, normal: mean + normal * np.diag(P0) ** 2,
        "You squared the variances. A standard deviation is the root of a variance.",
    ),
    "mean multiplied": (
        lambda mean, P0, normal: mean * normal * np.sqrt(np.diag(P0)),
        "You multiplied the mean as well. Stretch the random numbers, then add the mean.",
    ),
    "places only": (
        lambda mean, P0, normal: some_drawn(mean, P0, normal, 0),
        "The places are right, but the speeds stay at the mean: draw all four states.",
    ),
    "speeds only": (
        lambda mean, P0, normal: some_drawn(mean, P0, normal, 1),
        "The speeds are right, but the places stay at the mean: draw all four states.",
    ),
    "mean stretched": (
        lambda mean, P0, normal: (mean + normal) * np.sqrt(np.diag(P0)),
        "You stretched the mean too. Multiply only `normal` by σ, then add the mean.",
    ),
}
