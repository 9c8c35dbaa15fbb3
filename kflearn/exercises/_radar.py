"""Recordings for the open exercise of lesson 13: a radar that measures distance and bearing."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._judge import pair

STEPS, F, Q = 100, np.kron(np.eye(2), [[1, 1], [0, 1]]), np.diag([0.005, 0.01, 0.005, 0.01])
R = np.diag([5.0**2, 0.02**2])
COV = np.diag([30.0**2, 2.0**2, 30.0**2, 2.0**2])


def recording(rng):
    """((readings (100, 2), mean and covariance of the start), true states (100, 4)); half of them pass in the west."""
    side = rng.choice([-1, 1])
    mean = np.array([side * rng.uniform(120, 300), rng.uniform(-1, 1), rng.uniform(-500, -350), rng.uniform(6, 10)])
    if rng.random() < 0.5:
        mean[2:] = -mean[2:]
    x, truth = mean + rng.normal(size=4) * np.sqrt(np.diag(COV)), np.empty((STEPS, 4))
    for k in range(STEPS):
        x = F @ x + rng.normal(size=4) * np.sqrt(np.diag(Q))
        truth[k] = x
    z = np.stack([np.hypot(truth[:, 0], truth[:, 2]), np.arctan2(truth[:, 2], truth[:, 0])], axis=1)
    z = z + rng.normal(size=z.shape) * np.sqrt(np.diag(R))
    z[:, 1] = angle_difference(z[:, 1], 0, 2 * np.pi)
    return (z, mean, COV.copy()), truth


def place_error(first=0):
    """The rms distance of the place from the truth."""

    def value(answers, truths):
        errors = [(pair(a)[0] - t)[first:, [0, 2]] for a, t in zip(answers, truths, strict=True)]
        return np.sqrt(np.mean(np.sum(np.concatenate(errors) ** 2, axis=-1)))

    return value


# ---- designs


def seen(x):
    """Distance and bearing of a state, and their slope."""
    r = np.hypot(x[0], x[2])
    H = np.array([[x[0] / r, 0, x[2] / r, 0], [-x[2] / r**2, 0, x[0] / r**2, 0]])
    return np.array([r, np.arctan2(x[2], x[0])]), H


def extended(z, mean, cov, rows=(0, 1), wrap=True, sign=1, Q=Q):
    """The extended filter, with places for mistakes."""
    x, P, means, covs, rows = mean, cov, [], [], list(rows)
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        if rows:
            expected, H = seen(x)
            H = (H * np.array([[1], [sign]]))[rows]
            y = reading - expected
            y[1] = angle_difference(y[1], 0, 2 * np.pi) if wrap else y[1]
            K = P @ H.T @ np.linalg.inv(H @ P @ H.T + R[np.ix_(rows, rows)])
            x, P = x + K @ y[rows], (np.eye(4) - K @ H) @ P
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def converted(z, mean, cov):
    """A linear filter of the places that the readings mean, with R turned into the plane."""
    x, P, H, means, covs = mean, cov, np.eye(4)[[0, 2]], [], []
    for r, angle in z:
        x, P = F @ x, F @ P @ F.T + Q
        turn = np.array([[np.cos(angle), -r * np.sin(angle)], [np.sin(angle), r * np.cos(angle)]])
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + turn @ R @ turn.T)
        x = x + K @ (turn[:, 0] * r - H @ x)
        P = (np.eye(4) - K @ H) @ P
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def raw(z, mean, cov):
    places = z[:, 0] * np.array([np.cos(z[:, 1]), np.sin(z[:, 1])])
    speeds = np.diff(places, axis=1, prepend=places[:, :1])
    states = np.stack([places[0], speeds[0], places[1], speeds[1]], axis=1)
    return states, np.tile(np.diag([50.0, 100, 50, 100]), (STEPS, 1, 1))


PASSING = {"extended filter": extended, "places from the readings": converted}
FAILING = {
    "raw readings": raw,
    "ignores the readings": lambda z, mean, cov: extended(z, mean, cov, rows=()),
    "the lesson's filter, distance only": lambda z, mean, cov: extended(z, mean, cov, rows=(0,)),
    "bearing subtracted plainly": lambda z, mean, cov: extended(z, mean, cov, wrap=False),
    "slope of the bearing with the wrong sign": lambda z, mean, cov: extended(z, mean, cov, sign=-1),
    "Q = 0": lambda z, mean, cov: extended(z, mean, cov, Q=0 * Q),
}
