"""Lesson 26: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import linecache
import re

import numpy as np

import kflearn
from kflearn import Gaussian, LinearModel, boats, pda_filter


def nearest(y, nis):
    return y[nis.argmin()]


PLANE = boats.plane()


def tracker(choose, gate=9.21):
    """A tracker of the boat that corrects by what is chosen among the innovations in its gate."""

    def follow(z, start, clutter):
        x, P, found = np.array(start, float), np.diag([25.0, 1, 25, 1]), []
        for scan in z:
            x, P = PLANE.F @ x, PLANE.F @ P @ PLANE.F.T + PLANE.Q
            S = PLANE.H @ P @ PLANE.H.T + PLANE.R
            y = scan[~np.isnan(scan).any(axis=1)] - PLANE.H @ x
            nis = np.sum(y @ np.linalg.inv(S) * y, axis=1)
            y, nis = y[nis <= gate], nis[nis <= gate]
            if len(y):
                K = P @ PLANE.H.T @ np.linalg.inv(S)
                x, P = x + K @ choose(y, nis), P - K @ S @ K.T
            found.append(x[[0, 2]])
        return np.array(found)

    return follow


def middle(y, nis):
    return y.mean(axis=0)


def turned_round(y, nis):
    return -y[nis.argmin()]


STRAIGHT = LinearModel(PLANE.F, PLANE.H, 0 * PLANE.Q, PLANE.R)


def with_model(model, columns=(0, 2), cov=(25, 1, 25, 1)):
    def follow(z, start, clutter):
        track = pda_filter(model, z, Gaussian(start, np.diag(cov)), detection=0.9, clutter=clutter)
        return track.mean[:, list(columns)]

    return follow


def places_first():
    """A model of x, y, v_x, v_y."""
    parts = [[1, 1], [0, 1]], [[1, 0]], 0.25 * np.array([[0.25, 0.5], [0.5, 1]]), [[25.0]]
    return LinearModel(*(np.kron(part, np.eye(2)) for part in parts))


def first_columns(z, start, clutter):
    belief = Gaussian(start, np.diag([25.0, 1, 25, 1]))
    return pda_filter(boats.plane(), z, belief, detection=0.9, clutter=clutter).mean[:, :2]


def typed(text):
    """The last function of a text, as if it had been typed into a cell of the notebook."""
    place = f"<typed {abs(hash(text))}>"
    space = {name: getattr(kflearn, name) for name in kflearn.__all__} | {"np": np, "plane": boats.plane()}
    linecache.cache[place] = (len(text), None, text.splitlines(True), place)
    exec(compile(text, place, "exec"), space)
    return space[re.findall(r"^def (\w+)\(", text, re.MULTILINE)[-1]]


def tracks(filters, columns="[0, 2]"):
    """A tracker of the boat, typed."""
    return typed(
        "def follow(z, start, clutter):\n"
        "    belief = Gaussian(start, np.diag([25.0, 1, 25, 1]))\n"
        f"    return {filters}.mean[:, {columns}]\n"
    )


NEAREST = tracks("nearest_filter(plane, z, belief)")

SMALL = tracks("pda_filter(plane, z, belief, detection=0.9, clutter=clutter, gate=0.9)")

OTHER_H = tracks("pda_filter(plane.replace(H=np.eye(2, 4)), z, belief, detection=0.9, clutter=clutter)", ":2")


def nearest_by_hand(z, start, clutter):
    F, H, Q, R = (getattr(boats.plane(), letter) for letter in "FHQR")
    x, P, found = np.array(start, float), np.diag([25.0, 1, 25, 1]), []
    for scan in z:
        x, P = F @ x, F @ P @ F.T + Q
        y, S = scan - H @ x, H @ P @ H.T + R
        nis = np.sum(y @ np.linalg.inv(S) * y, axis=1)
        i = np.argmin(nis)
        if nis[i] <= 9.21:
            K = P @ H.T @ np.linalg.inv(S)
            x, P = x + K @ y[i], P - K @ S @ K.T
        found.append(x[[0, 2]])
    return np.array(found)


def times_S(z, expected, S, detection, clutter):
    nis, b = (z - expected) ** 2 * S, clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * detection) / detection
    e = np.append(b, np.where(nis <= 6.635, np.exp(-nis / 2), 0))
    return e / e.sum()


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("weights", times_S, "as if no reading were in the gate"),
    ("false_in_gate", 0.2, "a gate of 400 m²"),
    ("zeros", [2, 7], "There is no reading 7"),
    ("boat", tracker(nearest, np.inf), "200 m from where the boat must be moves your boat"),
    ("boat", tracker(nearest), "only the nearer one moves your boat"),
    ("boat", tracker(middle), "each has the same weight, as if you took their mean"),
    ("boat", tracker(turned_round), "to the west: the innovation is the reading minus H x"),
    ("boat", with_model(STRAIGHT), "with Q = 0 the gain goes to zero"),
    ("boat", with_model(places_first(), (0, 1), (25, 25, 1, 1)), "is x, v_x, y, v_y, in F and H too"),
    ("boat", first_columns, "take its columns 0 and 2"),
    ("boat", NEAREST, "takes the nearest reading"),
    ("boat", SMALL, "refuses 10 of 100"),
    ("boat", OTHER_H, "H must pick 0 and 2"),
    (
        "zeros",
        {"A": "reading 2", "B": "reading 3"},
        "it is a dictionary of texts: give numbers, without quotation marks",
    ),
    ("false_in_gate", 0.0005 * 2 * np.pi * np.sqrt(36 * 25), "without its last factor"),
    ("boat", nearest_by_hand, "With a row of NaN beside it", "b too large"),
    (
        "boat",
        lambda z, start, clutter: (np.zeros((60, 2)), np.eye(4)),
        "is a tuple of 2 items: one array of shape (60, 2)",
    ),
]
