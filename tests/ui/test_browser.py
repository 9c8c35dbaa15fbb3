"""Playgrounds in JupyterLab and Notebook 7, with a real kernel: moves, cells that compute, faults."""

import json
import os
import shutil
import signal
from importlib.util import find_spec

import pytest

from dev import axe
from dev.lab import ROOT, Lab, notebook, server

pytestmark = [pytest.mark.browser, pytest.mark.timeout(240)]

LESSON = "05-voltmeter.ipynb"  # its first playground has sliders Q and R
BUSY, LOST = "The kernel is busy with a cell", "The kernel does not answer"

SETUP = """\
import time, warnings
import numpy as np
import ipywidgets
from traitlets import link
from kflearn import plots
from kflearn.ui import Playground, drag, log_slider
t = np.arange(200.)
def draw(fig):
    ax = fig.subplots()
    ax.set(xlim=(0, 200), ylim=(-3, 3))
    return plots.estimate(ax, t, t, t), ax.text(5, 2, "")
def update(artists, Q, R):
    artists[0].set(t, np.sin(t / 20 + np.log(Q)), 0 * t + R**0.2 / 5)
    artists[1].set_text(f"{Q:g} and {R:g}")
    if Q == 666:
        raise ValueError("no such Q")
    return f"Q = {Q:g}, R = {R:g}"
def make():
    handle = drag(y=("R", lambda R: R**0.2 / 5, lambda y: max(5 * y, 0)**5), label="the band")
    sliders = dict(Q=log_slider(1e-3, 1e3, 1), R=log_slider(1e-3, 1e3, 1))
    return Playground(draw, update, size=(6, 3), handles=[handle], **sliders)
live = make()
"""
PLAIN = SETUP, "live"
NESTED = (
    SETUP,
    "other = make()\nnumber = ipywidgets.FloatText(1)",
    "link((number, 'value'), (live.controls['Q'], 'value'))",
)
NESTED += ("ipywidgets.VBox([number, ipywidgets.HBox([other.widget]), live.widget])", "live")
SLOW = SETUP.replace("Q, R):\n", "Q, R):\n    time.sleep(0.6)\n", 1), "live"
DYING = SETUP, "live.widget.spec = live.widget.spec | dict(patience=[0.3, 1])\nlive"

KERNEL = """
import json
from kflearn.ui import Playground
live = [value for value in globals().values() if isinstance(value, Playground)][0]
live.refresh()
print(json.dumps([list(live.values.values()), live.status, live.errors]))
"""

COUNT = """() => {
  let waiting = 0;
  window.most = 0;
  jupyterapp.shell.currentWidget.sessionContext.session.kernel.anyMessage.connect((_, { direction, msg }) => {
    const { kind, n } = msg.content.data?.content || {};
    if (direction == "send" && kind == "move") most = Math.max(most, waiting += 1);
    if (direction == "recv" && kind == "picture" && n) waiting -= 1;
  });
}"""

START = "code => { jupyterapp.shell.currentWidget.sessionContext.session.kernel.requestExecute({ code }) }"


@pytest.fixture(scope="module")
def url(tmp_path_factory):
    folder = tmp_path_factory.mktemp("notebooks")
    for name in (LESSON, "00-start-here.ipynb"):
        shutil.copy(ROOT / "notebooks" / name, folder)
    for name, cells in dict(plain=PLAIN, slow=SLOW, nested=NESTED, dying=DYING).items():
        notebook(folder / f"{name}.ipynb", *cells)
    with server(folder) as found:
        yield found


def opened(chromium, url, name, **how):
    """A notebook that has run, with its pictures."""
    lab = Lab(chromium, url, name, **how)
    lab.run_all()
    lab.slider(0)
    lab.rest()
    return lab


def right(lab):
    """Kernel and browser agree on numbers and sentence, and a fresh picture from the kernel is the one shown before."""
    lab.rest()
    picture, lab.before = lab.picture(), lab.pictures()
    values, status, errors = json.loads(lab.ask(KERNEL))
    lab.rest()
    assert lab.numbers()[: len(values)] == values
    assert sentence(lab) == status
    assert lab.picture() == picture
    assert errors == 0
    return values, picture


