"""Wrong answers to exercises of lesson 10 that a second stranger tried, and more of their kind."""

import numpy as np

from kflearn import rmse
from kflearn.exercises._combined import combined


def started(x, P, readings, gain="R", stop=None):
    """The room's filter from some start over some of the readings."""

    def last(z, Q, R):
        level, var = {"z0": z[0], "0": 0.0, "mean": np.mean(z), "last": z[-1]}[x], P(Q, R)
        for reading in z[{"rest": 1, "all": 0, "two": 2}[readings] :][:stop]:
            var = var + Q
            K = {"R": var / (var + R), "Q": var / (var + Q), "σ": var**0.5 / (var**0.5 + R**0.5)}[gain]
            level, var = level + K * (reading - level), (1 - K) * var
        return level, var

    return last


def mended(K, second, old_gain=False):
    """One step with another gain, or another second number."""

    def step(x, P, room, reading, Q, R):
        old, P = P, P + Q
        gain = K(old if old_gain else P, R)
        return x + gain * (reading - x), second(old, P, gain, R)

    return step


def kalman(P, R):
    return P / (P + R)


def deviation(old, P, K, R):
    return np.sqrt((1 - K) * P)


def made_of(error, sigma):
    """A report of a fall from error(way, x, z) of the heights, and sigma(cov), both of the moments above the ground."""

    def report(x, z, mean, ignored, cov):
        above = x[:, 0] > 0
        errors = [error(way[above, 0], x[above, 0], z[above, 0]) for way in (mean, ignored)]
        return *errors, sigma(cov[above])

    return report


def reported(keep, second, entry, root, last):
    """A report of a fall in which something else is chosen."""

    def report(x, z, mean, ignored, cov):
        above = {"above": x[:, 0] > 0, "all": x[:, 0] > -np.inf, "below": x[:, 0] <= 0}[keep]
        other = {"ignored": ignored, "z": z, "mean": mean}[second]
        at = {"last": np.flatnonzero(above)[-1], "end": -1, "first": np.flatnonzero(above)[0],
              "next": min(np.flatnonzero(above)[-1] + 1, len(x) - 1)}[last]  # fmt: skip
        value = cov[at, entry, entry]
        errors = [rmse(way[above, 0], x[above, 0]) for way in (mean, other)]
        return *errors, np.sqrt(value) if root else value

    return report


