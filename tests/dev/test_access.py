"""The web page for those who use keys or a screen reader, and for those with a slow line."""

import pytest

from dev import axe
from tests.dev.web import FUSION, VOLTMETER

pytestmark = pytest.mark.timeout(300)
KINDS = [
    "index.html",
    FUSION,
    VOLTMETER,
    "search.html?q=gain",
    "equations.html",
    "api-filters.html",
    "appendix-glossary.html",
    "appendix-notation.html",
    "appendix-loggers.html",
    "404.html",
]
DRAWN = "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"


@pytest.mark.browser
@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_no_serious_fault(tab, name, theme):
    if not axe.source():
        pytest.skip("axe-core is neither in build/axe nor to be had from npm")
    page = tab(name, color_scheme=theme)
    page.wait_for_load_state("networkidle")
    for figure in page.locator("figure.playground").all():  # live, with its controls
        figure.scroll_into_view_if_needed()
        figure.locator("img").wait_for(state="detached")
    assert axe.faults(page, "html") == []
    page.set_viewport_size({"width": 390, "height": 850})
    page.evaluate(DRAWN)
    assert axe.faults(page, "html") == []


WEIGHT = """() => performance.getEntries()
  .filter(({ name }) => !/\\/recorded\\/|recorded\\.js|playground\\.css/.test(name))
  .reduce((sum, { encodedBodySize }) => sum + (encodedBodySize || 0), 0)"""


@pytest.mark.browser
def test_a_page_without_its_playgrounds_is_light(tab, site):
    weights = {}
    for name in sorted(path.name for path in site.glob("*.html")):
        page = tab(name)
        page.wait_for_load_state("networkidle")
        weights[name] = page.evaluate(WEIGHT)
        page.close()
    assert min(weights.values()) > 1_000 and weights["index.html"] > 100_000  # its text, and style and scripts
    assert {name: weight for name, weight in weights.items() if weight > 600_000} == {}
