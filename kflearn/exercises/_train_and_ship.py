"""Wrong answers to exercises of lesson 11, each with the sentence that it gets."""

import math

import numpy as np


def published_speeds(z, dt):
    """Differences, as published: zeros filled from the second place on."""
    return np.concatenate([[0.0], np.diff(z) / dt])


def averages(speed, window=5, first=0):
    """Running averages over `window` values; the places for which there are not enough are NaN."""
    out = np.full(len(speed), np.nan)
    for k in range(first + window - 1, len(speed)):
        out[k] = np.mean(speed[k - window + 1 : k + 1])
    return out


def as_published(z, dt):
    speed = published_speeds(z, dt)
    return np.array([sum(speed[max(0, k - 4) : k + 1]) / 5 for k in range(len(z))])


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


def running(z, dt):
    return averages(np.concatenate([[np.nan], np.diff(z) / dt]), first=1)


WRONG = {
    "running_average": {
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
    },
    "start_variance": {
        "as published": (
            lambda low, high, believed: 1.0,
            "That is the published answer again: 1, whatever is known. Then five becomes 'five, give or take one'.",
        ),
        "the wrong guess forgotten": (
            lambda low, high, believed: (high - low) ** 2 / 12,
            "That is the variance about the middle of the range. The filter starts at `believed`, and P₀ counts errors from there.",
        ),
        "the scatter forgotten": (
            lambda low, high, believed: ((low + high) / 2 - believed) ** 2,
            "That is the squared distance from the middle only; at believed = middle it would claim to know the speed exactly.",
        ),
        "a deviation": (
            lambda low, high, believed: math.sqrt((high - low) ** 2 / 12 + ((low + high) / 2 - believed) ** 2),
            "Rightly put together, and then the root was taken: P holds variances, in (m/s)².",
        ),
        "distance not squared": (
            lambda low, high, believed: (high - low) ** 2 / 12 + abs((low + high) / 2 - believed),
            "The distance from the middle to `believed` is in m/s; to be added to a variance it must be squared.",
        ),
        "the whole range squared": (
            lambda low, high, believed: (high - low) ** 2 + ((low + high) / 2 - believed) ** 2,
            "That has the whole range as a standard deviation. Between two limits the variance is the range squared, over 12.",
        ),
        "half the range squared": (
            lambda low, high, believed: (high - low) ** 2 / 4 + ((low + high) / 2 - believed) ** 2,
            "Half the range is the farthest that the speed can be from the middle; on average it is nearer: divide the range squared by 12.",
        ),
        "half the range squared, guess forgotten": (
            lambda low, high, believed: (high - low) ** 2 / 4,
            "Half the range as σ is too much between hard limits (divide the range squared by 12), and the wrong guess is missing.",
        ),
        "range over 12": (
            lambda low, high, believed: (high - low) / 12 + ((low + high) / 2 - believed) ** 2,
            "The 12 belongs under the range *squared*; m/s and (m/s)² cannot be added.",
        ),
        "the worst case": (
            lambda low, high, believed: max(abs(high - believed), abs(low - believed)) ** 2,
            "That is the worst error, squared. P₀ is the *mean* square: nothing is over-confident here, but the start counts too little.",
        ),
        "range squared, guess forgotten": (
            lambda low, high, believed: (high - low) ** 2,
            "That has the whole range as σ, and the wrong guess is missing. Between two limits the variance is the range squared, over 12.",
        ),
        "from the upper limit": (
            lambda low, high, believed: (high - believed) ** 2,
            "That is the squared error at the upper limit. The speed may be anything in between: take the mean over all of it.",
        ),
        "guess squared": (
            lambda low, high, believed: (high - low) ** 2 / 12 + believed**2,
            "You added the square of `believed` itself. What counts is how far it is from the middle of the range.",
        ),
        "subtracted": (
            lambda low, high, believed: (high - low) ** 2 / 12 - ((low + high) / 2 - believed) ** 2,
            "You took the squared distance away. A wrong guess makes the mean square error larger: add.",
        ),
        "both over 12": (
            lambda low, high, believed: ((high - low) ** 2 + ((low + high) / 2 - believed) ** 2) / 12,
            "The 12 belongs under the squared range alone; the squared distance is added as it is.",
        ),
    },
    "report": {
        "as published": (
            lambda e: (np.cov(e.T), np.mean(np.hypot(*e.T))),
            "That is the published report again: a covariance called a mean, and a mean distance called RMS.",
        ),
        "mean distance": (
            lambda e: (e.mean(axis=0), np.mean(np.hypot(*e.T))),
            "The mean is right. The second number is still the mean distance: square, *then* average, then take the root.",
        ),
        "rms right, covariance": (
            lambda e: (np.cov(e.T), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first is still a covariance, in m²: a mean error is in metres.",
        ),
        "variances": (
            lambda e: (e.var(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first are variances, in m²: a mean error is in metres and has a sign.",
        ),
        "an rms for each axis": (
            lambda e: (e.mean(axis=0), np.sqrt(np.mean(e**2, axis=0))),
            "The mean is right. You return one rms for each axis, whose squares R holds; the rms *distance* is one number.",
        ),
        "all numbers alike": (
            lambda e: (e.mean(axis=0), np.sqrt(np.mean(e**2))),
            "The mean is right. The second is the rms of all 2T numbers, per axis, √2 too small: first add the squares of a fix.",
        ),
        "root forgotten": (
            lambda e: (e.mean(axis=0), np.mean(np.sum(e**2, axis=1))),
            "The mean is right. The second is a mean square, in m²: the root is missing.",
        ),
        "about the mean": (
            lambda e: (e.mean(axis=0), np.sqrt(np.mean(np.sum((e - e.mean(axis=0)) ** 2, axis=1)))),
            "The mean is right. But it is taken off before the squares: a receiver that is always 50 m off would get a fine mark.",
        ),
        "mean not divided": (
            lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2))),
            "The mean is right. You took the root of the *sum* over all fixes: more fixes would make the error larger.",
        ),
        "mean of both axes": (
            lambda e: (e.mean(), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The mean needs `axis=0`: east and north apart, else one hides the other.",
        ),
        "mean of each fix": (
            lambda e: (e.mean(axis=1), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. You averaged east with north in each fix: the mean goes over the fixes, `axis=0`.",
        ),
        "mean without sign": (
            lambda e: (abs(e).mean(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. A mean error keeps its sign: errors to both sides cancel, and so they should.",
        ),
        "swapped": (
            lambda e: (np.sqrt(np.mean(np.sum(e**2, axis=1))), e.mean(axis=0)),
            "Both are right, in the wrong order: first the mean error, then the rms distance.",
        ),
        "length of the mean": (
            lambda e: (e.mean(axis=0), np.hypot(*e.mean(axis=0))),
            "The mean is right. The second number is the length of the mean error, in which errors to both sides have cancelled: square first.",
        ),
        "not averaged": (
            lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2, axis=1))),
            "The mean is right. You return the distance of each fix; asked is the root of the mean of their squares.",
        ),
        "standard deviation": (
            lambda e: (e.mean(axis=0), np.std(e)),
            "The mean is right. A standard deviation leaves a mean out, and this one mixes the axes: square, add the two axes, average, root.",
        ),
    },
}
