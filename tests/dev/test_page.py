"""Around the lessons on the web page: where a page leads, how it is found, what it looks like on paper."""

import io
import re
import xml.etree.ElementTree
import zipfile
import zlib
from urllib.parse import urlsplit

import nbformat
import pytest
from PIL import Image

from dev import lessons as course
from dev.lab import ROOT
from dev.web import about, teaches
from tests.dev.web import BEARINGS, BUILT, FUSION, LESSONS, VOLTMETER, Page, build

pytestmark = pytest.mark.timeout(300)
REPOSITORY, ADDRESS = "https://example.org/kalman", "https://example.com/course"
GLOSSARY = (ROOT / "notebooks" / "appendix-glossary.md").read_text(encoding="utf-8")
SHEET = "appendix-cheat-sheet.html"


@pytest.fixture
def settings(tmp_path, monkeypatch):
    """Makes settings from the text of a pyproject.toml."""
    for name in about.VARIABLES.values():
        monkeypatch.delenv(name, raising=False)

    def read(text):
        (tmp_path / "kflearn").mkdir(exist_ok=True)
        (tmp_path / "kflearn" / "__init__.py").write_text('__version__ = "1.2.3"  # here\n', encoding="utf-8")
        (tmp_path / "pyproject.toml").write_text(text, encoding="utf-8")
        return about.settings(tmp_path)

    return read


@pytest.fixture(scope="session")
def known(tmp_path_factory):
    """A page of one lesson, of which both addresses are known."""
    return build(tmp_path_factory.mktemp("known") / "site", "04", REPOSITORY, f"{ADDRESS}/")


# ---- where a page leads


def test_addresses_are_said_once(settings, monkeypatch):
    nothing = {"repository": "", "site": "", "version": "1.2.3"}
    assert settings("") == settings("[tool.kflearn]\nrepository = ''") == nothing
    text = f'[tool.kflearn]\nrepository = "{REPOSITORY}/"\nsite = "{ADDRESS}"'
    assert settings(text) == {"repository": REPOSITORY, "site": ADDRESS, "version": "1.2.3"}
    monkeypatch.setenv("KFLEARN_REPOSITORY", "https://example.net/fork")
    monkeypatch.setenv("KFLEARN_ADDRESS", "")
    assert settings(text) == {"repository": "https://example.net/fork", "site": "", "version": "1.2.3"}


@pytest.mark.parametrize("wrong", ["example.org/kalman", "javascript:alert(1)", "https://a b", 'https://a\\"b'])
def test_a_wrong_address_is_refused(settings, wrong):
    with pytest.raises(SystemExit, match="is not an address"):
        settings(f'[tool.kflearn]\nrepository = "{wrong}"')


def body(path):
    """The words of a page."""
    return " ".join(re.sub(r"<[^>]*>", " ", path.read_text(encoding="utf-8")).split())


def test_each_page_leads_on(site, pages):
    version = about.settings(ROOT)["version"]
    for name in set(pages) - {"404.html"}:
        text = body(site / name)
        assert f"Kalman filtering, hands on, version {version}" in text
        assert "Is something wrong on this page?" in text
        assert (f"notebooks/{name[:-5]}.ipynb" in pages[name].links) == (name in [*LESSONS, BEARINGS])
        assert ("course.zip" in pages[name].links) == (site / "course.zip").exists() == (ROOT / ".git").exists()


def test_the_notebook_is_the_original(site):
    for name in LESSONS:
        notebook = f"notebooks/{name[:-5]}.ipynb"
        assert (site / notebook).read_bytes() == (ROOT / notebook).read_bytes()


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="not a git checkout: there is no course.zip")
def test_the_course_is_whole(site):
    names = zipfile.ZipFile(site / "course.zip").namelist()
    wanted = ["README.md", "Makefile", "pyproject.toml", "kflearn/__init__.py", "notebooks/05-voltmeter.ipynb"]
    assert set(names) >= {f"kalman-course/{name}" for name in wanted}
    assert not [name for name in names if not name.startswith("kalman-course/") or ".venv" in name]
    assert f"{(site / 'course.zip').stat().st_size / 1e6:.1f} MB" in body(site / "index.html")


def test_outside_of_git_there_is_no_archive(tmp_path):
    assert about.archive(tmp_path, tmp_path / "course.zip") == ""
    assert "course.zip" not in about.note("05-voltmeter.ipynb", "") + about.where({"zip": "", "repository": ""})
    assert "whoever gave you this page" in about.where({"zip": "", "repository": ""})


