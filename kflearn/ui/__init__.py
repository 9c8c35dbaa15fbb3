"""What is shown: pictures, controls and the playground.

    from kflearn.ui import Playground, log_slider, slider

`plots` draws, `Playground` makes a drawing live, `choice`, `log_slider`, `slider` and `toggle` are its controls, and
`drag` and `drag_bell` let the reader take hold of the picture.
"""

from importlib import import_module

__all__ = ["Playground", "choice", "drag", "drag_bell", "log_slider", "plots", "slider", "toggle"]


def __dir__() -> list[str]:
    return __all__


def __getattr__(name):
    """Each name is loaded when it is first asked for: `plots` alone needs no ipywidgets."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name == "plots":
        return import_module(".plots", __name__)
    home = import_module(".playground" if name == "Playground" else ".controls", __name__)
    return getattr(home, name)
