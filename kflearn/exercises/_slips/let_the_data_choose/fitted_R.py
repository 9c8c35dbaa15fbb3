"""Lesson 24, `fitted_R`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn import fit, random_walk
from kflearn.exercises._fitted_R import GRID, best, where_nis_is_one
from kflearn.exercises._slips.let_the_data_choose.shared import bridged


def from_the_smoothed_line(z, Q):
    """The R that is the mean squared distance of the readings, without the first, from the line smoothed with it."""
    seen, steps, R = ~np.isnan(z), np.diff(np.eye(len(z)), axis=0), np.nanvar(z)
    for _ in range(30):
        level = np.linalg.solve(np.diag(seen / R) + steps.T @ steps / Q, np.where(seen, z, 0) / R)
        R = np.nanmean((z - level)[1:] ** 2) + 1e-12
    return R


WRONG = {
    "variance of the readings": (
        lambda z, Q: np.nanvar(z, ddof=1),
        "That is the variance of the readings, and the most probable R of a value that never moves, with Q = 0. "
        "Here the walk is in it too: Q belongs to the prediction, P + Q in every step.",
    ),
    "differences": (
        lambda z, Q: np.nanvar(np.diff(z)) / 2,
        "Half the variance of the differences. A difference also holds one step of the walk: its variance is 2R + Q.",
    ),
    "differences, nothing taken off": (
        lambda z, Q: np.nanvar(np.diff(z)),
        "That is the variance of the differences, which is 2R + Q: a difference holds the errors of two readings and a step "
        "of the walk. And differences are not the most probable R: use the likelihood.",
    ),
    "differences without the half": (
        lambda z, Q: np.nanmean(np.diff(z) ** 2) - Q,
        "That is 2R, since a difference holds the errors of two readings. And differences are not the most probable R: use the likelihood.",
    ),
    "differences, right on average": (
        lambda z, Q: max((np.nanmean(np.diff(z) ** 2) - Q) / 2, 0),
        "A fair estimate: right on average, but it scatters more than need be. Maximise the likelihood.",
    ),
    "differences over the gaps too": (
        lambda z, Q: max((np.var(np.diff(z[~np.isnan(z)])) - Q) / 2, 0),
        "That is half of the variance of the differences, less Q, with the gaps left out. Over a gap the walk makes more than one step, and so "
        "has more than one Q. And differences are not the most probable R: use the likelihood, and leave NaN in.",
    ),
    "σ": (
        lambda z, Q: np.sqrt(best(z, Q)),
        "That is σ. Its square, the variance R, was asked for.",
    ),
    "no half before the logarithm": (
        lambda z, Q: best(z, Q, log=2),
        "The ½ belongs to both parts of the sum, also to log 2πS. Without it your R is too small: that is the mistake of exercise 3.",
    ),
    "no half before the NIS": (
        lambda z, Q: best(z, Q, nis=2),
        "The ½ belongs to both parts of the sum, also to y²/S. Without it your R is too large.",
    ),
    "Q as σ": (
        lambda z, Q: best(z, Q**2),
        "That is about the most probable R for Q². Q is a variance already.",
    ),
    "root of Q": (
        lambda z, Q: best(z, np.sqrt(Q)),
        "That is about the most probable R for √Q. Q is the variance of one step of the walk, and it is added to P as it is.",
    ),
    "Q = 1": (
        lambda z, Q: best(z, 1.0),
        "That is right for Q = 1. Use the Q that your function is given.",
    ),
    "Q and R exchanged": (
        lambda z, Q: best(z, Q, R=np.full_like(GRID, Q), walk=GRID),
        "That is about what comes out if `random_walk` gets Q and R in the wrong order: its first argument is Q.",
    ),
    "gaps left out": (
        lambda z, Q: best(z[~np.isnan(z)], Q),
        "That is about what comes out without the gaps, with the readings on either side as neighbours. Leave NaN in: the filter then predicts twice.",
    ),
    "Q fitted too": (
        lambda z, Q: fit(random_walk, z, {"Q": 1.0, "R": 1.0}).parameters["R"],
        "That is about what comes out if Q is fitted as well. It is known here: put it into `build`.",
    ),
    "mean NIS of 1": (
        where_nis_is_one,
        "That is the R at which the mean NIS is 1. With Q held fixed this need not be the top: take the largest log L.",
    ),
    "0 in the gaps": (
        lambda z, Q: best(np.nan_to_num(z), Q),
        "That is about what comes out if a reading of 0 stands in each gap. NaN means that there is no reading: "
        "leave it in, and the filter only predicts there.",
    ),
    "gaps bridged": (
        lambda z, Q: best(bridged(z), Q),
        "That is about what comes out if straight lines fill the gaps, and count as readings. Leave NaN in: the "
        "filter only predicts there.",
    ),
    "distance from the smoothed line": (
        from_the_smoothed_line,
        "That is about the mean squared distance of the readings from the smoothed line. The line follows the very "
        "readings, so this is too small. Find the largest likelihood.",
    ),
}
