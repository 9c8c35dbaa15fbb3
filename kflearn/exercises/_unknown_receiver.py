"""Recordings for the open exercise of lesson 7: a ship's position from a receiver whose accuracy nobody tells."""

import numpy as np

from kflearn.exercises._judge import pair

STEPS, F, Q = 100, np.array([[1.0, 1.0], [0.0, 1.0]]), np.diag([0.005, 0.01])
MEAN, COV = np.zeros(2), np.diag([50.0**2, 5.0**2])


def recording(rng):
    """Readings (100,) of a ship's position east, once a second, and its true position and speed (100, 2)."""
    sigma = np.exp(rng.uniform(np.log(2), np.log(40)))
    jolts = rng.normal(size=(STEPS, 2)) * np.sqrt(np.diag(Q))
    x, truth = MEAN + rng.normal(size=2) * np.sqrt(np.diag(COV)), np.empty((STEPS, 2))
    for k in range(STEPS):
        x = F @ x + jolts[k]
        truth[k] = x
    return (truth[:, 0] + rng.normal(0, sigma, STEPS),), truth


def honest_share(low=0.5, high=2.0):
    """The share of the recordings, in per cent, whose own NEES/n lies between two limits."""

    def value(answers, truths):
        good = []
        for answer, truth in zip(answers, truths, strict=True):
            mean, cov = pair(answer)
            error = truth - mean
            score = np.mean(np.sum(error * np.linalg.solve(cov, error[..., None])[..., 0], axis=-1)) / 2
            good.append(low < score < high)
        return 100 * np.mean(good)

    return value


def of_errors(answers, recordings):
    """What to look at where the errors are too large."""
    if all(
        np.allclose(pair(answer)[0][:, 0], inputs[0]) for answer, (inputs, _) in zip(answers, recordings, strict=True)
    ):
        return "Your positions are the readings themselves: a filter with the right R is nearer to the truth."
    return "That is more than a filter with the right R needs. Does each recording get an R of its own?"


def lacks_Q(answer):
    """Whether the covariances are those of F P Fᵀ and a reading of the position, without a Q in between."""
    cov = pair(answer)[1]
    gained = np.linalg.inv(cov[1:20]) - np.linalg.inv(F @ cov[:19] @ F.T)
    return np.allclose(gained[:, 1], 0, atol=1e-6 * np.abs(np.linalg.inv(cov[1:20])).max())


def of_claims(answers, recordings):
    """What to look at where the claims are too small."""
    if all(map(lacks_Q, answers)):
        return "The claim is too small: your P moves with F but gains no Q. Is Q added in each prediction?"
    if all(
        np.allclose(pair(answer)[0][:, 0], inputs[0]) for answer, (inputs, _) in zip(answers, recordings, strict=True)
    ):
        return "The claim is too small for the readings themselves: theirs is R, different in each recording."
    return "The claim is too small: is R the variance, and does every recording get its own?"


# ---- designs


def run(z, R, Q=Q):
    """The lesson's filter: the means, the covariances and the NIS."""
    x, P, means, covs, scores = MEAN, COV, [], [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        innovation, S = reading - x[0], P[0, 0] + R
        K = P[:, 0] / S
        x, P = x + K * innovation, P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
        scores.append(innovation**2 / S)
    return np.array(means), np.array(covs), np.array(scores)


def by_differences(z):
    """R from the second differences, which contain hardly anything but noise: six times R."""
    return run(z, np.var(np.diff(z, 2)) / 6)[:2]


def by_scale(z):
    """R scaled by the NIS, four times: where the filter is surprised too often, R was too small."""
    R = 100.0
    for _ in range(4):
        R = R * np.mean(run(z, R)[2])
    return run(z, R)[:2]


def by_median(z):
    """R from the middle of the second differences, which a few wild readings would not change."""
    return run(z, (np.median(abs(np.diff(z, 2))) / 0.6745) ** 2 / 6)[:2]


PASSING = {
    "second differences": by_differences,
    "R times the NIS, four times": by_scale,
    "median of second differences": by_median,
}
FAILING = {
    "the lesson's R": lambda z: run(z, 100.0)[:2],
    "ignores the readings": lambda z: run(z, 1e12)[:2],
    "raw readings": lambda z: (np.stack([z, 0 * z], axis=1), np.tile(np.diag([np.var(np.diff(z)) / 2, 25]), (STEPS, 1, 1))),
    "too modest": lambda z: run(z, np.var(np.diff(z, 2)))[:2],
    "too sure": lambda z: run(z, np.var(np.diff(z, 2)) / 36)[:2],
    "Q forgotten": lambda z: run(z, np.var(np.diff(z, 2)) / 6, 0 * Q)[:2],
    "R from the scatter of z": lambda z: run(z, np.var(z))[:2],
}  # fmt: skip
