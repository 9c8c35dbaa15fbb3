"""Answers of lessons 12 to 25 that a stranger handed in: what each of them must get."""

import math

import numpy as np
import pytest

from kflearn.exercises import _thrown_ball, _unknown_sensor
from kflearn.exercises.adaptive import unknown_sensor
from tests.exercises.hand_in import asked

inv = np.linalg.inv


def recognised(rows):
    return 0 if abs(np.median(rows) - 210) < 1 else 6


def within(size):
    return lambda rows: 0 if np.all(abs(np.array(rows) - 210) < size) else 6


def long_doubles(logs, likelihoods):
    p = np.exp(np.asarray(logs, np.longdouble) + likelihoods)
    return np.log(p / p.sum()).astype(float)


def no_Q_in_the_gain(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ inv(F @ P @ F.T)
    return x + G @ (x_next - F @ x), P + G @ (P_next - F @ P @ F.T - Q) @ G.T


def row_put_back(x, P, z, H, R, c):
    K = P @ H.T / (H @ P @ H.T + R)
    part, Q = K.copy(), (np.eye(len(x)) - K @ H) @ P
    part[c], Q[c], Q[:, c] = 0, P[c], P[:, c]
    return x + part @ (z - H @ x), Q


def quarter_turns(east, north):
    quarter = (0 if east > 0 else 1) if north >= 0 else (3 if east > 0 else 2)
    return quarter * math.pi / 2 + math.atan(north / east)


ANSWERS = [
    ("your_data.variance_at_rest", lambda t, z, u: np.nanvar(z[t <= u], ddof=1), "right", ""),
    ("error_state_navigation.all_bias", -27, "right", ""),
    ("ball_in_a_video.gravity", within(1), "right", ""),
    ("adaptive.unknown_sensor", lambda *given: _unknown_sensor.learn(*given, window=25, floor=0.3), "right", ""),
    ("ball_in_a_video.gravity", within(0.9), "wrong", ""),
    ("ball_in_a_video.gravity", within(1.1), "wrong", ""),
    ("ball_in_a_video.gravity", within(2), "wrong", "1.5 px off"),
    ("ball_in_a_video.gravity", recognised, "wrong", "A median near the floor"),
    (
        "ball_in_a_video.thrown_ball",
        lambda *given: _thrown_ball.follow(*given, kick=np.eye(4)),
        "wrong",
        "on its diagonal",
    ),
    ("ball_in_a_video.thrown_ball", _thrown_ball.FAILING["σ for R"], "wrong", "take no root"),
    ("adaptive.unknown_sensor", lambda *given: _unknown_sensor.learn(*given, explained=False), "wrong", "taken off C"),
    ("adaptive.unknown_sensor", lambda *given: unknown_sensor._solve(*given)[0], "wrong", "the covariance is missing"),
    ("adaptive.weigh", long_doubles, "wrong", ""),
    ("adaptive.window_needed", 260, "wrong", "S stands squared"),
    ("adaptive.matrix_R", lambda y, H, P: y @ y.T / len(y) - H @ P @ H.T, "wrong", "`y.T @ y`"),
    ("your_data.clock", lambda t, z: np.round(np.diff(t[~np.isnan(z)]), 1), "wrong", "rounded"),
    ("your_data.milliseconds_for_seconds", 1e-8, "wrong", "1000³ is 10⁹"),
    ("extended.mended_prediction", lambda x, P, u: (x, P * u), "wrong", ""),
    ("bearings_only.mended_bearing", quarter_turns, "wrong", "as without `abs`"),
    ("smoothing.step_back", no_Q_in_the_gain, "wrong", "Your gain is F⁻¹"),
    ("smoothing.one_step_back", (6, 1), "wrong", "right for G = 1"),
    ("smoothing.smoothed_cov", lambda P, B: 1 / (1 / P + 1 / B), "wrong", "entry by entry"),
    ("consider_filter.late_row", row_put_back, "wrong", "as they were before the reading"),
    ("consider_filter.inflated", 0.55, "wrong", "by its standard deviation"),
]


@pytest.mark.parametrize(("name", "answer", "status", "words"), ANSWERS)
@pytest.mark.filterwarnings("ignore:divide by zero")
def test_fresh_answer(name, answer, status, words):
    outcome = asked(name).check(answer)
    assert outcome.status == status, outcome.text
    assert words in outcome.text


def test_a_name_keeps_its_small_letter():
    exercise = asked("linearised_and_extended.linearised_correction")
    text = exercise.check(lambda x, P, reading, nominal: (exercise._solve(x, P, reading, nominal)[0], P)).text
    assert "Your x is right." in text


def test_an_argument_that_cancels_is_not_called_unused():
    exercise = asked("smoothing.step_back")
    cancels = exercise.check(lambda x, P, F, Q, x_next, P_next: (x - x + F @ x_next, P + F @ P_next @ F.T + Q)).text
    assert "does not depend on" not in cancels
    assert "does not depend on" in exercise.check(lambda x, P, F, Q, x_next, P_next: (x_next + x, P_next + P + Q)).text
