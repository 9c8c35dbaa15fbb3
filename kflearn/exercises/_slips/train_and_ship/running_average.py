"""Lesson 11, `running_average`: wrong answers, each with the sentence that it gets."""

import numpy as np


def published_speeds(z, dt):
    """Differences, as published: zeros filled from the second place on."""
    return np.concatenate([[0.0], np.diff(z) / dt])


def as_published(z, dt):
    speed = published_speeds(z, dt)
    return np.array([sum(speed[max(0, k - 4) : k + 1]) / 5 for k in range(len(z))])


def averages(speed, window=5, first=0):
    """Running averages over `window` values; the places for which there are not enough are NaN."""
    out = np.full(len(speed), np.nan)
    for k in range(first + window - 1, len(speed)):
        out[k] = np.mean(speed[k - window + 1 : k + 1])
    return out


def running(z, dt):
    return averages(np.concatenate([[np.nan], np.diff(z) / dt]), first=1)


def growing(z, dt):
    """Averages over as many differences as there are, five at most."""
    speed = np.diff(z) / dt
    return np.array([np.nan, *(np.mean(speed[max(0, k - 4) : k + 1]) for k in range(len(speed)))])


def late(z, dt):
    """The right averages, one place too late."""
    return np.concatenate([[np.nan], running(z, dt)[:-1]])


def centred(z, dt):
    """Averages over five differences about the place."""
    right = running(z, dt)
    return np.concatenate([right[2:], [np.nan, np.nan]])


def averaged(z, dt, count=5, first=None, centred=0):
    """Averages of so many differences, from some place on."""
    speed = np.full(len(z), np.nan)
    for k in range(count if first is None else first, len(z)):
        end = min(k + centred, len(z) - 1)
        begin = max(end - count, 0)
        if end > begin:
            speed[k] = (z[end] - z[begin]) / ((end - begin) * dt)
    return speed


