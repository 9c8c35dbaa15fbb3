"""For the tests of the course's web page: build it, read its files."""

import os
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

from dev.lab import ROOT

FUSION, VOLTMETER, BEARINGS = "04-gaussian-fusion.html", "05-voltmeter.html", "15-bearings-only.html"
BUILT = os.environ.get("KFLEARN_SITE")
LESSONS = sorted(path.name for path in Path(BUILT).glob("[0-9][0-9]-*.html")) if BUILT else [FUSION, VOLTMETER]


def build(out, only, repository="", address=""):
    """Build a page of some lessons. Its build is silent: Sphinx had nothing to warn of."""
    command = [sys.executable, "-m", "dev.web.build", "--only", only, "--out", str(out)]
    env = os.environ | {"KFLEARN_REPOSITORY": repository, "KFLEARN_ADDRESS": address}
    done = subprocess.run(command, cwd=ROOT, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "WARNING" not in done.stderr
    return out


class Page(HTMLParser):
    """What an HTML file refers to: `.links` that one follows, `.parts` that are loaded; `.ids`; `.images`; `.meta`."""

    def __init__(self, path):
        super().__init__()
        self.links, self.parts, self.ids, self.images, self.meta = [], [], set(), [], {}
        self.canonical = None
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids.add(attributes.get("id"))
        if tag == "a" and "href" in attributes:
            self.links.append(attributes["href"])
        if tag == "link" and attributes.get("rel") == "canonical":
            self.canonical = attributes["href"]  # a name, nothing is loaded from there
        elif tag in ("link", "use") and "href" in attributes:
            self.parts.append(attributes["href"])
        if "src" in attributes:
            self.parts.append(attributes["src"])
        if tag == "img":
            self.images.append(attributes)
        if tag == "meta":
            self.meta[attributes.get("name") or attributes.get("property")] = attributes.get("content")
