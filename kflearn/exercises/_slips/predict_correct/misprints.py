"""Lesson 3, `misprints`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.predict_correct.shared import WRONG_STEPS, corrected, gain_of

TAKEN = (
    "both kept",
    "covariance not reduced",
    "np.eye(2)",
    "np.eye(len(z))",
    "1 − K H",
)  # they have a sentence of their own, or a rule


def step(x_pred, P_pred, z, H, R, begin=None):
    """A correction of a prediction; as printed it begins its walk elsewhere."""
    K = gain_of(P_pred, H, R)
    return (x_pred if begin is None else begin) + K @ (z - H @ x_pred), P_pred - K @ H @ P_pred


def whole_step(correction):
    """A wrong correction after the right prediction."""
    return lambda x, P, z, F, H, Q, R: correction(F @ x, F @ P @ F.T + Q, z, H, R)


def Q_at_the_end(x, P, z, F, H, Q, R):
    x, P = corrected(F @ x, F @ P @ F.T, z, H, R)
    return x, P + Q


def Q_in_the_gain_alone(x, P, z, F, H, Q, R):
    P = F @ P @ F.T
    return corrected(F @ x, P, z, H, R, P @ H.T @ np.linalg.inv(H @ (P + Q) @ H.T + R))


WRONG = (
    {
        "as published": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P @ F @ P, z, H, R, begin=F @ F @ x),
            "That is still the published step: line two and line four are both misprinted.",
        ),
        "only line four": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P @ F @ P, z, H, R),
            "The second F is gone. Line two remains: P F P should be F P Fᵀ + Q.",
        ),
        "only line two": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T + Q, z, H, R, begin=F @ F @ x),
            "Line two is mended. Line four still moves the state a second time: begin at x_pred, not at F @ x_pred.",
        ),
        "Q still missing": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T, z, H, R),
            "F P Fᵀ is right and the second F is gone. But the bumps are missing: add Q.",
        ),
        "Q missing, stray F": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T, z, H, R, begin=F @ F @ x),
            "F P Fᵀ is right. Q is still missing after it, and line four still has a second F.",
        ),
        "P F P + Q": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P @ F @ P + Q, z, H, R),
            "The second F is gone and Q is there. But in P F P the order is wrong: F P Fᵀ.",
        ),
        "F P F": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F + Q, z, H, R),
            "The second F is gone. In line two the right-hand F must be transposed: F P Fᵀ + Q.",
        ),
        "Fᵀ P F": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F.T @ P @ F + Q, z, H, R),
            "The second F is gone. In line two the transpose is on the wrong side: F P Fᵀ + Q.",
        ),
        "F in the innovation": (
            lambda x, P, z, F, H, Q, R: step(F @ F @ x, F @ P @ F.T + Q, z, H, R),
            "Line two is mended. But now F acts twice on the state, in the innovation too: x_pred is F @ x, moved once.",
        ),
        "not predicted at all": (
            lambda x, P, z, F, H, Q, R: step(x, F @ P @ F.T + Q, z, H, R),
            "The state is not moved on at all: x_pred = F @ x stays, only the second F, in line four, has to go.",
        ),
        "never predicted": (
            lambda x, P, z, F, H, Q, R: step(x, P, z, H, R),
            "That is a correction alone. Predict first: x_pred = F @ x and P_pred = F P Fᵀ + Q.",
        ),
        "innovation with the old state": (
            lambda x, P, z, F, H, Q, R: (
                F @ x + gain_of(F @ P @ F.T + Q, H, R) @ (z - H @ x),
                step(F @ x, F @ P @ F.T + Q, z, H, R)[1],
            ),
            "P is right. But the innovation compares z with the state of a second ago. It belongs to the predicted state: z − H @ x_pred, with x_pred = F @ x.",
        ),
        "the old P at the end": (
            lambda x, P, z, F, H, Q, R: (
                step(F @ x, F @ P @ F.T + Q, z, H, R)[0],
                P - gain_of(F @ P @ F.T + Q, H, R) @ H @ P,
            ),
            "The new x is right. But the last line shrinks the P of a second ago: use P_pred.",
        ),
        "the gain from the old P": (
            lambda x, P, z, F, H, Q, R: (
                F @ x + gain_of(P, H, R) @ (z - H @ F @ x),
                F @ P @ F.T + Q - gain_of(P, H, R) @ H @ (F @ P @ F.T + Q),
            ),
            "Your gain is made of the P of a second ago. Use P_pred in line three.",
        ),
        "the walk begins at x": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T + Q, z, H, R, begin=x),
            "Line two is mended. Line four begins at x_pred, not at the old x.",
        ),
        "P_pred returned": (
            lambda x, P, z, F, H, Q, R: (step(F @ x, F @ P @ F.T + Q, z, H, R)[0], F @ P @ F.T + Q),
            "The new x is right. P is still the predicted one: the last line of the step makes it smaller.",
        ),
        "F(P + Q)Fᵀ": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ (P + Q) @ F.T, z, H, R),
            "The second F is gone. Q belongs to this step: first F P Fᵀ, then add Q.",
        ),
        "prediction only": (
            lambda x, P, z, F, H, Q, R: (F @ x, F @ P @ F.T + Q),
            "That is the prediction, and it is right. The correction by z is missing: lines three to five.",
        ),
        "F P": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P + Q, z, H, R),
            "The second F is gone. In line two the Fᵀ on the right is missing.",
        ),
        "minus Q": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T - Q, z, H, R),
            "The second F is gone. In line two Q is added, not subtracted: bumps make the prediction less certain.",
        ),
        "P + Q": (
            lambda x, P, z, F, H, Q, R: step(F @ x, P + Q, z, H, R),
            "The second F is gone. In line two P has to be moved: F P Fᵀ, then Q.",
        ),
        "R in line two": (
            lambda x, P, z, F, H, Q, R: step(F @ x, F @ P @ F.T, z, H, R, begin=x),
            "Q is missing in line two, and line four begins at x_pred.",
        ),
        "Q twice": (
            lambda x, P, z, F, H, Q, R: corrected(F @ x, F @ P @ F.T + 2 * Q, z, H, R),
            "The second F is gone, and F P Fᵀ is right. But Q is added twice in line two: once is enough.",
        ),
        "Q squared": (
            lambda x, P, z, F, H, Q, R: corrected(F @ x, F @ P @ F.T + Q @ Q, z, H, R),
            "The second F is gone, and F P Fᵀ is right. Q holds variances already: it is not squared.",
        ),
    }
    | {
        label: (whole_step(answer), f"Both misprints are mended. {sentence}")
        for label, (answer, sentence, *pattern) in WRONG_STEPS.items()
        if not pattern and label not in TAKEN
    }
    | {
        "Q at the end": (
            Q_at_the_end,
            "The second F is gone. Q is missing in line two, and is added after the correction: the bumps come before "
            "the reading, so Q belongs to P_pred.",
        ),
        "Q in the gain alone": (
            Q_in_the_gain_alone,
            "The second F is gone. Q counts in the inverse of line three only. Put it into P_pred, in line two: then "
            "it is in all that is made of P_pred.",
        ),
    }
)
