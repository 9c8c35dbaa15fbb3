"""Is a filter any good on a recording, when nobody knows the truth? Tests that need none, on one card.

An honest filter fails the card in one recording in twenty: the bands (`bands.py`) are made for all statistical tests at
once, and they know that R was estimated from the readings at rest. In 12,000 simulated recordings of twelve kinds it
failed 5.3 ± 0.2 %: about 4 % of the easiest kind, and 9 % of the hardest, which has a gate of 99 %: no band knows of
its runs of refusals. `python -m dev.hard values` measures it.
"""

import textwrap
from dataclasses import dataclass

import numpy as np

from ..core.matrices import compact
from ..models import checks as check
from .bands import Around0, Share, Size, behind_a_gate, common_level
from .consistency import lagged_products
from .held_back import forecasts
from .track import Track

FEWEST = 20  # readings that a test needs
ERROR = 0.05  # how often an honest filter fails one test or more
REACH = 0.85  # S goes with R to this power, about: between ¾ (constant velocity) and 1
MARKS = {True: "✓", False: "✗", None: "–"}
ADVICE = {
    "size": "above: Q or R is too small, or there are outliers; below: Q or R is too large (the table of lesson 7)",
    "mean": "something pushes in one direction that F and u do not know, or the sensor has an offset",
    "neighbours": "above: Q is too small beside R, or the sensor's error has a memory and needs a state of its own "
    "(lesson 21); below: Q is too large",
    "share": "more than one reading in ten was refused: R is too small, or the model does not fit",
    "run": "the gate refused for long, so it may have locked the filter out: try a larger Q, or a new start after some "
    "refusals",
    "coverage": "±2σ of the forecasts is too narrow or too wide: look at Q first, then at R",
    "rival": "the simple forecast is better: the model predicts what does not happen",
}


@dataclass(frozen=True)
class CardTest:
    """One line of the card: passed is None where there was nothing to test, and kind is a key of ADVICE."""

    what: str
    kind: str
    found: float
    low: float
    high: float
    count: int

    @property
    def passed(self) -> bool | None:
        """Does what was found lie in its band? None for fewer than 20 readings."""
        if self.count < FEWEST:
            return None
        return bool(self.low <= self.found <= self.high)

    def __str__(self):
        mark = MARKS[self.passed]
        if self.passed is None:
            return f"{mark} {self.what:32} nothing to test: {self.count} readings"
        high = "" if np.isinf(self.high) else f" to {self.high:.3f}"
        least = "at least " if np.isinf(self.high) else ""
        return f"{mark} {self.what:32} {self.found:9.3f}   {least}{self.low:.3f}{high}"


@dataclass(frozen=True)
class ReportCard:
    """tests: a CardTest for each line; print the card to see the table, and what to try where a test failed."""

    tests: tuple[CardTest, ...]

    @property
    def passed(self) -> bool:
        """Was anything tested, and did the filter fail in nothing?"""
        results = [test.passed for test in self.tests]
        return any(result is not None for result in results) and False not in results

    def __str__(self):
        told = [f"  {'':32} {'found':>9}   wanted", *map(str, self.tests)]
        failed = [test for test in self.tests if test.passed is False]
        advice = [fill(f"{kind}: {ADVICE[kind]}") for kind in dict.fromkeys(test.kind for test in failed)]
        verdict = "can be defended" if self.passed else "not yet" if failed else "too few readings to say"
        return "\n".join([*told, f"verdict: {verdict}", *advice])


def report_card(z, rest, follow, names=None) -> ReportCard:
    """Tests of a filter on a recording whose truth nobody knows.

    For each column, over its readings in motion: are the innovations as large as the filter says, without a mean, and
    without correlation between one reading and the next? Of the gate: how many readings were refused, and how many in a
    row? Of forecasts of readings that were hidden: does ±2σ hold 95 % of them, and are they nearer than
    the last reading, the mean so far and the line through the last two? Where there are too few readings a test neither
    passes nor fails.

    Parameters
    ----------
    z : array_like
        Readings (T, m), or (T,) when m = 1; NaN for gaps.
    rest : array_like of bool
        (T,), True for the rows at which nothing moved and from which R was estimated; the bands allow for what so few
        readings leave open. All False if R comes from elsewhere.
    follow : callable
        The filter under test: a function of readings (T, m) that starts from the first of them and returns its model
        and the Track of the T − 1 others. Refused is what track.refused says, and a reading that follow left out, so
        that its innovation is NaN.
    names : list of str, optional
        Of the columns.

    Returns
    -------
    ReportCard
        Print it to see the table.

    Raises
    ------
    ValueError, TypeError
        Where z or rest do not fit, or follow does not return what it should.

    References
    ----------
    Bar-Shalom, Li and Kirubarajan 2001, 5.4; Šidák 1967; Diebold and Mariano 1995 for forecasts against rivals.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import kalman_filter, random_walk, report_card, start_from
    >>> model, rng = random_walk(1, 1), np.random.default_rng(0)
    >>> z = np.concatenate([np.zeros(50), np.cumsum(rng.normal(size=150))]) + rng.normal(size=200)
    >>> def follow(z):
    ...     return model, kalman_filter(model, z[1:], start_from(model, z[0]))
    >>> print(report_card(z, np.arange(200) < 50, follow).tests[0].what)
    size of innovations
    """
    z = check.numbers("z", z, gaps=True)
    z = check.shape("z", z[:, None] if z.ndim == 1 else z, (None, None))
    rest = check.shape("rest", np.asarray(rest, dtype=bool), (len(z),))
    if np.isnan(z[0]).any():
        raise ValueError("z must begin with a row without gaps, from which the filter starts")
    names = _names(names, z.shape[1])
    model, track = followed(follow, z)
    used = ~np.isnan(track.innovation.mean) & ~track.refused[:, None]
    white, moving = track.innovation.mean / track.innovation.std, used & ~rest[1:, None]
    refused = (~used & ~np.isnan(z[1:])).any(axis=1)
    doubt = doubt_about_R(z[rest], model)
    share = _share_of_R(model, track)
    lines, kept = [], behind_a_gate(track.nis, refused, z.shape[1])
    for j, name in enumerate(names):
        lines += _innovations(name, white[moving[:, j], j], share[moving[:, j], j], doubt[j], kept)
    together = doubt.mean() / (1 if _one_R(model) else z.shape[1]) * REACH**2
    ahead = [_forecast(one, together) for one in forecasts(z, lambda part: followed(follow, part))]
    tested = [one.band for one in lines + ahead if one.count >= FEWEST and one.kind != "rival"]
    level = common_level(tested, ERROR)
    read = refused[~np.isnan(z[1:]).all(axis=1)]
    fixed = [CardTest("share refused", "share", _mean(read), 0, 0.1, len(read))]
    fixed += [CardTest("refused in a row", "run", longest_run(read), 0, 3, len(read))]
    return ReportCard((*(_judged(one, level) for one in lines), *fixed, *(_judged(one, level) for one in ahead)))


