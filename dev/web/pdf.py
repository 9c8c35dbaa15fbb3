"""The whole course as one PDF: the built web page, printed by Chromium, one page after the other.

    python -m dev.web.pdf                          build/site → build/course.pdf
    python -m dev.web.pdf --site X --out Y.pdf

The pages come in the order of the navigation, each with an entry in the PDF's own contents. Hints and solutions are
left out: they stand in the web page.
"""

import argparse
import io
import sys
from html.parser import HTMLParser
from pathlib import Path

from dev.lab import CHROMIUM, ROOT, browser


class Navigation(HTMLParser):
    """The pages of a site in the order of its navigation: `.pages` of (file name, title)."""

    def __init__(self, text):
        super().__init__()
        self.pages, self._leads = [], None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "a" and "reference internal" in (attributes.get("class") or ""):
            name = attributes.get("href", "").partition("#")[0]
            self._leads = name if name.endswith(".html") and name not in dict(self.pages) else None

    def handle_data(self, data):
        if self._leads:
            self.pages.append((self._leads, data.strip()))
            self._leads = None


def sidebar(site):
    """The part of the first page's HTML that leads to all others."""
    text = (site / "index.html").read_text(encoding="utf-8")
    return text[text.index('<div class="sidebar-tree">') :].partition("</aside>")[0]


def printed(site, names):
    """The PDF of each page, in bytes."""
    with browser() as chromium:
        page = chromium.new_page()
        for name in names:
            page.goto((site / name).resolve().as_uri())
            page.add_style_tag(content=".help { display: none }")
            yield page.pdf(format="A4", print_background=True)


def bind(site, out, only=None):
    """Write all pages, or those with the names `only`, into one file; returns how many sheets it has."""
    from pypdf import PdfReader, PdfWriter

    pages, book = Navigation(sidebar(site)).pages, PdfWriter()
    pages = [page for page in pages if only is None or page[0] in only]
    for (_, title), sheets in zip(pages, printed(site, [name for name, _ in pages]), strict=True):
        first = len(book.pages)
        book.append(PdfReader(io.BytesIO(sheets)), import_outline=False)
        book.add_outline_item(title=title, page_number=first)
    out.parent.mkdir(parents=True, exist_ok=True)
    book.write(out)
    return len(book.pages)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--site", type=Path, default=ROOT / "build" / "site")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "course.pdf")
    options = parser.parse_args()
    if not CHROMIUM:
        sys.exit("no Chromium found: install chromium, chromium-browser or google-chrome")
    if not (options.site / "index.html").exists():
        sys.exit(f"there is no page in {options.site}: make site")
    print(f"{bind(options.site, options.out)} sheets in {options.out}")


if __name__ == "__main__":
    main()
