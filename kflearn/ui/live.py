"""A playground's side of the messages: what comes from playground.js, and what goes to it."""

import threading
import traceback
from pathlib import Path

import anywidget
import traitlets

HERE = Path(__file__).parent


class View(anywidget.AnyWidget):
    """What the browser shows; playground.js says what it does with `spec`."""

    _esm = HERE / "playground.js"
    _css = HERE / "playground.css"
    spec = traitlets.Dict().tag(sync=True)
    first = traitlets.Bytes().tag(
        sync=True
    )  # a PNG file: the picture until the kernel answers, and where there is none


class Live:
    """The controls' values and the messages about them; refresh(view=…, n=…) makes a picture and calls `send`.

    Messages come in the main thread or in that of a subshell, as JupyterLab likes; a lock keeps them apart from each
    other and from cells. Every move is answered, so that the browser, which has two under way, sends the next.
    """

    def __init__(self, stage, controls, handles, spec, refresh):
        self.stage, self.controls, self.handles, self.refresh = stage, controls, handles, refresh
        self.lock = threading.RLock()
        self.view = View(spec=spec)
        self.view.on_msg(self._receive)
        self._last = {}  # by view: the number of the last move that was taken
        self._ratios = {}  # by view: device pixels for each pixel of its page; the finest screen decides
        self._epoch = 0  # how often a program has set controls: older moves of the hand do not undo that
        self.watched, self._setting = False, False  # is it shown anywhere? is `put` at work?
        for control in controls.values():
            control.observe(self._changed, "value")

    def values(self):
        return {name: control.value for name, control in self.controls.items()}

    def put(self, values):
        """Give controls new values, which were checked."""
        before, self._setting = self._setting, True
        try:
            for name, value in values.items():
                self.controls[name].value = value
        finally:
            self._setting = before

    def set_by_program(self, values):
        """The same, and then the picture; moves of the hand that were made before do not count any more."""
        with self.lock:
            self.put(values)
            if not self._setting:  # else somebody who observes a control sets another: one picture for both
                self._epoch += 1
                self.refresh()

    def _changed(self, change):
        """A control was given a value directly, or by a link to another widget."""
        with self.lock:
            if not self._setting:
                self._epoch += 1
                self.refresh()

    # -- messages

    def _receive(self, view, content, buffers):
        with self.lock:
            if content.get("kind") == "hello":
                self.watched = True
                self._ratios[content["view"]] = float(content["ratio"])
                self.stage.show_at(max(self._ratios.values()))
                about, still = self.stage.still()
                self.view.send({"kind": "stage", **about}, [still])
                self.refresh(view=content["view"])
            elif content.get("kind") == "move":
                self._move(content)

    def _move(self, content):
        """A move of the hand: newer than the last one of its view, and not older than what a program has set."""
        view, number = content["view"], content["n"]
        if number > self._last.get(view, 0) and content["epoch"] == self._epoch:
            self._last[view] = number
            self.put(self._wanted(content))
        self.refresh(view=view, n=number)

    def _wanted(self, content):
        """The values that a move asks for; those that a control cannot take are left out."""
        start = {name: control.start for name, control in self.controls.items()} if content.get("reset") else {}
        wanted, found = start | content.get("values", {}), {}
        for ask, find in (("drag", "values_at"), ("nudge", "values_beside")):
            if ask in content:
                i, x, y = content[ask]
                wanted |= getattr(self.handles[i], find)(self.stage.fig, self.values(), x, y, self.controls)
        for name, value in wanted.items():
            try:
                found[name] = self.controls[name].checked(value)
            except (KeyError, ValueError):
                continue
        return found

    def places(self):
        """Where the handles are now, for the browser."""
        return [handle.spec(self.stage.fig, self.values(), self.stage.ratio) for handle in self.handles]

    def send(self, status, picture, view="", n=0):
        """The values of now, the sentence and, unless it is None, the picture."""
        if not self.watched:
            return
        about, buffers = picture or ({}, [])
        about |= dict(kind="picture", view=view, n=n, epoch=self._epoch, values=self.values(), status=status)
        self.view.send(about | dict(ratio=self.stage.ratio, handles=self.places()), buffers)


def told(error, function):
    """An exception as a sentence that names the line of the function, or of another in the same cell."""
    file = function.__code__.co_filename if hasattr(function, "__code__") else ""
    lines = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == file]
    where = f" in line {lines[-1].lineno}, {lines[-1].line}," if lines and lines[-1].line else ""
    return f"The picture is the one before: this setting failed{where} with {type(error).__name__}: {error}"
