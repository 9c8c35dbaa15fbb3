"""Lesson 10, `honest_report`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn import rmse
from kflearn.exercises._combined import combined


def compared(x, one, other, cov, keep=slice(None), entry=1, root=np.sqrt, states=0):
    """A report with some of its details chosen."""
    errors = (rmse(way[keep][..., states], x[keep][..., states]) for way in (one, other))
    return *errors, root(cov[keep][-1, entry, entry])


def made_of(error, sigma):
    """A report of a fall from error(way, x, z) of the heights, and sigma(cov), both of the moments above the ground."""

    def report(x, z, mean, ignored, cov):
        above = x[:, 0] > 0
        errors = [error(way[above, 0], x[above, 0], z[above, 0]) for way in (mean, ignored)]
        return *errors, sigma(cov[above])

    return report


def reported(keep, second, entry, root, last):
    """A report of a fall in which something else is chosen."""

    def report(x, z, mean, ignored, cov):
        above = {"above": x[:, 0] > 0, "all": x[:, 0] > -np.inf, "below": x[:, 0] <= 0}[keep]
        other = {"ignored": ignored, "z": z, "mean": mean}[second]
        at = {"last": np.flatnonzero(above)[-1], "end": -1, "first": np.flatnonzero(above)[0],
              "next": min(np.flatnonzero(above)[-1] + 1, len(x) - 1)}[last]  # fmt: skip
        value = cov[at, entry, entry]
        errors = [rmse(way[above, 0], x[above, 0]) for way in (mean, other)]
        return *errors, np.sqrt(value) if root else value

    return report


def report(x, z, mean, ignored, cov):
    """Errors under the ground as well."""
    up = x[:, 0] > 0
    errors = [np.sqrt(np.mean((each[:, 0] - x[:, 0]) ** 2)) for each in (mean, ignored)]
    return *errors, np.sqrt(cov[up][-1, 1, 1])


def over_all_moments(x, z, mean, ignored, cov):
    up = x[:, 0] > 0
    errors = [np.sqrt(np.sum((each - x)[up, 0] ** 2) / len(x)) for each in (mean, ignored)]
    return *errors, np.sqrt(cov[up][-1, 1, 1])


WRONG = (
    {
        "as published": (
            lambda x, z, mean, ignored, cov: compared(x, mean, z, cov, entry=0, root=lambda v: v),
            "That is the published report again: it counts underground, leaves out ignoring, and prints the height's variance.",
        ),
        "not cut": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov),
            "You compare with the right thing, but still count underground: keep only moments with x[:, 0] > 0.",
        ),
        "compared with raw": (
            lambda x, z, mean, ignored, cov: compared(x, mean, z, cov, x[:, 0] > 0),
            "The second number is the error of the raw readings. This filter beats them and still does harm: compare with `ignored`.",
        ),
        "height's entry": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, entry=0),
            "The third number is σ of the *height*: cov[…, 0, 0]. The velocity is the second state, entry [1, 1].",
        ),
        "variance": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, root=lambda v: v),
            "The right entry, but it is a variance, in m²/s²; σ is its root.",
        ),
        "last of all": (
            lambda x, z, mean, ignored, cov: (
                *compared(x, mean, ignored, cov, x[:, 0] > 0)[:2],
                np.sqrt(cov[-1, 1, 1]),
            ),
            "The errors are right. But σ is that of the very last moment, deep underground: take the last one above.",
        ),
        "below": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] <= 0),
            "You kept what lies underground and threw away the rest.",
        ),
        "both states": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, states=slice(None)),
            "Your errors mix metres with metres per second: take the height alone, column 0.",
        ),
        "swapped": (
            lambda x, z, mean, ignored, cov: compared(x, ignored, mean, cov, x[:, 0] > 0),
            "The two errors have changed places: first the filter's, then that of ignoring.",
        ),
        "filter against prediction": (
            lambda x, z, mean, ignored, cov: (
                rmse(mean[x[:, 0] > 0, 0], x[x[:, 0] > 0, 0]),
                rmse(mean[x[:, 0] > 0, 0], ignored[x[:, 0] > 0, 0]),
                np.sqrt(cov[x[:, 0] > 0][-1, 1, 1]),
            ),
            "The second number compares the filter with the prediction. Compare the prediction with the truth.",
        ),
        "velocity error": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, states=1),
            "Those are the errors of the velocity; the height was asked for, column 0.",
        ),
        "the filter's height": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, mean[:, 0] > 0),
            "You keep the moments at which the *filter* says that the stone is above 0. Which moments count is decided by the truth, x.",
        ),
        "the reading above": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, z[:, 0] > 0),
            "You keep the moments at which the *reading* is above 0. Which moments count is decided by the truth, x.",
        ),
        "mean of the sizes": (
            lambda x, z, mean, ignored, cov: (
                *(np.mean(abs(way - x)[x[:, 0] > 0, 0]) for way in (mean, ignored)),
                compared(x, mean, ignored, cov, x[:, 0] > 0)[2],
            ),
            "Those are means of the sizes of the errors. Root mean square: square, mean, root; `rmse` does it.",
        ),
        "mean of the errors": (
            lambda x, z, mean, ignored, cov: (
                *(np.mean((way - x)[x[:, 0] > 0, 0]) for way in (mean, ignored)),
                compared(x, mean, ignored, cov, x[:, 0] > 0)[2],
            ),
            "Those are mean errors, in which plus and minus cancel. Root mean square: square, mean, root; `rmse` does it.",
        ),
        "the first moment": (
            lambda x, z, mean, ignored, cov: (
                *compared(x, mean, ignored, cov, x[:, 0] > 0)[:2],
                np.sqrt(cov[x[:, 0] > 0][0, 1, 1]),
            ),
            "The errors are right. But σ is that of the first moment above; asked is the last.",
        ),
        "raw, not cut": (
            lambda x, z, mean, ignored, cov: compared(x, mean, z, cov),
            "Two faults remain: you still count underground, and you compare with the raw readings and not with `ignored`. The σ is of the right entry.",
        ),
        "raw, height": (
            lambda x, z, mean, ignored, cov: compared(x, mean, z, cov, x[:, 0] > 0, entry=0),
            "The moments are right. Compare with `ignored` and not with the readings; and the velocity's entry is [1, 1].",
        ),
        "variance of the height": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, x[:, 0] > 0, entry=0, root=lambda v: v),
            "The errors are right. The third number is the height's variance: σ of the velocity is the root of entry [1, 1].",
        ),
        "not cut, variance": (
            lambda x, z, mean, ignored, cov: compared(x, mean, ignored, cov, root=lambda v: v),
            "You still count underground; and the third number is a variance: σ is its root.",
        ),
        "median": (
            made_of(lambda way, x, z: np.sqrt(np.median((way - x) ** 2)), lambda cov: np.sqrt(cov[-1, 1, 1])),
            "Those are medians. Root mean square: square, mean, root; `rmse` does it.",
        ),
        "last errors": (
            made_of(lambda way, x, z: abs(way - x)[-1], lambda cov: np.sqrt(cov[-1, 1, 1])),
            "Those are the errors at the last moment above. Take the root mean square over all moments above.",
        ),
        "of the readings": (
            made_of(lambda way, x, z: rmse(way, z), lambda cov: np.sqrt(cov[-1, 1, 1])),
            "You compare with the readings. Errors are measured against the truth, x.",
        ),
        "corner": (
            made_of(lambda way, x, z: rmse(way, x), lambda cov: np.sqrt(cov[-1, 0, 1])),
            "The errors are right. You took the root of the covariance, entry [0, 1]; the velocity's variance is entry [1, 1].",
        ),
        "mean of σ": (
            made_of(lambda way, x, z: rmse(way, x), lambda cov: np.mean(np.sqrt(cov[:, 1, 1]))),
            "The errors are right. The third number is a mean of σ; wanted is σ at the last moment above.",
        ),
    }
    | combined(
        reported,
        most=3,
        keep={"above": "", "all": "You still count underground.", "below": "You keep what lies underground."},
        second={
            "ignored": "",
            "z": "You compare with the raw readings and not with `ignored`.",
            "mean": "The filter is compared with itself: the second error is that of `ignored`.",
        },
        entry={1: "", 0: "The third number is of the height; the velocity's entry is [1, 1]."},
        root={True: "", False: "The third number is a variance; σ is its root."},
        last={
            "last": "",
            "end": "σ is that of the very last moment, deep underground.",
            "next": "σ is that of the first moment underground: count from 0.",
            "first": "σ is that of the first moment.",
        },
    )
    | {
        "under the ground": (
            report,
            "σ is right. Your two errors count the moments under the ground too: keep only those where x[:, 0] > 0.",
        ),
        "over all moments": (
            over_all_moments,
            "σ is right. Your two errors are too small: the squares above the ground are divided by the number of "
            "*all* moments. Divide by the number of those above.",
        ),
    }
)
