"""What answers to exercises of lessons 19 to 28 must get, after a second stranger had handed in theirs."""

import math

import numpy as np
import pytest

from kflearn import Gaussian, LinearModel, kalman_filter, mmae_filter
from kflearn.exercises import _a_ride, _thrown_ball, _unknown_sensor
from kflearn.exercises._a_ride import moving
from kflearn.exercises._answers import fault
from kflearn.exercises._judge import Mark
from kflearn.exercises.adaptive import unknown_sensor
from kflearn.exercises.ball_in_a_video import thrown_ball
from kflearn.exercises.your_data import ride
from tests.exercises.hand_in import asked, assert_right, assert_told

inv = np.linalg.inv
H = np.eye(2, 4)


def of_size_three(x, P, z, H, R, considered):
    K = P @ H.T / (H @ P @ H.T + R)
    K[considered] = 0
    keep = np.eye(3) - K @ H
    return x + K @ (z - H @ x), keep @ P @ keep.T + K @ R @ K.T


def of_size_two(p, means, covs):
    P = np.zeros((2, 2))
    for weight, mean, cov in zip(p, means, covs, strict=True):
        P += weight * (np.outer(mean - p @ means, mean - p @ means) + cov)
    return P


def spread_not_weighted(p, means, covs):
    d = means - p @ means
    return np.einsum("m,mij->ij", p, covs) + d.T @ d


def P_next_in_the_gain(x, P, F, Q, x_next, P_next):
    ahead = F @ P @ F.T + Q
    G = P @ F.T @ inv(P_next)
    return x + G @ (x_next - F @ x), P + G @ (P_next - ahead) @ G.T


def R_off_P_back(x, P, x_back, P_back, z, R):
    Pb = P_back - R
    information = 1 / P + 1 / Pb
    return (x / P + x_back / Pb) / information, 1 / information


def blocks(cross):
    return lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, cross(C, F, fading, q), fading**2 * B + q)


def rest_to_the_newest(K, n):
    w = K * (1 - K) ** np.arange(n)
    w[0] += 1 - w.sum()
    return w


