"""A tracker: it does not know how many targets there are. Tracks start from readings, are confirmed, and end."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..core.frozen import Frozen, freeze
from ..core.matrices import matvec
from ..filters.moments import linearize
from ..filters.steps import predicted_belief, starting_belief
from ..models import checks as check
from ..models.arguments import check_belief, check_functions, check_model, check_stacks
from ..models.gaussian import Gaussian, unchecked_gaussian
from .assign import HOW, assigned
from .filters import mixed, one_each
from .pairs import check_sensor, compare, gate_limit, scan_readings


@dataclass(frozen=True, eq=False, repr=False)
class Tracks(Frozen):
    """All tracks of a recording in M slots; a slot is used again when its track has ended.

    Attributes
    ----------
    mean, cov : ndarray (..., T, M, n), (..., T, M, n, n)
        The belief after each scan; NaN where a slot is empty.
    label : ndarray of int (..., T, M)
        The number of the track in the slot, counted from 0 in each run; -1 where it is empty.
    confirmed : ndarray of bool (..., T, M)
        Whether M of N readings have confirmed the track.
    used : ndarray of int (..., T, M)
        The reading that the track got in this scan, -1 for none.
    score : ndarray (..., T, M)
        The logarithm of how much more probable the readings of the track are from a target than from clutter, since
        the scan after its first; NaN where a slot is empty.
    """

    mean: np.ndarray
    cov: np.ndarray
    label: np.ndarray
    confirmed: np.ndarray
    used: np.ndarray
    score: np.ndarray

    def __post_init__(self):
        freeze([self.mean, self.cov, self.label, self.confirmed, self.used, self.score])

    @property
    def estimates(self) -> np.ndarray:
        """The means of the confirmed tracks alone, (..., T, M, n), NaN elsewhere: what the tracker tells."""
        return np.where(self.confirmed[..., None], self.mean, np.nan)

    def __repr__(self):
        *batch, T, M, n = self.mean.shape
        runs = f", batch={tuple(batch)}" if batch else ""
        count = self.confirmed.sum(axis=-1).mean()
        return f"Tracks(T={T} steps, M={M} slots, n={n} states{runs}; confirmed tracks a step: {count:.2f})"


class Rules(NamedTuple):
    """What does not change while a tracker runs; the names are those of its arguments."""

    model: object
    birth: Gaussian
    detection: float
    clutter: float
    gate: float
    limit: float
    confirm: tuple[int, int]
    patience: int
    how: str


class Live(NamedTuple):
    """The slots (runs, M) after a scan. recent: which of the last N scans had a reading for the track, (runs, M, N)."""

    mean: np.ndarray
    cov: np.ndarray
    label: np.ndarray
    confirmed: np.ndarray
    used: np.ndarray
    score: np.ndarray
    age: np.ndarray
    missed: np.ndarray
    recent: np.ndarray

    @property
    def alive(self):
        return self.label >= 0


def tracker(model, z, birth, *, detection, clutter, gate=0.99, confirm=(2, 3), patience=3, how="global") -> Tracks:
    """Track an unknown number of targets: global nearest neighbour, with tracks that start and end by counting.

    Each scan is assigned to the tracks. Every reading that is left starts a track, which is tentative. It is confirmed
    as soon as M of the last N scans had a reading for it, and dropped as soon as this can no longer happen in its first
    N scans. A confirmed track ends after `patience` scans in a row without a reading.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states and m components of a reading; of every target.
    z : array_like (..., T, N, m)
        Scans; a row of NaN is no reading.
    birth : Gaussian
        The belief about a new target before its first reading: wide where nothing is known, e.g. of its position, and
        as wide as targets are fast in its velocity.
    detection, clutter, gate, how
        As in gnn_filter.
    confirm : tuple of two int
        (M, N): the first reading counts as one.
    patience : int
        How many misses in a row end a confirmed track.

    Returns
    -------
    Tracks
        .estimates are the means of the confirmed tracks (..., T, M, n), NaN elsewhere.

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Sittler 1964 (the score); Blackman and Popoli 1999, *Design and Analysis of Modern Tracking Systems*.

    Examples
    --------
    >>> from kflearn import Gaussian, random_walk, tracker
    >>> scans = [[[53.0], [80.0]], [[20.0], [56.0]], [[54.0], [5.0]]]
    >>> tracks = tracker(random_walk(1, 9), scans, Gaussian(50, 1e4), detection=0.9, clutter=0.01)
    >>> print(tracks.confirmed.sum(axis=-1), f"{tracks.estimates[-1, 0, 0]:.1f}")
    [0 1 1] 54.4
    """
    z, rules = _checked(model, z, birth, (detection, clutter), gate, confirm, patience, how)
    runs = z.reshape(-1, *z.shape[-3:])
    live, told = _empty(rules, len(runs), 1), []
    next_label = np.zeros(len(runs), int)
    for k in range(runs.shape[1]):
        live = _kept(_updated(live, runs[:, k], k, rules), rules)
        live, next_label = _born(live, runs[:, k], k, next_label, rules)
        told.append(live)
    return _tracks(told, rules, z.shape[:-3])


def _checked(model, z, birth, sensor, gate, confirm, patience, how):
    check_model(model)
    check_belief("birth", birth, model)
    if birth.batch:
        raise ValueError(f"birth must be one belief for all new targets, got batch axes {birth.batch}")
    z = scan_readings(model, z, (None, None, model.m))
    check.batches(z=z.shape[:-3], **check_stacks(model, z.shape[-3]))
    check_functions(model, birth.mean, None, birth.std)
    check_sensor(*sensor)
    if not isinstance(confirm, (tuple, list)) or len(confirm) != 2:
        raise ValueError(f"confirm must be two whole numbers (M, N), such as (2, 3), got {confirm!r}")
    M = check.whole_number("M of confirm", confirm[0])
    N = check.whole_number("N of confirm", confirm[1], least=M)
    patience = check.whole_number("patience", patience)
    limit = gate_limit(gate, model.m)
    return z, Rules(model, birth, *sensor, gate, limit, (M, N), patience, check.word("how", how, HOW))


def _empty(rules, runs, M):
    """M empty slots in each run, which hold the belief of a birth."""
    belief, slots = starting_belief(rules.birth, (runs, M)), (runs, M)
    no, zero = np.zeros(slots, bool), np.zeros(slots, int)
    recent = np.zeros((*slots, rules.confirm[1]), bool)
    return Live(belief.mean, belief.cov, zero - 1, no, zero - 1, np.full(slots, np.nan), zero, zero, recent)


def _updated(live, scan, k, rules):
    """Predict all tracks, assign the readings of the scan, correct."""
    predicted = predicted_belief(rules.model, unchecked_gaussian(live.mean, live.cov), None, k, linearize)
    pairs = compare(rules.model, predicted, scan[:, None], k, rules.gate, rules.limit)
    ratio = np.where(live.alive[..., None], pairs.log_ratio(rules.detection, rules.clutter), -np.inf)
    used = assigned(-ratio, 0.0, rules.how)
    hit = used >= 0
    belief = mixed(pairs, one_each(used, ratio.shape[-1]))
    gained = np.take_along_axis(ratio, np.maximum(used, 0)[..., None], axis=-1)[..., 0]
    score = live.score + np.log(1 - rules.detection * rules.gate) + np.where(hit, gained, 0)
    recent = np.concatenate([live.recent[..., 1:], hit[..., None]], axis=-1)
    missed = np.where(hit, 0, live.missed + 1)
    return Live(belief.mean, belief.cov, live.label, live.confirmed, used, score, live.age + 1, missed, recent)


def _kept(live, rules):
    """Confirm tracks by M of N, and empty the slots of those that end."""
    M, N = rules.confirm
    hits = live.recent.sum(axis=-1)
    confirmed = live.alive & (live.confirmed | (hits >= M))
    hopeless = live.age - hits > N - M
    keep = live.alive & np.where(confirmed, live.missed < rules.patience, ~hopeless)
    return _chosen(keep, live._replace(confirmed=confirmed), _empty(rules, *keep.shape))


def _chosen(keep, live, other):
    """`live` where `keep` (runs, M), else `other`."""
    return Live(
        *(np.where(keep.reshape(*keep.shape, *[1] * (a.ndim - 2)), a, b) for a, b in zip(live, other, strict=True))
    )


def _born(live, scan, k, next_label, rules):
    """Every reading that no track got starts one, in a free slot; slots are added where there are too few."""
    taken = (live.used[..., None] == np.arange(scan.shape[1])).any(axis=1)
    new = ~np.isnan(scan).any(axis=-1) & ~taken
    short = (live.alive.sum(axis=1) + new.sum(axis=1)).max() - live.label.shape[1]
    if short > 0:
        more = _empty(rules, len(scan), short)
        live = Live(*(np.concatenate([a, b], axis=1) for a, b in zip(live, more, strict=True)))
    free = np.argsort(live.alive, axis=1, kind="stable")  # the free slots first
    rank = np.cumsum(new, axis=1) - 1  # the new readings of a run in order: 0, 1, …
    run, reading = np.nonzero(new)
    slot = free[run, rank[run, reading]]
    pairs = compare(rules.model, starting_belief(rules.birth, (len(scan),)), scan, k, rules.gate, rules.limit)
    mean = rules.birth.mean + matvec(pairs.gain[run], pairs.innovation[run, reading])
    fields = Live(*(array.copy() for array in live))
    fields.mean[run, slot], fields.cov[run, slot] = mean, pairs.corrected[run]
    fields.label[run, slot], fields.used[run, slot] = next_label[run] + rank[run, reading], reading
    fields.score[run, slot], fields.age[run, slot], fields.missed[run, slot] = 0.0, 1, 0
    fields.confirmed[run, slot], fields.recent[run, slot] = rules.confirm[0] == 1, False
    fields.recent[run, slot, -1] = True
    return fields, next_label + new.sum(axis=1)


def _tracks(told, rules, batch):
    """The slots of all steps, as many in each as in the last."""
    M = told[-1].label.shape[1]

    def along(name, empty):
        whole = np.full((len(told[0].label), len(told), M, *getattr(told[0], name).shape[2:]), empty)
        for k, live in enumerate(told):
            shown = getattr(live, name)
            keep = live.alive.reshape(*live.alive.shape, *[1] * (shown.ndim - 2))
            whole[:, k, : shown.shape[1]] = np.where(keep, shown, empty)
        return whole.reshape(*batch, *whole.shape[1:])

    empty = dict(mean=np.nan, cov=np.nan, label=-1, confirmed=False, used=-1, score=np.nan)
    return Tracks(*(along(name, value) for name, value in empty.items()))
