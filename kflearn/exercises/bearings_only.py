"""Lesson 15: only the direction."""

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._bearings_only import WRONG
from kflearn.exercises._hints import tried
from kflearn.exercises._slips_eleventh import WRONG as ELEVENTH
from kflearn.exercises._slips_fifth_late import WRONG as FIFTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_fourth_words import REVIEW
from kflearn.exercises._slips_third_filters import WRONG as THIRD
from kflearn.exercises.engine import exercise


def offsets(rng):
    """How far east and north of a station a target is, in metres; never on an axis or a diagonal."""
    size, sign = rng.choice(np.arange(1, 90), 2, replace=False), rng.choice([-1, 1], 2)
    east, north = size * sign
    return float(east), float(north)


@exercise(
    hints=[
        "Draw a target north-west of the station. From which axis is `np.arctan(abs(north / east))` measured, and which way round?",
        "It is always the angle to the east–west axis. In quadrant 2 the bearing is 180° minus that angle, in quadrant 4 it is 360° minus it.",
        tried(
            (-1, 1),
            "mended_bearing(-1, 1)",
            "That target is in the north-west, 135° from east: 2.356 rad.",
            "Try a target one metre west and one metre north: 135° from east, 2.356 rad.",
        ),
        "`np.arctan2` takes north first, then east, and looks at both signs; it gives −π to π.",
        "In one line: `return np.arctan2(north, east) % (2 * np.pi)`.",
    ],
    inputs=offsets,
    wrong=WRONG["mended_bearing"] | THIRD["mended_bearing"] | FIFTH["mended_bearing"] | ELEVENTH["mended_bearing"],
    then="NumPy's arctan2 was made for this, and it also works where east is 0. Which bearing has a target due south?",
    rtol=1e-4,  # with 6.2832 for 2π
)
def mended_bearing(east, north):
    """The bearing of a target (rad, from 0 to 2π, counted from east towards north), `east` and `north` of a station."""
    return np.arctan2(north, east) % (2 * np.pi)


@exercise(
    hints=[
        "Look at what each line computes, not at what its result is called.",
        "Units: by how many radians does the bearing change for each metre? The result must be something per metre.",
        "Call the function with a place, and compare the result with `bearing_slope` from above, or with two bearings a metre apart.",
    ],
    wrong={
        "a": (
            "a",
            "With the root, line 3 would divide metres by metres, and a step of a target ten times as far away would change the bearing as much. Look at what the divisor is, not at its name.",
        ),
        "b": (
            "b",
            "Try a target due east. One metre further north makes its bearing larger: the entry for north is +east/…, as in line 3.",
        ),
        "c": (
            "c",
            "How fast a target moves does not change where it is seen now. The zeros are right.",
        ),
    },
    also=["Nothing is wrong", "nothing"],
    otherwise=REVIEW,
    then="(d): the gradient of a bearing is (−north, east)/distance², per metre. Only the name in the code is wrong: `distance` is a square.",
)
def review():
    """Which of the four reviewers of the published Jacobian is right?"""
    return "d"


@exercise(
    hints=[
        "A variance is a mean of squares. If every number is multiplied by c, by what is its square multiplied?",
        "First turn the standard deviation into radians. Then square it.",
        "In one line: `return np.radians(sd) ** 2`.",
    ],
    inputs=lambda rng: (float(rng.integers(1, 400) / 100),),
    wrong=WRONG["bearing_variance"] | FOURTH["bearing_variance"] | ELEVENTH["bearing_variance"],
    then="For 0.1° it is 3·10⁻⁶ rad². The published number describes a sensor of 2.4°, so the filter gives good readings far too little weight.",
    rtol=5e-4,  # numbers of the learner's own, such as 0.0175 for π/180
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
            "(6, −4) is twice the target's own velocity, and also twice the relative one with twice ours added. What doubles is the velocity relative to us, (−3, −2); ours is added once.",
        ),
        "relative velocity": (
            (-6, -4),
            "That is the twin's velocity relative to us. Its own is larger by ours: add (6, 0).",
        ),
        "unchanged": (
            (3, -2),
            "With the same velocity, twice as far away, the bearing would change half as fast, and that can be seen.",
        ),
        "relative, not doubled": (
            (-3, -2),
            "That is the true target's velocity relative to us: double it, then add ours.",
        ),
        "ours subtracted twice": (
            (-12, -4),
            "That is the twin's relative velocity, (−6, −4), less ours. To go back from relative to own, ours is added.",
        ),
        "half": ((1.5, -1), "Twice as far away, the twin must move faster, not more slowly, to keep the same bearing."),
        "half, relative": (
            (4.5, -1),
            "That is half of the relative velocity, plus ours. Twice as far away, the relative velocity doubles.",
        ),
        "doubled, ours not": (
            (12, -4),
            "12 east is not right; the north is. Relative to us the target moves with 3 − 6 = −3 to the east: that doubles, and then our 6 is added.",
        ),
        "both added": (
            (9, -2),
            "That is the sum of the two velocities. The relative velocity is the target's minus ours; double it, then add ours.",
        ),
        "sign": (
            (0, 4),
            "The sign of the second number: relative is target minus ours, −2 − 0 to the north. It doubles and keeps its sign.",
        ),
        "east and north swapped": ((-4, 0), "These are the right two numbers, exchanged: east comes first."),
        "ours counted twice": (
            (6, -2),
            "Relative to us that target does not move east or west. Both parts of the relative velocity, (−3, −2), double; then our (6, 0) is added.",
        ),
        "not doubled in the north": (
            (0, -2),
            "East is right. The north part of the relative velocity, −2, doubles as well.",
        ),
        "sum doubled": (
            (18, -4),
            "That is twice the sum of the two velocities. Take the target's minus ours, double it, then add ours.",
        ),
        "one doubled": (
            (12, -2),
            "Relative to us that target moves with (6, −2), and the true one with (−3, −2): both numbers are to be doubled, then our (6, 0) is added.",
        ),
        "ours minus theirs, doubled": (
            (6, 4),
            "That is our velocity minus the target's, doubled. Relative is target minus ours; and at the end our velocity is added.",
        ),
        "signs of relative and own": (
            (12, 4),
            "The signs: relative is target minus ours, (−3, −2). Doubled, our (6, 0) is *added* to it.",
        ),
        "target's velocity added": (
            (-3, -6),
            "(−3, −6) is twice the relative velocity plus the target's own, and also three times the relative one plus ours. Double the relative velocity once, then add ours, (6, 0).",
        ),
        "target's taken off": (
            (-9, -2),
            "That is twice the relative velocity, less the target's. It is relative to us: add ours.",
        ),
        "our velocity": (
            (6, 0),
            "That is our own velocity. A ship that moves as we do would be seen in one direction for ever.",
        ),
        "four times": (
            (-6, -8),
            "That is four times the relative velocity, plus ours. Twice as far away, the relative velocity doubles once.",
        ),
        "ours unchanged, north doubled": (
            (3, -4),
            "North is right. East: relative it is 3 − 6 = −3; double that, and add our 6.",
        ),
    }
    | FOURTH["twin_velocity"],
    otherwise=facts.relative_of,
    unit="m/s",
    then="Every distance has such a twin. The twins separate only when we change our own velocity, by a turn or by a change of speed; best across the line of sight.",
)
def twin_velocity():
    """The own velocity (east, north) of the target twice as far away that shows the same bearings."""
    ours = np.array([6, 0])
    relative = np.array([3, -2]) - ours
    return 2 * relative + ours
