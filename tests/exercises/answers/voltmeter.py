"""Lesson 5: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import linecache
import re

import numpy as np

import kflearn
from kflearn import boats
from kflearn.exercises import _voltmeter_judge as meter
from tests.exercises.hand_in import asked


def named(exercise, *names):
    """The right values under names of their own."""
    return lambda *given: dict(zip(names, asked(exercise)._solve(*given), strict=True))


DICTIONARY = "The values are right, but the result is a dictionary: return the values one after the other"


def is_nan(x):
    return any(value is np.nan for value in x)


def asks_for_zero(x):
    return np.any(x)


def one_over_H(z, H, R):
    return (1 / H) @ z, (1 / H) @ R @ (1 / H).T


inv = np.linalg.inv


def corrects_in_gaps(z, Q, R):
    """In a gap the estimate is taken for a reading."""
    x, P = z[0], R
    rows = [(x, P)]
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x, P = x + K * (np.nan_to_num(reading - x)), (1 - K) * P
        rows.append((x, P))
    return tuple(zip(*rows, strict=True))


def typed(text):
    """The last function of a text, as if it had been typed into a cell of the notebook."""
    place = f"<typed {abs(hash(text))}>"
    space = {name: getattr(kflearn, name) for name in kflearn.__all__} | {"np": np, "plane": boats.plane()}
    linecache.cache[place] = (len(text), None, text.splitlines(True), place)
    exec(compile(text, place, "exec"), space)
    return space[re.findall(r"^def (\w+)\(", text, re.MULTILINE)[-1]]


POWER = typed("def start(z, H, R):\n    G = H**-1.0\n    return G @ z, G @ R @ G.T")


def turned_over(z, H, R):
    I = 1 / np.array(H, float)
    return I @ z, I @ R @ I.T


def exchanged(z, Q, R):
    x, P, rows = z[0], R, [(z[0], R)]
    for seen in z[1:]:
        P = P + R
        if not np.isnan(seen):
            K = P / (P + Q)
            x, P = x + K * (seen - x), (1 - K) * P
        rows.append((x, P))
    return tuple(zip(*rows, strict=True))


def entry_by_entry(z, H, R):
    undo = 1 / np.where(np.asarray(H) == 0, np.inf, H)
    return undo @ z, undo @ R @ undo.T


def impatient(Q, R):
    P, old, K = R, 0, 1
    while abs(K - old) > 0.01:
        old = K
        P = P + Q
        K = P / (P + R)
        P = (1 - K) * P
    return K


def whole(Q, R):
    q = Q // R
    return (np.sqrt(q**2 + 4 * q) - q) / 2


def filled(z, Q, R):
    return meter.filtered(meter.last_reading(z), Q, R)


def few_steps(Q, R):
    P = R
    for _ in range(3):
        P = P + Q
        K = P / (P + R)
        P = (1 - K) * P
    return K


RIGHT = [
    ("second_gain", 0.357),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("steady_gain", lambda Q, R: Q // (Q + R), "in every trial: do `//` or `int` cut it off?"),
    ("best_error", 2.002, "the error of believing each reading", "square"),
    (
        "whole_filter",
        lambda z, Q, R: corrects_in_gaps(z[~np.isnan(z)], Q, R),
        "the first and the missing ones included",
    ),
    ("steady_gain", lambda Q, R: np.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R, "is divided by 2", "Nearly"),
    ("second_gain", 0.408, "P = 2 V² is what the first reading left", "made the start"),
    ("best_error", 0.707, "K, or the sum of the two precisions"),
    ("auto_start", named("voltmeter.auto_start", "x", "P"), DICTIONARY),
    ("second_gain", 0.25 + 0.05, "A gain of 0.3 would need P⁻ = 3.86 V²"),
    ("is_unknown", is_nan, "the same object"),
    ("is_unknown", asks_for_zero, "whether an entry is not zero"),
    ("is_unknown", lambda x: bool(np.isnan(x[0]) or np.isnan(x[1])), "may lie beyond the end"),
    ("auto_start", one_over_H, "`1 / H` turns over each entry"),
    ("auto_start", lambda z, H, R: (inv(H) @ z, inv(H) * R * inv(H).T), "`*` multiplies entry by entry"),
    ("whole_filter", corrects_in_gaps, "no factor 1 − K"),
    ("auto_start", POWER, "`H**-1` turns over each entry by itself"),
    ("is_unknown", lambda x: not np.all(x), "differs from 0"),
    ("auto_start", lambda z, H, R: (H @ z, inv(H) @ R @ inv(H).T), "applied H once more"),
    ("auto_start", turned_over, "`np.linalg.inv(H)`"),
    ("best_error", 2.83, "Or you took the 4 in both places"),
    ("best_error", 2.47, "comes to"),
    ("best_error", 5**0.5, "with one part weighed"),
    ("whole_filter", exchanged, "You exchanged Q and R"),
    ("auto_start", entry_by_entry, "only where H holds a single number. `1 / H` turns over"),
    ("best_error", 1.632, "what the filter with its random walk is off by"),
    ("best_error", 6.0, "a variance of 36 V²"),
    ("second_gain", "0,357", "and write a point in place of the comma"),
    ("steady_gain", impatient, "once K changes by 0.01 or less"),
    ("steady_gain", whole, "rounded down to a whole number"),
    ("best_error", np.sqrt((1 - 8 / 12) * 8), "1.633 is √(8/3)"),
    ("best_error", 1.416, "what the simulation measured"),
    ("whole_filter", filled, "such as 0 or the last reading?"),
    ("whole_filter", filled, "wanted in all"),
    ("steady_gain", few_steps, "That is the gain of reading 4"),
    ("steady_gain", lambda Q, R: (R + Q) / (2 * R + Q), "That is the gain of reading 2"),
    ("is_unknown", lambda x: x == np.nan, "NaN equals nothing"),
    ("is_unknown", lambda x: np.nan in x, "`in` compares with =="),
    ("is_unknown", lambda x: len(x) == 0, "says False whatever the state is"),
    ("is_unknown", lambda x: np.isnan(x[0]) or np.isnan(x[1]), "IndexError"),
    ("auto_start", lambda z, H, R: (inv(H) @ z, inv(H) @ R @ H.T), "only the left side is undone"),
    ("auto_start", lambda z, H, R: (inv(H) @ R @ inv(H).T, inv(H) @ z), "wanted in the other order"),
    ("whole_filter", meter.FAILING["gaps filled with zeros"], "or the last reading?", "P has to grow by Q"),
    ("whole_filter", meter.FAILING["raw readings, NaN kept"], "not finite at reading", "±2σ"),
    ("whole_filter", meter.FAILING["predictions"], "one reading late", "Does the gain"),
    ("second_gain", (9 + 3) / (9 + 3 + 9), "it starts with P = R"),
    ("best_error", lambda reading: 12 + 0.5 * (reading - 12), "but it is a function: hand in the value itself"),
    (
        "is_unknown",
        lambda x: np.flatnonzero(np.isnan(x)) if np.isnan(x).any() else False,
        "should be True or False, but it is an array of shape (1,)",
    ),
]
