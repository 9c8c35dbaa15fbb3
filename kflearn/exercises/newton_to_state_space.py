"""Lesson 1: from Newton to the state space."""

import numpy as np

from kflearn.exercises._impossible_units import wrong_choices
from kflearn.exercises._newton_to_state_space import WRONG, first_wrong_row
from kflearn.exercises._slips_foundations import WRONG as SLIPS
from kflearn.exercises._slips_fourth import WRONG as FOURTH
from kflearn.exercises._slips_seventh_early import WRONG as SEVENTH
from kflearn.exercises._slips_start import WRONG as MORE
from kflearn.exercises._slips_tenth_early import WRONG as TENTH
from kflearn.exercises._slips_third import WRONG as THIRD
from kflearn.exercises.engine import exercise


def steps_masses_and_drags(rng):
    """A time step, a mass, a drag; none is 1, where the usual mistakes do not show, and the drag is weak."""
    dt, mass = float(rng.choice([0.25, 0.5, 2.0])), float(rng.choice([3.0, 5.0, 6.0, 10.0]))
    return dt, mass, float(rng.choice([0.3, 0.6, 0.9]))


@exercise(
    hints=[
        "Write u − c·v wherever (1) and (2) have the force. Then collect everything that is multiplied by v: what stands before v in (1), and what in (2)?",
        "(1) becomes p + (dt − c·dt²/2m)·v + dt²/2m·u. Sort (2) in the same way. The factors of p and v are the rows of F, those of u are B.",
        "`F = np.array([[1, dt - c * dt**2 / (2 * mass)], [0, 1 - c * dt / mass]])`, then `return F, np.array([[dt**2 / 2], [dt]]) / mass`",
    ],
    inputs=steps_masses_and_drags,
    wrong=WRONG["motion"] | MORE["motion"] | THIRD["motion"] | FOURTH["motion"] | TENTH["motion"],
    then="With c = 0 it is the lesson's cart. Unlike (3), this F is not exact: the drag changes during the step, so dt must be short beside m/c.",
)
def motion(dt, mass, c):
    """F and B of a cart (kg) whose input is the force (N), with a drag −c·v that is held during a step of dt seconds."""
    F = np.array([[1, dt - c * dt**2 / (2 * mass)], [0, 1 - c * dt / mass]])
    B = np.array([[dt**2 / 2], [dt]]) / mass
    return F, B


@exercise(
    hints=[
        "A row for each sensor, a column for each state: what does the sensor show for one metre, and what for one metre per second?",
        "No tape asks for the velocity, so the second column begins with two zeros. A metre is 100 cm; a metre per second is 3,600 m in an hour.",
        "Row by row: `[[1, 0], [100, 0], [0, 3.6]]`",
    ],
    wrong={
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
    }
    | THIRD["three_sensors"]
    | FOURTH["three_sensors"],
    otherwise=first_wrong_row,
    then="H can be read off without calculating: put in 1 m and 0 m/s, then 0 m and 1 m/s, and write down what each sensor shows.",
)
def three_sensors():
    """H for a tape in metres, a tape in centimetres and a speedometer in km/h; the state is [p (m), v (m/s)]."""
    return np.array([[1, 0], [100, 0], [0, 3.6]])


@exercise(
    hints=[
        "Write the unit beside every letter. A sum needs equal units, a variance the square of a unit, an entry of B the unit of what comes out over the unit of what goes in.",
        "Three of the five are impossible: one sum, one variance, one distance.",
        "A adds m to m/s. C should be in m², as R is the mean of a squared error. In E, (m/s²)·s is no distance.",
    ],
    wrong={", ".join(sorted(picked)): (picked, sentence) for picked, sentence in wrong_choices()},
    then="A adds metres to metres per second, C gives a variance in m where m² belongs, and the product in E is a velocity. No number mends a wrong unit.",
)
def impossible():
    """Which cannot be right: A reads p + v, B Q₁₂ = 0.5 m²/s, C R = 0.5 m, D B₂ = 0.5 s/kg, E the distance a·dt/2?"""
    return {"A", "C", "E"}


def matrices_and_states(rng):
    """A full matrix (2, 2) without zeros and a state."""
    entries = rng.choice([-1.5, -0.5, 0.5, 1.5, 2.0], 4).reshape(2, 2)
    return entries, rng.choice([-3.0, -2.0, 1.0, 2.0, 4.0], 2)


def one_after_the_other(F, x, order=(0, 1)):
    """F x entry by entry, each written over the old one at once."""
    x = x.copy()
    for i in order:
        x[i] = F[i, 0] * x[0] + F[i, 1] * x[1]
    return x


