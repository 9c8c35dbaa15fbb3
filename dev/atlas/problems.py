"""Three tiny problems, and their exact answers without any filter: all states and readings are one large Gaussian.

Nothing but NumPy: these lines also run in the environments of the other libraries.
"""

from itertools import product

import numpy as np

NAN = float("nan")
BEFORE, FIRST = "one step before the first reading", "at the first reading"
HALF = "the mean one step before the first reading, the covariance at it"
NONE, STEADY = "none: the first reading is the start", "none: the gain of the steady state"
USED, DROPPED, ZERO = "used", "dropped", "read as 0"

LEVEL = {
    "F": [[1.0]],
    "H": [[1.0]],
    "Q": [[4.0]],
    "R": [[4.0]],
    "x": [10.0],
    "P": [[9.0]],
    "z": [[11.2], [9.7], [13.1], [12.4], [8.9], [10.5]],
}
MOVING = {
    "F": [[1.0, 1.0], [0.0, 1.0]],
    "H": [[1.0, 0.0]],
    "Q": [[0.2, 0.1], [0.1, 0.3]],
    "R": [[1.5]],
    "x": [0.0, 1.0],
    "P": [[4.0, 1.0], [1.0, 2.0]],
    "z": [[1.1], [2.3], [NAN], [5.2], [5.9], [7.4]],
}
TWO = MOVING | {
    "H": [[1.0, 0.0], [0.0, 1.0]],
    "R": [[1.5, 0.4], [0.4, 0.8]],
    "z": [[1.1, 1.4], [2.3, 0.8], [3.1, NAN], [5.2, 1.2], [5.9, 1.6], [7.4, 0.9]],
}
PROBLEMS = {"level": LEVEL, "moving": MOVING, "two": TWO}
WHOLE = {"z": [[1.1], [2.3], [3.6], [5.2], [5.9], [7.4]]}  # MOVING without its gap
GAP = {"z": [[11.2], [9.7], [NAN], [12.4], [8.9], [10.5]]}  # LEVEL with one


def arrays(name, **changes):
    """One of the problems as arrays, with some of them changed."""
    return {key: np.array(value, float) for key, value in (PROBLEMS[name] | changes).items()}


def joint(F, Q, x, P, steps, start):
    """Mean (T n,) and covariance (T n, T n) of the states at the times of all readings, one after the other."""
    means, blocks = [x], {(0, 0): P}
    for t in range(1, steps + 1):
        means.append(F @ means[-1])
        for s in range(t):
            blocks[t, s] = F @ blocks[t - 1, s]
            blocks[s, t] = blocks[t, s].T
        blocks[t, t] = F @ blocks[t - 1, t - 1] @ F.T + Q
    times = range(1, steps + 1) if start == BEFORE else range(steps)
    return np.concatenate([means[t] for t in times]), np.block([[blocks[t, s] for s in times] for t in times])


def conditioned(mean, cov, H, R, z):
    """The states, given the numbers in z (T, m) that are there, and the log-density of these."""
    T = len(z)
    seen = ~np.isnan(z.ravel())
    C = np.kron(np.eye(T), H)[seen]
    S = C @ cov @ C.T + np.kron(np.eye(T), R)[np.ix_(seen, seen)]
    y = z.ravel()[seen] - C @ mean
    gain = np.linalg.solve(S, C @ cov).T
    log_density = -0.5 * (y @ np.linalg.solve(S, y) + np.linalg.slogdet(S)[1] + seen.sum() * np.log(2 * np.pi))
    return mean + gain @ y, cov - gain @ C @ cov, log_density


def exact(F, H, Q, R, x, P, z, start=BEFORE, part=USED):
    """The filter's means (T, n) and covariances (T, n, n), and the log-likelihood of all readings.

    start: when the belief N(x, P) holds. part: what becomes of a reading of which a part is missing.
    """
    if start in (HALF, NONE):
        return exact(**shifted(F, H, Q, R, x, P, z, start), start=FIRST, part=part)
    T, n = len(z), len(x)
    if part == DROPPED:
        z = np.where(np.isnan(z).any(axis=1, keepdims=True), NAN, z)
    if part == ZERO:
        z = np.nan_to_num(z)
    mean, cov = joint(F, Q, x, P, T, start)
    means, covs = np.empty((T, n)), np.empty((T, n, n))
    for t in range(T):
        known = np.where(np.arange(T)[:, None] <= t, z, NAN)
        after, spread, likelihood = conditioned(mean, cov, H, R, known)
        here = slice(t * n, (t + 1) * n)
        means[t], covs[t] = after[here], spread[here, here]
    return means, covs, likelihood


def shifted(F, H, Q, R, x, P, z, start):
    """The problem whose belief at the first reading is that of a start which is HALF, or NONE (one number, H not 0)."""
    if start == HALF:
        return dict(F=F, H=H, Q=Q, R=R, x=F @ x, P=P, z=z)
    unread = np.where(np.arange(len(z))[:, None] == 0, NAN, z)
    return dict(F=F, H=H, Q=Q, R=R, x=z[0] / H[0], P=R / H**2, z=unread)


def answers(problem):
    """{(start, part): exact answer} for all readings of the conventions."""
    gaps = np.isnan(problem["z"])
    parts = (
        (USED, DROPPED, ZERO) if gaps.any() and problem["z"].shape[1] > 1 else (USED, ZERO) if gaps.any() else (USED,)
    )
    starts = (BEFORE, FIRST, HALF) if len(problem["x"]) > 1 else (BEFORE, FIRST, HALF, NONE)
    return {(start, part): exact(**problem, start=start, part=part) for start, part in product(starts, parts)}
