"""Scans: what a sensor reports of several targets at one step, with misses, with false readings, and in no order."""

from typing import NamedTuple

import numpy as np

from ..core.matrices import matvec, root, step_matrix
from ..models import checks as check
from ..models.arguments import check_model


class Scans(NamedTuple):
    """Readings of many steps, shuffled within each.

    Attributes
    ----------
    z : ndarray (..., T, N, m)
        The readings; a row of NaN where a scan has fewer than N.
    source : ndarray of int (..., T, N)
        Which target made a reading: 0, 1, …; -1 for a false reading, -2 for a row without a reading.
    """

    z: np.ndarray
    source: np.ndarray

    def of(self, target=0) -> np.ndarray:
        """The readings of one target, (..., T, m), NaN where it was not detected: what no tracker knows."""
        mine = (self.source == target)[..., None]
        seen = mine.any(axis=-2)
        return np.where(seen, np.where(mine, self.z, 0).sum(axis=-2), np.nan)


def scan_targets(model, x, detection, clutter, region, rng=None) -> Scans:
    """Scan targets: each is detected or missed, false readings come on top, and the order is lost.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        It says how a target is measured: h and R.
    x : array_like (..., T, A, n)
        True states of A targets; NaN where a target is not there.
    detection : float
        The probability with which a target that is there gives a reading, from 0 to 1.
    clutter : float
        λ, the mean number of false readings per unit of volume of the measurement space (for m = 2 in metres: per m²)
        in a scan, 0 or more. Their number is Poisson, their places are uniform in the region.
    region : array_like (m, 2)
        The lower and the upper end of each component of the measurement.
    rng : numpy.random.Generator, int or None
        A generator or a seed.

    Returns
    -------
    Scans
        z (..., T, N, m) and source (..., T, N), N being the largest number of readings in a scan.

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom, Willett and Tian 2011, *Tracking and Data Fusion*

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import random_walk, scan_targets
    >>> scans = scan_targets(random_walk(0, 1), np.zeros((50, 1, 1)), 0.9, 0.02, [[-100, 100]], rng=1)
    >>> print(f"{(scans.source == 0).mean(axis=0).sum():.2f} true, {(scans.source == -1).sum() / 50:.2f} false a scan")
    0.96 true, 3.52 false a scan
    """
    x, region = _checked(model, x, detection, clutter, region)
    rng = check.generator("rng", rng)
    z = np.stack([_measured(model, x[..., k, :, :], k, rng) for k in range(x.shape[-3])], axis=-3)
    seen = ~np.isnan(z).any(axis=-1) & (rng.random(z.shape[:-1]) < detection)
    count = rng.poisson(clutter * np.prod(region[:, 1] - region[:, 0]), z.shape[:-2])
    there = np.arange(count.max()) < count[..., None]
    false = rng.uniform(region[:, 0], region[:, 1], (*there.shape, model.m))
    targets = np.broadcast_to(np.arange(z.shape[-2]), seen.shape)
    source = np.concatenate([np.where(seen, targets, -2), np.where(there, -1, -2)], axis=-1)
    return _shuffled(np.concatenate([z, false], axis=-2), source, rng)


def _checked(model, x, detection, clutter, region):
    """True states and region as arrays, after a look at all arguments."""
    check_model(model)
    x = check.shape("x", check.numbers("x", x, gaps=True), (None, None, model.n))
    if not 0 <= check.number("detection", detection) <= 1:
        raise ValueError(f"detection must be a probability from 0 to 1, got {detection}")
    check.number("clutter", clutter, least=0)
    region = check.shape("region", check.numbers("region", region), (model.m, 2), exact=True)
    if not (region[:, 0] < region[:, 1]).all():
        raise ValueError("region must have a lower end below the upper end in each row")
    return x, region


def _measured(model, x, k, rng):
    """The readings (..., A, m) of all targets at step k; NaN where there is no target."""
    there = ~np.isnan(x).any(axis=-1, keepdims=True)
    noise = matvec(root(step_matrix(model.R, k)), rng.standard_normal((*x.shape[:-1], model.m)))
    return np.where(there, model.measure(np.where(there, x, 0), None, k) + noise, np.nan)


def _shuffled(z, source, rng):
    """The readings of each scan in random order, those that are none last, and as few rows as possible."""
    key = np.where(source == -2, 2, rng.random(source.shape))
    order = np.argsort(key, axis=-1)[..., : max(1, (source != -2).sum(axis=-1).max())]
    source = np.take_along_axis(source, order, axis=-1)
    z = np.take_along_axis(z, order[..., None], axis=-2)
    return Scans(np.where((source == -2)[..., None], np.nan, z), source)
