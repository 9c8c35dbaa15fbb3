"""The visual vocabulary: what is drawn, how it is moved, how it becomes a picture."""

import io
import re
import subprocess
import sys

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from PIL import Image

from kflearn import plots
from kflearn.ui.pictures import palette

T = np.arange(50.0)
ROLES = {"truth": plots.truth, "measurement": plots.measurements, "prediction": plots.prediction}
ROLES |= {"estimate": plots.estimate, "gain": plots.gain, "outlier": plots.outliers}


def picture(data):
    return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"))


def full_figure():
    """A figure with everything in it, as full as a lesson's."""
    rng = np.random.default_rng(0)
    fig, (above, below) = plots.figure(2, 1, sharex=True, height_ratios=(2, 1), size=(8, 5))
    x = np.cumsum(rng.normal(size=200))
    for draw in (plots.truth, plots.prediction):
        draw(above, np.arange(200), x + rng.normal(size=200))
    plots.measurements(above, np.arange(200), x + rng.normal(size=200))
    plots.estimate(above, np.arange(200), x, np.ones(200))
    plots.outliers(above, [20, 60], [3, 4])
    plots.gain(below, np.arange(200), np.exp(-np.arange(200) / 50))
    above.legend(ncols=3)
    above.set_ylabel("voltage / V")
    return fig


def test_no_pyplot():
    code = "import sys, kflearn.ui.plots, kflearn.ui.playground; assert 'matplotlib.pyplot' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_roles_differ_in_more_than_colour():
    _, ax = plots.figure()
    looks = set()
    for role, draw in ROLES.items():
        line = draw(ax, T, T).artists[-1]
        assert to_rgb(line.get_color()) == to_rgb(plots.colours[role])
        looks.add((line.get_linestyle(), line.get_marker(), line.get_linewidth()))
    assert len(looks) == len(ROLES)


@pytest.mark.parametrize("role", ROLES)
def test_set_moves_it(role):
    _, ax = plots.figure()
    drawn = ROLES[role](ax, T, T)
    assert drawn.set(T[:10], 2 * T[:10]) is drawn
    np.testing.assert_array_equal(drawn.artists[-1].get_xydata(), np.column_stack([T[:10], 2 * T[:10]]))


def test_estimate_moves_its_band():
    _, ax = plots.figure()
    drawn = plots.estimate(ax, T, T, np.ones(50))
    drawn.set(T, -T, 3 * np.ones(50))
    corners = drawn.artists[0].get_paths()[0].vertices
    assert corners[:, 1].min() == -49 - 6
    assert corners[:, 1].max() == 0 + 6
    drawn.set(T, -T)
    assert np.ptp([c[1] for c in drawn.artists[0].get_paths()[0].vertices if c[0] == 20]) == 0


def test_gaps_are_masked():
    fig, ax = plots.figure()
    mean = np.ma.masked_where(T > 40, T)
    drawn = plots.estimate(ax, T, mean, np.ones(50))
    assert np.isnan(drawn.artists[1].get_ydata(orig=False)[45])
    assert drawn.artists[0].get_paths()[0].vertices[:, 0].max() == 40
    plots.png(fig)


def test_density_has_area_one():
    _, ax = plots.figure()
    grid = np.linspace(-20, 20, 2001)
    for kind in plots.colours:
        drawn = plots.density(ax, grid, 0, 1, kind).set(1.5, 4.0)
        y = drawn.artists[1].get_ydata()
        assert np.trapezoid(y, grid) == pytest.approx(1)
        assert grid[np.argmax(y)] == pytest.approx(1.5)
    with pytest.raises(KeyError):
        plots.density(ax, grid, 0, 1, "guess")


def test_limits_take_in_what_is_drawn_unless_fixed():
    _, (left, right) = plots.figure(1, 2)
    right.set_ylim(0, 5)
    for ax in (left, right):
        plots.estimate(ax, T, T, np.full(50, 10.0))
    assert left.get_ylim()[0] < -20
    assert left.get_ylim()[1] > 69
    assert right.get_ylim() == (0, 5)


def test_size_and_letters():
    fig, _ = plots.figure()
    assert plots.pixels(fig).shape == (450, 800, 4)
    fig = full_figure()
    plots.png(fig)
    sizes = [text.get_fontsize() for text in fig.findobj(lambda a: hasattr(a, "get_fontsize")) if text.get_text()]
    assert min(sizes) >= 9


def test_png_is_small_true_and_the_same_every_time():
    fig = full_figure()
    rgba = plots.pixels(fig)
    for quick in (False, True):
        data = plots.encode(rgba, quick)
        assert len(data) < 80_000
        assert data == plots.encode(rgba, quick)
        error = np.abs(picture(data).astype(int) - rgba[..., :3])
        assert np.quantile(error, 0.99) <= 16
        assert (picture(data)[(rgba == 255).all(axis=-1)] == 255).all()
    assert plots.png(full_figure()) == plots.png(full_figure())


def test_vocabulary_colours_are_in_the_palette():
    table, _ = palette()
    assert tuple(table[0]) == (255, 255, 255)
    assert len(table) <= 256
    for colour in plots.colours.values():
        rgb = np.round(255 * np.array(to_rgb(colour)))
        assert np.abs(table - rgb).max(axis=1).min() <= 4


def test_show_carries_its_words(monkeypatch):
    shown = []
    monkeypatch.setattr("IPython.display.display", lambda data, **kw: shown.append((data, kw)))
    fig, _ = plots.figure()
    plots.show(fig, 'The gain falls & stays below "0.2" <V>.')
    (image, first), (page, _) = shown
    assert image["image/png"].startswith(b"\x89PNG")
    assert first["metadata"]["image/png"]["alt"] == 'The gain falls & stays below "0.2" <V>.'
    assert image["text/plain"] == page["text/plain"] == 'Figure: The gain falls & stays below "0.2" <V>.'
    assert "&amp; stays below &quot;0.2&quot; &lt;V&gt;" in page["text/html"]
    assert not re.search("0x|id=", page["text/html"])
