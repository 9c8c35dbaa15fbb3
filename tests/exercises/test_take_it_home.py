"""Lesson 29: right answers in other forms, wrong ones with their sentences, and what it says of the libraries."""

import numpy as np
import pykalman
import pytest
import simdkalman

from tests.exercises.hand_in import asked, assert_right, assert_told

SENSORS = {"A": [[1, 0]], "B": [[0, 1]], "C": [[1, 0], [0, 1]], "D": [[-1, 0]], "E": [[0, 1], [1, 0]]}


def joseph(x, P, z, H, R):
    seen = np.flatnonzero(np.isfinite(z))
    H, R = H[seen], R[seen][:, seen]
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    A = np.eye(len(x)) - K @ H
    return [x + K.dot(z[seen] - H.dot(x)), A @ P @ A.T + K @ R @ K.T]


def asks_first(x, P, z, H, R):
    if np.isnan(z).all():
        return x, P
    return joseph(x, P, z, H, R)


def information(x, P, z, H, R):
    seen = ~np.isnan(z)
    weight = H[seen].T @ np.linalg.inv(R[np.ix_(seen, seen)])
    after = np.linalg.inv(np.linalg.inv(P) + weight @ H[seen])
    return after @ (np.linalg.inv(P) @ x + weight @ z[seen]), after


def very_uncertain(x, P, z, H, R):
    """What was not read gets a variance so large that it counts nothing: right to nine digits."""
    R = R + np.diag(np.where(np.isnan(z), 1e12, 0))
    return joseph(x, P, np.nan_to_num(z), H, R)


RIGHT = {
    "start_covariance": [[[8, 2], [2, 2]], np.array([[8.0, 2], [2, 2]]), ((8, 2), (2, 2))],
    "with_the_constant": [-104.9, -104.915, -31.4 - 40 * np.log(2 * np.pi), -31.4 - 80 * 0.919],
    "use_what_is_there": [joseph, asks_first, information, very_uncertain],
    "own_start": ["BDE", {"B", "D", "E"}, ["E", "D", "B"], "b, d, e", "B, D and E"],
}


@pytest.mark.parametrize("name", RIGHT)
def test_right_forms_pass(name):
    for answer in RIGHT[name]:
        assert_right(f"take_it_home.{name}", answer)


def diagonal_inverted(x, P, z, H, R):
    seen = ~np.isnan(z)
    H, R = H[seen], R[seen, seen]
    K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R)
    return x + K @ (z[seen] - H @ x), P - K @ H @ P


def diagonal_solved(x, P, z, H, R):
    seen = ~np.isnan(z)
    H, R = H[seen], R[seen, seen]
    K = np.linalg.solve(H @ P @ H.T + R, H @ P).T
    return x + K @ (z[seen] - H @ x), P - K @ H @ P


SAID = [
    ("start_covariance", [[4, 0], [0, 1]], "predict once"),
    ("start_covariance", [[4, 10], [0, 2]], "transposed"),
    ("with_the_constant", 42.1, "the sign is not"),
    ("with_the_constant", -68.2, "one for each whole row"),
    ("use_what_is_there", lambda x, P, z, H, R: joseph(x, P, np.nan_to_num(z), H, R), "put 0 in place of NaN"),
    ("use_what_is_there", lambda x, P, z, H, R: (x, P), "as it came in"),
    ("use_what_is_there", diagonal_inverted, "R came in as a vector"),
    ("use_what_is_there", diagonal_solved, "R came in as a vector"),
    ("with_the_constant", -77.3, "each of the 50 rows"),
    ("with_the_constant", -71.8, "each of 44 rows"),
    ("with_the_constant", -114.1, "one number in each of the ten rows"),
    (
        "start_covariance",
        np.array([[1, 2], [0, 1]]) * np.diag([4, 1]) * np.array([[1, 0], [2, 1]]) + np.diag([0, 1]),
        "`@`",
    ),
    ("own_start", {"B"}, "D is missing"),
    ("own_start", {"A", "B", "D", "E"}, "A has 1 on its diagonal"),
]


@pytest.mark.parametrize(("name", "answer", "words"), SAID, ids=[f"{row[0]}-{i}" for i, row in enumerate(SAID)])
def test_wrong_answers_get_their_sentence(name, answer, words):
    assert_told(f"take_it_home.{name}", answer, words)


def test_the_librarys_own_starts_are_those_of_the_hunt():
    found = set()
    for letter, H in SENSORS.items():
        kf = simdkalman.KalmanFilter(np.eye(2), np.eye(2), H, np.eye(len(H)))
        done = kf.compute(np.full((1, 1, len(H)), np.nan), 0, filtered=True)
        variance = done.filtered.states.cov[0, 0, 0, 0]
        assert variance == 25 * np.trace(H)
        found |= {letter} if variance <= 0 else set()
    assert found == asked("take_it_home.own_start")._solve()


@pytest.mark.parametrize("R", [1, 20, 30, 100])
def test_what_a_start_with_a_negative_variance_makes_of_a_depth(R):
    kf = simdkalman.KalmanFilter([[1, 1], [0, 1]], 0.01 * np.eye(2), SENSORS["D"], R)
    first = kf.compute(np.full((1, 1), -10.0), 0, filtered=True).filtered.states.mean[0, 0, 0]
    assert first > 10 if R < 25 else first < 0


def test_pykalman_takes_one_offset_too_many_and_begins_with_the_first():
    told = dict(initial_state_mean=[0.0], initial_state_covariance=[[1.0]])
    offsets, readings = np.array([[3.0], [5.0], [7.0]]), np.ma.masked_all((3, 1))
    kf = pykalman.KalmanFilter([[1]], [[1]], [[1]], [[1]], transition_offsets=offsets, **told)
    assert kf.filter(readings)[0].ravel().tolist() == [0, 3, 8]


def test_the_constant_of_simdkalman_is_that_of_the_exercise():
    z = np.random.default_rng(29).normal(size=(50, 2))
    z[:6], z[6:10, 1] = np.nan, np.nan
    done = simdkalman.KalmanFilter(np.eye(2), np.eye(2), np.eye(2), np.eye(2)).compute(
        z[None], 0, np.zeros(2), np.eye(2), log_likelihood=True
    )
    whole = np.ma.masked_invalid(z)
    theirs = pykalman.KalmanFilter(np.eye(2), np.eye(2), np.eye(2), np.eye(2)).loglikelihood(whole)
    assert np.isclose(theirs - done.log_likelihood[0], -40 * np.log(2 * np.pi), rtol=0, atol=1e-10)
