"""JupyterLab in a real browser, for the tests and the benchmark: a server, a page, hands and eyes.

with server(folder) as url, browser() as chromium:
    lab = Lab(chromium, url, "lesson.ipynb")
    lab.run_all()
    lab.press(0, "ArrowRight")      # slider 0
    lab.picture(0)                  # the bytes of picture 0
"""

import base64
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


def code(path):
    """The code of a notebook, to be executed in this process."""
    return "\n".join(cell.source for cell in nbformat.read(path, 4).cells if cell.cell_type == "code")


@contextmanager
def server(folder, config=ROOT):
    """A JupyterLab server for a folder, started as `make course` does; yields its URL with {} for the path of a page.

    config : the folder with jupyter_server_config.py, or None for Jupyter as it comes.
    """
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token = secrets.token_hex(16)
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}"]
    command += [f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={folder}", "--ServerApp.port_retries=0"]
    command += ["--LabApp.expose_app_in_browser=True"]
    with tempfile.TemporaryDirectory() as home:  # nothing of the user's own settings
        places = ["JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"]
        places += ["JUPYTERLAB_SETTINGS_DIR", "JUPYTERLAB_WORKSPACES_DIR"]
        env = os.environ | {name: f"{home}/{name}" for name in places} | {"JUPYTER_CONFIG_PATH": str(config or home)}
        news = Path(home, "JUPYTERLAB_SETTINGS_DIR/@jupyterlab/apputils-extension/notification.jupyterlab-settings")
        news.parent.mkdir(parents=True)
        news.write_text('{"fetchNews": "false", "checkForUpdates": false}')
        with open(f"{home}/log", "wb") as log:
            process = subprocess.Popen(command, cwd=ROOT, env=env, stdout=log, stderr=log, start_new_session=True)
        try:
            for _ in range(300):
                try:
                    urllib.request.urlopen(f"http://127.0.0.1:{port}/api", timeout=5).close()
                    break
                except OSError:
                    assert process.poll() is None, Path(home, "log").read_text()
                    time.sleep(0.1)
            yield f"http://127.0.0.1:{port}/{{}}?token={token}"
        finally:
            process.terminate()  # ends its kernels too
            with suppress(subprocess.TimeoutExpired):
                process.wait(10)
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)  # whatever is left of the server's own process group
            process.wait()


@contextmanager
def browser():
    """Chromium without a window."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        try:
            yield chromium
        finally:
            chromium.close()


WATCH = """() => {
  window.loads = []; window.keys = [];
  document.addEventListener('load', e => { if (e.target.tagName == 'IMG') loads.push(performance.now()) }, true);
  document.addEventListener('keydown', e => keys.push(performance.now()), true);
}"""

FRAMES = """index => {
  window.frames_seen = []; window.looking = true;
  const look = () => {
    const img = document.querySelectorAll('.widget-image')[index];
    const box = img ? img.getBoundingClientRect() : {};
    frames_seen.push([img ? img.naturalWidth : 0, Math.round(box.width || 0), Math.round(box.height || 0)].join());
    if (looking) requestAnimationFrame(look);
  };
  look();
}"""

BYTES = """async index => {
  const bytes = await (await fetch(document.querySelectorAll('.widget-image')[index].src)).arrayBuffer();
  return btoa(Array.from(new Uint8Array(bytes), b => String.fromCharCode(b)).join(''));
}"""


class Lab:
    """A notebook open in JupyterLab. Sliders, number boxes and pictures are counted from 0 in the order of the page."""

    def __init__(self, chromium, url, name, width=1280, height=1000):
        self.page = chromium.new_page(viewport={"width": width, "height": height})
        self.page.set_default_timeout(30_000)
        self.page.goto(url.format(f"lab/workspaces/{secrets.token_hex(4)}/tree/{name}"))  # no other notebook beside it
        self.page.locator(".jp-NotebookPanel .jp-Cell").first.wait_for()
        self.page.wait_for_function("() => jupyterapp.shell.currentWidget?.sessionContext?.session?.kernel")
        self.page.evaluate("() => jupyterapp.shell.currentWidget.sessionContext.ready")
        self.page.evaluate("() => jupyterapp.commands.execute('application:toggle-left-area')")
        self.page.evaluate(WATCH)

    def run_all(self):
        """Run all cells; fails when one of them does."""
        self.page.evaluate("() => jupyterapp.commands.execute('notebook:run-all-cells')")
        errors = self.page.locator('.jp-RenderedText[data-mime-type="application/vnd.jupyter.stderr"]')
        assert errors.count() == 0, errors.first.inner_text()

    def handle(self, slider):
        """The knob of a slider, scrolled into view."""
        handle = self.page.locator(".noUi-handle").nth(slider)
        handle.scroll_into_view_if_needed()
        return handle

    def press(self, slider, key, times=1):
        """Press a key on a slider."""
        for _ in range(times):
            self.handle(slider).press(key)

    def drag(self, slider, share, swings=1, moves=60):
        """Take a slider's knob and move it over a share of its length, as a hand does: one movement each frame of the
        browser. With 3, 5, … swings it goes there, back and there again. Returns the seconds taken."""
        box, track = self.handle(slider).bounding_box(), self.page.locator(".noUi-base").nth(slider).bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        mouse = self.page.mouse
        mouse.move(x, y)
        mouse.down()
        start = time.monotonic()
        for swing in range(swings):
            mouse.move(x + share * track["width"] * (1 - swing % 2), y, steps=moves)
        took = time.monotonic() - start
        mouse.up()
        return took

    def settle(self, quiet=0.4):
        """Wait until no picture has come for a while."""
        self.page.wait_for_function(f"() => performance.now() - (loads.at(-1) || 0) > {1000 * quiet}")

    def picture(self, index=0):
        """The bytes of a live picture, as the browser has it now."""
        return base64.b64decode(self.page.evaluate(BYTES, index))

    def numbers(self):
        """What stands in the number boxes."""
        boxes = self.page.locator(".widget-text input")
        return [float(text) for text in boxes.evaluate_all("all => all.map(i => i.value)")]

    def type(self, box, text):
        """Type a number into a box."""
        place = self.page.locator(".widget-text input").nth(box)
        place.fill(text)
        place.press("Enter")

    @contextmanager
    def watch(self, index=0):
        """Look at a picture in every frame of the browser; yields a set that is filled with what was seen, "w,w,h"."""
        seen = set()
        self.page.evaluate(FRAMES, index)
        yield seen
        seen.update(self.page.evaluate("() => { looking = false; return frames_seen }"))
