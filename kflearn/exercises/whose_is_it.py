"""Lesson 26: whose is it?"""

import numpy as np

from kflearn import Gaussian, boats, pda_filter
from kflearn.exercises._a_boat import FAILING, PASSING, lost_share, not_exact, places, recording, typical
from kflearn.exercises._a_boat_signs import SIGNS
from kflearn.exercises._slips import whose_is_it as slips
from kflearn.exercises._turns import in_turn
from kflearn.exercises.engine import Mark, exercise, judged


@exercise(
    hints=[
        "First the area of the gate: π times the limit times the square root of the determinant of S.",
        "The determinant of S is 36 · 25, so its root is 30 m². The area is π · 9.21 · 30.",
        "`np.pi * 9.21 * np.sqrt(36 * 25) * 0.0005`",
    ],
    wrong=slips.false_in_gate.WRONG,
    otherwise=slips.false_in_gate.area_of,
    then="With a Poisson number of mean 0.43 a scan has no false reading in the gate in 65 of 100 cases, e^−0.43. In the "
    "other 35 a tracker can go wrong.",
)
def false_in_gate():
    """How many false readings are in the gate on average, with S = diag(36, 25) m², limit 9.21 and λ = 0.0005 per m²?"""
    return np.pi * 9.21 * np.sqrt(36 * 25) * 0.0005


AWAY = [
    0.2,
    -0.7,
    1.171,
    0.45,
    -1.09,
    0.9,
    1.09,
    2.5,
]  # how far a reading is, in half widths of the gate; 1.171² · 6.635 = 9.1


def scans(rng, N):
    """N readings on a line, inside the gate and outside, a prediction, its S and the sensor."""
    expected, S = float(rng.integers(20, 80)), float(rng.integers(4, 30))
    away = rng.permutation(AWAY)[:N] if N > 1 else np.array([0.3])
    z = np.round(expected + away * np.sqrt(6.635 * S) * rng.choice([-1, 1]), 2)
    return z, expected, S, float(rng.integers(10, 20) / 20), float(rng.integers(2, 30) / 200)


@exercise(
    hints=[
        "First the NIS of each reading, (z − expected)²/S. Then e^(−NIS/2) where it is at most 6.635, else 0. What is b on a line?",
        "b = λ √(2πS) (1 − 0.99 P_D)/P_D: with one component the Gaussian's height is 1/√(2πS). It comes first; then divide all by their sum.",
        "`nis = (z - expected)**2 / S`, `b = clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * detection) / detection`, "
        "`e = np.append(b, np.where(nis <= 6.635, np.exp(-nis / 2), 0))`, and `return e / e.sum()`",
    ],
    inputs=in_turn(scans, 1, 4, 2, 7),
    wrong=slips.weights.WRONG,
    then="Where no reading is in the gate the first weight is 1: the filter predicts and does not correct.",
    rtol=1e-4,  # with 6.2832 for 2π
)
def weights(z, expected, S, detection, clutter):
    """The PDA weights on a line, (N + 1,): of "none of them", then of each reading z (N,), 0 outside the gate (P_G = 0.99)."""
    nis = (z - expected) ** 2 / S
    b = clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * detection) / detection
    e = np.append(b, np.where(nis <= 6.635, np.exp(-nis / 2), 0))
    return e / e.sum()


@exercise(
    hints=[
        "Write down the matrix as the program has it: the two dashes are 0. What is the smallest sum of two entries, one from each row, in different columns?",
        "A zero is cheaper than every real NIS. There is one in each row, and they are in different columns.",
        "The dash of track A is at reading 2, that of track B at reading 3: the sum is 0. `[2, 3]`",
    ],
    wrong=slips.zeros.WRONG,
    otherwise=slips.zeros.readings_of,
    rtol=1e-9,
    then="Both tracks get a reading that the gate had refused. Forbidden pairs must be infinite, or so large that no sum of real ones comes near.",
)
def zeros():
    """Which readings do tracks A and B get, if 0 stands for "outside the gate"? [reading of A, reading of B]"""
    return [2, 3]


@judged(
    hints=[
        "The lesson has all the parts: a model of the boat, a belief about the start, and a filter for scans.",
        "A boat turns more in some recordings than in others. A filter with a small Q loses those that turn, and a large Q makes the gate large. Try a σ of the acceleration between 0.3 and 1 m/s².",
        "Start with `Gaussian(start, np.diag([25, 1, 25, 1]))` and return `pda_filter(plane, z, belief, detection=0.9, "
        "clutter=clutter).mean[:, [0, 2]]`, where `plane` is the lesson's model.",
    ],
    recording=recording,
    marks=[
        Mark(
            "recordings whose boat is lost at the end (more than 40 m away)",
            lost_share,
            high=20,
            above="Is each reading in the gate weighed, is the gate wide enough (0.99), and Q large enough for a boat that turns? Are x and y numbers 0 and 2 of the state, in H too?",
            unit="%",
        ),
        Mark(
            "error in the middle recording (rms)",
            typical,
            high=8,
            above=not_exact,
            unit="m",
        ),
    ],
    form=places,
    passing=PASSING,
    failing=FAILING,
    signs=SIGNS,
    then="A filter that is told which reading is the boat's has 4.5 m in the middle recording, and loses none. The rest is what the false readings cost.",
)
def boat(z, start, clutter):
    """Write a tracker `(z, start, clutter) → positions` that stays with one boat among false readings.

    z (60, N, 2): sixty scans, one a second, of at most N readings in m, x and y; rows of NaN at the end of a scan are no
    readings. start (4,): x, v_x, y, v_y one step before the first scan, with errors of 5 m and 1 m/s (σ). clutter: λ,
    the mean number of false readings per m². P_D is 0.9, and σ of a reading is 5 m in x and in y. Return positions (60, 2).
    """
    belief = Gaussian(start, np.diag([25, 1, 25, 1]))
    return pda_filter(boats.plane(), z, belief, detection=0.9, clutter=clutter).mean[:, [0, 2]]
