"""What a second stranger answered in lessons 0 to 6: refused, passed or misled; and the rules that came of it."""

import numpy as np
import pytest

from kflearn.exercises import _code_of
from kflearn.exercises import _voltmeter_judge as meter
from kflearn.exercises._typed import typed
from tests.exercises.hand_in import asked, assert_right, assert_told

inv, eye = np.linalg.inv, np.eye
F, K, means = np.array([[1.0, 1.0], [0.0, 1.0]]), np.array([[0.8], [0.1]]), np.arange(5.0)  # names of a notebook


def predicts_again(x, P, z, H, R):
    x, P = F @ x, F @ P @ F.T
    K = P @ H.T @ inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), (eye(len(x)) - K @ H) @ P


def a_known_gain(x, P, z, H, R):
    return x + K @ (z - H @ x), (eye(len(x)) - K @ H) @ P


def turned_over(x, P, z, H, R):
    K = P @ H.T @ (1 / (H @ P @ H.T + R))
    return x + K @ (z - H @ x), (eye(len(x)) - K @ H) @ P


def step(x, P, z, F, H, Q, R, identity=None, times=1):
    x, P = F @ x, F @ P @ F.T + times * Q
    K = P @ H.T @ inv(H @ P @ H.T + R)
    return x + K @ (z - H @ x), ((np.eye(len(x)) if identity is None else identity) - K @ H) @ P


def fixed_size(x, P, z, F, H, Q, R):
    return step(x, P, z, F, H, Q, R, np.eye(2))


def one_over_H(z, H, R):
    return (1 / H) @ z, (1 / H) @ R @ (1 / H).T


def whole_numbers(F, x):
    y = np.zeros(2, dtype=int)
    y[:] = F @ x
    return y


def is_nan(x):
    return any(value is np.nan for value in x)


def asks_for_zero(x):
    return np.any(x)


def detrended(readings):
    k = np.arange(len(readings))
    return np.var(readings - np.polyval(np.polyfit(k, readings, 9), k))


RIGHT = [
    ("tuning_the_ratio.R_with_drift", lambda r: np.mean(abs(np.diff(r))) ** 2 * np.pi / 4),
    ("tuning_the_ratio.R_with_drift", lambda r: (1.4826 * np.median(abs(np.diff(r)))) ** 2 / 2),
    ("voltmeter.second_gain", 0.357),
    ("tuning_the_ratio.steady_sigma", 0.213),
]


@pytest.mark.parametrize(("name", "answer"), RIGHT)
def test_right_answers_pass(name, answer):
    assert_right(name, answer)


