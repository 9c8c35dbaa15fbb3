"""Lesson 1, `motion`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips.newton_to_state_space.shared import column
from kflearn.exercises._slips.shared import table


def moving(dt):
    """F of a cart."""
    return np.array([[1.0, dt], [0.0, 1.0]])


def push(dt, mass):
    """B of a cart."""
    return column(dt**2 / 2, dt) / mass


def dragged(dt, less_far, slower):
    """F of a cart that goes less far, and is slower, by so much of its velocity."""
    return np.array([[1.0, dt - less_far], [0.0, 1.0 - slower]])


def decaying(dt, mass, c):
    """F for a drag that follows the velocity at every instant."""
    left = np.exp(-c * dt / mass)
    return np.array([[1.0, mass / c * (1 - left)], [0.0, left]])


def held_drag(dt, mass, c):
    """The right F of a cart with drag."""
    return dragged(dt, c * dt**2 / (2 * mass), c * dt / mass)


NO_DT = "Your B is right, and so is the first row of F. In the second row the drag lacks dt: it acts for dt seconds."

TWO_ROWS = "In the first rows of F and B stands dt/2m. By (1) the distance needs dt²/2m: check the units."

BRACKETS = "the mass multiplies, as in `/ 2 * mass`, where Python divides by 2 only: write / (2 * mass)."


def half(dt, mass):
    return dt**2 / (2 * mass)


def motion(first, second, dt_F=True, dt_B=True):
    """F and B; in one of them, or in both, the distance is divided by 2 and multiplied by the mass."""
    return lambda dt, mass, c: (
        dragged(dt, c * (first if dt_F else second)(dt, mass), c * dt / mass),
        column((first if dt_B else second)(dt, mass), dt / mass),
    )


def slip(dt, mass):
    return dt**2 / 2 * mass


def implicit(dt, mass, c):
    """The cart whose drag is that of the new velocity."""
    kept = 1 / (1 + c * dt / mass)
    F = np.array([[1, dt * (1 + kept) / 2], [0, kept]])
    return F, np.array([[dt**2 / 2], [dt]]) * kept / mass


def without_dt(dt, mass, c):
    F = np.array([[1, dt - c / (2 * mass)], [0, 1 - c / mass]])
    return F, np.array([[dt**2 / 2], [dt]]) / mass


WRONG = {
    "no drag": (
        lambda dt, mass, c: (moving(dt), push(dt, mass)),
        "B is right. Your F is that of the cart without drag. The force −c·v depends on the velocity, so it belongs to F.",
    ),
    "no half in the first rows": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / mass, c * dt / mass), column(dt**2, dt) / mass),
        "The second rows are right. In the first row of F and in that of B the ½ is missing: a force that acts for dt seconds "
        "moves the cart by ½·F/m·dt², as in (1).",
    ),
    "drag that follows the velocity": (
        lambda dt, mass, c: (
            decaying(dt, mass, c),
            column(dt - decaying(dt, mass, c)[0, 1], 1 - decaying(dt, mass, c)[1, 1]) / c,
        ),
        "You solved the differential equation, in which the drag follows the velocity at every instant. Here it is held during "
        "a step at −c·v with the v of the beginning, as the text says: put u − c·v into (1) and (2).",
    ),
    "drag in the velocity only": (
        lambda dt, mass, c: (dragged(dt, 0.0, c * dt / mass), push(dt, mass)),
        "B is right, and so is the second row of F. In the first row the drag is missing: it acts during the whole step, like u in (1).",
    ),
    "drag in the position only": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), 0.0), push(dt, mass)),
        "B is right, and so is the first row of F. In the second row the drag is missing: it makes the cart slower, as in (2).",
    ),
    "one half forgotten": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / mass, c * dt / mass), push(dt, mass)),
        "B is right, and so is the second row of F. In the first row the ½ of (1) is missing before the drag.",
    ),
    "one half below too": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), c * dt / (2 * mass)), push(dt, mass)),
        "B is right, and so is the first row of F. In the second row there is no ½: the velocity gets all of the force's F/m·dt.",
    ),
    "plus": (
        lambda dt, mass, c: (dragged(dt, -c * dt**2 / (2 * mass), -c * dt / mass), push(dt, mass)),
        "B is right. Your drag pushes the cart forwards: the force is −c·v, with a minus.",
    ),
    "mass forgotten in the drag": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / 2, c * dt), push(dt, mass)),
        "B is right. In F the drag is not divided by the mass yet: c·v is a force, and a force changes the velocity by F/m.",
    ),
    "dt forgotten in the drag": (
        lambda dt, mass, c: (dragged(dt, c * dt / (2 * mass), c / mass), push(dt, mass)),
        "B is right. In F the drag lacks a factor dt in both rows: it acts for dt seconds.",
    ),
    "a spring": (
        lambda dt, mass, c: (np.array([[1 - c * dt**2 / (2 * mass), dt], [-c * dt / mass, 1.0]]), push(dt, mass)),
        "B is right. In your F the force depends on the position: that is a spring. A drag depends on the velocity, so it belongs to the second column of F.",
    ),
    "minus c alone": (
        lambda dt, mass, c: (np.array([[1, dt - c * dt**2 / (2 * mass)], [0, -c * dt / mass]]), push(dt, mass)),
        "B is right, and so is the first row of F. The second row has lost the old velocity: v stays, less c·dt/m of it.",
    ),
    "first row without dt": (
        lambda dt, mass, c: (
            np.array([[1, -c * dt**2 / (2 * mass)], [0, 1 - c * dt / mass]]),
            push(dt, mass),
        ),
        "B is right, and so is the second row of F. The first row has lost v·dt, the distance without any force.",
    ),
    "exact": (
        lambda dt, mass, c: (decaying(dt, mass, c), push(dt, mass)),
        "That F is exact for a drag which follows the velocity at every instant. Here the drag is held during the step, so F has no exponential.",
    ),
    "exact velocity": (
        lambda dt, mass, c: (
            np.array([[1, dt - c * dt**2 / (2 * mass)], [0, np.exp(-c * dt / mass)]]),
            push(dt, mass),
        ),
        "B is right, and so is the first row of F. The drag is held during the step: the velocity falls by c·dt/m of itself, without an exponential.",
    ),
    "drag in B": (
        lambda dt, mass, c: (moving(dt), (1 - c) * push(dt, mass)),
        "The drag is no part of the input: it depends on v, and v is part of the state. It belongs to F.",
    ),
    "B braked": (
        lambda dt, mass, c: (held_drag(dt, mass, c), (1 - c * dt / mass) * push(dt, mass)),
        "F is right. B has the factors of u alone, and in u − c·v the force u stands undiminished: B is that of the lesson.",
    ),
    "no push on the position": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(0.0, dt / mass)),
        "F is right. Your force acts on the velocity only; during the step the new velocity already moves the cart: dt²/2m on top.",
    ),
    "[dt/2, 1]": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt / 2, 1.0) / mass),
        "F is right. Your B lacks a factor dt in both entries: it is right at dt = 1 only.",
    ),
    "one half forgotten in B": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2, dt) / mass),
        "F is right. The mean velocity of the step lies halfway: the first entry of B is dt²/2m.",
    ),
    "dt/2 above": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt / 2, dt) / mass),
        "F is right. The first entry of B must turn newtons into metres, dt²/2m: yours lacks a factor dt.",
    ),
    "mass forgotten": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2 / 2, dt)),
        "F is right. Your B takes an acceleration; the input is a force, so divide by the mass.",
    ),
    "mass forgotten in both": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / 2, c * dt), column(dt**2 / 2, dt)),
        "The mass is missing, in F and in B: u and c·v are forces, and a force changes the velocity by F/m.",
    ),
    "mass under one entry": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2 / (2 * mass), dt)),
        "F is right, and so is the first entry of B. The second turns newtons into m/s: divide by the mass there too.",
    ),
    "mass under the second": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt**2 / 2, dt / mass)),
        "F is right, and so is the second entry of B. The first turns newtons into metres: divide by the mass there too.",
    ),
    "B upside down": (
        lambda dt, mass, c: (held_drag(dt, mass, c), column(dt, dt**2 / 2) / mass),
        "F is right. The entries of B have changed places: the state is [position, velocity], in this order.",
    ),
    "F transposed": (
        lambda dt, mass, c: (held_drag(dt, mass, c).T, push(dt, mass)),
        "B is right. Your F is transposed: its first row makes the new position, so the factor of v stands at the upper right.",
    ),
    "everything at dt = 1": (
        lambda dt, mass, c: (held_drag(1.0, mass, c), push(1.0, mass)),
        "That is right at dt = 1 only. Your function gets dt as an argument: use it, in F and in B.",
    ),
    "a flat B": (
        lambda dt, mass, c: (held_drag(dt, mass, c), push(dt, mass).ravel()),
        "The numbers are right. But your B is flat, of shape (2,): a row for each state, a column for each input, shape (2, 1).",
    ),
    "B in a row": (
        lambda dt, mass, c: (held_drag(dt, mass, c), push(dt, mass).T),
        "The numbers are right. But your B is a row: a row for each state, a column for each input, shape (2, 1).",
    ),
    "the order of the pair": (
        lambda dt, mass, c: (push(dt, mass), held_drag(dt, mass, c)),
        "Both are right, in the wrong order: return F first, then B.",
    ),
    "F alone": (
        lambda dt, mass, c: held_drag(dt, mass, c),
        "Your F is right. B is wanted as well: return both, F first.",
    ),
    "no drag, no mass": (
        lambda dt, mass, c: (moving(dt), column(dt**2 / 2, dt)),
        "Two things: the drag is missing in F, and B is not divided by the mass.",
    ),
    "velocity braked by the position": (
        lambda dt, mass, c: (table(1, dt, -c * dt / mass, 1.0), push(dt, mass)),
        "B is right. In F the drag stands in the column of the position. It depends on the velocity, so it belongs to the second column, in both rows.",
    ),
    "no dt anywhere": (
        lambda dt, mass, c: (dragged(dt, c * dt / (2 * mass), c / mass), column(dt / 2, 1.0) / mass),
        "In F and in B a factor dt is missing, in both rows: a force that acts for dt seconds changes the velocity by F/m·dt.",
    ),
    "no dt below": (lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), c / mass), push(dt, mass)), NO_DT),
    "one dt above": (
        lambda dt, mass, c: (dragged(dt, c * dt / (2 * mass), c * dt / mass), push(dt, mass)),
        "B is right, and so is the second row of F. In the first row the drag needs dt², as the force does in (1).",
    ),
    "one dt above, no half": (
        lambda dt, mass, c: (dragged(dt, c * dt / mass, c * dt / mass), push(dt, mass)),
        "B is right, and so is the second row of F. In the first row the drag needs ½·dt², as the force does in (1).",
    ),
    "plus below": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), -c * dt / mass), push(dt, mass)),
        "B is right, and so is the first row of F. In the second row the drag has the wrong sign: it brakes.",
    ),
    "plus above": (
        lambda dt, mass, c: (dragged(dt, -c * dt**2 / (2 * mass), c * dt / mass), push(dt, mass)),
        "B is right, and so is the second row of F. In the first row the drag has the wrong sign: it brakes.",
    ),
    "no mass below": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / (2 * mass), c * dt), push(dt, mass)),
        "B is right, and so is the first row of F. In the second row the drag is not divided by the mass.",
    ),
    "no mass above": (
        lambda dt, mass, c: (dragged(dt, c * dt**2 / 2, c * dt / mass), push(dt, mass)),
        "B is right, and so is the second row of F. In the first row the drag is not divided by the mass.",
    ),
    "drag alone": (
        lambda dt, mass, c: (table(1, dt, 0.0, c * dt / mass), push(dt, mass)),
        "B is right. The second row of F should keep the old velocity, less the part c·dt/m; and in the first row the drag is missing.",
    ),
    "no drag, B transposed": (
        lambda dt, mass, c: (held_drag(dt, mass, c), push(dt, mass) * mass**2),
        "F is right. You multiplied B by the mass: a force makes a heavy cart move less, so divide by it.",
    ),
    "dt/2m in the first rows": (
        lambda dt, mass, c: (
            dragged(dt, c * dt / (2 * mass), c * dt / mass),
            column(dt / (2 * mass), dt / mass),
        ),
        TWO_ROWS,
    ),
    "/ 2 * mass": (motion(slip, half), f"In the first rows of F and B {BRACKETS}"),
    "/ 2 * mass in F": (motion(slip, half, dt_B=False), f"B is right. In the first row of F {BRACKETS}"),
    "/ 2 * mass in B": (motion(slip, half, dt_F=False), f"F is right. In the first row of B {BRACKETS}"),
    "1 − c in B": (
        lambda dt, mass, c: (
            dragged(dt, c * half(dt, mass), c * dt / mass),
            (1 - c) * column(half(dt, mass), dt / mass),
        ),
        "F is right. B belongs to the push u alone: the drag depends on v and stands in F already, so c does not occur in B.",
    ),
    "drag of the new velocity": (
        implicit,
        "In your F the part 1/(1 + c·dt/m) of v is left, as if the drag belonged to the new velocity. It stays "
        "what it is at the step's beginning: −c·v with the old v.",
    ),
    "no dt in either row": (
        without_dt,
        "B is right. In F the drag is right at dt = 1 only: it needs dt² in the first row, as the force does in "
        "(1), and dt in the second.",
    ),
}
