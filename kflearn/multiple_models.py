"""Several models side by side: which of them explains the measurements, and what do they believe together?"""

from dataclasses import dataclass, field

import numpy as np

from . import _checks as check
from .arguments import check_belief, check_model, check_series
from .filtering import _correct, _predict
from .gaussian import Gaussian, trusted
from .models import LinearModel
from .moments import linearize
from .results import Filtered, scores, settled


@dataclass(frozen=True, eq=False)
class MultipleModelTrack(Filtered):
    """The joint belief of M models along time, and what each of them believes.

    filtered: Gaussian with mean (..., T, n) and cov (..., T, n, n), the mean and covariance of the mixture.
    mode_probabilities: (..., T, M), after each measurement. modes: Gaussian (..., T, M, n), the belief of each model in
    the coordinates of the whole state. log_likelihood: of the whole series, (...).
    """

    mode_probabilities: np.ndarray
    modes: Gaussian = field(repr=False)
    log_likelihood: np.ndarray = field(repr=False)

    def __post_init__(self):
        super().__post_init__()
        settled(self.modes)
        self.mode_probabilities.flags.writeable = False


def imm_filter(models, z, initial, transition, mode_probabilities, u=None, states=None, through=linearize):
    """The interacting-multiple-model filter: at each step the models exchange beliefs, predict, correct and are
    weighed.

    models: M models, linear and nonlinear ones mixed at will (`through` serves the nonlinear ones, see `moments`).
    z, initial, u: as in kalman_filter; one belief for all models at the start.
    transition: (M, M), transition[i, j] the probability that model j follows model i; its rows sum to 1.
    mode_probabilities: (M,), of the models at the start.
    states: for models of fewer states than `initial`, a list of M lists: which components of the whole state each
    model has. What a model lacks, it believes to be exactly 0 (a constant-velocity model: no acceleration).
    Returns a MultipleModelTrack. Source: Blom and Bar-Shalom 1988; weights are kept as logarithms.
    """
    models = lifted(models, initial, states)
    M = len(models)
    transition = check.shape("transition", check.numbers("transition", transition), (M, M))
    weights = _probabilities("mode_probabilities", mode_probabilities, M)
    for row in transition:
        _probabilities("each row of transition", row, M)
    return _filter(models, z, initial, transition, weights, u, through)


def mmae_filter(models, z, initial, u=None, mode_probabilities=None, states=None, through=linearize):
    """Multiple-model adaptive estimation: a bank of filters that never exchange anything, weighed by their
    likelihoods; one of the models is taken to be the true one, for ever.

    Arguments and result as in imm_filter; mode_probabilities: equal without it. Source: Magill 1965.
    """
    models = lifted(models, initial, states)
    M = len(models)
    equal = np.full(M, 1 / M)
    weights = equal if mode_probabilities is None else _probabilities("mode_probabilities", mode_probabilities, M)
    return _filter(models, z, initial, np.eye(M), weights, u, through)


def _filter(models, z, initial, transition, weights, u, through):
    """The loop. Inside it the axis of the models comes first: beliefs (M, ..., n), logarithms of weights (M, ...)."""
    n, M = initial.mean.shape[-1], len(models)
    checked = [check_series(model, z, initial, u) for model in models]
    z, u, _ = checked[0]
    batch = check.batches(**{f"model {j}": axes for j, (_, _, axes) in enumerate(checked)})
    bank = _bank(models, len(batch))
    beliefs = trusted(np.broadcast_to(initial.mean, (M, *batch, n)), np.broadcast_to(initial.cov, (M, *batch, n, n)))
    with np.errstate(divide="ignore"):
        log_transition, log_weights = np.log(transition), np.log(weights)
    ones = (1,) * len(batch)
    log_transition, log_weights = log_transition.reshape(M, M, *ones), log_weights.reshape(M, *ones)
    rows, total = [], 0.0
    for k in range(z.shape[-2]):
        beliefs, log_weights = _mix(beliefs, log_weights, log_transition)
        beliefs, log_likelihood = _step(bank, beliefs, z[..., k, :], None if u is None else u[..., k, :], k, through)
        log_weights = log_weights + log_likelihood
        evidence = np.logaddexp.reduce(log_weights, axis=0)
        log_weights = log_weights - evidence
        total = total + evidence
        rows.append((log_weights, beliefs.mean, beliefs.cov))
    log_weights, means, covs = zip(*rows, strict=True)
    modes = trusted(np.stack(means, axis=-2), np.stack(covs, axis=-3))
    shares = np.exp(np.stack(log_weights, axis=-1))
    last = trusted(np.moveaxis(modes.mean, 0, -2), np.moveaxis(modes.cov, 0, -3))
    return MultipleModelTrack(_mixture(shares, modes), np.moveaxis(shares, 0, -1), last, total)