WRONG = {
    "mended_step": {
        "gain of deviations": (
            mended(lambda P, R: np.sqrt(P) / (np.sqrt(P) + np.sqrt(R)), deviation),
            "Your gain is made of standard deviations. K = P/(P + R) is made of variances.",
        ),
        "gain of the old P": (
            mended(kalman, deviation, old_gain=True),
            "You form the gain from the P that came in. First P grows by Q, then the gain is formed from it.",
        ),
        "gain of Q": (
            lambda x, P, room, reading, Q, R: (
                x + (P + Q) / (P + 2 * Q) * (reading - x),
                np.sqrt(Q / (P + 2 * Q) * (P + Q)),
            ),
            "Below the line of the gain stands P + R, the reading's variance; you have Q there.",
        ),
        "without a gain": (
            lambda x, P, room, reading, Q, R: (reading, np.sqrt(R)),
            "That is the reading alone and its σ. The estimate starts from x and moves by the part K towards the reading.",
        ),
        "no correction": (
            lambda x, P, room, reading, Q, R: (x, np.sqrt(P + Q)),
            "That is the prediction. Correct it with the reading.",
        ),
        "σ of S": (
            mended(kalman, lambda old, P, K, R: np.sqrt(P + R)),
            "The estimate is right. The second number is σ of the innovation, √(P + R); wanted is that of the estimate.",
        ),
        "added deviations": (
            mended(kalman, lambda old, P, K, R: (1 - K) * (np.sqrt(old) + np.sqrt(P - old))),
            "The estimate is right. For the second number you added roots: variances add up, and the root comes last.",
        ),
        "truth and old P": (
            lambda x, P, room, reading, Q, R: (x + (P + Q) / (P + Q + R) * (room - x), np.sqrt(P)),
            "Two faults: the estimate is still corrected with the truth; and P has grown by Q and shrunk by 1 − K before its root is taken.",
        ),
        "the mean of both": (
            lambda x, P, room, reading, Q, R: ((x + reading) / 2, np.sqrt(R * (P + Q) / (P + Q + R))),
            "You take the mean of prediction and reading. They are weighted: K = P/(P + R) for the reading.",
        ),
    },
    "room_filter": {
        "inside the loop": (
            lambda z, Q, R: started("z0", lambda Q, R: R, "rest", stop=1)(z, Q, R),
            "That is the estimate after the second reading. Does the `return` stand inside the loop? Then only one round is made.",
        ),
        "very vague": (
            lambda z, Q, R: started("z0", lambda *_: 1e6, "rest")(z, Q, R),
            "You start with P = 10⁶, so that the first reading hardly counts. A single reading has the variance R.",
        ),
        "last one left out": (
            lambda z, Q, R: started("z0", lambda Q, R: R, "rest")(z[:-1], Q, R),
            "The last reading is left out: `z[1:]` goes to the end, `z[1:-1]` does not.",
        ),
        "the mean": (lambda z, Q, R: (np.mean(z), np.var(z)), "Those are the mean of the readings and their variance. A filter weighs the newest most."),
        "last reading": (lambda z, Q, R: (z[-1], R), "That is the last reading alone. The readings before it tell something too."),
        "gain": (
            lambda z, Q, R: (lambda x, P: (x, P / R))(*started("z0", lambda Q, R: R, "rest")(z, Q, R)),
            "The estimate is right. The second number is the last gain; wanted is the variance P.",
        ),
        "predicted": (
            lambda z, Q, R: (lambda x, P: (x, P + Q))(*started("z0", lambda Q, R: R, "rest")(z, Q, R)),
            "The estimate is right. The variance is that of the next prediction, one Q too large.",
        ),
        "constant gain": (
            lambda z, Q, R: (_steady(z, (R + Q) / (2 * R + Q)), R * (R + Q) / (2 * R + Q)),
            "Your gain stays that of the second reading: P must go on from step to step.",
        ),
        "P never shrinks, no Q": (
            lambda z, Q, R: (_steady(z, 0.5), R / 2),
            "Your gain is one half in each step. P grows by Q and shrinks by 1 − K, so the gain changes.",
        ),
        "backwards": (
            lambda z, Q, R: started("z0", lambda Q, R: R, "rest")(z[::-1], Q, R),
            "You go through the readings backwards. The first is where the filter starts.",
        ),
        "room's numbers": (
            lambda z, Q, R: started("z0", lambda *_: 0.25, "rest")(z, 0.01, 0.25),
            "That is the filter with Q and R of the lesson's room. Use the Q and R that are handed in.",
        ),
        "no Q, and published": (
            lambda z, Q, R: started("z0", lambda *_: Q, "rest")(z, 0, R),
            "Two faults: the start claims Q, and in the loop P does not grow by Q.",
        ),
        "Q last": (
            lambda z, Q, R: (lambda x, P: (x, P - Q))(*_late(z, Q, R)),
            "The first correction goes without Q. Before each new reading the room has moved: P grows by Q first.",
        ),
    }
    | combined(
        lambda x, P, readings, gain: started(x, {"R": lambda Q, R: R, "R²": lambda Q, R: R * R, "√R": lambda Q, R: R**0.5, "Q": lambda Q, R: Q,
                    "Q + R": lambda Q, R: Q + R, "2R": lambda Q, R: 2 * R, "R/2": lambda Q, R: R / 2}.get(P, lambda Q, R: P), readings, gain),
        x={"z0": "", "0": "You start at 0 °C. The first reading is the start: x = z[0].", "mean": "You start at the mean of all readings. Start at the first, z[0].",
           "last": "You start at the last reading. Start at the first, z[0]."},
        P={"R": "", "R²": "You start with R². R is a variance already: a single reading has the variance R.", "√R": "You start with √R. P is a variance: R.",
           "Q": "You start with Q, as published. A single reading has the variance R.", "Q + R": "You start with Q + R. When the first reading is made, nothing has moved yet.",
           "2R": "You start with 2R. A single reading has the variance R.", "R/2": "You start with R/2. A single reading has the variance R.", 0: "You start with P = 0, as if the first reading were exact."}
        | {number: f"You start with P = {number:g}, whatever R is. A single reading has the variance R." for number in (0.01, 0.1, 0.25, 1.0, 10.0, 100.0, 500.0, 1000.0, 1e4)},
        readings={"rest": "", "all": "The first reading is used in the loop as well. It is used up by the start: begin the loop at z[1].", "two": "The second reading is left out: the loop begins at z[1]."},
        gain={"R": "", "Q": "Below the line of the gain stands P + R; you have P + Q.", "σ": "The gain is made of variances, not of standard deviations."},
    ),
    "noise": {
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
    },
    "honest_report": {
        "median": (
            made_of(lambda way, x, z: np.sqrt(np.median((way - x) ** 2)), lambda cov: np.sqrt(cov[-1, 1, 1])),
            "Those are medians. Root mean square: square, mean, root; `rmse` does it.",
        ),
        "last errors": (
            made_of(lambda way, x, z: abs(way - x)[-1], lambda cov: np.sqrt(cov[-1, 1, 1])),
            "Those are the errors at the last moment above. Take the root mean square over all moments above.",
        ),
        "of the readings": (
            made_of(lambda way, x, z: rmse(way, z), lambda cov: np.sqrt(cov[-1, 1, 1])),
            "You compare with the readings. Errors are measured against the truth, x.",
        ),
        "corner": (
            made_of(lambda way, x, z: rmse(way, x), lambda cov: np.sqrt(cov[-1, 0, 1])),
            "The errors are right. You took the root of the covariance, entry [0, 1]; the velocity's variance is entry [1, 1].",
        ),
        "mean of σ": (
            made_of(lambda way, x, z: rmse(way, x), lambda cov: np.mean(np.sqrt(cov[:, 1, 1]))),
            "The errors are right. The third number is a mean of σ; wanted is σ at the last moment above.",
        ),
    }
    | combined(
        reported,
        most=3,
        keep={"above": "", "all": "You still count underground.", "below": "You keep what lies underground."},
        second={"ignored": "", "z": "You compare with the raw readings and not with `ignored`.", "mean": "The filter is compared with itself: the second error is that of `ignored`."},
        entry={1: "", 0: "The third number is of the height; the velocity's entry is [1, 1]."},
        root={True: "", False: "The third number is a variance; σ is its root."},
        last={"last": "", "end": "σ is that of the very last moment, deep underground.", "next": "σ is that of the first moment underground: count from 0.", "first": "σ is that of the first moment."},
    ),
}  # fmt: skip


def _steady(z, K):
    """The estimate with one gain for all."""
    x = z[0]
    for reading in z[1:]:
        x = x + K * (reading - x)
    return x


def _late(z, Q, R):
    """The loop with the prediction at its end."""
    x, P = z[0], R
    for reading in z[1:]:
        K = P / (P + R)
        x, P = x + K * (reading - x), (1 - K) * P + Q
    return x, P
