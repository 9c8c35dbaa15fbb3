"""Lesson 8: the bearing of a sound."""

import numpy as np

from kflearn.exercises._hints import tried
from kflearn.exercises._slips import bearing_of_a_sound as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import exercise


def mended_prediction(P, dt, q):
    """What the published two-state filter does to P in a prediction, mended."""
    F = np.array([[1, dt], [0, 1]])
    return F @ P @ F.T + q * np.eye(2)


def mended_update(P, K):
    """What it does to P in a correction, mended; H = [1, 0]."""
    return P - np.outer(K, P[0])


def repairs(prediction, update):
    """The four programs of the lesson's bug hunt: as published, one half mended, the other half, both."""
    return [(first, second) for first in (prediction, mended_prediction) for second in (update, mended_update)]


def differences(rng):
    """A difference of two bearings, one of which may have gone round many times; never half a turn."""
    return (float(rng.integers(-1440, 1440) * rng.choice([1, 25])) + 0.5,)


@exercise(
    hints=[
        "The remainder `% 360` puts every angle between 0 and 360. You want −180 to 180: the same width, moved by half a turn.",
        "Move the difference up by half a turn, take the remainder, move back down.",
        tried(
            (331,),
            "wrap(331)",
            "Work it out by hand: from 8° to 339° it is 29° to the left, which is −29.",
            "Work out one case by hand: 339 − 8 is 331, and from 8° to 339° it is 29° to the left, −29.",
        ),
        "In one line: `return (difference + 180) % 360 - 180`.",
    ],
    inputs=differences,
    rtol=1e-9,
    atol=1e-9,
    wrong=slips.wrap.WRONG,
    then="Half a turn is the one difference with two right answers: 180 and −180 are equally far.",
)
def wrap(difference):
    """The same difference of two bearings (degrees), written between −180 and 180."""
    return (difference + 180) % 360 - 180


def stuck_rates(rng):
    """A rate that never changes, a gain, a time step."""
    return (
        float(rng.integers(1, 60) * rng.choice([-1, 1])),
        float(rng.integers(1, 10) / 10),
        float(rng.integers(1, 11) / 10),
    )


@exercise(
    hints=[
        "At rest the offset is the same after every step. What does one step add to it, and what does the correction leave of it?",
        tried(
            (10, 0.5, 1),
            "offset(10, 0.5, 1)",
            "By hand: each step adds 10 and leaves one half, so after the steps it is 5, 7.5, 8.75 … Where does that end?",
            "Take x₁ = 10, K = 0.5, dt = 1: each step adds 10 and leaves one half: 5, 7.5, 8.75 … Where does that end?",
        ),
        "Prediction: offset + dt·x₁. Correction: the part 1 − K of that is left. At rest this is the offset itself.",
        "offset = (1 − K)(offset + dt·x₁). Bring the offset to one side: offset·K = (1 − K)·dt·x₁.",
    ],
    inputs=stuck_rates,
    wrong=slips.offset.WRONG,
    then="For the golden gain 0.618 the factor (1 − K)/K is 0.618 as well. What does the offset become when K nears 1?",
)
def offset(x1, K, dt):
    """Where a filter with gain K for the angle and none for the rate rests, above the truth, when its rate is stuck at x1."""
    return dt * x1 * (1 - K) / K


def beliefs(rng):
    """A P of angle and rate, half of them not symmetric (as the published ones), a Q with corners, and a time step."""
    root, jolts = rng.integers(1, 5, (2, 2)) / 2, rng.integers(1, 5, (2, 2)) / 4
    P, dt = root @ root.T + np.eye(2), float(rng.integers(1, 11) / 10)
    P[1, 0] += rng.integers(1, 9) / 4 * (rng.random() < 0.5)
    return P, jolts @ jolts.T, dt


@exercise(
    hints=[
        "The error of the state moves as the state does: e becomes F e. Its covariance is the mean of (F e)(F e)ᵀ.",
        "F stands once on the left and once, transposed, on the right; then Q is added. Build F = [[1, dt], [0, 1]] first.",
        "In one line: `return F @ P @ F.T + Q`.",
    ],
    inputs=beliefs,
    wrong=slips.right_prediction.WRONG,
    then="From a symmetric P comes a symmetric one. The published prediction fails this test, which takes one line.",
    fixed={
        "P": "the state is an angle and its rate, so it is always two by two",
        "Q": "the state is an angle and its rate, so it is always two by two",
    },
)
def right_prediction(P, Q, dt):
    """The covariance of angle and rate one step of dt later. Q has corners too; P (2, 2) need not be symmetric."""
    F = np.array([[1, dt], [0, 1]])
    return F @ P @ F.T + Q


