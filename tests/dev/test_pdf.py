"""The web page as one PDF."""

import pytest
from pypdf import PdfReader

from dev.lab import CHROMIUM
from dev.web import pdf
from tests.dev.web import FUSION, LESSONS, VOLTMETER

SHEET = "appendix-cheat-sheet.html"

pytestmark = pytest.mark.timeout(300)


@pytest.mark.browser
@pytest.mark.skipif(not CHROMIUM, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_all_pages_become_one_pdf(site, tmp_path):
    lessons = [name for name in LESSONS if name in (FUSION, VOLTMETER)]
    sheets = pdf.bind(site, tmp_path / "course.pdf", only=[*lessons, SHEET])
    book = PdfReader(tmp_path / "course.pdf")
    assert len(book.pages) == sheets >= 15
    assert [entry.title for entry in book.outline] == [
        "4 · Two opinions, one belief",
        "5 · The voltmeter",
        "Appendix · Cheat sheet",
    ]
    second = book.get_destination_page_number(book.outline[1])
    assert (
        "The voltmeter" in book.pages[second].extract_text()
        and "The voltmeter" not in book.pages[second - 1].extract_text()
    )
    assert "Hint 1 of" not in "".join(sheet.extract_text() for sheet in book.pages)
