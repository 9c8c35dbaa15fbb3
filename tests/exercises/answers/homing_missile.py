"""Lesson 16: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np


def another_t0(e, v, t0, t):
    t0 = 3.7
    b = -(v + e / t0) / (2 * t0**2)
    return (e / t0 - b * t0**2) * t + b * t**3


def time_gone(e, v, t0, t):
    b = -(v + e / t0) / (2 * t0**2)
    return (e / t0 - b * t0**2) * (t0 - t) + b * (t0 - t) ** 3


def H_forgotten(sigma, turn, across):
    H = np.sin(np.radians(turn))
    K = sigma**2 * H / (H**2 * sigma**2 + across**2)
    return np.sqrt(abs((1 - K) * sigma**2))


def mean_distances(error):
    return [np.sqrt(np.linalg.norm(error[..., k : k + 3], axis=-1).mean(axis=0)) for k in (0, 3, 6)]


def lost_and_left(lasts, sd, dt):
    part = np.exp(-dt / lasts)
    return 1 - part, sd**2 * part**2


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("start_sigma", 250, "the NEES is 5.47, where 3 is wanted"),
    ("left_over", another_t0, "does not depend on t0"),
    ("left_over", lambda e, v, t0, t: e * t / t0 + v * (t / t0) ** 3, "With t = t₀ that is e + v, metres plus"),
    ("left_over", time_gone, "the time that has passed"),
    ("false_range", H_forgotten, "That is √((1 − K)·P)"),
    ("figures", mean_distances, "the mean *distance*"),
    ("left_over", lambda e, v, t0, t: (e + v * t0) * (t / t0) ** 3, "with (e + v·t₀)/t₀³ for b"),
    ("memory", lambda lasts, sd, dt: (1 - dt / lasts, 2 * sd**2 * dt / lasts), "short steps only"),
    ("memory", lost_and_left, "your second the variance that survives it"),
]
