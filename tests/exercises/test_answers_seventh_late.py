"""What answers to lessons 10 to 29 must get that a seventh group of strangers handed in, and more of their kind."""

import numpy as np
import pytest

from kflearn.exercises import _a_boat, _unknown_sensor_signs
from kflearn.exercises._a_stream_late import step_to
from kflearn.exercises._answers import fault
from kflearn.exercises._cart_with_gaps import motion
from kflearn.exercises._results import of_gaps
from kflearn.exercises._words import one_of
from tests.exercises.hand_in import asked, assert_right, assert_told


def test_a_loop_over_the_time_gets_the_sentence_of_the_squares():
    def tried(dv, b, allowed):
        t = 0.0
        while np.hypot(dv * t, b * t**2 / 2) < allowed:
            t += 0.01
        return t

    assert_told("error_state_navigation.dark_time", tried, "Squares add where errors are independent")


ANSWERS = [
    (
        "error_state_navigation.dark_time",
        lambda dv, b, allowed: abs((-dv - np.sqrt(dv**2 + 2 * b * allowed)) / b),
        "or is it the other root, with its sign dropped? Take (−dv + √…)/b",
    ),
    (
        "error_state_navigation.dark_time",
        lambda dv, b, allowed: (dv + np.sqrt(dv**2 + 2 * b * allowed)) / b,
        "Has dv the wrong sign, or",
    ),
    ("bearings_only.review", "a, b", "none of these. a: With the root"),
    ("bearings_only.review", "b and c", "b: Try a target due east"),
    ("let_the_data_choose.doubled", "B", 'several are handed in as one text, such as "XY"'),
    ("let_the_data_choose.doubled", "A", 'several are handed in as one text, such as "XY"'),
    ("history.undisturbed", "A", 'several are handed in as a set, such as {"X", "Y"}'),
    ("take_it_home.own_start", "B", 'several are handed in as a set, such as {"X", "Y"}'),
    (
        "whose_is_it.zeros",
        {"A": "reading 2", "B": "reading 3"},
        "it is a dictionary: give the numbers alone, without names, in the order of the question, as in `[1, 2]`",
    ),
    (
        "let_the_data_choose.fitted_R",
        lambda z, Q: (np.var(np.diff(z[~np.isnan(z)])) - Q) / 2,
        "Over a gap the walk makes more than one step",
    ),
    ("let_the_data_choose.fitted_R", lambda z, Q: 1.7 * np.nanvar(np.diff(z)), "both parts, log 2πS and y²/S?"),
]


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_an_answer_is_told(name, answer, words):
    assert_told(name, answer, words)


def test_right_answers_of_these_kinds():
    for answer in ("BC", "B, C", "B and C", {"B", "C"}, ["C", "B"]):
        assert_right("let_the_data_choose.doubled", answer)
    assert_right("whose_is_it.zeros", {"A": 2, "B": 3})
    assert "best across the line of sight" in asked("bearings_only.twin_velocity").check((0, -4)).text


def test_two_wrong_choices_get_their_reasons_and_three_do_not():
    wrong = {"one": ("a", "It bends."), "two": ("b", "It is late."), "three": ("c", "It is early.")}
    assert one_of({"a", "b"}, {"d"}, set("abcd"), wrong).endswith("a: It bends. b: It is late.")
    assert one_of({"a", "b", "c"}, {"d"}, set("abcde"), wrong).endswith("none of these.")
    assert one_of({"a", "d"}, {"d"}, set("abcd"), wrong).endswith("among these.")


def test_a_dictionary_is_called_a_dictionary():
    for right, words in ((np.eye(2), "in the order of the question."), (np.array([1.0, 5.0]), "as in `[1, 2]`.")):
        said = fault({"x": "one", "y": "two"}, right, "your answer", 1e-3, None, False, by_hand=True)
        assert "it is a dictionary" in said
        assert said.endswith(words)


# ---- open exercises


def cart(speed=9.0, R=1.0, late=False):
    """The cart's filter, which returns the belief before each reading; or uses each reading one step late."""

    def follow(z, dt, sd, sigma):
        (F, Q), x, P = motion(dt, sd), np.array([z[0], 0.0]), np.diag([sigma**2, speed])
        means, covs = [x], [P]
        for reading in z[:-1] if late else z[1:]:
            x, P = F @ x, F @ P @ F.T + Q
            before = x, P
            if not np.isnan(reading):
                K = P[:, 0] / (P[0, 0] + R * sigma**2)
                x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
            means.append(x if late else before[0])
            covs.append(P if late else before[1])
        return np.array(means), np.array(covs)

    return follow


