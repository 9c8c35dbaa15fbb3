"""The top of many functions of a few parameters, from values beside each point: Newton's steps, kept short."""

from functools import partial
from typing import NamedTuple

import numpy as np

LEAST = 1e-3  # what a direction bends is taken to be at least this
WIDTH = 1e-3  # how far beside a point values are taken
LONGEST, ROUNDS, ENOUGH = 2.0, 100, 1e-10  # of a step; how many; how much more a step must promise to be made


class Hill(NamedTuple):
    """A function at points (N, p): value (N,), slope (N, p), and the matrix of second derivatives (N, p, p)."""

    value: np.ndarray
    slope: np.ndarray
    bend: np.ndarray

    @classmethod
    def around(cls, function, at) -> "Hill":
        """From values at and beside the points `at` (N, p). function: (M, N, p) → (M, N)."""
        p = at.shape[-1]
        pairs = [(i, j) for i in range(p) for j in range(i)]
        shifts = np.concatenate([np.eye(p), *(np.eye(p)[[i]] + np.eye(p)[[j]] for i, j in pairs)]) * WIDTH
        values = function(at + np.concatenate([0 * shifts[:1], shifts, -shifts])[:, None])
        middle, (up, down) = values[0], np.split(values[1:], 2)
        # a point that cannot be (−inf): the function is taken to be flat there
        up, down = (np.where(np.isfinite(side), side, middle) for side in (up, down))
        square = (up + down - 2 * middle).T
        bend = np.empty((len(at), p, p))
        bend[:, range(p), range(p)] = square[:, :p] / WIDTH**2
        for number, (i, j) in enumerate(pairs, p):
            mixed = (square[:, number] - square[:, i] - square[:, j]) / (2 * WIDTH**2)
            bend[:, i, j] = bend[:, j, i] = mixed
        return cls(middle.copy(), ((up - down)[:p].T / (2 * WIDTH)), bend)

    def of(self, which) -> "Hill":
        """Those of some of the points."""
        return Hill(*(part[which] for part in self))

    def steps(self, least):
        """Newton's steps (N, p), along directions that bend the wrong way or too little as if they bent by `least`."""
        size, along = np.linalg.eigh(self.bend)
        ahead = np.matvec(along.mT, self.slope) / np.maximum(abs(size), least[:, None])
        return np.matvec(along, ahead)


class Peaks(NamedTuple):
    """Where a climb ended: points (N, p), whether each is a top, (N,), and the hill there. Can be written into."""

    at: np.ndarray
    reached: np.ndarray
    hill: Hill

    def put(self, which, others):
        """Set some of the points (indices), and all that is known of them, to those of other peaks."""
        for old, new in zip(
            (self.at, self.reached, *self.hill), (others.at, others.reached, *others.hill), strict=True
        ):
            old[which] = new


def climb(function, start) -> Peaks:
    """The highest points (N, p) that lie uphill of the points `start`.

    function: (points (M, n, p), which of the N functions, n indices) → (M, n), in coordinates in which a step of 1 is a
    fair one. A point that is flat to within what can be computed counts as reached.
    """
    at, damping, going = np.array(start, float), np.full(len(start), LEAST), np.arange(len(start))
    hill = Hill.around(partial(function, which=going), at)
    for _ in range(ROUNDS):
        here = hill.of(going)
        step = here.steps(damping[going])
        step *= (LONGEST / np.maximum(abs(step).max(axis=-1), LONGEST))[:, None]
        more = 0.5 * np.sum(step * here.slope, axis=-1) > ENOUGH
        going, step = going[more], step[more]
        if not len(going):
            break
        there = Hill.around(partial(function, which=going), at[going] + step)
        better = there.value >= hill.value[going]
        risen = going[better]
        at[risen] += step[better]
        for old, new in zip(hill, there.of(better), strict=True):
            old[risen] = new
        damping[going] = np.clip(damping[going] * np.where(better, 0.1, 10), LEAST, None)
    return Peaks(at, ~np.isin(np.arange(len(at)), going), hill)
