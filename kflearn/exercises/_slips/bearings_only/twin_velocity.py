"""Lesson 15, `twin_velocity`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show


def relative_of(velocity):
    """What a number would mean that is in no row."""
    east, north = velocity - [6, 0]
    return (
        f"Relative to us that target moves with ({show(east)}, {show(north)}) m/s. The true one moves with (−3, −2) m/s, and the "
        "twin, twice as far away, with twice of that."
    )


WRONG = {
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
    "three numbers": (
        (-3, -2, 5000),
        "Two numbers are wanted. (−3, −2) is the target's velocity relative to us: double it, and add ours.",
    ),
}
