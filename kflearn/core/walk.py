"""A recursion whose steps depend on symbols (was there a gap?), not on data: each distinct step is computed once."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np


class Walk(NamedTuple):
    """The distinct steps, and which of them each step of a series is.

    parts: arrays (..., S, ·, ·) of what belongs to a step, or None. index: (..., T), rows of `parts`; None:
    row k belongs to step k, and the last row to all steps after it.
    """

    parts: tuple
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
    if index is not None:
        return rows[index]
    rest = T - rows.shape[-3]
    if not rest:
        return rows
    last = rows[..., -1:, :, :]
    repeated = np.broadcast_to(last, (*last.shape[:-3], rest, *last.shape[-2:]))
    return np.concatenate([rows, repeated], axis=-3)


def walk(symbols, start, step, same) -> Walk:
    """Follow carried_k = step(carried_{k-1}, symbol_k) through the symbols (..., T), whole numbers.

    step(carried, symbol) → carried, parts; it takes one carried array (n, n) with one symbol, or many (count, n, n)
    with symbols (count,). same(carried, before), (...), tells which have come to rest.
    """
    atlas = _Atlas(start, step, same, int(symbols.max()) + 1)
    runs = symbols.reshape(-1, symbols.shape[-1])
    index = (atlas.one_run(runs[0]) if len(runs) == 1 else atlas.many_runs(runs)).reshape(symbols.shape) - 1
    parts = tuple(None if part[0] is None else np.concatenate(part) for part in zip(*atlas.parts, strict=True))
    straight = np.minimum(np.arange(symbols.shape[-1]), atlas.count - 2)
    return Walk(parts, None if (index == straight).all() else index)


class _Atlas:
    """All states met so far, by number (0 is the start), and which of them follows which under which symbol."""

    def __init__(self, start, step, same, symbols):
        self.step, self.same, self.count, self.parts = step, same, 1, []
        self.carried = np.array([start])
        self.symbols, self.follows = symbols, {}  # {state * symbols + symbol: the next state}
        self.rest, self.last = {}, {}  # under each symbol, the state at rest, and the last new one: there may be cycles

    def one_run(self, symbols):
        """The states along one run (T,): whole stretches of one symbol at a time."""
        index = np.empty(len(symbols), int)
        cuts = [0, *(np.flatnonzero(np.diff(symbols)) + 1).tolist(), len(symbols)]
        state, paths = 0, {}
        for begin, end in pairwise(cuts):
            symbol = int(symbols[begin])
            path = paths.setdefault((state, symbol), [])
            self._extend(path, state, symbol, end - begin)
            path = path[: end - begin]
            index[begin : begin + len(path)] = path
            index[begin + len(path) : end] = path[-1]
            state = int(index[end - 1])
        return index

    def _extend(self, path, state, symbol, length):
        """Make a path under one symbol `length` long, or until it comes to rest."""
        while len(path) < length:
            last = path[-1] if path else state
            after = self.follows.get(last * self.symbols + symbol)
            if after is None:
                after = self.follows[last * self.symbols + symbol] = self._one(last, symbol)
            if path and after == last:
                return
            path.append(after)

    def _one(self, state, symbol):
        """Compute the state that follows; return its number, an old one where it was here before."""
        carried, parts = self.step(self.carried[state], symbol)
        for number in {self.rest.get(symbol), self.last.get(symbol)} - {None}:
            before = self.carried[number]
            # A quick look at the first entry: most states differ there.
            if abs(carried[0, 0] - before[0, 0]) <= 1e-14 * abs(carried[0, 0]) and self.same(carried, before):
                if number == state:
                    self.rest[symbol] = number
                return number
        number = self._enter(carried[None], [None if part is None else part[None] for part in parts])
        self.last[symbol] = number
        return number

    def many_runs(self, symbols):
        """The states along many runs (runs, T): step by step, what is new of all runs at once."""
        if symbols.shape[-1] > 1:
            self._settle(symbols)
        index = np.empty(symbols.shape, int)
        here = np.zeros(len(symbols), int)
        for k, now in enumerate(symbols.T):
            keys = here * self.symbols + now
            new = [key for key in set(keys.tolist()) if key not in self.follows]
            if new:
                self._many(np.sort(new))
            index[:, k] = here = np.array([self.follows[key] for key in keys.tolist()])
        return index

    def _settle(self, symbols):
        """Find where a run comes to rest under the commonest symbol: most runs come back to it after a gap."""
        common = int(np.bincount(symbols.ravel()).argmax())
        self._extend([], 0, common, symbols.shape[-1])

    def _many(self, keys):
        """Compute the states that follow many pairs of state and symbol."""
        states, symbols = np.divmod(keys, self.symbols)
        carried, parts = self.step(self.carried[states], symbols)
        numbers = np.full(len(states), -1)
        for symbol, rest in self.rest.items():
            numbers[(symbols == symbol) & self.same(carried, self.carried[rest])] = rest
        new = numbers < 0
        if new.any():
            first = self._enter(carried[new], [None if part is None else part[new] for part in parts])
            numbers[new] = np.arange(first, self.count)
        self.follows.update(zip(keys.tolist(), numbers.tolist(), strict=True))

    def _enter(self, carried, parts):
        """Take new states (count, n, n) in; return the number of the first."""
        first, self.count = self.count, self.count + len(carried)
        if self.count > len(self.carried):
            more = max(len(self.carried), len(carried))
            self.carried = np.concatenate([self.carried, np.empty((more, *self.carried.shape[1:]))])
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
