"""A learner's code that takes too long is stopped, and nothing of that stays behind."""

import signal
import threading
import time
import types

import pytest

from kflearn.exercises import _watch
from kflearn.exercises.voltmeter import whole_filter
from tests.exercises.examples import correct


def test_a_loop_that_never_ends_is_stopped(monkeypatch):
    monkeypatch.setattr("kflearn.exercises._watch.SECONDS", 0.2)

    def loops(x, P, z, R):
        while True:
            x = x + 1

    outcome = correct.check(loops)
    assert outcome.status == "raised"
    assert "It was stopped after" in outcome.text and "Does a loop never end?" in outcome.text
    assert sum(range(1000)) == 499_500  # nothing is raised later


def test_what_only_waits_is_stopped_later(monkeypatch):
    """On a busy machine a right answer waits for the processor; it gets three times the time, and no more.

    A sleep is not broken off: the first of a second ends, and then the check does.
    """
    monkeypatch.setattr("kflearn.exercises._watch.SECONDS", 0.3)

    def waits(seconds):
        def corrected(x, P, z, R):
            time.sleep(seconds / 20)  # there are twenty trials
            return correct._solve(x, P, z, R)

        return correct.check(corrected).status

    assert waits(0.5) == "right"
    began = time.monotonic()
    assert waits(20) == "raised"
    assert 0.8 < time.monotonic() - began < 5


def test_a_loop_stopped_in_its_last_line_leaves_ctrl_c_as_it_was(monkeypatch):
    """The interruption comes when the learner's code has ended, while the limit is being taken away."""

    class Late(threading.Event):
        def set(self):
            raise _watch.TooLong

    before, events = signal.getsignal(signal.SIGINT), iter((threading.Event(), Late()))
    with monkeypatch.context() as patched:
        patched.setattr(_watch, "threading", types.SimpleNamespace(**vars(threading) | {"Event": lambda: next(events)}))
        with pytest.raises(_watch.TooLong), _watch._limit(5):
            pass
    assert signal.getsignal(signal.SIGINT) == before


def test_without_threads_a_check_has_no_limit_and_works(monkeypatch):
    """As in a browser, where Python has a single thread."""

    def none(thread):
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr("threading.Thread.start", none)
    before = signal.getsignal(signal.SIGINT)
    assert correct.check(correct._solve).status == "right"
    assert signal.getsignal(signal.SIGINT) == before


def test_an_open_exercise_has_a_limit_for_each_recording(monkeypatch):
    """Twenty recordings take longer than one; an endless loop is stopped in the first."""
    monkeypatch.setattr("kflearn.exercises._watch.SECONDS", 0.3)
    calls = []

    def slow(*inputs):
        calls.append(1)
        end = time.process_time() + 0.1
        while time.process_time() < end:
            pass
        return whole_filter._solve(*inputs)

    def endless(*inputs):
        calls.append(1)
        while True:
            pass

    assert whole_filter.check(slow).status == "right" and len(calls) >= 10
    calls.clear()
    assert whole_filter.check(endless).status == "raised" and len(calls) == 1
