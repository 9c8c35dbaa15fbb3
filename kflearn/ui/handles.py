"""What one can take hold of in a playground's picture: points and lines whose places are values of sliders."""

import inspect
from functools import lru_cache

import numpy as np

from .labels import plain
from .widgets import Slider

POINT, LINE = 32, 20  # pixels of the page: how large a point is, and how thick a line, for a hand


class Handle:
    """Made by `drag`; a playground calls the methods below."""

    def __init__(self, x, y, axes, at, when, label):
        self.parts, self.axes, self.at, self.when = (x, y), axes, at, when
        self.label, self.controls = label or "handle", {}

    def check(self, controls) -> list[str]:
        """The names of the sliders that it moves; ValueError where there is none of that name."""
        names = [_name(part) for part in self.parts if part is not None]
        for name in names:
            if not isinstance(controls.get(name), Slider):
                raise ValueError(f"drag needs the name of a slider, got {name!r}")
        for name in self._asked():
            if name not in {*controls, "x", "y", "**"}:
                raise ValueError(f"a function of drag takes {name!r}, but no control is named so")
        self.controls = {name: controls[name] for name in names}
        return names

    def _asked(self):
        """The values that its functions take."""
        pairs = [part for part in self.parts if isinstance(part, tuple)]
        names = [name for _, there, back in pairs for name in _parameters(there) + _parameters(back)[1:]]
        others = [function for function in (self.at, self.when) if callable(function)]
        return names + [name for function in others for name in _parameters(function)]

    def place(self, values) -> tuple[float | None, float | None]:
        """Where it is in the axes; None along the axis in which it is a line."""
        return tuple(self._along(part, values) for part in self.parts)

    def _along(self, part, values):
        if part is None:
            return _call(self.at, values) if callable(self.at) else self.at
        return values[part] if isinstance(part, str) else _call(part[1], values)

    def spec(self, fig, values, ratio) -> dict:
        """Its place and its area in device pixels from the top, the way it goes, whether it is a line, and words."""
        ax, place = fig.axes[self.axes], self.place(values)
        line = None in place
        if not _call(self.when, values) or not all(np.isfinite(side) for side in place if side is not None):
            return dict(hidden=True)
        half = (LINE if line else POINT) * ratio / 2
        px, left, right = _held(ax, 0, place, half)
        py, low, high = _held(ax, 1, place, half)
        at, area = [px, fig.bbox.height - py], [left, fig.bbox.height - high, right - left, high - low]
        return dict(at=at, area=area, along=self._way(), line=line, words=self._words(values))

    def _way(self):
        """Along which axes the hand does something."""
        used = "".join(side for side, part in zip("xy", self.parts, strict=True) if part is not None)
        asked = [_parameters(part[2])[1:] for part in self.parts if isinstance(part, tuple)]
        return "xy" if any(side in names for names in asked for side in "xy") else used

    def _words(self, values):
        units = [(name, control.unit) for name, control in self.controls.items()]
        told = ", ".join(f"{plain(self.controls[n].label)} {values[n]:g} {unit}".rstrip() for n, unit in units)
        return f"{self.label}: {told}; arrow keys move it"

    def values_at(self, fig, values, x, y, controls) -> dict:
        """The values of its sliders, were it at a place in device pixels from the top."""
        ax = fig.axes[self.axes]
        inside = ax.transData.inverted().transform([[x, fig.bbox.height - y]])[0]
        place, found = dict(zip("xy", map(float, inside), strict=True)), {}
        for part, coordinate in zip(self.parts, place.values(), strict=True):
            if isinstance(part, str):
                found[part] = coordinate
            elif part is not None:
                found[part[0]] = _call(part[2], values, coordinate, **place)
        return {name: controls[name].near(value) for name, value in found.items() if np.isfinite(value)}

    def values_beside(self, fig, values, right, down, controls) -> dict:
        """The values a hundredth of the axes further on, or as many hundredths as it takes to change them."""
        box, found = fig.axes[self.axes].bbox, {}
        x, y = self.spec(fig, values, 1).get("at", (np.nan, np.nan))
        for times in (1, 2, 4, 8, 16):
            at = x + times * right * box.width / 100, y + times * down * box.height / 100
            found = self.values_at(fig, values, *at, controls)
            if any(found[name] != values[name] for name in found):
                break
        return found


