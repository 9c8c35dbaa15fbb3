"""What one can take hold of in a playground's picture: points and lines whose places are values of sliders."""

import numpy as np

from .widgets import Slider

POINT, LINE = 30, 18  # pixels of the page: how large a point is, and how thick a line, for a hand


class Handle:
    """Made by `drag`; a playground calls the methods below."""

    def __init__(self, x, y, axes, at, label):
        self.x, self.y, self.axes, self.at, self.label = x, y, axes, at, label

    def check(self, controls) -> list[str]:
        """The names of the sliders that it moves; ValueError where there is none of that name."""
        names = [part for part in (self.x, self.y) if isinstance(part, str)]
        pairs = [part for part in (self.x, self.y) if part is not None and not isinstance(part, str)]
        names += [name for _, _, *some in pairs for name in some]
        for name in names:
            if not isinstance(controls.get(name), Slider):
                raise ValueError(f"drag needs the name of a slider, got {name!r}")
        return names

    def place(self, values) -> tuple[float | None, float | None]:
        """Where it is in the axes; None along the axis in which it is a line."""
        return self._along(self.x, values), self._along(self.y, values)

    def _along(self, part, values):
        if part is None:
            return None if self.at is None else self.at(**values)
        return values[part] if isinstance(part, str) else part[0](**values)

    def spec(self, fig, values, ratio) -> dict:
        """Its place and its area in device pixels from the top, the way it goes, and words."""
        ax, (x, y) = fig.axes[self.axes], self.place(values)
        start = ax.get_xlim()[0] if x is None else x, ax.get_ylim()[0] if y is None else y
        px, py = (float(side) for side in ax.transData.transform(start))
        half = (LINE if x is None or y is None else POINT) * ratio / 2
        px, left, right = _held(px, half, ax.bbox.x0, ax.bbox.x1, whole=x is None)
        py, low, high = _held(py, half, ax.bbox.y0, ax.bbox.y1, whole=y is None)
        way = "x" if self.y is None else "y" if self.x is None else "xy"
        at, area = [px, fig.bbox.height - py], [left, fig.bbox.height - high, right - left, high - low]
        return dict(at=at, area=area, along=way, words=self._words(values))

    def _words(self, values):
        names = [part for part in (self.x, self.y) if isinstance(part, str)]
        told = ", ".join(f"{name} {values[name]:g}" for name in names)
        return f"{self.label or 'drag'}{': ' if told else ''}{told}; arrow keys move it"

    def values_at(self, fig, values, x, y, controls) -> dict:
        """The values of its sliders, were it at a place in device pixels from the top."""
        ax = fig.axes[self.axes]
        inside = ax.transData.inverted().transform([[x, fig.bbox.height - y]])[0]
        found = {}
        for part, coordinate in zip((self.x, self.y), inside, strict=True):
            if isinstance(part, str):
                found[part] = float(coordinate)
            elif part is not None:
                found |= part[1](float(coordinate), **values)
        return {name: controls[name].near(value) for name, value in found.items() if np.isfinite(value)}

    def values_beside(self, fig, values, right, down, controls) -> dict:
        """The values a few hundredths of the axes further on: as many as asked, more where nothing would change."""
        (x, y), box = self.spec(fig, values, 1)["at"], fig.axes[self.axes].bbox
        for times in (1, 2, 4, 8, 16):
            at = x + times * right * box.width / 100, y + times * down * box.height / 100
            found = self.values_at(fig, values, *at, controls)
            if any(found[name] != values[name] for name in found):
                break
        return found


def _held(place, half, low, high, whole):
    """A place kept inside the axes, and both ends of the area around it: the whole side of the axes for a line."""
    place = min(max(place, low), high)
    return (place, low, high) if whole else (place, place - half, place + half)


def drag(x=None, y=None, *, axes=0, at=None, label="") -> Handle:
    """Something in the picture that the reader can take hold of; the sliders follow, and it follows the sliders.

    With x alone it is an upright line that goes left and right, with y alone a level line that goes up and down, with
    both a point.

    Parameters
    ----------
    x, y : str or (function, function, str …), optional
        The name of the slider whose value is this coordinate; or a function where(**values) that returns the
        coordinate, a function back(coordinate, **values) that returns a dict of new values by name, and the names of
        the sliders that it moves.
    axes : int
        In which of the figure's axes it is, counted from 0 in the order in which `draw` made them.
    at : function(**values), optional
        Makes a point of a line: returns the other coordinate, along which the hand does nothing.
    label : str
        What it is, for those who hear it: "the measurement".

    Returns
    -------
    Handle
        For `Playground(draw, update, handles=[drag(…)], …)`.

    Raises
    ------
    ValueError
        Where neither x nor y is given; later, by the playground, where a name is no slider's.

    Examples
    --------
    >>> from kflearn.ui import drag
    >>> drag(x="mean", label="the top of the bell").place(dict(mean=3, sigma=1))
    (3, None)
    """
    if x is None and y is None:
        raise ValueError("drag needs x, y or both: the names of sliders")
    return Handle(x, y, axes, at, label)
