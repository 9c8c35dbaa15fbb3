"""What the last exercise of lesson 24, where R is fitted, says of an R, and ways to a wrong one.

These are sought on a grid of R, all of it in one pass, so that a check of slow code does not become slower still.
"""

import numpy as np

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


THE_SAME = (
    "Does it come from z? A NaN in the sum makes all of it NaN, and each trial has missing readings: without a reading there is "
    "no y, and no term."
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
        return f"Your R is {results[0]:.4g} in every trial. {THE_SAME}"
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
