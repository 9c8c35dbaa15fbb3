"""Live pictures without a browser: controls, coalescing, errors, the sweep, the text form."""

import asyncio
import io
import math
import threading
import time
import warnings
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from kflearn import plots
from kflearn.playground import Playground, choice, log_slider, slider, toggle

T = np.arange(100.0)


def draw(fig):
    ax = fig.subplots()
    ax.set(xlim=(0, 100), ylim=(-3, 3))
    plots.truth(ax, T, np.sin(T / 10))
    live = plots.estimate(ax, T, T * 0, T * 0)
    ax.legend(loc="upper right")
    return SimpleNamespace(curve=live, more={"words": [ax.text(1, 2, "")]})


def update(live, Q, R):
    live.curve.set(T, np.sin(T / 10 + Q), np.full(100, R))
    live.more["words"][0].set_text(f"Q = {Q:g}")
    return f"Q = {Q:g}, R = {R:g}"


def make(update=update, draw=draw, **controls):
    controls = controls or dict(Q=log_slider(0.01, 100, 1, unit="V²"), R=slider(0.0, 2.0, 0.5))
    return Playground(draw, update, size=(6, 3), **controls)


def counted(update=update):
    calls = []

    def counting(live, **values):
        calls.append(values)
        return update(live, **values)

    return counting, calls


def pixels(data):
    return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"))


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
    for artist in lively._moving:
        artist.set_animated(False)
    whole = plots.pixels(lively._fig)[..., :3].astype(int)
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
    (ax,) = lively._fig.axes
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


# ---- controls


def test_number_box_and_slider():
    lively = make()
    control = lively.controls["Q"]
    control.box.value = 1.2345  # typed
    assert lively.values["Q"] == 1.2345
    assert control.slider.value == pytest.approx(1.2345, rel=0.07)
    control.slider.value = 10**0.1  # the browser moves the handle to its nearest step: not a new value
    assert lively.values["Q"] == 1.2345
    control.slider.value = 10**0.55  # dragged
    assert lively.values["Q"] == control.box.value == 3.55
    control.box.value = 1e9
    assert lively.values["Q"] == 100
    assert lively.errors == 0


def test_number_box_waits_for_the_picture():
    async def drag():
        lively = make()
        control = lively.controls["Q"]
        control.slider.value = 10**0.55
        first = control.box.value
        await asyncio.sleep(0.05)
        return first, control.box.value

    assert asyncio.run(drag()) == (1, 3.55)


def test_whole_numbers():
    lively = make(lambda live, n: f"{n!r}", n=slider(1, 50, 10))
    lively.controls["n"].slider.value = 17.0
    assert lively.status == "17"
    assert lively.controls["n"].ends() == (1, 25, 50)
    for typed, taken in ((17.7, 17), (18.2, 18), (18.9, 18)):  # also when it is the number that was there before
        lively.controls["n"].box.value = typed
        assert lively.values["n"] == lively.controls["n"].box.value == taken


def test_choice_and_toggle():
    def steps(live, step, band):
        return f"{step} {band}"

    lively = make(steps, step=choice(["predict", "measure", "correct"]), band=toggle(True, label="show the band"))
    assert lively.status == "predict True"
    lively.controls["step"].buttons.value = "correct"
    lively.controls["band"].widget.value = False
    assert lively.status == "correct False"
    lively.reset()
    assert lively.status == "predict True"
    assert lively.sweep() == 6
    assert str(lively) == "Playground: step: predict, measure, correct; band: on or off"


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda: log_slider(0, 1, 0.5), "0 < low < high"),
        (lambda: log_slider(1, 10, 20), "from 1 to 10 cannot be 20"),
        (lambda: slider(3, 2, 2), "low < high"),
        (lambda: slider(0, 2, math.nan), "cannot be nan"),
        (lambda: choice(["a", "b"], "c"), "a choice of a, b cannot be 'c'"),
        (lambda: make().set(S=1), "no control is named 'S'; this playground has Q, R"),
        (lambda: make().set(Q="much"), "cannot be 'much'"),
        (lambda: make().set(Q=1e9), "from 0.01 to 100 cannot be"),
    ],
)
def test_wrong_values_are_named(wrong, words):
    with pytest.raises(ValueError, match=words):
        wrong()


def test_two_playgrounds_share_a_description_not_a_value():
    q = log_slider(0.1, 10, 1)
    one, two = make(lambda live, Q: "", Q=q), make(lambda live, Q: "", Q=q)
    one.set(Q=5)
    assert two.values == {"Q": 1}


def test_names_for_those_who_do_not_see():
    control = make().controls["Q"]
    assert control.box.description == "$Q$"
    assert control.box.tooltip == "Q from 0.01 to 100 V²"
    assert 'role="status" aria-live="polite"' in make()._status.value


# ---- many moves


def test_a_burst_makes_few_pictures_and_the_last_is_right():
    counting, calls = counted()

    async def burst():
        lively = make(counting)
        calls.clear()
        for exponent in np.linspace(-1.9, 1.9, 39):
            lively.controls["Q"].slider.value = 10**exponent
        assert len(calls) == 0  # a move itself costs nothing
        await asyncio.sleep(0.1)
        return lively

    lively = asyncio.run(burst())
    assert len(calls) == 1
    assert calls[-1]["Q"] == lively.values["Q"] == 79.4
    shown = lively.png()
    lively.refresh()
    assert lively.png() == shown


