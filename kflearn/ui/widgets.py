"""What the controls of a playground are made of: a value that can be observed, and words for it.

A control starts unbound; `attach` returns a copy with its name.
"""

import copy
import math
from numbers import Real

from traitlets import Any, HasTraits, TraitError, validate

from . import labels


class Control(HasTraits):
    """What all controls have in common. A playground uses the methods below.

    Attributes
    ----------
    start : float, int, str or bool
        The value at the beginning.
    value : float, int, str or bool
        The value now, a trait: `observe` and `link` know it.
    """

    value = Any()

    def attach(self, name) -> "Control":
        """A copy that has a name and stands at its start."""
        bound = copy.copy(self)
        bound.name, bound.label = name, self.label or f"${name}$"
        bound.value = bound.start
        return bound

    @validate("value")
    def _valid(self, proposal):
        try:
            return self.checked(proposal["value"])
        except ValueError as error:
            raise TraitError(str(error)) from None

    def caption(self, value) -> str:
        """The label with a value, for a title."""
        return f"{self.label} = {value}"

    def spec(self) -> dict:
        """What playground.js needs to know."""
        words = dict(label=labels.as_html(self.label), plain=labels.plain(self.label))
        return dict(name=self.name, start=self.start, **words)


class Slider(Control):
    """A slider and a box for the exact number; made by `slider` and `log_slider`."""

    def __init__(self, low, high, value, label, unit, log=False, step=None):
        super().__init__()
        self.low, self.high, self.label, self.unit, self.log = low, high, label, unit, log
        whole = not log and all(isinstance(number, int) for number in (low, high, value, 1 if step is None else step))
        self.number = int if whole else float
        self.step = step or (max(1, (high - low) // 100) if whole else (high - low) / 100)
        self.start = self.checked(value)

    def checked(self, value) -> float | int:
        """The value as a number of the slider's kind; ValueError outside its ends."""
        if isinstance(value, Real) and self.low <= value <= self.high:
            return self.number(value)
        raise ValueError(f"a control from {self.low:g} to {self.high:g} cannot be {value!r}")

    def near(self, value) -> float | int:
        """The nearest value that the hand could choose: three digits on a log slider, else a step; within the ends."""
        if self.log:
            value = float(f"{value:.3g}")
        else:
            value = round(self.low + self.step * round((value - self.low) / self.step), 12)
        return self.number(min(max(value, self.low), self.high))

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

    def spec(self) -> dict:
        """What playground.js needs to know; `step` is one of the places of the slider, decades where it is `log`."""
        step = self.step
        if self.log:
            decades = math.log10(self.high / self.low)
            step = 0.05 if decades >= 2 else decades / 100
        about = dict(kind="slider", low=self.low, high=self.high, step=step, log=self.log, unit=self.unit)
        about |= dict(whole=self.number is int, range=self.range(), digits=self._digits())
        return super().spec() | about

    def _digits(self):
        """How many signs the box has room for."""
        places = [1, 2, 3] if self.log else [self.low + self.step * k for k in range(4)]
        return max(len(f"{number:g}") for number in (self.low, self.high, *map(self.number, places)))


class Choice(Control):
    """Buttons of which one is pressed; made by `choice`."""

    def __init__(self, options, value, label):
        super().__init__()
        self.options, self.label = options, label
        self.start = self.checked(options[0] if value is None else value)

    def checked(self, value) -> str | bool:
        """The value itself; ValueError if it is not one of the options."""
        if value in self.options:
            return value
        raise ValueError(f"a choice of {', '.join(map(str, self.options))} cannot be {value!r}")

    def ends(self) -> tuple:
        """All options."""
        return tuple(self.options)

    def describe(self) -> str:
        """Its name and its options, for those who see no buttons."""
        return f"{self.name}: {', '.join(map(str, self.options))}"

    def spec(self) -> dict:
        """What playground.js needs to know."""
        return super().spec() | dict(kind="choice", options=self.options)


class Toggle(Choice):
    """A check box; made by `toggle`."""

    def __init__(self, value, label):
        super().__init__([False, True], value, label)

    def checked(self, value) -> bool:
        """The value as True or False; ValueError if it is neither."""
        return bool(super().checked(value))

    def caption(self, value) -> str:
        """The label with "on" or "off", for a title."""
        return f"{self.label} {'on' if value else 'off'}"

    def describe(self) -> str:
        """Its name and what it can be, for those who see no check box."""
        return f"{self.name}: on or off"

    def spec(self) -> dict:
        """What playground.js needs to know."""
        return super().spec() | dict(kind="toggle")
