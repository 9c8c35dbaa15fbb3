"""What a Recorder keeps is what matplotlib draws: canvas in Chromium against Agg, at both device ratios."""

import base64
import io
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib import patches
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.path import Path
from PIL import Image

from dev import canvas
from kflearn.ui.stage import Stage

RNG = np.random.default_rng(4)
X = np.linspace(0, 10, 80)


def axes(fig):
    ax = fig.subplots()
    ax.set(xlim=(0, 10), ylim=(-2, 2))
    return ax


def lines(ax):
    """Dashes, joins, caps, alpha, gaps, and what leaves the axes: cut at a rectangle."""
    y = np.where(abs(X - 5) < 0.3, np.nan, 3 * np.sin(2 * X))
    looks = [
        dict(linestyle="--", linewidth=4, dash_capstyle="round"),
        dict(linestyle="-.", linewidth=1),
        dict(linestyle=(3, (8, 2, 1, 2)), linewidth=2, alpha=0.4),
        dict(linewidth=9, solid_joinstyle="miter", solid_capstyle="butt"),
        dict(drawstyle="steps-mid", linewidth=1.3),
    ]
    return [ax.plot(X[:: 1 + 3 * i], y[:: 1 + 3 * i] / (1 + i), **look)[0] for i, look in enumerate(looks)]


def markers(ax):
    kinds = "os^D*+x|_hP<."
    return [
        ax.plot(X[i::13], np.cos(X[i::13]), marker=kind, linestyle="none", markersize=4 + i, alpha=1 - i / 20)[0]
        for i, kind in enumerate(kinds)
    ] + [ax.plot(X, np.sin(X), "o-", markevery=9, fillstyle="none", markeredgewidth=2)[0]]


def clipped(ax):
    """Cut at paths: a circle, and a star with a hole."""
    circle = patches.Circle((3, 0), 1.5, transform=ax.transData)
    band = ax.fill_between(X, -2, 2, color="C1", alpha=0.5)
    line = ax.plot(X, np.sin(9 * X), "k", linewidth=2)[0]
    words = ax.text(6, 0, "cut in two", fontsize=30)
    band.set_clip_path(circle)
    line.set_clip_path(Path(np.add(Path.unit_regular_star(5).vertices, [6, 0])), ax.transData)
    words.set_clip_box(ax.bbox.shrunk(0.75, 0.54))
    return [band, line, words]


def images(ax):
    ramp = np.linspace(0, 1, 30).reshape(5, 6)
    kept = [
        ax.imshow(ramp, extent=(1, 4, -1, 1), aspect="auto", interpolation="nearest", cmap="viridis"),
        ax.imshow(RNG.random((9, 9)), extent=(6, 9, -1.5, 1), aspect="auto", alpha=0.5, cmap="magma"),
    ]
    ax.set(xlim=(0, 10), ylim=(-2, 2))
    return kept


def words(ax):
    look = dict(boxstyle="round", facecolor="#ffd", alpha=0.8)
    return [
        ax.text(1, 1, "turned by 30°", rotation=30, fontsize=18),
        ax.text(5, -1, r"$\hat{x} = \frac{\sigma_x^2}{\sqrt{1 + K}}$", fontsize=22, rotation=90),
        ax.text(6, 1, "in a box\nof two lines", bbox=look, ha="center"),
        ax.text(7, -1, "faint", alpha=0.4, fontsize=30),
        ax.annotate("here", (3, -1.5), (4.5, 0.5), arrowprops=dict(arrowstyle="->", connectionstyle="arc3,rad=.4")),
    ]


def collections(ax):
    many = ax.scatter(X, np.sin(X), s=RNG.uniform(5, 200, 80), c=X, alpha=0.6, edgecolors="k", cmap="plasma")
    parts = np.stack([np.stack([X, np.cos(X + k)], axis=1) for k in range(4)])
    lines = LineCollection(
        parts, colors=["r", "g", "b", "k"], linewidths=[1, 2, 3, 4], linestyles=["-", "--", ":", "-."]
    )
    arrows = ax.quiver(X[::8], 0 * X[::8], np.cos(X[::8]), np.sin(X[::8]), X[::8])
    return [many, ax.add_collection(lines), arrows]


def contours(ax):
    a, b = np.meshgrid(X, np.linspace(-2, 2, 40))
    height = np.sin(a) * np.cos(2 * b)
    return [ax.contour(a, b, height, levels=6), ax.contourf(a, b, height, levels=4, alpha=0.3)]


def mesh(ax):
    return ax.pcolormesh(np.linspace(0, 10, 9), np.linspace(-2, 2, 6), RNG.random((5, 8)), norm=Normalize(0, 1))


def shapes(ax):
    kinds = [
        patches.Ellipse((2, 0), 3, 1, angle=30, facecolor=(0, 0, 1, 0.3), edgecolor="r", linewidth=3, linestyle="--"),
        patches.Rectangle((5, -1), 2, 1, fill=False, linewidth=2),
        patches.FancyArrowPatch((1, -1.5), (9, 1.5), mutation_scale=30, connectionstyle="arc3,rad=0.2"),
        patches.Wedge((8, -1), 0.9, 20, 300, facecolor="C3", alpha=0.5),
        patches.PathPatch(Path.unit_circle_righthalf().transformed(ax.transData + ax.transData.inverted()), color="g"),
    ]
    for kind in kinds:
        ax.add_patch(kind)
    return kinds


def hatched(ax):
    return ax.add_patch(patches.Rectangle((2, -1), 5, 2, hatch="//", facecolor="w"))


def sketched(ax):
    line = ax.plot(X, np.sin(X))[0]
    line.set_sketch_params(3, 50, 5)
    return [line, ax.text(2, 1, "above it")]


RECORDED = lines, markers, clipped, images, words, collections, contours, mesh, shapes
FALLBACK = hatched, sketched


@pytest.fixture(scope="module")
def page(chromium):
    return canvas.page(chromium)


def staged(kind, ratio):
    stage = Stage(lambda fig: SimpleNamespace(all=kind(axes(fig))), lambda artists: "", (6, 4))
    stage.show_at(ratio)
    return stage


@pytest.mark.browser
@pytest.mark.parametrize("ratio", canvas.RATIOS)
@pytest.mark.parametrize("kind", RECORDED, ids=lambda kind: kind.__name__)
def test_it_is_drawn_as_matplotlib_draws_it(page, kind, ratio):
    stage = staged(kind, ratio)
    told = canvas.pair(stage, *stage.still())
    assert len(told["about"]["ops"]) >= 1
    assert not (told["files"][0] == "" and len(told["about"]["ops"]) == 1), "it was not recorded"
    assert canvas.share(page, told) <= canvas.MOST
    away = told | {"about": told["about"] | {"ops": []}}
    assert canvas.share(page, away) > 2 * canvas.share(page, told), "the measure sees what is missing"


@pytest.mark.browser
@pytest.mark.parametrize("ratio", canvas.RATIOS)
@pytest.mark.parametrize("kind", FALLBACK, ids=lambda kind: kind.__name__)
def test_what_cannot_be_recorded_is_matplotlibs_own_picture(page, kind, ratio):
    stage = staged(kind, ratio)
    told = canvas.pair(stage, *stage.still())
    assert told["about"]["ops"] == [["i", 0, 0, 0, 1.0, 0]]
    image = Image.open(io.BytesIO(base64.b64decode(told["files"][1])))
    assert image.size == (600 * ratio, 400 * ratio)
    assert canvas.share(page, told) <= canvas.MOST
