"""Lesson 1, `overwritten`: wrong answers, each with the sentence that it gets."""

import numpy as np


def one_after_the_other(F, x, order=(0, 1)):
    """F x entry by entry, each written over the old one at once."""
    x = x.copy()
    for i in order:
        x[i] = F[i, 0] * x[0] + F[i, 1] * x[1]
    return x


def one_minus(i, j):
    """F x, with a minus before one entry of F."""
    sign = np.ones((2, 2))
    sign[i, j] = -1
    return lambda F, x: (sign * F) @ x


WRONG = (
    {
        "as published": (
            one_after_the_other,
            "The second line still meets the new first entry. Keep the old values first (old = x is not enough: that is a second name for the same array).",
        ),
        "the other order": (
            lambda F, x: one_after_the_other(F, x, (1, 0)),
            "The line of x[0] meets the new x[1], not the old one: keep both old values first.",
        ),
        "transposed": (
            lambda F, x: F.T @ x,
            "Rows and columns are exchanged: the first entry is F[0, 0] * x[0] + F[0, 1] * x[1].",
        ),
        "diagonal only": (
            lambda F, x: np.diag(F) * x,
            "You left out F[0, 1] and F[1, 0]: each new entry is made of both old ones.",
        ),
        "entry by entry": (
            lambda F, x: F * x,
            "* multiplies entry by entry and gives a matrix. Each new entry is the sum of a row of it.",
        ),
        "only one entry mended": (
            lambda F, x: np.array([F[0] @ x, x[1]]),
            "The first entry is right. The second has not been moved at all.",
        ),
        "the same row twice": (
            lambda F, x: np.array([F[0] @ x, F[0] @ x]),
            "The first entry is right. The second takes the second row: F[1, 0] and F[1, 1].",
        ),
        "entries exchanged": (
            lambda F, x: (F @ x)[::-1],
            "Both numbers are right, but they have changed places: the first row of F gives the first entry.",
        ),
        "only the new x[0] in the first": (
            lambda F, x: np.array([x[0], F[1] @ x]),
            "The second entry is right. The first has not been moved at all.",
        ),
        "columns": (
            lambda F, x: np.array([(F[0, 0] + F[0, 1]) * x[0], (F[1, 0] + F[1, 1]) * x[1]]),
            "Each entry of F meets its own number: F[0, 1] belongs to x[1], and F[1, 0] to x[0].",
        ),
        "second without F[1, 0]": (
            lambda F, x: np.array([F[0] @ x, F[1, 1] * x[1]]),
            "The first entry is right. The second lacks F[1, 0] times x[0].",
        ),
        "first without F[0, 1]": (
            lambda F, x: np.array([F[0, 0] * x[0], F[1] @ x]),
            "The second entry is right. The first lacks F[0, 1] times x[1].",
        ),
        "F[0, 1] for F[1, 0]": (
            lambda F, x: np.array([F[0] @ x, F[0, 1] * x[0] + F[1, 1] * x[1]]),
            "The first entry is right. The second uses the second row of F: F[1, 0], not F[0, 1].",
        ),
        "a column": (
            lambda F, x: (F @ x)[:, None],
            "The numbers are right, but you return a column, of shape (2, 1). The state is flat: two numbers.",
        ),
        "only the second": (
            lambda F, x: F[1] @ x,
            "You return the second entry only. Return both, as an array of two numbers.",
        ),
        "unchanged": (lambda F, x: x, "You return the old state. Where are the new entries?"),
        "velocity twice": (
            lambda F, x: np.array([F[0] @ x, (F[1, 0] + F[1, 1]) * x[1]]),
            "In your second line F[1, 0] is multiplied by the velocity. It belongs to the old position.",
        ),
        "position twice": (
            lambda F, x: np.array([(F[0, 0] + F[0, 1]) * x[0], F[1] @ x]),
            "In your first line F[0, 1] is multiplied by the position. It belongs to the old velocity.",
        ),
        "two steps": (lambda F, x: F @ F @ x, "That is F F x, two steps. Multiply by F once."),
    }
    | {
        f"−F[{i}, {j}]": (
            one_minus(i, j),
            f"The {('first', 'second')[i]} entry is what comes out with −F[{i}, {j}]. In F x all products are added, with a plus.",
        )
        for i in range(2)
        for j in range(2)
    }
    | {
        "on top of the old state": (
            lambda F, x: x + F @ x,
            "That is x + F x: the old state is still in it. The new entries are the sums alone, so each sum begins at "
            "0.",
        ),
    }
)