SAID = [
    ("start_here.three_readings", 61 + 62 + 66 / 3, "Put brackets around the sum"),
    ("start_here.three_readings", 62.3, "add up to 186.9 m"),
    ("start_here.readings_needed", 70, "2/√n is 0.239 m"),
    ("start_here.data_sheet", 7, "σ is its root, 2.65 m"),
    ("start_here.root_mean_square", lambda e: np.sqrt(np.sum(e**2) / 5000), "follows how many numbers come in"),
    ("start_here.root_mean_square", lambda e: np.sqrt(np.mean(means**2)), "does not depend on error"),
    ("newton_to_state_space.overwritten", whole_numbers, "so does an array of whole numbers"),
    ("newton_to_state_space.impossible", "ABCDE", "Not all five. B is possible"),
    ("newton_to_state_space.three_sensors", [[1, 0], [100, 0], [0, 4]], "the row of the speedometer"),
    ("newton_to_state_space.held_push", lambda T, s: s**2 * np.full((2, 2), 4.0), "does not depend on T"),
    ("two_numbers.table_of", lambda x, y: np.cov(means, means), "does not depend on x and y"),
    ("two_numbers.scale_for", lambda share: np.sqrt(2 * np.log(1 - share)), "The result is NaN"),
    ("two_numbers.told_speed", 12.0, "adds 0.667 m/s for each of the 3 m"),
    ("predict_correct.correct", predicts_again, "reads `F`, which is a name of the notebook"),
    ("predict_correct.correct", a_known_gain, "reads `K`, which is a name of the notebook"),
    ("predict_correct.correct", turned_over, "`1 / …` turns over each entry"),
    ("predict_correct.misprints", fixed_size, "`np.eye(2)` has a fixed size"),
    ("predict_correct.misprints", lambda *a: step(*a, times=2), "Q is added twice"),
    ("predict_correct.predicted_covariance", [[16, 7], [7, 4]], "with dt² = 4"),
    ("predict_correct.printed_position", "ABCD", "A and B and C and D together end at"),
    ("gaussian_fusion.third_opinion", 61.6667 + 0.8333**0.5 / (0.8333**0.5 + 2) * 4.3333, "two standard deviations"),
    ("gaussian_fusion.third_opinion", 61.6667 + 5 / 6 * 4.3333, "comes from K = 0.8333"),
    ("gaussian_fusion.third_opinion", 63.5, "lies 0.423 of the way"),
    ("gaussian_fusion.third_opinion", 62, "if you have rounded"),
    ("gaussian_fusion.common_cause", lambda P, R, c: min(max((P - c) / (P + R - 2 * c), 0), 1), "between 0 and 1"),
    ("gaussian_fusion.common_cause", lambda P, R, c: 1.7 * (P - c) / (P + R - 2 * c), "is 1.7 times what is wanted"),
    ("gaussian_fusion.common_cause", lambda P, R, c: 1.7 + (P - c) / (P + R - 2 * c), "is larger by 1.7 than"),
    ("voltmeter.second_gain", 0.25 + 0.05, "A gain of 0.3 would need P⁻ = 3.86 V²"),
    ("voltmeter.is_unknown", is_nan, "the same object"),
    ("voltmeter.is_unknown", asks_for_zero, "whether an entry is not zero"),
    ("voltmeter.is_unknown", lambda x: bool(np.isnan(x[0]) or np.isnan(x[1])), "may lie beyond the end"),
    ("voltmeter.auto_start", one_over_H, "`1 / H` turns over each entry"),
    ("voltmeter.auto_start", lambda z, H, R: (inv(H) @ z, inv(H) * R * inv(H).T), "`*` multiplies entry by entry"),
    ("tuning_the_ratio.data_sheets", [0.09, 6.25, 0.0208], "in another order"),
    ("tuning_the_ratio.data_sheets", [2.5, 0.09, 0.0625], "(b) is right. In (a) the sheet gives σ"),
    ("tuning_the_ratio.which_knob", {"C", "E"}, "C is enough"),
    ("tuning_the_ratio.R_with_drift", detrended, "You took a polynomial away"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), SAID, ids=[f"{row[0]}-{i}" for i, row in enumerate(SAID)])
def test_wrong_answers_get_their_sentence(name, answer, words):
    assert_told(name, answer, words)


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


@pytest.mark.parametrize(("design", "words", "not_said"), OPEN, ids=range(len(OPEN)))
def test_a_filter_s_report_says_what_its_results_show(design, words, not_said):
    text = asked("voltmeter.whole_filter").check(design).text
    assert all(each in text for each in words) and not_said not in text, text


def test_a_number_that_does_not_pass_is_not_shown_as_its_bound():
    mark = asked("voltmeter.whole_filter").marks[1]
    assert (mark.shown(1.0502, False), mark.shown(1.0461, True), mark.shown(0.9, True)) == ("1.0502", "1.05", "0.9")


def test_a_known_number_must_be_near():
    assert typed(0.643, 9 / 14, 4e-4) and typed([1, 2.5], (1, 2.5), 4e-4) and not typed(63.02, 63, 1e-4)
    assert typed("text", 3, 1e-4)  # nothing to compare: `check` has said before that it is no number


def test_expressions_are_read_where_there_is_no_source():
    space = {"np": np, "F": F}
    exec("def f(x, P):\n    y = np.eye(2) @ x\n    return F @ y, any(v is np.nan for v in x), 1 / (P * x)[0]", space)
    text = _code_of.text_of(space["f"])
    assert "np.eye(2) @ x" in text and "is np.nan" in text and "(P * x)[0]" in text, text
    assert _code_of.has(space["f"], r"eye\(2\)") and not _code_of.has(space["f"], r"eye\(3\)")
    assert _code_of.names_of_the_notebook(space["f"]) == ["F"] and _code_of.has(len, "anything")
