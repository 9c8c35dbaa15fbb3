"""Is a filter any good on a recording, when nobody knows the truth? Tests that need none, on one card."""

from dataclasses import dataclass

import numpy as np

from ..core.matrices import step_matrix
from ..models import checks as check
from .consistency import chi_square_interval, lagged_products
from .track import Track


@dataclass(frozen=True)
class ReportCard:
    """tests: (what, found, low, high) of each test, passed when low ≤ found ≤ high; print it to see the table."""

    tests: tuple[tuple[str, float, float, float], ...]

    @property
    def passed(self) -> bool:
        """Has the filter passed every test?"""
        return all(low <= found <= high for _, found, low, high in self.tests)

    def __str__(self):
        told = [f"  {'':24} {'found':>9}    wanted"]
        for what, found, low, high in self.tests:
            mark = "✓" if low <= found <= high else "✗"
            told.append(f"{mark} {what:24} {found:9.3f}   {low:7.3f} to {high:.3f}")
        return "\n".join([*told, f"verdict: {'can be defended' if self.passed else 'not yet'}"])


def report_card(z, rest, follow) -> ReportCard:
    """Tests of a filter on a recording whose truth nobody knows.

    Two-sided, at 95 %: the scatter at rest against R; the neighbours at rest; NIS and neighbours of the innovations.
    Refused: a tenth at most, three in a row at most. Every fifth reading is hidden from the filter: its median miss, in
    standard deviations of a reading, has to be smaller than those of the reading before it and of the first one.

    Parameters
    ----------
    z : array_like
        Readings (T, m), or (T,) when m = 1; NaN for gaps.
    rest : array_like of bool
        (T,), True for the rows at which nothing moved.
    follow : callable
        The filter under test: a function of readings (T, m) that starts from the first of them and returns its model
        and the Track of the T − 1 others. Refused
        is what track.refused says, and a reading that follow left out, so that its innovation is NaN.

    Returns
    -------
    ReportCard
        Print it to see the table.

    Raises
    ------
    ValueError, TypeError
        Where z or rest do not fit, or follow does not return what it should.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import kalman_filter, random_walk, report_card, start_from
    >>> model, rng = random_walk(1, 1), np.random.default_rng(0)
    >>> z = np.concatenate([np.zeros(50), np.cumsum(rng.normal(size=150))]) + rng.normal(size=200)
    >>> def follow(z):
    ...     return model, kalman_filter(model, z[1:], start_from(model, z[0]))
    >>> print(report_card(z, np.arange(200) < 50, follow).tests[2][0])
    NIS / m
    """
    z = check.numbers("z", z, gaps=True)
    z = check.shape("z", z[:, None] if z.ndim == 1 else z, (None, None))
    rest = check.shape("rest", np.asarray(rest, dtype=bool), (len(z),))
    if (~np.isnan(z[rest])).sum(axis=0).min() < 2:
        raise ValueError("rest must be True for two rows or more with readings in every column")
    if np.isnan(z[0]).any():
        raise ValueError("z must begin with a row without gaps, from which the filter starts")
    model, track = _followed(follow, z)
    sigma = np.sqrt(np.diagonal(step_matrix(model.R, 0)))
    still = (z[rest] - np.nanmean(z[rest], axis=0)) / sigma
    tests = _at_rest(still) + _innovations(track, z) + _hidden(z, sigma, follow)
    return ReportCard(tuple((what, *map(float, numbers)) for what, *numbers in tests))


def _followed(follow, z):
    """The model and the track of the filter under test, after they were looked at."""
    found = follow(z)
    if not isinstance(found, (tuple, list)) or len(found) != 2:
        raise TypeError(f"follow must return two things, the model and the track, got {type(found).__name__}")
    model, track = found
    if isinstance(model, Track) or not isinstance(track, Track):
        kinds = f"{type(model).__name__} and {type(track).__name__}"
        raise TypeError(f"follow must return the model first and then its Track, got {kinds}")
    steps = track.innovation.mean.shape[:-1]
    if steps != (len(z) - 1,):
        raise ValueError(
            f"follow must start from the first reading and filter the {len(z) - 1} others, got a track of {steps[-1]} "
            f"steps{'' if len(steps) == 1 else ' of several runs'}"
        )
    return model, track


def _at_rest(still):
    """Readings at rest, in standard deviations, against R."""
    count = int((~np.isnan(still)).sum())
    freedom, bound = count - still.shape[1], 1.96 / np.sqrt(count)
    return (
        ("scatter at rest / R", np.nansum(still**2) / freedom, *chi_square_interval(1, freedom)),
        ("neighbours at rest", neighbours(still), -bound, bound),
    )


def _innovations(track, z):
    """Are the innovations as large and as white as they should be, and how many readings were refused?"""
    used = ~np.isnan(track.innovation.mean) & ~track.refused[:, None]
    y = np.where(used, track.innovation.mean / track.innovation.std, np.nan)
    N = max(int(used.sum()), 1)
    refused = (~used & ~np.isnan(z[1:])).any(axis=1)
    return (
        ("NIS / m", np.nansum(track.nis[~track.refused]) / N, *chi_square_interval(1, N)),
        ("neighbours, innovations", neighbours(y), -1.96 / np.sqrt(N), 1.96 / np.sqrt(N)),
        ("share refused", refused.mean(), 0, 0.1),
        ("refused in a row", longest_run(refused), 0, 3),
    )


def _hidden(z, sigma, follow):
    """Does the filter foresee hidden readings better than those who do not filter?"""
    miss, last, ignored = _misses(z, sigma, follow)
    return (
        ("miss / last reading's", _ratio(miss, last), 0, 1),
        ("miss / all ignored", _ratio(miss, ignored), 0, 1),
    )


def _misses(z, sigma, follow):
    """Median misses of hidden readings: of the filter, of the reading before, of the first reading."""
    hidden, part = np.arange(4, len(z), 5), z.copy()
    part[hidden] = np.nan
    model, track = _followed(follow, part)
    guesses = (_expected(model, track)[hidden - 1], z[hidden - 1], z[0])
    misses = (np.linalg.norm((guess - z[hidden]) / sigma, axis=1) for guess in guesses)
    return [np.median(miss[~np.isnan(miss)]) if not np.isnan(miss).all() else np.nan for miss in misses]


def _expected(model, track):
    """The measurements that the filter expects, (T, m)."""
    inputs = [None] * len(track.mean) if track.u is None else track.u
    return np.stack([model.measure(x, u, k) for k, (x, u) in enumerate(zip(track.predicted.mean, inputs, strict=True))])


def _ratio(one, other):
    return one / other if other else np.nan


def neighbours(y):
    """The correlation of neighbouring rows of y (T, m), without those that are NaN; within ±1.96/√(T m) it is white.

    One number for all components: the sum of the products by the sum of the squares. `whiteness` has one for each, the
    mean of the products by the mean of the squares.
    """
    power = np.nansum(y**2)
    return float(_ratio(np.nansum(lagged_products(y, 1)), power))


def longest_run(flags):
    """The length of the longest run of True in flags (T,)."""
    ends = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(flags, dtype=int), [0]])))  # begin, end, begin, end …
    return int((ends[1::2] - ends[::2]).max(initial=0))
