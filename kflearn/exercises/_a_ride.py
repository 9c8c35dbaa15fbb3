"""Recordings for the open exercise of lesson 27: rides with uneven steps, gaps, and readings that are far off."""

import numpy as np

REST = 30.0  # seconds at the beginning in which nothing moves
T, HOLE = 60, 46  # readings, and the one that follows the long hole
H = np.kron(np.eye(2), [[1, 0]])


def white(dt):
    """Q of a step on one axis, with q = 1."""
    return [[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]]


def moving(dt, q, push=white):
    """F and Q of a step, for [east, its speed, north, its speed]."""
    return np.kron(np.eye(2), [[1, dt], [0, 1]]), q * np.kron(np.eye(2), push(dt))


def a_ride(rng):
    """60 readings; q; and the truth. R is not told."""
    dt = rng.choice([0.5, 1.0, 1.0, 1.0, 2.0], T) * rng.choice([0.8, 1.0])
    dt[HOLE] = rng.integers(12, 20)
    time, q, sigma = np.cumsum(dt), rng.integers(2, 6) / 10, np.exp(rng.uniform(0.7, 2.3))
    state, states = np.array([rng.uniform(-200, 200), 0, rng.uniform(-200, 200), 0]), []
    for k, step in enumerate(dt):
        if time[k] >= REST:
            F, Q = moving(step, q)
            state = F @ state + np.linalg.cholesky(Q) @ rng.standard_normal(4)
        states.append(state)
    truth = np.array(states)
    z = truth @ H.T + sigma * rng.standard_normal((T, 2))
    ride = np.flatnonzero(time > REST + 4)
    ride = ride[abs(ride - HOLE) > 3]
    for k in rng.choice(ride, 3, replace=False):  # reflections
        z[k] += 30 * sigma * np.array([np.cos(a := rng.uniform(0, 6.28)), np.sin(a)])
    z[rng.choice(ride, 3, replace=False)] = np.nan
    z[HOLE] = np.nan  # so that P at the end of the hole is all Q's
    return (time, z, q), truth


def follow(time, z, q, R=None, gate=13.8, dt=None, start=0.1, push=white):
    """The lesson's filter: R from the rest, F and Q for each step, a gate."""
    R = np.nanvar(z[time < REST], axis=0, ddof=1).mean() if R is None else R
    x, P = np.array([z[0, 0], 0, z[0, 1], 0]), np.kron(np.eye(2), np.diag([R, start]))
    rows = [(x, P)]
    for step, seen in zip(np.diff(time) if dt is None else dt * np.ones(len(time) - 1), z[1:], strict=True):
        F, Q = moving(step, q, push)
        x, P = F @ x, F @ P @ F.T + Q
        y, S = seen - H @ x, H @ P @ H.T + R * np.eye(2)
        if y @ np.linalg.solve(S, y) < gate:
            K = np.linalg.solve(S, H @ P).T
            x, P = x + K @ y, P - K @ S @ K.T
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def smoothed(time, z, q):
    """The filter, and then the way back."""
    mean, cov = follow(time, z, q, start=9.0)
    for k in range(len(time) - 2, -1, -1):
        F, Q = moving(time[k + 1] - time[k], q)
        ahead = F @ cov[k] @ F.T + Q
        G = np.linalg.solve(ahead, F @ cov[k]).T
        mean[k] += G @ (mean[k + 1] - F @ mean[k])
        cov[k] += G @ (cov[k + 1] - ahead) @ G.T
    return mean, cov


def raw(time, z, q):
    """The readings themselves, and their differences for the speed."""
    mean, held = np.zeros((len(z), 4)), z.copy()
    for k in np.flatnonzero(np.isnan(z[:, 0])):
        held[k] = held[k - 1]
    mean[:, ::2] = held
    mean[1:, 1::2] = np.diff(held, axis=0) / np.diff(time)[:, None]
    return mean, np.tile(np.nanvar(z[time < REST]) * np.eye(4), (len(z), 1, 1))


def at_rest(z, time):
    """The readings of the first 30 s."""
    return z[time < REST]


PASSING = {
    "a narrower gate": lambda time, z, q: follow(time, z, q, gate=9.2),
    "a wider gate, a wider start": lambda time, z, q: follow(time, z, q, gate=25, start=9.0),
    "the smoother": smoothed,
}
FAILING = {
    "ignores all readings": lambda time, z, q: follow(time, z, q, gate=-1),
    "the readings themselves": raw,
    "the lesson's R and q": lambda time, z, q: follow(time, z, 0.5, R=9.47, start=9.0),
    "no gate": lambda time, z, q: follow(time, z, q, gate=np.inf),
    "one step, one second": lambda time, z, q: follow(time, z, q, dt=1.0),
    "one median step": lambda time, z, q: follow(time, z, q, dt=np.median(np.diff(time))),
    "R from the ride": lambda time, z, q: follow(time, z, q, R=np.nanvar(z, axis=0).mean()),
    "R about one mean for both axes": lambda time, z, q: follow(time, z, q, R=np.nanvar(at_rest(z, time))),
    "σ for R": lambda time, z, q: follow(time, z, q, R=np.nanvar(at_rest(z, time), axis=0, ddof=1).mean() ** 0.5),
    "one push a step": lambda time, z, q: follow(time, z, q, push=lambda d: [[d**4 / 4, d**3 / 2], [d**3 / 2, d**2]]),
}
