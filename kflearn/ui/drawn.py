"""What is drawn in the vocabulary: objects that `set` moves in place."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D

from .away import Away
from .looks import BAND, colours, look_of


class Drawn:
    """Something drawn in the vocabulary.

    Attributes
    ----------
    artists : tuple of matplotlib artists
    data : tuple of arrays
        What was last set.
    """

    def set(self, *data) -> "Drawn":
        """Move it in place; takes the arguments with which it was drawn, without the axes, and returns itself."""
        self.data = data
        self._move(*data)
        return self


class Line(Drawn):
    """A line or a set of markers: `.set(x, y)`, two sequences of one length. A masked y leaves a gap."""

    def __init__(self, ax, role, x, y, label=None, away=False, **look):
        look = look_of(role, look)
        if look.get("marker") and look["linestyle"] != "none":
            look.setdefault("markevery", max(1, np.size(x) // 12))
        (line,) = ax.plot([], [], label=label, **look)
        self.artists = (line, Away(line)) if away else (line,)
        self.set(x, y)
        fit(self.artists)

    def _move(self, x, y):
        self.artists[0].set_data(x, y)


class Estimate(Drawn):
    """A line with a band of ±2 standard deviations: `.set(x, mean, std)`; without std the band is empty."""

    def __init__(self, ax, x, mean, std=None, label="estimate", role="estimate", away=False, **look):
        look = look_of(role, look)
        band = ax.fill_between(x, mean, mean, color=look["color"], alpha=BAND, linewidth=0, zorder=1.5)
        if std is not None and label:
            band.set_label("±2σ")
        (line,) = ax.plot([], [], label=label, **look)
        self.artists = (band, line, Away(line)) if away else (band, line)
        self.set(x, mean, std)
        fit(self.artists)

    def _move(self, x, mean, std=None):
        width = 0 if std is None else 2 * np.asanyarray(std, dtype=float)
        mean = np.asanyarray(mean, dtype=float)
        self.artists[0].set_data(x, mean - width, mean + width)
        self.artists[1].set_data(x, mean)


class Density(Drawn):
    """A Gaussian bell over a fixed grid: `.set(mean, variance)`, two numbers, variance > 0."""

    def __init__(self, ax, x_grid, mean, variance, kind="estimate", label=None, **look):
        self.grid = np.asarray(x_grid, dtype=float)
        bell = {"measurement": dict(linestyle=":", marker=None, linewidth=2.5)}.get(kind, {})
        look = look_of(kind, {"markevery": max(1, self.grid.size // 12), **bell, **look})
        area = ax.fill_between(self.grid, 0, 0, color=look["color"], alpha=BAND, linewidth=0, zorder=1.5)
        self.artists = (area, *ax.plot([], [], label=label or kind, **look))
        self.set(mean, variance)
        fit(self.artists)

    def _move(self, mean, variance):
        height = np.exp(-((self.grid - mean) ** 2) / (2 * variance)) / np.sqrt(2 * np.pi * variance)
        self.artists[0].set_data(self.grid, 0, height)
        self.artists[1].set_data(self.grid, height)


class Innovations(Drawn):
    """Innovations and their band ±2√S: `.set(t, innovation, std)`. What lies outside wears a ring."""

    def __init__(self, ax, t, innovation, std, label="innovation", **look):
        look = look_of("measurement", look)
        band = ax.fill_between(t, 0, 0, color=look["color"], alpha=BAND, linewidth=0, zorder=1.5, label="±2√S")
        (dots,) = ax.plot([], [], label=label, **look)
        ring = dict(color=colours["outlier"], linestyle="none", marker="o", markerfacecolor="none", markersize=9)
        (rings,) = ax.plot([], [], label="outside", zorder=2.7, **ring)
        ax.axhline(0, color=colours["truth"], linewidth=0.8, zorder=1.6)
        self.artists = (band, dots, rings)
        self.set(t, innovation, std)
        fit(self.artists)

    def _move(self, t, innovation, std):
        t, innovation, std = (np.asarray(each, dtype=float) for each in (t, innovation, std))
        outside = np.abs(innovation) > 2 * std
        self.outside = float(outside.sum() / max(1, (~np.isnan(innovation)).sum()))
        self.artists[0].set_data(t, -2 * std, 2 * std)
        self.artists[1].set_data(t, innovation)
        self.artists[2].set_data(t[outside], innovation[outside])


def fit(artists) -> None:
    """Let the axes take in some artists where they are now, unless their limits were fixed by hand.

    Parameters
    ----------
    artists : iterable of matplotlib artists
    """
    for artist in artists:
        ax = artist.axes
        if isinstance(artist, Line2D):
            ax.update_datalim(artist.get_xydata())
        elif isinstance(artist, PolyCollection):
            ax.update_datalim(artist.get_datalim(ax.transData).get_points())
        if ax:
            ax.autoscale_view()
