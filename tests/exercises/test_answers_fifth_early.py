"""What answers to lessons 0 to 14 must get that a fifth group of strangers handed in, and what is said of a form."""

import numpy as np
import pytest

from kflearn.exercises import _cart_with_gaps as cart
from kflearn.exercises import _radar as radar
from kflearn.exercises import _unknown_receiver as receiver
from kflearn.exercises.engine import exercise
from tests.exercises.hand_in import asked, assert_right, assert_told

DICTIONARY = "The values are right, but the result is a dictionary: return the values one after the other"


def on_a_grid(P, R, c):
    gains = np.linspace(0, 1, 21)
    return gains[np.argmin((1 - gains) ** 2 * P + gains**2 * R + 2 * gains * (1 - gains) * c)]


def never_open(away, P, Q, R):
    """P shrinks as if the refused readings had been used."""
    for step in range(1, 2_000):
        P = P + Q
        if away**2 <= 9 * (P + R):
            return step
        P = (1 - P / (P + R)) * P
    return step


def room(x, P):
    """The room's filter from another start."""

    def filtered(z, Q, R, x=x, P=P):
        x = z[0] if x is None else x
        for reading in z[1:]:
            P = P + Q
            K = P / (P + R)
            x, P = x + K * (reading - x), (1 - K) * P
        return x, P

    return filtered


def on_its_side(r, angle, sd_r, sd_angle):
    """A row for each reading, so J is transposed."""
    J = np.array([[np.cos(angle), np.sin(angle)], [-r * np.sin(angle), r * np.cos(angle)]])
    return J @ np.diag([sd_r**2, sd_angle**2]) @ J.T


def glued(dt, mass, c):
    F, B = asked("newton_to_state_space.motion")._solve(dt, mass, c)
    return np.hstack([F, B])


def named(exercise, *names):
    """The right values under names of their own."""
    return lambda *given: dict(zip(names, asked(exercise)._solve(*given), strict=True))


ANSWERS = [
    ("newton_to_state_space.motion", glued, "should be 2 values, an array of shape (2, 2) and an array"),
    ("newton_to_state_space.impossible", "E", "Your answer is the letter E alone"),
    ("predict_correct.printed_position", "ABD", "turns it into a step of 4 m"),
    ("predict_correct.printed_position", "AD", "only 0.5 m is wanted"),
    ("predict_correct.speedometer", 66, "Only K₁ times the innovation of 3 m/s is to be added"),
    ("gaussian_fusion.common_cause", on_a_grid, "multiples of 0.05 between 0 and 1"),
    ("voltmeter.best_error", 0.707, "K, or the sum of the two precisions"),
    ("is_the_filter_honest.interval", (0.051, 7.378), "the limits for a single run"),
    ("is_the_filter_honest.interval", (0.1, 9), "Practically every average lies between these limits"),
    ("readings_that_lie.steps_shut", never_open, "A refused reading does not make P smaller"),
    ("temperature_and_free_fall.room_filter", room(24.9, 0.25), "Your filter starts at 24.9 °C, with P = 0.25"),
    ("temperature_and_free_fall.room_filter", room(None, 0.375), "You start with P = 0.375, whatever R is"),
    ("linearised_and_extended.into_the_plane", on_its_side, "either the factors are exchanged, or your J"),
    ("linearised_and_extended.widest_belief", 0.005, "0.005 m is the sag of a belief 2 m wide"),
    ("two_numbers.table_length", 1.8, "one variance less the corner"),
    ("start_here.data_sheet", 1.73, "6/√12"),
    ("tuning_the_ratio.steady_sigma", 0.301, "Either K is not divided by 2"),
    ("voltmeter.auto_start", named("voltmeter.auto_start", "x", "P"), DICTIONARY),
    ("temperature_and_free_fall.honest_report", named("temperature_and_free_fall.honest_report", *"abc"), DICTIONARY),
    ("train_and_ship.report", named("train_and_ship.report", "mean", "RMS"), DICTIONARY),
    ("train_and_ship.report", lambda errors: {"mean": 1, "RMS": 2}, "The result is a dictionary"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), ANSWERS)
def test_own_sentence(name, answer, words):
    assert_told(name, answer, words)


