"""Lesson 9: readings that lie."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._hints import tried
from kflearn.exercises._judge import series
from kflearn.exercises._slips import readings_that_lie as slips
from kflearn.exercises._speaker import (
    FAILING,
    PASSING,
    averages_raw,
    of_one,
    of_two,
    off,
    outvoted,
    recording,
    sorts_raw,
    turned,
)
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import Mark, exercise, judged

SHARES = [0.6, 1.5, 0.9, 2.5, 0.3, 1.03, 0.45, 1.1, 0.97, 3.5, 0.2, 1.25, 0.75, 9.0, 0.55, 1.03, 0.4, 0.65, 0.25, 0.85]


def readings(rng, trial):
    """A reading so many times as far away as the gate is wide, on either side; often across north."""
    x, side = [(1.0, -1), (359.0, 1), (float(rng.choice([5, 90, 178])), int(rng.choice([-1, 1])))][trial % 3]
    sigmas = float(rng.integers(2, 5))
    P, R = rng.choice([rng.integers(1, 4) / 4, rng.integers(2, 9), rng.integers(10, 40)], 2).tolist()
    if abs(SHARES[trial] - 1) < 0.05:  # close to the limit, with a small S
        P, R = (rng.integers(4, 12, 2) / 8).tolist()
    P, R = {11: (20.0, 18.0)}.get(trial, (P, R))
    away = SHARES[trial] * side * sigmas * np.sqrt(P + R)
    return float(np.round((x + away) % 360, 2)), x, P, R, sigmas


@exercise(
    hints=[
        "Three steps: the innovation, the short way round; its standard deviation √S; how many of these it is away.",
        tried(
            (10.0, 355.0, 9.0, 16.0, 2.0),
            "is_refused(10, 355, 9, 16, 2)",
            "By hand: from 355° to 10° it is 15°, and √S = √(9 + 16) = 5. That is three standard deviations, and two are allowed: True.",
            "By hand: the reading is 10° and the prediction 355°, so y is 15°. P = 9, R = 16, so √S = 5. That is three standard deviations.",
        ),
        "`return angle_difference(reading, x) ** 2 > sigmas**2 * (P + R)`",
    ],
    inputs=in_turn(readings, *range(len(SHARES))),
    wrong=slips.is_refused.WRONG,
    then="Square both sides: the left one over S is the NIS, and 3σ is a limit of 9. An honest filter refuses 0.3 % of its good readings there.",
)
def is_refused(reading, x, P, R, sigmas):
    """Does a gate refuse this reading (degrees)? x, P: the prediction and its variance; R: of the reading; sigmas: the gate."""
    return angle_difference(reading, x) ** 2 > sigmas**2 * (P + R)


def openings(rng):
    """How far away a new speaker is, and the variances of a filter that refuses its readings."""
    P, Q, R = float(rng.integers(1, 9)), float(rng.integers(1, 9) / 4), float(rng.integers(2, 12))
    n = rng.integers(3, 400)
    return float(np.round(3 * np.sqrt(P + R + (n - rng.choice([0.2, 0.4, 0.6, 0.8])) * Q), 3)), P, Q, R


@exercise(
    hints=[
        "While nothing is accepted, P grows by Q in each step. In which step is the new speaker inside 3√S for the first time?",
        "In step n the gate reaches to 3√(P + nQ + R). Set this equal to the distance, and solve for n.",
        "n = (away²/9 − P − R)/Q, rounded up to a whole number: `np.ceil`.",
    ],
    inputs=openings,
    rtol=1e-9,
    wrong=slips.steps_shut.WRONG,
    otherwise=slips.steps_shut.shut,
    then="With the lesson's Q = 0.2 and R = 2, this gate of 3σ lets in a speaker who is 90° away after about 4490 steps, seven and a half minutes. To reach twice as far takes four times as long.",
)
def steps_shut(away, P, Q, R):
    """In which step after the change does a gate of 3σ let the new speaker in, who is `away` degrees from the estimate?

    P: the variance after the last accepted reading. In step 1 the gate has S = P + Q + R.
    """
    return np.ceil((away**2 / 9 - P - R) / Q)


def refusals(rng, n):
    """Refused readings that cluster at two places, one of them near north, a new reading and a width.

    None is on its edge; for n = 0 two of three are. For n = 8 one comes from behind; for n = 5
    all are in the south.
    """
    if n == 0:
        return np.array([358.0, 2.0, 40.0]), 0.0, 2.0
    places = rng.choice([2.0, 357.0, 40.0], n) + rng.choice([-9, -6.5, -3, 0, 3, 6.5, 9], n)
    places[0] += 180 * (n == 8)
    south = 180 * (n == 5)
    reading = (rng.choice([1, 358, 41]) + south) % 360
    return np.mod(places + south, 360), float(reading), float(rng.choice([5.25, 8.25, 11.25]))


@exercise(
    hints=[
        "How far is each of the refused readings from the new one, the short way round? Then count.",
        "`angle_difference` takes whole arrays, and `np.sum` of an array of True and False counts the True.",
        "`return np.sum(abs(angle_difference(refused, reading)) <= width)`",
    ],
    inputs=in_turn(refusals, 2, 5, 3, 8, 0),
    wrong=slips.agreeing.WRONG,
    then="Three such readings of the last five are a reason to start again there; three that contradict one another are not.",
)
def agreeing(refused, reading, width):
    """How many of the refused readings are within ± width of this one (all in degrees)?"""
    return np.sum(abs(angle_difference(refused, reading)) <= width)


GATES = [0.5, 11.8, 0.9, 2.5, 0.2, 0.62, 1.6, 0.97, 1.03, 0.7, 4.0, 0.35, 1.4, 0.6, 3.5, 0.8, 1.1, 0.25, 1.9, 1.25]


def steps(rng, trial):
    """A belief, a reading inside the gate of 3σ, outside it, or outside only before the correction."""
    x = float(rng.choice([4, 178, 356]))
    P, Q, R = float(rng.integers(1, 25)), float(rng.integers(2, 14)), float(rng.integers(2, 40))
    # what is left after a correction is much, or little; in trial 4 the reading is less than 3° away
    P, R = {4: (4.0, 6.0), 10: (1.0, 2.0), 12: (2.0, 40.0), 14: (24.0, 4.0)}.get(trial, (P, R))
    away = 3 * GATES[trial] * rng.choice([-1, 1]) * np.sqrt(P + Q + R)
    return x, P, float(np.round((x + away) % 360, 1)), Q, R


def whole_turns_off(x, P, reading, Q, R):
    """The same step, with the mean brought back to 0 … 360."""
    y, S = angle_difference(reading, x), P + Q + R
    K = 0.0 if y**2 > 9 * S else (P + Q) / S
    return (x + K * y) % 360, (1 - K) * (P + Q)


@exercise(
    hints=[
        "The prediction comes first, whatever the reading is: x stays and P grows by Q. Then the gate decides whether there is a correction.",
        "A refused reading leaves the prediction as it is: x and P + Q. An accepted one corrects both.",
        "`S = P + Q + R`, `y = angle_difference(reading, x)`; if `y**2 > 9 * S`: `return x, P + Q`. "
        "Else K = (P + Q)/S, and `return x + K * y, (1 - K) * (P + Q)`.",
    ],
    inputs=in_turn(steps, *range(len(GATES))),
    wrong=slips.gated_step.WRONG,
    also=[whole_turns_off],
    then="The gate stands between prediction and correction, where the innovation and its S are those of this reading.",
)
def gated_step(x, P, reading, Q, R):
    """One step of a random walk with a gate of 3σ: the mean (degrees) and the variance after it. x, P: after the step before."""
    P = P + Q
    y, S = angle_difference(reading, x), P + R
    K = 0.0 if y**2 > 9 * S else P / S
    return x + K * y, (1 - K) * P


@judged(
    hints=[
        "An echo lasts up to 14 readings, and then the speaker is back. How many readings in a row must a gate refuse, before it gives in?",
        "The first reading may be an echo. What does the middle value of the first fifteen say?",
        "Take the lesson's `gate_only` with Q = 0.5, R = 9 and a gate of 3, start again at the 15th refusal in a row, and begin at the median of the first fifteen "
        "readings, taken the short way round: `z[0] + np.median(angle_difference(z[:15], z[0]))`.",
    ],
    recording=recording,
    marks=[
        Mark(
            "error with one speaker (rms, the short way round)",
            off(False),
            high=3,
            above=of_one,
            unit="°",
        ),
        Mark(
            "error with two speakers (the 30 readings after the change do not count)",
            off(True),
            high=3,
            above=of_two,
            unit="°",
        ),
    ],
    signs=[sorts_raw, averages_raw, outvoted, turned],
    form=series,
    passing=PASSING,
    failing=FAILING,
    then="A filter that goes by how long an echo lasts finds a new speaker with his 15th reading at best. A design that looks at later readings, as a smoother does (lesson 23), is not late.",
)
def speaker(z):
    """Write a filter `(z) → bearings` that follows a speaker among echoes, to 3° and better.

    z (325,): bearings in whole degrees, 0 to 359, ten a second. The speaker walks by 0.15° a reading, past north.
    Echoes last up to 14 readings, are more than 10° off and can be there from the first reading. In about half of
    the recordings somebody else, elsewhere, takes over, once. Return the bearings (325,) in degrees; whole turns more or
    less do not matter.
    """
    x = z[0] + np.median(angle_difference(z[:15], z[0]))
    P, R, Q, refused, found = 9.0, 9.0, 0.5, 0, []
    for reading in z:
        P, innovation = P + Q, angle_difference(reading, x)
        far = innovation**2 > 9 * (P + R)
        refused = refused + 1 if far else 0
        K = 1 if refused > 14 else 0 if far else P / (P + R)
        x, P = x + K * innovation, (1 - K) ** 2 * P + K**2 * R
        found.append(x)
    return np.array(found)
