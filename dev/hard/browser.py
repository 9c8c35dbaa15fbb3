"""Ten minutes of a restless reader: two lessons open at once in JupyterLab, all their sliders moved without a pause.

Drags of sliders and in the picture, keys, typed numbers (also such as are not allowed), buttons and resets come in a
random order, now in one lesson, now in the other, now in both at the same time. After each burst comes a rest, and
everything is compared: the numbers in the browser with those of the kernel, the pictures with those that the kernel
then makes anew, and a lesson that nobody touched with what it was before.
The environment variable MINUTES makes it shorter or longer.

The page's memory is that of moving sliders. Going from one cell to another is left out, with one playground in each
lesson: JupyterLab 4.6 keeps some 90 kB each time, also in a notebook of two empty cells.
"""

import json
import os
import random
import shutil
import tempfile
import time
from collections import Counter
from hashlib import sha256
from itertools import cycle
from pathlib import Path
from statistics import median

import psutil

from dev.hard.line import Line
from dev.lab import CHROMIUM, ROOT, Lab, browser, notebook, server

MINUTES = float(os.environ.get("MINUTES", "10"))
LESSONS = "05-voltmeter.ipynb", "11-train-and-ship.ipynb"  # two sliders; three, one of whole numbers, and buttons
KEYS = "ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End"
FLAT = 0.05  # the share by which memory may have changed at the end
KEEP_CODE = "--js-flags=--no-flush-bytecode"  # else V8 drops some 4 MB of JupyterLab's compiled code at some moment

# In the page: every message of the kernel that tells of trouble, also of what happens between the cells. Not counted is
# that JupyterLab, when it opens a notebook, looks for widgets in a kernel that has not imported ipywidgets yet.
LISTEN = """() => {
  window.trouble = [];
  jupyterapp.shell.currentWidget.sessionContext.session.kernel.iopubMessage.connect((_, message) => {
    const {header, content} = message, text = content.text || content.evalue;
    if (header.msg_type == 'error' || (content.name == 'stderr' && !text.startsWith('No such comm')))
      trouble.push(text);
  });
}"""

# In the kernel: the playgrounds in the order of the page, what they show, and what they should show, made anew.
PLAYGROUNDS = """
import json, os
from hashlib import sha256
from kflearn.ui.controls import Slider
from kflearn.ui import Playground
live = list({id(thing): thing for thing in list(globals().values()) if isinstance(thing, Playground)}.values())
"""
BEGIN = (
    PLAYGROUNDS
    + """
sliders = [c for one in live for c in one.controls.values() if isinstance(c, Slider)]
print(json.dumps(dict(pid=os.getpid(), ends=[(c.low, c.high) for c in sliders])))
"""
)
STATE = (
    PLAYGROUNDS
    + """
pictures = []
for one in live:
    shown = sha256(one.png()).hexdigest()
    one.refresh()
    pictures.append((shown, sha256(one.png()).hexdigest()))
numbers = [c.value for one in live for c in one.controls.values() if isinstance(c, Slider)]
print(json.dumps(dict(pictures=pictures, numbers=numbers, errors=sum(one.errors for one in live))))
"""
)

SMALL = """
from kflearn.ui import Playground, choice, drag, log_slider, slider
def draw(fig):
    return fig.subplots().plot([0, 100], [0, 100], "o")[0]
def update(dots, n, q, mirror):
    dots.set_data(range(n + 1), [q * (100 - i if mirror == "yes" else i) for i in range(n + 1)])
    return f"{n} and {q}"
sliders = dict(n=slider(0, 100, 50), q=log_slider(0.01, 1, 1))
Playground(draw, update, handles=[drag(x="n")], **sliders, mirror=choice(["no", "yes"]))
"""


