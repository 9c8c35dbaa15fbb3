"""Make slides of a lesson with nbconvert: `make slides LESSON=04`, or

    python tools/slides.py 04            build/slides/04.slides.html

The slides are the lesson as it is stored, up to its exercises: a heading begins a slide (to the right), what does not
fit continues below (down). The code of pictures is left out. Everything is in the one file: reveal.js from the package
sphinx-revealjs, formulas written by math-core.
"""

import argparse
import html
import re
import sys
from base64 import b64decode
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path

import nbformat
from math_core import LatexToMathML
from nbconvert.exporters import SlidesExporter
from PIL import Image
from traitlets.config import Config

ROOT = Path(__file__).parent.parent
LINES, WIDTH = 21, 82  # that fit on a slide
STYLE = """<style>
.reveal { font-size: 22px; }
.reveal .slides { text-align: left; }
.reveal h1, .reveal h2 { font-size: 1.7em; text-transform: none; margin: 0 0 0.5em; }
.reveal p { margin: 0.5em 0; line-height: 1.4; }
.reveal img { max-height: 460px; width: auto; margin: 0; }
.reveal pre { font-size: 0.8em; white-space: pre-wrap; width: 100%; margin: 0.3em 0; box-shadow: none; }
.reveal .jp-Cell-inputWrapper, .reveal .jp-RenderedHTMLCommon { font-size: 1em; }
.reveal .jp-InputPrompt, .reveal .jp-OutputPrompt, .reveal .jp-InputCollapser, .reveal .jp-OutputCollapser
{ display: none; }
.reveal table { font-size: 0.8em; }
details { display: none; }
.reveal .slide-number { right: auto; left: 8px; }
math[display="block"] { margin: 0.6em 0; }
</style>"""
# What nbconvert would load from a network is left out, and reveal.js started as it lies in the file.
TEMPLATE = """{% extends 'reveal/index.html.j2' %}
{% block html_head_js_jquery %}{% endblock %}
{% block html_head_js_requirejs %}{% endblock %}
{% block html_head_js_mermaidjs %}{% endblock %}
{% block html_head_js_mathjax %}{% endblock %}
{% block footer_js %}<script>
Reveal.initialize({hash: true, center: false, controls: true, progress: true, slideNumber: "c/t", transition: "none"});
</script>{% endblock %}"""


def paragraphs(text):
    """The parts of a text cell that stay together: paragraphs, lists, tables, formulas, headings."""
    return [part for part in re.split(r"\n\n+", text) if part.strip()]


def formulas(text):
    """LaTeX between $ … $ or $$ … $$ as MathML, where code is left alone."""

    def one(found):
        if found[1]:
            return found[1]
        block = found[2] is not None
        return LatexToMathML().convert_with_local_state(found[2] or found[3], displaystyle=block)

    return re.sub(r"(`[^`]*`)|\$\$(.*?)\$\$|\$([^$]+)\$", one, text, flags=re.DOTALL)


def is_heading(part):
    return re.match(r"#{1,2} ", part) is not None


def height(part):
    """Lines that a paragraph takes on a slide."""
    if part.startswith("$$"):
        return 3 + 2 * part.count(r"\begin")
    if part.startswith("|"):
        return part.count("\n") + 1
    return sum(1 + len(line) // WIDTH for line in part.splitlines()) + (2 if is_heading(part) else 0.6)


def pictures(cell):
    return [output.data["image/png"] for output in cell.outputs if "image/png" in output.get("data", {})]


def code_cell(cell):
    """A code cell as it is shown, and its height; None when there is nothing to see."""
    shown = pictures(cell)
    lines = 0.0
    for picture in shown:
        wide, high = Image.open(BytesIO(b64decode(picture))).size
        lines += min(460, high * min(1, 920 / wide)) / 29 + 0.5
    for output in cell.outputs:
        if output.output_type == "stream":
            lines += 1 + output.text.count("\n")
        elif "data" in output and not shown:
            lines += 1 + output.data.get("text/plain", "").count("\n")
    code = cell.source.count("\n") + 1
    if shown or code > LINES - 4:
        cell.metadata.tags = ["no-code"]
    else:
        lines += 0.9 * code + 1
    return (cell, lines) if cell.outputs or code <= 6 else None


def blocks(notebook):
    """What is shown, piece by piece: (cell, height, whether it begins a slide)."""
    for cell in notebook.cells:
        if cell.cell_type == "code":
            if piece := code_cell(cell):
                yield *piece, False
            continue
        for part in paragraphs(cell.source):
            if re.match("## Exercises", part):
                return
            yield nbformat.v4.new_markdown_cell(part), height(part), is_heading(part)


def deck(notebook):
    """The notebook of the slides: cells with the marks that nbconvert reads."""
    cells, used = [], 0.0
    pieces = list(blocks(notebook))
    for number, (cell, lines, begins) in enumerate(pieces):
        following = pieces[number + 1] if number + 1 < len(pieces) else (None, 0, True)
        # a heading, a sentence that ends in a colon and a picture keep what follows them on their slide
        announces = begins or cell.source.rstrip().endswith(":") if cell.cell_type == "markdown" else pictures(cell)
        together = lines + (following[1] if announces and not following[2] else 0)
        kind = "slide" if begins else "subslide" if used > 4 and used + min(together, LINES) > LINES else "-"
        used = lines if kind != "-" else used + lines
        cell.metadata.slideshow = {"slide_type": kind}
        cells.append(cell)
    notebook.cells = cells
    return notebook


def slides(path):
    """The HTML of a lesson's slides, complete in itself."""
    notebook = deck(nbformat.read(path, as_version=4))
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = formulas(re.sub(r"\[([^\]]*)\]\(\d\d-[\w-]+\.ipynb\)", r"\1", cell.source))
    config = Config()
    config.TagRemovePreprocessor.remove_input_tags = {"no-code"}
    config.TagRemovePreprocessor.enabled = True
    exporter = SlidesExporter(config=config, raw_template=TEMPLATE)
    exporter.exclude_input_prompt = exporter.exclude_output_prompt = True
    exporter.reveal_scroll = True
    page, _ = exporter.from_notebook_node(notebook, {"metadata": {"name": path.stem}})
    title = html.escape(notebook.cells[0].source.lstrip("# "))
    page = re.sub(r"<title>.*?</title>", f"<title>{title}</title>", page, count=1)
    page = re.sub(r'<link [^>]*href="https?://[^>]*>', "", page)
    head, _, rest = page.partition("</head>")
    return f"{head}{reveal()}{STYLE}</head>{rest}"


def reveal():
    """The style sheets and the script of reveal.js, as they lie in the package sphinx-revealjs."""
    folder = Path(find_spec("sphinx_revealjs").origin).parent / "_static" / "revealjs" / "dist"
    sheets = [(folder / name).read_text("utf-8") for name in ("reveal.css", "theme/white.css")]
    sheets = [re.sub(r"@import url\([^)]*\);?", "", sheet) for sheet in sheets]
    script = (folder / "reveal.js").read_text("utf-8").replace("</script", r"<\/script")
    return "".join(f"<style>{sheet}</style>" for sheet in sheets) + f"<script>{script}</script>"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lessons", nargs="+", help="numbers of lessons, such as 04")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "slides")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    for number in options.lessons:
        path = next((ROOT / "notebooks").glob(f"{number:0>2}-*.ipynb"), None)
        if path is None:
            sys.exit(f"there is no lesson {number}")
        page = slides(path)
        target = options.out / f"{path.name[:2]}.slides.html"
        target.write_text(page, encoding="utf-8")
        print(f"{target.name}: {len(page) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
