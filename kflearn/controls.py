"""The controls of a playground: sliders with a box for the exact number, named steps, switches.

What a control is stands here without its name and its playground; both come with `attach`, which makes the widgets.
"""

import copy
import math
import re

import ipywidgets as ipw


def log_slider(low, high, value, label=None, unit=""):
    """A slider over decades, 0 < low < high, which gives 3 significant digits; the box beside it takes any number.

    label : at its left, LaTeX between $ … $ (the control's name when not given); unit : of the numbers, such as "V²"
    """
    if not 0 < low < high:
        raise ValueError(f"a log_slider needs 0 < low < high, found low = {low}, high = {high}")
    return Slider(low, high, value, label, unit, log=True)


def slider(low, high, value, label=None, unit="", step=None):
    """A slider, low < high, in steps of `step` (a hundredth of its length when not given). It gives whole numbers when
    low, high, value and step are ints."""
    if not low < high:
        raise ValueError(f"a slider needs low < high, found low = {low}, high = {high}")
    return Slider(low, high, value, label, unit, step=step)


def choice(options, value=None, label=None):
    """Buttons of which one is pressed; options: words, value: the one pressed at first (the first if not given)."""
    return Choice(list(options), value, label)


def toggle(value=False, label=None):
    """A check box: True or False."""
    return Toggle(bool(value), label)


class Control:
    """`.value` now, `.start` at the beginning, `.widget` to show. A playground uses the methods below."""

    def attach(self, name, moved, lock):
        """A copy with widgets; `moved()` is called after the reader has changed its value; the lock guards it."""
        self = copy.copy(self)
        self.name, self.moved, self.lock = name, moved, lock
        self.value = self.start
        self.label = self.label or f"${name}$"
        self.build()
        return self

    def take(self, value):
        """The reader has chosen this value."""
        with self.lock:
            if value != self.value:
                self.put(value)
                self.moved()

    def caption(self, value):
        return f"{self.label} = {value}"


class Slider(Control):
    def __init__(self, low, high, value, label, unit, log=False, step=None):
        self.low, self.high, self.label, self.unit, self.log = low, high, label, unit, log
        whole = not log and all(isinstance(number, int) for number in (low, high, value, 1 if step is None else step))
        self.number = int if whole else float
        self.step = step or (max(1, (high - low) // 100) if whole else (high - low) / 100)
        self.start = self.checked(value)

    def checked(self, value):
        if not isinstance(value, str) and self.low <= value <= self.high:
            return self.number(value)
        raise ValueError(f"a control from {self.low:g} to {self.high:g} cannot be {value!r}")

    def build(self):
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

    def put(self, value):
        self.value = value
        if abs(self._place(self.slider.value) - self._place(value)) > 0.51 * self.slider.step:
            self.slider.value = value

    def show(self):
        self.box.value = self.value

    def ends(self):
        middle = math.sqrt(self.low * self.high) if self.log else (self.low + self.high) / 2
        return self.number(self.low), self.number(middle), self.number(self.high)

    def caption(self, value):
        return f"{self.label} = {value:g} {self.unit}".rstrip()

    def range(self):
        return f"from {self.low:g} to {self.high:g} {self.unit}".rstrip()

    def describe(self):
        return f"{self.name} {self.range()}"


class Choice(Control):
    def __init__(self, options, value, label):
        self.options, self.label = options, label
        self.start = self.checked(options[0] if value is None else value)

    def checked(self, value):
        if value in self.options:
            return value
        raise ValueError(f"a choice of {', '.join(map(str, self.options))} cannot be {value!r}")

    def build(self):
        self.buttons = ipw.ToggleButtons(options=self.options, value=self.value, style={"button_width": "auto"})
        self.widget = ipw.HBox([ipw.Label(self.label), self.buttons], layout=ipw.Layout(overflow="visible"))
        self.buttons.observe(lambda change: self.take(change["new"]), "value")

    def put(self, value):
        self.value = self.buttons.value = value

    def show(self):
        pass

    def ends(self):
        return tuple(self.options)

    def describe(self):
        return f"{self.name}: {', '.join(map(str, self.options))}"


class Toggle(Choice):
    def __init__(self, value, label):
        super().__init__([False, True], value, label)

    def build(self):
        layout = ipw.Layout(width="auto")
        self.widget = self.buttons = ipw.Checkbox(self.value, description=self.label, indent=False, layout=layout)
        self.buttons.observe(lambda change: self.take(change["new"]), "value")

    def caption(self, value):
        return f"{self.label} {'on' if value else 'off'}"

    def describe(self):
        return f"{self.name}: on or off"
