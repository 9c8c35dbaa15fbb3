"""Wrong answers to exercises of lesson 10, each with the sentence that it gets."""

import numpy as np


def step(x, P, reading, Q, R):
    """One step of the random walk's filter: the estimate, its variance, its predicted variance."""
    predicted = P + Q
    K = predicted / (predicted + R)
    return x + K * (reading - x), (1 - K) * predicted, predicted


def loop(x, P, z, Q, R):
    """The random walk's filter from a given start."""
    for reading in z:
        x, P, _ = step(x, P, reading, Q, R)
    return x, P


def grows(z, Q, R):
    """The loop without (1 − K)P."""
    x, P = z[0], R
    for reading in z[1:]:
        P = P + Q
        x = x + P / (P + R) * (reading - x)
    return x, P


def late_prediction(z, Q, R):
    """The loop with the prediction at its end."""
    x, P = z[0], R
    for reading in z[1:]:
        x, P = x + P / (P + R) * (reading - x), P * R / (P + R) + Q
    return x, P


def all_estimates(z, Q, R):
    """The estimates after each reading, and the last variance."""
    found = [loop(z[0], R, z[1:k], Q, R) for k in range(1, len(z) + 1)]
    return np.array([x for x, _ in found]), found[-1][1]


WRONG = {
    "mended_step": {
        "as published": (
            lambda x, P, room, reading, Q, R: (
                step(x, P, room, Q, R)[0],
                step(x, P, room, Q, R)[1],
            ),
            "That is the published step again: it corrects with the room's true temperature, and it hands back a variance.",
        ),
        "still the truth": (
            lambda x, P, room, reading, Q, R: (step(x, P, room, Q, R)[0], np.sqrt(step(x, P, room, Q, R)[1])),
            "The deviation is right now. But the estimate is still corrected with `room`, the truth, which no filter is ever shown.",
        ),
        "still the variance": (
            lambda x, P, room, reading, Q, R: step(x, P, reading, Q, R)[:2],
            "The estimate is right now. But (1 − K)P is a variance, in °C²; its root is the deviation.",
        ),
        "predicted deviation": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], np.sqrt(step(x, P, reading, Q, R)[2])),
            "That is the deviation before the reading; the factor 1 − K under the root is missing.",
        ),
        "root of the old P": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], np.sqrt(P)),
            "You took the root of the P that came in. P has since grown by Q and shrunk by 1 − K.",
        ),
        "root of P alone": (
            lambda x, P, room, reading, Q, R: (
                step(x, P, reading, Q, R)[0],
                (1 - (P + Q) / (P + Q + R)) * np.sqrt(P + Q),
            ),
            "The factor 1 − K belongs under the root: it shrinks the variance, and the deviation by its root only.",
        ),
        "Q forgotten": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, 0, R)[0], np.sqrt(step(x, P, reading, 0, R)[1])),
            "Q is missing: P grows by Q before the gain is formed.",
        ),
        "1 − K for K": (
            lambda x, P, room, reading, Q, R: (
                reading + (P + Q) / (P + Q + R) * (x - reading),
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "K and 1 − K have changed places in the correction: start at the prediction and move by the fraction K towards the reading.",
        ),
        "average of truth and reading": (
            lambda x, P, room, reading, Q, R: (
                step(x, P, (room + reading) / 2, Q, R)[0],
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "Half a truth is still a truth that no filter is shown: correct with the reading alone.",
        ),
        "sign of the innovation": (
            lambda x, P, room, reading, Q, R: (
                2 * x - step(x, P, reading, Q, R)[0],
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "Your estimate walks away from the reading: K times (reading − x) is added.",
        ),
        "twice the deviation": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], 2 * np.sqrt(step(x, P, reading, Q, R)[1])),
            "The estimate is right. The second number is 2σ, half the width of a band; asked is one standard deviation.",
        ),
        "results swapped": (
            lambda x, P, room, reading, Q, R: (np.sqrt(step(x, P, reading, Q, R)[1]), step(x, P, reading, Q, R)[0]),
            "Both are right, in the wrong order: first the estimate, then its deviation.",
        ),
        "reading minus truth": (
            lambda x, P, room, reading, Q, R: (
                x + (P + Q) / (P + Q + R) * (reading - room),
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "You subtract the true temperature from the reading. The innovation is the reading minus what the filter expects, x.",
        ),
        "K for 1 − K in P": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], np.sqrt((P + Q) ** 2 / (P + Q + R))),
            "The estimate is right. In the variance you took K; what is left after a reading is the part 1 − K.",
        ),
        "the reading's σ": (
            lambda x, P, room, reading, Q, R: (step(x, P, reading, Q, R)[0], np.sqrt(R)),
            "The estimate is right. The second number is the sensor's σ; the estimate's is the root of (1 − K)P.",
        ),
    },
    "room_filter": {
        "as published": (
            lambda z, Q, R: loop(z[0], Q, z[1:], Q, R),
            "That is the published start again: Q says how far the room moves in a step, not how good a reading is.",
        ),
        "published number": (
            lambda z, Q, R: loop(z[0], 0.01, z[1:], Q, R),
            "0.01 is the published number. What does the first reading deserve, for any R?",
        ),
        "first reading twice": (
            lambda z, Q, R: loop(z[0], R, z, Q, R),
            "The first reading counts twice: it makes the start, and then the loop corrects with it once more. Begin the loop at z[1].",
        ),
        "published, and twice": (
            lambda z, Q, R: loop(z[0], Q, z, Q, R),
            "Two faults: the start claims Q instead of a reading's variance, and the first reading is used again in the loop.",
        ),
        "certain": (
            lambda z, Q, R: loop(z[0], 0.0, z[1:], Q, R),
            "P = 0 says that the first reading is exact: the second reading would hardly count.",
        ),
        "R + Q": (
            lambda z, Q, R: loop(z[0], R + Q, z[1:], Q, R),
            "At the moment of the first reading nothing has moved yet: P = R. The first prediction, in the loop, adds Q.",
        ),
        "σ for variance": (
            lambda z, Q, R: loop(z[0], np.sqrt(R), z[1:], Q, R),
            "P is a variance: start it with R itself, not with its root.",
        ),
        "Q forgotten": (
            lambda z, Q, R: loop(z[0], R, z[1:], 0, R),
            "The start is right. But without Q this is the plain average of all readings, right for a room that never changes.",
        ),
        "ignores": (
            lambda z, Q, R: (z[0], R),
            "That is the start alone: the other readings are still to be filtered.",
        ),
        "starts at 0": (
            lambda z, Q, R: loop(0.0, R, z, Q, R),
            "You start at 0 °C, as sure as of a reading. The first reading is the start: x = z[0], P = R.",
        ),
        "P does not shrink": (
            lambda z, Q, R: (grows(z, Q, R)[0], grows(z, Q, R)[1]),
            "P grows by Q at each step and never shrinks. After each correction it is multiplied by 1 − K.",
        ),
        "Q after the correction": (
            late_prediction,
            "You add Q after the correction, so the first gain misses it and the last P has it too much. Predict first, then correct.",
        ),
        "P starts at 1": (
            lambda z, Q, R: loop(z[0], 1.0, z[1:], Q, R),
            "You start with P = 1, whatever the sensor is. The first reading is as good as its variance.",
        ),
        "Q and R swapped": (
            lambda z, Q, R: loop(z[0], Q, z[1:], R, Q),
            "You exchanged Q and R: Q is added in the prediction, R stands in the gain and at the start.",
        ),
        "Q and R swapped, start right": (
            lambda z, Q, R: loop(z[0], R, z[1:], R, Q),
            "The start is right. In the loop you exchanged Q and R: Q is added in the prediction, R stands in the gain.",
        ),
        "scatter of z": (
            lambda z, Q, R: loop(z[0], np.var(z) if len(z) > 1 else 2 * R, z[1:], Q, R),
            "You started with the scatter of the whole series. At the first reading nothing of it is known, but the sensor's variance is.",
        ),
        "a deviation at the end": (
            lambda z, Q, R: (loop(z[0], R, z[1:], Q, R)[0], np.sqrt(loop(z[0], R, z[1:], Q, R)[1])),
            "The estimate is right. The second number is a standard deviation; here the variance is asked for.",
        ),
        "all estimates": (all_estimates, "These are all estimates, one for each reading; the last one was asked for."),
        "R at the end": (
            lambda z, Q, R: (loop(z[0], R, z[1:], Q, R)[0], R),
            "The estimate is right. The variance is that of a single reading; return the P that the loop has made smaller.",
        ),
        "starts at the mean": (
            lambda z, Q, R: loop(np.mean(z), R, z[1:], Q, R),
            "You start at the mean of the series, which contains readings still to come. Start at the first, z[0].",
        ),
        "R squared": (lambda z, Q, R: loop(z[0], R**2, z[1:], Q, R**2), "You squared R. It is a variance already."),
        "one reading left out": (
            lambda z, Q, R: loop(z[0], R, z[2:], Q, R),
            "You left out the second reading: after the start from z[0] the loop begins at z[1].",
        ),
        "vague at the first reading": (
            lambda z, Q, R: loop(z[0], 1000, z[1:], Q, R),
            "With P = 1000 the first reading hardly counts: you start at it as if nothing were known. It is as good as its variance.",
        ),
    },
    "noise": {
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
    },
}
