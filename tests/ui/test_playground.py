"""Live pictures without a browser: the picture follows, errors are told, what is saved with the notebook."""

import html
import re
from base64 import b64encode

import nbformat
import numpy as np
from nbconvert import HTMLExporter

from kflearn import plots
from kflearn.ui import log_slider, slider
from tests.ui.samples import Browser, T, draw, make, pixels, update

# ---- pictures


def test_picture_follows_the_values():
    lively = make()
    first = lively.png()
    assert pixels(first).shape == (300, 600, 3)
    lively.set(Q=3.0)
    assert lively.png() != first
    assert lively.status == "Q = 3, R = 0.5"
    lively.reset()
    assert lively.png() == first
    assert lively.values == {"Q": 1.0, "R": 0.5}


def test_blitting_gives_the_same_picture_as_drawing_all():
    lively = make()
    lively.set(Q=7.0, R=1.25)
    fresh = make(Q=log_slider(0.01, 100, 7.0), R=slider(0.0, 2.0, 1.25))
    assert lively.png() == fresh.png()
    for artist in lively._stage.moving:
        artist.set_animated(False)
    whole = plots.pixels(lively._stage.fig)[..., :3].astype(int)
    different = np.abs(whole - pixels(lively.png())).max(axis=-1) > 40
    assert different.mean() < 0.002  # nothing but what crosses the frame of the axes or the legend


def test_white_stays_white_and_the_file_small():
    data = make().png()
    assert len(data) < 80_000
    assert (pixels(data) == 255).all(axis=-1).mean() > 0.3


def test_the_axes_do_not_jump():
    def free(fig):
        return plots.estimate(fig.subplots(), T, T)

    lively = make(lambda live, Q: live.set(T, Q * T) and "", free, Q=log_slider(0.1, 10, 1))
    (ax,) = lively._stage.fig.axes
    before = ax.get_ylim(), ax.get_position().bounds
    assert before[0][1] > 99  # fitted to the first picture
    lively.set(Q=10)
    assert (ax.get_ylim(), ax.get_position().bounds) == before


def test_figure_is_drawn_once():
    made = []
    lively = make(draw=lambda fig: made.append(fig) or draw(fig))
    for q in (0.1, 1.0, 10.0):
        lively.set(Q=q)
    assert len(made) == 1


# ---- errors


def test_an_exception_is_told_and_counted_and_the_playground_lives():
    def fragile(live, Q, R):
        if Q > 10:
            raise ZeroDivisionError("<division> by zero")
        return update(live, Q, R)

    lively = make(fragile)
    browser = Browser(lively)
    before = lively.png()
    answer = browser.move(values={"Q": 50.0})
    assert lively.errors == 1
    assert isinstance(lively.last_error, ZeroDivisionError)
    assert answer["status"] == lively.status
    assert "ZeroDivisionError: <division> by zero" in lively.status
    assert re.search(r'in line \d+, raise ZeroDivisionError\("<division> by zero"\), with', lively.status)
    assert "ops" not in answer, "the picture stays"
    assert lively.png() == before
    lively.set(Q=1.0)
    assert lively.status == "Q = 1, R = 0.5"
    assert lively.errors == 1


def test_after_an_exception_half_way_the_saved_picture_is_the_one_before():
    def fragile(live, Q, R):
        update(live, Q, R)
        return 1 / (Q < 10)

    lively = make(fragile)
    before = lively.png()
    lively.set(Q=50.0)
    assert lively.errors == 1
    assert lively.png() == before


# ---- what is saved with the notebook


def test_mimebundle():
    lively = make()
    data, metadata = lively._repr_mimebundle_()
    assert data["text/plain"] == "Playground: Q from 0.01 to 100 V²; R from 0 to 2"
    assert data["image/png"] == lively.png()
    assert "application/vnd.jupyter.widget-view+json" in data
    assert metadata["image/png"]["alt"].endswith("Q = 1, R = 0.5")
    assert make()._repr_mimebundle_()[0]["text/plain"] == data["text/plain"]


def test_gallery(monkeypatch):
    shown = []
    monkeypatch.setattr("IPython.display.display", lambda data, **kw: shown.append((data, kw)))
    lively = make()
    lively.gallery(dict(Q=0.01), dict(Q=1), dict(Q=100, R=2.0), size=(9, 3))
    image, page = shown[0][0], shown[1][0]
    assert pixels(image["image/png"]).shape == (300, 900, 3)
    assert len(image["image/png"]) < 80_000
    assert image["text/plain"].startswith("Figure: Q = 0.01 V²: Q = 0.01, R = 0.5. Q = 1 V²: ")
    assert "0x" not in page["text/html"]
    assert lively.values == {"Q": 1.0, "R": 0.5}
    lively.gallery(dict(Q=0.01), dict(Q=1), alt="Three pictures.")
    assert shown[2][0]["text/plain"] == "Figure: Three pictures."


def test_a_page_made_of_the_notebook_has_the_picture_and_its_words():
    """`jupyter nbconvert --to html`, without the state of widgets; of its templates, only this one writes words."""
    lively = make()
    data, metadata = lively._repr_mimebundle_()
    data = data | {"image/png": b64encode(data["image/png"]).decode()}
    output = nbformat.v4.new_output("execute_result", data, metadata=metadata, execution_count=1)
    cell = nbformat.v4.new_code_cell("lively", outputs=[output])
    page, _ = HTMLExporter(template_name="classic").from_notebook_node(nbformat.v4.new_notebook(cells=[cell]))
    assert data["image/png"] in page
    assert html.escape(f'alt="{lively}. {lively.status}"', quote=False) in page


def test_the_widget_has_the_picture_too():
    """For the time until the kernel answers, and for a page with the state of widgets but no kernel."""
    lively = make()
    lively.set(Q=3.0)
    lively._repr_mimebundle_()
    assert lively.widget.first == lively.png()
