"""Is a filter any good on a recording, when nobody knows the truth? Tests that need none, on one card."""

from dataclasses import dataclass

import numpy as np

from . import _checks as check
from .consistency import chi_square_interval
from .models import at


@dataclass(frozen=True)
class ReportCard:
    """tests: (what, found, low, high) of each test, passed when low ≤ found ≤ high; print it to see the table."""

    tests: tuple[tuple[str, float, float, float], ...]

    @property
    def passed(self):
        return all(low <= found <= high for _, found, low, high in self.tests)

    def __str__(self):
        told = [f"  {'':24} {'found':>9}    wanted"]
        for what, found, low, high in self.tests:
            mark = "✓" if low <= found <= high else "✗"
            told.append(f"{mark} {what:24} {found:9.3f}   {low:7.3f} to {high:.3f}")
        return "\n".join([*told, f"verdict: {'can be defended' if self.passed else 'not yet'}"])


def report_card(z, rest, follow):
    """Tests of a filter on readings z (T, m), NaN for gaps, without a truth. Returns a ReportCard.

    rest: (T,), True for the rows at which nothing moved. follow: the filter under test, a function of readings (T, m)
    that starts from the first of them and returns its model and the Track of the others; a reading that the track does
    not use is one that a gate has refused.
    Two-sided, at 95 %: the scatter at rest against R; the neighbours at rest; NIS and neighbours of the innovations.
    Refused: a tenth at most, three in a row at most. Every fifth reading is hidden from the filter: its median miss, in
    standard deviations of a reading, has to be smaller than those of the reading before it and of the first one.
    Raises ValueError where z or rest do not fit.
    """
    z = check.shape("z", check.numbers("z", z, gaps=True), (None, None))
    rest = check.shape("rest", np.asarray(rest, dtype=bool), (len(z),))
    if (~np.isnan(z[rest])).sum(axis=0).min() < 2:
        raise ValueError("rest must be True for two rows or more with readings in every column")
    if np.isnan(z[0]).any():
        raise ValueError("z must begin with a row without gaps, from which the filter starts")
    model, track = follow(z)
    sigma = np.sqrt(np.diagonal(at(model.R, 0)))
    y, used = track.innovation.mean / track.innovation.std, ~np.isnan(track.innovation.mean)
    N = max(int(used.sum()), 1)
    refused = (~used & ~np.isnan(z[1:])).any(axis=1)
    still = (z[rest] - np.nanmean(z[rest], axis=0)) / sigma
    count = int((~np.isnan(still)).sum())
    freedom = count - z.shape[1]
    miss, last, ignored = _misses(z, sigma, follow)
    tests = (
        ("scatter at rest / R", np.nansum(still**2) / freedom, *chi_square_interval(1, freedom)),
        ("neighbours at rest", neighbours(still), -1.96 / np.sqrt(count), 1.96 / np.sqrt(count)),
        ("NIS / m", np.nansum(track.nis) / N, *chi_square_interval(1, N)),
        ("neighbours, innovations", neighbours(y), -1.96 / np.sqrt(N), 1.96 / np.sqrt(N)),
        ("share refused", refused.mean(), 0, 0.1),
        ("refused in a row", longest_run(refused), 0, 3),
        ("miss / last reading's", _ratio(miss, last), 0, 1),
        ("miss / all ignored", _ratio(miss, ignored), 0, 1),
    )
    return ReportCard(tuple((what, *map(float, numbers)) for what, *numbers in tests))


def _misses(z, sigma, follow):
    """Median misses of hidden readings: of the filter, of the reading before, of the first reading."""
    hidden, part = np.arange(4, len(z), 5), z.copy()
    part[hidden] = np.nan
    model, track = follow(part)
    guesses = (model.measure(track.predicted.mean)[hidden - 1], z[hidden - 1], z[0])
    misses = (np.linalg.norm((guess - z[hidden]) / sigma, axis=1) for guess in guesses)
    return [np.median(miss[~np.isnan(miss)]) if not np.isnan(miss).all() else np.nan for miss in misses]


def _ratio(one, other):
    return one / other if other else np.nan


def neighbours(y):
    """The correlation of neighbouring rows of y (T, m), without those that are NaN; within ±1.96/√(T m) it is white."""
    power = np.nansum(y**2)
    return float(_ratio(np.nansum(y[1:] * y[:-1]), power))


def longest_run(flags):
    """The length of the longest run of True in flags (T,)."""
    ends = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(flags, dtype=int), [0]])))  # begin, end, begin, end …
    return int((ends[1::2] - ends[::2]).max(initial=0))
