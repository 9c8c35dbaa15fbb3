"""One visual vocabulary for every figure of the course.

The same thing looks the same everywhere, and never by its colour alone:

    truth         black, thin solid line
    measurement   grey dots
    prediction    orange, dashed line with triangles
    estimate      blue, thick solid line with a band of ±2 standard deviations
    gain          green, dash-dotted line with diamonds
    outlier       vermilion crosses

Each function draws one of them on matplotlib axes and returns it as an object with a `set` method, so that a live
picture is changed in place: `line = estimate(ax, t, mean, std)`, later `line.set(t, mean, std)`. Figures are made
without pyplot: nothing is registered, nothing has to be closed, and `show(fig, alt)` puts a figure into the notebook
with words for those who cannot see it.

    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> dots = plots.measurements(ax, [0, 1, 2], [0.2, 0.9, 2.1])
    >>> line = plots.estimate(ax, [0, 1, 2], [0.1, 1.0, 2.0], [0.3, 0.2, 0.2])
    >>> [text.get_text() for text in ax.legend().get_texts()]
    ['measurement', '±2σ', 'estimate']
"""

from .drawn import Density, Drawn, Estimate, Innovations, Line, fit
from .figures import figure
from .looks import colours, style
from .pictures import display_png, encode, pixels, png, show
from .step import step_diagram

__all__ = [
    "Density",
    "Drawn",
    "Estimate",
    "Innovations",
    "Line",
    "colours",
    "density",
    "display_png",
    "encode",
    "estimate",
    "figure",
    "fit",
    "gain",
    "innovations",
    "measurements",
    "outliers",
    "pixels",
    "png",
    "prediction",
    "show",
    "step_diagram",
    "style",
    "truth",
]


def __dir__() -> list[str]:
    return __all__


# ---- the vocabulary


def truth(ax, t, x, label="truth", **look) -> Line:
    """Draw the true state: a thin black line.

    Parameters
    ----------
    ax : matplotlib Axes
    t, x : array (T,)
        Times and states.
    label : str
        Its name in the legend.
    **look
        Settings of matplotlib's `plot` that come before the course's own; and away=True for an arrow with the value
        where the line is furthest above or below the axes.

    Returns
    -------
    Line
        `.set(t, x)` moves it.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> line = plots.truth(ax, [0, 1, 2], [0, 1, 4])
    >>> line.set([0, 1, 2], [0, 2, 8]).data
    ([0, 1, 2], [0, 2, 8])
    """
    return Line(ax, "truth", t, x, label, **look)


def measurements(ax, t, z, label="measurement", **look) -> Line:
    """Draw measurements: grey dots.

    Parameters
    ----------
    ax : matplotlib Axes
    t, z : array (T,)
        Times and measurements.
    label, **look
        As in `truth`.

    Returns
    -------
    Line
        `.set(t, z)` moves it.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> plots.measurements(ax, [0, 1, 2], [0.1, 0.8, 4.2]).artists[0].get_marker()
    'o'
    """
    return Line(ax, "measurement", t, z, label, **look)


def prediction(ax, t, x, label="prediction", **look) -> Line:
    """Draw predicted values: a dashed orange line with triangles.

    Parameters
    ----------
    ax : matplotlib Axes
    t, x : array (T,)
        Times and predicted values.
    label, **look
        As in `truth`.

    Returns
    -------
    Line
        `.set(t, x)` moves it.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> plots.prediction(ax, [0, 1, 2], [0, 1, 3]).artists[0].get_linestyle()
    '--'
    """
    return Line(ax, "prediction", t, x, label, **look)


def gain(ax, t, k, label="gain", **look) -> Line:
    """Draw a Kalman gain along time: a dash-dotted green line with diamonds.

    Parameters
    ----------
    ax : matplotlib Axes
    t, k : array (T,)
        Times and gains.
    label, **look
        As in `truth`.

    Returns
    -------
    Line
        `.set(t, k)` moves it.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> plots.gain(ax, [0, 1, 2], [0.9, 0.5, 0.4]).artists[0].get_label()
    'gain'
    """
    return Line(ax, "gain", t, k, label, **look)


def outliers(ax, t, z, label="outlier", **look) -> Line:
    """Draw outlying or rejected measurements: vermilion crosses.

    Parameters
    ----------
    ax : matplotlib Axes
    t, z : array (T,)
        Times and measurements; both may be empty.
    label, **look
        As in `truth`.

    Returns
    -------
    Line
        `.set(t, z)` moves them.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> plots.outliers(ax, [], []).set([1], [9.0]).data
    ([1], [9.0])
    """
    return Line(ax, "outlier", t, z, label, **look)


def estimate(ax, t, mean, std=None, label="estimate", **look) -> Estimate:
    """Draw estimates: a blue line and, with std, a band of ±2 standard deviations.

    Parameters
    ----------
    ax : matplotlib Axes
    t, mean : array (T,)
        Times and estimates.
    std : array (T,), optional
        Standard deviations, in the unit of `mean`.
    label, **look
        As in `truth`.

    Returns
    -------
    Estimate
        `.set(t, mean, std)` moves the line and its band together.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> drawn = plots.estimate(ax, [0, 1, 2], [0, 1, 2], [1, 1, 1])
    >>> [artist.get_label() for artist in drawn.artists]
    ['±2σ', 'estimate']
    """
    return Estimate(ax, t, mean, std, label, **look)


def density(ax, x_grid, mean, variance, kind="estimate", label=None, **look) -> Density:
    """Draw a Gaussian bell in the colours of a role.

    Parameters
    ----------
    ax : matplotlib Axes
    x_grid : array (n,)
        Where the bell is drawn.
    mean : float
        In the unit of `x_grid`.
    variance : float
        In that unit squared, above 0.
    kind : str
        "truth", "measurement", "prediction", "estimate", "gain" or "outlier".
    label : str, optional
        Its name in the legend, `kind` when not given.
    **look
        As in `truth`.

    Returns
    -------
    Density
        `.set(mean, variance)` moves it.

    Raises
    ------
    KeyError
        For another kind.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> plots.density(ax, [-1, 0, 1], 0, 1, kind="prediction").set(0.5, 4).data
    (0.5, 4)
    """
    return Density(ax, x_grid, mean, variance, kind, label, **look)


def innovations(ax, t, innovation, std, label="innovation", **look) -> Innovations:
    """Draw innovations inside their band ±2√S: the daily check of a filter that needs no truth.

    An honest filter has about 95 in 100 of its innovations inside the band, on both sides of zero, without runs of
    one sign. Those outside are marked with a ring.

    Parameters
    ----------
    ax : matplotlib Axes
    t : array (T,)
        Times.
    innovation : array (T,)
        Reading minus predicted reading; NaN where there was none.
    std : array (T,)
        √S, the standard deviation that the filter expects of it, in the unit of the innovation.
    label, **look
        As in `truth`.

    Returns
    -------
    Innovations
        `.set(t, innovation, std)` moves dots, rings and band together; `.outside` is the share of the readings outside.

    Examples
    --------
    >>> from kflearn import plots
    >>> fig, ax = plots.figure()
    >>> drawn = plots.innovations(ax, [0, 1, 2, 3], [0.5, -1.0, 3.0, 0.2], [1, 1, 1, 1])
    >>> print(f"{drawn.outside:.2f}")
    0.25
    """
    return Innovations(ax, t, innovation, std, label, **look)
