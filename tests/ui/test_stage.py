"""What moves and what stays: legends, images, labels."""

import io

import numpy as np
from PIL import Image

from kflearn import plots
from kflearn.ui import labels, slider
from tests.ui.samples import Browser, make, pixels


def test_a_picture_within_the_picture_stands_upright():
    """Dark above, light below: in what the browser gets as in matplotlib's own."""

    def draw(fig):
        ax = fig.subplots()
        return ax.imshow([[0, 0], [1, 1]], cmap="gray", vmin=0, vmax=1)

    lively = make(lambda image, a: "", draw, a=slider(0.0, 1.0, 0.5))
    (_, buffers) = Browser(lively).heard[-1]
    sent = np.asarray(Image.open(io.BytesIO(buffers[1])).convert("L"))
    assert sent[: len(sent) // 3].max() < 20
    assert sent[-len(sent) // 3 :].min() > 235


def test_nothing_moves_over_a_legend():
    def draw(fig):
        ax = fig.subplots()
        ax.set(xlim=(0, 1), ylim=(0, 1))
        line = plots.truth(ax, [0, 1], [0, 0], linewidth=200)
        ax.legend([line.artists[0]], ["truth"], loc="upper left")
        return line

    lively = make(lambda line, a: line.set([0, 1], [a, a]) and "", draw, a=slider(0.0, 1.0, 0.5))
    before = pixels(lively.png())
    lively.set(a=0.9)
    (x, y, width, height) = lively._stage._legends[0]
    legend = np.s_[y : y + height, x : x + width]
    after = pixels(lively.png())
    assert (after[legend] == before[legend]).all()
    assert (after != before).any()


def test_formulas_and_words_in_labels():
    assert "svg" in labels.as_html("$P_0$")
    assert "svg" in labels.as_html("assumed $σ_a$")
    assert labels.as_html("$form$") == "form"
