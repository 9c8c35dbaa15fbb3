"""A row of `kflearn.FILTERS`, the table of all filters: tests, benchmarks and the overview in `kflearn` use it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from ..results.track import Filtered, Track


def settings(**values) -> Mapping:
    """Keyword arguments that nobody can change."""
    return MappingProxyType(values)


@dataclass(frozen=True)
class Row:
    """One filter.

    function: takes (model, z, initial, u=None, *, …), or a list of models in the place of the model where `several`.
    models: "linear" or "both", the kinds of model it takes (LinearModel; NonlinearModel too).
    returns: the class of its result.
    smoothed: may rts_smoother follow?
    several: does it take a list of models?
    needed: keyword arguments without which it cannot be called, each with a valid value (for two models).
    optional: its other keyword arguments, each with a valid value that differs from the default (for two states or
        more, and for two models); `nominal`, whose shape is that of the states (T, n), and `states` and `through` are
        not among them.
    exact: on a linear model with these settings left alone, are its numbers those of the Kalman filter?
    """

    function: Callable
    models: str
    returns: type[Filtered] = Track
    smoothed: bool = True
    several: bool = False
    needed: Mapping = field(default_factory=settings)
    optional: Mapping = field(default_factory=settings)
    exact: bool = True

    @property
    def name(self) -> str:
        """The public name, kflearn.<name>."""
        return self.function.__name__

    def run(self, model, z, initial, u=None, **settings) -> Filtered:
        """Call the filter with what it needs; a filter of several models gets the model twice."""
        first = [model, model] if self.several else model
        return self.function(first, z, initial, u, **{**self.needed, **settings})