def gains(rng):
    """A matrix that need not be symmetric (the published prediction makes such), and any gain, not the best one."""
    root = rng.integers(1, 5, (2, 2)) / 2
    P = root @ root.T + np.eye(2)
    P[1, 0] += rng.integers(1, 9) / 4
    return P, rng.integers(1, 8, 2) / 8


@exercise(
    hints=[
        "K H is a matrix: the column K times the row [1, 0]. Write down which of its entries are zero.",
        "K H = [[K₀, 0], [K₁, 0]]. Subtract from the identity, and multiply with @, not with *.",
        "In one line: `return (np.eye(2) - np.outer(K, [1, 0])) @ P`.",
    ],
    inputs=gains,
    wrong=slips.right_update.WRONG,
    then="With any gain but the best one this is not the covariance of the error: that takes Joseph's form, in lesson 12.",
    fixed={
        "P": "the state is an angle and its rate, so it is always two by two",
        "K": "a state of angle and rate has two gains",
    },
)
def right_update(P, K):
    """(I − KH)P for H = [1, 0] and any gain K of two numbers; P (2, 2) need not be symmetric."""
    return (np.eye(2) - np.outer(K, [1, 0])) @ P


KINDS = [
    "covariance",
    "rounded",
    "known",
    "not symmetric",
    "beyond 1",
    "all beyond 1",
    "contradiction",
    "negative",
    "zero",
    "both",
]


def candidates(rng, n, kind):
    """A covariance of n states, or a matrix that cannot be one: KINDS[kind]."""
    root, sign, kind = rng.integers(-4, 5, (n, n)) / 2, rng.choice([-1, 1]), KINDS[kind]
    root = abs(root) + 0.5 if kind in ("rounded", "not symmetric") else root
    P = root @ root.T + np.eye(n)
    if kind == "rounded":
        P[n - 1, 0] += 4e-10 * sign
    if kind == "known":  # one state exactly: its variance is zero
        P = np.diag(rng.permutation(np.arange(n)) / 2)
    if kind == "not symmetric":
        P[n - 1, 0] += sign / 8
    if kind == "beyond 1":  # a correlation
        P[n - 1, 0] = P[0, n - 1] = sign * (P[0, 0] + P[n - 1, n - 1])
    if kind == "all beyond 1":
        P = np.full((n, n), 2.0) - np.eye(n) * rng.choice([0.5, 1])
    if kind == "contradiction":  # three that cannot all be alike and opposite; of two a negative variance
        P = np.array([[1, 0.9, 0.9], [0.9, 1, -0.9], [0.9, -0.9, 1]]) * 2 if n == 3 else np.diag([-1.0, 2.0])
    if kind in ("negative", "both"):
        P[[0, n - 1], [0, n - 1]] *= -1
    if kind == "both":  # nor symmetric
        P[n - 1, 0] += 1.5
    if kind == "zero":  # beside a negative variance
        P = np.diag([0.0, -1.0, 2.0][:n])
    return (P,)


TURNS = [
    (2, 0),
    (3, 0),
    (2, 2),
    (3, 3),
    (2, 4),
    (3, 4),
    (3, 1),
    (2, 3),
    (3, 5),
    (3, 6),
    (2, 7),
    (3, 2),
    (3, 8),
    (2, 1),
    (3, 7),
    (2, 9),
    (3, 9),
]


@exercise(
    hints=[
        "There are two questions. Is P equal to its transpose? And is vᵀPv, the variance of a combination v of the states, "
        "never negative?",
        "For a symmetric matrix vᵀPv is smallest along an eigenvector, and there it is the smallest eigenvalue.",
        "`np.allclose(P, P.T)` answers the first question, `np.linalg.eigvalsh(P).min() >= -1e-9` the second. Both must be True.",
    ],
    inputs=in_turn(candidates, *TURNS),
    wrong=slips.is_a_covariance.WRONG,
    then="From P = [[1, 0.2], [0.2, 0.5]] the published prediction makes a matrix that fails this test in one line, and so does the "
    "published update. A test like this one runs in a filter at every step.",
)
def is_a_covariance(P):
    """Can this matrix be a covariance: symmetric, and without a combination of states of negative variance?"""
    return np.allclose(P, P.T) and np.linalg.eigvalsh(P).min() >= -1e-9
