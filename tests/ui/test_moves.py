"""Moves from browsers and programs at the same time: each is answered, and what was done last holds."""

import threading

import numpy as np

from tests.ui.samples import Browser, counted, make


def test_each_move_is_answered_and_none_is_drawn_without_being_seen():
    counting, calls = counted()
    lively = make(counting)
    before = len(calls)
    lively.widget.send = lambda *message: calls.append("sent")
    lively.set(Q=3.0)
    assert "sent" not in calls[before:], "nobody looks yet"
    browser = Browser(lively)
    for k, exponent in enumerate(np.linspace(-1.9, 1.9, 39)):
        assert browser.move(values={"Q": 10**exponent})["n"] == k + 1
    assert len(browser.heard) == 41  # the stage, the first picture, and an answer each


def test_the_last_word_is_the_programs():
    """Moves that the hand made before it saw what a program had set come too late."""
    lively = make()
    browser = Browser(lively)
    old = browser.epoch
    lively.set(Q=50.0)
    lively.set(Q=60.0)
    assert browser.move(epoch=old, values={"Q": 2.0})["values"]["Q"] == 60
    assert lively.values["Q"] == 60
    assert browser.move(values={"Q": 2.0})["values"]["Q"] == 2
    lively.set(Q=3.0)
    lively.reset()
    assert lively.values["Q"] == browser.heard[-1][0]["values"]["Q"] == 1


def test_moves_out_of_order_do_not_go_back():
    lively = make()
    browser = Browser(lively)
    browser.sent = 5
    browser.move(values={"Q": 4.0})
    browser.sent = 2
    assert browser.move(values={"Q": 2.0})["values"]["Q"] == 4


def test_two_views_of_one_playground():
    lively = make()
    one, two = Browser(lively, "one"), Browser(lively, "two", ratio=2.0)
    answer = two.move(values={"Q": 4.0})
    assert one.heard[-1][0] is answer  # both see it; only two counts it as an answer
    assert answer["view"] == "two"
    assert one.move(values={"R": 1.0})["values"] == {"Q": 4, "R": 1}


def test_threads():
    """Moves from several threads, as in JupyterLab's subshells, while a cell sets values."""
    lively = make()
    browsers = [Browser(lively, name) for name in ("one", "two")]

    def drag(browser):
        for exponent in np.linspace(-1.9, 1.9, 40):
            browser.move(values={"Q": float(f"{10**exponent:.3g}")})

    threads = [threading.Thread(target=drag, args=(browser,)) for browser in browsers]
    for thread in threads:
        thread.start()
    for r in np.linspace(0, 2, 20):
        lively.set(R=r)
    for thread in threads:
        thread.join()
    browsers[0].move(values={"Q": 79.4})
    assert lively.errors == 0
    assert lively.values == {"Q": 79.4, "R": 2.0}
    assert lively.status == "Q = 79.4, R = 2"
    shown = lively.png()
    lively.refresh()
    assert lively.png() == shown
