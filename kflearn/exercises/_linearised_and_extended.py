"""Wrong answers to exercises of lesson 13, each with the sentence that it gets."""

import numpy as np


def radar_slope(x, sign=-1, power=3, other=1):
    """The Jacobian of distance and its rate, with the entries of the second row open to mistakes."""
    r = np.hypot(x[0], x[2])
    turn = x[2] * x[1] - x[0] * x[3]
    bent = other * x[2] * turn / r**power, sign * x[0] * turn / r**power
    return np.array([[x[0] / r, 0, x[2] / r, 0], [bent[0], x[0] / r, bent[1], x[2] / r]])


def grown(x, u):
    """Where the growth model moves x."""
    return x / 2 + 25 * x / (1 + x**2) + u


def growth_slope(x):
    """Its slope."""
    return 0.5 + 25 * (1 - x**2) / (1 + x**2) ** 2


WRONG = {
    "mended_slope": {
        "as claimed": (
            lambda x: radar_slope(x, sign=1),
            "That is the claimed Jacobian again. Take its difference from `jacobian(radar, x)`: one entry is not near zero.",
        ),
        "the neighbour": (
            lambda x: radar_slope(x, sign=1, other=-1),
            "You turned the sign in column 0, which was right; the wrong entry is the other one that holds `turn`.",
        ),
        "both": (
            lambda x: radar_slope(x, other=-1),
            "You turned both signs: one was wrong and is mended, the other was right and is now wrong.",
        ),
        "power two": (
            lambda x: radar_slope(x, power=2),
            "The sign is right now, but the third power of the distance was right too: leave it.",
        ),
        "transposed": (
            lambda x: radar_slope(x).T,
            "The numbers are right, but turned on their side: one row a measurement, one column a state.",
        ),
        "negative": (
            lambda x: -radar_slope(x),
            "Every sign is turned: that is the slope of −h. Did you take h(x − step) − h(x + step)?",
        ),
        "double": (
            lambda x: 2 * radar_slope(x),
            "Twice too large: the two points are 2·step apart, so divide by 2·step.",
        ),
        "entry zero": (
            lambda x: radar_slope(x, sign=0),
            "That the entry is wrong is no reason to strike it out: the rate does depend on y. Mend it.",
        ),
        "first row only": (
            lambda x: radar_slope(x)[:1],
            "The radar measures two things, so H has two rows: distance, and its rate.",
        ),
        "power two, sign as claimed": (
            lambda x: radar_slope(x, sign=1, power=2),
            "The third power of the distance was right, and the wrong sign is still there: compare entry by entry with `jacobian(radar, x)`.",
        ),
        "power one": (
            lambda x: radar_slope(x, power=1),
            "The sign is right now. But the changes with the place have r³ below; you left only r.",
        ),
        "sign of the last entry": (
            lambda x: radar_slope(x, sign=1) * np.array([[1, 1, 1, 1], [1, 1, 1, -1]]),
            "You turned the sign of the last entry, y/r, which was right. Compare entry by entry with `jacobian(radar, x)`.",
        ),
        "sign of x/r": (
            lambda x: radar_slope(x, sign=1) * np.array([[1, 1, 1, 1], [1, -1, 1, 1]]),
            "You turned the sign of x/r in the second row, which was right. Compare entry by entry with `jacobian(radar, x)`.",
        ),
        "sign in the first row": (
            lambda x: radar_slope(x, sign=1) * np.array([[1, 1, -1, 1], [1, 1, 1, 1]]),
            "You changed the first row, the slope of the distance. It was right; look in the second.",
        ),
        "second row only": (
            lambda x: radar_slope(x)[1],
            "That is the second row alone. The radar measures two things, so two rows are wanted.",
        ),
        "entries exchanged": (
            lambda x: radar_slope(x, sign=1)[:, [2, 1, 0, 3]] * [[0], [1]] + radar_slope(x) * [[1], [0]],
            "You exchanged the two entries that hold `turn`. Each stands in its place; one of them has the wrong sign.",
        ),
        "power two in the third": (
            lambda x: np.vstack([radar_slope(x)[0], [*radar_slope(x)[1, :2], *radar_slope(x, power=2)[1, 2:]]]),
            "The sign is right now, but in this entry you left r²: the third power of the distance was right.",
        ),
        "speeds exchanged": (
            lambda x: np.vstack([radar_slope(x)[0], radar_slope(x)[1, [0, 3, 2, 1]]]),
            "The sign is mended. But the slopes for the two speeds, x/r and y/r, have changed places.",
        ),
        "north for east": (
            lambda x: np.vstack(
                [radar_slope(x)[0], [*radar_slope(x)[1, :2], -radar_slope(x)[1, 0], x[2] / np.hypot(x[0], x[2])]]
            ),
            "The sign is right now, but the entry in the column of y holds x[0] times `turn`, and you put x[2] there.",
        ),
        "first row negative": (
            lambda x: radar_slope(x) * [[-1], [1]],
            "The second row is right. In the first, the slope of the distance, you turned the signs: it was right.",
        ),
        "the difference": (
            lambda x: radar_slope(x) - radar_slope(x, sign=1),
            "That is the difference of the two. It shows where the fault is; return the right Jacobian itself.",
        ),
    },
    "mended_prediction": {
        "as published": (
            lambda x, P, u: (grown(x, u), growth_slope(grown(x, u)) ** 2 * P + 10),
            "That is the published prediction again: its slope is taken where the belief lands, not where it stood.",
        ),
        "halfway": (
            lambda x, P, u: (grown(x, u), growth_slope((x + grown(x, u)) / 2) ** 2 * P + 10),
            "You took the slope halfway. The belief to be pushed through the curve stands at the old x, nowhere else.",
        ),
        "at the input": (
            lambda x, P, u: (grown(x, u), growth_slope(x + u) ** 2 * P + 10),
            "The input is added after the curve: it shifts the mean and changes no slope.",
        ),
        "slope at u": (
            lambda x, P, u: (grown(x, u), growth_slope(u) ** 2 * P + 10),
            "You took the slope at u, the input. It is taken at x, where the belief stood before it moved.",
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
        "Q forgotten": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * P),
            "The slope is right now. But P also grows by Q = 10, the variance of what disturbs a step.",
        ),
        "Q stretched too": (
            lambda x, P, u: (grown(x, u), growth_slope(x) ** 2 * (P + 10)),
            "The disturbance comes after the move, so the curve does not stretch it: F·P·F first, then + 10.",
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
            "You shifted the place of the slope by u. The belief to be moved stands at the old x, whatever the input is.",
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
            "One of the two slopes is still taken where the belief lands. Both belong to the old x.",
        ),
        "|F| once": (
            lambda x, P, u: (grown(x, u), abs(growth_slope(x)) * P + 10),
            "P is a variance: stretching by F multiplies it by F twice, which is never negative, without abs.",
        ),
    },
    "true_starts": {
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
            "The scatter is right, but it lies about zero: add the mean.",
        ),
        "one draw for all states": (
            lambda mean, P0, normal: mean + normal[:, :1] * np.sqrt(np.diag(P0)),
            "One draw serves all four states of a run, so they are always wrong together. P0 is diagonal: each has its own.",
        ),
        "one draw for all runs": (
            lambda mean, P0, normal: mean + 0 * normal + normal[0] * np.sqrt(np.diag(P0)),
            "Every run starts at the same wrong place. The belief speaks of many starts: each run has its own row.",
        ),
        "other side": (
            lambda mean, P0, normal: mean - normal * np.sqrt(np.diag(P0)),
            "As a draw that is just as good, for a bell is symmetric; but please add, so that the numbers can be compared.",
        ),
        "divided": (
            lambda mean, P0, normal: mean + normal / np.sqrt(np.diag(P0)),
            "You divided by the deviations: the vaguest state would scatter least.",
        ),
        "transposed": (
            lambda mean, P0, normal: (mean + normal * np.sqrt(np.diag(P0))).T,
            "The numbers are right, but turned on their side: one row a run, one column a state.",
        ),
        "the same wrong place": (
            lambda mean, P0, normal: mean + normal[0] * np.sqrt(np.diag(P0)),
            "You use the first row of `normal` only. Each run has a row of its own: multiply the whole array.",
        ),
        "σ added": (
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
