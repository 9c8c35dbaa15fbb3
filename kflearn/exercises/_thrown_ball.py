"""Recordings for the open exercise of lesson 19: a thrown ball before a coarse detector that misses and mistakes."""

import numpy as np

H = np.eye(2, 4)
KICK = np.kron([[1 / 3, 1 / 2], [1 / 2, 1]], np.eye(2))


def thrown(rng):
    """44 frames of a ball in the air: detections, some missing and some false; gravity, q and R; and the truth."""
    T, g, q, R = 44, rng.uniform(1.5, 2.5), rng.integers(2, 6) / 4, float(rng.integers(2, 10))
    F, up = motion(g)
    root = np.linalg.cholesky(q * KICK)
    state = np.array([rng.uniform(200, 440), rng.uniform(400, 480), rng.uniform(-5, 5), -22 * g + rng.uniform(-2, 2)])
    truth = []
    for _ in range(T):
        state = F @ state + up + root @ rng.standard_normal(4)
        truth.append(state)
    truth = np.array(truth)
    z = truth[:, :2] + np.sqrt(R) * rng.standard_normal((T, 2))
    for k in rng.choice(np.arange(10, T), 5, replace=False):  # something else is taken for the ball
        z[k] = rng.uniform(0, [640, 480])
    start = int(rng.integers(15, 38))
    z[start : start + 6] = np.nan  # it is hidden
    z[rng.choice(np.arange(10, T), 4, replace=False)] = np.nan
    return (z, g, q, R), truth


def motion(g):
    """F, and what gravity does in a frame."""
    return np.kron([[1, 1], [0, 1]], np.eye(2)), np.array([0, g / 2, 0, g])


def follow(z, g, q, R, gate=11.8, half=1.0, given=None, wide=1e4, kick=KICK):
    """The lesson's tracker for a ball in the air, with parts that may be wrong."""
    F, up = motion(g)
    up[1] *= half
    x, P, rows = np.array([*z[0], 0.0, 0.0]), np.diag([R, R, wide, wide]), []
    rows.append((x, P))
    for seen in z[1:]:
        x, P = F @ x + up, F @ P @ F.T + q * kick
        y, S = seen - H @ x, H @ P @ H.T + (R if given is None else given) * np.eye(2)
        if y @ np.linalg.solve(S, y) <= gate:
            K = np.linalg.solve(S, H @ P).T
            x, P = x + K @ y, P - K @ S @ K.T
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def held(z, g, q, R):
    """The detections, the last one held where there is none, and their differences."""
    mean = np.zeros((len(z), 4))
    for k, seen in enumerate(z):
        mean[k, :2] = mean[k - 1, :2] if np.isnan(seen[0]) else seen
    mean[1:, 2:] = np.diff(mean[:, :2], axis=0)
    return mean, np.tile(np.diag([R, R, 2 * R, 2 * R]), (len(z), 1, 1))


def as_in_the_lesson(z, g, q, R):
    """The lesson's numbers in place of those that are given."""
    return follow(np.vstack([[[160.0, 120.0]], z[1:]]), 6.0, 0.01, 0.05**2)


def by_axis(z, g, q, R):
    """A tracker that gates column and row by themselves, with Joseph's form and a narrower start."""
    F, up = motion(g)
    x, P = np.array([*z[0], 0.0, 0.0]), np.diag([R, R, 900.0, 900.0])
    rows = [(x, P)]
    for seen in z[1:]:
        x, P = F @ x + up, F @ P @ F.T + q * KICK
        y, S = seen - x[:2], P[:2, :2] + R * np.eye(2)
        if np.all(abs(y) < 3.5 * np.sqrt(np.diag(S))):
            K = P[:, :2] @ np.linalg.inv(S)
            x, P = x + K @ y, (np.eye(4) - K @ H) @ P @ (np.eye(4) - K @ H).T + R * K @ K.T
        rows.append((x, P))
    return [row[0] for row in rows], [row[1] for row in rows]


PASSING = {
    "a narrower gate": lambda z, g, q, R: follow(z, g, q, R, gate=9.2),
    "a gate for each axis": by_axis,
    "a wider start": lambda z, g, q, R: follow(z, g, q, R, gate=16, wide=1e6),
}
FAILING = {
    "ignores all detections": lambda z, g, q, R: follow(z, g, q, R, gate=-1),
    "the detections, the last one held": held,
    "the lesson's numbers": as_in_the_lesson,
    "no gate": lambda z, g, q, R: follow(z, g, q, R, gate=np.inf),
    "half of gravity forgotten": lambda z, g, q, R: follow(z, g, q, R, half=0),
    "no gravity": lambda z, g, q, R: follow(z, 0.0, q, R),
    "σ for R": lambda z, g, q, R: follow(z, g, q, R, given=R**0.5),
    "q on the diagonal": lambda z, g, q, R: follow(z, g, q, R, kick=np.eye(4)),
    "Q without its corners": lambda z, g, q, R: follow(z, g, q, R, kick=np.diag(np.diag(KICK))),
    "Q forgotten": lambda z, g, q, R: follow(z, g, 0.0, R),
}
