"""The site that runs in a browser without an installation; most of it only where `make lite` has built it."""

import json
import os
import re
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import nbformat
import pytest

from dev.lab import ASK, CHROMIUM, ROOT, browser
from dev.lessons import lessons
from dev.lite import build, guest, pure, pyodide, wasm

BUILT = os.environ.get("KFLEARN_LITE")
FUSION = "04-gaussian-fusion.ipynb"
WAIT = 120_000  # milliseconds until Python runs in the browser
pytestmark = pytest.mark.timeout(300)
of_the_site = pytest.mark.skipif(not BUILT, reason="only with KFLEARN_LITE=folder: `make lite`")


def texts_in(notebook):
    """The texts of all outputs of a notebook's JSON that are shown as something else than plain text."""
    outputs = [output for cell in notebook["cells"] for output in cell.get("outputs", [])]
    return [text for output in outputs for text in output.get("data", {}).values() if not isinstance(text, dict)]


@pytest.mark.parametrize("path", lessons(), ids=lambda path: path.stem)
def test_a_lesson_begins_with_its_installation_and_keeps_the_rest(path):
    before = json.loads(path.read_text(encoding="utf-8"))
    after = build.for_browser(json.loads(path.read_text(encoding="utf-8")))
    nbformat.validate(nbformat.from_dict(after | {"nbformat": 4, "nbformat_minor": 5}))
    assert after["cells"][0] == before["cells"][0]
    assert "%pip install -q kflearn " in after["cells"][1]["source"]
    assert [cell["id"] for cell in after["cells"][2:]] == [cell["id"] for cell in before["cells"][1:]]
    assert all(isinstance(text, str) for text in texts_in(after))
    assert ["".join(text) for text in texts_in(after)] == ["".join(text) for text in texts_in(before)]


def test_there_are_outputs_whose_form_matters():
    found = [texts_in(json.loads(path.read_text(encoding="utf-8"))) for path in lessons()]
    assert any(isinstance(text, list) for texts in found for text in texts)


def test_what_is_installed_is_what_the_lessons_and_the_package_need():
    names = pure.needed()
    assert {"anywidget", "filterpy", "ipywidgets", "pandas"} <= set(names) and "ipykernel" not in names
    assert not [name for name in names if re.search(r"[^\w-]", name)], "names without versions"


def printing(folder, *cells):
    """A notebook of code cells, each with what it is said to have printed."""
    made = [
        {"cell_type": "code", "id": name, "source": source, "outputs": [{"output_type": "stream", "text": [text]}]}
        for name, source, text in cells
    ]
    path = folder / "lesson.ipynb"
    path.write_text(json.dumps({"cells": made}), encoding="utf-8")
    return path


def test_under_webassembly_a_cell_that_prints_otherwise_is_named(tmp_path, capsys):
    cells = ("same", "x = 2\nprint(x)", "2\n"), ("other", "print(x / 3)", "0.6667\n"), ("last", "x + 1;", "")
    names, other, count = guest.lesson(printing(tmp_path, *cells))
    assert (names["x"], other, count) == (2, ["other"], 3)
    assert "lesson.ipynb, other printed\n0.666" in capsys.readouterr().err
    assert wasm.line("04", {"cells": 3, "other": other}) == "04: 3 cells; printed otherwise in other"


def imports_of_lesson_4():
    """The imports of all cells of lesson 4, which its solutions need."""
    cells = json.loads((ROOT / "notebooks" / FUSION).read_text(encoding="utf-8"))["cells"]
    sources = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    lines = [line for source in sources for line in source.splitlines() if re.match(r"(from|import) ", line)]
    return "\n".join(lines)


def test_under_webassembly_solutions_are_checked():
    from kflearn.exercises import gaussian_fusion
    from kflearn.exercises.engine import exercises_of

    names = {"exercises": gaussian_fusion}
    exec(imports_of_lesson_4(), names)
    assert guest.solved(names) == len(exercises_of(gaussian_fusion)) >= 3


def test_pyodide_brings_what_its_packages_depend_on():
    packages = {"a": {"depends": ["B_c", "d"]}, "b-c": {"depends": ["a"]}, "d": {"depends": []}, "e": {"depends": []}}
    assert set(pyodide.all_of(["a"], packages)) == {"a", "b-c", "d"}


def test_a_copy_of_another_pyodide_is_refused(tmp_path):
    schema = tmp_path / "site" / build.EXTENSION
    schema.parent.mkdir(parents=True)
    default = {"default": "https://cdn.example.org/pyodide/v314.0.6/full/pyodide.mjs"}
    schema.write_text(json.dumps({"properties": {"pyodideUrl": default}}), encoding="utf-8")
    (tmp_path / "package.json").write_text('{"version": "0.27.1"}', encoding="utf-8")
    with pytest.raises(SystemExit, match=r"is Pyodide 0\.27\.1\. This JupyterLite was made for 314\.0\.6"):
        build.beside(tmp_path, tmp_path / "site")


# ---- the site as it was built