class Reader:
    """A lesson in a tab of its own, and a reader whose hands do not rest."""

    def __init__(self, chromium, url, name, seed):
        self.random, self.console, self.memory = random.Random(seed), [], []
        self.lab = Lab(chromium, url, name)
        self.page = self.lab.page
        self.page.on("console", lambda message: message.type == "error" and self.console.append(message.text))
        self.page.on("pageerror", lambda error: self.console.append(str(error)))
        self.page.evaluate(LISTEN)
        self.lab.run_all()
        begin = json.loads(self.lab.ask(BEGIN))
        self.kernel, self.ends = psutil.Process(begin["pid"]), begin["ends"]
        self.tape = self.page.context.new_cdp_session(self.page)
        self.tape.send("Performance.enable")
        self.before = self.rest()

    # -- hands

    def move(self):
        """Do something, quickly."""
        hands = [self.drag, self.hold, self.press, self.type, self.click, self.reset]
        self.random.choices(hands, [4, 2, 4, 3, 2, 1])[0]()

    def slider(self):
        return self.random.randrange(len(self.ends))

    def drag(self):
        self.lab.drag(self.slider(), self.random.uniform(-1, 1), self.random.choice([1, 1, 3]), moves=20)

    def hold(self):
        """Something in the picture is taken hold of, and moved on with the arrow keys."""
        handles = self.page.locator(".kf-handle")
        if not (count := handles.count()):
            return self.drag()
        handle, mouse = handles.nth(self.random.randrange(count)), self.page.mouse
        handle.scroll_into_view_if_needed()
        box = handle.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        mouse.move(x, y)
        mouse.down()
        mouse.move(x + self.random.uniform(-150, 150), y + self.random.uniform(-80, 80), steps=15)
        mouse.up()
        for key in self.random.choices(KEYS[:4], k=self.random.randint(0, 3)):
            self.page.keyboard.press(key)

    def press(self):
        slider = self.slider()
        for key in self.random.choices(KEYS, k=self.random.randint(1, 5)):
            self.lab.press(slider, key)

    def type(self):
        box = self.slider()
        low, high = self.ends[box]
        numbers = [low, high, low - 1, 10 * high, self.lab.numbers()[box] + 0.25, *[self.random.uniform(low, high)] * 4]
        self.lab.type(box, self.random.choice(["", "1e999", *[f"{self.random.choice(numbers):.6g}"] * 6]))

    def click(self):
        buttons = self.page.locator(".kf-option")
        if count := buttons.count():
            buttons.nth(self.random.randrange(count)).click()

    def reset(self):
        buttons = self.page.get_by_role("button", name="Reset")
        buttons.nth(self.random.randrange(buttons.count())).click()

    # -- eyes

    def rest(self):
        """Wait until nothing comes any more; then what the page shows: pictures, numbers."""
        self.lab.before = -1  # the last move may have changed nothing
        for _ in range(2):  # the kernel answers after all moves that it was told of
            self.lab.ask("pass")
            self.page.wait_for_timeout(150)
        self.lab.settle()
        return [sha256(self.lab.picture(index)).hexdigest() for index in range(self.pictures())], self.lab.numbers()

    def pictures(self):
        return self.page.locator(".kf-picture canvas").count()

    def stale(self):
        """Is there anything in the page that is not what its own kernel's values give?"""
        pictures, numbers = self.before = self.rest()
        kernel = json.loads(self.lab.ask(STATE))
        self.errors = kernel["errors"]
        anew, _ = self.rest()  # the kernel has just made them all again
        drawn = all(shown == fresh for shown, fresh in kernel["pictures"])
        return pictures != anew or numbers != kernel["numbers"] or not drawn

    def weigh(self):
        """Note the megabytes of kernel (RSS) and page (JavaScript's heap after a collection)."""
        self.lab.ask("import gc; gc.collect(); None")
        self.tape.send("HeapProfiler.collectGarbage")
        found = {each["name"]: each["value"] for each in self.tape.send("Performance.getMetrics")["metrics"]}
        self.memory.append((time.monotonic(), self.kernel.memory_info().rss / 1e6, found["JSHeapUsedSize"] / 1e6))

    def trouble(self):
        """Tracebacks and warnings of the kernel, errors in the browser's console, failed updates."""
        return self.page.evaluate("trouble") + self.console + ["update failed"] * self.errors


