"""Wrong answers to exercises of lesson 14, each with the sentence that it gets."""

import numpy as np


def grown(x, u):
    """Where the growth model moves x."""
    return x / 2 + 25 * x / (1 + x**2) + u


def growth_slope(x):
    """Its slope."""
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2


WRONG = {
    "mended_prediction": {
        "as published": (
            lambda x, P, u: (grown(x, u), growth_slope(grown(x, u)) ** 2 * P + 10),
            "That is the published prediction again: its slope is taken at the new x, where the belief is after the move. Take it at the old x.",
        ),
        "halfway": (
            lambda x, P, u: (grown(x, u), growth_slope((x + grown(x, u)) / 2) ** 2 * P + 10),
            "You took the slope halfway. The belief that is moved is at the old x, so take the slope there.",
        ),
        "at the input": (
            lambda x, P, u: (grown(x, u), growth_slope(x + u) ** 2 * P + 10),
            "The input is added after the curve: it shifts the mean and changes no slope.",
        ),
        "slope at u": (
            lambda x, P, u: (grown(x, u), growth_slope(u) ** 2 * P + 10),
            "You took the slope at u, the input. It is taken at x, where the belief was before the move.",
        ),
        "slope with 2.5": (
            lambda x, P, u: (grown(x, u), (0.5 + 2.5 * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10),
            "The mean is right. In the slope the coefficient is 25, as in the model, not 2.5.",
        ),
        "2.5 in both": (
            lambda x, P, u: (
                x / 2 + 2.5 * x / (1 + x**2) + u,
                (0.5 + 2.5 * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10,
            ),
            "The coefficient of the growth model is 25, in the curve and in its slope; you took 2.5.",
        ),
        "mean alone": (
            lambda x, P, u: grown(x, u),
            "The mean is right. Return its variance as well: F P F + 10.",
        ),
        "Q squared": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P + 100),
            "You squared Q. Q = 10 is the variance of the disturbance already.",
        ),
        "slope at the move without u": (
            lambda x, P, u: (grown(x, u), growth_slope(grown(x, 0)) ** 2 * P + 10),
            "You took the slope at the moved place, without u. The belief that is moved is at the old x: take the slope there, before the move.",
        ),
        "quotient not squared": (
            lambda x, P, u: (grown(x, u), (0.5 + 25 * (1 - x**2) / (1 + x**2)) ** 2 * P + 10),
            "In your slope the divisor is not squared. `move_slope(x)` of the notebook has it right.",
        ),
        "½ left out": (
            lambda x, P, u: (grown(x, u), (25 * (1 - x**2) / (1 + x**2) ** 2) ** 2 * P + 10),
            "In your slope the ½ of x/2 is missing. `move_slope(x)` of the notebook has it right.",
        ),
        "quotient rule left out": (
            lambda x, P, u: (grown(x, u), (0.5 + 25 / (1 + x**2)) ** 2 * P + 10),
            "In your slope only the numerator is differentiated: x stands in the divisor as well. `move_slope(x)` of the notebook has it right.",
        ),
        "variance alone": (
            lambda x, P, u: growth_slope(x) ** 2 * P + 10,
            "The variance is right. Return the mean as well, first: `return x, P`.",
        ),
        "P as it was": (
            lambda x, P, u: (grown(x, u), P),
            "The mean is right. P must be stretched by the curve, F on both sides, and grow by Q = 10.",
        ),
        "Q forgotten": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P),
            "The slope is right now. But P also grows by Q = 10, the variance of what disturbs a step.",
        ),
        "Q stretched too": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * (P + 10)),
            "The disturbance comes after the move, so it is not multiplied by the slope: F·P·F first, then + 10.",
        ),
        "F once": (
            lambda x, P, u: (grown(x, u), growth_slope(x) * P + 10),
            "P is a variance: stretching by F multiplies it by F twice. With F below zero yours may even be negative.",
        ),
        "deviation for variance": (
            lambda x, P, u: (grown(x, u), np.sqrt(growth_slope(x) ** 2 * P + 10)),
            "You took a root: P is a variance and stays one.",
        ),
        "tangent for the mean": (
            lambda x, P, u: (growth_slope(x) * x + u, growth_slope(x) ** 2 * P + 10),
            "P is right. But the mean travels along the curve itself, `move(x, u)`; the slope is for the width only.",
        ),
        "u forgotten": (
            lambda x, P, u: (grown(x, 0), growth_slope(x) ** 2 * P + 10),
            "P is right. The mean lacks the known input u.",
        ),
        "not moved": (
            lambda x, P, u: (x, growth_slope(x) ** 2 * P + 10),
            "P is right, but the mean has stayed where it was: it moves to `move(x, u)`.",
        ),
        "swapped": (
            lambda x, P, u: (growth_slope(x) ** 2 * P + 10, grown(x, u)),
            "Both are right, in the wrong order: first the mean, then its variance.",
        ),
        "root of Q": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P + np.sqrt(10)),
            "You added the root of 10. Q = 10 is the variance of the disturbance already.",
        ),
        "input taken off": (
            lambda x, P, u: (grown(x, u), growth_slope(x - u) ** 2 * P + 10),
            "You shifted the place of the slope by u. The belief that is moved is at the old x, whatever the input is.",
        ),
        "P squared": (
            lambda x, P, u: (grown(x, u), (growth_slope(x) * P) ** 2 + 10),
            "You squared P as well: only F stands twice, P once in the middle.",
        ),
        "not stretched": (
            lambda x, P, u: (grown(x, u), P + 10),
            "The mean is right. P must be stretched by the curve: F on both sides, then + 10.",
        ),
        "Q = 1": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P + 1),
            "The slope is right now. The reading's variance is 1, but the disturbance of the move has Q = 10.",
        ),
        "one slope at each place": (
            lambda x, P, u: (grown(x, u), growth_slope(x) * P * growth_slope(grown(x, u)) + 10),
            "One of the two slopes is still taken at the new x. Both belong to the old x.",
        ),
        "|F| once": (
            lambda x, P, u: (grown(x, u), abs(growth_slope(x)) * P + 10),
            "P is a variance: stretching by F multiplies it by F twice, which is never negative, without abs.",
        ),
    },
    "true_starts": {
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
    },
}
