"""How good is a picture of several targets? One number, and its three parts."""

from typing import NamedTuple

import numpy as np

from ..models import checks as check
from .assign import together


class Gospa(NamedTuple):
    """What `gospa` returns: the distance, and the parts of which distance^p is the sum.

    Attributes
    ----------
    distance : ndarray (...)
        In the unit of the positions.
    localisation, missed, false : ndarray (...)
        In that unit to the power p: of targets with an estimate, without one, and of estimates without a target.
    match : ndarray of int (..., A)
        The estimate of each target, -1 where there is none.
    """

    distance: np.ndarray
    localisation: np.ndarray
    missed: np.ndarray
    false: np.ndarray
    match: np.ndarray


def gospa(truth, estimates, cutoff, p=2) -> Gospa:
    """Generalised optimal sub-pattern assignment (GOSPA, α = 2): the distance between two sets of positions.

    Targets and estimates are matched so that the sum is smallest: a match costs d^p, a missed target cutoff^p/2, a
    false estimate the same. So nothing is matched over more than the cutoff.

    Parameters
    ----------
    truth : array_like (..., A, d)
        Positions of the targets; a row of NaN is no target.
    estimates : array_like (..., B, d)
        Positions of the estimates; a row of NaN is none.
    cutoff : float
        From which distance on an estimate is no estimate of a target; above 0.
    p : float
        The power, from 1.

    Returns
    -------
    Gospa
        distance, and its parts localisation, missed and false, each (...).

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Rahmathullah, García-Fernández and Svensson 2017.

    Examples
    --------
    >>> from kflearn import gospa
    >>> found = gospa([[0, 0], [50, 0]], [[3, 4], [90, 0]], cutoff=10)
    >>> print(f"{found.distance:.2f}: {found.localisation:.0f} + {found.missed:.0f} + {found.false:.0f} m²")
    11.18: 25 + 50 + 50 m²
    """
    truth, estimates = (_positions(*each) for each in (("truth", truth), ("estimates", estimates)))
    if truth.shape[-1] != estimates.shape[-1]:
        raise ValueError(f"estimates must have {truth.shape[-1]} components like truth, got {estimates.shape[-1]}")
    batch = check.batches(truth=truth.shape[:-2], estimates=estimates.shape[:-2])
    c, p = check.number("cutoff", cutoff, positive=True), check.number("p", p, least=1)
    apart = np.linalg.norm(truth[..., :, None, :] - estimates[..., None, :, :], axis=-1) ** p
    pairs = np.where(apart < c**p, apart - c**p, np.inf)  # against a missed target and a false estimate
    match = together(pairs, 0.0)
    matched = match >= 0
    near = np.take_along_axis(apart, np.maximum(match, 0)[..., None], axis=-1)[..., 0]
    there, told = (
        np.broadcast_to(~np.isnan(x).any(axis=-1), (*batch, x.shape[-2])).sum(-1) for x in (truth, estimates)
    )
    localisation, count = np.where(matched, near, 0).sum(axis=-1), matched.sum(axis=-1)
    missed, false = c**p / 2 * (there - count), c**p / 2 * (told - count)
    return Gospa((localisation + missed + false) ** (1 / p), localisation, missed, false, match)


def _positions(name, value):
    """Positions as an array (..., count, d)."""
    array = check.numbers(name, value, gaps=True)
    if array.ndim < 2:
        raise ValueError(f"{name} must have shape (..., count, components), got {check.found_in(array)}")
    return array
