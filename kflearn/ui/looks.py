"""What each role looks like: its colour, its line and its markers, and the style of all figures."""

from contextlib import AbstractContextManager
from pathlib import Path

from matplotlib import rc_context

STYLE = Path(__file__).with_name("kflearn.mplstyle")

colours = {
    "truth": "#000000",
    "measurement": "#808080",
    "prediction": "#E69F00",
    "estimate": "#0072B2",
    "gain": "#009E73",
    "outlier": "#D55E00",
}
BAND = 0.2  # how much of the colour is left in a ±2σ band or under a bell

LINES = {
    "truth": dict(linestyle="-", linewidth=1.0, zorder=2.4),
    "measurement": dict(linestyle="none", marker="o", markersize=3.5, zorder=2.1),
    "prediction": dict(linestyle="--", linewidth=1.5, marker="^", markersize=5, zorder=2.5),
    "estimate": dict(linestyle="-", linewidth=2.0, zorder=2.6),
    "gain": dict(linestyle="-.", linewidth=1.8, marker="D", markersize=4, zorder=2.6),
    "outlier": dict(linestyle="none", marker="x", markersize=7, markeredgewidth=2.0, zorder=2.7),
}


def style() -> AbstractContextManager:
    """The course's matplotlib style, as a context; `figure` and the playground use it themselves.

    Returns
    -------
    context manager
        Inside `with style():`, what matplotlib makes has the course's letters, lines and grid.

    Examples
    --------
    >>> from matplotlib import rcParams
    >>> with style():
    ...     rcParams["figure.dpi"]
    100.0
    """
    return rc_context(fname=STYLE)


def look_of(role, look) -> dict:
    """The matplotlib settings of a role's line; those in `look` come before the course's own."""
    return {"color": colours[role], **LINES[role], **look}