def test_a_cart_whose_predictions_are_returned():
    name, right = "train_and_ship.cart_with_gaps", "Your filter itself is right: append x and P after the correction"
    assert_told(name, cart(), right)
    for other in (cart(speed=900.0), cart(R=0.2), cart(late=True)):
        assert_told(name, other, "does not depend on the reading of that step")
        assert right not in asked(name).check(other).text


def stream(first, newest_first=False):
    """A filter for a stream that sorts all readings; first: what is done first in a row, "use" or "return"."""

    def follow(now, t, z, H, R, q, mean, cov):
        log, kept = [], []
        for k in range(len(now)):
            reading = [(t[k], z[k], H[k], R[k])] if not np.isnan(z[k]) else []
            log += reading if first == "use" else []
            younger = [each for each in log if each[0] > t[k]]
            order = sorted((each for each in log if each[0] <= t[k]), key=lambda each: each[0])
            order += sorted(younger, key=lambda each: each[0], reverse=newest_first)
            x, P, last = mean, cov, 0.0
            for at, value, h, r in order:
                x, P = step_to((last, x, P), at, q)
                K, last = P @ h / (h @ P @ h + r), at
                x, P = x + K * (value - h @ x), P - np.outer(K, h @ P)
            kept.append(step_to((last, x, P), now[k], q))
            log += reading if first == "return" else []
        return tuple(np.array(part) for part in zip(*kept, strict=True))

    return follow


def test_a_stream():
    assert_right("when_was_it.live", stream("use"))
    assert_told("when_was_it.live", stream("return"), "does not depend on the reading of that row")
    assert_told("when_was_it.live", stream("use", newest_first=True), "Is one of your steps negative?")


def boat_with_nan(z, start, clutter):
    """The PDA, in which the rows of NaN are not left out."""
    F, H, Q, R = _a_boat.PLANE.F, _a_boat.PLANE.H, _a_boat.PLANE.Q, _a_boat.PLANE.R
    x, P, found = start, np.diag([25.0, 1, 25, 1]), []
    for scan in z:
        x, P = F @ x, F @ P @ F.T + Q
        S, y = H @ P @ H.T + R, scan - H @ x
        e = np.exp(-np.einsum("ij,jk,ik->i", y, np.linalg.inv(S), y) / 2)
        x = x + P @ H.T @ np.linalg.inv(S) @ (e / (0.01 + e.sum()) @ y)
        found.append(x[[0, 2]])
    return np.array(found)


def test_a_boat():
    name = "whose_is_it.boat"
    assert_told(name, boat_with_nan, "not finite at scan 1. This scan holds rows of NaN, which are no readings")
    behind = lambda z, start, clutter: np.vstack([start[[0, 2]], _a_boat.pda()(z, start, clutter)[:-1]])  # noqa: E731
    assert_told(name, behind, "that is where it is after nine")


@pytest.mark.parametrize(
    ("bad", "at", "words"),
    [
        ([(3, 0)], 3, "This reading holds NaN beside the numbers"),
        ([(1, 0), (3, 0)], 3, "as others before it did, which have been passed"),
        ([(3, 0), (3, 1)], 3, "There the reading is NaN"),
        ([(1, 0)], 3, "The reading there is a number: is it the root"),
    ],
)
def test_a_result_that_is_not_finite_where_a_reading_holds_some_nan(bad, at, words):
    z = np.ones((6, 2))
    for place in bad:
        z[place] = np.nan
    assert words in of_gaps((z, 0.5), at)


def whole_mean(z, F, Q, mean, cov):
    """R̂ from the mean over all innovations."""
    x, P, squares, kept, R = mean, cov, [], [], 1.0
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading):
            squares.append((reading - x[0]) ** 2)
            R = max(np.mean(squares) - P[0, 0], 0.05) if len(squares) > 29 else R
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
        kept.append((x, P))
    return tuple(np.array(part) for part in zip(*kept, strict=True))


def test_a_time_beyond_the_end_of_the_recordings_is_no_number_of_readings():
    assert_told(
        "adaptive.unknown_sensor", whole_mean, "does not get mostly below 3 m² within the recording (121 readings)"
    )
    assert _unknown_sensor_signs.takes(50.0, "below 3 m²", [], []).startswith("it takes 50 readings (median)")
