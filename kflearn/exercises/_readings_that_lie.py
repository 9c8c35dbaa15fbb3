"""Wrong answers to exercises of readings_that_lie, each with the sentence that it gets."""

import numpy as np

from kflearn import angle_difference


def corrected(x, P, reading, Q, R):
    """The step without a gate."""
    P = P + Q
    K = P / (P + R)
    return x + K * angle_difference(reading, x), (1 - K) * P


def far(x, P, reading, Q, R):
    """What the gate of 3σ says."""
    return angle_difference(reading, x) ** 2 > 9 * (P + Q + R)


def gate_afterwards(x, P, reading, Q, R):
    """The gate looks at what is left after the correction."""
    new, var = corrected(x, P, reading, Q, R)
    return (x, P + Q) if angle_difference(reading, new) ** 2 > 9 * (P + Q + R) else (new, var)


def otherwise(refused):
    """A gated step whose refusal leaves something else behind."""
    return lambda x, P, z, Q, R: refused(x, P, z, Q, R) if far(x, P, z, Q, R) else corrected(x, P, z, Q, R)


WRONG = {
    "is_refused": {
        "not wrapped": (
            lambda z, x, P, R, n: (z - x) ** 2 > n**2 * (P + R),
            "Across north yours goes the long way round: a reading of 3° is then 355° away from a prediction of 358°, and is refused.",
        ),
        "R only": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 > n**2 * R,
            "That is the answer of a gate made with R only. The prediction has an error too: the innovation's variance is S = P + R.",
        ),
        "P only": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 > n**2 * P,
            "That is the answer of a gate made with P only. The reading has an error too: the innovation's variance is S = P + R.",
        ),
        "sigmas not squared": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 > n * (P + R),
            "It answers as if the squared innovation were compared with sigmas times S. Squared on both sides it is sigmas² times S: 3σ are a NIS of 9.",
        ),
        "variance for σ": (
            lambda z, x, P, R, n: abs(angle_difference(z, x)) > n * (P + R),
            "You compare degrees with a variance, which is in square degrees: the standard deviation is √S.",
        ),
        "accepted": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 <= n**2 * (P + R),
            "You say which readings are accepted. The question is which are refused: True for those outside the gate.",
        ),
        "one side": (
            lambda z, x, P, R, n: angle_difference(z, x) > n * np.sqrt(P + R),
            "You refuse on one side only. A reading far to the left is just as wrong as one far to the right.",
        ),
        "σ added": (
            lambda z, x, P, R, n: abs(angle_difference(z, x)) > n * (np.sqrt(P) + np.sqrt(R)),
            "It answers like a gate of sigmas · (√P + √R). Of independent errors not the standard deviations add up, but the variances: √(P + R).",
        ),
        "always 3": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 > 9 * (P + R),
            "Your gate is 3σ wide, whatever `sigmas` is. How wide the gate is, is said by sigmas.",
        ),
    },
    "steps_shut": {
        "not rounded": (
            lambda a, P, Q, R: (a**2 / 9 - P - R) / Q,
            "The formula is right. A step is a whole number: the first one that is at least this large.",
        ),
        "rounded down": (
            lambda a, P, Q, R: np.floor((a**2 / 9 - P - R) / Q),
            "That is one step too early, when the gate is still a little too narrow. Round up; and step 1 has one Q in S already, so S = P + nQ + R in step n. Or did you count the refusals? The step after the last of them is wanted.",
        ),
        "3 for 9": (
            lambda a, P, Q, R: np.ceil((a**2 / 3 - P - R) / Q),
            "Squared, the limit of 3σ is 9 S, so it is away²/9.",
        ),
        "1σ": (
            lambda a, P, Q, R: np.ceil((a**2 - P - R) / Q),
            "That is when the speaker is within 1σ. The gate reaches to 3σ: away²/9.",
        ),
        "R forgotten": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 - P) / Q),
            "R is missing: the gate asks for S = P + nQ + R.",
        ),
        "P forgotten": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 - R) / Q),
            "P is missing: the gate is already wider than Q and R make it when the change comes.",
        ),
        "P and R forgotten": (
            lambda a, P, Q, R: np.ceil(a**2 / 9 / Q),
            "P and R are missing: the gate asks for S = P + nQ + R, and only the part nQ grows.",
        ),
        "σ grows by √Q": (
            lambda a, P, Q, R: np.ceil((a / 3 - np.sqrt(P + R)) / np.sqrt(Q)),
            "You let the standard deviation grow by √Q in each step. It is the variance that grows, by Q.",
        ),
        "one step late": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 - P - R) / Q) + 1,
            "One too many: in step 1 there is one Q in S already.",
        ),
    },
    "agreeing": {
        "not wrapped": (
            lambda old, z, w: np.sum(abs(old - z) <= w),
            "Across north yours goes the long way round: 358° and 1° agree within 3°.",
        ),
        "width in all": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) <= w / 2),
            "You count within half the width. Wanted is ± width, on both sides.",
        ),
        "one side": (
            lambda old, z, w: np.sum(angle_difference(old, z) <= w),
            "You look at one side only: those far to the left are counted as well. Take the absolute value.",
        ),
        "those that do not": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) > w),
            "You counted those that do not agree.",
        ),
        "share": (
            lambda old, z, w: np.mean(abs(angle_difference(old, z)) <= w),
            "That is their share. Wanted is their number: sum, not mean.",
        ),
        "which": (
            lambda old, z, w: abs(angle_difference(old, z)) <= w,
            "That says for each whether it agrees; now count the True.",
        ),
        "itself too": (
            lambda old, z, w: 1 + np.sum(abs(angle_difference(old, z)) <= w),
            "One too many: the new reading itself is not among the refused ones that are asked for, and a count begins at 0.",
        ),
        "all of them": (
            lambda old, z, w: len(old),
            "That is how many were refused. How many of them are near the new reading?",
        ),
    },
    "gated_step": {
        "no gate": (
            corrected,
            "No reading is refused in it: one beyond 3√S must leave the prediction as it is.",
        ),
        "afterwards": (
            gate_afterwards,
            "You correct first and then look at what is left of the innovation. The reading has pulled the estimate towards itself by then, and passes too easily: the gate comes before the correction.",
        ),
        "not predicted": (
            otherwise(lambda x, P, z, Q, R: (x, P)),
            "A refused reading takes nothing away from the prediction: the variance after the step is P + Q, not the old P.",
        ),
        "P shrinks": (
            otherwise(lambda x, P, z, Q, R: (x, corrected(x, P, z, Q, R)[1])),
            "The mean stays, as it should, but the variance shrinks as if the reading had been used. So the gate does not widen as it should while readings are refused.",
        ),
        "jumps": (
            otherwise(lambda x, P, z, Q, R: (x + angle_difference(z, x), R)),
            "You start again at a reading that is refused. This is what the filter does after several that agree; one reading far away leaves the prediction as it is.",
        ),
        "to the edge": (
            otherwise(
                lambda x, P, z, Q, R: (
                    x + np.sign(angle_difference(z, x)) * 3 * (P + Q) / np.sqrt(P + Q + R),
                    corrected(x, P, z, Q, R)[1],
                )
            ),
            "You use a refused reading as if it were at the edge of the gate. This is a robust correction (Huber's); a gate does not use the reading at all.",
        ),
        "not wrapped": (
            lambda x, P, z, Q, R: (x, P + Q) if (z - x) ** 2 > 9 * (P + Q + R) else corrected(x, P, z, Q, R),
            "Near north good readings are refused: the gate needs the short way round.",
        ),
        "Q forgotten in the gate": (
            lambda x, P, z, Q, R: (x, P + Q) if angle_difference(z, x) ** 2 > 9 * (P + R) else corrected(x, P, z, Q, R),
            "The gate uses the old P. The innovation's variance is S = P + Q + R: predict first.",
        ),
        "gate of R": (
            lambda x, P, z, Q, R: (x, P + Q) if angle_difference(z, x) ** 2 > 9 * R else corrected(x, P, z, Q, R),
            "The gate compares with R only. The innovation's variance is S = P + Q + R.",
        ),
        "limit 3": (
            lambda x, P, z, Q, R: (
                (x, P + Q) if angle_difference(z, x) ** 2 > 3 * (P + Q + R) else corrected(x, P, z, Q, R)
            ),
            "Your gate is √3 σ wide, as if a square were compared with 3: 3σ is a NIS of 9.",
        ),
    },
}
