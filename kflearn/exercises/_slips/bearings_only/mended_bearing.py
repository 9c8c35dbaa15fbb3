"""Lesson 15, `mended_bearing`: wrong answers, each with the sentence that it gets."""

import math

import numpy as np


def published(east, north):
    """The published angle function, in all four quadrants."""
    slope = math.atan(abs(north / east))
    if north >= 0:
        return slope if east > 0 else math.pi / 2 + slope
    return 1.5 * math.pi + slope if east > 0 else math.pi + slope


TURN = 2 * math.pi


def half_mended(quadrant):
    """The published function with one of its two wrong quadrants mended."""

    def bearing(east, north):
        here = (north > 0 > east and 2) or (east > 0 > north and 4)
        return math.atan2(north, east) % TURN if here == quadrant else published(east, north)

    return bearing


def without_abs(east, north):
    """The published function with its `abs` taken away, and nothing else."""
    slope = math.atan(north / east)
    if north >= 0:
        return slope if east > 0 else math.pi / 2 + slope
    return 1.5 * math.pi + slope if east > 0 else math.pi + slope


def turned_over(east, north):
    """The quotient is right in quadrants 2 and 4."""
    quadrant = np.where(north >= 0, np.where(east > 0, 0, 1), np.where(east > 0, 3, 2))
    return np.pi / 2 * quadrant + np.arctan(abs(east / north))


QUARTER = np.pi / 2


def clockwise(east, north):
    """Quadrants numbered clockwise, and the published line."""
    quadrant = (0 if east > 0 else 3) if north >= 0 else (1 if east > 0 else 2)
    return QUARTER * quadrant + np.arctan(abs(north / east))


def taken_from_a_turn(east, north):
    """A negative angle is taken from the full circle, not added to it."""
    angle = np.arctan2(north, east)
    return angle if angle > 0 else 2 * np.pi - angle


WRONG = {
    "as published": (
        published,
        "That is the published function again: 105° becomes 165°, and 285° becomes 345°.",
    ),
    "quadrant 2 mended": (
        half_mended(2),
        "Quadrant 2 is mended. Quadrant 4 has the same fault: there the bearing is 360° minus the angle.",
    ),
    "quadrant 4 mended": (
        half_mended(4),
        "Quadrant 4 is mended. Quadrant 2 has the same fault: there the bearing is 180° minus the angle.",
    ),
    "without abs": (
        without_abs,
        "Quadrants 2 and 4 come out as 90° and 270° minus the angle to the east–west axis, as without `abs`. "
        "It is 180° minus it in quadrant 2, 360° minus it in quadrant 4.",
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
        "The quotient has lost one sign, and a full turn more does not bring it back: quadrants 2 and 3 are 180° off.",
    ),
    "arguments swapped": (
        lambda east, north: math.atan2(east, north),
        "That bearing counts from north, clockwise, as a compass does. Wanted is the angle from east towards north; "
        "`arctan2` takes north first.",
    ),
    "arguments swapped, from 0": (
        lambda east, north: math.atan2(east, north) % TURN,
        "That bearing counts from north, clockwise, as a compass does. Wanted is the angle from east towards north; "
        "`arctan2` takes north first.",
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
        "Your bearing is off by half a turn for targets in the south, so opposite directions become equal. What a "
        "negative angle of `arctan2` needs is a full turn, 2π.",
    ),
    "half a turn added": (
        lambda east, north: math.atan2(north, east) + math.pi,
        "Every bearing points the opposite way, as if 180° were added to all or both signs were turned. Only the "
        "negative angles of `arctan2` need something added, a full circle, 2π.",
    ),
    "% 360": (
        lambda east, north: math.atan2(north, east) % 360,
        "`arctan2` answers in radians, so a full circle is 2π, not 360.",
    ),
    "absolute value": (
        lambda east, north: abs(math.atan2(north, east)),
        "Every target in the south comes out in the north, as with `abs`. In the south the bearing is a full circle, "
        "2π, minus that angle.",
    ),
    "a turn added to all": (
        lambda east, north: math.atan2(north, east) + TURN,
        "All your bearings are a full circle larger than those of `arctan2`: in the north they are above 2π. The remainder, `% (2 * np.pi)`, adds it only where needed.",
    ),
    "no turn in quadrant 4": (
        lambda east, north: math.atan(north / east) if east > 0 else math.atan(north / east) + math.pi,
        "Right in three quadrants. In the south-east your answer is negative: add a full circle, 2π.",
    ),
    "arctangent plus half a turn": (
        lambda east, north: math.atan(north / east) + math.pi,
        "The quotient has lost one sign, and adding 180° to all cannot bring it back: look at the signs of both, as `arctan2` does.",
    ),
    "no brackets": (
        lambda east, north: math.atan2(north, east) % 2 * math.pi,
        "That is the remainder by 2, times π: `%` and `*` are worked out from left to right. Put brackets round `(2 * np.pi)`.",
    ),
    "from north, anticlockwise": (
        lambda east, north: math.atan2(-east, north) % TURN,
        "Every bearing is a quarter of a turn too small, as if it counted from north. It counts from east: 0 is east, π/2 is north.",
    ),
    "a quarter turn too much": (
        lambda east, north: (math.atan2(north, east) + math.pi / 2) % TURN,
        "Every bearing is a quarter of a turn too large. A target in the east has the bearing 0.",
    ),
    "signs of a half turn": (
        lambda east, north: math.pi - math.atan2(north, east),
        "East and west have changed places: a target in the east must get a bearing near 0 or 2π.",
    ),
    "quadrants by the sign of north alone": (
        lambda east, north: math.atan(north / east) + (math.pi if north < 0 else 0),
        "In the west the arctangent points to the east, whatever north is: half a turn is to be added where *east* is negative.",
    ),
    "quadrants, no turn in 4 and none in 2": (
        lambda east, north: math.atan(abs(north / east)) + (0 if east > 0 else math.pi),
        "The angle to the east–west axis is added in quadrants 1 and 3 only. In 2 and 4 it is subtracted: 180° minus it, 360° minus it.",
    ),
    "arctangent of east over north": (
        lambda east, north: math.atan(east / north) % TURN,
        "Two things: the quotient loses a sign, and it is north over east. `arctan2` takes north first, and looks at both signs.",
    ),
    "quotient turned over": (
        turned_over,
        "That is right in quadrants 2 and 4. In 1 and 3 the quotient must be north/east.",
    ),
    "quadrants clockwise": (
        clockwise,
        "Right in quadrants 1 and 3. The quarter turns of 2 and 4 have changed places, and they were right. What is wrong there is the "
        "arctangent of `abs(…)`, which runs backwards: 180° minus it, 360° minus it.",
    ),
    "taken from a full circle": (
        taken_from_a_turn,
        "Right in the north. In the south your bearings are larger than a full circle: `arctan2` is negative there, "
        "and a negative angle is *added* to 2π.",
    ),
    "arcsine": (
        lambda east, north: np.arcsin(north / np.hypot(east, north)) % (2 * np.pi),
        "Right in the east. A target in the west gets the bearing of its mirror image in the east: the sign of "
        "`east` is lost, as in an arcsine. `arctan2` looks at both signs.",
    ),
    "1000 m further north": (
        lambda east, north: np.arctan2(north - 1000, east) % (2 * np.pi),
        "That is the bearing from a place 1000 m north of the station. `north` is counted from the station "
        "already: nothing is to be subtracted.",
    ),
}
