"""JupyterLab in a real browser, for the tests and the benchmark: a server, a page, hands and eyes.

with server(folder) as url, browser() as chromium:
    lab = Lab(chromium, url, "lesson.ipynb")
    lab.run_all()
    lab.press(0, "ArrowRight")      # slider 0
    lab.picture(0)                  # the bytes of picture 0
"""

import base64
import io
import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from contextlib import contextmanager, suppress
from pathlib import Path

import nbformat
import numpy as np
from PIL import Image

ROOT = Path(__file__).parent.parent
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"]
FLAGS += ["--disable-background-networking", "--disable-component-update"]


def notebook(path, *cells):
    """Write a notebook of code cells."""
    nb = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    nb.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    for number, cell in enumerate(nb.cells):
        cell.id = f"cell-{number}"
    nbformat.write(nb, path)


def free_port():
    """The number of a port at which nobody waits."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


def variables(home, config, quiet):
    """The environment of a server that takes nothing from the user's own settings."""
    places = ["JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"]
    places += ["JUPYTERLAB_SETTINGS_DIR", "JUPYTERLAB_WORKSPACES_DIR"]
    if quiet:
        news = Path(home, "JUPYTERLAB_SETTINGS_DIR/@jupyterlab/apputils-extension/notification.jupyterlab-settings")
        news.parent.mkdir(parents=True)
        news.write_text('{"fetchNews": "false", "checkForUpdates": false}', encoding="utf-8")
    return os.environ | {name: f"{home}/{name}" for name in places} | {"JUPYTER_CONFIG_PATH": str(config or home)}


def wait_for(address, process, log):
    """Wait until a server answers; fails with the server's last words when its process has ended."""
    for _ in range(300):
        try:
            return urllib.request.urlopen(address, timeout=5).close()
        except OSError:
            assert process.poll() is None, Path(log).read_text(encoding="utf-8")
            time.sleep(0.1)


def stop(process):
    """End a server, its kernels too."""
    process.terminate()
    with suppress(subprocess.TimeoutExpired):
        process.wait(10)
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)  # whatever is left of the server's own process group
    process.wait()


