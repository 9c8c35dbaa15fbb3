"""Lesson 1, `three_sensors`: wrong answers, each with the sentence that it gets."""

import numpy as np

READINGS = (
    "These are readings. H holds what makes readings of [p, v]: two factors in a row, and one row for each sensor."
)


def first_wrong_row(H):
    """What to look at, for an H of the right form: the first sensor whose row is not right."""
    rows = {"the tape in metres": [1, 0], "the tape in centimetres": [100, 0], "the speedometer": [0, 3.6]}
    names = [name for row, (name, right) in zip(H, rows.items(), strict=True) if not np.allclose(row, right)]
    if np.isclose(H[1][0], 100 * H[0][0]) and abs(H[0][0]) > 1.5 and not (H[0][1] or H[1][1]):
        return (
            f"These look like readings: a tape that shows {H[0][0]:g} m. H holds no readings, but what each sensor shows for "
            "1 m and 0 m/s (first column), and for 0 m and 1 m/s (second column)."
        )
    return f"Look at the {'row' if len(names) == 1 else 'rows'} of {' and '.join(names)}: what is shown for 1 m and 0 m/s, and what for 0 m and 1 m/s?"


WRONG = {
    "as published": (
        [[1, 1], [100, 0], [0, 3.6]],
        "The first row is still the article's [1, 1]: a tape does not see the velocity.",
    ),
    "ones everywhere": (
        [[1, 1], [100, 100], [3.6, 3.6]],
        "Each row asks for position and velocity at once. A tape sees the first only, a speedometer the second only.",
    ),
    "tapes that see the velocity": (
        [[1, 1], [100, 100], [0, 3.6]],
        "The speedometer is right. Both tapes still add the velocity to the position.",
    ),
    "centimetres the wrong way": (
        [[1, 0], [0.01, 0], [0, 3.6]],
        "The second row turns centimetres into metres. H goes from the state to the reading: 1 m reads 100.",
    ),
    "km/h the wrong way": (
        lambda: [[1, 0], [100, 0], [0, 1 / 3.6]],
        "The third row turns km/h into m/s. H goes from the state to the reading: 1 m/s reads 3.6.",
    ),
    "both the wrong way": (
        lambda: [[1, 0], [0.01, 0], [0, 1 / 3.6]],
        "Your units go from the reading to the state. H goes the other way: 1 m reads 100, and 1 m/s reads 3.6.",
    ),
    "speed in m/s": (
        [[1, 0], [100, 0], [0, 1]],
        "The tapes are right. The speedometer shows km/h, and the state holds m/s: 1 m/s reads 3.6.",
    ),
    "km/h without the hour": (
        [[1, 0], [100, 0], [0, 0.001]],
        "The tapes are right. 0.001 turns metres into kilometres, but not seconds into hours: 3,600 s for 1,000 m.",
    ),
    "metres per hour": (
        [[1, 0], [100, 0], [0, 3600]],
        "The tapes are right. Your speedometer shows metres per hour: divide by 1,000.",
    ),
    "km/h in the first column": (
        [[1, 0], [100, 0], [3.6, 0]],
        "The tapes are right. The speedometer's 3.6 stands in the column of the position.",
    ),
    "transposed": (
        [[1, 100, 0], [0, 0, 3.6]],
        "The numbers are right, but H is transposed: a row for each sensor, a column for each state, shape (3, 2).",
    ),
    "one number a sensor": (
        [1, 100, 3.6],
        "The numbers are right. Now say which state each belongs to: a row for each sensor, a column for each state, shape (3, 2).",
    ),
    "both tapes see the velocity": (
        [[1, 1], [100, 1], [0, 3.6]],
        "The speedometer is right. Both tapes see the velocity: their second entries should be 0.",
    ),
    "the second tape sees the velocity": (
        [[1, 0], [100, 1], [0, 3.6]],
        "The second tape sees the velocity: its second entry should be 0.",
    ),
    "columns exchanged": (
        [[0, 1], [0, 100], [3.6, 0]],
        "The columns have changed places: the state is [position, velocity], in this order.",
    ),
    "centimetres forgotten": (
        [[1, 0], [1, 0], [0, 3.6]],
        "The second tape reads centimetres: 1 m reads 100.",
    ),
    "no units": (
        [[1, 0], [1, 0], [0, 1]],
        "You picked the right states. But H converts units too: the second tape reads centimetres, the speedometer km/h.",
    ),
    "millimetres": (
        [[1, 0], [1000, 0], [0, 3.6]],
        "A metre has 1,000 millimetres; the second tape reads centimetres.",
    ),
    "two rows": (
        [[1, 0], [0, 3.6]],
        "There are three sensors, so H has three rows: the tape in centimetres has one of its own.",
    ),
    "three columns": (
        [[1, 0, 0], [0, 100, 0], [0, 0, 3.6]],
        "There are three sensors and two states: three rows, two columns. Both tapes ask for the same state, the position.",
    ),
    "36": (
        [[1, 0], [100, 0], [0, 36]],
        "The tapes are right. One metre per second is 3,600 m in an hour: how many kilometres?",
    ),
    "cm of the velocity": (
        [[1, 0], [0, 100], [0, 3.6]],
        "Your second tape reads the velocity. It reads the position, in centimetres: 100 stands in the first column.",
    ),
    "rows turned": (
        [[0, 3.6], [100, 0], [1, 0]],
        "The rows are right, but in another order: first the tape in metres, then the one in centimetres, then the speedometer.",
    ),
    "tapes exchanged": (
        [[100, 0], [1, 0], [0, 3.6]],
        "The two tapes have changed places: first the one in metres.",
    ),
    "speedometer with position": (
        [[1, 0], [100, 0], [1, 3.6]],
        "The tapes are right. The speedometer does not see the position: its first entry is 0.",
    ),
    "the lesson's readings": ([60, 6000, 36], READINGS),
    "an hour of sixty seconds": (
        [[1, 0], [100, 0], [0, 0.06]],
        "An hour has 3,600 s, not 60: 1 m/s is 3,600 m in an hour, which is 3.6 km/h.",
    ),
    "the identity": (
        [[1, 0], [0, 1], [0, 0]],
        "Rows two and three are wrong: the tape in centimetres reads the position, the speedometer the velocity.",
    ),
    "as in the lesson": (
        [[1, 0], [100, 0], [0, 1], [1, 0], [0, 1]],
        "These are the lesson's sensors. Three rows are wanted: tape in m, tape in cm, speedometer in km/h.",
    ),
}
