"""Lesson 10: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn import Gaussian, LinearModel, kalman_filter, rmse
from tests.exercises.hand_in import asked


def room_from(x, P):
    """The room_from's filter from another start."""

    def filtered(z, Q, R, x=x, P=P):
        x = z[0] if x is None else x
        for reading in z[1:]:
            P = P + Q
            K = P / (P + R)
            x, P = x + K * (reading - x), (1 - K) * P
        return x, P

    return filtered


def named(exercise, *names):
    """The right values under names of their own."""
    return lambda *given: dict(zip(names, asked(exercise)._solve(*given), strict=True))


DICTIONARY = "The values are right, but the result is a dictionary: return the values one after the other"


def package(z, Q, R):
    track = kalman_filter(LinearModel([[1]], [[1]], [[Q]], [[R]]), z[1:, None], Gaussian([z[0]], [[R]]))
    return track.mean[-1, 0], track.cov[-1, 0, 0]


def room(z, Q, R, x=None, P=None, end=None, once=False):
    x, P = z[0] if x is None else x, R if P is None else P
    for reading in z[1:end]:
        K = (P + Q) / (P + Q + R)
        x, P = x + K * (reading - x), (1 - K) * (P + Q)
        if once:
            break
    return x, P


def own_noise(normal, Q):
    return np.random.default_rng(3).multivariate_normal([0, 0], Q, normal.shape[1]).T


def below_ground(x, z, mean, ignored, cov):
    above = x[:, 0] > 0
    number = min(above.sum(), len(cov) - 1)
    return rmse(mean[above, 0], x[above, 0]), rmse(ignored[above, 0], x[above, 0]), np.sqrt(cov[number, 1, 1])


def late_Q(x, P, room, reading, Q, R):
    K = P / (P + R)
    x = x + K * (reading - x)
    P = (1 - K) * P + Q
    return x, np.sqrt(P)


def from_the_mean(z, Q, R):
    x, P = np.mean(z), R / len(z)
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x = x + K * (reading - x)
        P = (1 - K) * P
    return x, P


def once(z, Q, R):
    x, P = z[0], R
    for reading in z[1:]:
        P = P + Q
        K = P / (P + R)
        x = x + K * (reading - x)
    return x, (1 - K) * P


def still_counted(x, z, mean, ignored, cov):
    up = (x[:, 0] > 0).astype(float)
    last = np.flatnonzero(up)[-1]
    a = np.sqrt(np.mean(up * (mean[:, 0] - x[:, 0]) ** 2))
    b = np.sqrt(np.mean(up * (ignored[:, 0] - x[:, 0]) ** 2))
    return a, b, np.sqrt(cov[last, 1, 1])


def drawn(normal, Q):
    return np.random.default_rng(0).multivariate_normal([0, 0], Q, normal.shape[1]).T


def old_P(x, P, room, reading, Q, R):
    K = (P + Q) / (P + Q + R)
    return x + K * (reading - x), np.sqrt((1 - K) * P)


RIGHT = [
    ("room_filter", package),
    ("suspect", "g is too large"),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("suspect", "g is too small", "the filter expects the stone too high", "among the choices"),
    ("suspect", "Q too small", "A wrong Q changes the NIS", "among the choices"),
    ("suspect", "nothing is wrong", "Here they average +1.5 m", "among the choices"),
    ("room_filter", room_from(24.9, 0.25), "Your filter starts at 24.9 °C, with P = 0.25"),
    ("room_filter", room_from(None, 0.375), "You start with P = 0.375, whatever R is"),
    ("honest_report", named("temperature_and_free_fall.honest_report", *"abc"), DICTIONARY),
    ("room_filter", lambda *given: room(*given, x=0.0), "You start at 0 °C"),
    ("room_filter", lambda z, Q, R: room(z, Q, R, P=R**2), "You start with R²"),
    ("room_filter", lambda *given: room(*given, once=True), "inside the loop"),
    ("room_filter", lambda *given: room(*given, end=-1), "last reading is left out"),
    ("noise", own_noise, "Use those in `normal`"),
    ("noise", lambda normal, Q: np.sqrt(np.diag(Q)) * normal, "As a column"),
    ("honest_report", below_ground, "first moment underground"),
    ("mended_step", late_Q, "as if Q were added after the correction"),
    ("room_filter", from_the_mean, "R over the number of readings"),
    ("room_filter", once, "multiplied by 1 − K at the end only"),
    ("noise", lambda normal, Q: normal + np.sqrt(np.diag(Q))[:, None], "the random numbers plus the deviations"),
    ("honest_report", still_counted, "the number of *all* moments"),
    ("suspect", "gravity too small", "Read as “g too small”"),
    ("noise", drawn, "Use those in `normal`"),
    ("mended_step", old_P, "the P that came in"),
    ("noise", lambda normal, Q: np.sqrt(Q) * normal, "`*` multiplies entry by entry"),
    ("suspect", "g", "one of the two halves", "not among"),
    ("suspect", "too large", "which of the two can push them there", "not among"),
    ("suspect", "wrong sign of g", "the readings would lie below", "not among"),
]
