"""Answers handed in to exercises by name, for the tables of what strangers answered."""

from importlib import import_module


def asked(name):
    """The exercise "lesson.exercise", such as "voltmeter.second_gain"."""
    module, name = name.split(".")
    return getattr(import_module(f"kflearn.exercises.{module}"), name)


def assert_right(name, answer):
    """The answer passes."""
    outcome = asked(name).check(answer)
    assert outcome.status == "right", outcome.text


def assert_told(name, answer, words, not_said=None):
    """The answer does not pass, and the reply holds these words, and not those."""
    outcome = asked(name).check(answer)
    assert outcome.status != "right" and words in outcome.text, outcome.text
    assert not_said is None or not_said not in outcome.text, outcome.text
