"""One visual vocabulary for every figure of the course.

The same thing looks the same everywhere, and never by its colour alone:

    truth         black, thin solid line
    measurement   grey dots
    prediction    orange, dashed line with triangles
    estimate      blue, thick solid line with a band of ±2 standard deviations
    gain          green, dash-dotted line with diamonds
    outlier       vermilion crosses

Each function draws one of them on matplotlib axes and returns it as an object with a `set` method, so that a live
picture is changed in place: `line = estimate(ax, t, mean, std)`, later `line.set(t, mean, std)`. Figures are made
without pyplot: nothing is registered, nothing has to be closed, and `show(fig, alt)` puts a figure into the notebook
with words for those who cannot see it.
"""

import html
import io
from functools import cache
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

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

_looks = {
    "truth": dict(linestyle="-", linewidth=1.0, zorder=2.4),
    "measurement": dict(linestyle="none", marker="o", markersize=3.5, zorder=2.1),
    "prediction": dict(linestyle="--", linewidth=1.5, marker="^", markersize=5, zorder=2.5),
    "estimate": dict(linestyle="-", linewidth=2.0, zorder=2.6),
    "gain": dict(linestyle="-.", linewidth=1.8, marker="D", markersize=4, zorder=2.6),
    "outlier": dict(linestyle="none", marker="x", markersize=7, markeredgewidth=2.0, zorder=2.7),
}


# ---- figures


def style():
    """The course's matplotlib style as a context, `with style(): …`; `figure` and the playground use it themselves."""
    return rc_context(fname=STYLE)


def figure(rows=1, columns=1, size=(8, 4.5), **subplots_kw):
    """A new figure in the course's style, and its axes.

    Parameters
    ----------
    rows, columns : int; with rows=0 the figure comes without axes
    size : (width, height) in inches, at 100 dots per inch
    subplots_kw : passed to `Figure.subplots`, for instance sharex=True or height_ratios=(2, 1)

    Returns
    -------
    fig : matplotlib Figure
    axes : one Axes, or an array of Axes as `Figure.subplots` gives it (None when rows=0)
    """
    with style():
        fig = Figure(figsize=size)
        FigureCanvasAgg(fig)
        axes = fig.subplots(rows, columns, **subplots_kw) if rows else None
    return fig, axes


# ---- what is drawn: objects with .set()


class Drawn:
    """Something drawn in the vocabulary: `.artists` (matplotlib's), `.data` (the arrays last set), `.set(…)`."""

    def set(self, *data):
        """Move it in place; the same arguments as when it was drawn, without the axes."""
        self.data = data
        self._move(*data)
        return self