def _mix(beliefs, log_weights, log_transition):
    """What each model starts the step with, and how probable it is before the measurement."""
    joint = log_weights[:, None] + log_transition  # from model i to model j
    arriving = np.logaddexp.reduce(joint, axis=0)
    alive = np.isfinite(arriving)
    if alive.all():
        return _mixture(np.exp(joint - arriving), beliefs), arriving
    own = np.eye(len(joint)).reshape(log_transition.shape)
    return _mixture(np.where(alive, np.exp(joint - np.where(alive, arriving, 0)), own), beliefs), arriving


def _mixture(shares, beliefs):
    """Mean and covariance of a mixture of M beliefs (M, ..., n): shares (M, ...), or (M, J, ...) for J mixtures."""
    shares = shares[..., None]
    mean = sum(share * x for share, x in zip(shares, beliefs.mean, strict=True))
    cov = 0.0
    for share, x, P in zip(shares, beliefs.mean, beliefs.cov, strict=True):
        apart = x - mean
        cov = cov + share[..., None] * (P + apart[..., :, None] * apart[..., None, :])
    return trusted(mean, cov)


def _step(bank, beliefs, z, u, k, through):
    """Every model predicts and corrects: beliefs (M, ..., n) and log-likelihoods (M, ...)."""
    if isinstance(bank, LinearModel):
        after, _, innovation = _correct(bank, _predict(bank, beliefs, u, k, linearize), z, k, linearize)
        return after, scores(innovation)[1]
    parts = []
    for model, mean, cov in zip(bank, beliefs.mean, beliefs.cov, strict=True):
        after, _, innovation = _correct(model, _predict(model, trusted(mean, cov), u, k, through), z, k, through)
        parts.append((after.mean, after.cov, scores(innovation)[1]))
    means, covs, logs = (np.stack(part) for part in zip(*parts, strict=True))
    return trusted(means, covs), logs


def lifted(models, initial, states):
    """The models, each written for the whole state."""
    if not isinstance(models, (list, tuple)) or not models:
        raise TypeError(f"models must be a list of models, got {type(models).__name__}")
    for model in models:
        check_model(model)
    measured = {model.m for model in models}
    if len(measured) > 1:
        raise ValueError(f"models must all measure the same components, got {sorted(measured)} of them")
    if states is None:
        for model in models:
            check_belief("initial", initial, model)
        return list(models)
    if not isinstance(initial, Gaussian):
        raise TypeError(f"initial must be a Gaussian, got {type(initial).__name__}")
    n = initial.mean.shape[-1]
    if not isinstance(states, (list, tuple)) or len(states) != len(models):
        raise ValueError(f"states must be a list of {len(models)} lists, one for each model, got {states!r}")
    return [_lift(model, n, kept) for model, kept in zip(models, states, strict=True)]


def _lift(model, n, kept):
    try:
        kept = [check.whole_number("each of states", i, least=0) for i in kept]
    except TypeError:
        raise TypeError(f"each of states must be a list of indices, got {kept!r}") from None
    if len(set(kept)) != model.n or len(kept) != model.n or max(kept) >= n:
        raise ValueError(f"each of states must hold as many different indices below {n} as its model has states")
    E = np.eye(n)[:, kept]
    if isinstance(model, LinearModel):
        B = None if model.B is None else E @ model.B
        return LinearModel(E @ model.F @ E.T, model.H @ E.T, E @ model.Q @ E.T, model.R, B)
    return model.replace(
        f=lambda x, *u: model.move(x[..., kept], *u) @ E.T,
        h=lambda x: model.measure(x[..., kept]),
        Q=E @ model.Q @ E.T,
        F_jacobian=lambda x, *u: E @ model.move_slope(x[..., kept], *u) @ E.T,
        H_jacobian=lambda x: model.measure_slope(x[..., kept]) @ E.T,
    )


def _bank(models, axes):
    """All models as one, the axis of models before `axes` batch axes, where they are linear: one step serves all."""
    if not all(isinstance(model, LinearModel) for model in models):
        return models
    matrices = {name: [getattr(model, name) for model in models] for name in "FHQRB"}
    pushed = [B for B in matrices["B"] if B is not None]
    matrices["B"] = [np.zeros_like(pushed[0]) if B is None else B for B in matrices["B"]] if pushed else None
    return LinearModel(**{name: same and _stacked(same, axes) for name, same in matrices.items()})


def _stacked(matrices, axes):
    """Matrices (rows, columns) or (..., T, rows, columns) as one stack (M, ..., T, rows, columns)."""
    wide = [M.reshape((1,) * (axes + 3 - M.ndim) + M.shape) for M in matrices]
    return np.stack(np.broadcast_arrays(*wide))


def _probabilities(name, value, M):
    array = check.shape(name, check.numbers(name, value), (M,))
    if (array < 0).any() or abs(array.sum(axis=-1) - 1).max() > 1e-9:
        raise ValueError(f"{name} must hold probabilities that sum to 1, got {array.tolist()}")
    return array
