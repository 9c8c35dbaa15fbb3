"""Lesson 9, `is_refused`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._combined import combined
from kflearn.exercises._slips.readings_that_lie.shared import DISTANCES, ROUND

FAR = "Across north yours goes the long way round: a reading of 3° is then 355° away from a prediction of 358°."


def gate(distance, variance, limit):
    """Whether a reading is refused."""

    def refused(z, x, P, R, n):
        y = DISTANCES[distance](z, x)
        S = {"S": P + R, "R": R, "P": P, "squares": P**2 + R**2, "product": P * R}[variance]
        return bool(y**2 > {"n²": n**2 * S, "n": n * S, "S": n**2 * S**2, "half": n**2 * S / 4, "twice": 4 * n**2 * S,
                            "3": 9 * S, "1": S, "n S": n * np.sqrt(S)}[limit])  # fmt: skip

    return refused


WRONG = (
    {
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
        "half turns": (
            lambda z, x, P, R, n: abs((z - x + 90) % 180 - 90) > n * np.sqrt(P + R),
            "A reading from behind, 180° away, passes as if it were near: take whole turns off, not half ones.",
        ),
        "the NIS": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 / (P + R),
            "You return the NIS. Compare it with the limit, sigmas², and return True or False.",
        ),
        "in sigmas": (
            lambda z, x, P, R, n: abs(angle_difference(z, x)) / np.sqrt(P + R),
            "You return how many standard deviations the reading is away. Compare that with sigmas, and return True or False.",
        ),
        "the innovation": (
            lambda z, x, P, R, n: angle_difference(z, x),
            "You return the innovation. How many √S is that, and is it more than sigmas?",
        ),
        "the other side": (
            lambda z, x, P, R, n: angle_difference(z, x) < -n * np.sqrt(P + R),
            "You refuse on one side only. A reading far to the right is just as wrong as one far to the left.",
        ),
        "Q": (
            lambda z, x, P, R, n: angle_difference(z, x) ** 2 > n**2 * (P + R + 0.2),
            "Your S is a little more than P + R, as if a Q had been added. P is the variance of the prediction here: Q is in it already.",
        ),
        "always": (lambda z, x, P, R, n: True, "You refuse every reading."),
        "never": (lambda z, x, P, R, n: False, "You refuse no reading."),
        "degrees for σ": (
            lambda z, x, P, R, n: abs(angle_difference(z, x)) > n,
            "You compare degrees with a number of standard deviations: how many degrees is one, √S?",
        ),
    }
    | combined(
        gate,
        distance={"short": "", "plain": FAR, "mod": ROUND},
        variance={
            "S": "",
            "R": "It answers like a gate of R only. The prediction has an error too: S = P + R.",
            "P": "It answers like a gate of P only. The reading has an error too: S = P + R.",
            "squares": "It answers as if P and R were squared. They are variances already: S = P + R.",
            "product": "It answers as if S were P · R. Variances of independent errors add up: S = P + R.",
        },
        limit={
            "n²": "",
            "n": "It answers as if the innovation were squared, and sigmas not.",
            "S": "You compare degrees with a variance, which is in square degrees: the standard deviation is √S.",
            "half": "Your gate is half as wide as it should be: ± sigmas standard deviations, on each side.",
            "twice": "Your gate is twice as wide as it should be: ± sigmas standard deviations, on each side.",
            "3": "Your gate is 3σ wide, whatever `sigmas` is.",
            "1": "Your gate is one standard deviation wide. How wide it is, is said by sigmas.",
            "n S": "You compare a square with a width in degrees: square both sides, or none.",
        },
    )
    | {
        "after the correction": (
            lambda z, x, P, R, sigmas: abs(angle_difference(z, x)) * R / (P + R) > sigmas * np.sqrt(P + R),
            "It answers as if only the part R/(P + R) of the innovation were compared, what is left of it after a "
            "correction. The gate stands before the correction: compare the whole innovation.",
        ),
    }
)
