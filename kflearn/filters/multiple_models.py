"""Several models side by side: which of them explains the measurements, and what do they believe together?"""

from dataclasses import dataclass

import numpy as np

from ..core.frozen import freeze
from ..models import checks as check
from ..models.arguments import check_input, check_series
from ..models.gaussian import Gaussian, unchecked_gaussian
from ..models.state_space import LinearModel
from ..results.track import Filtered, read_only, scores
from .lifting import difference_of, lifted
from .mixture import mix, mixture
from .moments import check_through, linearize
from .steps import at_step, corrected_belief, predicted_belief


@dataclass(frozen=True, eq=False, repr=False)
class MultipleModelTrack(Filtered):
    """The joint belief of M models along time, and what each of them believes.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n), the mean and covariance of the mixture; `mean`,
        `cov` and `std` are short for its own, `track[k]` is the mixture after step k.
    mode_probabilities: (..., T, M), after each measurement.
    modes: Gaussian (..., T, M, n), the belief of each model in the coordinates of the whole state.
    log_likelihood: of the whole series, (...).
    models: the models that the filter was given.

    The filter goes on where it stopped when it is given its track as `initial`.
    """

    mode_probabilities: np.ndarray
    modes: Gaussian
    log_likelihood: np.ndarray
    models: tuple
    _log_weights: np.ndarray  # of the last step, (..., M): a probability may be too small to be told from 0

    def __post_init__(self):
        super().__post_init__()
        object.__setattr__(self, "modes", read_only(self.modes))
        freeze((self.mode_probabilities, self.log_likelihood, self._log_weights))

    def _sizes(self):
        return f", M={self.mode_probabilities.shape[-1]} models"


def imm_filter(
    models, z, initial, u=None, *, transition, mode_probabilities=None, states=None, through=linearize
) -> MultipleModelTrack:
    """The interacting-multiple-model filter: models exchange beliefs, predict, correct and are weighed at each step.

    Parameters
    ----------
    models : list
        M models, linear and nonlinear ones mixed at will.
    z, initial, u
        As in kalman_filter; one belief for all models at the start. Or `initial` is the track of the readings before
        z, made by the same filter: then each model goes on with its own belief and probability.
    transition : array_like
        (M, M): transition[i, j] is the probability that model j follows model i; its rows sum to 1.
    mode_probabilities : array_like, optional
        (M,), the probabilities of the models at the start; equal without it. Not to be given with a track.
    states : list of lists, optional
        For models of fewer states than `initial`: which components of the whole state each model has. What a model
        lacks, it believes to be exactly 0 (a constant-velocity model: no acceleration).
    through : callable
        linearize, unscented(n) or cubature(n), for the nonlinear models.

    Returns
    -------
    MultipleModelTrack

    Raises
    ------
    ValueError, TypeError
        Naming the argument, where the pieces do not fit or f or h of a model returns NaN.

    References
    ----------
    Blom and Bar-Shalom 1988. Weights are kept as logarithms, so that no model is lost for ever.

    Examples
    --------
    >>> from kflearn import Gaussian, imm_filter, random_walk
    >>> quiet, lively = random_walk(0.01, 1), random_walk(4, 1)
    >>> often = [[0.9, 0.1], [0.1, 0.9]]
    >>> z = [0.1, 0.0, 0.2, 0.1, 4.0]
    >>> track = imm_filter([quiet, lively], z, Gaussian(0, 1), transition=often, mode_probabilities=[0.5, 0.5])
    >>> print([f"{probability:.2f}" for probability in track.mode_probabilities[-2:, 1]])  # lively, around the jump
    ['0.13', '0.94']
    """
    given, models = models, lifted(models, _together(initial), states)
    check_through(through)
    _check_as_many(initial, len(models))
    M = len(models)
    weights = _weights(initial, mode_probabilities, M)
    transition = check.numbers("transition", transition)
    if transition.shape != (M, M):
        raise ValueError(f"transition must have shape {(M, M)}, got {transition.shape}: one chain serves all steps")
    for row in transition:
        _probabilities("each row of transition", row, M)
    return _filter(tuple(given), models, z, initial, u, transition, weights, through)


def mmae_filter(
    models, z, initial, u=None, *, mode_probabilities=None, states=None, through=linearize
) -> MultipleModelTrack:
    """Multiple-model adaptive estimation: a bank of filters that never exchange anything, weighed by their likelihoods.

    One of the models is taken to be the true one, for ever.

    Parameters
    ----------
    models, z, initial, u, states, through
        As in imm_filter.
    mode_probabilities : array_like, optional
        As in imm_filter.

    Returns
    -------
    MultipleModelTrack

    Raises
    ------
    ValueError, TypeError
        As in imm_filter.

    References
    ----------
    Magill 1965.

    Examples
    --------
    >>> import numpy as np
    >>> from kflearn import Gaussian, mmae_filter, random_walk
    >>> z = np.random.default_rng(0).normal(0, 3, 100)
    >>> bank = [random_walk(0.01, R) for R in (1, 9)]
    >>> print(f"R = 9 has the probability {mmae_filter(bank, z, Gaussian(0, 1)).mode_probabilities[-1, 1]:.3f}")
    R = 9 has the probability 1.000
    """
    given, models = models, lifted(models, _together(initial), states)
    check_through(through)
    _check_as_many(initial, len(models))
    weights = _weights(initial, mode_probabilities, len(models))
    return _filter(tuple(given), models, z, initial, u, np.eye(len(models)), weights, through)


