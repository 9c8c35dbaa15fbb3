"""Make slides of a lesson with nbconvert: `make slides LESSON=04`, or

    python -m dev.teaching.slides 04            build/slides/04.slides.html

The slides are the lesson as it is stored, up to its exercises: a heading begins a slide (to the right), what does not
fit continues below (down). The code of pictures is left out. Everything is in the one file: reveal.js from the package
sphinx-revealjs, formulas written by math-core.

A lesson is cut into pieces: a paragraph, a table, the code of a cell, one of its outputs. The height of each is
estimated, and `pages` fills slides with them; a picture then takes the room that is left. The test measures all slides
in a browser. Should one be too high with other fonts, the script in `slide_page.py` makes it smaller.
"""

import argparse
import html
import re
import sys
from base64 import b64decode
from functools import cache
from importlib.util import find_spec
from io import BytesIO
from itertools import pairwise
from math import ceil
from pathlib import Path
from typing import NamedTuple

import nbformat
from math_core import LatexToMathML
from nbconvert.exporters import SlidesExporter
from PIL import Image
from traitlets.config import Config

from dev.teaching.slide_page import STYLE, TEMPLATE

ROOT = Path(__file__).parents[2]
ROOM, WIDE = 650, 1184  # px of a slide of 1280 × 720 that can be filled
LETTERS = 88  # in a line of text
SMALL = 96  # code with a line longer than this is set smaller
LIVE_ONLY = "*The outputs below are stored"  # begins a paragraph that means the notebook
# What is done by hand: sliders and rings; slides have a picture in their place
BY_HAND = r"(?m)\s*\bNow (?:move|you; press) .*[.:)]$|\s*(?:\*\*)?(?:Or t|T)ake hold [^.\n]*[.:]"


class Piece(NamedTuple):
    """What is not cut: a cell of the slides with its height in px.

    begins : it is a heading, which begins a slide
    announces : it wants what follows on its own slide
    """

    cell: nbformat.NotebookNode
    height: float
    begins: bool = False
    announces: bool = False


# ---- text


def paragraphs(text):
    """The parts of a text cell that stay together: paragraphs, lists, tables, formulas, headings."""
    text = re.sub(r"\b(Then t|T)ry three things", "In the notebook, try three things", re.sub(BY_HAND, "", text))
    return [part for part in re.split(r"\n\n+", text) if part.strip() and not part.startswith(LIVE_ONLY)]


def formulas(text):
    """LaTeX between $ … $ or $$ … $$ as MathML, where code is left alone."""

    def one(found):
        if found[1]:
            return found[1]
        block = found[2] is not None
        return LatexToMathML().convert_with_local_state(found[2] or found[3], displaystyle=block)

    return re.sub(r"(`[^`]*`)|\$\$(.*?)\$\$|\$([^$]+)\$", one, text, flags=re.DOTALL)


def seen(line):
    """A line of Markdown about as long as it is seen: no addresses of links, no commands of LaTeX."""
    return re.sub(r"\]\([^)]*\)|\\[a-z]+|[{}$*`\[\\]", "", line)


def rows(line, letters=LETTERS):
    """How many lines on the slide a line of Markdown takes."""
    return 1 + (len(seen(line)) - 1) // letters


def table_height(part):
    """A table's height: a row is as high as the fullest of its cells, and long cells share the width."""
    cells = [[len(seen(cell)) for cell in line.strip("| ").split("|")] for line in part.splitlines()]
    widths = [max(column) for column in zip(*cells, strict=False)]
    narrow = max(1, sum(widths) / (1.1 * LETTERS))
    lines = [max(length * narrow / wide for length, wide in zip(row, widths, strict=False)) for row in cells]
    return sum(10 + 24 * ceil(most) for most in lines) - 24


def height(part):
    """The height of a paragraph on a slide, in px."""
    if part.startswith("$$"):
        breaks = max(block.count(r"\\") for block in part.split(r"\end"))  # of lines, in the highest matrix
        return (96 if "frac" in part or breaks else 56) + 33 * max(0, breaks - 1)
    if part.startswith("|"):
        return table_height(part)
    if part.startswith("#"):
        return 24 + 48 * rows(part, 55)
    return 24 + 34 * sum(map(rows, part.splitlines()))


def text_piece(part):
    begins = re.match(r"#{1,2} ", part) is not None
    unfinished = re.search(r"[\w:]\**\s*$", part) is not None  # no full stop: a formula, code or a picture follows
    return Piece(nbformat.v4.new_markdown_cell(part), height(part), begins, begins or unfinished)


