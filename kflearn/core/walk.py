"""A recursion whose steps depend on symbols (was there a gap?), not on data: each distinct step is computed once."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np


@dataclass(frozen=True, eq=False)
class Walk:
    """The distinct steps, and which of them each step of a series is.

    parts: arrays (..., S, ·, ·) of what belongs to a step, or None. index: (..., T), rows of `parts`; None:
    row k belongs to step k, and the last row to all steps after it.
    """

    parts: Any
    index: np.ndarray | None = None

    def each(self, part, T):
        """One of the parts, or something with the same rows, for each step: (..., T, ·, ·)."""
        return pick(part, self.index, T)

    def rows(self, T):
        """The row of each step, (..., T)."""
        count = next(part for part in self.parts if part is not None).shape[-3]
        return np.minimum(np.arange(T), count - 1) if self.index is None else self.index


def pick(rows, index, T):
    """An array (..., S, ·, ·) made T long: by an index (..., T), or by repeating its last entry."""
    if index is not None and index.ndim > 1:
        return rows[index]
    if index is not None:  # most steps are alike: they are filled in at once
        common, others = commonest(index)
        out = np.empty((T, *rows.shape[1:]), rows.dtype)
        out[:] = rows[common]
        out[others] = rows[index[others]]
        return out
    rest = T - rows.shape[-3]
    if not rest:
        return rows
    last = rows[..., -1:, :, :]
    repeated = np.broadcast_to(last, (*last.shape[:-3], rest, *last.shape[-2:]))
    return np.concatenate([rows, repeated], axis=-3)


def commonest(index):
    """The row that most steps (T,) have, and the steps that have another one."""
    common = int(np.bincount(index).argmax())
    return common, np.flatnonzero(index != common)


LONG, MOST = 5000, 1000  # a series so long, with so many steps that differ, is better cut into blocks


def walk(symbols, start, step, same) -> Walk:
    """Follow carried_k = step(carried_{k-1}, symbol_k) through the symbols (..., T), whole numbers.

    step(carried, symbol) → carried, parts; it takes one carried array (n, n) with one symbol, or many (count, n, n)
    with symbols (count,). same(carried, before), (...), tells which have come to rest.
    """
    atlas = _Atlas(start, step, same, int(symbols.max()) + 1)
    runs = symbols.reshape(-1, symbols.shape[-1])
    if len(runs) > 1:
        index = atlas.many_runs(runs)
    else:
        index = atlas.one_run(runs[0], most=MOST if runs.size >= LONG else np.inf)
        if index is None:
            if (blocks := walk_in_blocks(runs[0], start, start, step, same, 3 * atlas.longest // 2)) is not None:
                return blocks
            index = atlas.one_run(runs[0])
    index = index.reshape(symbols.shape) - 1
    parts = tuple(None if part[0] is None else np.concatenate(part) for part in zip(*atlas.parts, strict=True))
    straight = np.minimum(np.arange(symbols.shape[-1]), atlas.count - 2)
    return Walk(parts, None if (index == straight).all() else index)


def walk_in_blocks(symbols, start, guess, step, same, shortest=64) -> Walk | None:
    """The same for one long series (T,) of which few steps are alike: cut into blocks that are computed side by side.

    Each block begins `shortest` steps early, at `guess`, and soon forgets what it began with. Where it really begins,
    it must agree with the end of the block before it: if not, the early start is made longer, and at last None is
    returned.
    """
    T = len(symbols)
    for early in (shortest, 2 * shortest, 4 * shortest, 16 * shortest):
        length = max(2 * early, int(np.sqrt(T)))
        count = T // length
        if count < 8:
            return None
        at = np.arange(count)[:, None] * length + np.arange(-early, length)
        carried, steps, ends = np.broadcast_to(guess, (count, *start.shape)).copy(), [], None
        for k, now in enumerate(symbols[np.maximum(at, 0)].T):
            if k == early:
                carried[0] = start
                begins = carried
            carried, parts = step(carried, now)
            if k >= early:
                steps.append(parts)
        ends = carried
        if same(begins[1:], ends[:-1]).all():
            return _joined(steps, symbols[count * length :], ends[-1], step)
    return None


def _joined(steps, symbols, carried, step):
    """Blocks side by side as one series, and what is left at its end."""
    rest = []
    for symbol in symbols:
        carried, parts = step(carried, symbol)
        rest.append(parts)
    joined = []
    for i, first in enumerate(steps[0]):
        if first is None:
            joined.append(None)
            continue
        blocks = np.stack([parts[i] for parts in steps], axis=1).reshape(-1, *first.shape[1:])
        joined.append(np.concatenate([blocks, np.array([parts[i] for parts in rest]).reshape(-1, *first.shape[1:])]))
    return Walk(tuple(joined))


class _Atlas:
    """All steps met so far, by number (0 is the start): what is carried after each, and which follows under a symbol.

    Two steps may end alike and yet differ: state[number] is the first step that ended as this one did.
    """

    def __init__(self, start, step, same, symbols):
        self.step, self.same, self.parts = step, same, []
        self.carried, self.state, self.count = np.array([start]), np.zeros(1, np.int64), 1
        self.symbols, self.follows = symbols, {}  # {state * symbols + symbol: the step that follows}
        self.longest = 64  # so many steps, at least, to forget where one came from
        self.rest, self.last = {}, {}  # under each symbol, the state at rest, and the last new one: there may be cycles

    def one_run(self, symbols, most=np.inf):
        """The steps along one run (T,), whole stretches of one symbol at a time; None where they exceed `most`."""
        index = np.empty(len(symbols), np.int32)
        cuts = [0, *(np.flatnonzero(np.diff(symbols)) + 1).tolist(), len(symbols)]
        state, paths = 0, {}
        for begin, end in pairwise(cuts):
            symbol = int(symbols[begin])
            path = paths.setdefault((state, symbol), [])
            self._extend(path, state, symbol, end - begin)
            path = path[: end - begin]
            index[begin : begin + len(path)] = path
            index[begin + len(path) : end] = path[-1]
            state = int(self.state[index[end - 1]])
            if self.count > most:
                return None
        return index

    def _extend(self, path, state, symbol, length):
        """Make a path under one symbol `length` long, or until it comes to rest."""
        while len(path) < length:
            state = int(self.state[path[-1]]) if path else state
            after = self.follows.get(state * self.symbols + symbol)
            if after is None:
                after = self.follows[state * self.symbols + symbol] = self._one(state, symbol)
            if path and after == path[-1]:
                self.longest = max(self.longest, len(path))
                return
            path.append(after)

    def _one(self, state, symbol):
        """Compute the step that follows a state; return its number."""
        carried, parts = self.step(self.carried[state], symbol)
        number = self._enter(carried[None], [None if part is None else part[None] for part in parts])
        for known in {self.rest.get(symbol), self.last.get(symbol)} - {None}:
            before = self.carried[known]
            # A quick look at the first entry: most differ there.
            if abs(carried[0, 0] - before[0, 0]) <= 1e-14 * abs(carried[0, 0]) and self.same(carried, before):
                self.state[number] = known
                if known == state:
                    self.rest[symbol] = known
                return number
        self.last[symbol] = number
        return number

    def many_runs(self, symbols):
        """The steps along many runs (runs, T): one after the other, what is new of all runs at once."""
        if symbols.shape[-1] > 1:  # most runs come back after a gap to where they rest without one
            self._extend([], 0, int(np.bincount(symbols.ravel()).argmax()), symbols.shape[-1])
        index = np.empty(symbols.shape, np.int32)
        here = np.zeros(len(symbols), np.int64)
        for k, now in enumerate(symbols.T):
            keys, which = np.unique(here * self.symbols + now, return_inverse=True)
            new = [key for key in keys.tolist() if key not in self.follows]
            if new:
                self._many(np.array(new, np.int64))
            index[:, k] = np.array([self.follows[key] for key in keys.tolist()])[which]
            here = self.state[index[:, k]]  # of 64 bits: keys may be large
        return index

    def _many(self, keys):
        """Compute the steps that follow many pairs of state and symbol."""
        states, symbols = np.divmod(keys, self.symbols)
        carried, parts = self.step(self.carried[states], symbols)
        first = self._enter(carried, parts)
        for symbol, rest in self.rest.items():
            self.state[first : self.count][(symbols == symbol) & self.same(carried, self.carried[rest])] = rest
        self.follows.update(zip(keys.tolist(), range(first, self.count), strict=True))

    def _enter(self, carried, parts):
        """Take new steps (count, n, n) in; return the number of the first."""
        first, self.count = self.count, self.count + len(carried)
        if self.count > len(self.carried):
            more = max(len(self.carried), len(carried))
            self.carried = np.concatenate([self.carried, np.empty((more, *self.carried.shape[1:]))])
            self.state = np.concatenate([self.state, np.arange(len(self.state), len(self.state) + more)])
        self.carried[first : self.count] = carried
        self.parts.append(parts)
        return first


def same_covariance(P, before):
    """Is it the same covariance? Judged against its own variances, a few roundings wide."""
    variance = np.diagonal(P, axis1=-2, axis2=-1)
    return _within(P - before, np.sqrt(abs(variance[..., :, None] * variance[..., None, :])))


def same_root(L, before):
    """Is it the same root of a covariance? Judged against its own standard deviations."""
    return _within(L - before, np.sqrt(np.sum(L * L, axis=-1, keepdims=True)))


def _within(change, scale):
    return (abs(change) <= 1e-14 * scale).all(axis=(-2, -1))
