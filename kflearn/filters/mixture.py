"""Mixtures of beliefs, one of each of M models; the axis of the models comes first, and weights are logarithms."""

import numpy as np

from ..models.gaussian import unchecked_gaussian


def mix(beliefs, log_weights, log_transition, apart):
    """What each model starts the step with, and how probable it is before the measurement."""
    joint = log_weights[:, None] + log_transition  # from model i to model j
    arriving = np.logaddexp.reduce(joint, axis=0)
    alive = np.isfinite(arriving)
    if alive.all():
        return mixture(np.exp(joint - arriving), beliefs, apart), arriving
    own = np.eye(len(joint)).reshape(log_transition.shape)
    return mixture(np.where(alive, np.exp(joint - np.where(alive, arriving, 0)), own), beliefs, apart), arriving


def mixture(shares, beliefs, apart=np.subtract):
    """Mean and covariance of a mixture of M beliefs (M, ..., n): shares (M, ...), or (M, J, ...) for J mixtures.

    apart: the difference of two states.
    """
    likeliest = None if apart is np.subtract else np.argmax(shares, axis=0)[..., None]
    shares = shares[..., None]
    if likeliest is None:
        mean = sum(share * x for share, x in zip(shares, beliefs.mean, strict=True))
    else:  # an angle has no mean, but differences from one model's angle have
        origin = beliefs.mean[0]
        for j, x in enumerate(beliefs.mean):
            origin = np.where(likeliest == j, x, origin)
        mean = origin + sum(share * apart(x, origin) for share, x in zip(shares, beliefs.mean, strict=True))
    cov = 0.0
    for share, x, P in zip(shares, beliefs.mean, beliefs.cov, strict=True):
        off = apart(x, mean)
        cov = cov + share[..., None] * (P + off[..., :, None] * off[..., None, :])
    return unchecked_gaussian(mean, cov)