# ---- code and outputs


def code_piece(source, announces):
    """The code of a cell, without its outputs; it announces them if there are any."""
    cell, lines = nbformat.v4.new_code_cell(source), source.splitlines()
    small = max(map(len, lines)) > SMALL
    cell.metadata.tags = ["small"] if small else []
    return Piece(cell, 30 + (20.8 if small else 24.7) * len(lines), announces=announces)


def picture(output):
    return output.get("data", {}).get("image/png")


def picture_size(output):
    return Image.open(BytesIO(b64decode(picture(output)))).size


def output_piece(output):
    """An output on its own; a picture at nine tenths of its size, which `enlarge` changes."""
    cell = nbformat.v4.new_code_cell(outputs=[output], metadata={"tags": ["no-code"]})
    if picture(output):
        return Piece(cell, 20 + 0.9 * picture_size(output)[1], announces=True)
    text = output.text if output.output_type == "stream" else output.data["text/plain"]
    return Piece(cell, 24 + 24.7 * sum(1 + len(line) // SMALL for line in text.splitlines()))


def code_pieces(cell):
    """What is shown of a code cell: its outputs, and before them its code unless it draws."""
    in_words = "text/html"  # of a figure, for those who cannot see it: its alternative text says the same
    outputs = [output for output in cell.outputs if in_words not in output.get("data", {})]
    if not any(map(picture, outputs)) and (outputs or cell.source.count("\n") < 6):
        yield code_piece(cell.source, bool(outputs))
    yield from map(output_piece, outputs)


# ---- slides


def pieces(notebook):
    """What is shown, piece by piece, up to the exercises."""
    for cell in notebook.cells:
        if cell.cell_type == "code":
            yield from code_pieces(cell)
            continue
        for part in paragraphs(cell.source):
            if re.match("## Exercises", part):
                return
            yield text_piece(part)


def together(pieces):
    """The height of the first piece and of those that it wants on its slide, as far as a slide can hold them."""
    total = pieces[0].height
    for piece, following in pairwise(pieces):
        if not piece.announces or following.begins or total + following.height > ROOM:
            break
        total += following.height
    return total


def pages(pieces):
    """The pieces slide by slide."""
    found = []
    for number, piece in enumerate(pieces):
        if piece.begins or not found:
            found.append([piece])
            continue
        page = found[-1]
        announced = all(before.announces for before in page)
        needed = piece.height if announced else together(pieces[number:])
        if sum(before.height for before in page) + needed > ROOM:
            found.append([piece])
        else:
            page.append(piece)
    return found


def enlarge(page):
    """Give a slide's pictures the room that its other pieces leave."""
    outputs = [output for piece in page for output in piece.cell.get("outputs", []) if picture(output)]
    spare = (ROOM - sum(piece.height for piece in page)) / max(1, len(outputs))
    for output in outputs:
        wide, high = picture_size(output)
        scale = min(1.4, WIDE / wide, 0.9 + spare / high)
        output.metadata["image/png"] |= {"width": round(scale * wide), "height": round(scale * high)}


def deck(notebook, name):
    """The notebook of the slides: cells with the marks that nbconvert reads."""
    end = f"Continue in the notebook **{name}**: its sliders move the pictures, its exercises check your answers."
    found = pages([*pieces(notebook), text_piece("## Now you"), text_piece(end)])
    for page in found:
        enlarge(page)
        for piece in page:
            piece.cell.metadata.slideshow = {"slide_type": "-"}
        page[0].cell.metadata.slideshow.slide_type = "slide" if page[0].begins else "subslide"
    notebook.cells = [piece.cell for page in found for piece in page]
    return notebook


@cache
def exporter():
    """What nbconvert makes slides with; it is slow to start, so all lessons share it."""
    config = Config()
    config.TagRemovePreprocessor.remove_input_tags = {"no-code"}
    config.TagRemovePreprocessor.enabled = True
    made = SlidesExporter(config=config, raw_template=TEMPLATE)
    made.exclude_input_prompt = made.exclude_output_prompt = True
    return made


def slides(path):
    """The HTML of a lesson's slides, complete in itself."""
    notebook = deck(nbformat.read(path, as_version=4), path.stem)
    file_beside = r"\[([^\]]*)\]\((?!https?:)[^)]*\)"  # the slides are one file: of such a link the words stay
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = formulas(re.sub(file_beside, r"\1", cell.source))
    page, _ = exporter().from_notebook_node(notebook, {"metadata": {"name": path.stem}})
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
