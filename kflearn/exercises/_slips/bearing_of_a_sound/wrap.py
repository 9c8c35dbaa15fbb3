"""Lesson 8, `wrap`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def stepping_down(d):
    """Whole turns taken off, never added."""
    return d - 360 * math.ceil((d - 180) / 360) if d > 180 else d


def stepping_up(d):
    """Whole turns added, never taken off."""
    return d + 360 * math.ceil((-180 - d) / 360) if d < -180 else d


WRONG = {
    "untouched": (
        lambda d: d,
        "That hands the difference back as it came: 8 − 339 is still −331, the long way round.",
    ),
    "% 360": (
        lambda d: d % 360,
        "That lies between 0 and 360, as by `% 360`: 3° to the left become 357° to the right.",
    ),
    "absolute value": (
        lambda d: abs((d + 180) % 360 - 180),
        "The size is right, but the sign is lost: the filter would turn the same way for a reading on the left and one on the right.",
    ),
    "absolute value first": (
        lambda d: abs(d) % 360,
        "The direction is lost, as by `abs`; and the result still goes up to 360.",
    ),
    "absolute value only": (
        lambda d: abs(d),
        "The direction is lost, as by `abs`, and nothing shortened: 331 is as long a way as −331.",
    ),
    "radians": (
        lambda d: (d + math.pi) % (2 * math.pi) - math.pi,
        "That wraps at π, as for radians; these are degrees, a turn is 360.",
    ),
    "radians returned": (
        lambda d: math.radians((d + 180) % 360 - 180),
        "It is wrapped as it should be, but in radians; the filter works in degrees.",
    ),
    "from 0 to 360 with half a turn": (
        lambda d: (d + 180) % 360,
        "A difference of 0 becomes 180: after the remainder half a turn must come off.",
    ),
    "half a turn as period": (
        lambda d: (d + 90) % 180 - 90,
        "That wraps with a period of 180: a voice behind is then taken for one in front.",
    ),
    "only downwards": (
        lambda d: d - 360 if d > 180 else d,
        "You mend differences above 180 only; 8 − 339 = −331 needs a turn added.",
    ),
    "only upwards": (
        lambda d: d + 360 if d < -180 else d,
        "You mend differences below −180 only; 339 − 8 = 331 needs a turn taken off.",
    ),
    "one turn only": (
        lambda d: d - 360 if d > 180 else d + 360 if d < -180 else d,
        "Right for one turn. But the estimate itself is never wrapped and may be several turns on: use the remainder, `%`.",
    ),
    "C's remainder": (
        lambda d: math.fmod(d + 180, 360) - 180,
        "What lies below −180 becomes too low: `fmod` and `int` cut towards zero, as C does; Python's `%` does not.",
    ),
    "the other way round": (
        lambda d: -((d + 180) % 360 - 180),
        "The size is right and the sign is the opposite: the filter would walk away from the sound.",
    ),
    "arcsine of the sine": (
        lambda d: math.degrees(math.asin(math.sin(math.radians(d)))),
        "The arcsine knows only −90 to 90: that is the front/back ambiguity of the two microphones again.",
    ),
    "moved down only": (
        lambda d: d % 360 - 180,
        "After the remainder you moved down by half a turn, so a difference of 0 becomes −180. What must be done before the remainder?",
    ),
    "half turns taken off": (
        lambda d: d % 180,
        "That takes off half turns: a difference of 190 becomes 10, though that is on the other side. A turn is 360.",
    ),
    "up twice": (
        lambda d: (d + 180) % 360 + 180,
        "A difference of 0 becomes 360: after the remainder half a turn must come off, not be added.",
    ),
    "two turns": (
        lambda d: next((d + 360 * k for k in (0, -1, 1, -2, 2) if abs(d + 360 * k) <= 180), d),
        "Right for two turns. After three the difference is beyond 900, and you leave it there: the remainder, `%`, takes off any number of turns.",
    ),
    "sine of degrees": (
        lambda d: np.degrees(np.arctan2(np.sin(d), np.cos(d))),
        "The difference is taken for radians, as by `np.sin`. It is in degrees: turn it into radians first.",
    ),
    "clipped": (
        lambda d: np.clip(d, -180, 180),
        "You cut the difference off at ±180. 190° to the right is not 180° to the right, it is 170° to the left: take off whole turns.",
    ),
    "steps down": (
        stepping_down,
        "Differences above 180 come out right. Those below −180 need whole turns added.",
    ),
    "steps up": (
        stepping_up,
        "Differences below −180 come out right. From those above 180 whole turns have to be taken off.",
    ),
    "towards zero": (
        lambda d: d - 360 * int(d / 360),
        "You took off the whole turns, and what is left lies between −360 and 360. 331 is still the long way round.",
    ),
    "below zero": (
        lambda d: -(-d % 360),
        "That puts every difference between −360 and 0. −331 is the long way round.",
    ),
    "reflected": (
        lambda d: d % 360 if d % 360 <= 180 else 180 - d % 360,
        "Up to 180 it is right. Beyond that the way to the left is what is missing to a whole turn, not what is beyond half a turn.",
    ),
    "from 180": (
        lambda d: 180 - d % 360,
        "That is 180 minus the remainder: a difference of 1 becomes 179, and the sign is turned round.",
    ),
    "away from zero": (
        lambda d: math.copysign(abs(d) % 180, d),
        "That takes off half turns: a difference of 190 becomes 10, though that is on the other side. A turn is 360.",
    ),
    "remainder by half a turn": (
        lambda d: (d + 180) % 180 - 180,
        "You took the remainder by 180, half a turn: the result is never above 0. A whole turn is 360.",
    ),
}
