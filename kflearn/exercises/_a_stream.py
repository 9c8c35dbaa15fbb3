"""Streams for the open exercise of lesson 25: places and speeds of a car, of which some arrive late."""

import numpy as np

from kflearn import Gaussian, TimedFilter
from kflearn.exercises._a_stream_late import LATE, at_its_own_time, sorted_first, step_to, white
from kflearn.exercises._judge import pair

END = 40.0  # seconds


def taken(rng):
    """When each reading was taken, when it arrives, and what it is of: 0 the place, 1 the speed, 2 a question."""
    places = np.cumsum(rng.uniform(0.6, 1.6, 28))
    late = np.where(rng.random(28) < 0.7, rng.uniform(0.3, 2.5, 28), 0.0)
    speeds, asked = np.cumsum(rng.uniform(0.2, 1.0, 60)), rng.uniform(1, END, 30)
    t = np.concatenate([places, speeds, asked])
    now = np.concatenate([places + late, speeds, asked])
    kind = np.repeat([0, 1, 2], [28, 60, 30])
    order = np.argsort(now, kind="stable")
    order = order[now[order] < END]
    return t[order], now[order], kind[order]


def stream(rng):
    """The rows as they arrive, q and the belief at time 0; and the truth at each `now`."""
    t, now, kind = taken(rng)
    q, mean, cov = rng.integers(2, 9) / 2, np.array([0.0, rng.integers(10, 30)]), np.diag([4.0, 4.0])
    moments = np.unique(np.concatenate([t, now]))
    x, path = rng.multivariate_normal(mean, cov), []
    for dt in np.diff(moments, prepend=0):
        F, Q = white(dt, q)
        x = F @ x + rng.multivariate_normal([0, 0], Q, method="cholesky" if dt > 1e-3 else "eigh")
        path.append(x)
    path, R = np.array(path), np.array([rng.integers(1, 7) ** 2 / 4, rng.integers(1, 5) ** 2 / 8, 1.0])[kind]
    H = np.eye(2)[np.minimum(kind, 1)]
    z = np.sum(H * path[np.searchsorted(moments, t)], axis=1) + np.sqrt(R) * rng.standard_normal(len(t))
    z[kind == 2] = np.nan
    return (now, t, z, H, R, q, mean, cov), path[np.searchsorted(moments, now)]


def fed(late="replay", keep=60, when=lambda now, t: t, moves=white, skip=None, noise=1.0):
    """A filter that is fed by an TimedFilter; the settings are mistakes, and other designs."""

    def follow(now, t, z, H, R, q, mean, cov):
        live, rows = TimedFilter(lambda dt: moves(dt, q), Gaussian(mean, cov), 0.0, late=late, keep=keep), []
        for k in range(len(now)):
            if not (np.isnan(z[k]) or (skip and skip(H[k]))):
                live.update(z[k], H[k : k + 1], noise * R[k], when(now[k], t[k]))
            belief = live.predict_to(now[k])
            rows.append((belief.mean, belief.cov))
        return tuple(np.array(part) for part in zip(*rows, strict=True))

    return follow


def naive(step=abs, ask=True):
    """A filter that goes through the rows as they arrive, whatever the sign of dt; the questions moved for, or not."""

    def follow(now, t, z, H, R, q, mean, cov):
        x, P, time, rows = mean, cov, 0.0, []
        for k in range(len(now)):
            if not np.isnan(z[k]):
                F, Q = white(step(t[k] - time), q)
                x, P, time = F @ x, F @ P @ F.T + Q, t[k]
                K = P @ H[k] / (H[k] @ P @ H[k] + R[k])
                x, P = x + K * (z[k] - H[k] @ x), P - np.outer(K, H[k] @ P)
            F, Q = white(now[k] - time if ask else 0.0, q)
            rows.append((F @ x, F @ P @ F.T + Q))
        return tuple(np.array(part) for part in zip(*rows, strict=True))

    return follow


def back_and_lost(now, t, z, H, R, q, mean, cov):
    """Goes back for a late reading, and does not use the younger ones again."""
    kept, rows = [(0.0, mean, cov)], []
    for k in range(len(now)):
        if not np.isnan(z[k]):
            kept = [each for each in kept if each[0] <= t[k]]
            x, P = step_to(kept[-1], t[k], q)
            K = P @ H[k] / (H[k] @ P @ H[k] + R[k])
            kept.append((t[k], x + K * (z[k] - H[k] @ x), P - np.outer(K, H[k] @ P)))
        rows.append(step_to(kept[-1], now[k], q))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def carried_on(now, t, z, H, R, q, mean, cov):
    """Moves a late place on by the estimated speed, and uses it as if it were new."""
    last, rows = (0.0, mean, cov), []
    for k in range(len(now)):
        x, P = step_to(last, now[k], q)
        if not np.isnan(z[k]):
            seen = z[k] + H[k, 0] * x[1] * (now[k] - t[k])
            K = P @ H[k] / (H[k] @ P @ H[k] + R[k])
            x, P = x + K * (seen - H[k] @ x), P - np.outer(K, H[k] @ P)
        last = now[k], x, P
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def not_moved(now, t, z, H, R, q, mean, cov):
    """The belief at the newest reading in place of that at `now`."""
    live, rows = TimedFilter(lambda dt: white(dt, q), Gaussian(mean, cov), 0.0, keep=60), []
    for k in range(len(now)):
        if not np.isnan(z[k]):
            live.update(z[k], H[k : k + 1], R[k], t[k])
        rows.append((live.belief.mean, live.belief.cov))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def looks_ahead(now, t, z, H, R, q, mean, cov):
    """All readings that were taken before `now`, also those that have not arrived."""
    live, rows = TimedFilter(lambda dt: white(dt, q), Gaussian(mean, cov), 0.0), []
    waiting = [i for i in np.argsort(t, kind="stable") if not np.isnan(z[i])]
    for k in range(len(now)):
        while waiting and t[waiting[0]] <= now[k]:
            i = waiting.pop(0)
            live.update(z[i], H[i : i + 1], R[i], t[i])
        belief = live.predict_to(now[k])
        rows.append((belief.mean, belief.cov))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def raw(now, t, z, H, R, q, mean, cov):
    """The last place and the last speed that were read."""
    x, rows = mean.copy(), []
    for k in range(len(now)):
        if not np.isnan(z[k]):
            x[np.argmax(H[k])] = z[k]
        rows.append(x.copy())
    return np.array(rows), np.tile(np.diag([R[H[:, 0] == 1][0], R[H[:, 1] == 1][0]]), (len(now), 1, 1))


