"""Wrong answers to exercises of lesson 11 that a second stranger tried, and more of their kind."""

import math

import numpy as np

from kflearn.exercises._slips_train_second import WRONG as SECOND

SIGMA = 6 / math.sqrt(2 * math.log(2))


def spread(part, guess=2):
    """A share of the squared range, and the distance from the middle to a power."""
    return lambda low, high, believed: part * (high - low) ** 2 + abs((low + high) / 2 - believed) ** guess


def averaged(z, dt, count=5, first=None, centred=0):
    """Averages of so many differences, from some place on."""
    speed = np.full(len(z), np.nan)
    for k in range(count if first is None else first, len(z)):
        end = min(k + centred, len(z) - 1)
        begin = max(end - count, 0)
        if end > begin:
            speed[k] = (z[end] - z[begin]) / ((end - begin) * dt)
    return speed


def belief(corner, speed_variance, position=lambda R, dt: R, mean=lambda z0, z1, dt: [z1, (z1 - z0) / dt]):
    """Mean and covariance with some of their entries chosen; each is a function of (R, dt)."""

    def start(z0, z1, dt, R):
        c = corner(R, dt)
        return np.array(mean(z0, z1, dt)), np.array([[position(R, dt), c], [c, speed_variance(R, dt)]], dtype=float)

    return start


def right_corner(R, dt):
    return R / dt


def right_speed(R, dt):
    return 2 * R / dt**2