@exercise(
    hints=[
        "Which x[0] does the second line want: the one before the step, or the one after it? For which F does that make no difference?",
        "Keep the old state under two names of its own before anything is overwritten. For the cart it makes no difference, because its F[1, 0] is 0.",
        "`p, v = x`, then `return np.array([F[0, 0] * p + F[0, 1] * v, F[1, 0] * p + F[1, 1] * v])`",
    ],
    inputs=matrices_and_states,
    wrong={
        "as published": (
            one_after_the_other,
            "The second line still meets the new first entry. Keep the old values first (old = x is not enough: that is a second name for the same array).",
        ),
        "the other order": (
            lambda F, x: one_after_the_other(F, x, (1, 0)),
            "The line of x[0] meets the new x[1], not the old one: keep both old values first.",
        ),
        "transposed": (
            lambda F, x: F.T @ x,
            "Rows and columns are exchanged: the first entry is F[0, 0] * x[0] + F[0, 1] * x[1].",
        ),
        "diagonal only": (
            lambda F, x: np.diag(F) * x,
            "You left out F[0, 1] and F[1, 0]: each new entry is made of both old ones.",
        ),
        "entry by entry": (
            lambda F, x: F * x,
            "* multiplies entry by entry and gives a matrix. Each new entry is the sum of a row of it.",
        ),
        "only one entry mended": (
            lambda F, x: np.array([F[0] @ x, x[1]]),
            "The first entry is right. The second has not been moved at all.",
        ),
        "the same row twice": (
            lambda F, x: np.array([F[0] @ x, F[0] @ x]),
            "The first entry is right. The second takes the second row: F[1, 0] and F[1, 1].",
        ),
        "entries exchanged": (
            lambda F, x: (F @ x)[::-1],
            "Both numbers are right, but they have changed places: the first row of F gives the first entry.",
        ),
        "only the new x[0] in the first": (
            lambda F, x: np.array([x[0], F[1] @ x]),
            "The second entry is right. The first has not been moved at all.",
        ),
        "columns": (
            lambda F, x: np.array([(F[0, 0] + F[0, 1]) * x[0], (F[1, 0] + F[1, 1]) * x[1]]),
            "Each entry of F meets its own number: F[0, 1] belongs to x[1], and F[1, 0] to x[0].",
        ),
        "second without F[1, 0]": (
            lambda F, x: np.array([F[0] @ x, F[1, 1] * x[1]]),
            "The first entry is right. The second lacks F[1, 0] times x[0].",
        ),
        "first without F[0, 1]": (
            lambda F, x: np.array([F[0, 0] * x[0], F[1] @ x]),
            "The second entry is right. The first lacks F[0, 1] times x[1].",
        ),
        "F[0, 1] for F[1, 0]": (
            lambda F, x: np.array([F[0] @ x, F[0, 1] * x[0] + F[1, 1] * x[1]]),
            "The first entry is right. The second uses the second row of F: F[1, 0], not F[0, 1].",
        ),
        "a column": (
            lambda F, x: (F @ x)[:, None],
            "The numbers are right, but you return a column, of shape (2, 1). The state is flat: two numbers.",
        ),
        "only the second": (
            lambda F, x: F[1] @ x,
            "You return the second entry only. Return both, as an array of two numbers.",
        ),
        "unchanged": (lambda F, x: x, "You return the old state. Where are the new entries?"),
    }
    | THIRD["overwritten"]
    | SEVENTH["overwritten"]
    | TENTH["overwritten"],
    then="For the cart F[1, 0] is 0, so its second line does not contain x[0] at all. And `F @ x` calculates the whole new vector before anything is overwritten.",
    fixed={
        "F": "the published program steps a state of two numbers, entry by entry, and so does the answer",
        "x": "the published program steps a state of two numbers, entry by entry, and so does the answer",
    },
)
def overwritten(F, x):
    """F x entry by entry, which a published program gets wrong by overwriting x[0] too early."""
    first = F[0, 0] * x[0] + F[0, 1] * x[1]
    second = F[1, 0] * x[0] + F[1, 1] * x[1]
    return np.array([first, second])


def steps_and_sigmas(rng):
    """A time step and the standard deviation of an acceleration, neither of them 1."""
    return float(rng.choice([0.5, 2.0, 3.0, 4.0])), float(rng.choice([0.2, 1.5, 2.5, 3.0]))


@exercise(
    hints=[
        "Write units beside G = [T/2; 1]: G times m/s² should be metres above and metres per second below.",
        "What does an acceleration a, held for T seconds, add to the position, what to the velocity? See (1) and (2).",
        "`G = np.array([[T**2 / 2], [T]])`, and Q as before: `return sigma**2 * G @ G.T`",
    ],
    inputs=steps_and_sigmas,
    wrong=WRONG["held_push"] | SLIPS["held_push"] | MORE["held_push"],
    then="At T = 1 s the published G is right, and its program had T = 2 s. Try a formula with a step that is not 1.",
)
def held_push(T, sigma):
    """Q for an unknown acceleration of standard deviation sigma held for T, published with G = [T/2; 1]."""
    G = np.array([[T**2 / 2], [T]])
    return sigma**2 * G @ G.T
