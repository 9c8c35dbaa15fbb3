"""Right answers of lessons 0 to 6 in the forms that learners give them: all must pass."""

import math
from fractions import Fraction

import numpy as np
import pytest

from tests.exercises.hand_in import asked

inv = np.linalg.inv
K = 0.2207


def joseph(x, P, z, H, R):
    S = H @ P @ H.T + R
    K = np.linalg.solve(S.T, (P @ H.T).T).T
    A = np.eye(len(x)) - K @ H
    return x + K @ (z - H @ x), A @ P @ A.T + K @ R @ K.T


def info(x, P, z, H, R):
    Pn = inv(inv(P) + H.T @ inv(R) @ H)
    return Pn @ (inv(P) @ x + H.T @ inv(R) @ z), Pn


def loopw(K, n):
    w = [1.0]
    for _ in range(n - 1):
        w = [(1 - K) * a for a in w]
        w.insert(0, K)
    return w


def rest(tol, start):
    def f(Q, R):
        P = start(Q, R)
        old = None
        k = 0
        while True:
            P = P + Q
            k = P / (P + R)
            P = (1 - k) * P
            if old is not None and abs(k - old) < tol:
                return k
            old = k

    return f


def steps(N, start):
    def f(Q, R):
        P = start(Q, R)
        for _ in range(N):
            P = (P + Q) * R / (P + Q + R)
        return P / R

    return f


def mis(x, P, z, F, H, Q, R):
    xp = F.dot(x)
    Pp = F.dot(P).dot(F.T) + Q
    return joseph(xp, Pp, z, H, R)


RIGHT = {
    "start_here.three_readings": [63, 63.0, np.mean([61, 62, 66]), Fraction(63)],
    "start_here.readings_needed": [64, 64.0, (2 / 0.25) ** 2, np.float64(64)],
    "start_here.update_mean": [
        lambda m, n, z: ((n - 1) * m + z) / n,
        lambda a, b, c: (1 - 1 / b) * a + c / b,
        lambda m, n, z: m - (m - z) / n,
    ],
    "start_here.data_sheet": [9, 9.0, 9.37, 9.371, 9.4, (6 / 1.96) ** 2, 3**2],
    "start_here.root_mean_square": [
        lambda e: np.linalg.norm(e) / np.sqrt(len(e)),
        lambda e: math.sqrt(sum(v * v for v in e) / len(e)),
        lambda e: (e @ e / e.size) ** 0.5,
    ],
    "history.undisturbed": [{"A", "D"}, "AD", "A and D", ["D", "A"], "a, d"],
    "history.newest_ten": [0.803, 0.8031, 1 - 0.85**10, sum(0.15 * 0.85**j for j in range(10))],
    "history.exponential_weights": [
        loopw,
        lambda K, n: [K * (1 - K) ** j for j in range(n - 1)] + [(1 - K) ** (n - 1)],
    ],
    "history.behind": [1.06, 1.059, 0.3 * (1 - K) / K, 0.3 / K - 0.3],
    "history.mended": [
        lambda z, K: np.average(z, weights=(1 - K) ** np.arange(len(z))[::-1]),
        lambda z, K: sum(K * (1 - K) ** (len(z) - 1 - i) * v for i, v in enumerate(z)) / (1 - (1 - K) ** len(z)),
    ],
    "newton_to_state_space.motion": [
        lambda dt, m, c: ([[1, dt - c * dt * dt / 2 / m], [0, 1 - c * dt / m]], [[dt * dt / 2 / m], [dt / m]]),
        lambda T, M, c: ([[1, T - c * T**2 / M / 2], [0, 1 - c * T / M]], np.array([[T / 2], [1]]) * T / M),
    ],
    "newton_to_state_space.three_sensors": [[[1, 0], [100, 0], [0, 3.6]], np.array([[1, 0], [100, 0], [0, 3.6]])],
    "newton_to_state_space.impossible": ["ACE", "A, C and E", {"A", "C", "E"}, ["A", "C", "E"], "a c e"],
    "newton_to_state_space.overwritten": [
        lambda F, x: [F[0, 0] * x[0] + F[0, 1] * x[1], F[1, 0] * x[0] + F[1, 1] * x[1]],
        lambda F, x: np.dot(F, x),
    ],
    "newton_to_state_space.held_push": [
        lambda T, s: s**2 * np.array([[T**4 / 4, T**3 / 2], [T**3 / 2, T**2]]),
        lambda T, s: (lambda g: np.outer(g, g) * s * s)(np.array([T * T / 2, T])),
    ],
    "predict_correct.predicted_covariance": [[[22, 7], [7, 4]], np.array([[22.0, 7], [7, 4]])],
    "predict_correct.correct": [
        joseph,
        info,
        lambda x, P, z, H, R: [
            x + P @ H.T @ inv(H @ P @ H.T + R) @ (z - H @ x),
            P - P @ H.T @ inv(H @ P @ H.T + R) @ H @ P,
        ],
    ],
    "predict_correct.printed_position": ["ABC", "A, B and C", {"A", "B", "C"}, ["a", "b", "c"], "A,B,C"],
    "predict_correct.misprints": [mis],
    "gaussian_fusion.third_opinion": [62.4, 62.41, 62.414, 61.6667 + 0.1724 * 4.3333, 61.6667 + 0.172 * 4.3333],
    "gaussian_fusion.fuse": [
        lambda a, p, b, q: ((a * q + b * p) / (p + q), 1 / (1 / p + 1 / q)),
        lambda a, p, b, q: [(a / p + b / q) / (1 / p + 1 / q), p * q / (p + q)],
        lambda a, p, b, q: np.array([(a * q + b * p) / (p + q), p * q / (p + q)]),
    ],
    "gaussian_fusion.readings_needed": [11, 11.0, math.ceil(1 / 0.09 - 0.2)],
    "gaussian_fusion.published_claim": [lambda p, q: (p / q, p / (p + q), 1 + p / q)],
    "gaussian_fusion.common_cause": [lambda P, R, c: 1 - (R - c) / (P + R - 2 * c)],
    "voltmeter.second_gain": [5 / 14, 0.357, 0.3571, 10 / 28, Fraction(5, 14)],
    "voltmeter.steady_gain": [
        lambda Q, R: (math.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R) / 2,
        steps(100, lambda Q, R: R),
        steps(200, lambda Q, R: 1.0),
        steps(300, lambda Q, R: 0.0),
        steps(100, lambda Q, R: 1000.0),
        steps(100, lambda Q, R: 0.0),
        rest(1e-6, lambda Q, R: R),
        rest(1e-9, lambda Q, R: 1.0),
        rest(1e-8, lambda Q, R: R),
        rest(1e-5, lambda Q, R: R),
        lambda Q, R: max(np.roots([1, Q / R, -Q / R])),
    ],
    "voltmeter.is_unknown": [
        lambda x: np.any(np.isnan(x)),
        lambda x: bool(np.isnan(np.sum(x))),
        lambda x: any(v != v for v in x),
        lambda x: (x != x).any(),
        lambda x: not np.isfinite(x).all(),
        lambda x: any(np.isnan(v) for v in x),
    ],
    "voltmeter.auto_start": [
        lambda z, H, R: (inv(H) @ z, inv(H.T @ inv(R) @ H)),
        lambda z, H, R: [np.linalg.solve(H, z), inv(H) @ R @ np.transpose(inv(H))],
    ],
    "voltmeter.best_error": [1.41, 1.414, math.sqrt(2), 2**0.5],
    "tuning_the_ratio.steady_sigma": [0.213, 0.2127, 0.2128, math.sqrt(0.181 * 0.25), math.sqrt(0.1810 * 0.25)],
    "tuning_the_ratio.data_sheets": [
        [6.25, 0.09, 0.0208],
        (6.25, 0.0937, 0.0208),
        [6.25, 0.094, 0.0208],
        [6.25, 0.0937, 1 / 48],
        [6.25, 0.09, 0.0208333],
        [6.25, (0.6 / 1.96) ** 2, 0.0208],
    ],
    "tuning_the_ratio.which_knob": ["C", "c", "C)", "c.", ["C"], {"C"}],
    "tuning_the_ratio.three_sigma": [
        lambda z: np.std(z) ** 2,
        lambda z: np.var(z, ddof=1),
        lambda z: np.mean((z - z.mean()) ** 2),
        lambda z: np.cov(z),
    ],
    "tuning_the_ratio.R_with_drift": [
        lambda z: np.var(np.diff(z)) / 2,
        lambda z: np.std(np.diff(z)) ** 2 / 2,
        lambda z: (np.std(np.diff(z)) / np.sqrt(2)) ** 2,
        lambda z: np.sum(np.diff(z) ** 2) / 2 / (len(z) - 1),
        lambda z: np.sum(np.diff(z) ** 2) / 2 / len(z),
        lambda z: np.var(np.diff(z), ddof=1) / 2,
        lambda z: np.mean((z[1:] - z[:-1]) ** 2) / 2,
    ],
}