def test_a_broken_git_is_no_error(tmp_path, capsys):
    (tmp_path / ".git").write_text("gitdir: nowhere")
    assert about.archive(tmp_path, tmp_path / "course.zip") == ""
    assert not (tmp_path / "course.zip").exists()
    assert "no course.zip" in capsys.readouterr().err


@pytest.mark.skipif(bool(BUILT), reason="the built page may know its addresses")
def test_without_addresses_no_link_is_dead(site, pages):
    assert not {"sitemap.xml", "robots.txt"} & {path.name for path in site.iterdir()}
    for name, page in pages.items():
        assert not page.canonical and "og:url" not in page.meta
        assert not [link for link in page.links if "issues" in link or not link.strip()], name
        assert name == "404.html" or "Tell whoever gave it to you" in body(site / name)
    assert "repository</a>" not in (site / "index.html").read_text(encoding="utf-8")


def test_with_addresses_every_page_leads_there(known):
    names = {path.name for path in known.glob("*.html")} - {"404.html"}
    for name in names:
        page = Page(known / name)
        assert {REPOSITORY, f"{REPOSITORY}/issues"} <= set(page.links)
        assert "Tell whoever" not in body(known / name)
        assert page.meta["og:image"] == f"{ADDRESS}/_static/card.png"
        assert page.canonical == page.meta["og:url"] == f"{ADDRESS}/{name}"
    places = xml.etree.ElementTree.parse(known / "sitemap.xml").getroot()
    assert {place[0].text for place in places} == {f"{ADDRESS}/{name}" for name in names - {"search.html"}}
    assert f"Sitemap: {ADDRESS}/sitemap.xml" in (known / "robots.txt").read_text(encoding="utf-8")
    assert f"{ADDRESS}/index.html" in Page(known / "404.html").links


def test_the_words_on_stored_outputs_are_for_jupyterlab_only(site):
    for path in course.lessons()[1:]:
        first = nbformat.read(path, as_version=4).cells[0].source
        assert first.count(about.STORED) == 1
        assert about.without(about.STORED, first) == first.split(about.STORED)[0].rstrip(), (
            f"{path.name}: not at the end"
        )
    for name in LESSONS:
        assert "outputs below are stored" not in body(site / name)


def test_where_to_get_the_course(site):
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert readme.count(about.FOLDER) == 1
    assert "in which you read this" not in body(site / "index.html")  # true on the repository's page only
    assert body(site / "index.html").count("Get the folder.") == 1
    assert about.without(about.FOLDER, f"a\n\n{about.FOLDER} b\nc\n\nd") == "a\n\nd"


# ---- how it is found


def test_descriptions(pages):
    texts = [page.meta["description"] for name, page in pages.items() if name != "404.html"]
    assert len(set(texts)) == len(texts)
    for text in texts:
        assert 10 < len(text) <= 160 and not re.search(r"[*$<>`\\]", text)
    assert pages[FUSION].meta["description"].startswith("A calculation says that a cart should be at 60 m")
    for name in LESSONS:
        meta = pages[name].meta
        assert meta["og:title"] and meta["og:description"] == meta["description"] and meta["og:type"] == "article"


def test_a_picture_for_those_who_link_here(site, pages):
    data = (site / "_static" / "card.png").read_bytes()
    assert len(data) < 100_000
    assert Image.open(io.BytesIO(data)).size == (1200, 630)
    assert len(pages[VOLTMETER].meta["og:image:alt"]) > 40
    assert urlsplit(pages[VOLTMETER].meta["og:image"]).path.endswith("_static/card.png")


def test_every_term_of_the_glossary_has_its_lessons():
    rows = [line.strip("| ").split(" | ") for line in GLOSSARY.splitlines() if re.match(r"\| .*\]\(\d\d-", line)]
    taught = teaches.table(GLOSSARY)
    assert len(rows) > 100 and len(taught) >= len(rows)
    for english, _, _, lessons in rows:
        for term in teaches.terms(english):
            assert [term, re.findall(r"\((.*?)\.ipynb\)", lessons)] in taught
    assert {page for _, pages in taught for page in pages} <= {path.stem for path in ROOT.glob("notebooks/*.ipynb")}
    assert ["nis", ["07-is-the-filter-honest"]] in taught
    assert ["normalised innovation squared", ["07-is-the-filter-honest"]] in taught


FIRST = """query => {
  history.replaceState(null, "", "?q=" + encodeURIComponent(query));
  return (Search._performSearch(...Search._parseQuery(query)).at(-1) || [])[0];
}"""


