"""A lesson in JupyterLab, in a real browser: run it, move its sliders, see the picture follow."""

import json
import math
import shutil
from hashlib import sha256

import pytest

from dev.lab import CHROMIUM, ROOT, Lab, browser, notebook, server

LESSON = ROOT / "notebooks" / "05-voltmeter.ipynb"  # its first playground has sliders Q and R

CELLS = [
    """
import numpy as np
from kflearn import plots
from kflearn.ui import Playground, log_slider
t = np.arange(200)
z = np.random.default_rng(0).normal(12, 1, 200)
def run(Q, R):
    mean, P, track = z[0], R, []
    for value in z:
        P += Q
        K = P / (P + R)
        mean, P = mean + K * (value - mean), (1 - K) * P
        track.append((mean, P**0.5, K))
    return np.transpose(track)
""",
    """
def draw(fig):
    above, below = fig.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    plots.measurements(above, t, z)
    above.set(ylim=(8, 16), ylabel="voltage / V")
    below.set(ylim=(0, 1.05), xlabel="time / s", ylabel="gain")
    return plots.estimate(above, t, z, z), plots.gain(below, t, z)
def update(live, Q, R):
    mean, std, K = run(Q, R)
    live[0].set(t, mean, std)
    live[1].set(t, K)
    return f"steady gain {K[-1]:.2f}"
""",
    'Playground(draw, update, Q=log_slider(1e-3, 1e3, 0.04, unit="V²"), R=log_slider(1e-3, 1e3, 1, unit="V²"))',
]

KERNEL = """
import hashlib, json
from kflearn.ui import Playground
live = [value for value in globals().values() if isinstance(value, Playground)][0]
shown = hashlib.sha256(live.png()).hexdigest()
live.refresh()
print(json.dumps([list(live.values.values()), shown, hashlib.sha256(live.png()).hexdigest(), live.errors]))
"""


def same_everywhere(lab):
    """Kernel and browser agree on the numbers, and the picture in the browser is the one of these numbers."""
    lab.settle()
    values, shown, fresh, errors = json.loads(lab.ask(KERNEL))
    picture = lab.picture()
    assert lab.numbers()[: len(values)] == values
    assert sha256(picture).hexdigest() == shown == fresh
    assert errors == 0
    return values, picture


def moved_by_the_keyboard(lab, before):
    """An arrow key moves the first slider, and the picture follows."""
    lab.press(0, "ArrowRight")
    values, picture = same_everywhere(lab)
    assert values[0] > before[0][0]
    assert picture != before[1]
    return values, picture


def dragged_by_the_mouse(lab, before):
    """The second slider is dragged: the picture changes all the while, and is never blank."""
    with lab.film() as frames:
        lab.drag(1, 0.3)
    values, picture = same_everywhere(lab)
    assert values[1] > 10 * before[0][1]
    assert picture != before[1]
    assert lab.pictures() - lab.before >= 5
    inked = [(frame < 128).mean() for frame in frames]
    assert len(inked) >= 5
    assert min(inked) > 0.5 * max(inked) > 0, "the picture was blank for a moment"
    position = float(lab.handle(1).get_attribute("aria-valuetext"))
    assert math.isclose(10**position, values[1], rel_tol=0.005)


@pytest.mark.browser
@pytest.mark.timeout(240)  # half a minute on an idle machine
@pytest.mark.skipif(not CHROMIUM, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_playground_in_jupyterlab(tmp_path):
    if LESSON.exists():
        shutil.copy(LESSON, tmp_path / "lesson.ipynb")
    else:
        notebook(tmp_path / "lesson.ipynb", *CELLS)
    with server(tmp_path) as url, browser() as chromium:
        lab = Lab(chromium, url, "lesson.ipynb")
        lab.run_all()
        lab.handle(0)
        start = same_everywhere(lab)
        second = moved_by_the_keyboard(lab, start)
        dragged_by_the_mouse(lab, second)

        lab.type(0, "1.23456")  # the exact number
        values, _ = same_everywhere(lab)
        assert values[0] == 1.23456

        lab.reset()
        assert same_everywhere(lab) == start


@pytest.mark.browser
@pytest.mark.timeout(240)
@pytest.mark.skipif(not CHROMIUM, reason="no chromium, chromium-browser or google-chrome on the PATH")
def test_the_keys_of_lesson_0_lead_to_its_slider(tmp_path):
    """Its words: "press Shift+Tab twice right after Shift+Enter; then the arrow keys move it"."""
    shutil.copy(ROOT / "notebooks" / "00-start-here.ipynb", tmp_path)
    cells = json.loads((tmp_path / "00-start-here.ipynb").read_text(encoding="utf-8"))["cells"]
    first = next(i for i, cell in enumerate(cells) if "".join(cell["source"]).endswith("\nbell"))
    with server(tmp_path) as url, browser() as chromium:
        lab = Lab(chromium, url, "00-start-here.ipynb")
        lab.page.locator(".jp-Cell").first.click()
        for _ in range(first + 1):
            lab.page.keyboard.press("Shift+Enter")
        lab.page.locator(".noUi-handle").nth(1).wait_for()
        before = lab.numbers()
        lab.page.keyboard.press("Shift+Tab")
        lab.page.keyboard.press("Shift+Tab")
        assert lab.page.evaluate("document.activeElement.className").startswith("noUi-handle")
        lab.before = lab.pictures()
        lab.page.keyboard.press("ArrowRight")
        lab.settle()
        assert lab.numbers() != before
