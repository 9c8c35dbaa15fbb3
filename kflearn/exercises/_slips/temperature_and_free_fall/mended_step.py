"""Lesson 10, `mended_step`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.temperature_and_free_fall.shared import step


def stepped(x, P, reading, Q, R):
    """One right step of the random walk's filter: the estimate, the gain, P before the reading."""
    before = P + Q
    K = before / (before + R)
    return x + K * (reading - x), K, before


def deviation(old, P, K, R):
    return np.sqrt((1 - K) * P)


def mended(K, second, old_gain=False):
    """One step with another gain, or another second number."""

    def step(x, P, room, reading, Q, R):
        old, P = P, P + Q
        gain = K(old if old_gain else P, R)
        return x + gain * (reading - x), second(old, P, gain, R)

    return step


def kalman(P, R):
    return P / (P + R)


ROOM = "You start at `room`, the truth. The estimate moves from x, by K times reading minus x."


def from_the_room(P, room, reading, Q, R, root=np.sqrt):
    K = (P + Q) / (P + Q + R)
    return room + K * (reading - room), root((1 - K) * (P + Q))


def of_the_others(x, P, room, reading, Q, R):
    """A step with the gain R/(P + R)."""
    P = P + Q
    K = R / (P + R)
    return x + K * (reading - x), np.sqrt((1 - K) * P)


def Q_after_the_correction(x, P, room, reading, Q, R):
    K = P / (P + R)
    return x + K * (reading - x), np.sqrt(K * R + Q)


WRONG = {
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
    "from the room": (lambda x, P, room, reading, Q, R: from_the_room(P, room, reading, Q, R), ROOM),
    "from the room, variance": (
        lambda x, P, room, reading, Q, R: from_the_room(P, room, reading, Q, R, root=lambda v: v),
        f"{ROOM} And the second number is a variance: take its root.",
    ),
    "the other share": (
        of_the_others,
        "These are the results of the gain R/(P + R), with which a reading counts for less the better it is. The gain is the share of the "
        "prediction's variance: K = P/(P + R).",
    ),
    "Q after the correction": (
        Q_after_the_correction,
        "It answers as if Q were added after the correction. The room moves before it is read: P grows by Q "
        "first, and the gain is made of that P.",
    ),
}