@contextmanager
def server(folder, config=ROOT, quiet=True, package=None):
    """A JupyterLab server for a folder, started as `make course` does; yields its URL with {} for the path of a page.

    config : the folder with jupyter_server_config.py, or None for Jupyter as it comes
    quiet : without the pop-up that asks about news of Jupyter
    package : a folder with another kflearn than the one that is installed
    """
    port, token = free_port(), secrets.token_hex(16)
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}"]
    command += [f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={folder}", "--ServerApp.port_retries=0"]
    command += ["--LabApp.expose_app_in_browser=True", "--JupyterNotebookApp.expose_app_in_browser=True"]
    with tempfile.TemporaryDirectory() as home:
        env, file = variables(home, config, quiet), f"{home}/log"
        env |= {"PYTHONPATH": str(package)} if package else {}
        with open(file, "wb") as log:
            process = subprocess.Popen(command, cwd=ROOT, env=env, stdout=log, stderr=log, start_new_session=True)
        try:
            wait_for(f"http://127.0.0.1:{port}/api", process, file)
            yield f"http://127.0.0.1:{port}/{{}}?token={token}"
        finally:
            stop(process)


@contextmanager
def browser(*flags):
    """Chromium without a window."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM, args=[*FLAGS, *flags])
        try:
            yield chromium
        finally:
            chromium.close()


WATCH = """() => {
  window.loads = []; window.keys = [];
  const came = () => loads.push(performance.now());
  document.addEventListener('load', e => e.target.matches?.('.jp-OutputArea img') && came(), true);
  document.addEventListener('kf-picture', came, true);
  document.addEventListener('keydown', e => keys.push(performance.now()), true);
}"""

BYTES = """index => document.querySelectorAll('.kf-picture canvas')[index].toDataURL().split(',')[1]"""


BOXES = ".kf-box"
KNOB = 16  # pixels of a slider's knob in Chromium


ASK = """async code => {
  const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel, printed = [];
  const future = kernel.requestExecute({code: code, store_history: false});
  future.onIOPub = message => printed.push(message.content.text || (message.content.traceback || []).join(''));
  await future.done;
  return printed.join('');
}"""


class Lab:
    """A notebook open in JupyterLab, or in Notebook 7; `how` is for the page, such as device_scale_factor=2.

    Sliders, number boxes and pictures are counted from 0 in the order of the page."""

    def __init__(self, chromium, url, name, width=1280, height=1000, seven=False, **how):
        self.page = chromium.new_page(viewport={"width": width, "height": height}, **how)
        self.page.set_default_timeout(30_000)
        place = "notebooks" if seven else f"lab/workspaces/{secrets.token_hex(4)}/tree"  # no other notebook beside it
        self.page.goto(url.format(f"{place}/{name}"))
        self.page.locator(".jp-NotebookPanel .jp-Cell").first.wait_for()
        self.page.wait_for_function("() => jupyterapp.shell.currentWidget?.sessionContext?.session?.kernel")
        self.page.evaluate("() => jupyterapp.shell.currentWidget.sessionContext.ready")
        if not seven:
            self.page.evaluate("() => jupyterapp.commands.execute('application:toggle-left-area')")
        self.page.evaluate(WATCH)
        self.before = 0  # pictures that had come before the last thing done

    def run_all(self):
        """Run all cells; fails when one of them does."""
        self.page.evaluate("() => jupyterapp.commands.execute('notebook:run-all-cells')")
        errors = self.page.locator('.jp-RenderedText[data-mime-type="application/vnd.jupyter.stderr"]')
        assert errors.count() == 0, errors.first.inner_text()

    def slider(self, index):
        """A slider, scrolled into view: the course's own, or one of ipywidgets (its knob)."""
        found = self.page.locator(".kf-control input[type=range], .noUi-handle").nth(index)
        found.scroll_into_view_if_needed()
        return found

    def press(self, slider, key):
        """Press a key on a slider."""
        self.before = self.pictures()
        self.slider(slider).press(key)

    def knob(self, slider):
        """Where a slider's knob is, and how long its way is: x, y, length."""
        found = self.slider(slider)
        box = found.bounding_box()
        if found.evaluate("e => e.tagName") == "INPUT":
            share = found.evaluate("e => (e.value - e.min) / (e.max - e.min)")
            length = box["width"] - KNOB
            return box["x"] + KNOB / 2 + share * length, box["y"] + box["height"] / 2, length
        track = found.locator("xpath=ancestor::*[contains(@class, 'noUi-base')]").bounding_box()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, track["width"]

    def drag(self, slider, share, swings=1, moves=60):
        """Take a slider's knob and move it over a share of its length, as a hand does: one movement each frame of the
        browser. With 3, 5, … swings it goes there, back and there again. Returns the seconds taken."""
        x, y, length = self.knob(slider)
        mouse, self.before = self.page.mouse, self.pictures()
        mouse.move(x, y)
        mouse.down()
        start = time.monotonic()
        for swing in range(swings):
            mouse.move(x + share * length * (1 - swing % 2), y, steps=moves)
        took = time.monotonic() - start
        mouse.up()
        return took

    def pictures(self):
        """How many pictures have come since the page was opened."""
        return self.page.evaluate("loads.length")

    def settle(self, quiet=0.3):
        """Wait until a picture has come after the last thing done, and then no other for a while."""
        self.page.wait_for_function(f"() => loads.length > {self.before}", polling=50)
        self.page.wait_for_function(f"() => performance.now() - loads.at(-1) > {1000 * quiet}", polling=50)

    def rest(self):
        """Settle, and wait until the kernel has answered whatever was asked of it and no picture follows."""
        self.settle()
        seen = None
        while seen != self.pictures():
            seen = self.pictures()
            self.ask("pass")  # the kernel answers in order
            self.page.wait_for_timeout(300)

    def picture(self, index=0):
        """A live picture as the browser has it now: the bytes of a PNG file."""
        return base64.b64decode(self.page.evaluate(BYTES, index))

    def numbers(self):
        """What stands in the number boxes."""
        boxes = self.page.locator(BOXES)
        return [float(text) for text in boxes.evaluate_all("all => all.map(i => i.value)")]

    def type(self, box, text):
        """Type a number into a box."""
        self.before = self.pictures()
        place = self.page.locator(BOXES).nth(box)
        place.fill(text)
        place.press("Enter")

    def reset(self):
        """Press the first playground's reset button."""
        self.before = self.pictures()
        self.page.get_by_role("button", name="Reset").first.click()

    @contextmanager
    def film(self, index=0):
        """Film a picture as it is painted on the screen; yields a list that is filled with arrays of grey values."""
        place = self.page.locator(".kf-picture").nth(index).bounding_box()
        left, top, right, low = place["x"], place["y"], place["x"] + place["width"], place["y"] + place["height"]
        frames, tape = [], self.page.context.new_cdp_session(self.page)

        def keep(frame):
            frames.append(frame["data"])
            tape.send("Page.screencastFrameAck", {"sessionId": frame["sessionId"]})

        tape.on("Page.screencastFrame", keep)
        tape.send("Page.startScreencast", {"format": "jpeg", "quality": 50})
        yield frames
        tape.send("Page.stopScreencast")
        tape.detach()
        for i, data in enumerate(frames):
            screen = Image.open(io.BytesIO(base64.b64decode(data))).convert("L")
            frames[i] = np.asarray(screen.crop((left, top, min(right, screen.width), min(low, screen.height))))

    def ask(self, code):
        """Run code in the notebook's kernel, beside its cells; returns what it prints."""
        return self.page.evaluate(ASK, code)
