"""All filters in one table: what tests, benchmarks and the overview in `kflearn.__doc__` go through.

A new filter is a function `…_filter`, one row here and its export in `kflearn/__init__.py`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from ..results.track import Filtered, Track
from .adaptive import AdaptiveTrack, adaptive_kalman_filter
from .consider import schmidt_kalman_filter
from .kalman import (
    cubature_kalman_filter,
    extended_kalman_filter,
    kalman_filter,
    linearized_kalman_filter,
    unscented_kalman_filter,
)
from .multiple_models import MultipleModelTrack, imm_filter, mmae_filter
from .square_root import square_root_kalman_filter


def _frozen(**settings):
    return MappingProxyType(settings)


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
    needed: Mapping = field(default_factory=_frozen)
    optional: Mapping = field(default_factory=_frozen)
    exact: bool = True

    @property
    def name(self) -> str:
        """The public name, kflearn.<name>."""
        return self.function.__name__

    def run(self, model, z, initial, u=None, **settings) -> Filtered:
        """Call the filter with what it needs; a filter of several models gets the model twice."""
        first = [model, model] if self.several else model
        return self.function(first, z, initial, u, **{**self.needed, **settings})


FILTERS = (
    Row(kalman_filter, "linear"),
    Row(square_root_kalman_filter, "linear"),
    Row(schmidt_kalman_filter, "linear", smoothed=False, optional=_frozen(considered=[1])),
    Row(extended_kalman_filter, "both"),
    Row(unscented_kalman_filter, "both", optional=_frozen(alpha=0.5, beta=1.0, kappa=0.5)),
    Row(cubature_kalman_filter, "both"),
    Row(linearized_kalman_filter, "both"),
    Row(
        adaptive_kalman_filter,
        "both",
        AdaptiveTrack,
        smoothed=False,
        optional=_frozen(window=5, floor=0.1, adapt="Q"),
        exact=False,
    ),
    Row(
        imm_filter,
        "both",
        MultipleModelTrack,
        smoothed=False,
        several=True,
        needed=_frozen(transition=[[0.9, 0.1], [0.2, 0.8]], mode_probabilities=[0.5, 0.5]),
    ),
    Row(
        mmae_filter,
        "both",
        MultipleModelTrack,
        smoothed=False,
        several=True,
        optional=_frozen(mode_probabilities=[0.4, 0.6]),
    ),
)
