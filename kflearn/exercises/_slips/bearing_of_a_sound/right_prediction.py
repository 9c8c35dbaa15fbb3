"""Lesson 8, `right_prediction`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._combined import combined


def as_published(P, Q, dt):
    """The published prediction."""
    return np.array([[P[0, 0] + dt * P[1, 0] + Q[0, 0], P[0, 1] + P[1, 1]], [dt * P[1, 0], P[1, 1] + Q[1, 1]]])


def rows(dt):
    return np.array([[1, dt], [0, 1]])


def moved(P, dt):
    """F P Fᵀ for an angle and its rate."""
    F = np.array([[1, dt], [0, 1]])
    return F @ P @ F.T


def mended_entries(upper_left, upper_right, lower_left, q):
    """A prediction written entry by entry, some of them not mended."""

    def predict(P, Q, dt):
        a = P[0, 0] + dt * P[1, 0] + (upper_left > 0) * dt * P[0, 1] + (upper_left > 1) * dt**2 * P[1, 1]
        b = {"dt": P[0, 1] + dt * P[1, 1], "1": P[0, 1] + P[1, 1], "none": P[0, 1]}[upper_right]
        c = {"dt": P[1, 0] + dt * P[1, 1], "published": dt * P[1, 0], "none": P[1, 0]}[lower_left]
        return np.array([[a, b], [c, P[1, 1]]]) + {"Q": Q, "first": Q[0, 0] * np.eye(2), "diag": np.diag(np.diag(Q))}[q]

    return predict


def corners_moved_first(P, Q, dt):
    F, M = np.array([[1, dt], [0, 1]]), P.copy()
    M[[0, 1], [1, 0]] += dt * P[1, 1]
    right = F @ P @ F.T + Q
    return np.array([[(F @ M @ F.T + Q)[0, 0], right[0, 1]], right[1]])


WRONG = (
    {
        "as published": (
            as_published,
            "That is the published one again: its corners use F₀₀ and F₁₁ where F₀₁ belongs, and there is no Fᵀ.",
        ),
        "F P + Q": (
            lambda P, Q, dt: rows(dt) @ P + Q,
            "Half of the published fault is still there: Fᵀ is missing on the right, so the result is not symmetric.",
        ),
        "P Fᵀ + Q": (
            lambda P, Q, dt: P @ rows(dt).T + Q,
            "Fᵀ on the right is there, but F on the left is missing.",
        ),
        "F P F + Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt) + Q,
            "The right-hand F must be transposed. A covariance is symmetric; print yours and look at its corners.",
        ),
        "Fᵀ P F + Q": (
            lambda P, Q, dt: rows(dt).T @ P @ rows(dt) + Q,
            "Fᵀ P F, or dt in the wrong corner: here an uncertain angle makes the rate uncertain. It is the other way round.",
        ),
        "forgot Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T,
            "F P Fᵀ is right, but the jolts of the step are missing: add Q.",
        ),
        "forgot F": (
            lambda P, Q, dt: P + Q,
            "That is P + Q. An uncertain rate makes the angle more uncertain with every dt: F P Fᵀ.",
        ),
        "entry by entry": (
            lambda P, Q, dt: rows(dt) * P * rows(dt).T + Q,
            "P's corners are gone, as by *, entry by entry. The matrix product is @.",
        ),
        "dt forgotten": (
            lambda P, Q, dt: rows(1) @ P @ rows(1).T + Q,
            "That is F with a 1 in its corner; there belongs dt, the time between two readings.",
        ),
        "Q scaled": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T + dt * Q,
            "F P Fᵀ is right. Q is given per step already: add it as it is.",
        ),
        "minus Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T - Q,
            "Q is taken away: time makes a belief wider, never sharper.",
        ),
        "diagonal of Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T + np.diag(np.diag(Q)),
            "F P Fᵀ is right. Of Q you add the diagonal only; it may have corners, so add the whole matrix.",
        ),
        "first entry of Q": (
            lambda P, Q, dt: rows(dt) @ P @ rows(dt).T + Q[0, 0] * np.eye(2),
            "F P Fᵀ is right. You add Q's first entry twice, as in the published program; here Q is a whole matrix.",
        ),
        "Q added first": (
            lambda P, Q, dt: rows(dt) @ (P + Q) @ rows(dt).T,
            "F acts on the jolts of this step too, as if Q were added before the move. First F P Fᵀ, then + Q.",
        ),
        "upper left by hand": (
            lambda P, Q, dt: (rows(dt) @ P @ rows(dt).T + Q) - np.diag([dt * P[0, 1] + dt**2 * P[1, 1], 0]),
            "The corners are right. The upper left entry is not: it takes dt·P₁₀, dt·P₀₁ and dt²·P₁₁. Let F P Fᵀ do it.",
        ),
        "P on both sides": (
            lambda P, Q, dt: P @ rows(dt) @ P.T + Q,
            "F and P have changed places: F stands on both sides, P in the middle.",
        ),
        "corners mended, q as published": (
            lambda P, Q, dt: moved(P, dt) - np.diag([dt**2 * P[1, 1], 0]) + Q[0, 0] * np.eye(2),
            "The corners of F P Fᵀ are right. In the upper left dt²·P₁₁ is missing, and of Q you add the first entry twice: add the whole Q.",
        ),
        "dt² P₁₁ forgotten": (
            lambda P, Q, dt: moved(P, dt) - np.diag([dt**2 * P[1, 1], 0]) + Q,
            "Three entries are right. In the upper left one dt²·P₁₁ is missing: the rate's own variance, carried to the angle.",
        ),
        "a symmetric P taken for granted": (
            lambda P, Q, dt: moved(P, dt) + Q + np.diag([dt * (P[0, 1] - P[1, 0]), 0]),
            "You took P₀₁ twice. This P need not be symmetric: in the upper left stands P₀₁ + P₁₀.",
        ),
        "symmetric throughout": (
            lambda P, Q, dt: moved(np.array([[P[0, 0], P[0, 1]], [P[0, 1], P[1, 1]]]), dt) + Q,
            "You took P₀₁ for P₁₀ as well. This P need not be symmetric: use both.",
        ),
        "upper left and q as published": (
            lambda P, Q, dt: moved(P, dt) - np.diag([dt * P[0, 1] + dt**2 * P[1, 1], 0]) + Q[0, 0] * np.eye(2),
            "The corners of F P Fᵀ are right. In the upper left dt·P₀₁ and dt²·P₁₁ are missing, and of Q you add the first entry twice: add the whole Q.",
        ),
        "Q squared": (
            lambda P, Q, dt: moved(P, dt) + Q**2,
            "F P Fᵀ is right. Q is a covariance already: it is not squared.",
        ),
    }
    | combined(
        mended_entries,
        most=4,
        upper_left={
            2: "",
            1: "In the upper left the term with P₁₁ is missing.",
            0: "In the upper left the terms with P₀₁ and P₁₁ are missing.",
        },
        upper_right={
            "dt": "",
            "1": "The upper right is still as published, without dt.",
            "none": "In the upper right the term with P₁₁ is missing.",
        },
        lower_left={
            "dt": "",
            "published": "The lower left is still as published.",
            "none": "In the lower left the term with P₁₁ is missing.",
        },
        q={
            "Q": "",
            "first": "Of Q you add the first entry twice: add the whole Q.",
            "diag": "Of Q you add the diagonal only: add the whole Q.",
        },
    )
    | {
        "symmetrised": (
            lambda P, Q, dt: np.mean(
                [M := np.array([[1, dt], [0, 1]]) @ P @ np.array([[1, dt], [0, 1]]).T + Q, M.T], axis=0
            ),
            "F P Fᵀ + Q is right, but you made P, or the result, symmetric. This P need not be symmetric, and is to be treated as it is: a test has to see that it is not.",
        ),
        "lower left without P₁₀": (
            lambda P, Q, dt: (
                np.array([[1, dt], [0, 1]]) @ P @ np.array([[1, dt], [0, 1]]).T + Q - [[0, 0], [P[1, 0], 0]]
            ),
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
        "dt at the wrong term": (
            lambda P, Q, dt: (
                np.array(
                    [
                        [P[0, 0] + dt * (P[0, 1] + P[1, 0]) + dt**2 * P[1, 1], P[0, 1] + dt * P[1, 1]],
                        [dt * P[1, 0] + P[1, 1], P[1, 1]],
                    ]
                )
                + Q
            ),
            "Three entries are right. At the lower left dt stands beside the wrong term: it is P₁₀ + dt·P₁₁.",
        ),
        "corners moved first": (
            corners_moved_first,
            "Three entries are right. In the upper left dt²·P₁₁ counts three times, as if the corners had been "
            "overwritten before they are used there. It counts once: use the old corners.",
        ),
        "lower left like the upper right": (
            lambda P, Q, dt: Q + np.array([[P[0, 0] + dt * P[1, 0], P[0, 1] + P[1, 1]], [P[1, 0] + P[1, 1], P[1, 1]]]),
            "Each corner gets P₁₁ · dt, and yours get P₁₁ without dt. Upper left dt · P₀₁ and dt² · P₁₁ are missing. Multiply F P Fᵀ out, with F = [[1, dt], [0, 1]].",
        ),
    }
)
