"""Wrong answers to exercises of lesson 8 that a second stranger tried, and more of their kind."""

import math

import numpy as np

from kflearn.exercises._combined import combined


def mended_entries(upper_left, upper_right, lower_left, q):
    """A prediction written entry by entry, some of them not mended."""

    def predict(P, Q, dt):
        a = P[0, 0] + dt * P[1, 0] + (upper_left > 0) * dt * P[0, 1] + (upper_left > 1) * dt**2 * P[1, 1]
        b = {"dt": P[0, 1] + dt * P[1, 1], "1": P[0, 1] + P[1, 1], "none": P[0, 1]}[upper_right]
        c = {"dt": P[1, 0] + dt * P[1, 1], "published": dt * P[1, 0], "none": P[1, 0]}[lower_left]
        return np.array([[a, b], [c, P[1, 1]]]) + {"Q": Q, "first": Q[0, 0] * np.eye(2), "diag": np.diag(np.diag(Q))}[q]

    return predict


def summed(steps):
    """The offset after so many steps."""
    return lambda x1, K, dt: dt * x1 * sum((1 - K) ** j for j in range(1, steps + 1))


def stepping_down(d):
    """Whole turns taken off, never added."""
    return d - 360 * math.ceil((d - 180) / 360) if d > 180 else d


def stepping_up(d):
    """Whole turns added, never taken off."""
    return d + 360 * math.ceil((-180 - d) / 360) if d < -180 else d


