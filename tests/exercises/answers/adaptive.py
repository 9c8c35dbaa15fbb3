"""Lesson 22: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import math

import numpy as np

from kflearn import Gaussian, LinearModel, kalman_filter, mmae_filter
from kflearn.exercises import _unknown_sensor as sensor
from kflearn.exercises.adaptive import unknown_sensor


def learnt_Q(z, F, Q, mean, cov):
    """Q grows with the innovations, and R is that of the data sheet."""
    x, P, recent, found = mean, cov, [], []
    for reading in z:
        wide = Q * max(np.mean(recent[-30:]), 1) if len(recent) >= 30 else Q
        x, P = F @ x, F @ P @ F.T + wide
        if not np.isnan(reading):
            y, S = reading - x[0], P[0, 0] + 1
            recent.append(y**2 / S)
            x, P = x + P[:, 0] / S * y, P - np.outer(P[:, 0], P[0]) / S
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def rooted_R(z, F, Q, mean, cov):
    def rule(R, y, explained):
        with np.errstate(invalid="ignore"):
            return max(np.sqrt(0.95 * R**2 + 0.05 * (y * y - explained)), 0.05)

    return sensor.learn(z, F, Q, mean, cov, rule=rule)


def capped(z, F, Q, mean, cov):
    def rule(R, y, explained):
        return min(max(0.95 * R + 0.05 * (y * y - explained), 0.1), 4)

    return sensor.learn(z, F, Q, mean, cov, rule=rule)


def two_gains(z, F, Q, mean, cov):
    """R is learnt for the mean, and P goes on with that of the data sheet."""
    x, P, squares, rows = mean, cov, [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading):
            y = reading - x[0]
            squares.append(y**2)
            R = 1.0 if len(squares) < 30 else max(np.mean(squares[-30:]) - P[0, 0], 0.05)
            x, P = x + P[:, 0] / (P[0, 0] + R) * y, P - np.outer(P[:, 0], P[0]) / (P[0, 0] + 1)
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def of_size_two(p, means, covs):
    P = np.zeros((2, 2))
    for weight, mean, cov in zip(p, means, covs, strict=True):
        P += weight * (np.outer(mean - p @ means, mean - p @ means) + cov)
    return P


def spread_not_weighted(p, means, covs):
    d = means - p @ means
    return np.einsum("m,mij->ij", p, covs) + d.T @ d


def gated(z, F, Q, mean, cov):
    track = kalman_filter(LinearModel(F, [[1, 0]], Q, 1.0), z[:, None], Gaussian(mean, cov), gate=0.9999)
    return track.mean, track.cov


def static(z, F, Q, mean, cov):
    track = mmae_filter([LinearModel(F, [[1, 0]], Q, R) for R in (1, 16)], z[:, None], Gaussian(mean, cov)).filtered
    return track.mean, track.cov


def with_(design, **options):
    return lambda *given: design(*given, **options)


def root(R, y, explained):
    return math.sqrt(0.9 * R**2 + 0.1 * y * y)


def learns(**settings):
    return lambda z, F, Q, mean, cov: sensor.learn(z, F, Q, mean, cov, **settings)


def variance_of_the_readings(z, F, Q, mean, cov):
    x, P, recent, means, covs = mean, cov, [], [], []
    for seen in z:
        x, P = F @ x, F @ P @ F.T + Q
        recent.append(seen)
        if not np.isnan(seen):
            R = np.nanvar(recent[-31:]) if len(recent) > 30 else 1.0
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * (seen - x[0]), P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def tiny(log_weights, log_likelihoods):
    s = log_weights + log_likelihoods
    return s - np.log(np.sum(np.exp(s)) + 1e-300)


def lowest(log_weights, log_likelihoods):
    s = np.maximum(log_weights + log_likelihoods, -700.0)
    return s - np.log(np.exp(s).sum())


def repeated(z, F, Q, mean, cov):
    return np.tile(mean, (len(z), 1)), np.tile(cov, (len(z), 1, 1))


def long_doubles(logs, likelihoods):
    p = np.exp(np.asarray(logs, np.longdouble) + likelihoods)
    return np.log(p / p.sum()).astype(float)


def about_the_likeliest(p, means, covs):
    x = means[np.argmax(p)]
    y = means - x
    return sum(w * (np.outer(d, d) + c) for w, d, c in zip(p, y, covs, strict=True))


def zero_for_NaN(z, F, Q, mean, cov):
    x, P, recent, means, covs = mean, cov, [], [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        recent.append(np.nan_to_num(reading - x[0]))
        R = 1.0 if len(recent) < 30 else max(np.mean(np.square(recent[-30:])) - P[0, 0], 0.05)
        K = P[:, 0] / (P[0, 0] + R)
        x, P = x + K * recent[-1], P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def sum_of_logarithms(log_weights, log_likelihoods):
    total = log_weights + log_likelihoods
    return total - np.log(np.sum(total))


RIGHT = [
    ("unknown_sensor", learns(window=30, floor=0.3)),
    ("unknown_sensor", lambda *given: sensor.learn(*given, window=25, floor=0.3)),
]


def last_thirty(y, H, P):
    y = y[-30:]
    return y.T @ y / len(y) - H @ P @ H.T


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("matrix_R", lambda y, H, P: y.T @ y / len(y) - P, "You took P off C"),
    ("matrix_R", last_thirty, "You use the last 30 innovations only"),
    ("window_needed", 50, "R̂ scatters by S √(2/N) = 0.26 m²"),
    ("unknown_sensor", learnt_Q, "Q is given, and right; what changes is the sensor: learn R"),
    ("unknown_sensor", rooted_R, "or a root, stand in place of a variance"),
    ("unknown_sensor", capped, "a limit holds it"),
    ("unknown_sensor", two_gains, "Use the same R, the learnt one, in both"),
    ("moved_or_noisy", 0.85, "You read the right number"),
    ("moved_or_noisy", "D", "One of the three is right"),
    ("window_needed", 33.8, "0.1 is not"),
    ("window_needed", 30, "the lesson's window"),
    ("mixture_cov", of_size_two, "The size 2 stands in"),
    ("mixture_cov", spread_not_weighted, "how far the means are apart is not"),
    ("unknown_sensor", gated, "of the readings where the sensor is bad"),
    ("unknown_sensor", static, "let a bank change"),
    ("unknown_sensor", with_(sensor.learn, window=100), "a window must be shorter"),
    ("unknown_sensor", with_(sensor.learn, explained=False), "Is HP⁻Hᵀ taken off C, and may R̂ fall"),
    ("unknown_sensor", with_(sensor.learn, rule=root), "Does a standard deviation, or a root"),
    ("unknown_sensor", with_(sensor.learn, window=0, R=4.0), "uses R = 4 m² in every step"),
    ("unknown_sensor", learns(window=30, floor=0.01), "Give R̂ a floor of 0.05 m² or more"),
    ("unknown_sensor", learns(window=150), "until then nothing is learnt"),
    ("unknown_sensor", learns(window=1, R=1.0), "of too few squared innovations"),
    ("unknown_sensor", variance_of_the_readings, "Is that the variance of the readings?"),
    ("weigh", tiny, "as if 1e-300 were added to Σ exp(s)"),
    ("weigh", lowest, "raised to −700 first"),
    ("unknown_sensor", repeated, "no reading is used"),
    ("unknown_sensor", lambda *given: sensor.learn(*given, explained=False), "taken off C"),
    ("unknown_sensor", lambda *given: unknown_sensor._solve(*given)[0], "beside them the covariances"),
    ("weigh", long_doubles, ""),
    ("window_needed", 260, "S stands squared"),
    ("matrix_R", lambda y, H, P: y @ y.T / len(y) - H @ P @ H.T, "`y.T @ y`"),
    ("window_needed", 2 * (1.3 / 0.05) ** 2, "*twice* the standard deviation"),
    ("window_needed", int(np.ceil(2 * (1.3 / (0.1 + 0.3)) ** 2)), "takes nothing off its scatter"),
    ("mixture_cov", about_the_likeliest, "mean of the most probable filter"),
    ("unknown_sensor", zero_for_NaN, "as if something had been read"),
    ("moved_or_noisy", True, "Three answers are offered"),
    ("moved_or_noisy", 967.261, "That is R̂ of the stretch"),
    ("window_needed", round(2 * (1.1 / 0.1) ** 2), "Here S is 1.3"),
    ("weigh", sum_of_logarithms, "add up logarithms"),
    ("unknown_sensor", lambda z, F, Q, mean, cov: np.ones((len(z), 2)), "is one array (200, 2)", "means only"),
]
