"""How quickly a picture follows a slider, in JupyterLab in a real browser: the course's playground beside `interact`.

    python -m dev.bench.playground

Both draw the same: a Kalman filter over 200 steps, two axes, 800 × 500 pixels. Printed are the time from a key to the
new picture (median), the pictures a second while a slider is dragged, and the ratios.
"""

import statistics
import sys
import tempfile
from pathlib import Path

from dev.lab import CHROMIUM, Lab, browser, notebook, server

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
Playground(draw, update, Q=log_slider(1e-3, 1e3, 0.04), R=log_slider(1e-3, 1e3, 1), size=(8, 5))
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
interact(picture, Q=FloatLogSlider(0.04, min=-3, max=3, step=0.05), R=FloatLogSlider(1, min=-3, max=3, step=0.05));
"""


def measure(lab, keys=8):
    """Milliseconds from a key to its picture (one each for some keys), pictures a second while dragging."""
    lab.page.bring_to_front()
    waits = []
    for i in range(keys):
        lab.press(0, "ArrowRight" if i < keys // 2 else "ArrowLeft")
        lab.settle(0.15)
        waits.append(lab.page.evaluate(f"loads[{lab.before}] - keys.at(-1)"))
    took = lab.drag(1, -0.35, swings=2)
    rate = (lab.pictures() - lab.before) / took
    lab.settle()
    return waits, rate


PLAIN, LIVE, SLOW = "interact with pyplot", "playground", "playground, without jupyter_server_config.py"


def race(rounds=3):
    """{name: (milliseconds from key to picture, pictures a second)}, medians."""
    with tempfile.TemporaryDirectory() as folder, browser() as chromium:
        notebook(Path(folder, "ours.ipynb"), FILTER, OURS)
        notebook(Path(folder, "plain.ipynb"), FILTER, INTERACT)
        with server(folder) as url, server(folder, config=None) as slow:
            labs = {
                PLAIN: Lab(chromium, url, "plain.ipynb"),
                LIVE: Lab(chromium, url, "ours.ipynb"),
                SLOW: Lab(chromium, slow, "ours.ipynb"),
            }
            for lab in labs.values():
                lab.page.bring_to_front()
                lab.run_all()
                lab.settle()
            results = [{name: measure(lab) for name, lab in labs.items()} for _ in range(rounds)]  # in turns
    return {
        name: (
            statistics.median(wait for result in results for wait in result[name][0]),
            statistics.median(result[name][1] for result in results),
        )
        for name in labs
    }


def ratios(results):
    """How many times as quick as `interact` a picture follows a key, and as many pictures a second."""
    return results[PLAIN][0] / results[LIVE][0], results[LIVE][1] / results[PLAIN][1]


def table(results):
    """The lines of a table in Markdown."""
    yield "| | key → picture | pictures a second |"
    yield "|---|---:|---:|"
    for name, (wait, rate) in results.items():
        yield f"| {name} | {wait:.0f} ms | {rate:.1f} |"
    quicker, more = ratios(results)
    yield f"| playground to interact | {quicker:.1f} × | {more:.1f} × |"
    yield "| goal | ≥ 3 × | ≥ 4 ×, ≥ 15 pictures |"


if __name__ == "__main__":
    if not CHROMIUM:
        sys.exit("no Chromium found: install chromium, chromium-browser or google-chrome")
    print("\n".join(table(race())))