def sentence(lab):
    return lab.page.locator(".kf-sentence").first.inner_text()


def said(lab, words):
    """Wait for a sentence."""
    lab.page.wait_for_function(
        "words => document.querySelector('.kf-sentence').textContent.includes(words)", arg=words, polling=50
    )


def dragged_by_the_mouse(lab, before):
    """The second slider is dragged: the picture changes all the while, and is never blank."""
    with lab.film() as frames:
        lab.drag(1, 0.3)
    values, picture = right(lab)
    assert values[1] > 10 * before[0][1]
    assert picture != before[1]
    assert lab.pictures() - lab.before >= 1
    inked = [(frame < 128).mean() for frame in frames]
    assert len(inked) >= 5
    assert min(inked) > 0.5 * max(inked) > 0, "the picture was blank for a moment"


def test_a_lesson_in_jupyterlab(chromium, url):
    lab = opened(chromium, url, LESSON)
    start = right(lab)
    lab.press(0, "ArrowRight")
    second = right(lab)
    assert second[0][0] > start[0][0] and second[1] != start[1]
    dragged_by_the_mouse(lab, second)
    lab.type(0, "1.23456")  # the exact number
    assert right(lab)[0][0] == 1.23456
    lab.reset()
    assert right(lab) == start
    the_last_word_is_the_programs(lab)
    lab.page.evaluate("jupyterapp.commands.execute('apputils:change-theme', { theme: 'JupyterLab Dark' })")
    lab.page.wait_for_function("document.body.dataset.jpThemeLight == 'false'")
    colour = lab.page.locator(".kf-sentence").first.evaluate("element => getComputedStyle(element).color")
    assert min(int(part) for part in colour.removeprefix("rgb(").rstrip(")").split(",")[:3]) > 200, colour
    if axe.source():
        assert axe.faults(lab.page) == []


def test_a_picture_that_takes_longer_than_a_hand_waits(chromium, url):
    lab = opened(chromium, url, "slow.ipynb")
    start = right(lab)
    lab.press(0, "ArrowRight")
    lab.press(0, "ArrowRight")
    assert right(lab)[1] != start[1]
    lab.page.close()


def test_a_move_fetches_nothing_from_the_server(chromium, url):
    lab, asked = opened(chromium, url, "plain.ipynb"), []
    lab.page.on("request", lambda request: asked.append(request.url))
    for key in 5 * ["ArrowRight"] + 5 * ["ArrowLeft"]:
        lab.press(0, key)
        lab.settle(0.1)
    assert not [address for address in asked if "/static/" in address]  # as the icon of a busy tab would be
    lab.page.close()


def the_last_word_is_the_programs(lab):
    """Also right after moves of the hand that nobody has answered yet."""
    for k in range(5):
        lab.press(0, "ArrowRight")
        lab.press(0, "ArrowRight")
        assert lab.ask(f"live.set(Q=2, R={k + 1}); live.set(Q=3)") == ""
        assert right(lab)[0][:2] == [3, k + 1]
    lab.ask("live.set(R=50); live.reset()")
    assert right(lab)[0] == json.loads(lab.ask("print([c.start for c in live.controls.values()])"))


def test_while_a_cell_computes(chromium, url):
    """The first move of all, and one after the program has set a control: it works, or a sentence says why not."""
    lab = opened(chromium, url, "plain.ipynb", device_scale_factor=2)
    assert lab.page.locator(".kf-picture canvas").evaluate("c => [c.width, c.clientWidth]") == [1200, 600]
    for code, seconds in (("time.sleep(5)", 5), ("live.set(Q=7); time.sleep(3)", 3)):
        lab.before = lab.pictures()
        lab.page.evaluate(START, code)
        if seconds == 3:
            lab.settle(0.2)
        before = lab.numbers()[0]
        for _ in range(3):
            lab.press(0, "ArrowRight")
        lab.page.wait_for_timeout(1900)
        assert lab.pictures() > lab.before or sentence(lab).startswith(BUSY)
        values, _ = right(lab)
        assert values[0] == pytest.approx(before * 10**0.15, rel=0.02)
    lab.page.evaluate(START, "time.sleep(1); live.set(Q=2)")
    lab.press(0, "ArrowLeft")
    lab.ask("pass")
    assert right(lab)[0][0] == 2
    lab.press(0, "ArrowRight")
    assert right(lab)[0][0] > 2


