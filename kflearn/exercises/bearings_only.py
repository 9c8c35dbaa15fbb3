"""Lesson 13: only the direction."""

import math

import numpy as np

from kflearn.exercises.engine import exercise

TURN = 2 * math.pi


def published(east, north):
    """The published angle function, in all four quadrants."""
    slope = math.atan(abs(north / east))
    if north >= 0:
        return slope if east > 0 else math.pi / 2 + slope
    return 1.5 * math.pi + slope if east > 0 else math.pi + slope


def half_mended(quadrant):
    """The published function with one of its two wrong quadrants mended."""

    def bearing(east, north):
        here = (north > 0 > east and 2) or (east > 0 > north and 4)
        return math.atan2(north, east) % TURN if here == quadrant else published(east, north)

    return bearing


def offsets(rng):
    """How far east and north of a station a target is, in metres; never on an axis or a diagonal."""
    size, sign = rng.choice(np.arange(1, 90), 2, replace=False), rng.choice([-1, 1], 2)
    east, north = size * sign
    return float(east), float(north)


@exercise(
    hints=[
        "Draw a target north-west of the station. From which axis is `np.arctan(abs(north / east))` measured, and which way round?",
        "It is always the angle to the east–west axis. In quadrant 2 one goes half a turn and comes back by it; in quadrant 4 a whole turn.",
        "`np.arctan2` takes north first, then east, and looks at both signs; it gives −π to π.",
        "In one line: `return np.arctan2(north, east) % (2 * np.pi)`.",
    ],
    inputs=offsets,
    wrong={
        "as published": (
            published,
            "That is the published function again: 105° becomes 165°, and 285° becomes 345°.",
        ),
        "quadrant 2 mended": (
            half_mended(2),
            "Quadrant 2 is mended. Quadrant 4 has the same fault: there one comes back from a whole turn.",
        ),
        "quadrant 4 mended": (
            half_mended(4),
            "Quadrant 4 is mended. Quadrant 2 has the same fault: there one comes back from half a turn.",
        ),
        "from −π to π": (
            lambda east, north: math.atan2(north, east),
            "The direction is right; the published function answers from 0 to 2π, so take the remainder, `% (2 * np.pi)`.",
        ),
        "arctangent": (
            lambda east, north: math.atan(north / east),
            "The quotient has lost one sign: a target in the north-east and one in the south-west get the same bearing.",
        ),
        "arctangent from 0": (
            lambda east, north: math.atan(north / east) % TURN,
            "The remainder cannot bring back the sign that the quotient has lost: quadrants 2 and 3 are still half a turn off.",
        ),
        "arguments swapped": (
            lambda east, north: math.atan2(east, north),
            "`arctan2` takes north first. You have measured from north, clockwise, as a compass does.",
        ),
        "arguments swapped, from 0": (
            lambda east, north: math.atan2(east, north) % TURN,
            "`arctan2` takes north first. You have measured from north, clockwise, as a compass does.",
        ),
        "no signs at all": (
            lambda east, north: math.atan2(abs(north), abs(east)),
            "Without the signs every target is seen in the north-east.",
        ),
        "degrees": (
            lambda east, north: math.degrees(math.atan2(north, east)) % 360,
            "The right direction, but in degrees; the filter works in radians.",
        ),
        "mirrored": (
            lambda east, north: math.atan2(-north, east) % TURN,
            "North and south have changed places: a target in the north must get a bearing between 0 and π.",
        ),
        "modulo half a turn": (
            lambda east, north: math.atan2(north, east) % math.pi,
            "Half a turn is no turn: the station would take what is behind it for what is in front of it.",
        ),
    },
)
def mended_bearing(east, north):
    """The bearing of a target (rad, from 0 to 2π, counted from east towards north), `east` and `north` of a station."""
    return np.arctan2(north, east) % (2 * np.pi)


