"""What a filter with a known F and Q does wrongly, read from its means and covariances step by step; for the signs of open exercises.

A scene is what a filter returned for one recording, beside what should have been done in each step but the first.
Nothing is said of a smoother: in steps without a reading its P does not follow from the P before.
"""

from typing import NamedTuple

import numpy as np

from kflearn.exercises._inside import used_R
from kflearn.exercises._results import pair
from kflearn.exercises._shown import show


class Scene(NamedTuple):
    """The means (T, n) and covariances (T, n, n) of a filter; and of each step but the first F, Q, a push, and the readings."""

    mean: np.ndarray
    cov: np.ndarray
    F: np.ndarray
    Q: np.ndarray
    push: np.ndarray
    H: np.ndarray
    z: np.ndarray

    @property
    def empty(self):
        """The steps without a reading."""
        return np.isnan(self.z).any(axis=1)

    @property
    def ahead(self):
        """The mean and the covariance that should be predicted."""
        return (self.F @ self.mean[:-1, :, None])[..., 0] + self.push, self.F @ self.cov[:-1] @ self.F.mT + self.Q

    @property
    def grown(self):
        """What P grows by beyond F P Fᵀ in the steps without a reading."""
        return (self.cov[1:] - self.F @ self.cov[:-1] @ self.F.mT)[self.empty]


TAKEN_OFF = "Is too much taken off, in P by a correction, or in an R that is worked out by a difference? Or does a Q below zero come in?"


def negative(scenes, rows, cause=TAKEN_OFF):
    """A variance below zero."""
    for number, scene in enumerate(scenes, 1):
        bad = np.argwhere(np.diagonal(scene.cov, axis1=1, axis2=2) < 0)
        if len(bad):
            where = f"in {rows[:-1]} {bad[0, 0] + 1}"
            return f"In recording {number} your P has a negative variance {where}, which no covariance has. {cause}"
    return None


OTHERS = {
    "P + Q, without F": lambda F, P: P,
    "Fᵀ P F + Q": lambda F, P: F.mT @ P @ F,
    "F P + Q, without Fᵀ": lambda F, P: F @ P,
    "F P F + Q, the second F not transposed": lambda F, P: F @ P @ F,
}


def predicted(scenes, rows):
    """P is predicted by another formula."""
    for name, other in OTHERS.items():
        pairs = [(s.cov[1:][s.empty], (other(s.F, s.cov[:-1]) + s.Q)[s.empty]) for s in scenes]
        if all(np.allclose(P, wanted, rtol=1e-6, atol=1e-9 * abs(wanted).max()) for P, wanted in pairs):
            return f"In the {rows} without a reading your P is predicted as {name}. It is F P Fᵀ + Q."
    return None


def rooted(scenes, rows):
    """The squares of what is returned are the covariances of a filter."""
    near = []
    for scene in scenes:
        square = scene._replace(cov=np.square(scene.cov))
        found, wanted = (
            np.diagonal(part[square.empty], axis1=1, axis2=2) for part in (square.cov[1:], square.ahead[1])
        )
        near.append(abs(found - wanted) < 0.01 * wanted)
    if np.mean(np.concatenate(near)) > 0.8:
        return f"What you return for P is its root, entry by entry: in the {rows} without a reading it grows as a σ does. Return P itself."
    return None


def read_in_gaps(scenes, rows):
    """P becomes smaller where nothing was read."""
    pairs = [(s.H @ s.grown @ s.H.T, s.H @ s.ahead[1][s.empty] @ s.H.T) for s in scenes]
    traces = [np.trace(more, axis1=1, axis2=2) < -0.01 * np.trace(whole, axis1=1, axis2=2) for more, whole in pairs]
    less = np.concatenate(traces)
    if less.mean() > 0.05:
        return (
            f"In {less.sum()} of the {len(less)} {rows} without a reading your P is smaller than F P Fᵀ, as if something had been read: is a NaN "
            "taken for a number, such as 0, or is a correction done there?"
        )
    return None


