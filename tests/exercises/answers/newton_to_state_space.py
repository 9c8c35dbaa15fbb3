"""Lesson 1: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from tests.exercises.hand_in import asked


def glued(dt, mass, c):
    F, B = asked("newton_to_state_space.motion")._solve(dt, mass, c)
    return np.hstack([F, B])


def whole_numbers(F, x):
    y = np.zeros(2, dtype=int)
    y[:] = F @ x
    return y


def no_half(dt, mass, c):
    return [[1, dt - c * dt**2 / mass], [0, 1 - c * dt / mass]], [[dt**2 / mass], [dt / mass]]


def follows(dt, mass, c):
    left = np.exp(-c / mass * dt)
    way = (1 - left) * mass / c
    return [[1, way], [0, left]], [[(dt - way) / c], [(1 - left) / c]]


def implicit(dt, mass, c):
    d = 1 / (1 + c * dt / mass)
    F = np.array([[1, dt * (1 + d) / 2], [0, d]])
    return F, np.array([[dt**2 / (2 * mass) * d], [dt / mass * d]])


def no_dt(dt, mass, c):
    F = np.array([[1, dt - c / (2 * mass)], [0, 1 - c / mass]])
    return F, np.array([[dt**2 / 2], [dt]]) / mass


def added(F, x):
    new = list(x)
    for i in range(2):
        for j in range(2):
            new[i] += F[i, j] * x[j]
    return new


def flat(T, sigma):
    G = np.array([T**2 / 2, T])
    return sigma**2 * G @ G.T


def overwritten(F, x):
    y = [0, 0]
    y[0] = F[0, 0] * x[0] + F[0, 1] * x[1]
    y[1] = F[1, 0] * y[0] + F[1, 1] * x[1]
    return y


def half_not_squared(T, sigma):
    return sigma**2 * np.array([[T**4 / 2, T**3 / 2], [T**3 / 2, T**2]])


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("motion", glued, "should be 2 values, an array of shape (2, 2) and an array"),
    ("impossible", "E", "Your answer is the letter E alone"),
    ("overwritten", whole_numbers, "so does an array of whole numbers"),
    ("impossible", "ABCDE", "Not all five. B is possible"),
    ("three_sensors", [[1, 0], [100, 0], [0, 4]], "the row of the speedometer"),
    ("held_push", lambda T, s: s**2 * np.full((2, 2), 4.0), "does not depend on T"),
    ("motion", no_half, "the ½ is missing"),
    ("motion", follows, "You solved the differential equation"),
    ("three_sensors", [[60, 0], [6000, 0], [0, 36]], "These look like readings"),
    ("impossible", {"B", "D"}, "are the two that can be right"),
    ("motion", implicit, "as if the drag belonged to the new velocity"),
    ("motion", no_dt, "In F the drag is right at dt = 1 only"),
    ("overwritten", added, "That is x + F x"),
    ("three_sensors", [[1, 0], [50, 0], [0, 50]], "in centimetres and the speedometer"),
    ("held_push", flat, "np.outer(G, G)"),
    ("overwritten", overwritten, "the new first entry"),
    ("held_push", lambda T, s: s**2 * np.array([[T**2 / 2], [T]]), "That is σ² G, a column"),
    ("held_push", half_not_squared, "the half is squared too"),
]
