"""Recordings for the open exercise of lesson 22: a cart whose sensor becomes worse, or better, at some moment."""

import numpy as np

GOOD, BAD, SETTLED = 1.0, 16.0, 45  # R in m², and the steps after which a filter should have noticed


def unknown_sensor(rng):
    """200 readings of a cart, some missing; F, Q and the start.

    The truth has R in its third column, and in its fourth 1 where there is a reading. Most gaps come late.
    """
    T, dt, q = 200, rng.integers(1, 4) / 4, rng.integers(1, 5) / 4
    F = np.array([[1, dt], [0, 1]])
    Q = q * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])
    mean, cov = np.array([rng.integers(-20, 20), rng.integers(-5, 6)]).astype(float), np.diag([4.0, 1.0])
    state, root, states = rng.multivariate_normal(mean, cov), np.linalg.cholesky(Q), []
    for _ in range(T):
        state = F @ state + root @ rng.standard_normal(2)
        states.append(state)
    first, second = (GOOD, BAD) if rng.random() < 0.5 else (BAD, GOOD)
    R = np.where(np.arange(T) < rng.integers(62, 78), first, second)
    z = np.array(states)[:, 0] + np.sqrt(R) * rng.standard_normal(T)
    missing = rng.choice(np.arange(3, T), 10, replace=False)
    z[np.append(missing[:4], 120 + 0.4 * missing[4:]).astype(int)] = np.nan
    return (z, F, Q, mean, cov), np.column_stack([states, R, np.isfinite(z)])


def settled(R, level):
    """The steps at which R has got that value, the first 45 after the change left out."""
    change = np.flatnonzero(np.diff(R))[0] + 1
    steps = np.arange(len(R))
    return (level == R) & (steps - change >= SETTLED)


def learn(z, F, Q, mean, cov, window=30, R=1.0, floor=0.05, rule=None, explained=True, all_of_them=False):
    """The lesson's filter, with R from a window of innovations; `rule` puts another estimate in its place."""
    x, P, recent, rows = mean, cov, [], []
    for reading in z:
        x, P = F @ x, F @ P @ F.T + Q
        if not np.isnan(reading):
            y = reading - x[0]
            recent.append(y * y)
            if rule:
                R = rule(R, y, P[0, 0])
            elif window and len(recent) >= window:
                last = recent if all_of_them else recent[-window:]
                R = max(np.mean(last) - explained * P[0, 0], floor)
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * y, P - np.outer(K, P[0])
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def fading(R, y, explained):
    """R̂ as a fading mean of what the prediction does not explain."""
    return max(0.95 * R + 0.05 * (y * y - explained), 0.1)


def bank(z, F, Q, mean, cov, candidates=(1.0, 4.0, 16.0), stay=0.98):
    """A bank of filters with fixed R whose weights may change; their beliefs are mixed at the end of each step only."""
    xs, Ps = [mean] * len(candidates), [cov] * len(candidates)
    weights, rows, M = np.full(len(candidates), 1 / len(candidates)), [], len(candidates)
    for reading in z:
        weights = stay * weights + (1 - stay) * (1 - weights) / (M - 1)
        for i, R in enumerate(candidates):
            x, P = F @ xs[i], F @ Ps[i] @ F.T + Q
            if not np.isnan(reading):
                S, y = P[0, 0] + R, reading - x[0]
                weights[i] *= np.exp(-y * y / S / 2) / np.sqrt(S)
                K = P[:, 0] / S
                x, P = x + K * y, P - np.outer(K, P[0])
            xs[i], Ps[i] = x, P
        weights = weights / weights.sum()
        x = weights @ np.array(xs)
        P = sum(w * (C + np.outer(m - x, m - x)) for w, m, C in zip(weights, xs, Ps, strict=True))
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def raw(z, F, Q, mean, cov):
    """The readings themselves, the last one held where there is none, and their differences."""
    held = z.copy()
    for k in np.flatnonzero(np.isnan(z)):
        held[k] = held[k - 1]
    return np.column_stack([held, np.gradient(held) / F[0, 1]]), np.tile(np.eye(2), (len(z), 1, 1))


def as_in_the_lesson(z, F, Q, mean, cov):
    """The lesson's cart in place of the one that is given."""
    push = np.array([0.005, 0.1])
    return learn(z, np.array([[1, 0.1], [0, 1]]), 0.04 * np.outer(push, push), mean, cov)


PASSING = {
    "a window of 20": lambda *given: learn(*given, window=20),
    "a window of 40": lambda *given: learn(*given, window=40),
    "a fading mean": lambda *given: learn(*given, rule=fading),
    "a bank that may change": bank,
}
FAILING = {
    "ignores all readings": lambda *given: learn(*given, window=0, R=1e12),
    "the readings themselves": raw,
    "the lesson's cart": as_in_the_lesson,
    "the data sheet": lambda *given: learn(*given, window=0),
    "a compromise, R = 4": lambda *given: learn(*given, window=0, R=4.0),
    "always careful, R = 16": lambda *given: learn(*given, window=0, R=16.0),
    "a window that is too long": lambda *given: learn(*given, window=100),
    "a bank that never changes": lambda *given: bank(*given, stay=1.0),
    "a bank of eight that never changes": lambda *given: bank(*given, candidates=2.0 ** np.arange(8), stay=1.0),
    "HP⁻Hᵀ not taken off": lambda *given: learn(*given, explained=False),
    "a mean of all innovations": lambda *given: learn(*given, all_of_them=True),
}