def test_a_long_drag_is_not_debounced():
    counting, calls = counted()

    async def drag():
        lively = make(counting)
        calls.clear()
        start = time.monotonic()
        for exponent in np.linspace(-1.9, 1.9, 150):  # a move each 3 ms: never quiet
            lively.controls["Q"].slider.value = 10**exponent
            await asyncio.sleep(0.003)
        took = time.monotonic() - start
        await asyncio.sleep(0.1)
        return took, lively.values["Q"]

    took, last = asyncio.run(drag())
    assert len(calls) >= max(3, took / 0.250)
    assert calls[-1]["Q"] == last == 79.4


def test_without_an_event_loop_it_is_synchronous():
    lively = make()
    lively.controls["Q"].slider.value = 10.0
    assert lively.status == "Q = 10, R = 0.5"


def test_threads():
    """Moves from several threads, one of them with a loop as in JupyterLab's subshells, while a cell sets values."""
    lively = make()

    async def move():
        for exponent in np.linspace(-1.9, 1.9, 40):
            lively.controls["Q"].slider.value = 10**exponent
            await asyncio.sleep(0.002)
        await asyncio.sleep(0.1)

    threads = [threading.Thread(target=asyncio.run, args=(move(),)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for r in np.linspace(0, 2, 20):
        lively.set(R=r)
    for thread in threads:
        thread.join()
    assert lively.errors == 0
    assert lively.values == {"Q": 79.4, "R": 2.0}
    assert lively.status == "Q = 79.4, R = 2"
    shown = lively.png()
    lively.refresh()
    assert lively.png() == shown
    assert lively.controls["Q"].box.value == 79.4


# ---- errors and the sweep


def test_an_exception_is_told_and_counted_and_the_playground_lives():
    def fragile(live, Q, R):
        if Q > 10:
            raise ZeroDivisionError("<division> by zero")
        return update(live, Q, R)

    lively = make(fragile)
    before = lively.png()
    lively.controls["Q"].slider.value = 50.0
    assert lively.errors == 1
    assert isinstance(lively.last_error, ZeroDivisionError)
    assert "ZeroDivisionError: <division> by zero" in lively.status
    assert "&lt;division&gt;" in lively._status.value
    assert lively.png() == before
    lively.set(Q=1.0)
    assert lively.status == "Q = 1, R = 0.5"
    assert lively.errors == 1


def at_the_end(what):
    """An update that goes wrong only where Q is at its upper end and R in the middle."""

    def fragile(live, Q, R):
        words = update(live, Q, R)
        return what(live) or words if (Q, R) == (100, 1.0) else words

    return make(fragile)


def divide(live):
    raise ZeroDivisionError("only at the end")


def test_sweep_tries_all_and_restores():
    counting, calls = counted()
    lively = make(counting)
    lively.set(Q=7.0)
    calls.clear()
    assert lively.sweep() == 9
    assert {(c["Q"], c["R"]) for c in calls} > {(q, r) for q in (0.01, 1.0, 100) for r in (0, 1.0, 2)}
    assert lively.values == {"Q": 7.0, "R": 0.5}
    assert lively.status == "Q = 7, R = 0.5"


@pytest.mark.parametrize(
    ("what", "error"),
    [
        (divide, ZeroDivisionError),
        (lambda live: warnings.warn("careful", stacklevel=1), UserWarning),
        (lambda live: np.log(np.zeros(2)).sum() and "", RuntimeWarning),
        (lambda live: live.curve.set(T, np.where(T > 50, np.nan, T), T) and None, AssertionError),
        (lambda live: live.curve.set(T, T, np.where(T > 50, np.inf, T)) and None, AssertionError),
        (lambda live: live.more["words"][0].set_text("gain nan"), AssertionError),
        (lambda live: "gain nan", AssertionError),
        (lambda live: "gain -inf", AssertionError),
    ],
)
def test_sweep_finds_what_is_wrong_at_one_end_only(what, error):
    lively = at_the_end(what)
    with pytest.raises(error) as caught:
        lively.sweep()
    assert any("'Q': 100" in note for note in caught.value.__notes__)
    assert lively.values == {"Q": 1.0, "R": 0.5}


def test_sweep_allows_gaps_and_words_like_information():
    assert at_the_end(lambda live: live.curve.set(T, np.ma.masked_greater(T, 50), T) and "no information").sweep() == 9


def test_sweep_looks_at_plain_artists():
    def plain(fig):
        ax = fig.subplots()
        return [ax.plot(T, T), {"dots": ax.scatter(T, T)}]

    def broken(live, Q):
        live[1]["dots"].set_offsets(np.column_stack([T, np.where(T > 3, np.nan, T) if Q > 5 else T]))
        return ""

    with pytest.raises(AssertionError, match="not finite"):
        make(broken, plain, Q=log_slider(0.1, 10, 1)).sweep()


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
