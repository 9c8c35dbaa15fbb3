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

How it is fast: the figure is drawn once, without what moves (`stage`). After a move only that is drawn, not as pixels
but as a few thousand numbers (`recorder`), which the browser draws on top of the rest (`playground.js`), as sharp as
its screen. How it keeps up: the browser has at most two moves under way (`live`).
"""

import itertools
import re
import warnings
from functools import partial

from . import plots
from .contents import assert_finite, leaves, moving
from .live import Live, told
from .stage import DPI, Stage


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
    handles : sequence of Handle
        What one can take hold of in the picture, made by `drag` and `drag_bell`.
    **controls : log_slider, slider, choice or toggle
        One for each name that `update` takes.

    Attributes
    ----------
    controls : dict
        By name; the `value` of each is a trait that `observe` and `link` know.
    values : dict
        The controls' values now, by name.
    widget : ipywidgets widget
        What is shown, for layouts of your own.
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

    def __init__(self, draw, update, *, size=(8, 4.5), handles=(), **controls):
        self.draw, self.update, self.size = draw, update, size
        self.errors, self.last_error, self.status = 0, None, ""
        self.controls = {name: control.attach(name) for name, control in controls.items()}
        self._stage = Stage(draw, partial(update, **self.values), size)
        spec = dict(size=[round(DPI * side) for side in size], text=str(self))
        spec["controls"] = [control.spec() for control in self.controls.values()]
        spec["handles"] = [handle.check(self.controls) for handle in handles]
        self._live = Live(self._stage, self.controls, handles, spec, self.refresh)
        self.widget = self._live.view
        self._good = self.values  # those of the last picture
        self.status = self._update()

    # -- what the reader sees

    def __str__(self):
        return "Playground: " + "; ".join(c.describe() for c in self.controls.values())

    def _repr_mimebundle_(self, **kwargs):
        self.widget.first = self.png()
        data = self.widget._repr_mimebundle_(**kwargs)
        data, about = data if isinstance(data, tuple) else (data, {})
        data = data | {"image/png": self.widget.first, "text/plain": str(self)}
        return data, about | {"image/png": {"alt": f"{self}. {self.status}"}}

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
                    named = zip(*ax.get_legend_handles_labels(), strict=True)
                    entries |= {(label, type(drawn)): drawn for drawn, label in named}
                    ax.get_legend().remove()
        if entries:
            names = [label for label, _ in entries]  # a line and an area may have one name
            tight = dict(columnspacing=0.9, handlelength=1.8) if len(names) > 7 else {}
            bottom.legend(entries.values(), names, loc="center", ncols=8, frameon=False, **tight)
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
        self._live.set_by_program(self._checked(values))

    def reset(self) -> None:
        """Put every control back to where it started, and make the picture."""
        self.set(**{name: c.start for name, c in self.controls.items()})

    def _checked(self, values):
        """The values as their controls take them; ValueError for a wrong name or value."""
        for name in values:
            if name not in self.controls:
                raise ValueError(f"no control is named {name!r}; this playground has {', '.join(self.controls)}")
        return {name: self.controls[name].checked(value) for name, value in values.items()}

    # -- the picture

    def refresh(self, **to) -> None:
        """Make the picture for the values of now, at once. An exception becomes the sentence under the controls."""
        with self._live.lock:
            picture = None
            try:
                self.status = self._update()
                picture = self._stage.record() if self._live.watched else None
                self._good = self.values
            except Exception as error:
                self.errors, self.last_error = self.errors + 1, error
                self.status = told(error, self.update)
            self._live.send(self.status, picture, **to)

    def png(self) -> bytes:
        """The picture as it is now, the bytes of a PNG file."""
        with self._live.lock:
            if self._good != self.values:  # the last update failed, perhaps half-way
                self.update(self._stage.artists, **self._good)
            return self._stage.png()

    def _update(self):
        """Let `update` move the artists; returns its sentence. Exceptions pass through."""
        return str(self.update(self._stage.artists, **self.values) or "")

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
        with self._live.lock:
            before, tried = self.values, 0
            try:
                for setting in itertools.product(*(c.ends() for c in self.controls.values())):
                    self._live.put(dict(zip(self.controls, setting, strict=True)))
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
            self.status = self._update()
            self._stage.record()
            self._live.places()
        for thing in [self.status, *leaves(self._stage.artists)]:
            assert_finite(thing)
