"""Build the course as a web page: `make site`, or

    python -m dev.web.build                        everything, into build/site
    python -m dev.web.build --only 04,05 --out X   some lessons, into X

The committed notebooks with their outputs become pages. The playgrounds are those of JupyterLab, with pictures recorded
for a grid of their controls' values: for these a lesson is executed once, up to its last playground, and the recordings
stay in build/frames until the lesson or the package changes. Nothing is downloaded.

Each page leads on: to its notebook, to the whole course as course.zip, and, once these addresses are known, to the
course's repository (`dev/web/about.py` says where they are set).
"""

import argparse
import asyncio
import html
import json
import os
import re
import shutil
import sys
import tempfile
from base64 import b64decode
from concurrent.futures import ThreadPoolExecutor
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

import nbformat

from dev import lessons as course
from dev.web import about, api, card, equations, frames, help, named, packed, teaches

ROOT = Path(__file__).parents[2]
PAGES = Path(__file__).parent / "pages"
NOTEBOOKS, PACKAGE, FRAMES = ROOT / "notebooks", ROOT / "kflearn", ROOT / "build" / "frames"
LINK = r"\[([^\]]*)\]\(([\w-]+\.(?:ipynb|md))\)"
TWO_AT_A_TIME = "On this page two sliders can be away from their start; when a third one moves, the one that was moved "
TWO_AT_A_TIME += "longest ago goes back. In JupyterLab all of them move."


# ---- a playground without a kernel


def is_playground(output):
    return "image/png" in output.get("data", {}) and output.data["text/plain"].startswith("Playground:")


def recorded(path, notebook):
    """The folder with a folder for each playground. Executes the lesson at path, unless nothing has changed."""
    stem, shown = path.stem, [sum(map(is_playground, cell.get("outputs", []))) for cell in notebook.cells]
    last = max((i for i, count in enumerate(shown) if count), default=-1)
    sources = [cell.source for cell in notebook.cells[: last + 1] if cell.cell_type == "code"]
    made = re.findall(r"(?m)^(\w+) = Playground\(", "\n".join(sources))
    texts = [text for name in made for text in named.text_beside(notebook.cells, name)]
    files = [*(Path(module.__file__) for module in (frames, named, packed)), *sorted(PACKAGE.rglob("*.py"))]
    parts = [*(file.read_bytes() for file in (*files, *PACKAGE.rglob("*.mplstyle"))), "".join(sources + texts).encode()]
    folder = FRAMES / f"{stem}-{sha256(b''.join(parts)).hexdigest()[:12]}"
    if sources and not folder.exists():
        FRAMES.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=FRAMES) as draft:
            new = Path(draft, stem)
            execute(sources, f"frames.watch({str(new)!r}, {str(path)!r})")
            assert len(list(new.glob("*/page.json"))) == sum(shown), f"playgrounds of {stem} could not be recorded"
            keep(new, folder)
        print("playgrounds of", stem, flush=True)
    return folder


def keep(new, folder):
    """Give a new folder its name, unless another process was faster; remove what was recorded of the lesson before."""
    try:
        new.rename(folder)
    except OSError:
        if not folder.exists():
            raise
    for old in folder.parent.glob(f"{folder.name.rpartition('-')[0]}-*"):
        if old != folder:
            shutil.rmtree(old, ignore_errors=True)


def execute(sources, watch):
    """Run cells of code in a new kernel, which records each playground it shows."""
    from nbclient import NotebookClient

    sources = (f"from dev.web import frames; {watch}", *sources)
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in sources])
    how = dict(extra_arguments=["--log-level=ERROR"], resources={"metadata": {"path": NOTEBOOKS}})
    client = NotebookClient(notebook, timeout=1200, kernel_name="python3", **how)
    asyncio.run(client.async_execute(env=os.environ | {"PYTHONPATH": str(ROOT)}))


def figure(folder, name):
    """The HTML of a playground: its first picture and its sentence, and what recorded.js needs to make it live."""
    page = json.loads((folder / "page.json").read_text(encoding="utf-8"))
    note = "" if page["together"] else f"<figcaption>{TWO_AT_A_TIME}</figcaption>"
    script = json.dumps({key: page[key] for key in ("spec", "start", "status")}, ensure_ascii=False)
    script = script.replace("<", r"\u003c")
    alt = html.escape(f"{page['spec']['text']}. {page['status']}")
    (width, height), place = page["spec"]["size"], f"_static/recorded/{name}"
    style = f"max-width: {width}px; --wide: {width}px"
    return f"""<figure class="playground" data-recorded="{place}/recorded.js" style="{style}">
<div><p class="kf-sentence">{html.escape(page["status"])}</p>
<img src="{place}/start.webp" width="{width}" height="{height}" alt="{alt}"></div>{note}
<script type="application/json">{script}</script>
</figure>"""


