"""Steps of the filters for a stream (lesson 25), and filters that take late readings, or their steps, wrongly."""

import numpy as np


def white(dt, q):
    """F and Q of a step."""
    return np.array([[1, dt], [0, 1]]), q * np.array([[dt**3 / 3, dt**2 / 2], [dt**2 / 2, dt]])


def step_to(kept, t, q):
    """The belief at t, from (time, mean, covariance)."""
    time, x, P = kept
    F, Q = white(t - time, q)
    return F @ x, F @ P @ F.T + Q


def on_time(now, t, z, H, R, q, mean, cov, again=False):
    """Leaves out what arrives late; or uses it with the covariance of the start, at the old place by its own speed."""
    x, P, last, rows = mean, cov, 0.0, []
    for k in range(len(now)):
        x, P = step_to((last, x, P), now[k], q)
        late, last = t[k] < now[k], now[k]
        if not np.isnan(z[k]) and (again or not late):
            P = cov if late else P
            K = P @ H[k] / (H[k] @ P @ H[k] + R[k])
            old = x - np.array([x[1] * (now[k] - t[k]), 0])
            x, P = x + K * (z[k] - H[k] @ old), P - np.outer(K, H[k] @ P)
        rows.append((x, P))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def even(middle):
    """One step for all rows, and arrival for measurement."""

    def follow(now, t, z, H, R, q, mean, cov):
        (F, Q), x, P, rows = white(middle(np.diff(now)), q), mean, cov, []
        for k in range(len(now)):
            x, P = F @ x, F @ P @ F.T + Q
            if not np.isnan(z[k]):
                K = P @ H[k] / (H[k] @ P @ H[k] + R[k])
                x, P = x + K * (z[k] - H[k] @ x), P - np.outer(K, H[k] @ P)
            rows.append((x, P))
        return tuple(np.array(part) for part in zip(*rows, strict=True))

    return follow


def corrected(x, P, z, h, R):
    """A correction by one number."""
    K = P @ h / (h @ P @ h + R)
    return x + K * (z - h @ x), P - np.outer(K, h @ P)


def at_its_own_time(now, t, z, H, R, q, mean, cov):
    """A replay that returns the state at t, the time of the reading, where a reading arrives late."""
    kept, rows = [(0.0, mean, cov, -1)], []
    for k in range(len(now)):
        if np.isnan(z[k]):
            rows.append(step_to(kept[-1][:3], now[k], q))
            continue
        younger = [i for time, _, _, i in kept if time > t[k]]
        kept = kept[: len(kept) - len(younger)]
        for i in [k, *younger]:
            kept.append((t[i], *corrected(*step_to(kept[-1][:3], t[i], q), z[i], H[i], R[i]), i))
        rows.append(next((x, P) for _, x, P, i in kept if i == k))
    return tuple(np.array(part) for part in zip(*rows, strict=True))


def sorted_first(now, t, z, H, R, q, mean, cov):
    """A filter of all rows in the order of t."""
    rows, last = [None] * len(now), (0.0, mean, cov)
    for k in np.argsort(t, kind="stable"):
        x, P = step_to(last, t[k], q)
        if not np.isnan(z[k]):
            x, P = corrected(x, P, z[k], H[k], R[k])
        last = t[k], x, P
        rows[k] = step_to(last, now[k], q)
    return tuple(np.array(part) for part in zip(*rows, strict=True))


EVEN = "All your steps have the same length. Take dt from the times of the rows, each its own, and for a late reading its t."

LATE = {
    "late readings are never used": (
        on_time,
        "Your filter never uses a late reading. They are good: go back to t, use it, and then all that are younger once more.",
    ),
    "P begins again": (
        lambda *given: on_time(*given, again=True),
        "At a late reading your P jumps back to that of the start. It must be what the filter has then: replay, or retrodict.",
    ),
    "one mean step": (even(np.mean), EVEN),
    "one median step": (even(np.median), EVEN),
    "one second a step": (even(lambda steps: 1.0), EVEN),
}
