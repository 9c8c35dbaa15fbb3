"""The labels of controls as HTML: words as they are, formulas as drawings that take the colour of the words."""

import html
import re
from functools import cache

import numpy as np

SIZE = 100  # points of the letters while they are drawn


def plain(text) -> str:
    """A label in words, for those who hear it: r"$\\sigma_x$" is "sigma x"."""
    return re.sub(r"_", " ", re.sub(r"[$\\{}]", "", text)).strip()


@cache
def as_html(text) -> str:
    """A label with LaTeX between $ … $; a mere word between them is text too."""
    parts = re.split(r"(\$.*?\$)", re.sub(r"\$([^\W_]{3,})\$", r"\1", text))
    return "".join(_formula(part) if part.startswith("$") else html.escape(part) for part in parts if part)


def _formula(text):
    """A formula as SVG, in units of the size of the letters around it."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    points, codes = TextToPath().get_text_path(FontProperties(size=SIZE), text, ismath=True)
    (left, low), (right, high) = np.min(points, axis=0), np.max(points, axis=0)
    low = min(low, 0)
    box = f"{left:.0f} {-high:.0f} {right - left:.0f} {high - low:.0f}"
    look = f"height:{(high - low) / SIZE:.3f}em;vertical-align:{low / SIZE:.3f}em"
    return f'<svg aria-hidden="true" viewBox="{box}" style="{look}"><path d="{_outline(points, codes)}"/></svg>'


def _outline(points, codes):
    """The points of letters as the commands of an SVG path."""
    letters, written, last = {1: "M", 2: "L", 3: "Q", 4: "C"}, [], None
    for (x, y), code in zip(points, codes, strict=True):
        again = code == last and code != 1  # more points for the same command
        written.append(letters[code] * (not again) + f"{x:.0f} {-y:.0f}" if code in letters else "Z")
        last = code
    return " ".join(written)
