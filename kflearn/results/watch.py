"""Watching a filter that runs: the mean NIS of a window, and the sum that finds a small change."""

import numpy as np

from ..models import checks as check


def running_nis(nis, window, dof=1) -> np.ndarray:
    """The mean NIS of the last `window` readings, divided by the number of measured components; 1 is honest.

    Parameters
    ----------
    nis : array_like (..., T)
        As of `nis(track)`; NaN where nothing was measured.
    window : int
        How many steps.
    dof : int
        m, the number of measured components.

    Returns
    -------
    ndarray (..., T)
        NaN for the first window − 1 steps, and where nothing was measured in the whole window.

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    Examples
    --------
    >>> from kflearn import running_nis
    >>> print(running_nis([1.0, 0.0, 2.0, 9.0], window=2))
    [nan 0.5 1.  5.5]
    """
    nis, window = _scores(nis, dof), check.whole_number("window", window)
    if window > nis.shape[-1]:
        raise ValueError(f"window must not be longer than the {nis.shape[-1]} steps, got {window}")
    seen = ~np.isnan(nis)
    found = np.full(nis.shape, np.nan)
    total = _over(np.where(seen, nis, 0), window)
    with np.errstate(invalid="ignore"):
        found[..., window - 1 :] = total / (_over(seen, window) * dof)
    return found


def _over(values, window):
    """Sums of `window` neighbours, (..., T − window + 1), without the roundings of one long sum."""
    return np.lib.stride_tricks.sliding_window_view(values, window, axis=-1).sum(axis=-1)


def cusum(nis, limit, slack=0.5, dof=1) -> tuple[np.ndarray, np.ndarray]:
    """The cumulative sum of what the NIS is too large, which raises an alarm at a limit and begins again.

    g ← max(0, g + NIS/m − 1 − slack). An honest filter makes g fall by `slack` a step on average, so g stays near 0. If
    the NIS becomes larger by more than the slack, g climbs until the alarm.

    Parameters
    ----------
    nis : array_like (..., T)
        As of `nis(track)`; a step with NaN leaves g as it is.
    limit : float
        Where the alarm is: the higher, the fewer false alarms and the later the true one.
    slack : float
        How much too large the mean NIS may be, in shares of what is honest, without an alarm; above 0.
    dof : int
        m, the number of measured components.

    Returns
    -------
    g : ndarray (..., T)
        The sum after each step, at an alarm what it was before it began again.
    alarm : ndarray of bool (..., T)

    Raises
    ------
    ValueError or TypeError
        Naming the argument.

    References
    ----------
    E. S. Page, Continuous inspection schemes, Biometrika 41, 1954.

    Examples
    --------
    >>> from kflearn import cusum
    >>> g, alarm = cusum([1.0, 4.0, 4.0, 4.0, 1.0], limit=6)
    >>> print(g, alarm.astype(int))
    [0.  2.5 5.  7.5 0. ] [0 0 0 1 0]
    """
    nis = _scores(nis, dof)
    limit, slack = check.number("limit", limit, positive=True), check.number("slack", slack, positive=True)
    excess = np.where(np.isnan(nis), 0, nis / dof - 1 - slack)
    g, sums = np.zeros(nis.shape[:-1]), np.empty(nis.shape)
    for k in range(nis.shape[-1]):
        g = np.maximum(0, np.where(g > limit, 0, g) + excess[..., k])
        sums[..., k] = g
    return sums, sums > limit


def _scores(nis, dof):
    """NIS (..., T) after a look at it."""
    check.whole_number("dof", dof)
    nis = check.shape("nis", check.numbers("nis", nis, gaps=True), (None,))
    if (nis < 0).any():
        raise ValueError(f"nis must be at least 0, found {nis[nis < 0][0]:g}")
    return nis