WRONG = {
    "start_variance": {
        "quarter": (spread(1 / 16), "That has a quarter of the range as σ, as for a bell shape. Here any value between two limits is equally likely: the squared range over 12."),
        "sixth": (spread(1 / 36), "That has a sixth of the range as σ, as for a bell shape. Here any value between two limits is equally likely: the squared range over 12."),
        "over 2": (spread(1 / 2), "The squared range is divided by 12, not by 2."),
        "over 3": (spread(1 / 3), "The squared *half* of the range is divided by 3; of the whole range it is 12."),
        "over 6": (spread(1 / 6), "The squared range is divided by 12, not by 6."),
        "over 24": (spread(1 / 24), "The squared range is divided by 12, not by 24."),
        "quarter, guess forgotten": (
            lambda low, high, believed: (high - low) ** 2 / 16,
            "That has a quarter of the range as σ (between hard limits it is the squared range over 12), and the wrong guess is missing.",
        ),
        "from low": (
            lambda low, high, believed: (high - low) ** 2 / 12 + (low - believed) ** 2,
            "The variance is right. The wrong guess is counted from the middle of the range, not from `low`.",
        ),
        "from high": (
            lambda low, high, believed: (high - low) ** 2 / 12 + (high - believed) ** 2,
            "The variance is right. The wrong guess is counted from the middle of the range, not from `high`.",
        ),
        "half the range as middle": (
            lambda low, high, believed: (high - low) ** 2 / 12 + ((high - low) / 2 - believed) ** 2,
            "(high − low)/2 is half the range. The middle of it is (low + high)/2.",
        ),
        "sum as middle": (
            lambda low, high, believed: (high - low) ** 2 / 12 + (low + high - believed) ** 2,
            "The middle of the range is *half* of low + high.",
        ),
        "distance with its sign": (
            lambda low, high, believed: (high - low) ** 2 / 12 + (low + high) / 2 - believed,
            "The distance from the middle to `believed` is in m/s; to be added to a variance it must be squared.",
        ),
        "roots added": (
            lambda low, high, believed: ((high - low) / math.sqrt(12) + abs((low + high) / 2 - believed)) ** 2,
            "You added σ and the distance and squared the sum. Their squares add up.",
        ),
        "a bell and the guess": (
            lambda low, high, believed: (high - low) / math.sqrt(12) + ((low + high) / 2 - believed) ** 2,
            "(high − low)/√12 is a standard deviation. P holds variances: square it.",
        ),
        "from the lower limit": (
            lambda low, high, believed: (low - believed) ** 2,
            "That is the squared error at the lower limit. The speed may be anything in between: take the mean over all of it.",
        ),
        "a whole number": (
            lambda low, high, believed: np.mean((np.arange(low, high + 1) - believed) ** 2),
            "That is right if the speed is a whole number of m/s. Here it may be anything in between: (high − low)²/12 in place of a sum.",
        ),
        "guess by 2": (
            lambda low, high, believed: (high - low) ** 2 / 12 + ((low + high) / 2 - believed) ** 2 / 2,
            "The squared distance is added as it is, not halved.",
        ),
    },
    "running_average": {
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
            lambda z, dt: np.concatenate([[np.nan] * 5, [np.median(np.diff(z[k - 5 : k + 1])) / dt for k in range(5, len(z))]]),
            "Those are medians of five differences. Their average is wanted.",
        ),
    },
    "report": {
        "scatter of the distances": (
            lambda e: (e.mean(axis=0), np.std(np.hypot(*e.T))),
            "The mean is right. The second is how the distances scatter about their mean. Root mean square: square, mean, root.",
        ),
        "median distance": (
            lambda e: (e.mean(axis=0), np.median(np.hypot(*e.T))),
            "The mean is right. The second number is the median distance, which half of the fixes have. Root mean square: square, mean, root.",
        ),
        "largest distance": (
            lambda e: (e.mean(axis=0), np.max(np.hypot(*e.T))),
            "The mean is right. The second number is the largest distance. Root mean square: square, mean, root.",
        ),
        "root of the sum over T": (
            lambda e: (e.mean(axis=0), np.sqrt(np.sum(e**2)) / len(e)),
            "The mean is right. You divided after the root. First the mean of the squares, then its root.",
        ),
        "sum of the errors": (
            lambda e: (e.sum(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first are sums: divide by the number of fixes.",
        ),
        "median error": (
            lambda e: (np.median(e, axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first are medians; the mean error is wanted.",
        ),
        "deviations": (
            lambda e: (e.std(axis=0), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first are standard deviations: a mean error has a sign, and is 0 where plus and minus cancel.",
        ),
        "rms of each axis, summed": (
            lambda e: (e.mean(axis=0), np.sum(np.sqrt(np.mean(e**2, axis=0)))),
            "The mean is right. You added the rms of both axes. Their squares add up, and then comes the root.",
        ),
        "rms first": (
            lambda e: (np.sqrt(np.mean(e**2, axis=0)), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The second is right. The first are root mean squares of each axis; the mean error has a sign.",
        ),
        "mean distance and covariance": (
            lambda e: (np.cov(e.T), np.sqrt(np.mean(e**2))),
            "Two faults: the first is still a covariance; and in the second the squares of east and north are to be added before the mean.",
        ),
        "mean distance, mean of all": (
            lambda e: (e.mean(), np.mean(np.hypot(*e.T))),
            "Two faults: the mean needs `axis=0`, east and north apart; and the second is still the mean distance: square first.",
        ),
        "length of the mean, and of all": (
            lambda e: (np.hypot(*e.mean(axis=0)), np.sqrt(np.mean(np.sum(e**2, axis=1)))),
            "The root mean square is right. The first is the length of the mean error; wanted are its two numbers, east and north.",
        ),
    },
    "data_sheet": {
        "36/1.18": (lambda: 36 / 1.18, "30.5 is 6²/1.18, with the 1.18 not squared. First σ = 6 m/1.18, then the square of it."),
        "1.18 · 36": (lambda: 36 * 1.18, "42.5 is 1.18 · 6². The radius is the larger number here, σ the smaller: divide, then square."),
        "2DRMS": (lambda: (6 / math.sqrt(8)) ** 2, "4.5 is (6/2.83)², as if 6 m were twice the rms distance, 2.83 σ. Half of the fixes lie within a smaller circle, 1.18 σ."),
        "over √2": (lambda: 36 / math.sqrt(2), "25.5 is 6²/√2. First σ of one axis, 6 m/1.18, then the square of it."),
        "rounded σ": (25.0, "σ is 6 m/1.18 = 5.1 m, so R is a little more than 25 m²: round only at the end."),
        "σ on a line": (lambda: 6 / 0.6745, "0.674σ holds half of the values on a *line*, and that is a σ, not a variance. In the plane half are within 1.18 σ."),
        "doubled": (144.0, "144 is 12². Half of the *fixes* are within 6 m, that is not half of σ: 6 m are 1.18 σ."),
        "twice 36": (72.0, "72 is (√2 · 6)². The radius is the larger number here, σ the smaller: σ = 6 m/1.18."),
        "R of 10 m": (100.0, "That is R of the lesson's receiver, with σ = 10 m. Of this one half of the fixes are within 6 m."),
        "multiplied σ": (lambda: 6 * 1.177, "7.06 is 1.18 · 6. The radius is the larger number here, σ the smaller; R is σ²."),
        "a quarter": (lambda: SIGMA**2 / 4, "6.49 is the square of half of σ. 6 m/1.18 is σ of one axis already, and R is its square."),
        "over √2 of σ": (lambda: SIGMA / math.sqrt(2), "3.6 is σ/√2. 6 m/1.18 is σ of one axis already; R is its square."),
        "fourth power": (lambda: SIGMA**4, "674 is the fourth power of σ: square once."),
        "mean, not squared": (lambda: 6 / 1.25, "4.8 is 6/1.25, a σ, with 6 m for the mean distance. Half of the fixes lie within 1.18 σ; and R is a variance."),
        "95 % factor, not squared": (lambda: 6 / 2.45, "2.45 is √6, or 6/2.45 as if 6 m held 95 %. Half of the fixes lie within 1.18 σ; and R is a variance."),
    },
    "two_point_start": {
        "deviations on the diagonal": (
            belief(lambda R, dt: 0, lambda R, dt: math.sqrt(2 * R) / dt, lambda R, dt: math.sqrt(R)),
            "The mean is right. P holds variances, and you have standard deviations; and the corner is not zero, for z₁ is in the position and in the speed.",
        ),
        "deviations on the diagonal, corner": (
            belief(right_corner, lambda R, dt: math.sqrt(2 * R) / dt, lambda R, dt: math.sqrt(R)),
            "The mean and the corner are right. On the diagonal stand variances, and you have standard deviations.",
        ),
        "the lesson's start": (
            belief(lambda R, dt: 0, lambda R, dt: 400 / 12),
            "The mean and the position's variance are right. The speed is (z₁ − z₀)/dt: what is the variance of that? And z₁ is in both, so the corner is not zero.",
        ),
        "correlation": (
            belief(lambda R, dt: math.sqrt(0.5), right_speed),
            "Both variances are right. You put the correlation, √½, into the corner. Wanted is the covariance, in m · m/s.",
        ),
        "half the corner": (
            belief(lambda R, dt: R / dt / 2, right_speed),
            "Both variances are right. The corner is the mean of e₁ · (e₁ − e₀)/dt; e₁² is R, and nothing halves it.",
        ),
        "root corner": (
            belief(lambda R, dt: math.sqrt(2) * R / dt, right_speed),
            "Both variances are right. The corner you have is the product of both σ, as if the errors were the same. Only a part of the speed's error is that of z₁.",
        ),
        "difference halved": (
            belief(right_corner, right_speed, mean=lambda z0, z1, dt: [z1, (z1 - z0) / (2 * dt)]),
            "P and the position are right. Between the two fixes lies one dt, not two.",
        ),
        "no speed": (
            belief(right_corner, right_speed, mean=lambda z0, z1, dt: [z1, 0.0]),
            "P and the position are right. The two fixes tell the speed as well: (z₁ − z₀)/dt.",
        ),
        "no dt in the mean": (
            belief(right_corner, right_speed, mean=lambda z0, z1, dt: [z1, z1 - z0]),
            "P and the position are right. The speed is the difference per second: divide by dt.",
        ),
        "predicted": (
            belief(right_corner, right_speed, mean=lambda z0, z1, dt: [2 * z1 - z0, (z1 - z0) / dt]),
            "The position is that of the second fix, z₁. You went on by one more step.",
        ),
        "four R": (
            belief(right_corner, lambda R, dt: 4 * R / dt**2),
            "The variance of a difference of two fixes is R + R = 2R, not 4R.",
        ),
        "2 squared": (
            belief(lambda R, dt: 0, lambda R, dt: 4 * R / dt**2),
            "The variance of a difference of two fixes is R + R = 2R, not 4R; and the corner is not zero, for z₁ is in both.",
        ),
        "difference of variances": (
            belief(lambda R, dt: 0, lambda R, dt: 0),
            "The variances of the two fixes do not cancel in the difference: they add up. And z₁ is in both, so there is a corner.",
        ),
        "the middle alone": (
            belief(right_corner, right_speed, mean=lambda z0, z1, dt: [(z0 + z1) / 2, (z1 - z0) / dt]),
            "P and the speed are right. The position at the time of z₁ is z₁; the middle is where it was half a step ago.",
        ),
        "half R": (
            belief(right_corner, right_speed, lambda R, dt: R / 2),
            "The position's variance is that of one fix, R. (The mean of both would have R/2, but it belongs half a step ago.)",
        ),
        "P times R twice": (
            belief(lambda R, dt: 0, right_speed, lambda R, dt: 2 * R),
            "The position is one fix, z₁, so its variance is R; and the corner is not zero, for z₁ is in both.",
        ),
        "large speed variance": (
            belief(lambda R, dt: 0, lambda R, dt: 1e6),
            "The speed is known from the two fixes, and not unknown: what is the variance of (z₁ − z₀)/dt? And z₁ is in both, so there is a corner.",
        ),
    },
}  # fmt: skip

for name, more in SECOND.items():
    WRONG[name] |= more
