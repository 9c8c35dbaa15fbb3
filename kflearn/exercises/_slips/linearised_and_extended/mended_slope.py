"""Lesson 13, `mended_slope`: wrong answers, each with the sentence that it gets."""

import numpy as np


def measured(x, step=1e-3):
    """The Jacobian by the lesson's central difference."""

    def radar(x):
        r = np.hypot(x[0], x[2])
        return np.array([r, (x[0] * x[1] + x[2] * x[3]) / r])

    return np.stack([(radar(x + e) - radar(x - e)) / (2 * step) for e in step * np.eye(4)], axis=-1)


def radar_slope(x, sign=-1, power=3, other=1):
    """The Jacobian of distance and its rate, with the entries of the second row open to mistakes."""
    r = np.hypot(x[0], x[2])
    turn = x[2] * x[1] - x[0] * x[3]
    bent = other * x[2] * turn / r**power, sign * x[0] * turn / r**power
    return np.array([[x[0] / r, 0, x[2] / r, 0], [bent[0], x[0] / r, bent[1], x[2] / r]])


def numerator_only(x):
    """The entry of the column of y, as if r in the numerator's quotient did not depend on y."""
    J = radar_slope(x)
    J[1, 2] = x[3] / np.hypot(x[0], x[2])
    return J


def without(x, row, column):
    """The right Jacobian with one entry zero."""
    J = radar_slope(x)
    J[row, column] = 0
    return J


SPEEDS = "You changed the slopes for the speeds, which were right: along vx the slope is x/r, along vy it is y/r."


def slopes(x, changes):
    """The Jacobian of distance and its rate, with another second row."""
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] - x[0] * x[3]
    return np.array([[x[0] / r, 0, x[2] / r, 0], changes(x, r, turn)])


def turned_slope(x):
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] + x[0] * x[3]
    changes = [x[2] * turn / r**3, x[0] / r, -x[0] * turn / r**3, x[2] / r]
    return np.array([[x[0] / r, 0, x[2] / r, 0], changes])


def speeds_exchanged(x):
    """The claimed slope, with the slopes for the speeds exchanged as well."""
    slope = radar_slope(x)
    slope[1] = slope[1, [0, 3, 2, 1]] * [1, 1, -1, 1]
    return slope


def exchanged(x):
    """The Jacobian of a radar with x and y exchanged in the two long entries."""
    r, turn = np.hypot(x[0], x[2]), x[2] * x[1] - x[0] * x[3]
    changes = [x[0] * turn / r**3, x[0] / r, -x[2] * turn / r**3, x[2] / r]
    return np.array([[x[0] / r, 0, x[2] / r, 0], changes])


