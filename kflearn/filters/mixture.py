"""Mixtures of beliefs, one of each of M models; the axis of the models comes first, and weights are logarithms."""

import numpy as np

from ..models.gaussian import unchecked_gaussian


def mix(beliefs, log_weights, log_transition):
    """What each model starts the step with, and how probable it is before the measurement."""
    joint = log_weights[:, None] + log_transition  # from model i to model j
    arriving = np.logaddexp.reduce(joint, axis=0)
    alive = np.isfinite(arriving)
    if alive.all():
        return mixture(np.exp(joint - arriving), beliefs), arriving
    own = np.eye(len(joint)).reshape(log_transition.shape)
    return mixture(np.where(alive, np.exp(joint - np.where(alive, arriving, 0)), own), beliefs), arriving


def mixture(shares, beliefs):
    """Mean and covariance of a mixture of M beliefs (M, ..., n): shares (M, ...), or (M, J, ...) for J mixtures."""
    shares = shares[..., None]
    mean = sum(share * x for share, x in zip(shares, beliefs.mean, strict=True))
    cov = 0.0
    for share, x, P in zip(shares, beliefs.mean, beliefs.cov, strict=True):
        apart = x - mean
        cov = cov + share[..., None] * (P + apart[..., :, None] * apart[..., None, :])
    return unchecked_gaussian(mean, cov)
