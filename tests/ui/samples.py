"""A playground to try things on, a browser that is none, and what pictures hold."""

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


def make(update=update, draw=draw, handles=(), **controls):
    controls = controls or dict(Q=log_slider(0.01, 100, 1, unit="V²"), R=slider(0.0, 2.0, 0.5))
    return Playground(draw, update, size=(6, 3), handles=handles, **controls)


def counted(update=update):
    calls = []

    def counting(live, **values):
        calls.append(values)
        return update(live, **values)

    return counting, calls


class Browser:
    """What playground.js does, as far as the kernel sees it: messages there and back."""

    def __init__(self, lively, view="one", ratio=1.0):
        self.lively, self.view, self.heard, self.sent, self.epoch = lively, view, [], 0, 0
        before = lively.widget.send
        lively.widget.send = lambda content, buffers=None: (self.hear(content, buffers), before(content, buffers))
        self.say(kind="hello", ratio=ratio)

    def hear(self, content, buffers):
        self.heard.append((content, buffers))
        self.epoch = content.get("epoch", self.epoch)

    def say(self, **content):
        self.lively.widget._handle_custom_msg(dict(view=self.view, **content), [])

    def move(self, epoch=None, **how):
        """Send a move: values=…, drag=…, nudge=… or reset=True; returns the answer."""
        self.sent += 1
        self.say(kind="move", n=self.sent, epoch=self.epoch if epoch is None else epoch, **how)
        return self.heard[-1][0]

    @property
    def points(self):
        """The numbers of the last picture."""
        return np.frombuffer(self.heard[-1][1][0], np.float32).reshape(-1, 2)


def pixels(data):
    return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"))
