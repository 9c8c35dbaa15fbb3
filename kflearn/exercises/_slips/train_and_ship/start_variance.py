"""Lesson 11, `start_variance`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def spread(part, guess=2):
    """A share of the squared range, and the distance from the middle to a power."""
    return lambda low, high, believed: part * (high - low) ** 2 + abs((low + high) / 2 - believed) ** guess


WRONG = {
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
    "quarter": (
        spread(1 / 16),
        "That has a quarter of the range as σ, as for a bell shape. Here any value between two limits is equally likely: the squared range over 12.",
    ),
    "sixth": (
        spread(1 / 36),
        "That has a sixth of the range as σ, as for a bell shape. Here any value between two limits is equally likely: the squared range over 12.",
    ),
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
    "two sigma": (
        lambda low, high, believed: (max(high - believed, believed - low) / 2) ** 2,
        "All speeds in the range are equally likely, so there is no rule of two σ. Average the squared distance from `believed` over the range.",
    ),
    "half of high": (
        lambda low, high, believed: (high - low) ** 2 / 12 + (low + high / 2 - believed) ** 2,
        "`low + high / 2` halves only high: the middle is `(low + high) / 2`.",
    ),
    "the lesson's middle": (
        lambda low, high, believed: (high - low) ** 2 / 12 + (10 - believed) ** 2,
        "Your middle is 10, that of the lesson's trains. Here it is (low + high)/2.",
    ),
    "half of the range": (
        lambda low, high, believed: (high - low) ** 2 / 48 + ((low + high) / 2 - believed) ** 2,
        "You took half of the width. An even distribution has the variance (high − low)²/12, with the whole width.",
    ),
}
