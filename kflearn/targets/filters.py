"""Filters for scans: the nearest reading, all readings by weight (PDA), or one each by assignment (GNN)."""

from dataclasses import dataclass

import numpy as np

from ..core.matrices import matvec, symmetric
from ..filters.moments import linearize
from ..filters.steps import at_step, predicted_belief, starting_belief
from ..models import checks as check
from ..models.arguments import check_belief, check_control_series, check_functions, check_model, check_stacks
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..results.track import Filtered, read_only, stack_in_time
from .assign import HOW, assigned
from .pairs import Pairs, check_sensor, compare, gate_limit, scan_readings


@dataclass(frozen=True, eq=False, repr=False)
class ScanTrack(Filtered):
    """The beliefs after each scan, and which readings they were made from.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n); `mean`, `cov`, `std` and `track[k]` as in a Track.
    predicted: Gaussian of the same shapes, before each scan.
    weights: (..., T, N + 1), which sum to 1: first the weight of "none of these readings", then that of each reading.
    nis: (..., T, N), of each reading against the prediction; NaN where a row has no reading.

    Examples
    --------
    >>> from kflearn import Gaussian, nearest_filter, random_walk
    >>> track = nearest_filter(random_walk(1, 9), [[[53.0], [80.0]], [[20.0], [56.0]]], Gaussian(50, 16))
    >>> print(track.weights.argmax(axis=-1) - 1)  # which reading was used
    [0 1]
    """

    predicted: Gaussian
    weights: np.ndarray
    nis: np.ndarray

    def __post_init__(self):
        super().__post_init__()
        object.__setattr__(self, "predicted", read_only(self.predicted))
        self.weights.flags.writeable = self.nis.flags.writeable = False

    @property
    def used(self) -> np.ndarray:
        """The reading with the largest weight, int (..., T); -1 where "none of these" weighs most."""
        return self.weights.argmax(axis=-1) - 1


def pda_weights(pairs, detection, clutter) -> np.ndarray:
    """The probability of each reading of a scan to be the target's own, and first that none of them is.

    Parameters
    ----------
    pairs : Pairs
        Of pair_up: N readings beside a prediction.
    detection : float
        P_D, the probability that the target gives a reading, above 0 and at most 1.
    clutter : float
        λ, the mean number of false readings per unit of volume in a scan, in one unit with the readings: above 0.

    Returns
    -------
    ndarray (..., N + 1)
        They sum to 1, and are 0 outside the gate. β_i ∝ e^(−NIS_i/2), β_0 ∝ λ √det(2πS) (1 − P_D P_G)/P_D.

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom and Tse 1975; Bar-Shalom, Daum and Huang 2009.

    Examples
    --------
    >>> from kflearn import Gaussian, pair_up, pda_weights, random_walk
    >>> pairs = pair_up(random_walk(0, 9), Gaussian(50, 16), [[53], [80], [42]], gate=0.99)
    >>> print(pda_weights(pairs, detection=0.9, clutter=0.02).round(3))
    [0.027 0.73  0.    0.243]
    """
    if not isinstance(pairs, Pairs):
        raise TypeError(f"pairs must come from pair_up, got {type(pairs).__name__}")
    check_sensor(detection, clutter)
    return _weights(pairs, detection, clutter)


def _weights(pairs, detection, clutter):
    """The same without checks: every log ratio is one to "none of these", whose own is 0."""
    ratio = pairs.log_ratio(detection, clutter)
    ratio = np.concatenate([np.zeros((*ratio.shape[:-1], 1)), ratio], axis=-1)
    weight = np.exp(ratio - ratio.max(axis=-1, keepdims=True))  # the largest is 1: nothing overflows
    return weight / weight.sum(axis=-1, keepdims=True)


def pda_filter(model, z, initial, u=None, *, detection, clutter, gate=0.99) -> ScanTrack:
    """Probabilistic data association: one target among false readings, every reading in the gate used by its weight.

    Parameters
    ----------
    model : LinearModel or NonlinearModel
        With n states and m components of a reading; f and h are linearised.
    z : array_like (..., T, N, m)
        Scans; a row of NaN is no reading.
    initial : Gaussian
        The belief one step before the first scan.
    u : array_like (T, p), optional
        Control inputs.
    detection, clutter
        P_D and λ, as in pda_weights.
    gate : float
        P_G, the probability that the target's own reading is inside the gate.

    Returns
    -------
    ScanTrack
        .mean, .cov and .std as in a Track, and .weights (..., T, N + 1).

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom and Tse 1975; Bar-Shalom, Daum and Huang 2009.

    Examples
    --------
    >>> from kflearn import Gaussian, pda_filter, random_walk
    >>> scans = [[[53.0], [80.0]], [[20.0], [56.0]]]
    >>> track = pda_filter(random_walk(1, 9), scans, Gaussian(50, 16), detection=0.9, clutter=0.01)
    >>> print(f"{track[-1]:.1f}", track.weights.round(2).tolist())
    N(53.7, 4.1) [[0.02, 0.98, 0.0], [0.02, 0.0, 0.98]]
    """
    z, u, belief, limit = _checked(model, z, initial, u, gate)
    check_sensor(detection, clutter)
    return _run(model, z, belief, u, (gate, limit), lambda pairs: _weights(pairs, detection, clutter))


