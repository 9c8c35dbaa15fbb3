"""A family of models: what `build` makes of parameters, for many of them at once."""

import numpy as np

from ..models import checks as check
from ..models.state_space import LinearModel
from .many import Matrices


class Family:
    """The models build(**parameters), and coordinates in which to search among them.

    A positive parameter's coordinate is its logarithm (−inf: the parameter is 0), another one's is its value divided by
    the size of the first value. Where every matrix is a constant plus a multiple of each parameter, as with variances,
    build is called a few times only.
    """

    def __init__(self, build, start, as_is=()):
        if not callable(build):
            raise TypeError(f"build must be a function that returns a LinearModel, got {type(build).__name__}")
        if not isinstance(start, dict) or not start:
            raise TypeError(f"start must be a dict of first values by name, got {start!r}")
        if unknown := set(as_is) - set(start):
            raise ValueError(f"as_is must name parameters of start, got {sorted(unknown)}")
        self.build, self.names = build, list(start)
        self.first = np.array([check.number(f"start[{name!r}]", value) for name, value in start.items()])
        self.positive = (self.first > 0) & [name not in as_is for name in start]
        self.scale = np.where(self.first == 0, 1, abs(self.first))
        self.model = self.at(self.first)
        self._rest, self._slopes = self._straight()

    def at(self, values) -> LinearModel:
        """The model with parameters (p,)."""
        model = self.build(**dict(zip(self.names, map(float, values), strict=True)))
        if not isinstance(model, LinearModel):
            raise TypeError(f"build must return a LinearModel, got {type(model).__name__}")
        if any(getattr(model, name) is not None and getattr(model, name).ndim > 3 for name in Matrices._fields):
            raise ValueError("build must return a model without batch axes")
        return model

    def coordinates(self, values):
        """Where parameters (..., p) lie in the search."""
        with np.errstate(divide="ignore"):
            return np.where(self.positive, np.log(np.where(self.positive, values, 1)), values / self.scale)

    def values(self, coordinates):
        """The parameters (..., p) at coordinates (..., p)."""
        return np.where(self.positive, np.exp(np.where(self.positive, coordinates, 0)), coordinates * self.scale)

    def matrices(self, values) -> Matrices:
        """The matrices of the models with parameters values (*runs, p)."""
        runs = values.shape[:-1]
        if self._slopes is not None:
            each = np.moveaxis(values, -1, 0)
            return Matrices(*(_sum(rest, slope, each) for rest, slope in zip(self._rest, self._slopes, strict=True)))
        built = [Matrices.of(self.at(each)) for each in values.reshape(-1, len(self.names))]
        return Matrices(*(_side_by_side(M, runs) for M in zip(*built, strict=True)))

    def possible(self, values):
        """Can there be a model with these parameters (p,)?"""
        try:
            return bool(self.at(values))
        except ValueError:
            return False

    def _straight(self):
        """The matrices with all parameters 0, and what each parameter adds times its value; (None, None) where they are
        no such sums."""
        base, slopes = Matrices.of(self.model), []
        for i, value in enumerate(self.first):
            moved = self.first.copy()
            moved[i] = 2 * value if value else 1.0
            if not self.possible(moved):
                return None, None
            slopes.append(_differences(Matrices.of(self.at(moved)), base, moved[i] - value))
        slopes = [None if parts[0] is None else np.stack(parts) for parts in zip(*slopes, strict=True)]
        rest = [_rest(M, slope, self.first) for M, slope in zip(base, slopes, strict=True)]
        trial = self.first * (1 + np.arange(1, len(self.first) + 1) / 7) + (self.first == 0) / 3
        if not self.possible(trial):
            return None, None
        for M, left, slope in zip(Matrices.of(self.at(trial)), rest, slopes, strict=True):
            if M is not None and (M.shape != left.shape or not _same(M, left + np.tensordot(trial, slope, 1))):
                return None, None
        return rest, slopes


def _differences(moved, base, by):
    return [None if M is None else (M - first) / by for M, first in zip(moved, base, strict=True)]


def _same(A, B):
    return (abs(A - B) <= 1e-12 * np.maximum(abs(A), abs(B)).max()).all()


def _rest(base, slope, first):
    """What is left of the matrices (S, r, c) when all parameters are 0; what only rounding leaves is 0 too."""
    if base is None:
        return None
    left = base - np.tensordot(first, slope, 1)
    return np.where(abs(left) <= 1e-13 * abs(base), 0, left)


def _sum(rest, slope, each):
    """rest (S, r, c) plus slope (p, S, r, c) times the parameters (p, *runs): (S, r, c, *runs), or without runs."""
    if rest is None:
        return None
    lead = rest.reshape(*rest.shape, *[1] * (each.ndim - 1))
    return lead + np.tensordot(np.moveaxis(slope, 0, -1), each, 1) if slope.any() else lead


def _side_by_side(matrices, runs):
    """Matrices (S, r, c) of each run as one array (S, r, c, *runs)."""
    if matrices[0] is None:
        return None
    return np.stack(matrices, axis=-1).reshape(*matrices[0].shape, *runs)
