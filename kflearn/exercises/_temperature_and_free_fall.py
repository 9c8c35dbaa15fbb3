"""Wrong answers to exercises of lesson 9, each with the sentence that it gets."""

import numpy as np

from kflearn import rmse


def compared(x, one, other, cov, keep=slice(None), entry=1, root=np.sqrt, states=0):
    """A report with some of its details chosen."""
    errors = (rmse(way[keep][..., states], x[keep][..., states]) for way in (one, other))
    return *errors, root(cov[keep][-1, entry, entry])


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


WRONG = {
    "honest_report": {
        "as published": (
            lambda x, z, mean, ignored, cov: compared(x, mean, z, cov, entry=0, root=lambda v: v),
            "That is the published report again: it counts underground, leaves out ignoring, and prints the height's variance.",
        ),
        "not cut": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov),
            "You compare with the right thing, but still count underground: keep only moments with x[:, 0] > 0.",
        ),
        "compared with raw": (
            lambda x, z, mean, ignored, cov: compared(x, mean, z, cov, x[:, 0] > 0),
            "The second number is the error of the raw readings. This filter beats them and still does harm: compare with `ignored`.",
        ),
        "height's entry": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, entry=0),
            "The third number is σ of the *height*: cov[…, 0, 0]. The velocity is the second state, entry [1, 1].",
        ),
        "variance": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, root=lambda v: v),
            "The right entry, but it is a variance, in m²/s²; σ is its root.",
        ),
        "last of all": (
            lambda x, z, mean, ignored, cov: (
                *compared(x, mean, ignored, cov, x[:, 0] > 0)[:2],
                np.sqrt(cov[-1, 1, 1]),
            ),
            "The errors are right. But σ is that of the very last moment, deep underground: take the last one above.",
        ),
        "below": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] <= 0),
            "You kept what lies underground and threw away the rest.",
        ),
        "both states": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, states=slice(None)),
            "Your errors mix metres with metres per second: take the height alone, column 0.",
        ),
        "swapped": (
            lambda x, z, mean, ignored, cov: compared(x, ignored, mean, cov, x[:, 0] > 0),
            "The two errors have changed places: first the filter's, then that of ignoring.",
        ),
        "filter against prediction": (
            lambda x, z, mean, ignored, cov: (
                rmse(mean[x[:, 0] > 0, 0], x[x[:, 0] > 0, 0]),
                rmse(mean[x[:, 0] > 0, 0], ignored[x[:, 0] > 0, 0]),
                np.sqrt(cov[x[:, 0] > 0][-1, 1, 1]),
            ),
            "The second number compares the filter with the prediction. Compare the prediction with the truth.",
        ),
        "velocity error": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, states=1),
            "Those are the errors of the velocity; the height was asked for, column 0.",
        ),
    },
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
            "You forgot to predict: P grows by Q before the gain is formed.",
        ),
        "1 − K for K": (
            lambda x, P, room, reading, Q, R: (
                reading + (P + Q) / (P + Q + R) * (x - reading),
                np.sqrt(step(x, P, reading, Q, R)[1]),
            ),
            "K and 1 − K have changed places in the correction: start at the prediction and walk the fraction K towards the reading.",
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
            "The innovation has the wrong sign: your estimate walks away from the reading.",
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
            "P = 0 says that the first reading is exact: worse than the published start.",
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
    },
}