def both_drag(one, other):
    """The mouse of each lesson is pressed, moved and let go in turn with the other's."""
    hands = []
    for reader in (one, other):
        x, y, length = reader.lab.knob(reader.slider())
        hands.append((reader.page.mouse, x, y, reader.random.uniform(-1, 1) * length / 20))
        reader.page.mouse.move(x, y)
        reader.page.mouse.down()
    for step in range(20):
        for mouse, x, y, stride in hands:
            mouse.move(x + (step + 1) * stride, y)
    for mouse, *_ in hands:
        mouse.up()


def round_of(readers, busy, moves=6):
    """A burst by those who are busy, then a rest. Counts: moves, rests, pages with something stale in them, and pages
    that changed though nobody touched them."""
    counts = Counter()
    for _ in range(moves):
        both_drag(*busy) if len(busy) == 2 else busy[0].move()
        counts["moves"] += len(busy)
    for reader in readers:
        if reader not in busy:
            counts["disturbed"] += reader.before != reader.rest()
        counts["stale"] += reader.stale()
        counts["rests"] += 1
        reader.weigh()
    return counts


def torture(readers, seconds):
    """Rounds of both lessons, of the one, of the other. All counts."""
    begun, counts, busy = time.monotonic(), Counter(), cycle([readers, readers[:1], readers[1:]])
    while time.monotonic() - begun < seconds:
        counts += round_of(readers, next(busy))
    return counts


def growth(samples):
    """Medians of a quantity after the warm-up and at the end. [(seconds, megabytes)] → (before, after)

    The first tenth of the time is warm-up; what is compared is the tenth after it and the last one.
    """
    first, last = samples[0][0], samples[-1][0]
    tenth = (last - first) / 10
    before = [size for when, size in samples if first + tenth <= when <= first + 2 * tenth]
    after = [size for when, size in samples if when >= last - tenth]
    return median(before or [samples[0][1]]), median(after)


def memory_lines(reader, name):
    for what, place in (("kernel's memory (RSS)", 1), ("page's memory (JavaScript heap)", 2)):
        before, after = growth([(sample[0], sample[place]) for sample in reader.memory])
        change = after / before - 1
        measured = f"{before:.1f} → {after:.1f} MB, {100 * change:+.1f} %"
        yield Line(f"{name[:2]}: {what}", measured, f"±{100 * FLAT:.0f} %", abs(change) <= FLAT)


def lines(quick=False):
    if not CHROMIUM:
        yield Line("JupyterLab in a browser", "not tried: no Chromium", "tried where there is one", True)
        return
    seconds = 3 if quick else 60 * MINUTES
    with tempfile.TemporaryDirectory() as folder:
        for name in LESSONS:
            if quick:
                notebook(Path(folder, name), SMALL)
            else:
                shutil.copy(ROOT / "notebooks" / name, folder)
        with server(folder) as url, browser(KEEP_CODE) as chromium:
            readers = [Reader(chromium, url, name, seed) for seed, name in enumerate(LESSONS)]
            counts = torture(readers, seconds)
            trouble = [each for reader in readers for each in reader.trouble()]
    tried = f"of {counts['rests']} rests, {counts['moves']} moves"
    yield Line(
        "picture or number not what the kernel's values give", f"{counts['stale']} {tried}", "0", not counts["stale"]
    )
    yield Line("tracebacks, warnings, errors in the browser's console", f"{len(trouble)}", "0", not trouble)
    yield Line(
        "lesson disturbed by the one open beside it", f"{counts['disturbed']} {tried}", "0", not counts["disturbed"]
    )
    for reader, name in zip(readers, LESSONS, strict=True):
        yield from memory_lines(reader, name)
