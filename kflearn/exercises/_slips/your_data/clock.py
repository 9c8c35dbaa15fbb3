"""Lesson 27, `clock`: wrong answers, each with the sentence that it gets."""

import numpy as np

ALL_ALIKE = "You give all steps the same length. Each step has its own, above all the hole."


def steps(time, z, middle):
    """The same step for all."""
    d = np.diff(time[~np.isnan(z)])
    return np.full(len(d), middle(d))


THROWN = (
    "You throw long steps away. The hole is the step that matters: keep every one, there is one less than readings."
)


def cut_off(limit, middle=lambda d: 1.0):
    """The steps without the long ones."""

    def short(time, z):
        d = np.diff(time[~np.isnan(z)])
        return d[d < limit * middle(d)]

    return short


def every_step(time, z):
    return np.full(len(z) - 1, np.median(np.diff(time)))


def hole_closed(time, z):
    """The steps, of which those longer than five medians are set to the median."""
    steps = np.diff(time[~np.isnan(z)])
    return np.where(steps > 5 * np.median(steps), np.median(steps), steps)


WRONG = (
    {
        "ones": (
            lambda time, z: np.ones((~np.isnan(z)).sum() - 1),
            "That is the bug itself: one reading, one second. Where a reading is missing the clock goes on.",
        ),
        "median": (
            lambda time, z: np.full((~np.isnan(z)).sum() - 1, np.median(np.diff(time))),
            "Every step has the median length here. Over a gap the step is longer.",
        ),
        "NaN by comparison": (
            lambda time, z: np.diff(time[z != np.nan]),
            "NaN differs from everything, itself included: `z != np.nan` keeps all rows. Use `~np.isnan(z)`.",
            "!= np.nan",
        ),
        "all rows": (
            lambda time, z: np.diff(time),
            "Those are the steps between all rows, the empty ones too. Their number no longer fits the readings.",
        ),
        "steps dropped": (
            lambda time, z: np.diff(time)[~np.isnan(z[1:])],
            "Those are the steps of all rows without those that lead to a gap. The time of the dropped steps is lost: the clock still stops. First drop, then take differences.",
        ),
        "times": (
            lambda time, z: time[~np.isnan(z)],
            "Those are the right time stamps. The filter wants the steps between them: `np.diff`.",
        ),
        "differences of readings": (
            lambda time, z: np.diff(z[~np.isnan(z)]),
            "You took differences of the readings. The steps are differences of the time stamps.",
        ),
        "backwards": (
            lambda time, z: -np.diff(time[~np.isnan(z)]),
            "Your steps are negative: the later time stamp minus the earlier one.",
        ),
        "mask one too early": (
            lambda time, z: np.diff(time)[~np.isnan(z)[:-1]],
            "Those are the steps of all rows without those that begin at a gap: their time is lost. First drop, then take differences.",
        ),
        "first step from zero": (
            lambda time, z: np.diff(time[~np.isnan(z)], prepend=0),
            "One step too many: before the first reading there is no step.",
        ),
        "first step by itself": (
            lambda time, z: np.diff(time[~np.isnan(z)], prepend=time[~np.isnan(z)][0]),
            "One step too many: before the first reading there is no step, and none of length 0.",
        ),
        "times of the gaps": (
            lambda time, z: np.diff(time[np.isnan(z)]),
            "You kept the rows *without* a reading: `~np.isnan(z)` are those with one.",
        ),
        "both ends there": (
            lambda time, z: np.diff(time)[~np.isnan(np.diff(z))],
            "You kept only steps between two rows that both hold a reading. The steps across a gap are missing, and "
            "their time with them.",
        ),
        "one step of a second at the end": (
            lambda time, z: np.append(np.diff(time[~np.isnan(z)]), 1.0),
            "One step too many: after the last reading there is no step.",
        ),
        "mean step": (
            lambda time, z: np.diff(time[~np.isnan(z)]).mean(),
            "That is the mean step. Each step has its own length: return all of them.",
        ),
        "NaN for the missing": (
            lambda time, z: np.diff(np.where(np.isnan(z), np.nan, time)),
            "NaN stands in the time where a reading is missing, so the steps beside it are NaN. Drop these rows first, then take"
            " differences.",
        ),
        "mean length": (
            lambda time, z: np.full((~np.isnan(z)).sum() - 1, np.mean(np.diff(time))),
            "Every step has the mean length here. Over a gap the step is longer.",
        ),
        "gaps only": (
            lambda time, z: np.diff(time)[np.isnan(z[1:])],
            "Those are the steps that lead to a missing reading. You want those from one reading to the next.",
        ),
        "the median step": (lambda time, z: steps(time, z, np.median), ALL_ALIKE),
        "the mean step": (lambda time, z: steps(time, z, np.mean), ALL_ALIKE),
    }
    | {
        f"cut off at {limit} s": (cut_off(limit), THROWN)
        for limit in (1, 1.5, 2, 3, 5, 10, 20, 30, 60, 100, 120, 300, 1000)
    }
    | {f"cut off at {limit} medians": (cut_off(limit, np.median), THROWN) for limit in (2, 3, 4, 5, 10, 20)}
    | {
        "median step, all rows": (
            every_step,
            "Every step is the same in your answer, and rows without a reading count. Drop the rows with NaN, then take differences of time.",
        ),
        "since the first": (
            lambda time, z: time[~np.isnan(z)][1:] - time[~np.isnan(z)][0],
            "These are the times since the first reading. Wanted are the steps, each from one reading to the next.",
        ),
        "hole closed": (
            hole_closed,
            "The steps of the hole are shortened to the median. That time did pass: leave each step as long as the "
            "clock says.",
        ),
        "rows times the median": (
            lambda time, z: np.diff(np.flatnonzero(~np.isnan(z))) * np.median(np.diff(time)),
            "It answers as if each row came one median step after the row before. The clock runs unevenly: take the "
            "time stamps of the rows that hold a reading.",
        ),
        "whole seconds": (
            lambda time, z: np.maximum(1, np.round(np.diff(time[~np.isnan(z)]))),
            "Your steps are rounded to whole seconds, and none is shorter than 1 s. Leave each step as long as the "
            "clock says.",
        ),
        "gradient": (
            lambda time, z: np.gradient(time[~np.isnan(z)]),
            "One number too many: each but the first and last is the mean of the step before a reading and the one "
            "after it, as `np.gradient` makes it. A step goes from one reading to the next.",
        ),
        "in mean steps": (
            lambda time, z: (s := np.diff(time[~np.isnan(z)])) / np.mean(s),
            "Your steps are counted in mean steps. They are wanted in seconds: do not divide.",
        ),
    }
)
