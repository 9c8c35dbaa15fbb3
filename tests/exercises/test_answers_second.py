"""What answers must get that a third group of strangers handed in, for the second set of their answers."""

import time

import numpy as np
import pytest

from kflearn import bearings, fit, random_walk
from kflearn.exercises import _unknown_receiver as receiver
from kflearn.exercises import _unknown_sensor, _watch
from kflearn.exercises._thrown_ball import KICK, motion
from kflearn.exercises.engine import exercise
from tests.exercises.hand_in import asked, assert_right, assert_told

inv = np.linalg.inv


def written(text, **space):
    """A function as it is written into a cell, whose names are those of the notebook."""
    space = {"np": np, "fit": fit, "random_walk": random_walk, **space}
    exec(text, space)
    return space["answer"]


def search(back=np.exp, log=1.0, nis=1.0):
    """A search for R in the logarithm, with a loop of one's own."""

    def answer(z, Q):
        steps = np.linspace(-5, 8, 300)
        return back(steps[np.argmin([minus_log_likelihood(z, Q, np.exp(step), log, nis) for step in steps])])

    return answer


def minus_log_likelihood(z, Q, R, log, nis):
    first = np.flatnonzero(~np.isnan(z))[0]
    x, P, total = z[first], R, 0
    for seen in z[first + 1 :]:
        P = P + Q
        if not np.isnan(seen):
            S, y = P + R, seen - x
            total += log * np.log(2 * np.pi * S) + nis * y**2 / S
            x, P = x + P / S * y, P * R / S
    return total


def learns(**settings):
    return lambda z, F, Q, mean, cov: _unknown_sensor.learn(z, F, Q, mean, cov, **settings)


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


def four_steps(z, dt):
    return np.append(np.full(5, np.nan), (z[5:] - z[:-5]) / (4 * dt))


def at_the_first(z0, z1, dt, R):
    return [z0, (z1 - z0) / dt], [[R, -R / dt], [-R / dt, 2 * R / dt**2]]


def slow(z):
    return bearings.robust_filter(z[None], 0.2, 2.0, lambda score: 5 / (4 + score))[0]


def with_a_floor(z, g, q, R):
    (F, up), H = motion(g), np.eye(2, 4)
    x, P, rows = np.array([*z[0], 0, 0]), np.diag([R, R, 1e4, 1e4]), []
    rows.append((x, P))
    for seen in z[1:]:
        x, P = F @ x + up, F @ P @ F.T
        P = P + (900 if x[1] > 210 else q) * KICK
        y, S = seen - H @ x, H @ P @ H.T + R * np.eye(2)
        if y @ inv(S) @ y < 11.8:
            K = P @ H.T @ inv(S)
            x, P = x + K @ y, P - K @ S @ K.T
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def last_term(x, P, z, H, R, considered):
    K = P @ H.T / (H @ P @ H.T + R)
    K[considered] = 0
    keep = np.eye(len(P)) - K @ H
    return x + K @ (z - H @ x), keep @ P @ keep.T + K @ K.T


def no_half(dt, mass, c):
    return [[1, dt - c * dt**2 / mass], [0, 1 - c * dt / mass]], [[dt**2 / mass], [dt / mass]]


def follows(dt, mass, c):
    left = np.exp(-c / mass * dt)
    way = (1 - left) * mass / c
    return [[1, way], [0, left]], [[(dt - way) / c], [(1 - left) / c]]


def turned_over(z, H, R):
    I = 1 / np.array(H, float)
    return I @ z, I @ R @ I.T


def exchanged(z, Q, R):
    x, P, rows = z[0], R, [(z[0], R)]
    for seen in z[1:]:
        P = P + R
        if not np.isnan(seen):
            K = P / (P + Q)
            x, P = x + K * (seen - x), (1 - K) * P
        rows.append((x, P))
    return tuple(zip(*rows, strict=True))


def rooted(z):
    mean, cov = receiver.by_differences(z)
    return mean, np.sqrt(abs(cov))


