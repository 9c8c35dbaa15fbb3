"""Recordings for the open exercise of lesson 11: a cart whose readings fail for a while."""

import numpy as np

from kflearn.exercises._judge import nees, pair

STEPS = 200


def motion(dt, sd):
    """F and Q where the acceleration, of standard deviation sd, stays the same during a step."""
    push = np.array([dt**2 / 2, dt])
    return np.array([[1, dt], [0, 1]]), sd**2 * np.outer(push, push)


def recording(rng):
    """((readings (200,) with gaps, dt, sd of the acceleration, sigma of a reading), true position and speed (200, 2))."""
    dt, sd, sigma = rng.choice([0.5, 1.0, 2.0]), rng.uniform(0.2, 0.5), rng.uniform(2, 6)
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


def step_of(truth):
    """dt, from the way and the mean speed: exact, because the acceleration stays the same during a step."""
    return np.median(2 * np.diff(truth[:, 0]) / (truth[1:, 1] + truth[:-1, 1]))


def growth(answer, recording):
    """The Q that a filter uses in the gaps, as a mean, beside the right one."""
    (z, dt, sd, _), (F, right), cov = recording[0], motion(*recording[0][1:3]), pair(answer)[1]
    steps = np.flatnonzero(np.isnan(z))
    return np.mean([cov[k] - F @ cov[k - 1] @ F.T for k in steps], axis=0), right, dt, sd


def same(answers, recordings, form):
    """Whether the Q in all gaps is of some form, a function of (right Q, dt, sd)."""
    grown = [growth(*pair_) for pair_ in zip(answers, recordings, strict=True)]
    return all(np.allclose(Q, form(right, dt, sd), rtol=1e-3, atol=1e-6) for Q, right, dt, sd in grown)


SEEN = [
    (lambda Q, dt, sd: 0 * Q, "In the gaps P moves with F but gains no Q: add it in each prediction."),
    (lambda Q, dt, sd: Q / sd, "In the gaps P grows by sd times G Gᵀ; Q is a covariance: sd²."),
    (lambda Q, dt, sd: Q / dt**2, "In the gaps Q lacks a factor: an acceleration a, held for dt, adds a·dt to the speed."),
    (
        lambda Q, dt, sd: Q + np.diag([sd**2 * (dt**3 / 3 - dt**4 / 4), sd**2 * (dt - dt**2)])
        + sd**2 * (dt**2 - dt**3) / 2 * (1 - np.eye(2)),
        "In the gaps Q is that of white noise, new at every instant. Here the acceleration is held for the whole step.",
    ),
]  # fmt: skip


def of_claims(otherwise):
    """What to look at where the claims do not fit the errors: a Q or a start that can be named, or something else."""

    def look(answers, recordings):
        if all(growth(*each)[0][0, 0] < 0 for each in zip(answers, recordings, strict=True)):
            return "In the gaps your P shrinks, as if something had been read: is a NaN taken for a number, such as 0?"
        for form, words in SEEN:
            if same(answers, recordings, form):
                return words
        start = [(pair(answer)[1][0], sigma) for answer, ((*_, sigma), _) in zip(answers, recordings, strict=True)]
        if all(P[0, 0] < 0.7 * sigma**2 for P, sigma in start):
            return "Your P at the first reading is too small: its position has the variance sigma² of that reading."
        if all(P[1, 1] < 4 for P, _ in start):
            return "Your P at the first reading is too small for the speed, which is drawn from N(0, 3²)."
        return otherwise

    return look


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
    "noise for the speed only": simpler_Q,
}
FAILING = {
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
