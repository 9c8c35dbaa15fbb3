"""Build the course as a web page: `make site`, or

    python -m dev.web.build                        everything, into build/site
    python -m dev.web.build --only 04,05 --out X   some lessons, into X

The committed notebooks with their outputs become pages. Each playground becomes pictures for a grid of its controls'
values, and controls which choose among them; for these a lesson is executed once, up to its last playground, and the
pictures stay in build/frames until the lesson or the package changes. Nothing is downloaded.

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
from dev.web import about, card, frames, teaches

ROOT = Path(__file__).parents[2]
PAGES = Path(__file__).parent / "pages"
NOTEBOOKS, PACKAGE, FRAMES = ROOT / "notebooks", ROOT / "kflearn", ROOT / "build" / "frames"
LINK = r"\[([^\]]*)\]\(([\w-]+\.(?:ipynb|md))\)"
ONE_AT_A_TIME = "On this page one slider moves at a time, the others go back to their start. In JupyterLab all move."


# ---- a playground without a kernel


def is_playground(output):
    return "image/png" in output.get("data", {}) and output.data["text/plain"].startswith("Playground:")


def film(name, notebook):
    """The folder with a folder of pictures for each playground. Executes the lesson, unless nothing has changed."""
    shown = [sum(map(is_playground, cell.get("outputs", []))) for cell in notebook.cells]
    last = max((i for i, count in enumerate(shown) if count), default=-1)
    sources = [cell.source for cell in notebook.cells[: last + 1] if cell.cell_type == "code"]
    files = [Path(frames.__file__), *sorted(PACKAGE.rglob("*.py")), *sorted(PACKAGE.rglob("*.mplstyle"))]
    parts = [*(file.read_bytes() for file in files), *(source.encode() for source in sources)]
    folder = FRAMES / f"{name}-{sha256(b''.join(parts)).hexdigest()[:12]}"
    if sources and not folder.exists():
        FRAMES.mkdir(parents=True, exist_ok=True)
        for old in FRAMES.glob(f"{name}-*"):
            shutil.rmtree(old)
        with tempfile.TemporaryDirectory(dir=FRAMES) as draft:
            new = Path(draft, name)
            execute(sources, str(new))
            assert len(list(new.glob("*/frames.json"))) == sum(shown), f"pictures of {name} could not be made"
            new.rename(folder)
        print("pictures for", name, flush=True)
    return folder


def execute(sources, folder):
    """Run cells of code in a new kernel, which leaves the pictures of each playground it shows in the folder."""
    from nbclient import NotebookClient

    watch = f"from dev.web import frames; frames.watch({folder!r})"
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in (watch, *sources)])
    how = dict(extra_arguments=["--log-level=ERROR"], resources={"metadata": {"path": NOTEBOOKS}})
    client = NotebookClient(notebook, timeout=600, kernel_name="python3", **how)
    asyncio.run(client.async_execute(env=os.environ | {"PYTHONPATH": str(ROOT)}))


def figure(folder, name):
    """The HTML of a playground: its first picture, and controls for the script playground.js."""
    page = json.loads((folder / "frames.json").read_text(encoding="utf-8"))
    picture, sentence = page["frames"][",".join(map(str, page["start"]))]
    controls = zip(page["controls"], page["start"], strict=True)
    fields = "\n".join(field(f"{name}-{i}", control, start) for i, (control, start) in enumerate(controls))
    note = "" if page["together"] else f"<figcaption>{ONE_AT_A_TIME}</figcaption>"
    data = {key: page[key] for key in ("text", "start", "together", "frames")}
    script = json.dumps(data, ensure_ascii=False).replace("</", r"<\/")
    alt = html.escape(f"{page['text']}. {sentence}")
    width, height = page["size"]
    return f"""<figure class="playground" style="max-width: {width}px">
<form hidden>{fields}<button type="reset">Reset</button></form>
<p role="status" aria-live="polite">{html.escape(sentence)}</p>
<div><img src="_static/frames/{name}/{picture}.webp" width="{width}" height="{height}" alt="{alt}"></div>{note}
<script type="application/json">{script}</script>
</figure>"""


def field(name, control, start):
    """The HTML of a control: a slider over its places, or a row of buttons."""
    label, plain, texts = mathematics(control["label"]), html.escape(control["name"]), control["texts"]
    if control["slider"]:
        widest = max(map(len, texts))  # else the slider would change its length while it moves
        return f"""<label><span>{label}</span> <input type="range" max="{len(texts) - 1}" value="{start}"
aria-label="{plain}" data-texts="{html.escape(json.dumps(texts, ensure_ascii=False))}">
<output style="min-width: {widest}ch"></output></label>"""
    buttons = "".join(
        f'<label><input type="radio" name="{name}" value="{i}"{" checked" * (i == start)}>{html.escape(text)}</label>'
        for i, text in enumerate(texts)
    )
    return f"<fieldset><legend>{label}</legend>{buttons}</fieldset>"


def mathematics(text):
    """HTML of a text with LaTeX between $ … $; a mere word there is text too."""
    from math_core import LatexToMathML

    parts = re.split(r"\$(.*?)\$", re.sub(r"\$(\w{3,})\$", r"\1", text))
    parts[1::2] = [LatexToMathML().convert_with_local_state(part, displaystyle=False) for part in parts[1::2]]
    parts[::2] = map(html.escape, parts[::2])
    return "".join(parts)


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
        filmed = list(pool.map(film, [path.stem for path in lessons], notebooks))
    shutil.copytree(PAGES, folder, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(NOTEBOOKS / "pictures", folder / "pictures")
    maths_font(folder / "static" / "maths.woff")
    texts = {path.name: path for path in sorted(NOTEBOOKS.glob("*.md"))}
    texts |= {"class-server.md": ROOT / "class" / "README.md", "changelog.md": ROOT / "CHANGELOG.md"}
    pages, alts = [*(path.name for path in lessons), *texts], {}
    facts = leads(lessons, pages, folder)
    for path, notebook, pictures in zip(lessons, notebooks, filmed, strict=True):
        alts |= page(notebook, about.note(path.name, facts["zip"]), pictures, pages)
        nbformat.write(notebook, folder / path.name)
        for picture in pictures.glob("*/*.webp"):
            copy = folder / "static" / "frames" / picture.relative_to(FRAMES)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(picture, copy)
    for name, path in texts.items():
        text = path.read_text(encoding="utf-8").replace("](../notebooks/", "](")
        (folder / name).write_text(relink(text, pages), encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8").replace("](notebooks/", "](")
    readme = readme.replace("](class/README.md)", "](class-server.md)").replace("](CHANGELOG.md)", "](changelog.md)")
    (folder / "README.md").write_text(relink(about.without(about.FOLDER, readme), pages), encoding="utf-8")
    (folder / "alts.json").write_text(json.dumps(alts), encoding="utf-8")
    index = (folder / "index.md").read_text(encoding="utf-8").replace("PLAYGROUND", sample(filmed))
    index = index.replace("WHERE", about.where(facts))
    toctree = "\n".join(["", "```{toctree}", ":hidden:", *pages, "```", ""])
    (folder / "index.md").write_text(index + toctree, encoding="utf-8")


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
