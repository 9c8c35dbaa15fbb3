"""Lesson 27, `variance_at_rest`: wrong answers, each with the sentence that it gets."""

import numpy as np


def at_rest(time, z, until):
    return z[time < until]


DIFFERENCES = (
    "A fair estimate if the errors are independent. Asked for are the squares about the mean, divided by n − 1."
)


def rest_without_nan(time, z, until):
    return z[(time < until) & ~np.isnan(z)]


WRONG = {
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
    "mean square, n − 1": (
        lambda time, z, until: np.nansum(z[time < until] ** 2) / (np.sum(~np.isnan(z[time < until])) - 1),
        "You took the mean square about 0. Where it stood is not noise: take off the mean first.",
    ),
    "median for the mean": (
        lambda time, z, until: (
            np.nansum((z[time < until] - np.nanmedian(z[time < until])) ** 2) / (np.sum(~np.isnan(z[time < until])) - 1)
        ),
        "You took squares about the median. The variance is about the mean.",
    ),
    "both divided by n": (
        lambda time, z, until: np.nansum((z[time < until] - np.nanmean(z[time < until])) ** 2) / np.sum(time < until),
        "You divided by the number of rows, missing ones counted. Divide by the number of readings that are there, less one.",
    ),
    "half the squared differences": (
        lambda time, z, until: np.nanmean(np.diff(z[time < until]) ** 2) / 2,
        DIFFERENCES,
    ),
    "half the variance of the differences": (
        lambda time, z, until: np.nanvar(np.diff(z[time < until])) / 2,
        DIFFERENCES,
    ),
    "about the mean of all": (
        lambda time, z, until: (
            np.sum((rest_without_nan(time, z, until) - np.nanmean(z)) ** 2)
            / (len(rest_without_nan(time, z, until)) - 1)
        ),
        "The squares are taken about the mean of the *whole* record. Take them about the mean of the readings at rest.",
    ),
    "of the mean": (
        lambda time, z, until: np.var(rest_without_nan(time, z, until), ddof=1) / len(rest_without_nan(time, z, until)),
        "That is the right number, divided once more by the number of readings: the variance of their *mean*. R is "
        "the variance of one reading.",
    ),
}
