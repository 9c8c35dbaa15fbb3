"""Lesson 18, `transition`: wrong answers, each with the sentence that it gets."""

import numpy as np


def leaving(stays, T):
    """A transition matrix whose rows leave with T / stays."""
    M = len(stays)
    leave = (T / stays)[:, None]
    return np.where(np.eye(M, dtype=bool), 1 - leave, leave / (M - 1))


def chances(stays, T, leave):
    """A transition matrix whose rows leave with given chances."""
    M, leave = len(stays), leave[:, None]
    return np.where(np.eye(M, dtype=bool), 1 - leave, leave / (M - 1))


def shared(weight):
    """What is left of each row goes to the others by some weight."""

    def transition(stays, T):
        w = np.tile(weight(stays), (len(stays), 1))
        np.fill_diagonal(w, 0)
        leave = (T / stays)[:, None]
        return np.diag(1 - T / stays) + leave * w / w.sum(axis=1, keepdims=True)

    return transition


WRONG = {
    "columns sum to one": (
        lambda stays, T: leaving(stays, T).T,
        "Your columns sum to one. Row i is “from mode i”: each way out of it leads somewhere, so the rows must.",
    ),
    "clock forgotten": (
        lambda stays, T: leaving(stays, 1.0),
        "That is right for steps of one second. In `stays[i]` seconds there are `stays[i] / T` steps.",
    ),
    "clock upside down": (
        lambda stays, T: leaving(stays, 1 / T),
        "T stands in the denominator: the longer a step, the more likely a change within it.",
    ),
    "shared among all": (
        lambda stays, T: np.where(
            np.eye(len(stays), dtype=bool), 1 - (T / stays)[:, None], (T / stays)[:, None] / len(stays)
        ),
        "Each entry off the diagonal is T/(stays·M), and the rows fall short of 1. Who leaves passes to one of the other M − 1.",
    ),
    "not shared": (
        lambda stays, T: np.where(np.eye(len(stays), dtype=bool), 1 - (T / stays)[:, None], (T / stays)[:, None]),
        "Each off-diagonal entry has the whole chance to leave; the others must share it, or the rows exceed 1.",
    ),
    "stay and leave swapped": (
        lambda stays, T: np.where(
            np.eye(len(stays), dtype=bool), (T / stays)[:, None], (1 - T / stays)[:, None] / (len(stays) - 1)
        ),
        "The diagonal is the chance to stay, 1 − T / stays; you put the chance to leave there.",
    ),
    "one for all": (
        lambda stays, T: leaving(np.full(len(stays), stays.mean()), T),
        "Each mode has its own length: row i belongs to `stays[i]`.",
    ),
    "exponential": (
        lambda stays, T: np.where(
            np.eye(len(stays), dtype=bool),
            np.exp(-T / stays)[:, None],
            (1 - np.exp(-T / stays))[:, None] / (len(stays) - 1),
        ),
        "exp(−T / stays) is right for changes at any moment; here a change can come only with a step, and a mean of "
        "`stays / T` steps asks for 1 − T / stays.",
    ),
    "shared by two": (
        lambda stays, T: np.where(np.eye(len(stays), dtype=bool), 1 - (T / stays)[:, None], (T / stays)[:, None] / 2),
        "Each entry off the diagonal is T/(2·stays), which is right for three modes. There may be more: share by len(stays) − 1.",
    ),
    "diagonal only": (
        lambda stays, T: np.diag(1 - T / stays),
        "The diagonal is right. Who leaves a mode passes to another one: the rest of each row shares T / stays.",
    ),
    "ratio upside down": (
        lambda stays, T: leaving(T / stays, 1.0),
        "You divided stays by T. The chance to leave in one step is T / stays: the longer the stay, the smaller it is.",
    ),
    "all alike": (
        lambda stays, T: np.full((len(stays), len(stays)), 1 / len(stays)),
        "That says that every step begins anew, with all modes equally likely. A mode lasts: most of each row"
        " stands on the diagonal.",
    ),
    "also to itself": (
        lambda stays, T: np.diag(1 - T / stays) + (T / stays)[:, None] / len(stays),
        "Off the diagonal stands T/(stays·M), as if a ship that leaves a mode could pass to the same mode again. It "
        "passes to one of the *other* M − 1.",
    ),
    "T = 2": (
        lambda stays, T: chances(stays, T, 2 / stays),
        "That is right for readings every 2 s. The time between them is handed in as `T`.",
    ),
    "half-life": (
        lambda stays, T: chances(stays, T, 1 - 0.5 ** (T / stays)),
        "That is right if `stays` were a half-life. It is the mean time in the mode: with the chance p to leave in each step that is 1/p steps.",
    ),
    "leave alone": (
        lambda stays, T: chances(stays, T, T / stays) - np.diag(1 - T / stays),
        "The entries off the diagonal are right. On the diagonal stands the chance to stay, 1 − T / stays.",
    ),
    "whole number of steps": (
        lambda stays, T: chances(stays, T, 1 / np.ceil(stays / T)),
        "You rounded the number of steps. A mean of steps need not be a whole number: the chance to leave is T / stays.",
    ),
    "two by two": (
        lambda stays, T: T / stays,
        "Those are the chances to leave, one for each mode. Write the whole matrix, (M, M).",
    ),
    "chances to stay": (
        lambda stays, T: 1 - T / stays,
        "Those are the chances to stay, one for each mode. Write the whole matrix, (M, M).",
    ),
    "stays over T, at most 1": (
        lambda stays, T: chances(stays, T, np.minimum(1, stays / T)),
        "You divided stays by T. The chance to leave in one step is T / stays: the longer the stay, the smaller it is.",
    ),
    "whole steps": (
        lambda stays, T: chances(stays, T, 1 / (stays / T + 1)),
        "That is right for one step more, stays/T + 1. A mode that lasts `stays / T` steps on average is left with the chance T / stays.",
    ),
    "half": (
        lambda stays, T: chances(stays, T, T / stays / 2),
        "Your chance to leave is half of what it should be. It is T / stays, and the other M − 1 modes share it.",
    ),
    "the first for all": (
        lambda stays, T: chances(stays, T, T / stays[0] + 0 * stays),
        "All rows are right for the first length. Each mode has its own: row i belongs to `stays[i]`.",
    ),
    "in proportion to the stays": (
        shared(lambda stays: stays),
        "The diagonal is right. What is left of a row goes to the others in proportion to their stays here: there is no favourite, so "
        "each gets the same share.",
    ),
    "in proportion to the rates": (
        shared(lambda stays: 1 / stays),
        "The diagonal is right. What is left of a row goes to the others in proportion to 1/stays here: there is no favourite, so each "
        "gets the same share.",
    ),
}
