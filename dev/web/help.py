"""What a reader of the web page cannot call: the hints and the solution of each exercise, folded up under its cell."""

import html
import re
from importlib import import_module

from nbformat.v4 import new_markdown_cell


def with_help(cells):
    """The cells of a lesson, and after each cell of an exercise one that holds its hints and its solution."""
    found, module = [], None
    for cell in cells:
        found.append(cell)
        if cell.cell_type != "code":
            continue
        if made := re.search(r"from kflearn\.exercises import (\w+) as exercises", cell.source):
            module = import_module(f"kflearn.exercises.{made[1]}")
        if asked := re.search(r"(?m)^exercises\.(\w+)\.check\(", cell.source):
            found.append(new_markdown_cell(folded(getattr(module, asked[1]))))
    return found


def folded(exercise):
    """Hints and solution as HTML that opens on a click, each hint by itself: the next one is stronger."""
    hints = [hint(None) if callable(hint) else hint for hint in exercise.hints]
    parts = [(f"Hint {i} of {len(hints)}", f"<p>{in_words(hint)}</p>") for i, hint in enumerate(hints, 1)]
    parts.append(("Solution", f"<pre>{html.escape(exercise.solution().text)}</pre>"))
    shown = "\n".join(f"<details><summary>{name}</summary>{text}</details>" for name, text in parts)
    return f'<div class="help">\n{shown}\n</div>'


def in_words(text):
    """A hint as HTML: what stands between backticks is code."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(text, quote=False))
