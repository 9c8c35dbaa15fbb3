"""Forecasts of readings that a filter was not given, beside forecasts that need no filter."""

from typing import NamedTuple

import numpy as np

FAR = 10.828  # chi-square quantile of 0.999: a hidden reading beyond is an outlier, which no forecast can hit


class Forecast(NamedTuple):
    """share of hidden `readings` that were inside ±2σ, or for a rival nearer to the filter; what is honest."""

    what: str
    share: float
    readings: int
    honest: float
    rival: bool


def forecasts(z, follow) -> list[Forecast]:
    """One step ahead, with every fifth row hidden; five steps ahead, with five rows in 25 hidden; and three rivals."""
    T = len(z)
    one = _hidden(z, np.arange(4, T, 5), follow)
    blocks = (np.arange(T) % 25 >= 20) & (np.arange(T) > 0)
    five = _hidden(z, np.flatnonzero(blocks), follow, np.arange(24, T, 25))
    found = [_coverage("forecasts inside ±2σ", one), _coverage("5 steps ahead, inside ±2σ", five)]
    return found + [_against(one, name, guess) for name, guess in _rivals(z, one.rows).items()]


class Hidden(NamedTuple):
    """Rows that were hidden, and how far each reading (rows, m) was from its forecast, also in standard deviations."""

    rows: np.ndarray
    z: np.ndarray
    miss: np.ndarray
    scaled: np.ndarray


def _hidden(z, rows, follow, asked=None):
    """Hide rows, filter, and compare at these rows or at those that are asked for."""
    part = z.copy()
    part[rows] = np.nan
    model, track = follow(part)
    rows = rows if asked is None else asked
    inputs = [None] * len(track.mean) if track.u is None else track.u
    expected = [model.measure(track.predicted.mean[k - 1], inputs[k - 1], k - 1) for k in rows]
    miss = np.array([model.difference(z[k], e) for k, e in zip(rows, expected, strict=True)]).reshape(-1, z.shape[1])
    return Hidden(rows, z[rows], miss, miss / track.innovation.std[rows - 1])


def _coverage(what, hidden):
    """The share inside ±2σ, outliers aside."""
    scaled = hidden.scaled[~np.isnan(hidden.scaled)]
    scaled = scaled[scaled**2 < FAR]
    return Forecast(what, float(np.mean(abs(scaled) < 2)) if len(scaled) else 0.0, len(scaled), 0.9545 / 0.999, False)


def _rivals(z, rows):
    """What the last reading, the mean so far and the line through the last two say of hidden rows (rows, m)."""
    guesses = {"last reading": [], "mean so far": [], "line through two": []}
    for k in rows:
        seen = [z[:k, j][~np.isnan(z[:k, j]) & (np.arange(k) % 5 != 4)] for j in range(z.shape[1])]
        guesses["last reading"].append([s[-1] for s in seen])
        guesses["mean so far"].append([s.mean() for s in seen])
        guesses["line through two"].append([2 * s[-1] - s[-2] if len(s) > 1 else s[-1] for s in seen])
    return {name: np.array(guess).reshape(-1, z.shape[1]) for name, guess in guesses.items()}


def _against(hidden, name, guess):
    """How often the filter is nearer to a hidden reading than a rival."""
    ours, theirs = abs(hidden.miss), abs(hidden.z - guess)
    rounding = 1e-9 * np.maximum(abs(hidden.z), abs(guess))  # two forecasts may differ by it alone
    both = ~np.isnan(ours) & ~np.isnan(theirs) & (abs(ours - theirs) > rounding)
    share = float(np.mean((ours < theirs)[both])) if both.any() else 0.0
    return Forecast(f"nearer than {name}", share, int(both.sum()), 0.5, True)
