"""Lesson 28, `behind`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show
from kflearn.exercises._slips.history.shared import CONSTANT_GAIN


def next_night(distance):
    """What a number would mean that is in no row."""
    after = (distance + 0.3) * (1 - 0.2207)
    if distance < 0:
        return "The estimate trails, so the distance is a positive number: each night adds 0.3 s, and the part K is taken away."
    return f"From {show(distance)} s the clock goes on to {show(distance + 0.3)} s, and the reading leaves {show(after)} s: not the same distance as the night before."


WRONG = {
    "before the reading": (
        lambda: 0.3 / CONSTANT_GAIN,
        "That is the distance *before* the night's reading, d + 0.3. After it the estimate has gone the part K of the way: d = 0.3(1 − K)/K.",
    ),
    "one night": (0.3, "0.3 s is what one night adds. But the estimate has not caught up with the nights before."),
    "the root mean square": (
        1.27,
        "1.27 s is what `compare` printed: the trailing and the noise together. The trailing alone is less.",
    ),
    "first night": (
        lambda: 0.3 * (1 - CONSTANT_GAIN),
        "That is the distance after the first night only. It grows until each night takes away as much as it adds.",
    ),
    "times K": (
        lambda: 0.3 * CONSTANT_GAIN,
        "That is 0.3 times K. With a *small* gain the estimate is far behind: K belongs in the denominator.",
    ),
    "upside down": (
        lambda: 0.3 * CONSTANT_GAIN / (1 - CONSTANT_GAIN),
        "The fraction is upside down: with a gain near 1 the estimate hardly trails, with one near 0 it trails far.",
    ),
    "nights": (
        lambda: (1 - CONSTANT_GAIN) / CONSTANT_GAIN,
        "That is how many *nights* it trails, the mean age of what it knows. Each is worth 0.3 s.",
    ),
    "minus sign": (
        lambda: -0.3 * (1 - CONSTANT_GAIN) / CONSTANT_GAIN,
        "The size is right. How far it *trails* was asked for, a positive number.",
    ),
    "1 − K below": (
        lambda: 0.3 / (1 - CONSTANT_GAIN),
        "That is 0.3 divided by 1 − K. Each night the estimate goes the part K of the way, so K belongs in the denominator.",
    ),
    "nights of 1/K": (
        lambda: 1 / CONSTANT_GAIN,
        "1/K is a number of nights. Each is worth 0.3 s, and the last of them has been caught up with.",
    ),
    "not at all": (
        0,
        "A constant gain never catches up with a steady drift: each night the part 1 − K of the new distance is left.",
    ),
    "two nights": (
        lambda: 0.3 * (1 - CONSTANT_GAIN) + 0.3 * (1 - CONSTANT_GAIN) ** 2,
        "That is the distance after the second night. It goes on growing until each night takes away what it adds.",
    ),
    "the mean innovation": (
        1.30,
        "1.30 s is the mean innovation that the lesson printed, of another filter and *before* the reading. After it the estimate is nearer.",
    ),
    "all nights": (
        30,
        "30 s is what the clock gains in a hundred nights. The estimate follows it, at a distance that does not grow any more.",
    ),
    "two times (1 − K)": (
        lambda: 0.3 * (1 - 0.2207) ** 2 / 0.2207,
        "That is 0.3(1 − K)²/K, with 1 − K twice: after the night's reading it is 0.3(1 − K)/K.",
    ),
    "half": (0.15, "That is half of one night. The estimate has not caught up with the nights before either."),
    "of 2 − K": (
        lambda: 0.3 * 0.2207 / (2 - 0.2207),
        "K/(2 − K) is the share of the *noise* that is left. Here the readings have no error, and the clock drifts.",
    ),
    "ten nights ago": (
        0.083,
        "0.083 is the weight of a reading of ten nights ago. Asked for are seconds.",
    ),
    "one clock's": (3.2, "That is the error of one clock in the lesson, with its noise. Here the readings have none."),
    "further and further": (
        np.inf,
        "It does not grow for ever. Each night takes the part K of the distance away, so it stays the same where K(d + 0.3) = 0.3.",
    ),
}
