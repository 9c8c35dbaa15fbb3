"""Lesson 16, `figures`: wrong answers, each with the sentence that it gets."""

import numpy as np


def three(error):
    """The squared lengths of position, velocity and acceleration errors: three arrays (runs, T)."""
    return [np.sum(error[..., k : k + 3] ** 2, axis=-1) for k in (0, 3, 6)]


def squares_inside(third):
    """The root of the mean norm of squared errors."""
    return lambda e: [np.sqrt(np.linalg.norm(e[..., k : k + 3] ** 2, axis=-1).mean(axis=0)) for k in (0, 3, third)]


WRONG = {
    "as published": (
        lambda e: [np.sqrt(s).mean(axis=0) for s in (three(e)[0], three(e)[1], three(e)[1])],
        "Both published faults are still there: mean distances, and a third series that is the velocity's.",
    ),
    "only the third mended": (
        lambda e: [np.sqrt(s).mean(axis=0) for s in three(e)],
        "The third series is mended. But these are mean distances: square first, then the mean, and the root last.",
    ),
    "only the RMS mended": (
        lambda e: [np.sqrt(s.mean(axis=0)) for s in (three(e)[0], three(e)[1], three(e)[1])],
        "The RMS is mended. But your third series is still the velocity's: the acceleration has the indices 6 to 8.",
    ),
    "per axis": (
        lambda e: [np.sqrt(s.mean(axis=0) / 3) for s in three(e)],
        "That is the RMS *per axis*, smaller by √3. Sum the squares over the three axes, and average over the runs only.",
    ),
    "every third": (
        lambda e: [np.sqrt(np.mean(np.sum(e[..., k::3] ** 2, axis=-1), axis=0)) for k in (0, 1, 2)],
        "Each series has one state of the position, one of the velocity and one of the acceleration, as with `k::3`. "
        "The three of a kind stand side by side: `k : k + 3`.",
    ),
    "in the wrong order": (
        lambda e: [np.sqrt(s.mean(axis=0)) for s in three(e)[::-1]],
        "The three series are right, in the wrong order: position, velocity, acceleration.",
    ),
    "the worst": (
        lambda e: [np.sqrt(s.max(axis=0)) for s in three(e)],
        "That is the worst run at each step. Asked is the root of the *mean* of the squares over the runs.",
    ),
    "no root": (
        lambda e: [s.mean(axis=0) for s in three(e)],
        "These are mean squares: the root is missing.",
    ),
    "over time": (
        lambda e: [np.sqrt(s.mean(axis=1)) for s in three(e)],
        "You averaged over the time, axis 1, which gives one number a run. Asked is one a step: average over the runs, axis 0.",
    ),
    "over everything": (
        lambda e: [np.sqrt(s.mean()) for s in three(e)],
        "You averaged over runs and time. Asked is a series: average over the runs, axis 0, only.",
    ),
    "length of the mean": (
        lambda e: [np.linalg.norm(e[..., k : k + 3].mean(axis=0), axis=-1) for k in (0, 3, 6)],
        "You averaged the errors before squaring them: errors to the left and to the right cancel, and only the bias is left.",
    ),
    "sums": (
        lambda e: [np.sqrt(s.sum(axis=0)) for s in three(e)],
        "You summed over the runs: more runs would make the error larger. Take the mean.",
    ),
    "for each state": (
        lambda e: np.moveaxis(np.sqrt(np.mean(e**2, axis=0)), -1, 0),
        "That is one series for each of the nine states. Put three axes together: add their squares.",
    ),
    "spread": (
        lambda e: [np.sqrt(sum(e[..., k + i].var(axis=0) for i in range(3))) for k in (0, 3, 6)],
        "The mean is taken away here, as by `var` and `std`: a filter that is off by the same kilometre in every run "
        "would score 0.",
    ),
    "one column each": (
        lambda e: np.stack([np.sqrt(s.mean(axis=0)) for s in three(e)], axis=-1),
        "The numbers are right; hand them back as three series, each (T,), not as T rows of three.",
    ),
    "for each run": (
        lambda e: [np.sqrt(s) for s in three(e)],
        "These are the distances of each run. The mean of their squares over the runs is missing, before the root.",
    ),
    "nine rows": (
        lambda e: np.sqrt(np.mean(e**2, axis=0)),
        "That is one column for each of the nine states. Put three axes together: add their squares before the mean.",
    ),
    "two series": (
        lambda e: [np.sqrt(s.mean(axis=0)) for s in three(e)[:2]],
        "The first two are right; the third series, the acceleration's (indices 6 to 8), is missing.",
    ),
    "one axis": (
        lambda e: [np.sqrt(np.mean(e[..., k] ** 2, axis=0)) for k in (0, 3, 6)],
        "You took the first axis of each alone. Position, velocity and acceleration have three axes each: add their squares.",
    ),
    "two axes": (
        lambda e: [np.sqrt(np.mean(np.sum(e[..., k : k + 2] ** 2, axis=-1), axis=0)) for k in (0, 3, 6)],
        "Two axes of three are in it, as with `k : k + 2`, which ends before k + 2.",
    ),
    "root of the mean distance": (
        lambda e: [np.sqrt(np.sqrt(s).mean(axis=0)) for s in three(e)],
        "You took the root of the mean *distance*, so there is no square under the mean. Square first, then the mean, and the root last.",
    ),
    "spread of the distances": (
        lambda e: [np.sqrt(s).std(axis=0) for s in three(e)],
        "You took the standard deviation of the distances over the runs: how much they differ, and not how large they are. Use the mean of the squares.",
    ),
    "median": (
        lambda e: [np.median(np.sqrt(s), axis=0) for s in three(e)],
        "That is the median of the distances. Asked is the root of the mean of the squares.",
    ),
    "slice too short": (
        lambda e: [np.sqrt(s.mean(axis=0)) for s in (*three(e)[:2], np.sum(e[..., 6:8] ** 2, axis=-1))],
        "The first two are right. The third holds 6 and 7 alone, as with `6:8`: the acceleration has the indices 6, 7 "
        "and 8.",
    ),
    "slice too short, position": (
        lambda e: [
            np.sqrt(np.mean(np.sum(e[..., k : k + n] ** 2, axis=-1), axis=0)) for k, n in ((0, 2), (3, 2), (6, 3))
        ],
        "The third is right. A slice ends before its last number: `0:2` holds two axes, and so does `3:5`.",
    ),
    "first run": (
        lambda e: [np.sqrt(s[0]) for s in three(e)],
        "You took the first run alone. Take the mean of the squares over all runs, axis 0.",
    ),
    "one divided by n − 1": (
        lambda e: [np.sqrt(s.sum(axis=0) / max(len(s) - 1, 0.5)) for s in three(e)],
        "You divided by the number of runs less one. That is for a variance about a mean that was estimated; the mean of squares divides by all of them.",
    ),
    "square of the mean distance": (
        lambda e: [np.sqrt(s).mean(axis=0) ** 2 for s in three(e)],
        "You squared the mean distance. Square first, then the mean, and the root last.",
    ),
    "in a dictionary of states": (
        lambda e: [np.sqrt(np.mean(np.sum(e**2, axis=-1), axis=0))] * 3,
        "You put all nine states together: metres, metres a second and metres a second squared do not add up. One series for each kind.",
    ),
    "mean size": (
        lambda e: [np.mean(abs(e[..., k : k + 3]), axis=(0, 2)) for k in (0, 3, 6)],
        "Those are mean sizes of the errors of an axis. Add the squares of three axes, take the mean over the runs, then the root.",
    ),
    "squared before, third as published": (
        squares_inside(3),
        "Two things. The third series is the velocity's. And the `norm` of squared errors has fourth powers under its root: for the RMS "
        "add the squares, take the mean over the runs, and the root last.",
    ),
    "squared before": (
        squares_inside(6),
        "The `norm` of squared errors has fourth powers under its root. For the RMS add the squares of the three axes, take the mean "
        "over the runs, and the root last.",
    ),
}
