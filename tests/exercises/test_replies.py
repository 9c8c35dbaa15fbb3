"""What is said of answers to several exercises alike: choices, relations, dictionaries, neighbours."""

import linecache

import numpy as np
import pytest

from kflearn import angle_difference
from kflearn.exercises import _words
from kflearn.exercises._a_boat_signs import takes_the_nearest
from kflearn.exercises._answers import fault
from kflearn.exercises._words import one_of
from kflearn.exercises.engine import exercise
from tests.exercises.hand_in import asked, assert_right, assert_told


@exercise(hints=["Two whole numbers."])
def two_numbers():
    """Two whole numbers."""
    return -1.0, 8.0


SMALL = ["gain too small", "Q/R too small", "the overall scale", "both: Q too large, R too small"]

RIGHT = [("voltmeter.best_error", value) for value in (1.41, 1.414, 1.4142, 2**0.5)] + [
    ("voltmeter.second_gain", 0.357),
    ("temperature_and_free_fall.suspect", "gravity too large"),
    ("tuning_the_ratio.which_knob", "C"),
]


def test_ways_round_that_are_right_at_the_edge_of_the_width():
    def apart(one, other):
        return np.degrees(np.angle(np.exp(1j * np.radians(one - other))))

    for way in (angle_difference, apart, lambda one, other: (one - other + 180) % 360 - 180):
        assert_right("readings_that_lie.agreeing", lambda old, z, w, way=way: np.sum(abs(way(old, z)) <= w))


@pytest.mark.parametrize(("model", "turns"), [("plane", False), ("plane.replace(Q=plane.Q / 9)", True)])
def test_a_boat_that_is_told_of_Q_only_where_it_is_its_own(model, turns):
    code = f"def boat(z, start, clutter):\n    nearest_filter({model}, z)\n"
    space, file = {"nearest_filter": lambda *given: None}, f"<boat {turns}>"
    linecache.cache[file] = (len(code), None, code.splitlines(keepends=True), file)
    exec(compile(code, file, "exec"), space)
    said = takes_the_nearest(space["boat"], [], [])
    assert "Weigh all that are in the gate" in said
    assert ("Q must be large enough" in said) == turns


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


def test_an_offset_of_the_speeds_must_be_taken_out():
    def plain(v, late, dt):
        return np.argmin([np.mean((v[: len(v) - j] - late[j:]) ** 2) for j in range(11)]) * dt

    def without_offset(v, late, dt):
        return np.argmin([np.std(v[: len(v) - j] - late[j:]) for j in range(11)]) * dt

    def numpys(v, late, dt):
        return (np.argmax(np.correlate(late - late.mean(), v - v.mean(), "full")) - len(v) + 1) * dt

    assert_told("when_was_it.clock_offset", plain, "One instrument may show an offset")
    for right in (without_offset, numpys):
        assert_right("when_was_it.clock_offset", right)


def test_two_mistakes_in_the_weights_are_both_named():
    def weights(z, expected, S, detection, clutter):
        nis = (z - expected) ** 2 / S
        e = np.where(nis <= 9.21, np.exp(-nis / 2), 0)
        b = clutter * 2 * np.pi * np.sqrt(S) * (1 - 0.99 * detection) / detection
        return np.append(b, e) / (b + e.sum())

    for words in ("2π√S belongs to readings in the plane", "9.21 is the limit in the plane"):
        assert_told("whose_is_it.weights", weights, words)


def test_scale_of_one_number_stretched():
    from scipy.stats import norm

    assert_told(
        "two_numbers.scale_for", lambda share: norm.interval(share)[1] * 1.25, "One factor mends one share only"
    )


def test_two_digits_and_booleans_in_arrays():
    say = lambda given, right: fault(given, np.array(right), "it", 2e-3, None, False, by_hand=True)  # noqa: E731
    assert "three digits" in say([0.95, 2.0], [0.952, 2.0])
    assert "differs in 2" in say([0.95, 3.0], [0.952, 2.0])
    assert say([True, False], [1, 0]) is None and "bool" in say([True, False], [1, 2])