WRONG = {
    f"measured with a step of {step}": (
        lambda x, step=step: measured(x, step),
        "That is a central difference, right to some digits only. It is good enough to find the slip. Now write the formula.",
    )
    for step in (1e-2, 1e-4, 1e-5, 1e-6, 1.0)
} | {
    "numerator only": (
        numerator_only,
        "In the column of y you differentiated the numerator alone: that gives vy/r. The r below depends on y as well.",
    ),
    "third entry left out": (
        lambda x: without(x, 0, 2),
        "The second row is right. In the first, the slope of the distance along y, y/r, was right too, and you made it zero.",
    ),
    "measured": (
        measured,
        "That is the central difference. It is right to nine or ten digits, which is enough to find the slip. Now write the formula.",
    ),
    "as claimed": (
        lambda x: radar_slope(x, sign=1),
        "That is the claimed Jacobian again. Take its difference from `jacobian(radar, x)`: one entry is not near zero.",
    ),
    "the neighbour": (
        lambda x: radar_slope(x, sign=1, other=-1),
        "You turned the sign in column 0, which was right; the wrong entry is the other one that holds `turn`.",
    ),
    "both": (
        lambda x: radar_slope(x, other=-1),
        "Both signs are turned: one was wrong and is mended, the other was right and is now wrong.",
    ),
    "power two": (
        lambda x: radar_slope(x, power=2),
        "The sign is right now, but the third power of the distance was right too: leave it.",
    ),
    "transposed": (
        lambda x: radar_slope(x).T,
        "The numbers are right, but turned on their side: one row a measurement, one column a state.",
    ),
    "negative": (
        lambda x: -radar_slope(x),
        "Every sign is turned: that is the slope of −h. Did you take h(x − step) − h(x + step)?",
    ),
    "double": (
        lambda x: 2 * radar_slope(x),
        "All is twice too large. (A central difference is divided by 2·step.)",
    ),
    "entry zero": (
        lambda x: radar_slope(x, sign=0),
        "That the entry is wrong is no reason to strike it out: the rate does depend on y. Mend it.",
    ),
    "first row only": (
        lambda x: radar_slope(x)[:1],
        "The radar measures two things, so H has two rows: distance, and its rate.",
    ),
    "power two, sign as claimed": (
        lambda x: radar_slope(x, sign=1, power=2),
        "The third power of the distance was right, and the wrong sign is still there: compare entry by entry with `jacobian(radar, x)`.",
    ),
    "power one": (
        lambda x: radar_slope(x, power=1),
        "The sign is right now. But the changes with the place have r³ below; you left only r.",
    ),
    "sign of the last entry": (
        lambda x: radar_slope(x, sign=1) * np.array([[1, 1, 1, 1], [1, 1, 1, -1]]),
        "You turned the sign of the last entry, y/r, which was right. Compare entry by entry with `jacobian(radar, x)`.",
    ),
    "sign of x/r": (
        lambda x: radar_slope(x, sign=1) * np.array([[1, 1, 1, 1], [1, -1, 1, 1]]),
        "You turned the sign of x/r in the second row, which was right. Compare entry by entry with `jacobian(radar, x)`.",
    ),
    "sign in the first row": (
        lambda x: radar_slope(x, sign=1) * np.array([[1, 1, -1, 1], [1, 1, 1, 1]]),
        "You changed the first row, the slope of the distance. It was right; look in the second.",
    ),
    "second row only": (
        lambda x: radar_slope(x)[1],
        "That is the second row alone. The radar measures two things, so two rows are wanted.",
    ),
    "entries exchanged": (
        lambda x: radar_slope(x, sign=1)[:, [2, 1, 0, 3]] * [[0], [1]] + radar_slope(x) * [[1], [0]],
        "You exchanged the two entries that hold `turn`. Each stands in its place; one of them has the wrong sign.",
    ),
    "power two in the third": (
        lambda x: np.vstack([radar_slope(x)[0], [*radar_slope(x)[1, :2], *radar_slope(x, power=2)[1, 2:]]]),
        "The sign is right now, but in this entry you left r²: the third power of the distance was right.",
    ),
    "speeds exchanged": (
        lambda x: np.vstack([radar_slope(x)[0], radar_slope(x)[1, [0, 3, 2, 1]]]),
        "The sign is mended. But the slopes for the two speeds, x/r and y/r, have changed places.",
    ),
    "north for east": (
        lambda x: np.vstack(
            [radar_slope(x)[0], [*radar_slope(x)[1, :2], -radar_slope(x)[1, 0], x[2] / np.hypot(x[0], x[2])]]
        ),
        "The sign is right now, but the entry in the column of y holds x[0] times `turn`, and you put x[2] there.",
    ),
    "first row negative": (
        lambda x: radar_slope(x) * [[-1], [1]],
        "The second row is right. In the first, the slope of the distance, you turned the signs: it was right.",
    ),
    "the difference": (
        lambda x: radar_slope(x) - radar_slope(x, sign=1),
        "That is the difference of the two. It shows where the fault is; return the right Jacobian itself.",
    ),
    "speeds over r": (
        lambda x: slopes(x, lambda x, r, turn: [x[2] * turn / r**3, x[1] / r, -x[0] * turn / r**3, x[3] / r]),
        SPEEDS,
    ),
    "speeds over r, as claimed": (
        lambda x: slopes(x, lambda x, r, turn: [x[2] * turn / r**3, x[1] / r, x[0] * turn / r**3, x[3] / r]),
        SPEEDS,
    ),
    "r constant": (
        lambda x: slopes(x, lambda x, r, turn: [x[1] / r, x[0] / r, x[3] / r, x[2] / r]),
        "The distance r depends on the place too. The quotient rule gives a second term: minus x·(x·vx + y·vy)/r³, and the same with y.",
    ),
    "turn with a plus": (
        turned_slope,
        "The signs of the entries are right. But `turn` was right before: y·vx minus x·vy.",
    ),
    "speeds exchanged, sign as claimed": (
        speeds_exchanged,
        "The slopes for the two speeds, x/r and y/r, have changed places, and they were right. The wrong sign is still "
        "there: it is in one of the two entries with `turn`.",
    ),
    "exchanged": (
        exchanged,
        "Two entries of the second row are wrong: x and y are exchanged in [1, 0] and [1, 2]. Compare with `jacobian(radar, x)`.",
    ),
}
