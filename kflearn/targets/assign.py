"""Which reading belongs to which track, decided for all of them together, or one after the other."""

import numpy as np

from ..models import checks as check

HOW = "global", "greedy"


def assign(cost, nothing=0.0, how="global") -> np.ndarray:
    """Give each track one reading at most, and each reading to one track at most.

    Parameters
    ----------
    cost : array_like (..., M, N)
        What it costs to give reading j to track i; infinite where that is forbidden.
    nothing : float
        What it costs to leave a track without a reading.
    how : "global" or "greedy"
        "global": the smallest sum of all costs. "greedy": the cheapest pair first, then the cheapest of what is left,
        as long as a pair is cheaper than `nothing`.

    Returns
    -------
    ndarray of int (..., M)
        The reading of each track, -1 for none.

    Raises
    ------
    ValueError, TypeError
        Where cost holds NaN or −∞, or a setting does not make sense.

    References
    ----------
    Kuhn 1955; Crouse 2016, whose algorithm SciPy has as linear_sum_assignment.

    Examples
    --------
    >>> from kflearn import assign
    >>> print(assign([[1, 2], [2, 9]], nothing=20), assign([[1, 2], [2, 9]], nothing=20, how="greedy"))
    [1 0] [0 1]
    """
    cost = np.array(cost, float)
    if cost.ndim < 2:
        raise ValueError(f"cost must have shape (..., tracks, readings), got {check.found_in(cost)}")
    if np.isnan(cost).any() or np.isneginf(cost).any():
        raise ValueError("cost must consist of numbers, or infinity where a pair is forbidden; found NaN or -infinity")
    check.number("nothing", nothing)
    return assigned(cost, nothing, check.word("how", how, HOW))


def assigned(cost, nothing, how):
    """The same without checks."""
    return together(cost, nothing) if how == "global" else in_turn(cost, nothing)


def together(cost, nothing):
    """The assignment with the smallest sum. Where no two tracks want the same reading, each gets what it wants."""
    M, N = cost.shape[-2:]
    if N == 0 or M == 0:
        return np.full(cost.shape[:-1], -1)
    best = np.where(cost.min(axis=-1) < nothing, cost.argmin(axis=-1), -1)
    wanted = (best[..., None] == np.arange(N)).sum(axis=-2)
    for run in np.argwhere((wanted > 1).any(axis=-1)):
        best[*run] = _one_scan(cost[*run], nothing)
    return best


def _one_scan(cost, nothing):
    """One scan by SciPy, with a column "nothing" for each track."""
    from scipy.optimize import linear_sum_assignment  # imported here: `import kflearn` shall not wait for SciPy

    M, N = cost.shape
    _, column = linear_sum_assignment(np.hstack([cost, np.full((M, M), nothing)]))
    return np.where(column < N, column, -1)


def in_turn(cost, nothing):
    """The cheapest pair first; its track and its reading are then taken."""
    cost, found = cost.copy(), np.full(cost.shape[:-1], -1)
    M, N = cost.shape[-2:]
    for _ in range(min(M, N)):
        cheapest = cost.reshape(*cost.shape[:-2], M * N).argmin(axis=-1)[..., None, None]
        pair = (np.arange(M)[:, None] == cheapest // N) & (np.arange(N) == cheapest % N)
        pair &= cost < nothing
        found = np.where(pair.any(axis=-1), pair.argmax(axis=-1), found)
        cost[pair.any(axis=-1, keepdims=True) | pair.any(axis=-2, keepdims=True)] = np.inf
    return found