def test_one_thing_is_said_once():
    def squares(x, z, mean, ignored, cov):
        a = x[:, 0] > 0
        errors = [np.mean((way - x)[a, 0] ** 2) for way in (mean, ignored)]
        return *errors, np.sqrt(cov[a][-1, 1, 1])

    text = asked("temperature_and_free_fall.honest_report").check(squares).text
    assert text.count("is the square of") == 1 and "The same holds of value 2" in text


def test_nothing_is_said_twice():
    """Two mistakes of one kind have remarks that end alike."""
    two_by_two = lambda P: abs(P[0, 1] - P[1, 0]) < 1e-8 and P[0, 0] >= 0 and np.linalg.det(P[:2, :2]) >= -1e-9  # noqa: E731
    outcome = asked("bearing_of_a_sound.is_a_covariance").check(two_by_two)
    assert outcome.text.count("P may be of any size.") == 1, outcome.text


@pytest.mark.parametrize("answer", SMALL)
def test_a_small_gain_is_no_factor_for_both(answer):
    assert "by the same factor" not in asked("is_the_filter_honest.mystery").check(answer).text


def test_the_example_shows_all_entries_that_are_named():
    def update(P, K):
        right = P - np.outer(K, P[0])
        right[0, 1] += K[0] > 0.5  # in some trials only
        right[1, 1] += 1 if K[0] > 0.5 and K[1] > 0.5 else 0
        return right

    exercise = asked("bearing_of_a_sound.right_update")
    text = exercise.check(update).text
    shown = [exercise._called(case) for case in exercise.cases if np.all(case[1] > 0.5)]
    assert "only [0, 1], [1, 1] are wrong" in text
    assert any(f"`{case}`" in text for case in shown), text


def test_a_loop_over_the_time_gets_the_sentence_of_the_squares():
    def tried(dv, b, allowed):
        t = 0.0
        while np.hypot(dv * t, b * t**2 / 2) < allowed:
            t += 0.01
        return t

    assert_told("error_state_navigation.dark_time", tried, "Squares add where errors are independent")


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
        said = fault({"x": [1, 2, 3], "y": 2}, right, "your answer", 1e-3, None, False, by_hand=True)
        assert "it is a dictionary" in said
        assert said.endswith(words)


@pytest.mark.parametrize(
    ("name", "answer", "not_said"),
    [
        ("voltmeter.best_error", 1.63, "8/3"),
        ("tuning_the_ratio.steady_sigma", 0.301, "0.1/0.5"),
        ("gaussian_fusion.third_opinion", 61.85, "not 16"),
        ("start_here.three_readings", 62.93, "geometric"),
    ],
)
def test_an_answer_near_one_of_them_does_not_get_its_sentence(name, answer, not_said):
    assert not_said not in asked(name).check(answer).text


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right(name, answer):
    assert_right(name, answer)


def test_none_of_several_choices_is_right_or_one_of_them_is():
    choices = {"a", "b", "c"}
    assert _words.one_of({"a", "b"}, {"b"}, choices).endswith("among these.")
    assert _words.one_of({"a", "b"}, {"c"}, choices).endswith("none of these.")
    assert _words.one_of(choices, {"c"}, choices) == "choose one, please."


def test_the_gains_after_the_second_are_what_is_said_of_them():
    said, P, gains = asked("voltmeter.second_gain").then, (1 - 5 / 14) * 5, []
    for _ in range(3):
        K = (P + 3) / (P + 3 + 9)
        P = (1 - K) * (P + 3)
        gains.append(f"{K:.3f}")
    assert "{}, {} and {}".format(*gains) in said


def test_the_mean_of_converted_places_is_too_near():
    rng, far, sigma = np.random.default_rng(1), 1000.0, 0.2
    angles = rng.normal(0.7, sigma, 200_000)
    mean = np.hypot(np.mean(far * np.cos(angles)), np.mean(far * np.sin(angles)))
    assert abs(far - mean - far * sigma**2 / 2) < 1
    assert "too near" in asked("linearised_and_extended.into_the_plane").then


def test_empty_quotation_marks_are_named():
    assert "between the quotation marks" in asked("let_the_data_choose.doubled").check("").text
