"""What the controls of a playground are made of: a value, its widgets, and words for them.

A control starts unbound; `attach` returns a copy with its name, its playground's lock and its widgets.
"""

import copy
import math
import re

import ipywidgets as ipw


class Control:
    """What all controls have in common. A playground uses the methods below.

    Attributes
    ----------
    start : float, int, str or bool
        The value at the beginning.
    value : float, int, str or bool
        The value now; after `attach` only.
    widget : ipywidgets widget
        What is shown; after `attach` only.
    """

    def attach(self, name, moved, lock) -> "Control":
        """A copy with widgets.

        Parameters
        ----------
        name : str
            The control's name in its playground.
        moved : function()
            Called after the reader has changed the value.
        lock : threading.RLock
            Held while the value changes.
        """
        bound = copy.copy(self)
        bound.name, bound.moved, bound.lock = name, moved, lock
        bound.value = bound.start
        bound.label = bound.label or f"${name}$"
        bound.build()
        return bound

    def take(self, value) -> None:
        """Put this value, chosen by the reader, and tell the playground if it is a new one."""
        with self.lock:
            if value != self.value:
                self.put(value)
                self.moved()

    def caption(self, value) -> str:
        """The label with a value, for a title."""
        return f"{self.label} = {value}"


class Slider(Control):
    """A slider and a box for the exact number; made by `slider` and `log_slider`."""

    def __init__(self, low, high, value, label, unit, log=False, step=None):
        self.low, self.high, self.label, self.unit, self.log = low, high, label, unit, log
        whole = not log and all(isinstance(number, int) for number in (low, high, value, 1 if step is None else step))
        self.number = int if whole else float
        self.step = step or (max(1, (high - low) // 100) if whole else (high - low) / 100)
        self.start = self.checked(value)

    def checked(self, value) -> float | int:
        """The value as a number of the slider's kind; ValueError outside its ends."""
        if not isinstance(value, str) and self.low <= value <= self.high:
            return self.number(value)
        raise ValueError(f"a control from {self.low:g} to {self.high:g} cannot be {value!r}")

    def build(self) -> None:
        """Make the widgets: the box, its unit and the slider."""
        name = re.sub(r"[$\\{}]", "", self.label)
        tip = f"{name} {self.range()}"
        self.box = ipw.BoundedFloatText(
            self.value, min=self.low, max=self.high, description=self.label, tooltip=tip,
            style={"description_width": "initial"},
            layout=ipw.Layout(width="auto", max_width=f"{max(10, 6.5 + 0.6 * len(name)):.3g}em"),
        )  # fmt: skip
        look = dict(readout=False, layout=ipw.Layout(width="auto", min_width="8em", flex="1 1 8em"))
        if self.log:
            low, high = math.log10(self.low), math.log10(self.high)
            step = 0.05 if high - low >= 2 else (high - low) / 100
            self.slider = ipw.FloatLogSlider(self.value, min=low, max=high, step=step, **look)
        else:
            self.slider = ipw.FloatSlider(self.value, min=self.low, max=self.high, step=self.step, **look)
        self.slider.tooltip = tip
        self.box.observe(self._typed, "value")
        self.slider.observe(self._dragged, "value")
        unit = ipw.HTML(self.unit)
        self.widget = ipw.HBox([self.box, unit, self.slider])
        self.widget.layout = ipw.Layout(flex="1 1 22em", max_width="40em", align_items="center", overflow="visible")

    def _typed(self, change):
        """A number was typed. Where only whole ones count, the box shows the one that it is taken for."""
        self.box.value = number = self.number(change["new"])
        self.take(number)

    def _dragged(self, change):
        """The slider has moved; not a new value when the browser has only put it on the nearest of its steps."""
        if abs(self._place(change["new"]) - self._place(self.value)) > 0.51 * self.slider.step:
            value = float(f"{change['new']:.3g}") if self.log else round(change["new"], 12)
            self.take(self.number(min(max(value, self.low), self.high)))

    def _place(self, value):
        """Where a value is on the slider, in the unit of its step."""
        return math.log10(value) if self.log else value

    def put(self, value) -> None:
        """Set the value, and the slider where it stands elsewhere; the box follows with `show`."""
        self.value = value
        if abs(self._place(self.slider.value) - self._place(value)) > 0.51 * self.slider.step:
            self.slider.value = value

    def show(self) -> None:
        """Let the box show the value, once the picture does."""
        self.box.value = self.value

    def ends(self) -> tuple:
        """Both ends and the middle between them."""
        middle = math.sqrt(self.low * self.high) if self.log else (self.low + self.high) / 2
        return self.number(self.low), self.number(middle), self.number(self.high)

    def caption(self, value) -> str:
        """The label with a value and its unit, for a title."""
        return f"{self.label} = {value:g} {self.unit}".rstrip()

    def range(self) -> str:
        """Its ends in words."""
        return f"from {self.low:g} to {self.high:g} {self.unit}".rstrip()

    def describe(self) -> str:
        """Its name and its ends, for those who see no slider."""
        return f"{self.name} {self.range()}"


class Choice(Control):
    """Buttons of which one is pressed; made by `choice`."""

    def __init__(self, options, value, label):
        self.options, self.label = options, label
        self.start = self.checked(options[0] if value is None else value)

    def checked(self, value) -> str | bool:
        """The value itself; ValueError if it is not one of the options."""
        if value in self.options:
            return value
        raise ValueError(f"a choice of {', '.join(map(str, self.options))} cannot be {value!r}")

    def build(self) -> None:
        """Make the widgets: the label and the buttons."""
        self.buttons = ipw.ToggleButtons(options=self.options, value=self.value, style={"button_width": "auto"})
        self.widget = ipw.HBox([ipw.Label(self.label), self.buttons], layout=ipw.Layout(overflow="visible"))
        self.buttons.observe(lambda change: self.take(change["new"]), "value")

    def put(self, value) -> None:
        """Set the value and press its button."""
        self.value = self.buttons.value = value

    def show(self) -> None:
        """Nothing is left to do: the buttons show the value already."""

    def ends(self) -> tuple:
        """All options."""
        return tuple(self.options)

    def describe(self) -> str:
        """Its name and its options, for those who see no buttons."""
        return f"{self.name}: {', '.join(map(str, self.options))}"


class Toggle(Choice):
    """A check box; made by `toggle`."""

    def __init__(self, value, label):
        super().__init__([False, True], value, label)

    def build(self) -> None:
        """Make the widget: a check box with its label."""
        layout = ipw.Layout(width="auto")
        self.widget = self.buttons = ipw.Checkbox(self.value, description=self.label, indent=False, layout=layout)
        self.buttons.observe(lambda change: self.take(change["new"]), "value")

    def caption(self, value) -> str:
        """The label with "on" or "off", for a title."""
        return f"{self.label} {'on' if value else 'off'}"

    def describe(self) -> str:
        """Its name and what it can be, for those who see no check box."""
        return f"{self.name}: on or off"
