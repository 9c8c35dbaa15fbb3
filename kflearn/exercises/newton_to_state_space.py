"""Lesson 1: from Newton to the state space."""

import numpy as np

from kflearn.exercises._slips import newton_to_state_space as slips
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
    wrong=slips.motion.WRONG,
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
    wrong=slips.three_sensors.WRONG,
    otherwise=slips.three_sensors.first_wrong_row,
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
    wrong=slips.impossible.WRONG,
    then="A adds metres to metres per second, C gives a variance in m where m² belongs, and the product in E is a velocity. No number mends a wrong unit.",
)
def impossible():
    """Which cannot be right: A reads p + v, B Q₁₂ = 0.5 m²/s, C R = 0.5 m, D B₂ = 0.5 s/kg, E the distance a·dt/2?"""
    return {"A", "C", "E"}


def matrices_and_states(rng):
    """A full matrix (2, 2) without zeros and a state."""
    entries = rng.choice([-1.5, -0.5, 0.5, 1.5, 2.0], 4).reshape(2, 2)
    return entries, rng.choice([-3.0, -2.0, 1.0, 2.0, 4.0], 2)


@exercise(
    hints=[
        "Which x[0] does the second line want: the one before the step, or the one after it? For which F does that make no difference?",
        "Keep the old state under two names of its own before anything is overwritten. For the cart it makes no difference, because its F[1, 0] is 0.",
        "`p, v = x`, then `return np.array([F[0, 0] * p + F[0, 1] * v, F[1, 0] * p + F[1, 1] * v])`",
    ],
    inputs=matrices_and_states,
    wrong=slips.overwritten.WRONG,
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
    wrong=slips.held_push.WRONG,
    then="At T = 1 s the published G is right, and its program had T = 2 s. Try a formula with a step that is not 1.",
)
def held_push(T, sigma):
    """Q for an unknown acceleration of standard deviation sigma held for T, published with G = [T/2; 1]."""
    G = np.array([[T**2 / 2], [T]])
    return sigma**2 * G @ G.T
