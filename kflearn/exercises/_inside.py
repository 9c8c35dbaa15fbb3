"""What a learner's filter does, read from the means and covariances that it returned; the signs of open exercises.

A step without a reading shows what the filter adds to x and to P; a step with one shows the R that it uses, infinite
where the reading is refused. All this holds for a filter, and not for a smoother: a sign speaks of exact matches only.
"""

import copy
import itertools

import numpy as np

from kflearn.exercises._judge import pair


def added(mean, cov, F):
    """What each step but the first adds to F x and to F P Fᵀ, where nothing was read."""
    F = np.broadcast_to(F, (len(mean) - 1, *np.shape(F)[-2:]))
    return mean[1:] - (F @ mean[:-1, :, None])[..., 0], cov[1:] - F @ cov[:-1] @ F.mT


def used_R(cov, F, Q, H):
    """The R with which each step but the first made P smaller, the mean of the axes; infinite where it did not."""
    ahead = np.linalg.inv(F @ cov[:-1] @ np.swapaxes(F, -1, -2) + Q)
    known = np.trace(H @ ahead @ H.T, axis1=-2, axis2=-1)
    more = np.trace(H @ (np.linalg.inv(cov[1:]) - ahead) @ H.T, axis1=-2, axis2=-1)
    return np.where(more > 1e-6 * known, len(H) / np.where(more > 0, more, 1), np.inf)


def recognised(found, table, scale):
    """The sentence of the first row of the table that every recording agrees with, within a thousandth of a scale.

    table holds (what it would be in each recording, sentence); a sentence of None ends the search: all is right.
    """
    for wanted, sentence in table:
        if all(np.all(abs(f - w) <= 2e-3 * s) for f, w, s in zip(found, wanted, scale, strict=True)):
            return sentence
    return None


def predictions(z_at=0, words=None):
    """A sign: what is returned for a step does not change when the reading of this step is taken away."""

    def sign(answer, answers, recordings):
        inputs, mean = list(recordings[0][0]), pair(answers[0])[0]
        whole, changed = inputs[z_at], []
        there = np.flatnonzero(~np.isnan(whole.reshape(len(whole), -1)).any(axis=1))
        for k in there[[len(there) * part // 10 for part in (6, 7, 8)]]:
            given = copy.deepcopy(inputs)
            given[z_at][k] = np.nan
            again = pair(answer(*given))[0]
            changed.append([not np.allclose(again[k:][i], mean[k:][i], rtol=1e-9) for i in (0, 1)])
        at, later = np.array(changed).T
        return words or PREDICTIONS if later.any() and not at.any() else None

    return sign


PREDICTIONS = (
    "What you return for a step does not depend on the reading of that step, only on those before it: these are the "
    "predictions. Store x and P after the correction, which uses the reading of the same step."
)


def same_P(steps):
    """A sign: the covariance is the same in all steps, which may be called otherwise; and perhaps the mean too."""

    def sign(answer, answers, recordings):
        pairs = [pair(each) for each in answers]
        if not all(np.allclose(cov, cov[0], rtol=1e-9, atol=0) for _, cov in pairs):
            return None
        if all(np.allclose(mean, mean[0], rtol=1e-9, atol=0) for mean, _ in pairs):
            return f"Your state and your P are the same in all {steps}: no reading is used. Predict and correct."
        return f"Your P is the same in all {steps}, as if it were not predicted and not corrected. Predict and correct it as the lesson's filter does."

    return sign


def another_order(marks, words):
    """A sign: all marks pass when the states are put in another order."""

    def sign(answer, answers, recordings):
        truths, pairs = [truth for _, truth in recordings], [pair(each) for each in answers]
        for order in map(list, itertools.permutations(range(pairs[0][0].shape[1]))):
            turned = [(mean[:, order], cov[:, order][:, :, order]) for mean, cov in pairs]
            if all(mark.verdict(mark.value(turned, truths), turned, recordings) is None for mark in marks):
                return words
        return None

    return sign


def share(unused, which):
    """Which share of some readings is left unused, all recordings together."""
    picked = np.concatenate([u[w] for u, w in zip(unused, which, strict=True)])
    return picked.mean() if picked.size else 0.0
