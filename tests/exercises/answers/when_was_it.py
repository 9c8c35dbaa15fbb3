"""Lesson 25: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

from kflearn.exercises import _a_stream as stream
from kflearn.exercises._a_stream_late import at_its_own_time, corrected, sorted_first, step_to


def in_pairs(*given):
    return list(zip(*stream.fed()(*given), strict=True))


def away(now, t, z, H, R, q, mean, cov):
    """A filter of the rows as they arrive, that moves away from the readings."""
    x, P, time, found = mean, cov, 0.0, []
    for k in range(len(now)):
        x, P = step_to((time, x, P), now[k], q)
        time = now[k]
        if not np.isnan(z[k]) and t[k] == now[k]:
            seen, P = corrected(x, P, z[k], H[k], R[k])
            x = 2 * x - seen
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def looser(now, t, z, H, R, *rest):
    return stream.fed()(now, t, z, H, 3 * R, *rest)


def mixed_R(now, t, z, H, R, *rest):
    return stream.fed()(now, t, z, H, 0 * R + R.mean(), *rest)


def inflated(now, t, z, H, R, q, mean, cov):
    """A late reading is used as if it were new, with a larger R."""
    last, found = (0.0, mean, cov), []
    for k in range(len(now)):
        x, P = step_to(last, now[k], q)
        if not np.isnan(z[k]):
            x, P = corrected(x, P, z[k], H[k], R[k] + 9 * (now[k] - t[k]) ** 2)
        last = now[k], x, P
        found.append((x, P))
    return tuple(np.array(part) for part in zip(*found, strict=True))


def from_one_on(v, late, dt):
    r = [np.corrcoef(v[:-k], late[k:])[0, 1] for k in range(1, 11)]
    return dt * (1 + np.argmax(r))


def by_acceleration(v, late, dt):
    a = np.mean(abs(np.diff(v))) / dt
    return np.mean(v - late) / a


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("behind", -2.4, "a speed of 10 m/s, and the reading would lie behind"),
    ("live", at_its_own_time, "Wanted is the state at its `now`"),
    ("live", sorted_first, "uses readings before they have arrived"),
    ("live", in_pairs, "one list with a mean and a covariance for each reading"),
    ("live", away, "your state moves away from them"),
    ("live", looser, "as if R were 3 times the R of its row"),
    ("live", mixed_R, "it uses what has not arrived yet"),
    ("live", inflated, "It goes wrong with the rows that arrive late"),
    ("clock_offset", from_one_on, "the shift 0 is not tried"),
    ("clock_offset", by_acceleration, "the mean size of the acceleration"),
    (
        "clock_offset",
        lambda v, late, dt: dt * int(np.argmin([np.mean((late - np.roll(v, k)) ** 2) for k in range(11)])),
        "takes the end of the drive to its beginning",
    ),
]
