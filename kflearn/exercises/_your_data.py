"""Wrong answers to exercises of lesson 27, each with the sentence that it gets."""

import numpy as np


def at_rest(time, z, until):
    return z[time < until]


WRONG = {}

WRONG["clock"] = {
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
}

WRONG["variance_at_rest"] = {
    "whole record": (
        lambda time, z, until: np.nanvar(z, ddof=1),
        "That is the variance of the whole record. Whatever moved counts as noise then: keep to `time < until`.",
    ),
    "whole record, ddof 0": (
        lambda time, z, until: np.nanvar(z),
        "That is the variance of the whole record. Whatever moved counts as noise then: keep to `time < until`.",
    ),
    "the moving part": (
        lambda time, z, until: np.nanvar(z[time >= until], ddof=1),
        "That is the variance of the ride. At rest means *before* `until`.",
    ),
    "NaN": (
        lambda time, z, until: np.var(at_rest(time, z, until), ddof=1),
        "One reading at rest is NaN, and so is your variance: use `np.nanvar`.",
    ),
    "NaN, ddof 0": (
        lambda time, z, until: np.var(at_rest(time, z, until)),
        "One reading at rest is NaN, and so is your variance: use `np.nanvar`.",
    ),
    "ddof 0": (
        lambda time, z, until: np.nanvar(at_rest(time, z, until)),
        "Almost: you divided by the number of readings. Their mean was estimated too, so divide by one less: `ddof=1`.",
    ),
    "standard deviation": (
        lambda time, z, until: np.nanstd(at_rest(time, z, until), ddof=1),
        "That is the standard deviation. R is the variance.",
    ),
    "about 0": (
        lambda time, z, until: np.nanmean(at_rest(time, z, until) ** 2),
        "You took the mean square about 0. Where it stood is not noise: take off the mean first.",
    ),
    "until as a number of rows": (
        lambda time, z, until: np.nanvar(z[: int(until)], ddof=1),
        "`until` is a time in seconds, not a number of rows: choose with `time < until`.",
    ),
    "the lesson's 20 s": (
        lambda time, z, until: np.nanvar(z[time < 20], ddof=1),
        "That is right for the first 20 s, as in the lesson. Here `until` says how long nothing moved.",
    ),
    "the lesson's 40 s": (
        lambda time, z, until: np.nanvar(z[time < 40], ddof=1),
        "That is right for the first 40 s, the number in the program above. `until` says how long nothing moved.",
    ),
    "differences": (
        lambda time, z, until: np.nanvar(np.diff(at_rest(time, z, until)), ddof=1),
        "That is the variance of the differences from reading to reading, about 2R. Take the variance of the "
        "readings themselves.",
    ),
    "half of the differences": (
        lambda time, z, until: np.nanvar(np.diff(at_rest(time, z, until)), ddof=1) / 2,
        "Half the variance of the differences estimates R too, but not as well: take the variance of the readings"
        " about their mean.",
    ),
    "zeros for NaN": (
        lambda time, z, until: np.nanvar(np.nan_to_num(at_rest(time, z, until)), ddof=1),
        "A reading of 0 stands where there is none, as `np.nan_to_num` makes it. Leave it out: `np.nanvar`.",
    ),
    "mean": (
        lambda time, z, until: np.nanmean(at_rest(time, z, until)),
        "That is the mean of the readings at rest. R is their variance.",
    ),
    "standard deviation, ddof 0": (
        lambda time, z, until: np.nanstd(at_rest(time, z, until)),
        "That is the standard deviation. R is the variance.",
    ),
    "ddof with the missing ones": (
        lambda time, z, until: (
            np.nansum((at_rest(time, z, until) - np.nanmean(at_rest(time, z, until))) ** 2)
            / (len(at_rest(time, z, until)) - 1)
        ),
        "You divided by the number of rows less one, missing ones counted. Divide by the number of readings that "
        "are there, less one.",
    ),
}