@exercise(
    hints=[
        "Look at what each line computes, not at what its result is called.",
        "Units: how many radians does the bearing turn for each metre? The result must be something per metre.",
        "Hand the function a place, and compare it with `bearing_slope` from above, or with two bearings a metre apart.",
    ],
    wrong={
        "a": (
            "a",
            "With the root, line 3 would divide metres by metres, and a target ten times as far away would turn the bearing as fast. Look at what is divided by, not at its name.",
        ),
        "b": (
            "b",
            "Try a target due east. One metre further north turns its bearing up: the entry for north is +east/…, as in line 3.",
        ),
        "c": (
            "c",
            "How fast a target moves does not change where it is seen now. The zeros are right.",
        ),
    },
)
def review():
    """Which of the four reviewers of the published Jacobian is right?"""
    return "d"


@exercise(
    hints=[
        "A variance is a mean of squares. If every number is multiplied by c, what happens to its square?",
        "First make the standard deviation radians. Then square.",
        "In one line: `return np.radians(sd) ** 2`.",
    ],
    inputs=lambda rng: (float(rng.integers(1, 400) / 100),),
    wrong={
        "as published": (
            lambda sd: math.radians(sd),
            "That is the standard deviation in radians. Handed over as a variance, 0.1° becomes √(0.1·π/180) rad = 2.394°.",
        ),
        "degrees squared": (
            lambda sd: sd**2,
            "That is the variance in degrees squared; the filter's innovations are radians.",
        ),
        "squared before": (
            lambda sd: math.radians(sd**2),
            "You squared the degrees and converted once. The factor π/180 must be squared too.",
        ),
        "degrees": (lambda sd: sd, "That is σ, in degrees: neither a variance nor radians."),
        "backwards": (
            lambda sd: math.degrees(sd) ** 2,
            "You multiplied by 180/π: `np.degrees` turns radians into degrees. The other way.",
        ),
        "root": (
            lambda sd: math.sqrt(math.radians(sd)),
            "You took the root; from σ to the variance one squares.",
        ),
        "180 not squared": (
            lambda sd: (sd * math.pi) ** 2 / 180,
            "Square the whole of sd·π/180, the 180 as well.",
        ),
        "a whole turn": (
            lambda sd: (sd * math.pi / 360) ** 2,
            "π radians are 180°, not 360°.",
        ),
    },
)
def bearing_variance(sd):
    """R (rad²) of a sensor whose bearings scatter with the standard deviation `sd`, in degrees."""
    return np.radians(sd) ** 2


@exercise(
    hints=[
        "What is scaled is the relative state: relative place and relative velocity. What is the target's velocity relative to us?",
        "Relative velocity = own velocity − ours. Double it; then go back from relative to own.",
        "Relative: (3, −2) − (6, 0) = (−3, −2). The twin's is (−6, −4). Add our (6, 0).",
    ],
    wrong={
        "own velocity doubled": (
            (6, -4),
            "You doubled the target's own velocity. What scales is the velocity relative to us, (−3, −2).",
        ),
        "relative velocity": (
            (-6, -4),
            "That is the twin's velocity relative to us. Its own is larger by ours: add (6, 0).",
        ),
        "unchanged": (
            (3, -2),
            "With the same velocity, twice as far away, the bearing would turn half as fast: that can be seen.",
        ),
        "relative, not doubled": (
            (-3, -2),
            "That is the true target's velocity relative to us: double it, then add ours.",
        ),
        "ours subtracted twice": (
            (-12, -4),
            "You subtracted our velocity again; going back from relative to own, it is added.",
        ),
        "half": ((1.5, -1), "Twice as far away, the twin must move faster, not more slowly, to keep the same bearing."),
        "half, relative": ((4.5, -1), "Twice as far away, the relative velocity doubles; you have halved it."),
    },
    unit="m/s",
)
def twin_velocity():
    """The own velocity (east, north) of the target twice as far away that shows the same bearings."""
    ours = np.array([6, 0])
    relative = np.array([3, -2]) - ours
    return 2 * relative + ours
