"""Open exercises: how a report is made of marks, likely causes and results that are not finite."""

import numpy as np
import pytest

from kflearn import fit, random_walk
from kflearn.exercises import _a_ride as ride
from kflearn.exercises import _voltmeter_judge as voltmeter
from kflearn.exercises._judge import LIKELY, Likely, Mark, likely
from kflearn.exercises._results import of_gaps
from tests.exercises.hand_in import asked

NOTEBOOK_Z = "def answer(y, Q):\n    return fit(lambda R: random_walk(Q, R), z, {'R': 1.0}).parameters['R']"


def written(text, **space):
    """A function as it is written into a cell, whose names are those of the notebook."""
    space = {"np": np, "fit": fit, "random_walk": random_walk, **space}
    exec(text, space)
    return space["answer"]


def test_a_cause_that_the_results_contradict_is_left_out():
    known, unknown = (lambda answers, recordings: True), (lambda answers, recordings: False)
    look = likely("Too small.", ("Is it Q?", known), ("Is it R?", unknown))
    assert look([], []) == "Too small. Is it R?" and isinstance(look([], []), Likely)


def test_a_cause_of_which_nothing_can_be_told_stays():
    assert likely(("Is it Q?", lambda answers, recordings: 1 / 0))([], []) == "Is it Q?"


def test_a_mark_says_what_is_likely_or_what_is_seen():
    mark = Mark("error", lambda answers, truths: 2.0, high=1, above="Look at R.")
    assert isinstance(mark.verdict(2.0, [], []), Likely) and mark.verdict(0.5, [], []) is None
    seen = mark._replace(above=lambda answers, recordings: "Your R is 4.")
    assert not isinstance(seen.verdict(2.0, [], []), Likely)


def test_likely_causes_are_called_likely():
    """A smoother of which no step can be read: its P is too wide, and only likely causes are known."""

    def wide(time, z, q):
        mean, cov = ride.smoothed(time, z, q)
        return mean, 9 * cov

    text = asked("your_data.ride").check(wide).text
    assert LIKELY in text and "The claimed σ is too large." in text


@pytest.mark.parametrize(
    ("gaps", "at", "words"),
    [
        ([3], 3, "There the reading is NaN"),
        ([3], 4, "the first after a missing reading"),
        ([1, 3], 4, "missing readings have been passed before"),
        ([], 4, "The reading there is a number: is it the root"),
    ],
)
def test_a_result_that_is_not_finite(gaps, at, words):
    z = np.arange(8.0)
    z[gaps] = np.nan
    assert words in of_gaps((z, np.eye(2), 0.5), at)


def test_a_number_that_does_not_pass_is_not_shown_as_its_bound():
    mark = asked("voltmeter.whole_filter").marks[1]
    assert (mark.shown(1.0502, False), mark.shown(1.0461, True), mark.shown(0.9, True)) == ("1.0502", "1.05", "0.9")


def test_a_slow_filter_is_also_told_what_its_first_result_lacks(monkeypatch):
    calls = []

    def slow(now, *rest):
        calls.append(0)
        while len(calls) > 1:
            pass
        return np.full((len(now), 2), np.nan), np.tile(np.eye(2), (len(now), 1, 1))

    monkeypatch.setattr("kflearn.exercises._watch.SECONDS", 0.3)
    outcome = asked("when_was_it.live").check(slow)
    assert "is it only slow" in outcome.text and "not finite at reading 1" in outcome.text


def test_a_number_is_told_apart_from_its_bounds():
    mark = Mark("NEES / 4", len, low=0.75, high=1.4)
    assert mark.shown(1.403, False) == "1.403" and mark.shown(1.5, False) == "1.5"
    assert mark.shown(1.4, True) == "1.4"


def test_the_arguments_have_the_names_that_the_learner_gave_them():
    outcome = asked("let_the_data_choose.fitted_R").check(written(NOTEBOOK_Z, z=np.arange(50.0)))
    assert "It is given y, Q." in outcome.text


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


def test_numbers_are_written_in_full():
    outcome = asked("voltmeter.whole_filter").check(lambda z, Q, R: voltmeter.filtered(np.nan_to_num(z), Q, R))
    assert "e+0" not in outcome.text, outcome.text
