"""What answers must get that an eighth group of strangers handed in, and more of their kind."""

import linecache

import numpy as np
import pytest

from kflearn import angle_difference, bearings
from kflearn.exercises._a_boat_signs import takes_the_nearest
from kflearn.exercises._speaker import medians, plain
from tests.exercises.hand_in import asked, assert_right, assert_told

# ---- replies that say another thing than before


def symmetric_first(P, Q, dt):
    F = np.array([[1, dt], [0, 1]])
    return F @ (P + P.T) / 2 @ F.T + Q


def old_innovation(x, P, z, F, H, Q, R):
    ahead = F @ P @ F.T + Q
    K = ahead @ H.T @ np.linalg.inv(H @ ahead @ H.T + R)
    return F @ x + K @ (z - H @ x), (np.eye(len(x)) - K @ H) @ ahead


def two_states(P):
    alike = abs(P[0, 1] - P[1, 0]) < 1e-8
    return alike and P[0, 0] >= 0 and P[1, 1] >= 0 and P[0, 0] * P[1, 1] >= P[0, 1] ** 2


def all_read(x, P, z, H, R):
    S = H @ P @ H.T + R
    K = P @ H.T @ np.linalg.inv(S)
    return x + K @ np.nan_to_num(z - H @ x), P - K @ S @ K.T


def on_the_diagonal(z0, z1, dt, R):
    return np.array([z1, (z1 - z0) / dt]), np.array([[R, R / dt], [R / dt, np.sqrt(2 * R) / dt]])


def spread(x, P, z, H, R):
    seen = ~np.isnan(z)
    h = H[seen]
    S = h @ P @ h.T + R[seen, seen]
    K = P @ h.T @ np.linalg.inv(S)
    return x + K @ (z[seen] - h @ x), P - K @ S @ K.T


TOLD = [
    ("bearing_of_a_sound.right_prediction", symmetric_first, "but you made P, or the result, symmetric", "and then"),
    ("extended.both_humps", (4.4, 11), "11 is the distance of each hump from zero", "11.05"),
    ("extended.both_humps", (4.4, 11.05), "11.05 is √(11² + 1)", "half their distance"),
    ("take_it_home.use_what_is_there", all_read, "the mean is pulled towards H x", "if R is not diagonal"),
    ("take_it_home.use_what_is_there", spread, "The block of R is `R[np.ix_(seen, seen)]`", "several sizes"),
    ("voltmeter.steady_gain", lambda Q, R: np.sqrt((Q / R) ** 2 + 4 * Q / R) - Q / R, "is divided by 2", "Nearly"),
    ("voltmeter.second_gain", 0.408, "P = 2 V² is what the first reading left", "made the start"),
    ("tuning_the_ratio.R_with_drift", lambda z: np.mean(np.diff(z) ** 2), "Halve it", "Nearly"),
    ("predict_correct.misprints", old_innovation, "Use H @ x_pred in the innovation", "must be F @ x"),
    ("bearing_of_a_sound.is_a_covariance", two_states, "of which only the first two states are symmetric", "had to"),
    ("train_and_ship.data_sheet", 6 / 1.18**2, "with the 6 m not squared", "too low"),
    ("train_and_ship.two_point_start", on_the_diagonal, "P holds its square, the variance", "was expected"),
    ("temperature_and_free_fall.suspect", "g is too small", "Read as “g too small”", "among the choices"),
    ("temperature_and_free_fall.suspect", "Q too small", "A wrong Q changes the NIS", "among the choices"),
    ("temperature_and_free_fall.suspect", "nothing is wrong", "Here they average +1.5 m", "among the choices"),
    ("extended.winner", "UKF", "is not one of the two", "among the choices"),
    ("interacting_models.wrong_push", "twice as large", "By no factor", "among the choices"),
    ("smoothing.real_gap", "none", "About two standard errors are a weak sign", "among the choices"),
]


@pytest.mark.parametrize(("name", "answer", "words", "not_said"), TOLD)
def test_an_answer_is_told(name, answer, words, not_said):
    assert_told(name, answer, words)
    assert not_said not in asked(name).check(answer).text


# ---- a speaker among echoes


def running_median(z, window):
    """The lesson's, without SciPy: it unwraps before it sorts."""
    z = np.unwrap(z, period=360)
    return np.array([np.median(z[max(0, k - window + 1) : k + 1]) for k in range(len(z))])


def sorted_raw(z):
    return np.array([np.median(z[max(0, k - 4) : k + 1]) for k in range(len(z))])


def averaged_raw(z):
    return np.array([np.mean(z[max(0, k - 19) : k + 1]) for k in range(len(z))])


SPEAKERS = [
    (lambda z: plain(running_median(z, 5)), "A median of 5 is outvoted by 3 readings of an echo", "raw bearings"),
    (lambda z: running_median(z, window=9), "A median of 9 is outvoted by 5 readings", "raw bearings"),
    (sorted_raw, "You sort raw bearings", "outvoted"),
    (
        lambda z: np.array([np.mean(z[max(0, k - 19) : k + 1]) for k in range(len(z))]),
        "Fed with 359 and 1",
        "median",
    ),
    (plain, "of the way to them", "median"),
    (lambda z: bearings.gated_filter(z[None], 0.2, 2.0, 4, 4, 8).mean[0], "Does it switch too early", "median"),
    (lambda z: medians(61)(z) + 0 * np.mean(z), "behind the walking speaker", "Fed with 359"),
    (lambda z: np.full(len(z), np.mean(z)), "one bearing for a whole recording", "Fed with 359"),
]


@pytest.mark.parametrize(("answer", "words", "not_said"), SPEAKERS)
def test_a_speaker(answer, words, not_said):
    assert_told("readings_that_lie.speaker", answer, words)
    assert not_said not in asked("readings_that_lie.speaker").check(answer).text


def test_ways_round_that_are_right_at_the_edge_of_the_width():
    def apart(one, other):
        return np.degrees(np.angle(np.exp(1j * np.radians(one - other))))

    for way in (angle_difference, apart, lambda one, other: (one - other + 180) % 360 - 180):
        assert_right("readings_that_lie.agreeing", lambda old, z, w, way=way: np.sum(abs(way(old, z)) <= w))


# ---- a boat of which the nearest reading is taken


@pytest.mark.parametrize(("model", "turns"), [("plane", False), ("plane.replace(Q=plane.Q / 9)", True)])
def test_a_boat_that_is_told_of_Q_only_where_it_is_its_own(model, turns):
    code = f"def boat(z, start, clutter):\n    nearest_filter({model}, z)\n"
    space, file = {"nearest_filter": lambda *given: None}, f"<boat {turns}>"
    linecache.cache[file] = (len(code), None, code.splitlines(keepends=True), file)
    exec(compile(code, file, "exec"), space)
    said = takes_the_nearest(space["boat"], [], [])
    assert "Weigh all that are in the gate" in said
    assert ("Q must be large enough" in said) == turns
