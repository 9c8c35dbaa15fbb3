"""A mean over runs and its standard error: what a comparison of filters must show before it proves anything."""

from dataclasses import dataclass

import numpy as np

from ..models import checks as check


@dataclass(frozen=True)
class Measured:
    """A value found by repeated runs, and its standard error.

    Attributes
    ----------
    value, error : float
        In one unit.

    Examples
    --------
    >>> from kflearn import Measured
    >>> print(f"{Measured(58.234, 0.412):.2f} m")
    58.23 ± 0.41 m
    """

    value: float
    error: float

    def __format__(self, spec):
        return f"{self.value:{spec}} ± {self.error:{spec.lstrip('+')}}"

    def __str__(self):
        return f"{self:.3g}"


def with_error(values, minus=None, root=False) -> Measured:
    """The mean over independent runs, give or take one standard error.

    The leading axis counts the runs, which must be independent of one another; what follows (the steps of a run, its
    components) is averaged within the run first. The standard error is s/√N, s being the standard deviation over the N
    runs. With `minus` it is that of the difference, run by run: two filters that have seen the same readings share
    their luck, which drops out.

    Parameters
    ----------
    values : array_like
        (runs, ...), two runs at least.
    minus : array_like, optional
        Of the same shape, from the same runs: what is subtracted.
    root : bool
        True when `values` are squared errors and the root of their mean is wanted; its standard error follows to first
        order, that of the mean divided by twice the root.

    Returns
    -------
    Measured
        .value and .error, in the unit of `values`, or with root=True in its root.

    Raises
    ------
    ValueError
        For fewer than two runs, numbers that are not finite, shapes that differ, or squared errors below 0.

    References
    ----------
    JCGM 100:2008, *Guide to the expression of uncertainty in measurement*, 4.2.3 and 5.1.2.

    Examples
    --------
    >>> from kflearn import with_error
    >>> print(f"{with_error([1.0, 2.0, 3.0, 2.0]):.2f} m")
    2.00 ± 0.41 m
    >>> print(f"{with_error([9.0, 16.0, 25.0], minus=[4.0, 9.0, 16.0], root=True):.2f} m")
    0.97 ± 0.02 m
    """
    mean, about = _of_runs("values", values, root)
    if minus is not None:
        less, around = _of_runs("minus", minus, root)
        if np.shape(minus) != np.shape(values):
            raise ValueError(f"minus must have the shape of values, {np.shape(values)}, got {np.shape(minus)}")
        mean, about = mean - less, about - around
    return Measured(float(mean), float(about.std(ddof=1) / np.sqrt(about.size)))


def _of_runs(name, values, root):
    """The mean or its root, and what each run contributes to its deviation, to first order."""
    values = check.numbers(name, values)
    if values.ndim == 0 or len(values) < 2:
        raise ValueError(f"{name} must have two independent runs at least, along its first axis")
    runs = values.reshape(len(values), -1).mean(axis=1)
    mean = runs.mean()
    if not root:
        return mean, runs
    if values.min() < 0:
        raise ValueError(f"{name} must be squared errors with root=True, which are never below 0")
    return np.sqrt(mean), runs / (2 * np.sqrt(mean)) if mean else 0 * runs
