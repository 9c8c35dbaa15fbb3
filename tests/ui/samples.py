"""A playground to try things on, and what its pictures hold."""

import io
from types import SimpleNamespace

import numpy as np
from PIL import Image

from kflearn import plots
from kflearn.ui import Playground, log_slider, slider

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