@pytest.mark.parametrize("name", RIGHT)
def test_right_forms_pass(name):
    outcomes = [asked(name).check(answer) for answer in RIGHT[name]]
    assert [outcome.text for outcome in outcomes if outcome.status != "right"] == []


WRONG = {
    "voltmeter.is_unknown": [lambda x: np.isnan(x[0]) or np.isnan(x[-1]), lambda x: np.isnan(x[:2]).any()],
    "predict_correct.correct": [lambda x, P, z, H, R: (x, (np.eye(2) - np.eye(2)) @ P)],
    "start_here.root_mean_square": [lambda error: np.sqrt(np.sum(error**2) / 6)],
    "tuning_the_ratio.three_sigma": [lambda z: np.sum((z - np.mean(z)) ** 2) / 300],
    "tuning_the_ratio.R_with_drift": [lambda z: np.sum(np.diff(z) ** 2) / 2 / 399],
    "tuning_the_ratio.data_sheets": [[6.3125, 0.0909, 0.02104]],
    "start_here.data_sheet": [9.2],
    "history.behind": [1.07],
    "voltmeter.best_error": [1.42],
}


@pytest.mark.parametrize("name", WRONG)
def test_what_was_accepted_once_is_refused(name):
    assert all(asked(name).check(answer).status in ("wrong", "raised") for answer in WRONG[name])


def compares(x):
    return (x == np.nan).any()


def asks_too_late(x):
    return np.isnan(np.any(x))


def asks_for_none(x):
    return x is None


def test_who_has_not_compared_hears_nothing_of_equality():
    each = asked("voltmeter.is_unknown")
    assert "x == np.nan" in each.check(compares).text
    assert all("==" not in each.check(answer).text for answer in (asks_too_late, asks_for_none))
