"""Recordings for the open exercise of lesson 13: a radar that measures distance and bearing."""

import numpy as np

from kflearn import angle_difference
from kflearn.exercises._judge import Mark, inside, nees, pair

STEPS, F, Q = 100, np.kron(np.eye(2), [[1, 1], [0, 1]]), np.diag([0.005, 0.01, 0.005, 0.01])
R = np.diag([5.0**2, 0.02**2])
COV = np.diag([30.0**2, 2.0**2, 30.0**2, 2.0**2])
NARROW = np.diag([2.0**2, 0.3**2, 2.0**2, 0.3**2])  # the place is known so well that the first second of motion counts


def recording(rng):
    """((readings (100, 2), mean and covariance of the start), true states (100, 4)); half of them pass in the west.

    Some starts are known well, so that the second before the first reading counts, and these targets pass nearer.
    """
    side, near = rng.choice([-1, 1]), rng.random() < 0.4
    far, ahead = (rng.uniform(10, 20), rng.uniform(5, 30)) if near else (rng.uniform(120, 300), rng.uniform(350, 500))
    speed, cov = (rng.uniform(8, 11), NARROW) if near else (rng.uniform(6, 10), COV)
    mean = np.array([side * far, rng.uniform(-1, 1), -ahead, speed])
    if rng.random() < 0.5:
        mean[2:] = -mean[2:]
    x, truth = mean + rng.normal(size=4) * np.sqrt(np.diag(cov)), np.empty((STEPS, 4))
    for k in range(STEPS):
        x = F @ x + rng.normal(size=4) * np.sqrt(np.diag(Q))
        truth[k] = x
    z = np.stack([np.hypot(truth[:, 0], truth[:, 2]), np.arctan2(truth[:, 2], truth[:, 0])], axis=1)
    z = z + rng.normal(size=z.shape) * np.sqrt(np.diag(R))
    z[:, 1] = angle_difference(z[:, 1], 0, 2 * np.pi)
    return (z, mean, cov.copy()), truth


def place_error(first=0):
    """The rms distance of the place from the truth."""

    def value(answers, truths):
        errors = [(pair(a)[0] - t)[first:, [0, 2]] for a, t in zip(answers, truths, strict=True)]
        return np.sqrt(np.mean(np.sum(np.concatenate(errors) ** 2, axis=-1)))

    return value


def nees_of_the_first(steps):
    """The mean NEES of the first readings, divided by the number of states."""
    return lambda answers, truths: nees()(
        [tuple(part[:steps] for part in pair(a)) for a in answers], [t[:steps] for t in truths]
    )


def within(state, name):
    """The mark of how often the truth lies within ±2σ."""
    return Mark(
        f"true {name} inside ±2σ",
        inside(state),
        91,
        98.5,
        below="Your σ is too small for your errors. Either P is too small (Q, R), or the place is wrong (what is expected, the innovation, H, the order).",
        above="Your σ is too large for your errors: P is not made small enough by the readings, or R or Q is too large.",
        unit="%",
    )


MARKS = [
    Mark(
        "place error (rms)",
        place_error(),
        high=4.6,
        above="Your place is further off than it need be. Print both innovations and their claimed σ, the roots of the diagonal of S, for "
        "one of your own recordings: the one that does not fit its σ, far too large or far too small, shows whether distance or bearing goes wrong.",
        unit="m",
    ),
    within(0, "east"),
    within(2, "north"),
    Mark(
        "NEES / n",
        nees(),
        0.85,
        1.25,
        below="Your P is too large for your errors: compare Q, R and the correction of P with the text.",
        above="Your errors are larger than P says. Is it the innovation, Q, R, H, or the order of the states?",
    ),
    Mark(
        "NEES / n of the first five readings",
        nees_of_the_first(5),
        0.5,
        2,
        below="At the beginning your P is too large: does it start from `cov`?",
        above="At the beginning your errors are larger than P says. Look at the start, the second before the first reading, the innovation, R, and the state at which H is taken.",
    ),
]


# ---- designs


def seen(x):
    """Distance and bearing of a state, and their slope."""
    r = np.hypot(x[0], x[2])
    H = np.array([[x[0] / r, 0, x[2] / r, 0], [-x[2] / r**2, 0, x[0] / r**2, 0]])
    return np.array([r, np.arctan2(x[2], x[0])]), H


def predicted(x, P, Q=Q):
    """State and covariance a second later."""
    return F @ x, F @ P @ F.T + Q


def extended(z, mean, cov, rows=(0, 1), wrap=True, R=R, move=predicted, first=True, early="", back=False, **seen):
    """The extended filter, with places for mistakes."""
    x, P, means, covs, rows = mean, cov, [], [], list(rows)
    for k, reading in enumerate(z):
        before = x
        if k or first:
            x, P = move(x, P)
        if rows:
            y, H = against(reading, x, wrap, **seen)
            H = against(reading, before, wrap, **seen)[1] if early else H
            y = against(reading, before, wrap, **seen)[0] if early == "both" else y
            K = P @ H[rows].T @ np.linalg.inv(H[rows] @ P @ H[rows].T + R[np.ix_(rows, rows)])
            x, P = x + K @ (-y if back else y)[rows], (np.eye(4) - K @ H[rows]) @ P
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def against(reading, x, wrap, expect=None, slope=None):
    """Innovation and H at a state, or what stands there by mistake."""
    expected, H = seen(x)
    y = reading - (expected if expect is None else expect(x))
    turns = {True: [1], "both": [0, 1]}.get(wrap, [])  # what is taken the short way round
    y[turns] = angle_difference(y[turns], 0, 2 * np.pi)
    if wrap == "remainder":
        y[1] %= 2 * np.pi
    return y, H if slope is None else slope(H, x)


def converted(z, mean, cov, R=R, turned=True):
    """A linear filter of the places that the readings mean, with R turned into the plane."""
    x, P, H, means, covs = mean, cov, np.eye(4)[[0, 2]], [], []
    for r, angle in z:
        x, P = F @ x, F @ P @ F.T + Q
        turn = np.array([[np.cos(angle), -r * np.sin(angle)], [np.sin(angle), r * np.cos(angle)]])
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + (turn @ R @ turn.T if turned else R))
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
    "slope of the bearing with the wrong sign": lambda z, mean, cov: extended(
        z, mean, cov, slope=lambda H, x: H * [[1], [-1]]
    ),
    "corrects first": lambda z, mean, cov: extended(z, mean, cov, first=False),
    "σ for R": lambda z, mean, cov: extended(z, mean, cov, R=np.sqrt(R)),
    "slope before the prediction": lambda z, mean, cov: extended(z, mean, cov, early="H"),
    "Q twice": lambda z, mean, cov: extended(z, mean, cov, move=lambda x, P: predicted(x, P, 2 * Q)),
    "Q = 0": lambda z, mean, cov: extended(z, mean, cov, move=lambda x, P: predicted(x, P, 0 * Q)),
}
