"""Live pictures: move a slider, see the filter change.

    def draw(fig):                      # once: axes and everything in them; return what will move
        ax = fig.subplots()
        ...
        return estimate(ax, t, mean, std)

    def update(artists, Q, R):          # after every move: new data, and one sentence about what is to be seen
        ...
        artists.set(t, mean, std)
        return f"steady gain {gain:.2f}"

    Playground(draw, update, Q=log_slider(1e-3, 1e3, 1, unit="V²"), R=log_slider(1e-3, 1e3, 1, unit="V²"))

How it is fast: the figure is drawn once, without what moves. After a move only that is drawn, on a copy of the rest,
and the pixels go to the browser as a small PNG with a fixed palette. How it keeps up: when several moves arrive before
the next picture is made, only the last of them is drawn.
"""

import asyncio
import html
import itertools
import re
import threading
import time
import warnings

import ipywidgets as ipw
import numpy as np

from . import plots
from .contents import assert_finite, leaves, moving

QUIET = 0.005  # seconds without a new move, then a picture is made …
PATIENCE = 0.040  # … but never later than this after the first move it has to show


class Playground:
    """A picture with controls, shown by the last line of a cell.

    Parameters
    ----------
    draw : function(fig)
        Called once with an empty figure. It makes axes, everything that stays and everything that moves, and returns
        what moves: an object of `plots`, a matplotlib artist, or any nest of them in lists, tuples, dicts, namespaces.
        Limits it does not fix are fitted to the first picture; then the axes stay as they are.
    update : function(artists, **values)
        Called with what `draw` returned and the value of every control by its name. It sets the new data and returns
        one sentence for the line under the controls, or None. It must not make new artists.
    size : (float, float)
        Width and height of the picture in inches, at 100 dots per inch.
    **controls : log_slider, slider, choice or toggle
        One for each name that `update` takes.

    Attributes
    ----------
    values : dict
        The controls' values now, by name.
    status : str
        The sentence under the controls.
    errors : int
        How often `update` failed since the playground was made.
    last_error : Exception or None

    Examples
    --------
    >>> from kflearn import plots
    >>> from kflearn.ui import Playground, slider
    >>> def draw(fig):
    ...     return plots.truth(fig.subplots(), [0, 1], [0, 1])
    >>> def update(line, slope):
    ...     line.set([0, 1], [0, slope])
    ...     return f"it rises by {slope:g}"
    >>> live = Playground(draw, update, slope=slider(0.0, 2.0, 1.0))
    >>> live.status
    'it rises by 1'
    >>> live.set(slope=2)
    >>> live.values, live.status
    ({'slope': 2.0}, 'it rises by 2')
    """

    def __init__(self, draw, update, *, size=(8, 4.5), **controls):
        self.draw, self.update, self.size = draw, update, size
        self.errors, self.last_error, self.status = 0, None, ""
        self._lock = threading.RLock()  # JupyterLab's messages and the cells run in different threads
        self._asked = self._drawn = 0  # moves so far; moves that the picture shows
        self._oldest = self._finished = 0.0  # when the first move came that it does not show; when it was made
        self.controls = {name: c.attach(name, self._moved, self._lock) for name, c in controls.items()}
        self._stage()
        self._assemble()

    # -- what the reader sees

    def _assemble(self):
        """The widgets: controls and the reset button in a row that wraps, the sentence, the picture."""
        reset = ipw.Button(description="Reset", tooltip="Put every control back to where it started")
        reset.layout = ipw.Layout(width="auto")
        reset.on_click(lambda _: self.reset())
        width = f"{round(100 * self.size[0])}px"
        row = ipw.Layout(flex_flow="row wrap", align_items="center", overflow="visible", max_width=width)
        head = ipw.Box([*(c.widget for c in self.controls.values()), reset], layout=row)
        self._status = ipw.HTML(layout=ipw.Layout(max_width=width))
        self._image = ipw.Image(format="png", layout=ipw.Layout(width=width, max_width="100%", height="auto"))
        self.widget = ipw.VBox([head, self._status, self._image], layout=ipw.Layout(overflow="visible"))
        self._send(self._render())

    def __str__(self):
        return "Playground: " + "; ".join(c.describe() for c in self.controls.values())

    def _repr_mimebundle_(self, **kwargs):
        data = self.widget._repr_mimebundle_(**kwargs) | {"image/png": self.png(), "text/plain": str(self)}
        return data, {"image/png": {"alt": f"{self}. {self.status}"}}

    def gallery(self, *settings, alt=None, size=(9, 3.6)) -> None:
        """Show the picture at several settings side by side, as one static figure: for print and where no kernel runs.

        Parameters
        ----------
        *settings : dict
            Such as dict(Q=0.1). Controls that are not named keep their value.
        alt : str, optional
            The figure in words; made of the sentences of `update` when it is not given.
        size : (float, float)
            Of the whole figure, in inches.
        """
        fig, _ = plots.figure(0, size=size)
        top, bottom = fig.subfigures(2, 1, height_ratios=(12, 1))
        words, entries = [], {}
        for part, setting in zip(top.subfigures(1, len(settings), squeeze=False)[0], settings, strict=True):
            values = self.values | self._checked(setting)
            title = ", ".join(self.controls[name].caption(values[name]) for name in setting)
            with plots.style():
                artists = self.draw(part)
                words.append(f"{title}: {self.update(artists, **values)}")
                plots.fit(moving(artists))
                part.suptitle(title, fontsize=10)
            for ax in part.axes:  # one legend for all of them
                if ax.get_legend():
                    handles, labels = ax.get_legend_handles_labels()
                    entries |= dict(zip(labels, handles, strict=True))
                    ax.get_legend().remove()
        if entries:
            bottom.legend(entries.values(), entries.keys(), loc="center", ncols=6, frameon=False)
        plots.show(fig, alt or re.sub(r"[$\\]", "", ". ".join(words)))

    # -- the controls

    @property
    def values(self) -> dict:
        """The controls' values now, by name."""
        return {name: c.value for name, c in self.controls.items()}

    def set(self, **values) -> None:
        """Set controls by name; the picture is made when this returns.

        Raises
        ------
        ValueError
            For a name that no control has, or a value that the control cannot take.
        """
        with self._lock:
            for name, value in self._checked(values).items():
                self.controls[name].put(value)
            self.refresh()

    def reset(self) -> None:
        """Put every control back to where it started, and make the picture."""
        self.set(**{name: c.start for name, c in self.controls.items()})

    def _checked(self, values):
        """The values as their controls take them; ValueError for a wrong name or value."""
        for name in values:
            if name not in self.controls:
                raise ValueError(f"no control is named {name!r}; this playground has {', '.join(self.controls)}")
        return {name: self.controls[name].checked(value) for name, value in values.items()}

    def _moved(self):
        """A control has a new value. The first move is drawn at once; of those on its heels, the last is."""
        now = time.monotonic()
        if self._drawn == self._asked:
            self._oldest = now
        self._asked += 1
        try:
            loop = asyncio.get_running_loop()
        except RuntimeError:  # no event loop, so nothing would come back to it later
            return self.refresh()
        waited = now - self._finished > QUIET or now - self._oldest > PATIENCE
        loop.call_later(0 if waited else QUIET, self._settle, self._asked, waited)

    def _settle(self, asked, waited):
        """Make the picture for move number `asked`, unless a later move will."""
        if self._drawn < asked and (waited or asked == self._asked):
            self.refresh()

    # -- the picture

    def refresh(self) -> None:
        """Make the picture for the values of now, at once. An exception becomes the sentence under the controls."""
        with self._lock:
            asked = self._asked
            try:
                picture = self._render()
            except Exception as error:
                self.errors, self.last_error = self.errors + 1, error
                self.status = f"The picture is the one before: this setting made a {type(error).__name__}: {error}"
                picture = None
            self._drawn, self._finished = asked, time.monotonic()
            self._send(picture)

    def png(self) -> bytes:
        """The picture as it is now, the bytes of a PNG file."""
        return bytes(self._image.value)

    def _stage(self):
        """Everything that is done once: draw what stays, keep its pixels, list what moves."""
        self._fig, _ = plots.figure(0, size=self.size)
        with plots.style():
            self._artists = self.draw(self._fig)
            self.update(self._artists, **self.values)
        self._moving = moving(self._artists)
        plots.fit(self._moving)
        canvas = self._fig.canvas
        canvas.draw()  # lays out the axes
        self._fig.set_layout_engine("none")
        for ax in self._fig.axes:
            ax.autoscale(False)
        for artist in self._moving:
            artist.set_animated(True)  # left out by the next line
        canvas.draw()
        self._background = canvas.copy_from_bbox(self._fig.bbox)
        legends = [ax.get_legend() for ax in self._fig.axes if ax.get_legend() and ax.get_legend().get_frame_on()]
        self._legends = [canvas.copy_from_bbox(legend.get_window_extent()) for legend in legends]

    def _render(self):
        """Update and draw: the bytes of a PNG file. Exceptions pass through."""
        self.status = str(self.update(self._artists, **self.values) or "")
        canvas = self._fig.canvas
        canvas.restore_region(self._background)
        for artist in self._moving:
            artist.draw(canvas.get_renderer())
        for legend in self._legends:  # nothing moves over them
            canvas.restore_region(legend)
        return plots.encode(np.asarray(canvas.buffer_rgba()), quick=True)

    def _send(self, picture):
        """Picture, numbers and sentence to the browser."""
        if picture:
            self._image.value = picture
        for control in self.controls.values():
            control.show()
        self._status.value = f'<div role="status" aria-live="polite">{html.escape(self.status)}&nbsp;</div>'

    # -- the test

    def sweep(self) -> int:
        """Try both ends and the middle of every control in all combinations. Then everything is as it was before.

        Returns
        -------
        int
            How many settings were tried.

        Raises
        ------
        Exception
            The exception or the warning that a setting makes, with a note that names the setting.
        AssertionError
            For a number that is not finite in anything drawn (masked values are gaps and allowed) or in the sentence.
        """
        with self._lock:
            before, tried = self.values, 0
            try:
                for setting in itertools.product(*(c.ends() for c in self.controls.values())):
                    for control, value in zip(self.controls.values(), setting, strict=True):
                        control.put(value)
                    try:
                        self._try()
                    except Exception as error:
                        error.add_note(f"in the playground at {self.values}")
                        raise
                    tried += 1
            finally:
                self.set(**before)
        return tried

    def _try(self):
        """Draw the setting of now, with warnings as errors, and look at every word and number in it."""
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self._render()
        for thing in [self.status, *leaves(self._artists)]:
            assert_finite(thing)
