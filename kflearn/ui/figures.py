"""New figures in the course's style, made without pyplot."""

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from .looks import style


def figure(rows=1, columns=1, size=(8, 4.5), **subplots_kw) -> tuple:
    """Make a new figure in the course's style, and its axes.

    Parameters
    ----------
    rows, columns : int
        How many axes. With rows=0 the figure comes without axes.
    size : (float, float)
        Width and height in inches, at 100 dots per inch.
    **subplots_kw
        Passed to `Figure.subplots`, for instance sharex=True or height_ratios=(2, 1).

    Returns
    -------
    fig : matplotlib Figure
    axes : Axes, array of Axes or None
        One Axes, or an array of them as `Figure.subplots` gives it; None when rows=0.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, (above, below) = plots.figure(2, sharex=True, size=(6, 4))
    >>> fig.get_size_inches().tolist()
    [6.0, 4.0]
    """
    with style():
        fig = Figure(figsize=size)
        FigureCanvasAgg(fig)
        axes = fig.subplots(rows, columns, **subplots_kw) if rows else None
    return fig, axes
