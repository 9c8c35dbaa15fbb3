"""Lesson 15: only the direction."""

import numpy as np

from kflearn.exercises._hints import tried
from kflearn.exercises._slips import bearings_only as slips
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
    wrong=slips.mended_bearing.WRONG,
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
    wrong=slips.review.WRONG,
    also=["Nothing is wrong", "nothing"],
    otherwise=slips.review.REVIEW,
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
    wrong=slips.bearing_variance.WRONG,
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
    wrong=slips.twin_velocity.WRONG,
    otherwise=slips.twin_velocity.relative_of,
    unit="m/s",
    then="Every distance has such a twin. The twins separate only when we change our own velocity, by a turn or by a change of speed; best across the line of sight.",
)
def twin_velocity():
    """The own velocity (east, north) of the target twice as far away that shows the same bearings."""
    ours = np.array([6, 0])
    relative = np.array([3, -2]) - ours
    return 2 * relative + ours
