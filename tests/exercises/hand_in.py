"""Answers handed in to exercises by name, for the tables of what strangers answered."""

from importlib import import_module

import pytest


def asked(name):
    """The exercise "lesson.exercise", such as "voltmeter.second_gain"."""
    module, name = name.split(".")
    return getattr(import_module(f"kflearn.exercises.{module}"), name)


def assert_right(name, answer):
    """The answer passes."""
    outcome = asked(name).check(answer)
    assert outcome.status == "right", outcome.text


def assert_told(name, answer, words):
    """The answer does not pass, and the reply holds these words."""
    outcome = asked(name).check(answer)
    assert outcome.status != "right" and words in outcome.text, outcome.text


def rows_of(table, homes):
    """A parameter for each row of a table of slips: the exercise, the row's label and its sentence.

    table : {exercise: {label: (wrong answer, sentence, …)}}; homes : {lesson: "exercise exercise …"}
    """
    lessons = {name: lesson for lesson, names in homes.items() for name in names.split()}
    return [
        pytest.param(f"{lessons[name]}.{name}", label, words, id=f"{name}: {label}")
        for name, slips in table.items()
        for label, (_, words, *_) in slips.items()
    ]


def assert_row(name, label, words):
    """The row is in its exercise, and the wrong answer gets its sentence."""
    answer, _ = asked(name).wrong[label]
    assert_told(name, answer, words)
