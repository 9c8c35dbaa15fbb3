"""Open exercises: what is said of filters that do not pass, and what is not said of them."""

import numpy as np
import pytest

from kflearn.exercises import _a_boat, _radar_signs, _unknown_sensor_signs
from kflearn.exercises import _radar as radar
from kflearn.exercises import _unknown_receiver as receiver
from kflearn.exercises import _voltmeter_judge as meter
from kflearn.exercises._radar import R, extended
from tests.exercises.hand_in import asked, assert_right, assert_told


def bearing_in(convert):
    return lambda *given: radar.extended(*given, R=np.diag([25.0, convert(0.02) ** 2]))


def wrapped_distance(z, mean, cov):
    return radar.extended(z, mean, cov, wrap="both")


def loop(z, Q, R, sign=1.0, x=None, again=False):
    x, P = z[0] if x is None else x, R
    found = [] if again else [(x, P)]
    for reading in z if again else z[1:]:
        P = P + Q
        if not np.isnan(reading):
            K = P / (P + R)
            x, P = x + sign * K * (reading - x), (1 - K) * P
        found.append((x, P))
    return tuple(zip(*found, strict=True))


OPEN = [
    (
        lambda z, Q, R: loop(z, Q, R, sign=-1.0),
        ["away from the readings", "Your variances are right"],
        "a variance, or",
    ),
    (lambda z, Q, R: loop(z, Q, R, again=True), ["uses it a second time"], "Your variances"),
    (lambda z, Q, R: loop(z, Q, R, x=12.0), ["The first estimate has to be"], "Your variances"),
    (lambda z, Q, R: (loop(z, Q, R)[0], np.sqrt(loop(z, Q, R)[1])), ["You return σ"], "Do they come from"),
    (meter.FAILING["no growth in gaps"], ["P has to grow by Q", "in the gaps, or just after them"], "at most 1.05."),
    (lambda z, Q, R: (meter.filtered(z, 0.8 * Q, 1.6 * R)[0], loop(z, Q, 1.7 * R)[1]), ["variances are"], "σ?"),
]

EXERCISE = "linearised_and_extended.range_and_bearing"


def track(z, begin=0, append="after"):
    """Lesson 7's filter, begun at a reading, and its beliefs after each reading, before it, or predicted."""
    F, Q, R = np.array([[1.0, 1.0], [0.0, 1.0]]), np.diag([0.005, 0.01]), np.mean(np.diff(z, 2) ** 2) / 6
    x, P, beliefs = np.zeros(2), np.diag([2500.0, 25.0]), []
    beliefs += [(x, P)] * begin
    for reading in z[begin:]:
        old = x, P
        x, P = ahead = F @ x, F @ P @ F.T + Q
        K = P[:, 0] / (P[0, 0] + R)
        x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
        beliefs.append({"before": old, "predicted": ahead, "after": (x, P)}[append])
    return tuple(np.array(part) for part in zip(*beliefs, strict=True))


TRACKS = [
    (lambda z: track(z, append="before"), "You return the beliefs before each reading; wanted are those after it"),
    (lambda z: track(z, append="predicted"), "Your P is that of the prediction for each reading"),
    (lambda z: track(z, begin=1), "The first reading is not used"),
]


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


def test_a_dictionary_of_series():
    def filtered(z):
        mean, cov = receiver.by_differences(z)
        return {"mean": mean, "cov": cov}

    assert_told("is_the_filter_honest.unknown_sensor", filtered, "the result is a dictionary")


@pytest.mark.parametrize("move", receiver.MOVES)
def test_a_prediction_of_P_that_is_another_one(move):
    def filtered(z):
        R, x, P, rows = np.var(np.diff(z, 2)) / 6, receiver.MEAN, receiver.COV, []
        for reading in z:
            x, P = receiver.F @ x, receiver.MOVES[move](P) + receiver.Q
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
            rows.append((x, P))
        return tuple(np.array(part) for part in zip(*rows, strict=True))

    assert_told("is_the_filter_honest.unknown_sensor", filtered, f"Your P is predicted as {move}")


def test_means_that_do_not_follow_a_right_P():
    def waits(z):
        mean, cov = receiver.by_differences(z)
        return 0.5 * mean, cov

    outcome = asked("is_the_filter_honest.unknown_sensor").check(waits)
    assert "about the right R. But the means do not follow with it" in outcome.text
    assert "every recording get its own" not in outcome.text


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (wrapped_distance, "subtract the distance plainly"),
        (bearing_in(np.radians), "It is in radians already"),
        (bearing_in(np.degrees), "is turned into degrees"),
    ],
)
def test_what_is_an_angle_in_the_radar(answer, words):
    assert_told("linearised_and_extended.range_and_bearing", answer, words)


@pytest.mark.parametrize(("design", "words", "not_said"), OPEN, ids=range(len(OPEN)))
def test_a_filter_s_report_says_what_its_results_show(design, words, not_said):
    text = asked("voltmeter.whole_filter").check(design).text
    assert all(each in text for each in words) and not_said not in text, text


@pytest.mark.parametrize("number", range(len(_radar_signs.MISTAKES)))
def test_each_mistake_in_the_radars_filter_is_named(number):
    design, words = _radar_signs.MISTAKES[number]
    recordings = [radar.recording(np.random.default_rng(seed)) for seed in (1, 4)]
    assert any(np.any(abs(np.diff(inputs[0][:, 1])) > 4) for inputs, _ in recordings)  # for the short way round
    answers = [design(*inputs) for inputs, _ in recordings]
    assert _radar_signs.known(design, answers, recordings) == words


def test_the_short_way_round_is_named_in_another_filter_too():
    """Where no known filter gives these results, the recordings with a jump show the mistake."""

    def slow_gain(z, mean, cov):
        return extended(z, mean, cov, wrap=False, R=1.01 * R)

    text = asked(EXERCISE).check(slow_gain).text
    assert "There π and −π meet" in text, text


@pytest.mark.parametrize(("answer", "words"), TRACKS)
def test_a_belief_that_comes_too_early_is_named(answer, words):
    name = "is_the_filter_honest.unknown_sensor"
    assert_right(name, track)
    assert_told(name, answer, words)
    assert "does not follow from the start" not in asked(name).check(answer).text


def test_a_boat():
    name = "whose_is_it.boat"
    assert_told(name, boat_with_nan, "not finite at scan 1. This scan holds rows of NaN, which are no readings")
    behind = lambda z, start, clutter: np.vstack([start[[0, 2]], _a_boat.pda()(z, start, clutter)[:-1]])  # noqa: E731
    assert_told(name, behind, "that is where it is after nine")


def test_a_time_beyond_the_end_of_the_recordings_is_no_number_of_readings():
    assert_told(
        "adaptive.unknown_sensor", whole_mean, "does not get mostly below 3 m² within the recording (121 readings)"
    )
    assert _unknown_sensor_signs.takes(50.0, "below 3 m²", [], []).startswith("it takes 50 readings (median)")