def squared(now, t, z, H, R, *rest):
    return fed()(now, t, z, H, R**2, *rest)


def rooted(now, t, z, H, R, *rest):
    return fed()(now, t, z, H, np.sqrt(R), *rest)


def held(dt, q):
    """F, and the Q of a push that is held for the whole step."""
    push = np.array([[dt**2 / 2], [dt]])
    return np.array([[1, dt], [0, 1]]), q * push @ push.T


PASSING = {
    "a library": fed(),
    "one step of retrodiction": fed(late="retrodict"),
    "a memory of twelve readings": fed(keep=12),
}
SAID = LATE | {
    "late readings are dropped": (
        fed(late="drop"),
        "Your filter does not use readings that arrive late. They still tell where the car was: put them in at their t, and use all younger readings once more.",
    ),
    "arrival for measurement": (
        fed(when=lambda now, t: now),
        "Your filter takes the time of arrival for the time of the reading. A place that is 1 s old is off by what the car has driven since: use t.",
    ),
    "abs(dt)": (
        naive(),
        "For a late reading dt is negative, and your filter moves forward by its size. Go back to the belief before that reading.",
    ),
    "no step back": (
        naive(step=lambda dt: max(dt, 0.0)),
        "For a late reading your filter does not move at all, as if it had just been taken. Go back to the belief before that reading.",
    ),
    "a negative dt": (
        naive(step=lambda dt: dt),
        "For a late reading your dt is negative, and so is its Q: noise is taken off P. Predicting backwards is no filter: go back to the belief before that reading.",
    ),
    "younger readings lost": (
        back_and_lost,
        "For a late reading your filter goes back, and the readings that are younger than it are lost. Use them once more, in the order of their t.",
    ),
    "carried on by the speed": (
        carried_on,
        "You move a late place on by the estimated speed and use it as new. What the speed has done in the meantime, and its error, are missing: its R is then too small.",
    ),
    "R squared": (
        squared,
        "Your filter uses R². R is a variance already: add it as it is.",
    ),
    "σ for R": (
        rooted,
        "Your filter uses the root of R, σ. In S = H P Hᵀ + R stands the variance R.",
    ),
    "the state at t": (
        at_its_own_time,
        "For a row that arrives late you return the state at its t, when the reading was taken. Wanted is the state at its `now`, from all that has arrived.",
    ),
    "sorted as a whole": (
        sorted_first,
        "Your rows are sorted by t before the filter runs. Then it uses readings before they have arrived: in row k only the rows up to k are known, sorted by t.",
    ),
    "not moved to now": (
        not_moved,
        "You return the belief at the newest reading. The state at `now` is wanted: predict from there to `now`.",
    ),
    "looks ahead": (
        looks_ahead,
        "You use readings before they have arrived: in row k only the rows up to k are known.",
    ),
    "held Q": (
        fed(moves=held),
        "Your Q is that of one push which lasts the whole step, dt⁴/4. q is white acceleration: dt³/3, dt²/2, dt.",
    ),
    "no Q": (
        fed(moves=lambda dt, q: white(dt, 0.0)),
        "Q is missing: P becomes F P Fᵀ, as if the speed never changed.",
    ),
    "q squared": (fed(moves=lambda dt, q: white(dt, q**2)), "Your Q holds q². q is a variance already, per second."),
    "places alone": (
        fed(skip=lambda H: H[0] == 0),
        "Your filter uses the places alone. The rows with H = [0, 1] are readings of the speed.",
    ),
    "speeds alone": (
        fed(skip=lambda H: H[0] == 1),
        "Your filter uses the speeds alone. The rows with H = [1, 0] are readings of the place.",
    ),
    "nothing is used": (
        fed(skip=lambda H: True),
        "Your filter uses no reading at all: the belief of the start is only moved on.",
    ),
}
FAILING = {label: design for label, (design, _) in SAID.items()} | {
    "the readings themselves": raw,
    "a memory of two readings": fed(keep=2),
    "R a hundred times too large": fed(noise=100.0),
}


def named(answer, answers, recordings):
    """The sentence of a known mistake, where all results are those that it makes."""
    for design, sentence in SAID.values():
        if all(same(a, design(*inputs)) for a, (inputs, _) in zip(answers, recordings, strict=True)):
            return sentence
    return None


def same(answer, other):
    """Do two results agree, up to small changes of the design?"""
    mean, (wrong, spread) = pair(answer)[0], pair(other)
    std = np.sqrt(abs(np.diagonal(spread, axis1=-2, axis2=-1)))
    return np.mean(abs(mean - wrong) < 0.02 * std + 1e-9) > 0.97