class Line(Drawn):
    """A line or a set of markers: `.set(x, y)`, two sequences of one length. A masked y leaves a gap."""

    def __init__(self, ax, role, x, y, label=None, **look):
        look = {"color": colours[role], **_looks[role], **look}
        if look.get("marker") and look["linestyle"] != "none":
            look.setdefault("markevery", max(1, np.size(x) // 12))
        self.artists = tuple(ax.plot([], [], label=label, **look))
        self.set(x, y)
        fit(self.artists)

    def _move(self, x, y):
        self.artists[0].set_data(x, y)


class Estimate(Drawn):
    """A line with a band of ±2 standard deviations: `.set(x, mean, std)`; without std the band is empty."""

    def __init__(self, ax, x, mean, std=None, label="estimate", role="estimate", **look):
        look = {"color": colours[role], **_looks[role], **look}
        band = ax.fill_between(x, mean, mean, color=look["color"], alpha=BAND, linewidth=0, zorder=1.5)
        if std is not None and label:
            band.set_label("±2σ")
        self.artists = (band, *ax.plot([], [], label=label, **look))
        self.set(x, mean, std)
        fit(self.artists)

    def _move(self, x, mean, std=None):
        width = 0 if std is None else 2 * np.ma.asarray(std, dtype=float)
        mean = np.ma.asarray(mean, dtype=float)
        self.artists[0].set_data(x, mean - width, mean + width)
        self.artists[1].set_data(x, mean)


class Density(Drawn):
    """A Gaussian bell over a fixed grid: `.set(mean, variance)`, two numbers, variance > 0."""

    def __init__(self, ax, x_grid, mean, variance, kind="estimate", label=None, **look):
        self.grid = np.asarray(x_grid, dtype=float)
        bell = {"measurement": dict(linestyle=":", marker=None, linewidth=2.5)}.get(kind, {})
        look = {"color": colours[kind], **_looks[kind], "markevery": max(1, self.grid.size // 12), **bell, **look}
        area = ax.fill_between(self.grid, 0, 0, color=look["color"], alpha=BAND, linewidth=0, zorder=1.5)
        self.artists = (area, *ax.plot([], [], label=label or kind, **look))
        self.set(mean, variance)
        fit(self.artists)

    def _move(self, mean, variance):
        height = np.exp(-((self.grid - mean) ** 2) / (2 * variance)) / np.sqrt(2 * np.pi * variance)
        self.artists[0].set_data(self.grid, 0, height)
        self.artists[1].set_data(self.grid, height)


def fit(artists):
    """Let the axes take in these matplotlib artists where they are now, unless their limits were fixed by hand."""
    for artist in artists:
        ax = artist.axes
        if isinstance(artist, Line2D):
            ax.update_datalim(artist.get_xydata())
        elif isinstance(artist, PolyCollection):
            ax.update_datalim(artist.get_datalim(ax.transData).get_points())
        if ax:
            ax.autoscale_view()


def truth(ax, t, x, label="truth", **look):
    """The true state: black and thin. t, x : (T,). Returns a Line with `.set(t, x)`."""
    return Line(ax, "truth", t, x, label, **look)


def measurements(ax, t, z, label="measurement", **look):
    """Measurements: grey dots. t, z : (T,). Returns a Line with `.set(t, z)`."""
    return Line(ax, "measurement", t, z, label, **look)


def prediction(ax, t, x, label="prediction", **look):
    """Predicted values: orange, dashed, triangles. t, x : (T,). Returns a Line with `.set(t, x)`."""
    return Line(ax, "prediction", t, x, label, **look)


def gain(ax, t, k, label="gain", **look):
    """A Kalman gain along time: green, dash-dotted, diamonds. t, k : (T,). Returns a Line with `.set(t, k)`."""
    return Line(ax, "gain", t, k, label, **look)


def outliers(ax, t, z, label="outlier", **look):
    """Rejected or outlying measurements: vermilion crosses. t, z : (T,) or empty. Returns a Line with `.set(t, z)`."""
    return Line(ax, "outlier", t, z, label, **look)


def estimate(ax, t, mean, std=None, label="estimate", **look):
    """Estimates: a blue line and, with std, a band of ±2 std (same unit as mean). All (T,).

    Returns an Estimate with `.set(t, mean, std)`, which moves the line and its band together.
    """
    return Estimate(ax, t, mean, std, label, **look)


def density(ax, x_grid, mean, variance, kind="estimate", label=None, **look):
    """A Gaussian bell in the colours of a kind: "truth", "measurement", "prediction", "estimate", …

    x_grid : (n,), mean : a number in the same unit, variance : a number in that unit squared, > 0.
    Returns a Density with `.set(mean, variance)`. Raises KeyError for an unknown kind.
    """
    return Density(ax, x_grid, mean, variance, kind, label, **look)


# ---- pictures: small palette PNGs


def pixels(fig):
    """The figure drawn: an array (height, width, 4) of bytes, red, green, blue, alpha."""
    fig.canvas.draw()
    return np.asarray(fig.canvas.buffer_rgba())


@cache
def _palette():
    """256 colours, and for each of 32 × 32 × 32 colours (5 bits of red, green, blue) the number of the nearest of them.

    They are what figures of the vocabulary are made of: greys, each colour fading into white, and each colour fading
    into a band and into the other colours, as happens at smooth edges. The first is white, exactly.
    """
    white, black = np.ones(3), np.zeros(3)
    inks = [np.array(to_rgb(c)) for c in [*colours.values(), "#CC79A7", "#56B4E9"] if c not in ("#000000", "#808080")]
    bands = [white + BAND * (np.array(to_rgb(colours[role])) - white) for role in ("estimate", "prediction", "gain")]
    fade = [white * (1 - s) + black * s for s in np.linspace(0, 1, 34)]
    fade += [white * (1 - s) + ink * s for ink in inks for s in np.linspace(0.1, 1, 10)]
    fade += [a * (1 - s) + b * s for a in bands for b in [*inks, black, white / 2] for s in (0, 0.25, 0.5, 0.75)]
    fade += [a / 2 + b / 2 for i, a in enumerate([*inks, black]) for b in inks[:i]]
    table = np.unique(np.round(255 * np.array(fade)).astype(np.uint8), axis=0)[::-1][:256]
    five = np.arange(32)
    five = (five << 3 | five >> 2).astype(np.float32)
    rgb = np.stack(np.meshgrid(five, five, five, indexing="ij"), axis=-1).reshape(-1, 3)
    points = table.astype(np.float32)
    nearest = np.argmin((points**2).sum(1) - 2 * rgb @ points.T, axis=1).astype(np.uint8)
    return table, nearest


def encode(rgba, quick=False, photo=False):
    """A picture (height, width, 4) of bytes as a PNG of at most 256 fixed colours; white stays white.

    quick : a file a third larger in a tenth of the time (2–3 ms for 800 × 500), for pictures that move
    photo : 48 of the picture's own colours instead, for photographs; slow
    """
    from PIL import Image

    rgba = np.ascontiguousarray(rgba)
    picture = Image.fromarray(rgba[..., :3]).quantize(48) if photo else _indexed(rgba)
    file = io.BytesIO()
    picture.save(file, "png", **({"compress_level": 1, "compress_type": 3} if quick else {"compress_level": 9}))
    return file.getvalue()


def _indexed(rgba):
    """A picture in the fixed colours."""
    from PIL import Image

    table, nearest = _palette()
    colour = rgba.view("<u4").ravel()  # one number a pixel: red in the lowest byte
    image = np.zeros(colour.size, np.uint8)  # 0 is white
    inked = np.flatnonzero(colour != 0xFFFFFFFF)
    c = colour[inked]
    image[inked] = nearest[(c << 7) & 0x7C00 | (c >> 6) & 0x3E0 | (c >> 19) & 0x1F]
    picture = Image.fromarray(image.reshape(rgba.shape[:2]))
    picture.putpalette(table.tobytes())
    return picture


def png(fig, photo=False):
    """The figure as the bytes of a PNG file."""
    return encode(pixels(fig), photo=photo)


def show(fig, alt, photo=False):
    """Show a figure in the notebook, with a text that says in words what is to be seen.

    alt : one or two sentences. They go into the image's metadata, into the text form of the output and, because
    JupyterLab, nbconvert and GitHub use neither for a picture, into a line under it that opens on a click.
    photo : keep the colours of photographs
    """
    display_png(png(fig, photo), alt)


def display_png(data, alt):
    """Show the bytes of a PNG file in the notebook, with an alternative text."""
    from IPython.display import display

    words = f"Figure: {alt}"
    display({"image/png": data, "text/plain": words}, metadata={"image/png": {"alt": alt}}, raw=True)
    page = f"<details><summary><small>Figure in words</small></summary><small>{html.escape(alt)}</small></details>"
    display({"text/html": page, "text/plain": words}, raw=True)