@of_the_site
def test_the_site_has_all_lessons_and_wheels():
    listed = json.loads(Path(BUILT, "api", "contents", "all.json").read_text(encoding="utf-8"))["content"]
    assert {path.name for path in lessons()} <= {each["name"] for each in listed}
    for path in lessons():
        notebook = json.loads(Path(BUILT, "files", path.name).read_text(encoding="utf-8"))
        assert all(isinstance(text, str) for text in texts_in(notebook)), path.name
    wheels = json.loads(Path(BUILT, "pypi", "all.json").read_text(encoding="utf-8"))
    assert {name.replace("_", "-") for name in ("kflearn", *pure.SITE)} <= {name.replace("_", "-") for name in wheels}


@of_the_site
def test_the_class_guide_names_the_pyodide_that_fits():
    guide = (ROOT / "class" / "README.md").read_text(encoding="utf-8")
    assert f"pyodide-{build.version(Path(BUILT))}.tar.bz2" in guide


@pytest.fixture(scope="module")
def with_core(tmp_path_factory):
    """A copy of the site with Pyodide, but without Pyodide's compiled packages, which are in no registry."""
    folder = tmp_path_factory.mktemp("lite")
    site = folder / "site"
    build.shutil.copytree(BUILT, site)
    if not pyodide.without_compiled(build.version(site), folder / "pyodide"):
        pytest.skip("npm, which brings Pyodide's core, is not here or not reachable")
    build.beside(folder / "pyodide", site)
    file = site / "jupyter-lite.json"
    config = json.loads(file.read_text(encoding="utf-8"))
    config["jupyter-config-data"]["exposeAppInBrowser"] = True  # for the test's questions to the kernel
    file.write_text(json.dumps(config), encoding="utf-8")
    return site


@pytest.fixture(scope="module")
def address(with_core):
    """Where a server shows it."""

    class Quiet(SimpleHTTPRequestHandler):
        extensions_map = SimpleHTTPRequestHandler.extensions_map | {".mjs": "text/javascript"}

        def log_message(self, *args):
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(with_core))) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()
        thread.join()


@pytest.fixture(scope="module")
def lesson(address):
    """Lesson 4 in the lab, its Python running; and what was asked for elsewhere, and what was not there."""
    if not CHROMIUM:
        pytest.skip("no chromium, chromium-browser or google-chrome on the PATH")
    with browser() as chromium:
        page = chromium.new_page(viewport={"width": 1280, "height": 900})
        page.set_default_timeout(WAIT)
        elsewhere, missing, own = [], [], (address, "data:", "blob:")
        page.context.on("request", lambda r: None if r.url.startswith(own) else elsewhere.append(r.url))
        page.context.on("response", lambda r: missing.append(r.url) if r.status >= 400 else None)
        page.goto(f"{address}lab/index.html?path={FUSION}")
        page.locator(".jp-NotebookPanel .jp-Cell").first.wait_for()
        page.wait_for_function("() => jupyterapp.shell.currentWidget?.sessionContext?.session?.kernel")
        yield page, elsewhere, missing


@of_the_site
@pytest.mark.browser
def test_the_lab_opens_and_lists_the_lessons(lesson):
    page, *_ = lesson
    names = page.locator(".jp-DirListing-itemText").all_inner_texts()
    assert {path.name for path in lessons()} <= set(names)
    page.evaluate("() => jupyterapp.commands.execute('toc:show-panel')")
    headings = page.locator(".jp-tocItem-content")
    headings.first.wait_for()
    assert headings.count() >= 8


@of_the_site
@pytest.mark.browser
def test_python_of_32_bits_runs_in_the_browser_without_threads(lesson):
    page, *_ = lesson
    assert page.evaluate(ASK, "import sys; print(sys.platform, sys.maxsize)") == f"emscripten {2**31 - 1}\n"
    assert "can't start new thread" in page.evaluate(ASK, "import threading; threading.Timer(1, print).start()")


@of_the_site
@pytest.mark.browser
def test_python_and_the_lab_have_the_same_files(lesson):
    """So that a learner's recording, which the lab takes from the disk, can be read, and points are kept."""
    page, *_ = lesson
    written = f"import os; print(os.path.exists({FUSION!r})); print('a,b', file=open('mine.csv', 'w'), flush=True)"
    assert page.evaluate(ASK, written) == "True\n"
    found = "async () => (await jupyterapp.serviceManager.contents.get('', {content: true})).content.map(e => e.name)"
    assert "mine.csv" in page.evaluate(found)


@of_the_site
@pytest.mark.browser
def test_the_first_cell_installs_all_but_the_compiled_packages(lesson, with_core):
    page, elsewhere, missing = lesson
    notebook = json.loads((with_core / "files" / FUSION).read_text(encoding="utf-8"))
    page.evaluate(ASK, notebook["cells"][1]["source"])
    ask = "from importlib.metadata import version; print(*(version(name) for name in {}))".format
    versions = pure.pins()
    said = page.evaluate(ASK, ask(["kflearn", *pure.SITE])).split()
    (mine,) = re.findall(r'__version__ = "(.*)"', (ROOT / "kflearn" / "__init__.py").read_text(encoding="utf-8"))
    assert said == [mine, *(versions[name] for name in pure.SITE)]
    wheels = {re.sub(r"-.*", "", url.rpartition("/")[2]) for url in missing if url.endswith(".whl")}
    assert wheels >= {"numpy", "scipy", "matplotlib", "pandas", "pillow"}
    assert all("pyemscripten" in url for url in missing if url.endswith(".whl")), missing
    assert not elsewhere, "everything else comes from the site itself"
    assert "numpy" in page.evaluate(ASK, "import kflearn")
