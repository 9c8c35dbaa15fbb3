"""Recordings for the open exercise of lesson 11: a cart whose readings fail for a while."""

import numpy as np

from kflearn.exercises._judge import nees, pair

STEPS = 200


def motion(dt, sd):
    """F and Q where the acceleration, of standard deviation sd, stays the same during a step."""
    push = np.array([dt**2 / 2, dt])
    return np.array([[1, dt], [0, 1]]), sd**2 * np.outer(push, push)


def recording(rng):
    """((readings (200,) with gaps, dt, sd of the acceleration, sigma of a reading), true position and speed (200, 2)).

    In some recordings the readings are so fine that what matters is Q, with its corners.
    """
    dt, sd, sigma = rng.choice([0.5, 1.0, 2.0]), rng.uniform(0.2, 0.4), rng.uniform(2, 6)
    if rng.random() < 0.35:
        sd = rng.uniform(0.5, 0.6)
        sigma = rng.uniform(0.4, 0.7) * sd * dt**2
    F, _ = motion(dt, sd)
    x, truth = np.array([rng.uniform(-100, 100), rng.normal(0, 3)]), np.empty((STEPS, 2))
    for k in range(STEPS):
        truth[k] = x
        x = F @ x + np.array([dt**2 / 2, dt]) * rng.normal(0, sd)
    z = truth[:, 0] + rng.normal(0, sigma, STEPS)
    for begin in (rng.integers(30, 70), rng.integers(110, 150)):
        z[begin : begin + rng.integers(6, 13)] = np.nan
    z[rng.integers(160, 190, 4)] = np.nan
    return (z, float(dt), float(sd), float(sigma)), truth


def run(z, F, Q, R, x, P):
    """A Kalman filter that predicts only where there is no reading."""
    means, covs = [x], [P]
    for reading in z[1:]:
        x, P = F @ x, F @ P @ F.T + Q
        if np.isfinite(reading):
            K = P[:, 0] / (P[0, 0] + R)
            x, P = x + K * (reading - x[0]), P - np.outer(K, P[0])
        means.append(x)
        covs.append(P)
    return np.array(means), np.array(covs)


def honest_at(step):
    """The mean NEES / 2 of the recordings with that dt: Q depends on dt."""

    def value(answers, truths):
        rows = [(a, t) for a, t in zip(answers, truths, strict=True) if abs(step_of(t) - step) < 0.01]
        return nees()(*zip(*rows, strict=True))

    return value


def honest_where_fine(answers, truths):
    """The mean NEES / 2 where one step's acceleration moves the cart about as far as a reading's error."""
    rows = [(a, t) for a, t in zip(answers, truths, strict=True) if acceleration_of(t) > 0.45]
    return nees()(*zip(*rows, strict=True))


def honest_at_first(answers, truths):
    """The mean NEES / 2 of the first belief."""
    return nees()([tuple(part[:1] for part in pair(a)) for a in answers], [t[:1] for t in truths])


def acceleration_of(truth):
    """The root mean square acceleration of a recording."""
    return np.sqrt(np.mean(np.diff(truth[:, 1]) ** 2)) / step_of(truth)


def step_of(truth):
    """dt, from the way and the mean speed: exact, because the acceleration stays the same during a step."""
    return np.median(2 * np.diff(truth[:, 0]) / (truth[1:, 1] + truth[:-1, 1]))


# ---- designs


def from_the_first_reading(z, dt, sd, sigma):
    """The speed at the start: 0, give or take 3 m/s."""
    return run(z, *motion(dt, sd), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9]))


def vague(z, dt, sd, sigma):
    """The speed at the start: unknown, 0 give or take 30 m/s."""
    return run(z, *motion(dt, sd), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 900]))


def simpler_Q(z, dt, sd, sigma):
    """Only the speed gets noise; the position gets it one step later."""
    F, Q = motion(dt, sd)
    return run(z, F, np.diag([0, Q[1, 1]]), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9]))


def without_corners(z, dt, sd, sigma):
    F, Q = motion(dt, sd)
    return run(z, F, np.diag(np.diag(Q)), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9]))


def twice(z, dt, sd, sigma):
    """The first reading makes the start, and after a step it corrects as well."""
    means, covs = from_the_first_reading(np.append(z[0], z), dt, sd, sigma)
    return means[1:], covs[1:]


def filled(z, value):
    return np.where(np.isfinite(z), z, value)


def held(z):
    """The last reading, until there is a new one."""
    out = z.copy()
    for k in range(1, len(z)):
        out[k] = z[k] if np.isfinite(z[k]) else out[k - 1]
    return out


def raw(z, dt, sd, sigma):
    speed = np.diff(held(z), prepend=z[0]) / dt
    return np.stack([held(z), speed], axis=1), np.tile(np.diag([sigma**2, 2 * (sigma / dt) ** 2]), (STEPS, 1, 1))


def white(power):
    """White noise of the density sd² dt to a power; with the power 1 it comes near to a push that is held."""

    def follow(z, dt, sd, sigma):
        Q = sd**2 * dt**power * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])
        return run(z, motion(dt, sd)[0], Q, sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 9]))

    return follow


PASSING = {
    "white noise that grows with dt": white(1),
    "first reading": from_the_first_reading,
    "vague start": vague,
}
FAILING = {
    "noise for the speed only": simpler_Q,
    "Q without corners": without_corners,
    "first reading used twice": twice,
    "speed variance 3": lambda z, dt, sd, sigma: run(
        z, *motion(dt, sd), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 3])
    ),
    "raw readings": raw,
    "ignores the readings": lambda z, dt, sd, sigma: from_the_first_reading(
        np.append(z[:1], np.nan * z[1:]), dt, sd, sigma
    ),
    "the lesson's train, Q = 0": lambda z, dt, sd, sigma: run(
        z, motion(dt, sd)[0], np.zeros((2, 2)), sigma**2, np.array([z[0], 0]), np.diag([sigma**2, 25])
    ),
    "white noise": white(0),
    "gaps filled with zeros": lambda z, *rest: from_the_first_reading(filled(z, 0.0), *rest),
    "gaps filled with the last reading": lambda z, *rest: from_the_first_reading(held(z), *rest),
    "P = I at the start, Q = I": lambda z, dt, sd, sigma: run(
        z, motion(dt, sd)[0], np.eye(2), sigma**2, np.array([z[0], 0]), np.eye(2)
    ),
    "σ for R": lambda z, dt, sd, sigma: from_the_first_reading(z, dt, sd, np.sqrt(sigma)),
}