def _name(part):
    """The slider of a coordinate."""
    return part if isinstance(part, str) else part[0]


def _held(ax, side, place, half):
    """A coordinate in pixels, kept inside the axes, and both ends of the area around it: the axes' own for a line."""
    low, high = ax.bbox.intervalx if side == 0 else ax.bbox.intervaly
    if place[side] is None:
        return (low + high) / 2, low, high
    start = [limits[0] if value is None else value for value, limits in zip(place, _limits(ax), strict=True)]
    here = min(max(float(ax.transData.transform(start)[side]), low), high)
    return here, here - half, here + half


def _limits(ax):
    return ax.get_xlim(), ax.get_ylim()


def _call(function, values, *first, **place):
    """Call a function with some arguments, and with those values, and coordinates, whose names it has."""
    names, known = _parameters(function)[len(first) :], values | place
    return function(*first, **(values if "**" in names else {name: known[name] for name in names}))


@lru_cache(maxsize=256)
def _parameters(function):
    """The names of a function's parameters, but for those that need no value; "**" for one that takes all names."""
    given = inspect.signature(function).parameters.values()
    return ["**" if each.kind is each.VAR_KEYWORD else each.name for each in given if each.default is each.empty]


def drag(x=None, y=None, *, axes=0, at=None, when=lambda: True, label="") -> Handle:
    """Something in the picture that the reader can take hold of; the sliders follow, and it follows the sliders.

    With x alone it is an upright line that goes left and right, with y alone a level line that goes up and down, with
    both a point. A function below gets the values of those controls whose names it has as parameters.

    Parameters
    ----------
    x, y : str or (str, function, function), optional
        The name of the slider whose value is this coordinate. Where it is not the value itself: the name, a function
        that returns the coordinate, and a function that takes a coordinate first and returns the slider's value; its
        further parameters may be x or y, the other coordinate, for a thing that moves along a curve.
    axes : int
        In which of the figure's axes it is, counted from 0 in the order in which `draw` made them.
    at : float or function, optional
        Makes a point of a line: the other coordinate, along which the hand does nothing.
    when : function, optional
        Whether there is something to take hold of; always when not given.
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
    >>> drag(x="mean", label="the middle").place(dict(mean=3, sigma=1))
    (3, None)
    >>> behind = drag(x=("lag", lambda now, lag: now - lag, lambda x, now: now - x), at=0)
    >>> behind.place(dict(now=5, lag=2))
    (3, 0)
    """
    if x is None and y is None:
        raise ValueError("drag needs x, y or both: the names of sliders")
    return Handle(x, y, axes, at, when, label)


def drag_bell(mean, sigma, *, variance=False, height=None, axes=0, when=lambda: True, label="the bell") -> list[Handle]:
    """A Gaussian bell as two handles: its top, which moves the mean, and a point of its right flank, mean + σ.

    Parameters
    ----------
    mean : str or float
        The name of a slider; or a number where the bell does not move, which then has no handle at its top.
    sigma : str
        The name of the slider for σ.
    variance : bool
        Whether that slider gives σ² instead.
    height : float, optional
        How high it is drawn; 1/(σ√2π), as a density, when not given.
    axes, when, label
        As in `drag`.

    Returns
    -------
    list of Handle
        For `Playground(draw, update, handles=drag_bell(…), …)`; those of two bells are added with `+`.

    Examples
    --------
    >>> from kflearn.ui import drag_bell
    >>> [handle.place(dict(mean=3, sigma=2))[0] for handle in drag_bell("mean", "sigma")]
    [3, 5]
    """

    def middle(values):
        return values[mean] if isinstance(mean, str) else mean

    def spread(values):
        return values[sigma] ** 0.5 if variance else values[sigma]

    def top(share=1.0):
        return lambda **v: share * (height or 1 / (spread(v) * np.sqrt(2 * np.pi)))

    def back(x, **v):
        return max(x - middle(v), 0) ** (2 if variance else 1)

    edge = (sigma, lambda **v: middle(v) + spread(v), back)
    flank = drag(x=edge, at=top(np.exp(-0.5)), axes=axes, when=when, label=f"the width of {label}")
    if not isinstance(mean, str):
        return [flank]
    return [drag(x=mean, at=top(), axes=axes, when=when, label=f"the top of {label}"), flank]
