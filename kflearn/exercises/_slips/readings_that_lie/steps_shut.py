"""Lesson 9, `steps_shut`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.readings_that_lie.shared import wide


def growing_faster(away, P, Q, R):
    """The first n at which P + (1 + 2 + … + n) Q + R is enough."""
    rest = (away**2 / 9 - P - R) / Q
    return np.ceil((np.sqrt(1 + 8 * rest) - 1) / 2)


def shut(results, rights):
    """What is said of the same step in all trials, later than all that are right."""
    if np.ptp(results) or not results[0] > rights.max():
        return None
    return (
        f"Your result is {results[0]:.6g} in every trial: a number that is typed in, or the end of a loop in which the gate never "
        "opens. A refused reading does not make P smaller: P grows by Q in each step, and S with it."
    )


WRONG = (
    {
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
    | {f"{n} sigmas": (lambda a, P, Q, R, n=n: np.ceil((a**2 / n**2 - P - R) / Q), wide(n)) for n in (2, 4, 5, 6)}
    | {
        f"{n} steps off": (
            lambda a, P, Q, R, n=n: np.ceil((a**2 / 9 - P - R) / Q) + n,
            f"That is {abs(n)} {'step' if abs(n) == 1 else 'steps'} too {'late' if n > 0 else 'early'}: in step 1 there is one Q in S, in step n there are n.",
        )
        for n in (-2, 2)
    }
    | {
        "1 + 2 + 3": (
            growing_faster,
            "It answers as if P grew by Q, then by 2Q, then by 3Q. Each step adds Q alone: after n steps that is nQ.",
        ),
        "the width grows by 3√Q": (
            lambda a, P, Q, R: 1 + max(np.ceil((a - 3 * np.sqrt(P + Q + R)) / (3 * np.sqrt(Q))), 0),
            "Yours widens by 3√Q in each step. Standard deviations do not add: S grows by Q, and the width is 3√S.",
        ),
    }
)