RIGHT = [
    ("error_state_navigation.goes_back", [False, False, True, False, True]),
    ("consider_filter.first_covariance", [[0.952, -0.762], [-0.762, 1]]),
    ("ball_in_a_video.gravity", lambda rows: 0 if np.all(abs(rows - 210) <= 1) else 6),
    ("smoothing.smoothed_cov", lambda P, P_back: P @ inv(P + P_back) @ P_back),
]
ANSWERS = [
    ("ball_in_a_video.coast", lambda x, P, F, push, Q: (F @ x + push, 1e4 * np.eye(len(x))), "threw P away"),
    ("ball_in_a_video.first_velocity", lambda p, s, R, y: s * y / (p + s + R**2), "right for R²"),
    ("error_state_navigation.all_bias", (1 / 0.94 - 1) * 450, "what the sensor shows"),
    ("error_state_navigation.goes_back", [2, 4], "places of two states"),
    ("error_state_navigation.goes_back", [1, 0, 1, 0, 1], "F does not depend on them"),
    ("error_state_navigation.goes_back", [True, False, False, False, False], "Two are missing"),
    ("consider_filter.inflated", 10.092, "memory of the bias"),
    ("consider_filter.first_covariance", [[0.95, -0.76], [-0.76, 1]], "rounded too much: give three digits"),
    ("consider_filter.first_covariance", [[0.952, 0], [0, 0]], "Here the variance of the bias is zero"),
    ("consider_filter.late_row", of_size_three, "You wrote the size 3"),
    ("consider_filter.economical", blocks(lambda C, F, fading, q: fading * F @ C @ F.T), "F stands in C once"),
    ("consider_filter.economical", blocks(lambda C, F, fading, q: fading * F @ C + q), "C gets no noise"),
    ("consider_filter.economical", blocks(lambda C, F, fading, q: fading * F @ C[:, :1]), "one column for each"),
    ("adaptive.window_needed", 33.8, "0.1 is not"),
    ("adaptive.window_needed", 30, "the lesson's window"),
    ("adaptive.mixture_cov", of_size_two, "The size 2 stands in"),
    ("adaptive.mixture_cov", spread_not_weighted, "how far the means are apart is not"),
    ("smoothing.one_step_back", (5.5, 0.75), "known exactly"),
    ("smoothing.step_back", P_next_in_the_gain, "divides by P_next"),
    ("smoothing.smoothed_cov", lambda P, P_back: P @ P_back @ inv(P + P_back), "The order counts"),
    ("smoothing.count_once", R_off_P_back, "You subtracted R from P_back"),
    ("your_data.interval_of_R", (0.061, 0.15), "give three digits"),
    ("your_data.interval_of_R", (1 / 1.4836, 1 / 0.6108), "the factors"),
    ("your_data.clock", lambda time, z: np.diff(time), "steps between all rows"),
    ("your_data.clock", lambda time, z: np.diff(time[z != np.nan]), "NaN differs from everything"),
    ("history.undisturbed", {"A", "B", "C", "D"}, "B was told a large Q"),
    ("history.exponential_weights", rest_to_the_newest, "the missing part went to the newest"),
    ("history.behind", 1.3, "mean innovation"),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right(name, answer):
    assert_right(name, answer)


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_own_sentence(name, answer, words):
    assert_told(name, answer, words)


def test_a_function_without_source_is_not_said_to_compare_with_nan():
    space = {"np": np}
    exec("def answer(time, z):\n    return np.diff(time)", space)
    assert "np.nan" not in asked("your_data.clock").check(space["answer"]).text
    exec("def answer(time, z):\n    return np.diff(time[z != np.nan])", space)
    assert "!= np.nan" in asked("your_data.clock").check(space["answer"]).text


# ---- whole filters


def tracker(z, g, q, R, order=(0, 1, 2, 3), early=False, push=1.0, sign=1.0, shrink=1.0, at=None):
    """A tracker for the ball of lesson 19 with parts that may be wrong."""
    F, up = _thrown_ball.motion(g)
    x, P, rows = np.array([*(z[0] if at is None else at), 0, 0]), np.diag([R, R, 1e4, 1e4]), []
    rows.append((x, P))
    for seen in z[1:]:
        x, P = F @ x + push * up, F @ P @ F.T + q * _thrown_ball.KICK
        ahead = x, P
        y, S = seen - H @ x, H @ P @ H.T + R * np.eye(2)
        if y @ inv(S) @ y < 11.8:
            K = P @ H.T @ inv(S)
            x, P = x + sign * K @ y, P - shrink * K @ S @ K.T
        rows.append(ahead if early else (x, P))
    mean, cov = (np.array(part) for part in zip(*rows, strict=True))
    return mean[:, order], cov[:, order][:, :, order]


def with_(design, **options):
    return lambda *given: design(*given, **options)


def predictions(time, z, q):
    mean, cov = (part.copy() for part in _a_ride.follow(time, z, q))
    for k in range(len(time) - 1, 0, -1):
        F, Q = moving(time[k] - time[k - 1], q)
        mean[k], cov[k] = F @ mean[k - 1], F @ cov[k - 1] @ F.T + Q
    return mean, cov


def flat(d):
    return [[d**4 / 4, d**3 / 2], [d**3 / 2, d**2]]


def gated(z, F, Q, mean, cov):
    track = kalman_filter(LinearModel(F, [[1, 0]], Q, 1.0), z[:, None], Gaussian(mean, cov), gate=0.9999)
    return track.mean, track.cov


def static(z, F, Q, mean, cov):
    track = mmae_filter([LinearModel(F, [[1, 0]], Q, R) for R in (1, 16)], z[:, None], Gaussian(mean, cov)).filtered
    return track.mean, track.cov


def root(R, y, explained):
    return math.sqrt(0.9 * R**2 + 0.1 * y * y)


NAMED = [
    (thrown_ball, with_(tracker, early=True), "these are the predictions"),
    (thrown_ball, with_(tracker, order=[0, 2, 1, 3]), "In another order of your states"),
    (thrown_ball, with_(tracker, push=0), "Gravity is missing"),
    (thrown_ball, with_(tracker, push=0.3), "your state is pushed by"),
    (thrown_ball, with_(_thrown_ball.follow, kick=np.diag([3, 3, 1, 1])), "P grows by"),
    (thrown_ball, with_(tracker, sign=-1), "moves away from the detection"),
    (thrown_ball, with_(tracker, shrink=0), "P stays as it was predicted"),
    (thrown_ball, with_(tracker, at=(0, 0)), "px from the first detection"),
    (thrown_ball, with_(_thrown_ball.follow, given=64.0), "times the R that is given"),
    (thrown_ball, with_(_thrown_ball.follow, wide=0.01), "No start is given"),
    (thrown_ball, lambda *given: tuple(part[1:] for part in tracker(*given)), "has 43 rows for 44 readings"),
    (ride, predictions, "these are the predictions"),
    (ride, with_(_a_ride.follow, push=flat), "one push which lasts the whole step"),
    (ride, with_(_a_ride.follow, R=9.47), "Your R is 9.47 m² in all rides"),
    (ride, with_(_a_ride.follow, dt=1.0), "moves for one second in each step"),
    (ride, with_(_a_ride.follow, gate=np.inf), "uses readings that are far off"),
    (ride, with_(_a_ride.follow, gate=3), "of the good readings"),
    (unknown_sensor, gated, "of the readings where the sensor is bad"),
    (unknown_sensor, static, "let a bank change"),
    (unknown_sensor, with_(_unknown_sensor.learn, window=100), "a window must be shorter"),
    (unknown_sensor, with_(_unknown_sensor.learn, explained=False), "Is HP⁻Hᵀ taken off C, and may R̂ fall"),
    (unknown_sensor, with_(_unknown_sensor.learn, rule=root), "Does a standard deviation, or a root"),
    (unknown_sensor, with_(_unknown_sensor.learn, window=0, R=4.0), "uses R = 4 m² in every step"),
]


@pytest.mark.parametrize(("exercise", "design", "words"), NAMED)
def test_a_design_is_read_from_its_results(exercise, design, words):
    outcome = exercise.check(design)
    assert outcome.status == "wrong" and words in outcome.text, outcome.text


# ---- the engine


def test_a_number_is_told_apart_from_its_bounds():
    mark = Mark("NEES / 4", len, low=0.75, high=1.4)
    assert mark.shown(1.403, False) == "1.403" and mark.shown(1.5, False) == "1.5"
    assert mark.shown(1.4, True) == "1.4"


def test_two_digits_and_booleans_in_arrays():
    say = lambda given, right: fault(given, np.array(right), "it", 2e-3, None, False, by_hand=True)  # noqa: E731
    assert "three digits" in say([0.95, 2.0], [0.952, 2.0])
    assert "differs in 2" in say([0.95, 3.0], [0.952, 2.0])
    assert say([True, False], [1, 0]) is None and "bool" in say([True, False], [1, 2])