def growth(scenes, rows, remark=""):
    """P grows by something else than Q, in steps without a reading."""
    grown, wanted = (np.concatenate(part) for part in zip(*[(s.grown, s.Q[s.empty]) for s in scenes], strict=True))
    sizes, off = np.linalg.norm(wanted, axis=(1, 2)), np.linalg.norm(grown - wanted, axis=(1, 2))
    if np.all(off < 1e-3 * sizes):
        return None
    if np.linalg.eigvalsh((grown + grown.mT) / 2).min() < -1e-6 * abs(grown).max():  # a smoother, or no covariances
        return None
    factors = np.sum(grown * wanted, axis=(1, 2)) / sizes**2
    rest = np.linalg.norm(grown - factors[:, None, None] * wanted, axis=(1, 2))
    if np.all(rest < 0.01 * np.linalg.norm(grown, axis=(1, 2))):
        low, high = np.quantile(factors, [0.1, 0.9])
        often = f"{low:.2g} times" if high < 1.02 * low else f"{low:.2g} to {high:.2g} times (in most of them)"
        return f"In the {rows} without a reading your P grows by {often} the Q that belongs there, beyond F P Fᵀ. {remark}".rstrip()
    at = np.argmax(off / sizes)
    there = [show(np.where(abs(part[at]) > 1e-9 * sizes[at], part[at], 0)[:2, :2], 3) for part in (grown, wanted)]
    corner = " (upper left corner)" if wanted.shape[-1] > 2 else ""
    return f"In one of the {rows} without a reading your P grows by {there[0]}{corner} beyond F P Fᵀ, where Q is {there[1]}. {remark}".rstrip()


def turns(scene):
    """How far the state moves, in units of what K y would be with the K that made P smaller; and where it moves and P does not."""
    (x, P), seen = scene.ahead, ~scene.empty
    R = used_R(scene.cov, scene.F, scene.Q, scene.H)
    way, y = (scene.mean[1:] - x)[seen], (scene.z - x @ scene.H.T)[seen]
    moved = abs(way).max(axis=1) > 1e-9 * (1 + abs(y).max(axis=1))
    S = scene.H @ P @ scene.H.T + np.where(np.isinf(R), 1, R)[:, None, None] * np.eye(len(scene.H))
    right = ((P @ scene.H.T @ np.linalg.inv(S))[seen] @ y[..., None])[..., 0]
    parts = np.sum(way * right, axis=1) / np.sum(right**2, axis=1)
    return parts[np.isfinite(R[seen])], (np.isinf(R[seen]) & moved)[np.isinf(R[seen]) | moved]


def gain(scenes, rows, reading):
    """The mean does not move by the gain that made P smaller. Only where P is predicted rightly."""
    if not all(np.allclose(s.grown, s.Q[s.empty], rtol=1e-3, atol=1e-3 * abs(s.Q).max()) for s in scenes):
        return None
    parts, unmoved = (np.concatenate(part) for part in zip(*map(turns, scenes), strict=True))
    if np.mean(unmoved) > 0.5:
        return (
            f"Your {reading}s move the state, but P is not made smaller by them: after a {reading} it is (I − K H) P."
        )
    if not len(parts) or np.mean(abs(parts - 1) < 0.01) > 0.5:
        return None
    if np.mean(abs(parts + 1) < 0.01) > 0.5:
        return f"Your state moves away from the {reading}s: the innovation is z − H x."
    back = [np.linalg.inv(s.F[0]) for s in scenes]
    earlier = [s._replace(cov=F @ (s.cov - s.Q[0]) @ F.T) for s, F in zip(scenes, back, strict=True)]
    if np.mean(abs(np.concatenate([turns(s)[0] for s in earlier]) - 1) < 0.01) > 0.9:
        return f"Your P is predicted once more before you store it: return x and P after the correction, of the same {rows[:-1]}."
    return (
        "In many steps your state does not move by K (z − H x) with the K that makes your P smaller. In a single filter x and P get "
        "the same K, and P becomes (I − K H) P. In a bank, or behind a gate that is far too narrow, that is not so."
    )


def sign(check, scenes, *words, z_at=0, of_filters_only=False):
    """A sign from a check of scenes; perhaps one that says nothing of results that look ahead."""

    def found(answer, answers, recordings):
        said = check(scenes(answers, recordings), *words)
        return None if said and of_filters_only and looks_ahead(answer, answers[0], recordings[0][0], z_at) else said

    return found


def looks_ahead(answer, result, inputs, z_at):
    """Whether the first half of a result changes when the later readings are taken away, as it does in a smoother."""
    z = inputs[z_at].copy()
    half = len(z) // 2
    z[half:] = np.nan
    again = pair(answer(*inputs[:z_at], z, *inputs[z_at + 1 :]))[0]
    return not np.allclose(again[:half], pair(result)[0][:half], rtol=1e-9)
