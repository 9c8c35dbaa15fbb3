"""How quickly a picture follows a slider, in JupyterLab in a real browser: the course's playground beside `interact`,
and beside itself as it was when pictures were PNG files.

    python -m dev.bench.playground

All draw the same: a Kalman filter over 200 steps, two axes, 800 × 500 pixels. Printed are medians of five rounds: the
time from a key to the new picture; pictures a second, and for each movement of the pointer, while a slider is dragged;
the processor's time in the kernel for a picture, with the filter; what goes to the browser for it.
"""

import io
import statistics
import subprocess
import sys
import tarfile
import tempfile
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import NamedTuple

from dev.bench import goals
from dev.lab import CHROMIUM, ROOT, Lab, browser, notebook, server

OLD = "c9f65fa"  # the last commit before pictures were drawn in the browser
PLAIN, LIVE, SLOW = "interact with pyplot", "playground", "playground, without jupyter_server_config.py"
BEFORE = f"playground of {OLD}"  # as a learner had it: with the configuration of Jupyter of that commit
NEWER = f"{BEFORE}, today's jupyter_server_config.py"
SHARE, MOVES = (
    -0.45,
    40,
)  # of the slider: each movement of the pointer, there and back, passes a step and asks for a picture

FILTER = """
import numpy as np
from kflearn import Gaussian, LinearModel, kalman_filter
rng = np.random.default_rng(1)
t = np.arange(200)
x = np.cumsum(rng.normal(0, 0.2, 200))
z = x + rng.normal(0, 1, 200)
def run(Q, R):
    track = kalman_filter(LinearModel([[1]], [[1]], [[Q]], [[R]]), z, Gaussian([0], [[10]]))
    return track.mean[:, 0], np.sqrt(track.cov[:, 0, 0]), track.gain[:, 0, 0]
"""

OURS = """
from kflearn import plots
from kflearn.ui import Playground, log_slider
def draw(fig):
    above, below = fig.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    plots.truth(above, t, x)
    plots.measurements(above, t, z)
    mean, std, k = run(0.04, 1)
    live = plots.estimate(above, t, mean, std), plots.gain(below, t, k)
    above.set(ylabel="voltage / V", ylim=(-6, 6))
    below.set(xlabel="time / s", ylabel="gain", ylim=(0, 1.05))
    above.legend(ncols=4)
    return live
def update(live, Q, R):
    mean, std, k = run(Q, R)
    live[0].set(t, mean, std)
    live[1].set(t, k)
    return f"Q = {Q:g}, R = {R:g}: steady gain {k[-1]:.2f}"
live = Playground(draw, update, Q=log_slider(1e-3, 1e3, 0.04), R=log_slider(1e-3, 1e3, 1), size=(8, 5))
live
"""

INTERACT = """
import matplotlib.pyplot as plt
from ipywidgets import FloatLogSlider, interact
def picture(Q, R):
    mean, std, k = run(Q, R)
    fig, (above, below) = plt.subplots(2, 1, sharex=True, height_ratios=(2, 1), figsize=(8, 5), dpi=100)
    above.plot(t, x, "k-", label="truth")
    above.plot(t, z, ".", color="gray", label="measurement")
    above.fill_between(t, mean - 2 * std, mean + 2 * std, alpha=0.2, label="±2σ")
    above.plot(t, mean, label="estimate")
    above.set(ylabel="voltage / V", ylim=(-6, 6))
    below.plot(t, k, "g-.")
    below.set(xlabel="time / s", ylabel="gain", ylim=(0, 1.05))
    above.legend(ncols=4)
    plt.show()
ends = dict(min=-3, max=3, step=0.05)
live = interact(picture, Q=FloatLogSlider(0.04, **ends), R=FloatLogSlider(1, **ends)).widget
"""

KERNEL = """
import time
again = getattr(live, "refresh", None) or live.update
def cpu(count=10):
    begun = time.thread_time()
    for _ in range(count):
        again()
    return 1000 * (time.thread_time() - begun) / count
print(sorted(cpu() for _ in range(5))[2])
"""

# In the page: the sizes of the kernel's messages, with their buffers.
WEIGH = """() => {
  const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel;
  let sum = 0;
  const weigh = (_, { direction, msg }) => {
    if (direction != "recv") return;
    sum += JSON.stringify(msg.content).length;
    for (const buffer of msg.buffers || []) sum += buffer.byteLength;
  };
  kernel.anyMessage.connect(weigh);
  window.weighed = () => { kernel.anyMessage.disconnect(weigh); return sum };
}"""


class Round(NamedTuple):
    """What was measured of one competitor: milliseconds, pictures a second and a movement, bytes, milliseconds."""

    wait: float
    rate: float
    each: float
    size: float
    kernel: float = 0