@exercise(hints=["Two whole numbers."])
def two_numbers():
    """Two whole numbers."""
    return -1.0, 8.0


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ((1, 10), "Value 1 of your answer is too high. Value 2 of your answer is too high."),
        ((1, -8), "Value 1 of your answer has the opposite sign. Value 2 of your answer has the opposite sign."),
        ((-2, 16), "Value 1 of your answer is twice what is wanted. The same holds of value 2."),
        ((-2, 4), "Value 1 of your answer is too low. Value 2 of your answer is too low."),
        ((-1, 10), "✗ Not yet. Value 2 of your answer is too high."),
        ((-10, 80), "Value 1 of your answer is 10 times too large. Value 2 of your answer is 10 times too large."),
    ],
)
def test_of_several_wrong_parts_a_relation_is_named_that_holds_of_all(answer, words):
    assert words in two_numbers.check(answer).text


def test_a_dictionary_of_series():
    def filtered(z):
        mean, cov = receiver.by_differences(z)
        return {"mean": mean, "cov": cov}

    assert_told("is_the_filter_honest.unknown_sensor", filtered, "the result is a dictionary")


def test_figures_under_their_names_are_still_taken_where_they_are_typed():
    sheets = asked("tuning_the_ratio.data_sheets")
    assert sheets.check(dict(zip("abc", sheets.right, strict=True))).status == "right"


def test_an_argument_that_only_decides_is_not_called_lost():
    def slow_gate(away, P, Q, R):
        n = 1
        while away > 3 * np.sqrt(P + R + n * Q) and n < 7:
            n += 1
        return n + 0.5

    outcome = asked("readings_that_lie.steps_shut").check(slow_gate)
    assert "get lost" not in outcome.text and "stayed the same" not in outcome.text


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


def carts(change):
    """A filter of the cart that is right, but for a change of its means, covariances and inputs."""

    def follow(z, dt, sd, sigma):
        (F, Q), start = cart.motion(dt, sd), np.diag([sigma**2, 9.0])
        return change(*cart.run(z, F, Q, sigma**2, np.array([z[0], 0.0]), start), z)

    return follow


def wrong_gain(z, dt, sd, sigma):
    """P is right; the mean moves by twice its gain."""
    (F, Q), x, P, rows = cart.motion(dt, sd), np.array([z[0], 0.0]), np.diag([sigma**2, 9.0]), []
    rows.append((x, P))
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isfinite(reading):
            K = P[:, 0] / (P[0, 0] + sigma**2)
            x, P = x + 1.9 * K * (reading - x[0]), P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def never_smaller(z, dt, sd, sigma):
    """The gain uses P, and P is not made smaller."""
    (F, Q), x, P, rows = cart.motion(dt, sd), np.array([z[0], 0.0]), np.diag([sigma**2, 9.0]), []
    rows.append((x, P))
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isfinite(reading):
            x = x + P[:, 0] / (P[0, 0] + sigma**2) * (reading - x[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        (carts(lambda mean, cov, z: (mean * [1, 0], cov)), "does not move on as F says"),
        (never_smaller, "Look at the corrections"),
        (wrong_gain, "Your P is right at every reading"),
    ],
)
def test_what_is_right_in_a_cart_is_not_blamed(answer, words):
    outcome = asked("train_and_ship.cart_with_gaps").check(answer)
    assert words in outcome.text and "does Q have sd²?" not in outcome.text, outcome.text


def wrapped_distance(z, mean, cov):
    return radar.extended(z, mean, cov, wrap="both")


def bearing_in(convert):
    return lambda *given: radar.extended(*given, R=np.diag([25.0, convert(0.02) ** 2]))


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


def test_rows_under_their_names_are_taken_where_the_lesson_says_so():
    def figures(error):
        rows = {"position": error[..., :3], "velocity": error[..., 3:6], "acceleration": error[..., 6:]}
        return {name: np.sqrt(np.mean(np.sum(row**2, axis=-1), axis=0)) for name, row in rows.items()}

    assert_right("homing_missile.figures", figures)
    assert_told(
        "homing_missile.figures", lambda error: figures(error) | {"acceleration": figures(error)["velocity"]}, "third"
    )
    assert_told("homing_missile.start_sigma", 3.37, "the factor by which")
