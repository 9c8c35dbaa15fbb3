"""The torture of dev/hard/browser.py works, and can fail."""

import json
from types import SimpleNamespace

import pytest

from dev.hard import browser
from dev.lab import CHROMIUM


def reader(pages, kernel):
    """A reader without a browser: what the page shows, at first and when it is made anew; what the kernel says."""
    made, pages = object.__new__(browser.Reader), iter(pages)
    made.rest = lambda: next(pages)
    made.lab = SimpleNamespace(ask=lambda code: json.dumps(kernel))
    return made


@pytest.mark.parametrize(
    ("page", "anew", "shown", "fresh", "number", "stale"),
    [
        ("a", "a", "A", "A", 1.0, False),
        ("a", "b", "A", "A", 1.0, True),  # a picture that did not come to the page
        ("a", "a", "A", "B", 1.0, True),  # a move that was not drawn
        ("a", "a", "A", "A", 1.5, True),  # a box that shows another number
    ],
)
def test_a_stale_picture_is_seen(page, anew, shown, fresh, number, stale):
    kernel = dict(pictures=[[shown, fresh]], numbers=[1.0], errors=0)
    assert reader([([page], [number]), ([anew], [number])], kernel).stale() == stale


def test_a_disturbed_lesson_is_seen():
    shows = iter(range(100))
    quiet = SimpleNamespace(before=0, rest=lambda: 0, stale=lambda: False, weigh=lambda: None, move=lambda: None)
    restless = SimpleNamespace(**vars(quiet) | dict(rest=lambda: next(shows) + 1))
    still = SimpleNamespace(**vars(quiet) | dict(rest=lambda: 0))
    assert browser.round_of([still, quiet], [quiet], moves=1)["disturbed"] == 0
    assert browser.round_of([restless, quiet], [quiet], moves=1)["disturbed"] == 1


@pytest.mark.parametrize(("drift", "ok"), [(0.0, True), (0.004, True), (0.02, False), (-0.02, False)])
def test_growing_memory_is_seen(drift, ok):
    sizes = [(10.0 * i, 100 * (1 + 0.01 * (i % 3) + drift * i / 6), 40.0) for i in range(60)]
    kernel, page = browser.memory_lines(SimpleNamespace(memory=sizes), "05")
    assert kernel.ok == ok and page.ok


@pytest.mark.browser
@pytest.mark.timeout(240)
@pytest.mark.skipif(not CHROMIUM, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_a_short_torture():
    found = list(browser.lines(quick=True))
    assert len(found) == 7 and all(line.ok for line in found), found
