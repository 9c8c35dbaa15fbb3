"""What the tests of the course's web page share: the page, a server that shows it, a browser."""

import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from dev.lab import CHROMIUM, browser
from tests.dev.web import BUILT, Page, build


@pytest.fixture(scope="session")
def site(tmp_path_factory):
    """The folder of a page of three lessons."""
    return Path(BUILT) if BUILT else build(tmp_path_factory.mktemp("site") / "site", "04,05,15")


@pytest.fixture(scope="session")
def pages(site):
    return {path.name: Page(path) for path in site.glob("*.html")}


@pytest.fixture(scope="session")
def address(site):
    """Where a server shows the page."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *args):
            pass

    class Patient(ThreadingHTTPServer):
        def handle_error(self, request, client_address):
            """A page was closed while its pictures were still coming."""
            if not isinstance(sys.exception(), ConnectionError):
                super().handle_error(request, client_address)

    with Patient(("127.0.0.1", 0), partial(Quiet, directory=str(site))) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()
        thread.join()


@pytest.fixture(scope="module")
def chromium():
    if not CHROMIUM:
        pytest.skip("no chromium, chromium-browser or google-chrome on the PATH")
    with browser() as chromium:
        yield chromium


@pytest.fixture
def tab(chromium, address):
    """Opens a page in a window of some width; fails afterwards if anything went wrong in the browser."""
    troubles, tabs = [], []

    def go(name, width=1280, **options):
        tab = chromium.new_page(viewport={"width": width, "height": 850}, **options)
        tabs.append(tab)
        tab.on("console", lambda message: troubles.append(message.text) if message.type == "error" else None)
        tab.on("pageerror", lambda error: troubles.append(str(error)))
        tab.on("response", lambda response: troubles.append(response.url) if response.status >= 400 else None)
        tab.on("request", lambda r: None if r.url.startswith((address, "data:")) else troubles.append(r.url))
        tab.goto(address + name)
        return tab

    yield go
    for tab in tabs:
        tab.close()
    assert not troubles
