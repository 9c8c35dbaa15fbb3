"""Lesson 7: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn import Gaussian, LinearModel, chi_square_interval, kalman_filter
from kflearn.exercises import _unknown_receiver as receiver


def changing(z):
    """R from each innovation."""
    x, P, rows = receiver.MEAN, receiver.COV, []
    for reading in z:
        x, P = receiver.F @ x, receiver.F @ P @ receiver.F.T + receiver.Q
        y = reading - x[0]
        K = P[:, 0] / (P[0, 0] + max(y**2 - P[0, 0], 4.0))
        x, P = x + K * y, P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def own_start(mean, variances, normal):
    return np.random.default_rng(1).normal(mean, np.sqrt(variances))


def other_start(z):
    model = LinearModel(receiver.F, [[1, 0]], receiver.Q, [[np.var(np.diff(z, 2)) / 6]])
    track = kalman_filter(model, z[:, None], Gaussian([z[0], 0], np.eye(2)))
    return track.mean, track.cov


def scaled(z):
    factor = receiver.run(z, 100.0)[2].mean()
    return receiver.run(z, 100 * factor, factor * receiver.Q)[:2]


def rooted(z):
    mean, cov = receiver.by_differences(z)
    return mean, np.sqrt(abs(cov))


def star(e, P):
    return np.sum(e * np.linalg.inv(P) * e)


def smallest_nis(z):
    """The R of the smallest sum of y²/S, which is the largest one that is tried."""
    tried = [receiver.run(z, sigma**2) for sigma in range(2, 41)]
    return tried[int(np.argmin([np.sum(scores) for *_, scores in tried]))][:2]


inv = np.linalg.inv


def diagonal_matrix(mean, variances, normal):
    return mean + np.diag(np.sqrt(variances)) * normal


def with_its_variances(mean, variances, normal):
    return mean + np.sqrt(variances) * normal, variances


RIGHT = [
    ("draw_start", lambda mean, variances, normal: mean - np.sqrt(variances) * normal),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("unknown_sensor", lambda z: (z, z, 1.0), "is a tuple of 3 items: two arrays are wanted"),
    ("interval", (0.051, 7.378), "the limits for a single run"),
    ("interval", (0.1, 9), "Practically every average lies between these limits"),
    ("unknown_sensor", changing, "an R which changes from reading to reading"),
    ("mystery", "too modest", "Too modest, yes"),
    ("mystery", "Q", "Is Q too large or too small?"),
    ("mystery", "R", "Is R too large or too small?"),
    ("interval", chi_square_interval(2, 50 * 79), "one for each second of 50 voyages"),
    ("nees", lambda e, P: np.sum(np.linalg.inv(P) @ e**2), "as if e were squared first"),
    ("mystery", "Q too large or R too small", "Both agree with the minus sign"),
    ("draw_start", own_start, "Use those in `normal`"),
    ("unknown_sensor", other_start, "does not follow from the start", "every recording get"),
    ("unknown_sensor", scaled, "Only R is unknown", "every recording get"),
    ("unknown_sensor", lambda z: receiver.run(z, np.var(np.diff(z)))[:2], "about 2 times", "own?"),
    ("unknown_sensor", lambda z: receiver.run(z, np.diff(z).std() / 2**0.5)[:2], "the square", "is R"),
    ("unknown_sensor", lambda z: receiver.run(z, np.var(z))[:2], "counted as noise", "own?"),
    ("nees", lambda e, P: e @ e / np.linalg.det(P), "determinant"),
    ("unknown_sensor", lambda z: receiver.run(z, np.var(z))[:2], "variance of the readings' errors"),
    ("unknown_sensor", lambda z: receiver.run(z, np.mean(np.diff(z) ** 2))[:2], "squared differences"),
    ("unknown_sensor", rooted, "You return the root of P"),
    ("mystery", "gain too small", "With a gain (a ratio Q/R) too small"),
    ("mystery", "Q/R too small", "so the gain is too large"),
    ("mystery", "the ratio is low", "name one of the four faults"),
    ("mystery", "K too large", "Which makes it so, Q or R?"),
    ("mystery", "Q/R too large", "Which makes it so, Q or R?"),
    ("mystery", "gain too large, so R too small", "Which makes it so, Q or R?"),
    ("mystery", "R/Q too large", "Name one of the four faults"),
    ("mystery", "both by the same factor", "With Q and R wrong by the same factor"),
    ("nees", star, "as if e were squared first"),
    ("nees", lambda e, P: np.sum(np.diag(np.linalg.inv(P)) * np.asarray(e) ** 2), "the diagonal of P⁻¹, added up"),
    ("interval", (0, 100), "Practically every average lies between"),
    ("interval", (1.6, 2.4), "84.5 % of the averages"),
    ("mystery", "both too large", "far outside ±0.005"),
    ("mystery", "gain too large", "Which makes it so, Q or R?"),
    ("mystery", "right", "1.986 to 2.014"),
    ("unknown_sensor", smallest_nis, "Add log S"),
    ("unknown_sensor", smallest_nis, "1600 m²"),
    ("nees", lambda e, P: e @ inv(P @ P) @ e, "P⁻¹ stands once between the two e"),
    ("share_inside", lambda e, P: 0.683, "what to expect of an honest filter"),
    ("draw_start", lambda m, v, n: np.random.default_rng().normal(m, np.sqrt(v)), "Use those in `normal`"),
    ("unknown_sensor", receiver.FAILING["Q forgotten"], "Is Q added in each", "is R the variance"),
    (
        "unknown_sensor",
        lambda z: (np.stack([z, 0 * z], 1), np.tile(np.eye(2), (100, 1, 1))),
        "are the readings themselves",
        "Does each recording get",
    ),
    ("draw_start", diagonal_matrix, "multiplies entry by entry and leaves a matrix"),
    ("draw_start", with_its_variances, "but it is a tuple of 2 items"),
    (
        "unknown_sensor",
        lambda z: receiver.run(z, np.var(np.diff(z[:5])) / 2)[:2],
        "a factor that is different in each recording",
        "R is too large",
    ),
]
