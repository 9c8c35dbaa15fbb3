"""Lesson 19, `gravity`: wrong answers, each with the sentence that it gets."""

import numpy as np


def near(rows):
    return abs(rows - 210) < 1


WRONG = {
    "as published": (
        lambda rows: 6.0,
        "You return 6 in every trial, as published: gravity never sleeps, and a ball at rest is pushed into the floor.",
    ),
    "never": (
        lambda rows: 0.0,
        "You return 0 in every trial. Without gravity the ball flies straight: only a ball at rest is free of it.",
    ),
    "last row only": (
        lambda rows: 0.0 if near(rows)[-1] else 6.0,
        "You looked at the last frame only: a bouncing ball is near the floor for a frame as well.",
    ),
    "any": (
        lambda rows: 0.0 if near(rows).any() else 6.0,
        "One frame near the floor is enough for you: that is a bounce. All three must be near.",
    ),
    "NaN counts as near": (
        lambda rows: 6.0 if np.any(abs(rows - 210) >= 1) else 0.0,
        "A frame without a detection counts as near the floor with you: where nothing was seen, nothing is known to rest. Ask whether *all* three are near.",
    ),
    "mean": (
        lambda rows: 0.0 if near(np.mean(rows)) else 6.0,
        "A mean row near the floor may come from one above and one below: each of the three must be near.",
    ),
    "no change": (
        lambda rows: 0.0 if np.ptp(rows) < 1 else 6.0,
        "You ask whether the ball stays on its row, and not on which: only the floor was asked for.",
    ),
    "switched": (
        lambda rows: 6.0 if near(rows).all() else 0.0,
        "The two answers are exchanged: at rest 0, else 6.",
    ),
    "one side": (
        lambda rows: 0.0 if np.all(rows - 210 < 1) else 6.0,
        "Every ball above the floor counts as resting, as without the absolute value: rows count downwards.",
    ),
    "below the floor counts": (
        lambda rows: 0.0 if np.all(rows > 209) else 6.0,
        "A row of 211.5 counts as near with you. Within 1 px means on both sides: 209 < row < 211.",
    ),
    "mean of those seen": (
        lambda rows: 0.0 if near(np.nanmean(rows)) else 6.0,
        "A mean row near the floor may come from one above and one below, and it says nothing about a hidden "
        "frame: each of the three must be near.",
    ),
    "two pixels": (
        lambda rows: 0.0 if np.all(abs(rows - 210) < 2) else 6.0,
        "You return 0 also where one of the rows is 1.5 px off. Each must be less than 1 px from the floor.",
    ),
    "median": (
        lambda rows: 0.0 if near(np.median(rows)) else 6.0,
        "A median near the floor says that two of the rows may be near, or one above and one below. Each of the three must be near.",
    ),
    "first and last": (
        lambda rows: 0.0 if near(rows)[[0, -1]].all() else 6.0,
        "You looked at the first and the last frame. The one between must be near as well.",
    ),
    "last two": (
        lambda rows: 0.0 if near(rows)[1:].all() else 6.0,
        "You looked at the last two frames. All three must be near.",
    ),
    "rounded": (
        lambda rows: 0.0 if np.all(np.round(rows) == 210) else 6.0,
        "That is within half a pixel. One pixel was asked for: the absolute difference from 210, below 1.",
    ),
    "exactly": (
        lambda rows: 0.0 if np.all(rows == 210) else 6.0,
        "Of all trials only 210, 210, 210 gives 0. Within 1 px means: the absolute difference of each is below 1.",
    ),
    "three numbers": (
        lambda rows: np.where(near(rows), 0.0, 6.0),
        "You return one number for each frame. One push is wanted: 0 only if all three are near.",
    ),
    "two of three": (
        lambda rows: 0.0 if near(rows).sum() >= 2 else 6.0,
        "Two of three are enough for you. All three must be near: in a bounce two may be as well.",
    ),
    "larger than 209": (
        lambda rows: 0 if min(rows) > 209 else 6,
        "It answers as if only `min(rows) > 209` were asked: a row of 212 then counts as near, and so may a NaN. "
        "Each of the three must be less than 1 px away, above *and* below.",
    ),
    "at most 1 px": (
        lambda rows: 0.0 if np.all(abs(rows - 210) <= 1) else 6.0,
        "Right, but for a row that is exactly 1 px from the floor: it counts only if it is *less* than 1 px away, `<`.",
    ),
}
