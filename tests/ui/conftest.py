"""A browser for the tests of a file; without one they are skipped."""

import pytest

from dev.lab import CHROMIUM, browser


@pytest.fixture(scope="module")
def chromium():
    if not CHROMIUM:
        pytest.skip("no chromium, chromium-browser or google-chrome on the PATH")
    with browser() as found:
        yield found