def playgrounds(folders, static):
    """Put what playgrounds load among the files of the page: recordings, script and style."""
    for folder in folders:
        for file in (*folder.glob("*/*.webp"), *folder.glob("*/*.js")):
            copy = static / "recorded" / file.relative_to(FRAMES)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, copy)
    (static / "recorded.js").write_text(live_script(), encoding="utf-8")
    shutil.copy(PACKAGE / "ui" / "playground.css", static)


def live_script():
    """The playground's own script and the one that answers it, in one that a page opened from a disk may load too."""
    parts = PACKAGE / "ui" / "playground.js", PAGES / "static" / "recorded.js"
    text = "\n".join(path.read_text(encoding="utf-8") for path in parts)
    return '"use strict";\n(() => {\n' + re.sub(r"(?m)^export (default .*;|)", "", text) + "})();\n"


# ---- the pages


def page(notebook, note, folder, pages):
    """Make a notebook into a page for Sphinx, in place; returns the alternative texts of its pictures by their hash."""
    alts, number = {}, 0
    notebook.cells[0].source = about.without(about.STORED, notebook.cells[0].source)
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = relink(cell.source, pages)
        for i, output in enumerate(cell.get("outputs", [])):
            if "image/png" in output.get("data", {}):
                alt = output.metadata["image/png"]["alt"]
                alts[sha256(b64decode(output.data["image/png"])).hexdigest()] = alt
                if is_playground(output):
                    shown = figure(folder / str(number), f"{folder.name}/{number}")
                    cell.outputs[i] = nbformat.v4.new_output("display_data", {"text/html": shown})
                    number += 1
    notebook.cells = help.with_help(notebook.cells)
    notebook.cells.insert(1, nbformat.v4.new_markdown_cell(note))
    notebook.metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    return alts


def relink(text, pages):
    """Of links to lessons that exist, but are not built this time, keep the words."""
    left_out = {path.name for path in NOTEBOOKS.iterdir()} - set(pages)
    return re.sub(LINK, lambda link: link[1] if link[2] in left_out else link[0], text)


def sample(folders):
    """A playground for the first page: the voltmeter's, if it is there."""
    folder = next((folder for folder in folders if "voltmeter" in folder.name), folders[0])
    return figure(folder / "0", f"{folder.name}/0")


def maths_font(path):
    """A font for the formulas, cut down to Latin, Greek and mathematical signs."""
    from fontTools import subset

    font = Path(find_spec("ziamath").origin).parent / "fonts" / "STIXTwoMath-Regular.ttf"
    options = subset.Options(flavor="woff", layout_features=["ssty", "dtls", "kern"], name_IDs=["*"])
    letters = [*range(0x20, 0x7F), *range(0xA0, 0x100), *range(0x2BC, 0x3FF), *range(0x1D434, 0x1D468)]
    signs = [*range(0x2010, 0x2060), *range(0x2190, 0x2200), *range(0x2200, 0x2300), 0x210E, 0x22A4, 0x27F8, 0x27F9]
    cutter = subset.Subsetter(options)
    cutter.populate(unicodes=[*letters, *signs, *range(0x1D6A4, 0x1D6E2)])
    with subset.load_font(font, options) as whole:
        cutter.subset(whole)
        subset.save_font(whole, path, options)


def without_heading(folder):
    """What keeps a page from being made, found before minutes are spent on pictures: a sentence, or an empty string."""
    for path in sorted([*folder.glob("*.md"), *folder.glob("[0-9][0-9]-*.ipynb")]):
        is_text = path.suffix == ".md"
        text = path.read_text(encoding="utf-8") if is_text else nbformat.read(path, as_version=4).cells[0].source
        if not re.match(r"# +\S", text):
            where = "line" if is_text else "cell"
            return f"{folder.name}/{path.name} needs a heading in its first {where}, such as: # News"
    return ""