def _filter(given, models, z, initial, u, transition, weights, through):
    """The loop. Inside it the axis of the models comes first: beliefs (M, ..., n), logarithms of weights (M, ...)."""
    M = len(models)
    for model in given:
        check_input(model, u)
    checked = [check_series(model, z, _together(initial), u) for model in models]
    z, u, _ = checked[0]
    batch = check.batches(**{f"model {j}": axes for j, (_, _, axes) in enumerate(checked)})
    bank, beliefs = _bank(models, len(batch)), _beliefs(initial, M, batch)
    with np.errstate(divide="ignore"):
        log_transition = np.log(transition).reshape(M, M, *(1,) * len(batch))
    log_weights = np.moveaxis(np.broadcast_to(weights, (*batch, M)), -1, 0)
    rows, total, apart = [], 0.0, difference_of(models)
    for k in range(z.shape[-2]):
        beliefs, log_weights = mix(beliefs, log_weights, log_transition, apart)
        beliefs, log_likelihood = _step(bank, beliefs, z[..., k, :], at_step(u, k), k, through)
        log_weights = log_weights + log_likelihood
        evidence = np.logaddexp.reduce(log_weights, axis=0)
        log_weights = log_weights - evidence
        total = total + evidence
        rows.append((log_weights, beliefs.mean, beliefs.cov))
    return _track(rows, total, given, apart)


def _weights(initial, mode_probabilities, M):
    """Logarithms of the weights at the start: (M,), or (..., M) those at the end of a track."""
    if isinstance(initial, MultipleModelTrack):
        if mode_probabilities is not None:
            raise ValueError("mode_probabilities must be left out where initial is a track, which has its own")
        return initial._log_weights
    equal = np.full(M, 1 / M)
    weights = equal if mode_probabilities is None else _probabilities("mode_probabilities", mode_probabilities, M)
    with np.errstate(divide="ignore"):
        return np.log(weights)


def _check_as_many(initial, M):
    """A track to go on from has to be one of as many models."""
    if isinstance(initial, MultipleModelTrack) and initial.mode_probabilities.shape[-1] != M:
        found = initial.mode_probabilities.shape[-1]
        raise ValueError(f"initial must be a track of as many models as are given, {M}, got one of {found}")


def _together(initial):
    """One belief for all models: `initial` itself, or the mixture at the end of a track."""
    return initial[-1] if isinstance(initial, MultipleModelTrack) else initial


def _beliefs(initial, M, batch):
    """What each model believes at the start, (M, ..., n)."""
    n = initial.mean.shape[-1]
    if not isinstance(initial, MultipleModelTrack):
        return unchecked_gaussian(
            np.broadcast_to(initial.mean, (M, *batch, n)), np.broadcast_to(initial.cov, (M, *batch, n, n))
        )
    mean = np.broadcast_to(initial.modes.mean[..., -1, :, :], (*batch, M, n))
    cov = np.broadcast_to(initial.modes.cov[..., -1, :, :, :], (*batch, M, n, n))
    return unchecked_gaussian(np.moveaxis(mean, -2, 0), np.moveaxis(cov, -3, 0))


def _track(rows, total, given, apart):
    """The result: per step, the logarithms of the weights (M, ...), and the means and covariances of all models."""
    log_weights, means, covs = zip(*rows, strict=True)
    modes = unchecked_gaussian(np.stack(means, axis=-2), np.stack(covs, axis=-3))
    shares = np.exp(np.stack(log_weights, axis=-1))
    last = unchecked_gaussian(np.moveaxis(modes.mean, 0, -2), np.moveaxis(modes.cov, 0, -3))
    end = np.moveaxis(log_weights[-1], 0, -1)
    return MultipleModelTrack(mixture(shares, modes, apart), np.moveaxis(shares, 0, -1), last, total, given, end)


def _step(bank, beliefs, z, u, k, through):
    """Every model predicts and corrects: beliefs (M, ..., n) and log-likelihoods (M, ...)."""
    if isinstance(bank, LinearModel):
        predicted = predicted_belief(bank, beliefs, u, k, linearize)
        made = corrected_belief(bank, predicted, z, k, linearize, u)
        return made.belief, scores(made.innovation)[1]
    parts = []
    for model, mean, cov in zip(bank, beliefs.mean, beliefs.cov, strict=True):
        predicted = predicted_belief(model, unchecked_gaussian(mean, cov), u, k, through)
        made = corrected_belief(model, predicted, z, k, through, u)
        parts.append((made.belief.mean, made.belief.cov, scores(made.innovation)[1]))
    means, covs, logs = (np.stack(part) for part in zip(*parts, strict=True))
    return unchecked_gaussian(means, covs), logs


def _bank(models, axes):
    """All models as one, the axis of models before `axes` batch axes, where they are linear: one step serves all."""
    if not all(isinstance(model, LinearModel) for model in models):
        return models
    F, H, Q, R = (_stacked([getattr(model, name) for model in models], axes) for name in "FHQR")
    pushed = [model.B for model in models if model.B is not None]
    if not pushed:
        return LinearModel(F, H, Q, R)
    B = [np.zeros_like(pushed[0]) if model.B is None else model.B for model in models]
    return LinearModel(F, H, Q, R, _stacked(B, axes))


def _stacked(matrices, axes):
    """Matrices (rows, columns) or (..., T, rows, columns) as one stack (M, ..., T, rows, columns)."""
    wide = [M.reshape((1,) * (axes + 3 - M.ndim) + M.shape) for M in matrices]
    return np.stack(np.broadcast_arrays(*wide))


def _probabilities(name, value, M):
    """Probabilities (M,), after they were looked at."""
    array = check.numbers(name, value)
    if array.shape != (M,):
        raise ValueError(f"{name} must have shape ({M},), got {check.found_in(array)}")
    if (array < 0).any() or abs(array.sum() - 1) > 1e-9:
        raise ValueError(f"{name} must hold probabilities that sum to 1, got {array.tolist()}")
    return array
