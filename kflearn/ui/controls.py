"""The controls of a playground: sliders with a box for the exact number, named steps, switches."""

from .handles import drag, drag_bell
from .widgets import Choice, Slider, Toggle

__all__ = ["Choice", "Slider", "Toggle", "choice", "drag", "drag_bell", "log_slider", "slider", "toggle"]


def log_slider(low, high, value, label=None, unit="") -> Slider:
    """A slider over decades, which gives three significant digits; the box beside it takes any number.

    Parameters
    ----------
    low, high : float
        Its ends, 0 < low < high.
    value : float
        Where it starts.
    label : str, optional
        The words at its left, with LaTeX between $ … $; the control's name when not given.
    unit : str
        The unit of its numbers, such as "V²".

    Returns
    -------
    Slider
        To be given to a `Playground` by name.

    Raises
    ------
    ValueError
        Where low, high and value are not in this order.

    Examples
    --------
    >>> from kflearn.ui import log_slider
    >>> log_slider(0.001, 1000, 1, unit="V²").ends()
    (0.001, 1.0, 1000.0)
    """
    if not 0 < low < high:
        raise ValueError(f"a log_slider needs 0 < low < high, found low = {low}, high = {high}")
    return Slider(low, high, value, label, unit, log=True)


def slider(low, high, value, label=None, unit="", step=None) -> Slider:
    """A slider with equal steps. It gives whole numbers when low, high, value and step are ints.

    Parameters
    ----------
    low, high : float or int
        Its ends, low < high.
    value : float or int
        Where it starts.
    label, unit : str
        As in `log_slider`.
    step : float or int, optional
        A hundredth of its length when not given, for whole numbers 1 at least.

    Returns
    -------
    Slider
        To be given to a `Playground` by name.

    Raises
    ------
    ValueError
        Where low is not below high, or value is not between them.

    Examples
    --------
    >>> from kflearn.ui import slider
    >>> slider(1, 50, 10).ends(), slider(0.0, 2.0, 0.5).ends()
    ((1, 25, 50), (0.0, 1.0, 2.0))
    """
    if not low < high:
        raise ValueError(f"a slider needs low < high, found low = {low}, high = {high}")
    return Slider(low, high, value, label, unit, step=step)


def choice(options, value=None, label=None) -> Choice:
    """Buttons of which one is pressed.

    Parameters
    ----------
    options : sequence of str
        The words on the buttons.
    value : str, optional
        The one that is pressed at first; the first of them when not given.
    label : str, optional
        As in `log_slider`.

    Returns
    -------
    Choice
        To be given to a `Playground` by name.

    Raises
    ------
    ValueError
        Where value is not one of the options.

    Examples
    --------
    >>> from kflearn.ui import choice
    >>> choice(["predict", "measure", "correct"]).start
    'predict'
    """
    return Choice(list(options), value, label)


def toggle(value=False, label=None) -> Toggle:
    """A check box: True or False.

    Parameters
    ----------
    value : bool
        Whether it is ticked at first.
    label : str, optional
        As in `log_slider`.

    Returns
    -------
    Toggle
        To be given to a `Playground` by name.

    Examples
    --------
    >>> from kflearn.ui import toggle
    >>> toggle(True, label="show the band").start
    True
    """
    return Toggle(bool(value), label)