def followed(follow, z):
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


def _names(names, m):
    """What follows a test's name on the card: nothing where there is one column."""
    if names is None:
        names = [f"column {j + 1}" for j in range(m)]
    if len(names) != m:
        raise ValueError(f"names must be {m}, one for each column, got {len(names)}")
    return [""] if m == 1 else [f", {name}" for name in names]


def _one_R(model):
    """Is R the same number for all columns, at each step? Then it was taken from all of them."""
    R = np.diagonal(model.R, axis1=-2, axis2=-1)
    return bool((R[..., :1] == R).all())


def doubt_about_R(still, model):
    """The relative variance (m,) of an R that was estimated from these readings at rest (n, m); 0 without any."""
    known = np.maximum((~np.isnan(still)).sum(axis=0) - 1, 1)
    if not len(still):
        return np.zeros(still.shape[1])
    return np.full(known.shape, 2 / known.sum()) if _one_R(model) else 2 / known


def _share_of_R(model, track):
    """Which part of each innovation's variance is the reading's own, (T, m)."""
    R = np.diagonal(model.R, axis1=-2, axis2=-1)
    S = np.diagonal(compact(track.innovation.cov, 3), axis1=-2, axis2=-1)
    R = R[-len(S) :] if R.ndim > 1 and len(S) > 1 else R
    return np.broadcast_to(R / S, track.innovation.mean.shape)


@dataclass(frozen=True)
class _Line:
    """A line of the card before its level is known."""

    what: str
    kind: str
    found: float
    count: int
    band: Around0 | Size | Share


def _judged(line, level):
    low, high = line.band.limits(level) if line.count >= FEWEST else (0.0, 0.0)
    return CardTest(line.what, line.kind, line.found, float(low), float(high), line.count)


def _innovations(name, y, share, doubt, kept):
    """Size, mean and neighbours of a column's innovations, in their own standard deviations.

    `doubt` is the relative variance of an R estimated from so few readings at rest, `share` is that of R in S. Where
    R is off, S is off by share + ¾ (1 − share) of that, for P⁻ of a constant velocity goes with R^¾; the size then
    has an F distribution, nearly. And the gain is off, so that neighbours are correlated by share (1 − share)/(1 +
    share) for each unit of ln R, as for a random walk.
    """
    N, share = len(y), _mean(share)
    moved, lever = doubt * (share + 0.75 * (1 - share)) ** 2, share * (1 - share) / (1 + share)
    white, alike = np.sqrt(1 / max(N, 1)), np.sqrt((max(N, 2) - 1) / (max(N, 2) * (max(N, 2) + 2)))
    near = Around0(np.hypot(alike, lever * doubt**0.5))
    return [
        _Line(f"size of innovations{name}", "size", _mean(y**2), N, Size(N, moved, kept)),
        _Line(f"mean of innovations{name}", "mean", _mean(y), N, Around0(white * np.sqrt(1 + moved))),
        _Line(f"neighbours{name}", "neighbours", neighbours(y[:, None]), N, near),
    ]


def _forecast(one, moved):
    """A forecast's line: a share of hidden readings against what chance allows."""
    if one.rival:
        return _Line(one.what, "rival", one.share, one.readings, Share(one.readings, one.honest, below=True))
    return _Line(one.what, "coverage", one.share, one.readings, Share(one.readings, one.honest, moved))


def fill(advice):
    """Advice in lines that fit below the card."""
    return textwrap.fill(advice, 76, initial_indent="  ", subsequent_indent="    ")


def _mean(values):
    return float(np.mean(values)) if len(values) else 0.0


def neighbours(y):
    """The correlation of neighbouring rows of y (T, m), without those that are NaN; within ±1.96/√(T m) it is white.

    One number for all components: the sum of the products by the sum of the squares. `whiteness` has one for each, the
    mean of the products by the mean of the squares.
    """
    power = np.nansum(y**2)
    return float(np.nansum(lagged_products(y, 1)) / power) if power else 0.0


def longest_run(flags):
    """The length of the longest run of True in flags (T,)."""
    ends = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(flags, dtype=int), [0]])))  # begin, end, begin, end …
    return int((ends[1::2] - ends[::2]).max(initial=0))
