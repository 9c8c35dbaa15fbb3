"""What answers to lessons 11 to 29 must get that a tenth group of strangers handed in: their own answers."""

import numpy as np
import pytest

from kflearn import fit, random_walk
from tests.exercises.hand_in import assert_told

# ---- the strangers' own answers, one for each sentence


def report(errors):
    return np.mean(errors, axis=0), np.sqrt(np.mean(np.hypot(errors[:, 0], errors[:, 1])))


def dt_once(z0, z1, dt, R):
    return np.array([z1, (z1 - z0) / dt]), np.array([[R, R], [R, 2 * R / dt]])


def one_step_further(z0, z1, dt, R):
    v = (z1 - z0) / dt
    return np.array([z1 + v * dt, v]), np.array([[5 * R, 3 * R / dt], [3 * R / dt, 2 * R / dt**2]])


def lost_and_left(lasts, sd, dt):
    part = np.exp(-dt / lasts)
    return 1 - part, sd**2 * part**2


def with_the_weights_of_the_covariance():
    Wm = np.array([2 / 3, 1 / 6, 1 / 6])
    Wc = Wm + np.array([1 - 1**2 + 2, 0, 0])
    return Wc @ (100 * np.sin(np.radians(np.array([90, 90 + 30 * np.sqrt(3), 90 - 30 * np.sqrt(3)]))))


def between_runs(z, T):
    speed = np.diff(z[:, 1], axis=0, prepend=z[:1, 0]) / T
    return z[:, 0], np.stack([z[:, 1, 0], speed[:, 0], z[:, 1, 1], speed[:, 1]], axis=-1)


def of_deviations():
    P0, k = np.diag([16.0, 1.0]), 16 / 17.25
    keep = np.array([[1 - k, -k], [0, 1]])
    return keep @ P0 @ keep.T + 0.25 * np.diag([k**2, 0])


def tiny(log_weights, log_likelihoods):
    s = log_weights + log_likelihoods
    return s - np.log(np.sum(np.exp(s)) + 1e-300)


def lowest(log_weights, log_likelihoods):
    s = np.maximum(log_weights + log_likelihoods, -700.0)
    return s - np.log(np.exp(s).sum())


def broken_off(y, S):
    total = 0.0
    for a, b in zip(y, S, strict=True):
        if np.isnan(a):
            break
        total -= 0.5 * (np.log(2 * np.pi * b) + a**2 / b)
    return total


def heights(y, S):
    p = np.exp(-(y**2) / (2 * S)) / np.sqrt(2 * np.pi * S)
    return np.log(np.nansum(p))


def one_S(y, S):
    y = y[~np.isnan(y)]
    S = np.mean(S)
    return -0.5 * (len(y) * np.log(2 * np.pi * S) + np.sum(y**2) / S)


def filled(z, Q):
    return fit(lambda R: random_walk(Q, R), np.nan_to_num(z), {"R": 1.0}).parameters["R"]


def from_one_on(v, late, dt):
    r = [np.corrcoef(v[:-k], late[k:])[0, 1] for k in range(1, 11)]
    return dt * (1 + np.argmax(r))


def by_acceleration(v, late, dt):
    a = np.mean(abs(np.diff(v))) / dt
    return np.mean(v - late) / a


def capped(time, z):
    dt = np.diff(time[~np.isnan(z)])
    return np.where(dt > 5 * np.median(dt), np.median(dt), dt)


ANSWERS = [
    ("train_and_ship.report", report, "the root of the mean distance"),
    ("train_and_ship.two_point_start", dt_once, "one division by dt is missing in the corners"),
    ("train_and_ship.two_point_start", one_step_further, "the belief one dt after the second fix"),
    ("homing_missile.left_over", lambda e, v, t0, t: (e + v * t0) * (t / t0) ** 3, "with (e + v·t₀)/t₀³ for b"),
    ("homing_missile.memory", lambda lasts, sd, dt: (1 - dt / lasts, 2 * sd**2 * dt / lasts), "short steps only"),
    ("homing_missile.memory", lost_and_left, "your second the variance that survives it"),
    ("unscented.three_points", with_the_weights_of_the_covariance(), "the weights of the covariance, Wc"),
    ("interacting_models.mended_start", between_runs, "second reading of the run *before* is subtracted"),
    ("ball_in_a_video.first_velocity", lambda p, s, R, y: np.sqrt(p * s) / (p + s + R) * y, "On top you have √(p·s)"),
    ("ball_in_a_video.gravity", lambda rows: 0 if min(rows) > 209 else 6, "as if only `min(rows) > 209` were asked"),
    (
        "error_state_navigation.dark_time",
        lambda dv, b, allowed: (allowed - dv) / b,
        "the *speed* is wrong by `allowed`",
    ),
    (
        "error_state_navigation.dark_time",
        lambda dv, b, allowed: np.sqrt(2 * allowed / (b + dv)),
        "as if dv were an acceleration too",
    ),
    ("consider_filter.inflated", 0.3**2 + 0.5**2 * (1 - np.exp(-0.1 / 2) ** 2), "0.114 is 0.09 + 0.25 · (1 − φ²)"),
    ("consider_filter.first_covariance", of_deviations(), "right for P⁻ = diag(16, 1)"),
    ("adaptive.weigh", tiny, "as if 1e-300 were added to Σ exp(s)"),
    ("adaptive.weigh", lowest, "raised to −700 first"),
    ("let_the_data_choose.log_likelihood", broken_off, "as if the run ended at the first gap"),
    ("let_the_data_choose.log_likelihood", heights, "the *sum* of the heights"),
    ("let_the_data_choose.log_likelihood", one_S, "the mean of all S"),
    ("let_the_data_choose.half_missing", 4 - 0.5, "3.5 is 4 − ½"),
    ("let_the_data_choose.fitted_R", filled, "a reading of 0 stands in each gap"),
    ("when_was_it.clock_offset", from_one_on, "the shift 0 is not tried"),
    ("when_was_it.clock_offset", by_acceleration, "the mean size of the acceleration"),
    ("your_data.clock", capped, "shortened to the median"),
    ("history.newest_ten", sum(0.15 * 0.85**j for j in range(1, 10)), "0.653 is the sum for j = 1 to 9"),
]


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_an_answer_is_told(name, answer, words):
    assert_told(name, answer, words)
