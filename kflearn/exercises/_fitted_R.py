"""Wrong answers to the last exercise of lesson 24, where R is fitted, each with the sentence that it gets.

They are sought on a grid of R, all of it in one pass, so that a check of slow code does not become slower still.
"""

import numpy as np

from kflearn import fit, random_walk

GRID = np.geomspace(1e-6, 1e6, 4000)


def best(z, Q, log=1.0, nis=1.0, R=GRID, walk=None):
    """The R of the largest likelihood of a random walk, diffuse at first; with weights of its two parts.

    R: what is tried. walk: the Q of each of them, where it is not the one that is given.
    """
    walk, cost = Q if walk is None else walk, 0
    first, *rest = np.flatnonzero(~np.isnan(z))
    x, P, before = z[first], R, first
    for k in rest:
        P = P + (k - before) * walk
        S, y, before = P + R, z[k] - x, k
        cost = cost + log * np.log(S) + nis * y**2 / S
        x, P = x + P / S * y, P * R / S
    return GRID[np.argmin(cost)]


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
}


def where_nis_is_one(z, Q):
    """The R at which the mean NIS is 1."""
    first, *rest = np.flatnonzero(~np.isnan(z))
    x, P, before, nis = z[first], GRID, first, []
    for k in rest:
        P = P + (k - before) * Q
        S, y, before = P + GRID, z[k] - x, k
        nis.append(y**2 / S)
        x, P = x + P / S * y, P * GRID / S
    return GRID[np.argmin(abs(np.mean(nis, axis=0) - 1))]


WRONG["mean NIS of 1"] = (
    where_nis_is_one,
    "That is the R at which the mean NIS is 1. With Q held fixed this need not be the top: take the largest log L.",
)


def of_all(results, rights):
    """What is said of a logarithm, and where the search ran to an end of what was tried: a part of the sum is missing."""
    for log, back in ((np.log, "`np.exp` of it"), (np.log10, "ten to the power of it")):
        if np.allclose(results, log(rights), rtol=0, atol=0.04):
            return f"That is the logarithm of R. Return R itself, {back}."
    if np.ptp(results) == 0 and np.isclose(results[0], 15099, rtol=1e-3):
        return "Your R is 15099 whatever the readings are: that is the lesson's Nile. Fit R to z."
    if np.all(abs(np.log10(results) - np.round(np.log10(results))) < 1e-9) and np.ptp(results) > 0:
        return (
            "Your R is a power of ten in every trial. If your grid has one point a decade, refine it around the best, "
            "or use a search."
        )
    if np.ptp(results) == 0 and np.all(abs(np.log(results / rights)) < np.log(20)):
        return f"Your R is {results[0]:.4g} in every trial, whatever the readings are. Fit R to z."
    if np.all(results > 20 * rights):
        return (
            "Your R is far too large in every trial: does the search run to the end of what it tries? Is log 2πS in the sum? "
            "With Σ y²/S alone a larger R always looks better. Or is the sign such that the worst R is found?"
        )
    if np.all(results < rights / 20):
        return (
            "Your R is close to 0 in every trial: does the search run to the end of what it tries? Is y²/S in the sum? With "
            "log 2πS alone a smaller R always looks better. Or is the sign such that the worst R is found?"
        )
    if not np.isfinite(results).all():
        return None
    low, high = np.min(results / rights), np.max(results / rights)
    return (
        f"Your R is {low:.2g} to {high:.2g} times the most probable one in the trials. Print the log-likelihood at yours and at its neighbours, for "
        "readings of your own: where is it largest? Does each reading add both parts, log 2πS and y²/S?"
    )
