"""Lesson 9, `agreeing`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn import angle_difference

STOPS = (
    "You stop at the first refused reading that disagrees. Those on its other side may agree too: look at all of them."
)


def in_a_row(refused, reading, width, step):
    """How many agree until the first that does not, from one end."""
    near = abs(angle_difference(np.asarray(refused)[::step], reading)) <= width
    return int(np.argmin(near)) if not near.all() else len(near)


NEIGHBOURS = "You compare each reading with the one before it. Compare every refused reading with the new one."


def neighbours(refused, reading, width):
    rows = np.append(refused, reading)
    return np.sum(abs(angle_difference(rows[1:], rows[:-1])) <= width)


def wrapped_limits(refused, reading, width):
    low, high = (reading - width) % 360, (reading + width) % 360
    return sum(low <= old <= high for old in refused)


def one_side_wrapped(old, z, width):
    y = old - z
    return np.sum(abs(np.where(y > 180, y - 360, y)) <= width)


WRONG = (
    {
        "not wrapped": (
            lambda old, z, w: np.sum(abs(old - z) <= w),
            "Across north yours goes the long way round: 358° and 1° agree within 3°.",
        ),
        "width in all": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) <= w / 2),
            "You count within half the width. Wanted is ± width, on both sides.",
        ),
        "one side": (
            lambda old, z, w: np.sum(angle_difference(old, z) <= w),
            "You look at one side only: those far to the left are counted as well. Take the absolute value.",
        ),
        "those that do not": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) > w),
            "You counted those that do not agree.",
        ),
        "share": (
            lambda old, z, w: np.mean(abs(angle_difference(old, z)) <= w),
            "That is their share. Wanted is their number: sum, not mean.",
        ),
        "which": (
            lambda old, z, w: abs(angle_difference(old, z)) <= w,
            "That says for each whether it agrees; now count the True.",
        ),
        "itself too": (
            lambda old, z, w: 1 + np.sum(abs(angle_difference(old, z)) <= w),
            "One too many: the new reading itself is not among the refused ones that are asked for, and a count begins at 0.",
        ),
        "all of them": (
            lambda old, z, w: len(old),
            "That is how many were refused. How many of them are near the new reading?",
        ),
        "8 degrees": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) <= 8),
            "You count within about 8°, whatever `width` is.",
        ),
        "modulo": (
            lambda old, z, w: np.sum((old - z) % 360 <= w),
            "Only readings on one side are counted, as with `% 360`, which makes 357° of 3° to the left. Count both sides.",
        ),
        "one side, not wrapped": (
            lambda old, z, w: np.sum(old - z <= w),
            "You look at one side only, and subtract without the short way round.",
        ),
        "other side": (
            lambda old, z, w: np.sum(angle_difference(old, z) >= -w),
            "You look at one side only: those far to the right are counted as well. Take the absolute value.",
        ),
        "the readings": (
            lambda old, z, w: np.asarray(old)[abs(angle_difference(old, z)) <= w],
            "Those are the readings that agree. Wanted is how many there are.",
        ),
        "one at least": (
            lambda old, z, w: bool(np.any(abs(angle_difference(old, z)) <= w)),
            "That says whether there is one at least. Wanted is how many there are.",
        ),
        "three at least": (
            lambda old, z, w: bool(np.sum(abs(angle_difference(old, z)) <= w) >= 3),
            "That says whether there are three at least. Wanted is how many there are.",
        ),
        "squares": (
            lambda old, z, w: np.sum(angle_difference(old, z) ** 2 <= w),
            "It counts as if the squared difference were compared with the width itself.",
        ),
        "their mean": (
            lambda old, z, w: int(abs(angle_difference(np.mean(old), z)) <= w),
            "That is 1 or 0, as for the mean of all. Compare each refused reading with the new one, and count.",
        ),
        "among themselves": (
            lambda old, z, w: np.sum(abs(angle_difference(old, old[0])) <= w),
            "That is how many agree with the first refused reading. Compare each with the new one.",
        ),
        "neighbours alone": (
            lambda old, z, w: np.sum(abs(angle_difference(np.diff(old), 0)) <= w),
            "You compare each refused reading with the one before it. Compare each of them with the new one.",
        ),
    }
    | {
        f"last {n}": (
            lambda old, z, w, n=n: np.sum(abs(angle_difference(np.asarray(old)[-n:], z)) <= w),
            f"You look at the last {n} only. All of the refused readings count.",
        )
        for n in (3, 4, 5, 6)
    }
    | {
        "the last in a row": (lambda refused, reading, width: in_a_row(refused, reading, width, -1), STOPS),
        "the first in a row": (lambda refused, reading, width: in_a_row(refused, reading, width, 1), STOPS),
        "neighbours": (neighbours, NEIGHBOURS),
        "limits wrapped": (
            wrapped_limits,
            "Near north none is counted, as when the limits are wrapped: the lower one is then above the upper one. Wrap the difference.",
        ),
        "without the edge": (
            lambda old, z, w: np.sum(abs(angle_difference(old, z)) < w),
            "You leave out those that are exactly `width` away: within ± 3° includes 3°.",
        ),
        "different ones": (
            lambda old, z, w: np.sum(abs(angle_difference(np.unique(old), z)) <= w),
            "It answers as if equal readings counted once. Two refused readings with the same number are two: count "
            "them both.",
        ),
        "mean of all and the new one": (
            lambda old, z, w: np.sum(abs(angle_difference(old, np.mean(np.append(old, z)))) <= w),
            "It answers as if each reading were compared with the mean of all, the new one included. Compare each "
            "with the new one itself.",
        ),
        "one side wrapped": (
            one_side_wrapped,
            "Differences above 180° are taken the short way round, those below −180° are not: seen from 358°, 2° is "
            "4° away. `angle_difference` does both.",
        ),
        "the first one alone": (
            lambda refused, reading, width: (
                int(abs(angle_difference(refused[0], reading)) <= width) if len(refused) else None
            ),
            "Only the first refused reading counts in your result: does the `return` stand inside the loop?",
        ),
    }
)
