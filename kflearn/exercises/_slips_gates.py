"""Wrong answers to exercises of lesson 9 that a second stranger tried, and more of their kind."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._combined import combined

FAR = "Across north yours goes the long way round: a reading of 3° is then 355° away from a prediction of 358°."
ROUND = "As with `% 360`, a small step to the left is nearly a whole turn: −3° is 357°. The short way is between −180 and 180."
DISTANCES = {"short": angle_difference, "plain": np.subtract, "mod": lambda z, x: np.subtract(z, x) % 360}


def gate(distance, variance, limit):
    """Whether a reading is refused."""

    def refused(z, x, P, R, n):
        y = DISTANCES[distance](z, x)
        S = {"S": P + R, "R": R, "P": P, "squares": P**2 + R**2, "product": P * R}[variance]
        return bool(y**2 > {"n²": n**2 * S, "n": n * S, "S": n**2 * S**2, "half": n**2 * S / 4, "twice": 4 * n**2 * S,
                            "3": 9 * S, "1": S, "n S": n * np.sqrt(S)}[limit])  # fmt: skip

    return refused


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


def inverted(x, P, z, Q, R):
    """Corrected where it should be refused."""
    y, P = angle_difference(z, x), P + Q
    K = P / (P + R)
    return (x, P) if y**2 <= 9 * (P + R) else (x + K * y, (1 - K) * P)


def not_predicted(x, P, z, Q, R):
    """The gate is right, and the gain is that of the old P."""
    y, K = angle_difference(z, x), P / (P + R)
    return (x, P + Q) if y**2 > 9 * (P + Q + R) else (x + K * y, (1 - K) * P)


def wide(sigmas):
    return f"Your gate is {sigmas}σ wide; 3σ is wanted."


WRONG = {
    "is_refused": {
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
    ),
    "steps_shut": {
        "not squared": (
            lambda a, P, Q, R: max(1, np.ceil((a / 3 - P - R) / Q)),
            "You compare degrees with variances: away/3 is a standard deviation, √S. Square it.",
        ),
        "not squared, below 1": (
            lambda a, P, Q, R: np.ceil((a / 3 - P - R) / Q),
            "You compare degrees with variances: away/3 is a standard deviation, √S. Square it.",
        ),
        "away itself": (
            lambda a, P, Q, R: np.ceil((a - P - R) / Q),
            "You compare degrees with variances. The gate reaches to 3√S: what is S, when that is `away`?",
        ),
        "multiplied": (
            lambda a, P, Q, R: np.ceil((9 * a**2 - P - R) / Q),
            "You multiplied by 9. 3√S = away gives S = away²/9.",
        ),
        "as R": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 - P - R) / R),
            "In each step P grows by Q, and you divided by R.",
        ),
        "in seconds": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 - P - R) / Q) / 10,
            "That is in seconds. The number of the step is wanted.",
        ),
        "nearest": (
            lambda a, P, Q, R: np.round((a**2 / 9 - P - R) / Q),
            "You round to the nearest step. If that is the one below, the gate is still too narrow: round up.",
        ),
        "added": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 + P + R) / Q),
            "The signs of P and R: they are in S = P + nQ + R, so less is left for nQ to grow.",
        ),
        "R subtracted": (
            lambda a, P, Q, R: np.ceil((a**2 / 9 - P + R) / Q),
            "The sign of R: S = P + nQ + R, so R is taken from away²/9, as P is.",
        ),
        "bracket": (
            lambda a, P, Q, R: np.ceil(a**2 / 9 - P - R / Q),
            "Brackets are missing: all of away²/9 − P − R is divided by Q.",
        ),
        "always": (lambda a, P, Q, R: np.inf, "The gate does open: P grows by Q in each step, and S with it."),
    }
    | {
        f"{n} sigmas": (lambda a, P, Q, R, n=n: np.ceil((a**2 / n**2 - P - R) / Q), wide(n)) for n in (2, 4, 5, 6)
    }
    | {
        f"{n} steps off": (
            lambda a, P, Q, R, n=n: np.ceil((a**2 / 9 - P - R) / Q) + n,
            f"That is {abs(n)} {'step' if abs(n) == 1 else 'steps'} too {'late' if n > 0 else 'early'}: in step 1 there is one Q in S, in step n there are n.",
        )
        for n in (-2, 2)
    },
    "agreeing": {
        "8 degrees": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) <= 8),
            "You count within about 8°, whatever `width` is.",
        ),
        "modulo": (
            lambda old, z, w: np.sum((old - z) % 360 <= w),
            "Only readings on one side are counted, as with `% 360`, which makes 357° of 3° to the left. Count both sides.",
        ),
        "one side, not wrapped": (
            lambda old, z, w: np.sum(old - z <= w),
            "You look at one side only, and subtract without the short way round.",
        ),
        "other side": (
            lambda old, z, w: np.sum(angle_difference(old, z) >= -w),
            "You look at one side only: those far to the right are counted as well. Take the absolute value.",
        ),
        "the readings": (
            lambda old, z, w: np.asarray(old)[abs(angle_difference(old, z)) <= w],
            "Those are the readings that agree. Wanted is how many there are.",
        ),
        "one at least": (
            lambda old, z, w: bool(np.any(abs(angle_difference(old, z)) <= w)),
            "That says whether there is one at least. Wanted is how many there are.",
        ),
        "three at least": (
            lambda old, z, w: bool(np.sum(abs(angle_difference(old, z)) <= w) >= 3),
            "That says whether there are three at least. Wanted is how many there are.",
        ),
        "squares": (
            lambda old, z, w: np.sum(angle_difference(old, z) ** 2 <= w),
            "It counts as if the squared difference were compared with the width itself.",
        ),
        "their mean": (
            lambda old, z, w: int(abs(angle_difference(np.mean(old), z)) <= w),
            "That is 1 or 0, as for the mean of all. Compare each refused reading with the new one, and count.",
        ),
        "among themselves": (
            lambda old, z, w: np.sum(abs(angle_difference(old, old[0])) <= w),
            "That is how many agree with the first refused reading. Compare each with the new one.",
        ),
        "neighbours alone": (
            lambda old, z, w: np.sum(abs(angle_difference(np.diff(old), 0)) <= w),
            "You compare each refused reading with the one before it. Compare each of them with the new one.",
        ),
    }
    | {
        f"last {n}": (
            lambda old, z, w, n=n: np.sum(abs(angle_difference(np.asarray(old)[-n:], z)) <= w),
            f"You look at the last {n} only. All of the refused readings count.",
        )
        for n in (3, 4, 5, 6)
    },
    "gated_step": {
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
        "nine": (step(9, "S"), "Your gate is 9σ wide. 3σ squared on both sides is y² > 9 S; not squared it is |y| > 3√S."),
        "only if": (
            lambda x, P, z, Q, R: (x, P + Q),
            "You refuse every reading. One inside the gate corrects x and P.",
        ),
    }
    | {
        f"{n} sigmas": (step(n, "S"), wide(n)) for n in (1, 2, 2.5, 4, 5, 6)
    }
    | combined(
        step,
        width={3: "", 4: wide(4), 2: wide(2), 5: wide(5), np.sqrt(3): "The limit of y²/S is 9, the square of 3."},
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
    ),
}  # fmt: skip
