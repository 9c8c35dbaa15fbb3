"""One picture of a step of the filter, the same in every lesson, with the part under discussion marked."""

from matplotlib.patches import FancyBboxPatch

from .figures import figure
from .looks import colours, style
from .pictures import show

INK, PALE = "#404040", "#f2f2f2"
# name: (left, width, lines, colour of the role)
PARTS = {
    "belief": (0.0, 1.5, ("belief", r"$\hat x,\ P$"), "estimate"),
    "predict": (2.0, 2.2, ("predict (5) (6)", r"$\hat x^- = F\hat x + Bu$", r"$P^- = FPF^\top + Q$"), "prediction"),
    "innovation": (4.7, 2.3, ("innovation", r"$y = z - H\hat x^-$", r"$S = HP^-H^\top + R$"), "measurement"),
    "gain": (7.5, 1.9, ("gain (7)", r"$K = P^-H^\top S^{-1}$"), "gain"),
    "correct": (9.9, 2.2, ("correct (8) (9)", r"$\hat x = \hat x^- + Ky$", r"$P = (I - KH)P^-$"), "estimate"),
}
BOTTOM, HEIGHT = 1.0, 1.5


def step_diagram(*mark) -> None:
    """Show one step of the filter as a diagram, with the parts under discussion marked.

    Parameters
    ----------
    *mark : str
        Any of "belief", "predict", "innovation", "gain", "correct".

    Raises
    ------
    ValueError
        For another name.

    Examples
    --------
    >>> from kflearn import plots
    >>> plots.step_diagram("gain")  # in a notebook, the picture  # doctest: +SKIP
    """
    if unknown := [name for name in mark if name not in PARTS]:
        raise ValueError(f"step_diagram marks {', '.join(PARTS)}; there is no {unknown[0]!r}")
    fig, _ = figure(0, size=(9, 2.4))
    fig.set_layout_engine("none")
    with style():
        draw(fig, mark)
    marked = f" Marked: {', '.join(mark)}." if mark else ""
    parts = ", ".join(PARTS)
    show(fig, f"One step of the filter, from left to right: {parts}; an arrow leads back to the belief.{marked}")


def draw(fig, mark):
    """Draw the diagram into a figure; `mark` names the parts to be filled."""
    ax = fig.add_axes((0, 0, 1, 1))
    ax.set(xlim=(-0.15, 12.25), ylim=(0, 3.3))
    ax.set_axis_off()
    for name, (left, width, lines, role) in PARTS.items():
        _box(ax, left, width, lines, colours[role] if name in mark else None)
    for (left, width, *_), (right, *_) in zip(list(PARTS.values())[:-1], list(PARTS.values())[1:], strict=True):
        _arrow(ax, (left + width, 1.75), (right, 1.75))
    ax.plot([11.0, 11.0, 0.75], [BOTTOM, 0.45, 0.45], color=INK, linewidth=1.2)
    _arrow(ax, (0.75, 0.45), (0.75, BOTTOM))
    ax.text(5.9, 0.2, "the next step", ha="center", va="center", color=INK, fontsize=9, backgroundcolor="white")
    _arrow(ax, (5.85, 3.05), (5.85, BOTTOM + HEIGHT))
    ax.text(6.0, 2.97, "reading $z$", ha="left", va="center", color=INK, fontsize=9)


def _box(ax, left, width, lines, colour):
    look = dict(facecolor=colour or PALE, edgecolor=colour or INK, alpha=0.35 if colour else 1.0)
    ax.add_patch(FancyBboxPatch((left, BOTTOM), width, HEIGHT, boxstyle="round,pad=0,rounding_size=0.15", **look))
    places = {2: (2.1, 1.5), 3: (2.2, 1.75, 1.3)}[len(lines)]
    for line, y in zip(lines, places, strict=True):
        weight = "bold" if line is lines[0] and colour else "normal"
        ax.text(left + width / 2, y, line, ha="center", va="center", fontsize=10, weight=weight)


def _arrow(ax, start, end):
    ax.annotate("", end, start, arrowprops=dict(arrowstyle="-|>", color=INK, linewidth=1.2, shrinkA=0, shrinkB=0))