WRONG = {
    "as published": (
        as_published,
        "That is the published one again: zeros that nobody measured are averaged, so every train starts from rest.",
    ),
    "zeros for NaN": (
        lambda z, dt: np.nan_to_num(running(z, dt)),
        "The averages are right, but where there is none you say 0 m/s, which is a speed. Say NaN: not known.",
    ),
    "one zero left": (
        lambda z, dt: averages(published_speeds(z, dt)),
        "The first average still holds the zero in place 0: five differences exist from `z[5]` on, not from `z[4]`.",
    ),
    "as many as there are": (
        growing,
        "You average over as many differences as there are. The first of these averages scatters by 14 m/s: five were asked for, NaN before.",
    ),
    "dt forgotten": (
        lambda z, dt: running(z, 1.0),
        "dt is missing: metres per reading are not metres per second.",
    ),
    "multiplied by dt": (
        lambda z, dt: running(z, 1.0) * dt,
        "You multiplied by dt. A speed is metres *per* second: divide.",
    ),
    "the sum": (
        lambda z, dt: 5 * running(z, dt),
        "That is the sum of five differences; the average is a fifth of it.",
    ),
    "four": (
        lambda z, dt: averages(np.concatenate([[np.nan], np.diff(z) / dt]), 4, first=1),
        "You averaged four differences: between `z[k - 4]` and `z[k]` there are only four. Take `z[k - 5]`.",
    ),
    "five readings, over five": (
        lambda z, dt: averages(np.concatenate([[np.nan], np.diff(z) / dt]), 4, first=1) * 4 / 5,
        "Between `z[k - 4]` and `z[k]` lie four differences, and you divided by five: too slow by a fifth.",
    ),
    "late": (
        late,
        "Every average stands one place too late: the one that ends with reading k belongs to k.",
    ),
    "centred": (
        centred,
        "You centred the window: these averages need readings from the future.",
    ),
    "backwards": (
        lambda z, dt: -running(z, dt),
        "The sign: the later position minus the earlier one.",
    ),
    "the readings averaged": (
        lambda z, dt: averages(np.asarray(z, dtype=float)),
        "You averaged positions; the differences were asked for, in m/s.",
    ),
    "too short": (
        lambda z, dt: (z[5:] - z[:-5]) / (5 * dt),
        "The averages are right, but the first of them belongs to reading 5: one value for each reading, NaN in front.",
    ),
    "one number short, same": (
        lambda z, dt: np.convolve(np.diff(z) / dt, np.ones(5) / 5, "same"),
        "There is one difference less than readings, and 'same' also averages over zeros at both ends. Begin with an array of NaN as long as z.",
    ),
    "convolved with zeros": (
        lambda z, dt: np.convolve(np.diff(z) / dt, np.ones(5) / 5, "full")[: len(z)],
        "At the ends you average over zeros that nobody measured, and every average stands one place too early.",
    ),
    "differences": (
        lambda z, dt: np.concatenate([[np.nan], np.diff(z) / dt]),
        "Those are the single differences. Average the last five of them at each reading.",
    ),
    "differences, short": (
        lambda z, dt: np.diff(z) / dt,
        "Those are the single differences, one less than readings. Average the last five of them, and put NaN in front.",
    ),
    "over six": (
        lambda z, dt: running(z, dt) * 5 / 6,
        "You divided by 6: six readings, but five differences, and five time steps, lie between them.",
    ),
    "one NaN short": (
        lambda z, dt: running(z, dt)[1:],
        "One NaN is missing in front: the first average belongs to the sixth reading, index 5.",
    ),
    "NaN behind": (
        lambda z, dt: np.concatenate([running(z, dt)[5:], np.full(5, np.nan)]),
        "The NaN belong in front: the first five readings have no average yet.",
    ),
    "centred, as many as there are": (
        lambda z, dt: averaged(z, dt, 5, first=3, centred=2),
        "Your windows reach beyond the reading: the last five differences at reading k are those that end with it.",
    ),
    "centred, same": (
        lambda z, dt: np.concatenate([[np.nan], np.convolve(np.diff(z) / dt, np.ones(5) / 5, "same")]),
        "'same' puts each average in the middle of its window, and averages over zeros at both ends. The last five differences are wanted, NaN before.",
    ),
    "centred, NaN first": (
        lambda z, dt: np.convolve(np.append(np.nan, np.diff(z) / dt), np.ones(5) / 5, "same"),
        "'same' puts each average in the middle of its window, and averages over zeros at the end. The last five differences are wanted.",
    ),
    "six": (
        lambda z, dt: averaged(z, dt, 6),
        "You averaged six differences. Five lie between `z[k - 5]` and `z[k]`.",
    ),
    "one NaN too many": (
        lambda z, dt: np.where(np.arange(len(z)) < 6, np.nan, averaged(z, dt)),
        "The averages are right, but the first is missing: five differences exist from `z[5]` on.",
    ),
    "one early": (
        lambda z, dt: np.concatenate([averaged(z, dt)[1:], [np.nan]]),
        "Every average stands one place too early: the one that ends with reading k belongs to k.",
    ),
    "gradient": (
        lambda z, dt: np.gradient(z, dt),
        "Those are differences to both sides, as `np.gradient` takes them. The average of the last *five* differences is wanted, NaN before.",
    ),
    "since the start": (
        lambda z, dt: np.concatenate([[np.nan], (z[1:] - z[0]) / (dt * np.arange(1, len(z)))]),
        "You average over all differences since the start. Take the last five.",
    ),
    "since the start, NaN": (
        lambda z, dt: np.concatenate([[np.nan] * 5, (z[5:] - z[0]) / (dt * np.arange(5, len(z)))]),
        "You average over all differences since the start. Take the last five.",
    ),
    "the last": (
        lambda z, dt: (z[-1] - z[-6]) / (5 * dt),
        "That is the average at the last reading. One for each reading is wanted, NaN where five do not exist.",
    ),
    "growing from 0": (
        lambda z, dt: np.concatenate([[0.0], averaged(z, dt, 5, first=1)[1:]]),
        "You average over as many differences as there are, and say 0 where there is none. Five were asked for, NaN before.",
    ),
    "median": (
        lambda z, dt: np.concatenate(
            [[np.nan] * 5, [np.median(np.diff(z[k - 5 : k + 1])) / dt for k in range(5, len(z))]]
        ),
        "Those are medians of five differences. Their average is wanted.",
    ),
    "span of four steps": (
        lambda z, dt: np.append(np.full(min(5, len(z)), np.nan), (z[5:] - z[:-5]) / (4 * dt)),
        "From z[k − 5] to z[k] five steps of dt pass, not four: six readings, five differences.",
    ),
    "always 10": (
        lambda z, dt: np.where(np.arange(len(z)) < 5, np.nan, 10.0),
        "You return 10 for every recording. The speed comes from z and dt.",
    ),
}