def prepare(lessons, folder):
    """Write everything Sphinx needs into a folder."""
    notebooks = [nbformat.read(path, as_version=4) for path in lessons]
    with ThreadPoolExecutor(2) as pool:
        folders = list(pool.map(recorded, lessons, notebooks))
    shutil.copytree(PAGES, folder, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(NOTEBOOKS / "pictures", folder / "pictures")
    maths_font(folder / "static" / "maths.woff")
    playgrounds(folders, folder / "static")
    texts = {path.name: path for path in sorted(NOTEBOOKS.glob("*.md"))}
    texts |= {"class-server.md": ROOT / "class" / "README.md", "changelog.md": ROOT / "CHANGELOG.md"}
    made = {"equations.md": equations.page(lessons)}
    made |= {name: path.read_text(encoding="utf-8").replace("](../notebooks/", "](") for name, path in texts.items()}
    made |= api.pages(lessons) | {"cite.md": about.citation(ROOT)}
    pages, alts = [*(path.name for path in lessons), *made], {}
    facts = leads(lessons, pages, folder)
    for path, notebook, pictures in zip(lessons, notebooks, folders, strict=True):
        equations.mark(notebook.cells, path.name[:2])
        alts |= page(notebook, about.note(path.name, facts["zip"]), pictures, pages)
        notebook.cells.insert(-1, nbformat.v4.new_markdown_cell(api.names_of(path)))
        nbformat.write(notebook, folder / path.name)
    for name, text in made.items():
        (folder / name).write_text(relink(text, pages), encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8").replace("](notebooks/", "](")
    readme = readme.replace("](class/README.md)", "](class-server.md)").replace("](CHANGELOG.md)", "](changelog.md)")
    (folder / "README.md").write_text(relink(about.without(about.FOLDER, readme), pages), encoding="utf-8")
    (folder / "alts.json").write_text(json.dumps(alts), encoding="utf-8")
    index = (folder / "index.md").read_text(encoding="utf-8").replace("PLAYGROUND", sample(folders))
    index = index.replace("WHERE", about.where(facts))
    (folder / "index.md").write_text(index + contents(pages), encoding="utf-8")


PARTS = {  # the course's parts in the page's navigation, by the number of their first lesson
    0: "Foundations",
    8: "Practice",
    13: "Bent functions",
    18: "Several models, hidden errors",
    23: "All the data",
}


def contents(pages):
    """The page's navigation: lessons in parts, the package, and what one looks up."""
    parts = {title: [] for title in (*PARTS.values(), "The package", "To look up")}
    for page in pages:
        number = int(page[:2]) if page[:2].isdigit() else None
        if number is not None:
            parts[PARTS[max(first for first in PARTS if first <= number)]].append(page)
        else:
            parts["The package" if page.startswith("api") else "To look up"].append(page)
    lists = [
        ["", "```{toctree}", ":hidden:", f":caption: {title}", *names, "```"] for title, names in parts.items() if names
    ]
    return "\n".join([line for part in lists for line in part] + [""])


def leads(lessons, pages, folder):
    """Write what the pages lead to, and what leads to them; returns the facts on the course, as in facts.json."""
    facts, extra = about.settings(ROOT), folder / "extra"
    shutil.copytree(NOTEBOOKS, extra / "notebooks", ignore=lambda _, names: {*names} - {path.name for path in lessons})
    facts |= {"zip": about.archive(ROOT, extra / "course.zip"), "picture_alt": card.ALT}
    (folder / "facts.json").write_text(json.dumps(facts), encoding="utf-8")
    (folder / "static" / "card.png").write_bytes(card.card())
    glossary = (NOTEBOOKS / "appendix-glossary.md").read_text(encoding="utf-8")
    rewrite(folder / "scorer.js", "TAUGHT", teaches.as_json(glossary))
    start = "/".join(filter(None, [facts["site"], "index.html"]))
    rewrite(extra / "404.html", "START", start)
    if site := facts["site"]:
        names = ["index.html", *(f"{Path(name).stem}.html" for name in pages)]
        (extra / "sitemap.xml").write_text(about.sitemap(names, site), encoding="utf-8")
        (extra / "robots.txt").write_text(f"User-agent: *\nAllow: /\nSitemap: {site}/sitemap.xml\n", encoding="utf-8")
    return facts


def rewrite(path, word, text):
    """Put a text into a file, in place of a word in capitals."""
    path.write_text(path.read_text(encoding="utf-8").replace(word, text), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", help="the numbers of some lessons, such as 04,05", default="")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "site")
    options = parser.parse_args()
    lessons = [path for path in course.lessons() if path.name[:2] in (options.only or path.name)]
    if trouble := without_heading(NOTEBOOKS):
        sys.exit(trouble)
    from sphinx.cmd.build import build_main as sphinx

    with tempfile.TemporaryDirectory() as draft:
        prepare(lessons, Path(draft, "pages"))
        if failed := sphinx(["-q", "-W", "--keep-going", "-d", f"{draft}/doctrees", f"{draft}/pages", f"{draft}/site"]):
            sys.exit(failed)
        if (options.out / ".buildinfo").exists():  # a page built before, nothing else
            shutil.rmtree(options.out)
        shutil.copytree(f"{draft}/site", options.out)
    print(f"open {options.out / 'index.html'}")


if __name__ == "__main__":
    main()