@pytest.mark.browser
def test_the_lesson_that_teaches_a_term_is_found_first(site, tab):
    page = tab("search.html?q=gain")
    page.wait_for_function("() => Search.hasIndex()")
    there = {path.stem for path in site.glob("*.html")}
    asked = [(term, there & {*lessons}) for term, lessons in teaches.table(GLOSSARY)]
    asked.remove(("ins", there & {"20-error-state-navigation"}))  # its stem is "in", which the search leaves out
    wrong = [(term, first) for term, want in asked if want and (first := page.evaluate(FIRST, term)) not in want]
    assert not wrong
    want = {"observability": "15", "sigma": "", "Innovations": "03", "consider": "21", "smoother": "23", "gains": "00"}
    for query, number in want.items():
        found = page.evaluate(FIRST, query)
        assert not any(name.startswith(number) for name in there) or found.startswith(number), query


@pytest.mark.browser
def test_the_search_shows_it_first(tab):
    page = tab("search.html?q=observability")
    first = page.locator("#search-results li a").first
    first.wait_for()
    assert first.get_attribute("href").startswith(BEARINGS)


@pytest.mark.browser
@pytest.mark.parametrize("place", ["lost.html", "notebooks/lost.html", "a/b/c/lost.html"])
def test_what_is_not_found_leads_to_the_start(chromium, address, site, place):
    page = chromium.new_page()
    missing = (site / "404.html").read_text(encoding="utf-8")
    page.route("**/lost.html", lambda route: route.fulfill(status=404, body=missing, content_type="text/html"))
    page.goto(address + place)
    start = f"{(about.settings(ROOT)['site'] if BUILT else '') or address.rstrip('/')}/index.html"
    page.wait_for_function("start => document.querySelector('a').href == start", arg=start)
    page.close()


# ---- what it looks like on paper


def sheets(pdf):
    """How many pieces of text and pictures each page of a PDF has."""
    objects = dict(re.findall(rb"(?s)(\d+) 0 obj\n(.*?)\nendobj", pdf))
    pages = [body for body in objects.values() if re.search(rb"/Type /Page\b", body)]
    streams = [objects[re.search(rb"/Contents (\d+) 0 R", page)[1]] for page in pages]
    drawn = [zlib.decompressobj().decompress(stream.split(b"stream\n", 1)[1]) for stream in streams]
    return [page.count(b" Tf") + page.count(b" Do\n") for page in drawn]


@pytest.mark.browser
@pytest.mark.parametrize("paper", ["A4", "Letter"])
@pytest.mark.parametrize("name", [*sorted({*LESSONS, BEARINGS}), "changelog.html"])
def test_on_paper_no_page_is_empty(tab, name, paper):
    counts = sheets(tab(name).pdf(format=paper))
    assert len(counts) > 5 or name == "changelog.html"
    assert min(counts) > 2, counts  # what it is, and its number, stand on each


@pytest.mark.browser
@pytest.mark.parametrize("paper", ["A4", "Letter"])
def test_the_cheat_sheet_is_one_page(tab, paper):
    page = tab(SHEET)
    assert len(sheets(page.pdf(format=paper, prefer_css_page_size=True))) == 1
    page.emulate_media(media="print")
    sizes = page.locator("article :is(p, td, pre)").evaluate_all("all => all.map(e => getComputedStyle(e).fontSize)")
    assert min(float(size[:-2]) for size in sizes) * 72 / 96 >= 7


WIDE = """all => all.filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent.slice(0, 60))"""


@pytest.mark.browser
@pytest.mark.parametrize("name", [VOLTMETER, BEARINGS])
def test_on_paper_nothing_hides_or_is_cut_off(tab, name):
    page = tab(name, width=680)  # what is left of A4 between its margins
    page.emulate_media(media="print")
    for gone in (
        ".skip-to-content",
        ".back-to-top",
        ".sidebar-drawer",
        ".content footer",
        ".kf-controls",
        ".note",
        ".onward",
    ):
        assert not page.locator(gone).first.is_visible(), gone
    picture = page.locator(".playground img")
    assert picture.is_visible() and picture.evaluate("image => image.decode()") is None
    assert page.locator(".kf-sentence").is_visible()
    assert page.locator("article pre, article .output, article math").evaluate_all(WIDE) == []
    line = page.locator("article .output pre").first
    line.evaluate("pre => pre.textContent = '0'.repeat(82)")
    one = line.evaluate("pre => pre.clientHeight")
    line.evaluate("pre => pre.textContent = '0'")
    assert one == line.evaluate("pre => pre.clientHeight")
