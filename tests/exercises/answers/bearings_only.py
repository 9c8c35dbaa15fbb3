"""Lesson 15: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import math

import numpy as np


def from_the_full_circle(east, north):
    angle = np.arctan2(north, east)
    return angle if angle > 0 else 2 * np.pi - angle


def by_arcsin(east, north):
    return np.arcsin(north / np.hypot(east, north)) % (2 * np.pi)


def height_subtracted(east, north):
    return np.arctan2(north - 1000, east) % (2 * np.pi)


def published_R(sd):
    R = 0.1 * np.pi / 180
    return R * sd**2


def quarter_turns(east, north):
    quarter = (0 if east > 0 else 1) if north >= 0 else (3 if east > 0 else 2)
    return quarter * math.pi / 2 + math.atan(north / east)


RIGHT = [
    ("review", "Nothing is wrong"),
    ("review", "(d) Nothing is wrong."),
    ("review", "reviewer D"),
    ("twin_velocity", np.array([[0.0], [-4.0]])),
    ("twin_velocity", [[0, -4]]),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("mended_bearing", from_the_full_circle, "a negative angle is *added* to 2π"),
    ("mended_bearing", by_arcsin, "its mirror image in the east"),
    ("mended_bearing", height_subtracted, "a place 1000 m north of the station"),
    ("bearing_variance", lambda sd: (sd / 360) ** 2, "the variance in full turns, squared"),
    ("bearing_variance", lambda sd: np.radians(sd) ** 2 / 39, "divided by 39"),
    ("bearing_variance", published_R, "0.1 · π/180 times sd²"),
    ("twin_velocity", tuple(3 * (np.array([3, -2]) - [6, 0]) + [6, 0]), "three times the relative one plus ours"),
    ("twin_velocity", (10, 3), "Relative to us that target moves with (4, 3) m/s"),
    ("review", "line 2 lacks the square root", "That is reviewer (a)"),
    ("review", "none of them", "One of the four is right"),
    ("twin_velocity", (6, 4), "minus the target's, doubled"),
    ("bearing_variance", lambda sd: sd**2 * np.pi / 180**2, "with π not squared"),
    ("review", "a, b", "none of these. a: With the root"),
    ("review", "b and c", "b: Try a target due east"),
    ("mended_bearing", quarter_turns, "as without `abs`"),
    ("review", "none", "One of the four is right"),
]