def test_faults_and_floods(chromium, url):
    """An exception is a sentence with its line; the picture in the hand; two views of one playground, others nested."""
    lab = opened(chromium, url, "nested.ipynb")
    lab.page.evaluate(COUNT)
    assert len(lab.numbers()) == 6
    lab.drag(2, 0.3, swings=3)
    lab.settle()
    shown = lab.numbers()
    assert shown[2:4] == shown[4:6] and shown[2] > 5 and shown[0] == 1, shown
    assert lab.page.evaluate("most") <= 2
    assert lab.ask("print(number.value)") == f"{shown[2]}\n"
    lab.page.get_by_role("spinbutton").fill("5.5")
    lab.page.get_by_role("spinbutton").press("Enter")
    lab.page.wait_for_function(
        "[...document.querySelectorAll('.kf-box')].filter(box => box.value == '5.5').length == 2"
    )
    lab.page.locator(".kf-handle").nth(1).focus()
    lab.before = lab.pictures()
    for _ in range(5):
        lab.page.keyboard.press("ArrowUp")
    lab.settle()
    shown = lab.numbers()
    assert shown[3] == shown[5] > 1
    assert lab.picture(1) == lab.picture(2)
    lab.type(0, "666")
    said(lab, 'failed in line 16, raise ValueError("no such Q"), with ValueError: no such Q')
    lab.type(0, "6")
    said(lab, "Q = 6, R = 1")
    assert lab.page.evaluate("most") <= 2


def test_a_kernel_that_is_killed(chromium, url):
    lab = opened(chromium, url, "dying.ipynb")
    os.kill(int(lab.ask("import os; print(os.getpid())")), signal.SIGKILL)
    dialog = lab.page.locator(".jp-Dialog button.jp-mod-accept")
    dialog.wait_for()
    dialog.click()
    lab.slider(0).press("ArrowRight")
    said(lab, LOST)
    assert lab.numbers() == [1.12, 1]


def test_the_keys_of_lesson_0_lead_to_its_slider(chromium, url):
    """Its words: "press Shift+Tab four times right after Shift+Enter; then the arrow keys move it"."""
    cells = json.loads((ROOT / "notebooks" / "00-start-here.ipynb").read_text(encoding="utf-8"))["cells"]
    first = next(i for i, cell in enumerate(cells) if "".join(cell["source"]).endswith("\nbell"))
    lab = Lab(chromium, url, "00-start-here.ipynb")
    lab.page.locator(".jp-Cell").first.click()
    for _ in range(first + 1):
        lab.page.keyboard.press("Shift+Enter")
    lab.slider(1)
    lab.settle()
    before = lab.numbers()
    for _ in range(4):  # past two rings and the button
        lab.page.keyboard.press("Shift+Tab")
    assert lab.page.evaluate("document.activeElement.type") == "range"
    lab.before = lab.pictures()
    lab.page.keyboard.press("ArrowRight")
    lab.settle()
    assert lab.numbers() != before


@pytest.mark.skipif(not find_spec("notebook"), reason="Notebook 7 is not installed")
def test_notebook_7(chromium, url):
    lab = opened(chromium, url, "plain.ipynb", seven=True, device_scale_factor=2)
    start = right(lab)
    lab.press(0, "ArrowRight")
    lab.settle()
    lab.drag(1, 0.3)
    values, _ = right(lab)
    assert values[0] == 1.12 and values[1] > 5
    handle = lab.page.locator(".kf-handle")
    box, lab.before = handle.bounding_box(), lab.pictures()
    lab.page.mouse.move(box["x"] + 50, box["y"] + box["height"] / 2)
    lab.page.mouse.down()
    lab.page.mouse.move(box["x"] + 60, box["y"] + box["height"] / 2 - 20, steps=5)
    lab.page.mouse.up()
    assert right(lab)[0][1] > 2 * values[1]
    lab.reset()
    assert right(lab) == start
