"""Lesson 9, `gated_step`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._combined import combined
from kflearn.exercises._slips.readings_that_lie.shared import DISTANCES, ROUND, wide


def corrected(x, P, reading, Q, R):
    """The step without a gate."""
    P = P + Q
    K = P / (P + R)
    return x + K * angle_difference(reading, x), (1 - K) * P


def gate_afterwards(x, P, reading, Q, R):
    """The gate looks at what is left after the correction."""
    new, var = corrected(x, P, reading, Q, R)
    return (x, P + Q) if angle_difference(reading, new) ** 2 > 9 * (P + Q + R) else (new, var)


def far(x, P, reading, Q, R):
    """What the gate of 3σ says."""
    return angle_difference(reading, x) ** 2 > 9 * (P + Q + R)


def otherwise(refused):
    """A gated step whose refusal leaves something else behind."""
    return lambda x, P, z, Q, R: refused(x, P, z, Q, R) if far(x, P, z, Q, R) else corrected(x, P, z, Q, R)


def inverted(x, P, z, Q, R):
    """Corrected where it should be refused."""
    y, P = angle_difference(z, x), P + Q
    K = P / (P + R)
    return (x, P) if y**2 <= 9 * (P + R) else (x + K * y, (1 - K) * P)


def not_predicted(x, P, z, Q, R):
    """The gate is right, and the gain is that of the old P."""
    y, K = angle_difference(z, x), P / (P + R)
    return (x, P + Q) if y**2 > 9 * (P + Q + R) else (x + K * y, (1 - K) * P)


def step(width, variance, distance="short", corrected="short", refused="P", accepted="right", side="both"):
    """One step with a gate, in which something else is done."""

    def gated(x, P, z, Q, R):
        old, P = P, P + Q
        y, S = DISTANCES[distance](z, x), {"S": P + R, "old": old + R, "R": R, "P": P, "0.2": P + R + 0.2}[variance]
        K = P / (P + R)
        if (y if side == "one" else abs(y)) > width * np.sqrt(S):
            return {"P": (x, P), "old": (x, old), "S": (x, P + R), "reading": (z, P), "reading, R": (z, R),
                    "Q twice": (x, P + Q), "zero": (0.0, P), "reading, old": (z, old)}[refused]  # fmt: skip
        after = {"right": (1 - K) * P, "P": P, "old": (1 - K) * old, "K": K * P, "S": P + R}[accepted]
        return x + K * DISTANCES[corrected](z, x), after

    return gated


WRONG = (
    {
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
        "inverted": (
            inverted,
            "You correct with readings outside the gate and refuse those inside: turn the comparison round.",
        ),
        "old gain": (
            not_predicted,
            "The gate is right. But an accepted reading is used as if nothing had been predicted: P grows by Q before the gain is formed.",
        ),
        "variance for σ": (
            lambda x, P, z, Q, R: step(3 * np.sqrt(P + Q + R), "S")(x, P, z, Q, R),
            "You compare degrees with 3 S, which is in square degrees: the gate reaches to 3√S.",
        ),
        "nine": (
            step(9, "S"),
            "Your gate is 9σ wide. 3σ squared on both sides is y² > 9 S; not squared it is |y| > 3√S.",
        ),
        "without S": (
            lambda x, P, z, Q, R: (x, P + Q) if angle_difference(z, x) ** 2 > 9 else corrected(x, P, z, Q, R),
            "Your gate is 3 degrees wide. It is 3 standard deviations wide: y² > 9 S.",
        ),
        "only if": (
            lambda x, P, z, Q, R: (x, P + Q),
            "You refuse every reading. One inside the gate corrects x and P.",
        ),
    }
    | {f"{n} sigmas": (step(n, "S"), wide(n)) for n in (1, 2, 2.5, 4, 5, 6)}
    | combined(
        step,
        width={3: "", 4: wide(4), 2: wide(2), np.sqrt(3): "The limit of y²/S is 9, the square of 3."},
        variance={
            "S": "",
            "old": "The gate uses the old P: predict first, S = P + Q + R.",
            "R": "The gate compares with R only: S = P + Q + R.",
            "P": "The gate compares with P + Q only: R is missing in S.",
        },
        distance={"short": "", "plain": "The gate does not take the short way round.", "mod": ROUND},
        corrected={"short": "", "plain": "The correction does not take the short way round."},
        refused={
            "P": "",
            "old": "After a refused reading the variance is P + Q, not the old P.",
            "S": "After a refused reading the variance is P + Q; R does not come into it.",
            "Q twice": "After a refused reading Q is added twice.",
            "reading": "A refused reading is returned as the mean. It leaves the prediction as it is: x.",
            "reading, R": "After a refused reading you start again at it. One reading far away leaves the prediction as it is: x and P + Q.",
            "reading, old": "A refused reading is returned as the mean. It leaves the prediction as it is: x and P + Q.",
            "zero": "After a refused reading the mean stays x.",
        },
        accepted={
            "right": "",
            "P": "After an accepted reading the variance has to shrink by the factor 1 − K.",
            "old": "After an accepted reading the variance is (1 − K)(P + Q): you used the old P.",
            "K": "After an accepted reading 1 − K is left of the variance, not K.",
            "S": "After an accepted reading the variance has to shrink; you return S.",
        },
        side={"both": "", "one": "You refuse on one side only."},
    )
)