def measure(lab, keys=8):
    """One round: milliseconds from key to picture, pictures a second and for each movement while dragging, bytes."""
    lab.page.bring_to_front()
    waits = []
    lab.page.evaluate(WEIGH)
    for i in range(keys):
        lab.press(0, "ArrowRight" if i < keys // 2 else "ArrowLeft")
        lab.settle(0.15)
        waits.append(lab.page.evaluate(f"loads[{lab.before}] - keys.at(-1)"))
    weight = lab.page.evaluate("weighed()") / keys
    took = lab.drag(1, SHARE, swings=2, moves=MOVES)
    count = lab.pictures() - lab.before
    lab.settle()
    return Round(statistics.median(waits), count / took, count / (2 * MOVES), weight)


@contextmanager
def old_package():
    """A folder with the package of the commit OLD and its configuration of Jupyter; None where git does not know it."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["git", "archive", "--format=tar", OLD, "kflearn", "jupyter_server_config.py"]
        found = subprocess.run(command, cwd=ROOT, capture_output=True)
        if found.returncode == 0:
            with tarfile.open(fileobj=io.BytesIO(found.stdout)) as files:
                files.extractall(folder, filter="data")
        yield folder if found.returncode == 0 else None


def race(rounds=5):
    """{name: Round of medians}; the competitors take turns in each round."""
    with tempfile.TemporaryDirectory() as folder, browser() as chromium, ExitStack() as stack:
        for name in ("ours.ipynb", "slow.ipynb"):  # a file for each: JupyterLab asks when another one has saved it
            notebook(Path(folder, name), FILTER, OURS)
        notebook(Path(folder, "plain.ipynb"), FILTER, INTERACT)
        url, slow = stack.enter_context(server(folder)), stack.enter_context(server(folder, config=None))
        labs = {PLAIN: Lab(chromium, url, "plain.ipynb"), LIVE: Lab(chromium, url, "ours.ipynb")}
        labs[SLOW] = Lab(chromium, slow, "slow.ipynb")
        if package := stack.enter_context(old_package()):
            for name, file, config in ((BEFORE, "old.ipynb", package), (NEWER, "newer.ipynb", ROOT)):
                notebook(Path(folder, file), FILTER, OURS.replace("kflearn.ui", "kflearn.playground"))
                url = stack.enter_context(server(folder, config=config, package=package))
                labs[name] = Lab(chromium, url, file)
        for lab in labs.values():
            lab.page.bring_to_front()
            lab.run_all()
            lab.slider(0)
            lab.settle(1)
        results = [{name: measure(lab) for name, lab in labs.items()} for _ in range(rounds)]
        kernel = {name: float(lab.ask(KERNEL)) for name, lab in labs.items()}  # last: interact is not the same after it
    medians = {name: map(statistics.median, zip(*(one[name] for one in results), strict=True)) for name in labs}
    return {name: Round(*found)._replace(kernel=kernel[name]) for name, found in medians.items()}


def ratios(results):
    """The rows that compare: name, figure, goal, whether the figure may be at most the goal."""
    ours, plain, before = results[LIVE], results[PLAIN], results.get(BEFORE)
    yield "key → picture, times quicker than interact", plain.wait / ours.wait, 8, False
    if before:
        yield f"key → picture, share of the time of {OLD}", ours.wait / before.wait, 0.5, True
    often = before and ours.rate >= 2 * before.rate
    if often:
        yield f"pictures a second, times those of {OLD}", ours.rate / before.rate, 2, False
    else:
        yield "pictures for each movement of the pointer", ours.each, 0.9, False
    yield "kernel's milliseconds a picture", ours.kernel, 4, True


def table(results):
    """The lines of two tables in Markdown."""
    yield "| | key → picture | pictures a second | for each movement | kernel, a picture | to the browser, a picture |"
    yield "|---|---:|---:|---:|---:|---:|"
    for name, one in results.items():
        cells = (
            f"{one.wait:.1f} ms",
            f"{one.rate:.1f}",
            f"{one.each:.2f}",
            f"{one.kernel:.1f} ms",
            f"{one.size / 1e3:.1f} kB",
        )
        yield f"| {name} | {' | '.join(cells)} |"
    if BEFORE not in results:
        yield f"| {BEFORE} | not raced: git does not know this commit here | | | | |"
    yield from ["", "| the playground | | goal |", "|---|---:|---:|"]
    for name, figure, goal, at_most in ratios(results):
        yield f"| {name} | {goals.judged(figure, goal, at_most)} | {'≤' if at_most else '≥'} {goal} |"


if __name__ == "__main__":
    if not CHROMIUM:
        sys.exit("no Chromium found: install chromium, chromium-browser or google-chrome")
    print("\n".join(table(race())))
