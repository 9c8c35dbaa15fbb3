"""Lesson 20: through a tunnel."""

import math

import numpy as np

from kflearn.exercises._slips import error_state_navigation as slips
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "What does the sensor show too much while the tram pulls, and what while it brakes? The filter subtracts the first all the time.",
        "The 6 % of the true acceleration change their sign with it. Which acceleration is left over when the filter subtracts too much?",
        "0.1 + 0.03 is learnt, 0.1 − 0.03 is needed: 0.06 m/s² too much is subtracted. Over 30 s that makes b·t²/2.",
    ],
    wrong=slips.all_bias.WRONG,
    otherwise=slips.all_bias.acceleration_of,
    unit="m",
    also=[-27],  # with its sign
    then=(
        "The filter was perfect as long as the tram pulled: an error with the wrong name shows only when the ride "
        "changes. A state for the scale, and a ride that pulls and brakes, would tell the two apart."
    ),
)
def all_bias():
    """How far off (m) is a filter after 30 s of braking with −0.5 m/s², if it took 0.1 + 6 % of 0.5 m/s² for a bias?"""
    learnt, needed = 0.1 + 0.06 * 0.5, 0.1 - 0.06 * 0.5
    return (learnt - needed) * 30**2 / 2


def tunnel_mouths(rng):
    """A speed error (m/s), a bias (m/s²) and an allowed error (m)."""
    return float(rng.integers(1, 9)) / 4, float(rng.integers(1, 20)) / 100, float(rng.integers(3, 40))


@exercise(
    hints=[
        "A speed that is wrong by dv makes dv·t metres, a bias b makes b·t²/2. Both pull the same way, so they add.",
        "Solve b t²/2 + dv t − allowed = 0 for t, and take the root that lies in the future.",
        "`return (-dv + np.sqrt(dv**2 + 2 * b * allowed)) / b`",
    ],
    inputs=tunnel_mouths,
    wrong=slips.dark_time.WRONG,
    then=(
        "At t = 2 dv/b both have made the same number of metres: before that the speed error is the larger part, "
        "afterwards the bias."
    ),
)
def dark_time(dv, b, allowed):
    """After how many seconds do a speed error dv and a bias b, pulling the same way, make `allowed` metres?"""
    return (-dv + math.sqrt(dv**2 + 2 * b * allowed)) / b


@exercise(
    hints=[
        "Write down F, the slopes of the five expressions: which states stand in its entries?",
        "The slope of east with respect to ψ is −(1 + s)·d·sin ψ, with respect to s it is d·cos ψ. In ψ + w − b every slope is 1 or −1.",
        "The entries of F hold ψ and s, nothing else: `[0, 0, 1, 0, 1]`.",
    ],
    wrong=slips.goes_back.WRONG,
    then=(
        "Only ψ and s stand in F, and H is constant. A state on which neither depends may be wrong in the INS: F moves "
        "its error in the same way, fed back or not, and H measures it in the same way."
    ),
)
def goes_back():
    """1 for each of [east, north, ψ, b, s] that must be fed back for the closed loop's answer, 0 for the others."""
    return np.array([0, 0, 1, 0, 1])


def fixes(rng):
    """An INS state of three, four or six, its error state, a gain and a fix."""
    n = int(rng.choice([4, 6, 3]))
    x, dx = rng.integers(-20, 20, n) / 2, rng.integers(1, 9, n) / 4
    return x, dx, rng.integers(1, 9, (n, 2)) / 10, x[:2] + rng.integers(1, 9, 2) / 2 + dx[:2]


@exercise(
    hints=[
        "The line for dx is right. What is missing comes after it: the INS must be corrected too.",
        "First correct dx as published. Then add it to x. And what is left of the error that x has lost?",
        "`dx = dx + K @ (fix - x[:2] - dx[:2])`, then `return x + dx, 0 * dx`.",
    ],
    inputs=fixes,
    fixed={"fix": "a fix is always east and north"},
    wrong=slips.mended_fix.WRONG,
    then="As dx is zero now, F @ dx stays zero until the next fix: between two fixes only P must be predicted.",
)
def mended_fix(x, dx, K, fix):
    """The INS's state and the error state after a fix, with feedback."""
    dx = dx + K @ (fix - x[:2] - dx[:2])
    return x + dx, 0 * dx