def nearest_filter(model, z, initial, u=None, *, gate=0.99) -> ScanTrack:
    """The nearest neighbour: the reading with the smallest NIS is used as if it were the target's own.

    Where no reading is inside the gate the prediction stays.

    Parameters
    ----------
    model, z, initial, u, gate
        As in pda_filter.

    Returns
    -------
    ScanTrack
        Its weights are 0 and 1.

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Bar-Shalom, Willett and Tian 2011, *Tracking and Data Fusion*

    Examples
    --------
    >>> from kflearn import Gaussian, nearest_filter, random_walk
    >>> track = nearest_filter(random_walk(1, 9), [[[53.0], [80.0]], [[20.0], [56.0]]], Gaussian(50, 16))
    >>> print(f"{track[-1]:.1f}")
    N(53.7, 3.9)
    """
    z, u, belief, limit = _checked(model, z, initial, u, gate)
    return _run(model, z, belief, u, (gate, limit), _nearest)


def _nearest(pairs):
    """Weight 1 for the nearest reading inside the gate, or else for "none of these"."""
    nis = np.where(pairs.inside, pairs.nis, np.inf)
    return one_each(np.where(pairs.inside.any(axis=-1), nis.argmin(axis=-1), -1), nis.shape[-1])


def gnn_filter(model, z, initial, u=None, *, detection, clutter, gate=0.99, how="global") -> ScanTrack:
    """Global nearest neighbour: M known targets, each with one reading at most, the most probable assignment of a scan.

    Parameters
    ----------
    model, z, u, detection, clutter, gate
        As in pda_filter. All targets have the same model.
    initial : Gaussian
        The beliefs about the M targets one step before the first scan, mean (..., M, n).
    how : "global" or "greedy"
        As in assign.

    Returns
    -------
    ScanTrack
        With the axis of the targets in front of the time: mean (..., M, T, n). Its weights are 0 and 1.

    Raises
    ------
    ValueError, TypeError
        Naming the argument.

    References
    ----------
    Blackman and Popoli 1999, *Design and Analysis of Modern Tracking Systems*.

    Examples
    --------
    >>> from kflearn import Gaussian, gnn_filter, random_walk
    >>> two = Gaussian([[50.0], [56.0]], [[16.0]])
    >>> track = gnn_filter(random_walk(1, 9), [[[54.0], [49.0]]], two, detection=0.9, clutter=0.001)
    >>> print(track.used[:, 0], track.mean[:, 0, 0].round(1))
    [1 0] [49.3 54.7]
    """
    if isinstance(initial, Gaussian) and not initial.batch:
        raise ValueError("initial must have an axis for the targets, mean (..., M, n); for one target, (1, n)")
    z, u, belief, limit = _checked(model, z, initial, u, gate, targets=True)
    check_sensor(detection, clutter)
    check.word("how", how, HOW)

    def weigh(pairs):
        return one_each(assigned(-pairs.log_ratio(detection, clutter), 0.0, how), z.shape[-2])

    return _run(model, z[..., None, :, :, :], belief, u, (gate, limit), weigh)


def one_each(used, N):
    """Weights (..., N + 1) of 0 and 1 from the reading that is used, -1 for none."""
    return (used[..., None] == np.arange(-1, N)).astype(float)


def _checked(model, z, initial, u, gate, targets=False):
    """Scans, inputs, the start for each run and target, and the limit of the gate."""
    check_model(model)
    check_belief("initial", initial, model)
    z = scan_readings(model, z, (None, None, model.m))
    T = z.shape[-3]
    axes = check_stacks(model, T)
    if u is not None:
        u = check_control_series(model, u, T)
        u = u[..., None, :, :] if targets else u
        axes["u"] = u.shape[:-2]
    runs = (*z.shape[:-3], 1) if targets else z.shape[:-3]
    belief = starting_belief(initial, check.batches(z=runs, initial=initial.batch, **axes))
    check_functions(model, belief.mean, u, initial.std)
    return z, u, belief, gate_limit(gate, model.m)


def _run(model, z, belief, u, gate, weigh):
    """Step by step: predict, compare with all readings, weigh them, and take the mixture's mean and covariance."""
    steps = []
    for k in range(z.shape[-3]):
        predicted = predicted_belief(model, belief, at_step(u, k), k, linearize)
        pairs = compare(model, predicted, z[..., k, :, :], k, *gate)
        weights = weigh(pairs)
        belief = mixed(pairs, weights)
        steps.append((belief, predicted, weights, pairs.nis))
    filtered, predicted, weights, nis = zip(*steps, strict=True)
    return ScanTrack(
        stack_in_time(filtered), stack_in_time(predicted), np.stack(weights, axis=-2), np.stack(nis, axis=-2)
    )


def mixed(pairs, weights) -> Gaussian:
    """The mean and the covariance of the mixture of all possibilities, weighed: with β_0 nothing was learnt.

    P = β_0 P⁻ + (1 − β_0) P_c + K (Σ β_i y_i y_iᵀ − y yᵀ) Kᵀ, with P_c the covariance after a correction and
    y = Σ β_i y_i.
    """
    none, share = weights[..., 0, None, None], weights[..., 1:, None]
    y = np.where(share > 0, pairs.innovation, 0)
    pull = (share * y).sum(axis=-2)
    spread = (share * y).mT @ y - pull[..., :, None] * pull[..., None, :]
    cov = none * pairs.predicted.cov + (1 - none) * pairs.corrected + pairs.gain @ spread @ pairs.gain.mT
    return unchecked_gaussian(pairs.predicted.mean + matvec(pairs.gain, pull), symmetric(cov))