WRONG = {
    "wrap": {
        "sine of degrees": (
            lambda d: np.degrees(np.arctan2(np.sin(d), np.cos(d))),
            "The difference is taken for radians, as by `np.sin`. It is in degrees: turn it into radians first.",
        ),
        "clipped": (
            lambda d: np.clip(d, -180, 180),
            "You cut the difference off at ±180. 190° to the right is not 180° to the right, it is 170° to the left: take off whole turns.",
        ),
        "steps down": (
            stepping_down,
            "Differences above 180 come out right. Those below −180 need whole turns added.",
        ),
        "steps up": (
            stepping_up,
            "Differences below −180 come out right. From those above 180 whole turns have to be taken off.",
        ),
        "towards zero": (
            lambda d: d - 360 * int(d / 360),
            "You took off the whole turns, and what is left lies between −360 and 360. 331 is still the long way round.",
        ),
        "below zero": (
            lambda d: -(-d % 360),
            "That puts every difference between −360 and 0. −331 is the long way round.",
        ),
        "reflected": (
            lambda d: d % 360 if d % 360 <= 180 else 180 - d % 360,
            "Up to 180 it is right. Beyond that the way to the left is what is missing to a whole turn, not what is beyond half a turn.",
        ),
        "from 180": (
            lambda d: 180 - d % 360,
            "That is 180 minus the remainder: a difference of 1 becomes 179, and the sign is turned round.",
        ),
        "away from zero": (
            lambda d: math.copysign(abs(d) % 180, d),
            "That takes off half turns: a difference of 190 becomes 10, though that is on the other side. A turn is 360.",
        ),
    },
    "offset": {
        "1/K − K": (
            lambda x1, K, dt: dt * x1 * (1 / K - K),
            "(1 − K)/K is 1/K − 1, not 1/K − K.",
        ),
        "bracket": (
            lambda x1, K, dt: dt * x1 / K - 1,
            "A bracket is missing: dt·x₁ multiplies all of 1/K − 1.",
        ),
        "bracket above": (
            lambda x1, K, dt: dt * x1 * 1 - K / K,
            "A bracket is missing around 1 − K.",
        ),
        "plus below": (
            lambda x1, K, dt: dt * x1 * (1 - K) / (1 + K),
            "Below the line stands 1 + K. At rest offset = (1 − K)·(offset + dt·x₁): on the left offset·(1 − (1 − K)) is left, "
            "which is K times the offset.",
        ),
        "plus": (
            lambda x1, K, dt: dt * x1 * (1 + K) / K,
            "There is 1 + K above the line. The correction takes the part K away: 1 − K is left.",
        ),
        "K squared below": (
            lambda x1, K, dt: dt * x1 * (1 - K) / K**2,
            "You divided by K twice. Write down when the offset stays the same: what does one step add, what does the correction leave?",
        ),
        "squared above": (
            lambda x1, K, dt: dt * x1 * (1 - K) ** 2 / K,
            "You have the factor 1 − K twice. At rest each step adds one push, and one correction follows.",
        ),
        "half a push": (
            lambda x1, K, dt: dt * x1 * (1 - K) / (2 * K),
            "That is half of the offset: each step pushes by the whole dt·x₁.",
        ),
    }
    | {
        f"{steps} steps": (
            summed(steps),
            f"That is the offset after {steps} steps, when it is not yet at rest. Where does it end, after however many?",
        )
        for steps in (2, 3, 5, 10, 20, 30, 50, 100)
    },
    "right_prediction": combined(
        mended_entries,
        most=4,
        upper_left={2: "", 1: "In the upper left the term with P₁₁ is missing.", 0: "In the upper left the terms with P₀₁ and P₁₁ are missing."},
        upper_right={"dt": "", "1": "The upper right is still as published, without dt.", "none": "In the upper right the term with P₁₁ is missing."},
        lower_left={"dt": "", "published": "The lower left is still as published.", "none": "In the lower left the term with P₁₁ is missing."},
        q={"Q": "", "first": "Of Q you add the first entry twice: add the whole Q.", "diag": "Of Q you add the diagonal only: add the whole Q."},
    )
    | {
        "symmetrised": (
            lambda P, Q, dt: np.mean([M := np.array([[1, dt], [0, 1]]) @ P @ np.array([[1, dt], [0, 1]]).T + Q, M.T], axis=0),
            "F P Fᵀ + Q is right, but you made P, or the result, symmetric. This P need not be symmetric, and is to be treated as it is: a test has to see that it is not.",
        ),
        "lower left without P₁₀": (
            lambda P, Q, dt: np.array([[1, dt], [0, 1]]) @ P @ np.array([[1, dt], [0, 1]]).T + Q - [[0, 0], [P[1, 0], 0]],
            "Three entries are right. In the lower left P₁₀ itself is missing: the second row of F P is the second row of P, "
            "and Fᵀ adds dt·P₁₁ to its first entry.",
        ),
        "sum for product": (
            lambda P, Q, dt: (F := np.array([[1, dt], [0, 1]])) @ P + P @ F.T + Q,
            "You added F P and P Fᵀ. It is one product of three: F P Fᵀ.",
        ),
        "F squared": (
            lambda P, Q, dt: (F := np.array([[1, dt], [0, 1]])) @ F @ P + Q,
            "You multiplied by F twice on the left. Once it stands on the right, and transposed.",
        ),
        "Q multiplied": (
            lambda P, Q, dt: (F := np.array([[1, dt], [0, 1]])) @ P @ F.T @ Q,
            "F P Fᵀ is right. Q is added, not multiplied.",
        ),
        "Q times dt²": (
            lambda P, Q, dt: (F := np.array([[1, dt], [0, 1]])) @ P @ F.T + dt**2 * Q,
            "F P Fᵀ is right. Q is given per step already: add it as it is.",
        ),
        "Q forgotten and half of F": (
            lambda P, Q, dt: np.array([[1, dt], [0, 1]]) @ P,
            "Two things are missing: Fᵀ on the right, and Q.",
        ),
    },
    "right_update": {
        "1 for I": (
            lambda P, K: (1 - np.outer(K, [1, 0])) @ P,
            "`1 - K H` takes K H from a matrix full of ones. I is the identity, `np.eye(2)`.",
        ),
        "K * H": (
            lambda P, K: (np.eye(2) - K * np.array([1, 0])) @ P,
            "`K * H` of two vectors multiplies entry by entry: that is [K₀, 0], which NumPy then takes from each row. K H is a matrix, a column times a row.",
        ),
        "own gain": (
            lambda P, K: (np.eye(2) - np.outer(P[:, 0] / (P[0, 0] + 1e-6), [1, 0])) @ P,
            "You work out a gain of your own. The update is wanted for the K that is handed in.",
        ),
        "own gain, R = 1": (
            lambda P, K: (np.eye(2) - np.outer(P[:, 0] / (P[0, 0] + 1), [1, 0])) @ P,
            "You work out a gain of your own, with R = 1. The update is wanted for the K that is handed in.",
        ),
        "on the right": (
            lambda P, K: P - np.outer(P[:, 0], K),
            "You took P HᵀKᵀ away: the bracket on the right, transposed. Here (I − KH) stands on the left of P.",
        ),
        "upper left for all": (
            lambda P, K: P - K * P[0, 0],
            "`K * P[0, 0]` is two numbers, taken from each row. What is taken away is a matrix: the column K times the first row of P.",
        ),
        "K @ P": (
            lambda P, K: P - K @ P,
            "`K @ P` is a row, taken from both rows of P. K H P is a matrix: the column K times the first row of P.",
        ),
        "P added": (
            lambda P, K: np.eye(2) - np.outer(K, [1, 0]) + P,
            "The bracket is to be multiplied by P, not added.",
        ),
        "other column": (
            lambda P, K: (np.eye(2) - np.outer(K, [0, 1])) @ P,
            "That is H = [0, 1], as if the rate were read. Here the angle is: H = [1, 0].",
        ),
    },
}  # fmt: skip