def without_a_corner(P, Q, dt):
    F = np.array([[1, dt], [0, 1]])
    M = F @ P @ F.T
    M[1, 0] = dt * P[1, 1]
    return M + Q


FITTED = "let_the_data_choose.fitted_R"
NOTEBOOK_Z = "def answer(y, Q):\n    return fit(lambda R: random_walk(Q, R), z, {'R': 1.0}).parameters['R']"
RIGHT = [
    ("let_the_data_choose.fitted_R", search()),
    ("adaptive.unknown_sensor", learns(window=30, floor=0.3)),
    ("is_the_filter_honest.draw_start", lambda mean, variances, normal: mean - np.sqrt(variances) * normal),
]
ANSWERS = [
    ("start_here.readings_needed", 16, "2²/0.25 takes the 0.25 m for a variance"),
    ("start_here.three_readings", 63.75, "counts as much as the other two"),
    ("newton_to_state_space.motion", no_half, "the ½ is missing"),
    ("newton_to_state_space.motion", follows, "You solved the differential equation"),
    ("newton_to_state_space.three_sensors", [[60, 0], [6000, 0], [0, 36]], "These look like readings"),
    ("newton_to_state_space.impossible", {"B", "D"}, "are the two that can be right"),
    ("gaussian_fusion.readings_needed", 67, "Precisions add"),
    ("gaussian_fusion.published_claim", lambda p, r: (p / r, p / (p + r), p / r), "mended variance"),
    ("voltmeter.is_unknown", lambda x: not np.all(x), "differs from 0"),
    ("voltmeter.auto_start", lambda z, H, R: (H @ z, inv(H) @ R @ inv(H).T), "applied H once more"),
    ("voltmeter.auto_start", turned_over, "`np.linalg.inv(H)`"),
    ("voltmeter.best_error", 2.83, "Or you took the 4 in both places"),
    ("voltmeter.best_error", 2.47, "comes to"),
    ("voltmeter.best_error", 5**0.5, "with one part weighed"),
    ("voltmeter.whole_filter", exchanged, "You exchanged Q and R"),
    ("tuning_the_ratio.steady_sigma", 0.05**0.5, "√(QR)"),
    ("is_the_filter_honest.nees", lambda e, P: e @ e / np.linalg.det(P), "determinant"),
    (
        "is_the_filter_honest.unknown_sensor",
        lambda z: receiver.run(z, np.var(z))[:2],
        "variance of the readings' errors",
    ),
    (
        "is_the_filter_honest.unknown_sensor",
        lambda z: receiver.run(z, np.mean(np.diff(z) ** 2))[:2],
        "squared differences",
    ),
    ("is_the_filter_honest.unknown_sensor", rooted, "You return the root of P"),
    ("train_and_ship.running_average", four_steps, "five differences"),
    ("train_and_ship.data_sheet", (6 * 1.18) ** 2, "divide, then square"),
    ("train_and_ship.data_sheet", (6 / 2.45) ** 2, "95 % of the fixes"),
    ("train_and_ship.two_point_start", at_the_first, "right there"),
    (
        "extended.true_starts",
        lambda mean, P0, n: mean * (1 + np.sqrt(np.diag(P0)) * n),
        "multiplied the scatter by the mean",
    ),
    ("readings_that_lie.speaker", slow, "later than 30 readings"),
    ("ball_in_a_video.coast", lambda x, P, F, push, Q: (np.zeros(4), F @ P @ F.T + Q), "though the ball flies on"),
    ("ball_in_a_video.thrown_ball", with_a_floor, "there is no floor"),
    ("consider_filter.inflated", 0.09 + 0.25 * 1.951 / 0.049, "memory of the bias"),
    ("consider_filter.first_covariance", [[0.8, -0.8], [-0.8, 1]], "R is left out"),
    ("consider_filter.late_row", last_term, "K R Kᵀ, not K Kᵀ"),
    ("bearing_of_a_sound.offset", lambda x1, K, dt: dt * x1 * (1 - K) / (1 + K), "Below the line stands 1 + K"),
    ("bearing_of_a_sound.right_prediction", without_a_corner, "In the lower left P₁₀ itself is missing"),
    ("let_the_data_choose.one_reading", 0.0726, "probability density itself"),
    ("let_the_data_choose.one_reading", -1.1394, "base of ten"),
    ("let_the_data_choose.one_reading", 0.8237, "sign of the logarithm"),
    ("let_the_data_choose.half_missing", 4 * 2**0.5, "nothing is rooted"),
    ("let_the_data_choose.half_missing", 64, "nothing is squared"),
    ("let_the_data_choose.doubled", {"A"}, "A does not come out wrong"),
    ("let_the_data_choose.fitted_R", search(lambda step: step), "the logarithm of R"),
    ("let_the_data_choose.fitted_R", search(log=2), "also to log 2πS"),
    ("let_the_data_choose.fitted_R", search(log=0), "Is log 2πS in the sum?"),
    ("let_the_data_choose.fitted_R", search(nis=0), "Is y²/S in the sum?"),
    (
        "let_the_data_choose.fitted_R",
        asked("let_the_data_choose.fitted_R").wrong["Q fitted too"][0],
        "if Q is fitted as well",
    ),
    (
        "let_the_data_choose.fitted_R",
        written(NOTEBOOK_Z, z=np.arange(50.0)),
        "reads `z`, which is a name of the notebook",
    ),
    ("let_the_data_choose.fitted_R", lambda z, Q: np.nanvar(np.diff(z)), "2R + Q"),
    ("let_the_data_choose.fitted_R", lambda z, Q: (np.var(np.diff(z)) - Q) / 2, "where the input holds NaN"),
    ("adaptive.unknown_sensor", learns(window=30, floor=0.01), "Give R̂ a floor of 0.05 m² or more"),
    ("adaptive.unknown_sensor", learns(window=150), "until then nothing is learnt"),
    ("adaptive.unknown_sensor", learns(window=1, R=1.0), "of too few squared innovations"),
    ("adaptive.unknown_sensor", variance_of_the_readings, "Is that the variance of the readings?"),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right(name, answer):
    assert_right(name, answer)


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_own_sentence(name, answer, words):
    assert_told(name, answer, words)


def test_nothing_is_said_twice():
    """Two mistakes of one kind have remarks that end alike."""
    two_by_two = lambda P: abs(P[0, 1] - P[1, 0]) < 1e-8 and P[0, 0] >= 0 and np.linalg.det(P[:2, :2]) >= -1e-9  # noqa: E731
    outcome = asked("bearing_of_a_sound.is_a_covariance").check(two_by_two)
    assert outcome.text.count("P may be of any size.") == 1, outcome.text


def test_a_size_that_is_typed_in_is_named():
    answer = written(
        "def answer(x, dx, K, fix):\n    moved = dx + K @ (fix - x[:2] - dx[:2])\n"
        "    return x + (np.arange(9) < 4) * moved, 0 * dx"
    )
    assert "`np.arange(9)` has a fixed size" in asked("error_state_navigation.mended_fix").check(answer).text


def test_the_arguments_have_the_names_that_the_learner_gave_them():
    outcome = asked("let_the_data_choose.fitted_R").check(written(NOTEBOOK_Z, z=np.arange(50.0)))
    assert "It is given y, Q." in outcome.text


def test_no_time_to_explain_is_no_error_of_the_learner(monkeypatch):
    """Whether the explanation takes too long is no matter of the learner's code, which has done its work."""
    monkeypatch.setattr(_watch, "SECONDS", 0.3)

    def endless(x):
        while True:
            time.sleep(0.01)

    @exercise(hints=["A.", "B."], inputs=lambda rng: (int(rng.integers(1, 9)),), wrong={"endless": (endless, "No.")})
    def twice(x):
        """Twice x?"""
        return 2 * x

    outcome = twice.check(lambda x: 2 * x + x**3)
    assert outcome.status == "wrong" and "was expected" in outcome.text, outcome.text


def test_a_hole_is_no_step_that_may_be_cut_off():
    outcome = asked("your_data.clock").check(lambda time, z: (s := np.diff(time[~np.isnan(z)]))[s < 10])
    assert outcome.status != "right"
