"""Lesson 10, `room_filter`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._combined import combined
from kflearn.exercises._slips.temperature_and_free_fall.shared import loop, started


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


def old_gain(z, Q, R):
    x, P = z[0], R
    for reading in z[1:]:
        K = P / (P + R)
        x, P = x + K * (reading - x), (1 - K) * (P + Q)
    return x, P


def filtered(z, Q, R, x, P, shrinks=True):
    """The room's filter from a start (x, P) over z[1:]; or one whose P shrinks at the end only."""
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x, P = x + K * (reading - x), P * (1 - K) if shrinks else P
    return x, P if shrinks else (1 - K) * P


def start_of(result, case):
    """The estimate and the variance from which the room's filter comes to a result."""
    (x, P), (z, Q, R) = result, case
    for reading in z[:0:-1]:
        K = P / R
        x, P = (x - K * reading) / (1 - K), P / (1 - K) - Q
    return x, P


def of_a_start(results, cases):
    """What is said of a filter of the room that is right, but for a start that is the same in all trials."""
    short = [(result, case) for result, case in zip(results, cases, strict=True) if len(case[0]) < 5]
    with np.errstate(all="ignore"):
        x, P = np.array([start_of(*pair) for pair in short]).T
    first = np.array([case[0][0] for _, case in short])
    typed = [np.isfinite(part).all() and np.ptp(part) < 1e-6 * (1 + abs(part[0])) for part in (x, P)]
    if typed[0]:
        with_P = f", with P = {P[0]:.4g}" if typed[1] else ""
        return f"Your filter starts at {x[0]:.4g} °C{with_P}, whatever z is. The first reading is the start: x = z[0], P = R."
    if typed[1] and np.allclose(x, first):
        return f"You start with P = {P[0]:.4g}, whatever R is. A single reading has the variance R."
    return None


WRONG = (
    {
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
        "the mean": (
            lambda z, Q, R: (np.mean(z), np.var(z)),
            "Those are the mean of the readings and their variance. A filter weighs the newest most.",
        ),
        "last reading": (
            lambda z, Q, R: (z[-1], R),
            "That is the last reading alone. The readings before it tell something too.",
        ),
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
        lambda x, P, readings, gain: started(
            x,
            {
                "R": lambda Q, R: R,
                "R²": lambda Q, R: R * R,
                "√R": lambda Q, R: R**0.5,
                "Q": lambda Q, R: Q,
                "Q + R": lambda Q, R: Q + R,
                "2R": lambda Q, R: 2 * R,
                "R/2": lambda Q, R: R / 2,
            }.get(P, lambda Q, R: P),
            readings,
            gain,
        ),
        x={
            "z0": "",
            "0": "You start at 0 °C. The first reading is the start: x = z[0].",
            "mean": "You start at the mean of all readings. Start at the first, z[0].",
            "last": "You start at the last reading. Start at the first, z[0].",
        },
        P={
            "R": "",
            "R²": "You start with R². R is a variance already: a single reading has the variance R.",
            "√R": "You start with √R. P is a variance: R.",
            "Q": "You start with Q, as published. A single reading has the variance R.",
            "Q + R": "You start with Q + R. When the first reading is made, nothing has moved yet.",
            "2R": "You start with 2R. A single reading has the variance R.",
            "R/2": "You start with R/2. A single reading has the variance R.",
            0: "You start with P = 0, as if the first reading were exact.",
        }
        | {
            number: f"You start with P = {number:g}, whatever R is. A single reading has the variance R."
            for number in (0.01, 0.1, 0.25, 1.0, 10.0, 100.0, 500.0, 1000.0, 1e4)
        },
        readings={
            "rest": "",
            "all": "The first reading is used in the loop as well. It is used up by the start: begin the loop at z[1].",
            "two": "The second reading is left out: the loop begins at z[1].",
        },
        gain={
            "R": "",
            "Q": "Below the line of the gain stands P + R; you have P + Q.",
            "σ": "The gain is made of variances, not of standard deviations.",
        },
    )
    | {
        "Q after the gain": (
            old_gain,
            "Your gain uses the P before Q is added. Add Q first; then form K, and multiply P by 1 − K.",
        ),
        "mean, R over n": (
            lambda z, Q, R: filtered(z, Q, R, np.mean(z), R / len(z)),
            "It answers as if the start were the mean of the whole series, with R over the number of readings. "
            "All but the first are still to come, and would count twice. Start at the first one alone.",
        ),
        "shrinks at the end": (
            lambda z, Q, R: filtered(z, Q, R, z[0], R, shrinks=False),
            "It answers as if P were multiplied by 1 − K at the end only, and grew all the time before. It shrinks "
            "after each correction, inside the loop.",
        ),
    }
)
