"""What answers to lessons 1 to 9 must get that a seventh group of strangers handed in, and more of their kind."""

import numpy as np
import pytest

from kflearn import angle_difference
from kflearn.exercises._speaker import medians, plain
from tests.exercises.hand_in import asked, assert_right, assert_told


def entry_by_entry(z, H, R):
    undo = 1 / np.where(np.asarray(H) == 0, np.inf, H)
    return undo @ z, undo @ R @ undo.T


def star(e, P):
    return np.sum(e * np.linalg.inv(P) * e)


FACTS = [
    ("is_the_filter_honest.mystery", "gain too small", "With a gain (a ratio Q/R) too small"),
    ("is_the_filter_honest.mystery", "Q/R too small", "so the gain is too large"),
    ("is_the_filter_honest.mystery", "the ratio is low", "name one of the four faults"),
    ("is_the_filter_honest.mystery", "K too large", "Which makes it so, Q or R?"),
    ("is_the_filter_honest.mystery", "Q/R too large", "Which makes it so, Q or R?"),
    ("is_the_filter_honest.mystery", "gain too large, so R too small", "Which makes it so, Q or R?"),
    ("is_the_filter_honest.mystery", "R/Q too large", "Name one of the four faults"),
    ("is_the_filter_honest.mystery", "both by the same factor", "With Q and R wrong by the same factor"),
    ("is_the_filter_honest.nees", star, "as if e were squared first"),
    ("voltmeter.auto_start", entry_by_entry, "only where H holds a single number. `1 / H` turns over"),
    ("voltmeter.best_error", 1.632, "what the filter with its random walk is off by"),
    ("voltmeter.best_error", 6.0, "a variance of 36 V²"),
    ("voltmeter.second_gain", "0,357", "and write a point in place of the comma"),
    ("tuning_the_ratio.data_sheets", [56.2, 0.09, 0.0208], "56.2 is (3 · 2.5)²"),
    ("tuning_the_ratio.data_sheets", [6.25, 0.12, 0.0208], "0.12 is 0.6²/3"),
    ("tuning_the_ratio.data_sheets", [3, 0.04, 0.0208], "as if 0.6 °C were 3σ"),
    ("tuning_the_ratio.data_sheets", [6.25, 0.2, 0.0208], "halve the 0.6 °C first"),
    ("two_numbers.scale_for", lambda share: 2.45 * share / 0.95, "k is not proportional to the share"),
    ("readings_that_lie.is_refused", lambda *given: "refused", "should be True or False, but it is text"),
    ("readings_that_lie.is_refused", lambda *given: "refused", "write True or False, without quotation marks"),
    ("bearing_of_a_sound.is_a_covariance", np.linalg.eigvalsh, "should be True or False, but it is an array"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "words"), FACTS)
def test_an_answer_is_told_what_it_would_mean(name, answer, words):
    assert_told(name, answer, words)


SMALL = ["gain too small", "Q/R too small", "the overall scale", "both: Q too large, R too small"]


@pytest.mark.parametrize("answer", SMALL)
def test_a_small_gain_is_no_factor_for_both(answer):
    assert "by the same factor" not in asked("is_the_filter_honest.mystery").check(answer).text


def test_a_matrix_turned_over_gets_no_letter_of_another_exercise():
    def undone(z, H, R):
        pieces = np.ones_like(H) / H
        return pieces @ z, pieces @ R @ pieces.T

    def inner(z, H, R):
        def over(each):
            return 1 / each.clip(1e-3)

        return over(H) @ z, over(H) @ R @ over(H).T

    for answer in (undone, inner, entry_by_entry):
        text = asked("voltmeter.auto_start").check(answer).text
        assert "inv(S)" not in text and "only where R" not in text, text


def test_the_example_shows_all_entries_that_are_named():
    def update(P, K):
        right = P - np.outer(K, P[0])
        right[0, 1] += K[0] > 0.5  # in some trials only
        right[1, 1] += 1 if K[0] > 0.5 and K[1] > 0.5 else 0
        return right

    exercise = asked("bearing_of_a_sound.right_update")
    text = exercise.check(update).text
    shown = [exercise._called(case) for case in exercise.cases if np.all(case[1] > 0.5)]
    assert "only [0, 1], [1, 1] is wrong" in text
    assert any(f"`{case}`" in text for case in shown), text


# ---- open exercises


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


@pytest.mark.parametrize(("answer", "words"), TRACKS)
def test_a_belief_that_comes_too_early_is_named(answer, words):
    name = "is_the_filter_honest.unknown_sensor"
    assert_right(name, track)
    assert_told(name, answer, words)
    assert "does not follow from the start" not in asked(name).check(answer).text


def densest(z):
    """The mean of the largest group among the last 25 readings."""
    found = []
    for k in range(len(z)):
        last = z[:36] if k < 36 else z[k - 24 : k + 1]
        away = angle_difference(last[:, None], last[None, :])
        j = (abs(away) < 7).sum(axis=0).argmax()
        found.append(last[j] + away[abs(away[:, j]) < 7, j][-8:].mean())
    return np.array(found)


SPEAKERS = [
    (densest, "of 28 long echoes your filter is wholly at the echo", "pulls"),
    (lambda z: medians()(z) - 5, "The largest error is", "short way round?"),
    (lambda z: medians(61)(z), "behind the walking speaker", "short way round?"),
    (plain, "at their end it is", "wholly at the echo"),
]


@pytest.mark.parametrize(("answer", "words", "not_said"), SPEAKERS)
def test_a_speaker_that_is_lost_is_told_where(answer, words, not_said):
    assert_told("readings_that_lie.speaker", answer, words)
    assert not_said not in asked("readings_that_lie.speaker").check(answer).text
