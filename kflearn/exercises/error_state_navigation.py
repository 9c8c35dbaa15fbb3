"""Lesson 20: through a tunnel."""

import math

import numpy as np

from kflearn.exercises import _slips_fifth_late_facts as facts
from kflearn.exercises._error_state_navigation import MORE
from kflearn.exercises._slips_fifth_late import WRONG as FIFTH
from kflearn.exercises._slips_fourth_later import WRONG as FOURTH
from kflearn.exercises._slips_more import WRONG as NEW
from kflearn.exercises._slips_seventh_late import WRONG as SEVENTH
from kflearn.exercises._slips_tenth_late import WRONG as TENTH
from kflearn.exercises._slips_third_data import WRONG as THIRD
from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "What does the sensor show too much while the tram pulls, and what while it brakes? The filter subtracts the first all the time.",
        "The 6 % of the true acceleration change their sign with it. Which acceleration is left over when the filter subtracts too much?",
        "0.1 + 0.03 is learnt, 0.1 − 0.03 is needed: 0.06 m/s² too much is subtracted. Over 30 s that makes b·t²/2.",
    ],
    wrong={
        "the scale once": (
            lambda: 0.03 * 30**2 / 2,
            "13.5 m is what 0.03 m/s² makes, the scale error once. It is learnt with a plus sign and met with a minus: the difference is twice 0.03.",
        ),
        "all of it": (
            lambda: 0.13 * 30**2 / 2,
            "That is what the INS alone would make of 0.13 m/s². The filter subtracts something; how much too much?",
        ),
        "bias and braking": (
            lambda: 0.07 * 30**2 / 2,
            "That is what the sensor shows too much while braking. But the filter subtracts 0.13 m/s² of it, which is too much by …?",
        ),
        "the bias alone": (
            lambda: 0.1 * 30**2 / 2,
            "That is the bias without any filter. It has been learnt; what was learnt with it, and does not belong there?",
        ),
        "half forgotten": (
            lambda: 0.06 * 30**2,
            "54 m is 0.06 · 30², or 0.12 · 30²/2. An acceleration makes a·t²/2 metres, and 6 % of 0.5 m/s² are 0.03 m/s².",
        ),
        "a speed": (
            lambda: 0.06 * 30,
            "The acceleration is right, but a·t is the speed that it makes; you need the way.",
        ),
        "nothing": (
            0,
            "While the tram pulls, nothing is off. When it brakes, the scale error changes its sign and the learnt bias does not.",
        ),
        "learnt plus scale": (
            lambda: 0.16 * 30**2 / 2,
            "72 m is what 0.16 m/s² makes, the learnt 0.13 and 0.03 more. The filter subtracts what it has learnt; what does the sensor show too much while the tram brakes?",
        ),
        "an acceleration": (
            0.06,
            "That is the acceleration that is subtracted too much, in m/s². What does it make in 30 s?",
        ),
        "6 % of everything": (
            lambda: 0.06 * (0.5 + 0.1) * 30**2 / 2,
            "The 6 % are of the true acceleration, which is 0.5 m/s². The bias is not scaled.",
        ),
    }
    | MORE["all_bias"]
    | THIRD["all_bias"]
    | FOURTH["all_bias"],
    otherwise=facts.acceleration_of,
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
    wrong={
        "half forgotten": (
            lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 4 * b * allowed)) / (2 * b),
            "That solves dv·t + b·t² = allowed. The bias makes b·t²/2 metres: its speed grows from nothing to b·t, and on average is half of that.",
        ),
        "only the bias": (
            lambda dv, b, allowed: math.sqrt(2 * allowed / b),
            "That is the bias alone. The wrong speed, which the tram takes into the tunnel, comes on top.",
        ),
        "only the speed": (
            lambda dv, b, allowed: allowed / dv,
            "That is the speed alone. The bias makes the speed wronger all the time.",
        ),
        "the past": (
            lambda dv, b, allowed: (-dv - math.sqrt(dv**2 + 2 * b * allowed)) / b,
            "That is the other root of the parabola: a time before the tunnel. Take the plus sign.",
        ),
        "signs against each other": (
            lambda dv, b, allowed: (dv + math.sqrt(dv**2 + 2 * b * allowed)) / b,
            "Your time solves b·t²/2 − dv·t = allowed, as if speed and bias pulled against each other. Has dv the wrong sign, or is it the other root, with its sign dropped? Take (−dv + √…)/b.",
        ),
        "two times added": (
            lambda dv, b, allowed: allowed / dv + math.sqrt(2 * allowed / b),
            "That is the sum of two times, one for each error alone. The two errors happen at the same time: add the metres, then solve for t.",
        ),
        "the earlier of two": (
            lambda dv, b, allowed: min(allowed / dv, math.sqrt(2 * allowed / b)),
            "That is the earlier of two times, one for each error alone. But both errors act at the same time: add the metres, then solve for t.",
        ),
        "not divided": (
            lambda dv, b, allowed: -dv + math.sqrt(dv**2 + 2 * b * allowed),
            "Nearly: that is b·t, the speed gained meanwhile. Divide by b.",
        ),
        "four under the root": (
            lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 4 * b * allowed)) / b,
            "Under the root of the formula stands 4 times b/2 times allowed, which is 2 b allowed: the parabola "
            "begins with b/2, not with b.",
        ),
        "two in the denominator": (
            lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + 2 * b * allowed)) / (2 * b),
            "The root is right. Below must stand twice the factor of t². That factor is b/2, so divide by b.",
        ),
        "no time in it": (
            lambda dv, b, allowed: allowed / (dv + b),
            "That is allowed/(dv + b), with the sum of a speed and an acceleration. First make metres of each: dv·t and b·t²/2.",
        ),
        "both squared": (
            lambda dv, b, allowed: math.sqrt(allowed / (dv + b / 2)),
            "That solves dv·t² + b·t²/2 = allowed. The speed error makes dv·t metres; only the bias grows with t².",
        ),
        "both roots": (
            lambda dv, b, allowed: tuple((-dv + side * math.sqrt(dv**2 + 2 * b * allowed)) / b for side in (1, -1)),
            "Two roots; one of them is before the tunnel. Return the one that lies in the future.",
        ),
        "constant speed error": (
            lambda dv, b, allowed: (-dv + math.sqrt(dv**2 + b * allowed)) / b,
            "Nearly: under the root stands 4 times b/2 times allowed, which is 2 b allowed.",
        ),
    }
    | MORE["dark_time"]
    | NEW["dark_time"]
    | THIRD["dark_time"]
    | FOURTH["dark_time"]
    | FIFTH["dark_time"]
    | SEVENTH["dark_time"]
    | TENTH["dark_time"],
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
    wrong=MORE["goes_back"],
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


def updated(x, dx, K, fix):
    """The error state after the fix."""
    return dx + K @ (fix - x[:2] - dx[:2])


@exercise(
    hints=[
        "The line for dx is right. What is missing comes after it: the INS must be corrected too.",
        "First correct dx as published. Then add it to x. And what is left of the error that x has lost?",
        "`dx = dx + K @ (fix - x[:2] - dx[:2])`, then `return x + dx, 0 * dx`.",
    ],
    inputs=fixes,
    fixed={"fix": "a fix is always east and north"},
    wrong={
        "as published": (
            lambda x, dx, K, fix: (x, updated(x, dx, K, fix)),
            "That is the open loop again: dx is never added to x, so the tangents are taken further and further from the road.",
        ),
        "told twice": (
            lambda x, dx, K, fix: (x + updated(x, dx, K, fix), updated(x, dx, K, fix)),
            "The INS is right now. But dx still holds what x has been told already: the next fix would be corrected twice. Set it to zero.",
        ),
        "the old error fed back": (
            lambda x, dx, K, fix: (x + dx, 0 * dx),
            "You fed back the error state from before the fix: correct dx first, then add it.",
        ),
        "the old error forgotten": (
            lambda x, dx, K, fix: (x + K @ (fix - x[:2] - dx[:2]), 0 * dx),
            "You fed back only what this fix brought, and threw away what dx held before. Add the whole dx.",
        ),
        "innovation without dx": (
            lambda x, dx, K, fix: (x + dx + K @ (fix - x[:2]), 0 * dx),
            "The innovation compares the fix with x alone. A part of that difference is explained by dx already: subtract dx[:2] as well.",
        ),
        "fed back before the gain, and again": (
            lambda x, dx, K, fix: (x + dx + updated(x, dx, K, fix), 0 * dx),
            "In your x the old dx is added twice: the corrected dx holds it already.",
        ),
        "wrong sign": (
            lambda x, dx, K, fix: (x - updated(x, dx, K, fix), 0 * dx),
            "The sign: here dx is truth minus INS, so it is added to the INS.",
        ),
        "reset without telling": (
            lambda x, dx, K, fix: (x, 0 * dx),
            "The error state is zero, but it has not been added to x: the fix is lost.",
        ),
        "only the position": (
            lambda x, dx, K, fix: (x + np.append(updated(x, dx, K, fix)[:2], 0 * x[2:]), 0 * dx),
            "The position was told and the rest thrown away. Add the whole of dx: heading and faults are what bends.",
        ),
        "the output only": (
            lambda x, dx, K, fix: x + updated(x, dx, K, fix),
            "That is the output, and it is right. But the filter goes on with two states: return the INS's state and the error state.",
        ),
        "told the old, kept the new": (
            lambda x, dx, K, fix: (x + dx, updated(x, dx, K, fix)),
            "You told x the error state from before the fix and kept the corrected one. First correct dx, then "
            "add it to x, and what x has been told is zero in dx.",
        ),
        "dx left out": (
            lambda x, dx, K, fix: (x + K @ (fix - x[:2]), 0 * dx),
            "What dx held before the fix is lost, and the fix is compared with x alone. Correct dx first, as "
            "published; then add it to x.",
        ),
        "not reset": (
            lambda x, dx, K, fix: (x + updated(x, dx, K, fix), dx),
            "The INS is right now. But dx still holds the old error, which x has been told: set it to zero.",
        ),
        "only the news kept": (
            lambda x, dx, K, fix: (x + dx, K @ (fix - x[:2] - dx[:2])),
            "You split the correction in two and told x only the older part. Tell it all; then dx is zero.",
        ),
        "nothing subtracted": (
            lambda x, dx, K, fix: (x + dx + K @ (fix - x[:2] - dx[:2]), dx + K @ (fix - x[:2] - dx[:2]))[:1] * 2,
            "You returned the INS's state twice. The second result is the error state, which is zero after "
            "feeding back.",
        ),
    }
    | MORE["mended_fix"]
    | NEW["mended_fix"]
    | THIRD["mended_fix"]
    | FOURTH["mended_fix"]
    | FIFTH["mended_fix"],
    then="As dx is zero now, F @ dx stays zero until the next fix: between two fixes only P must be predicted.",
)
def mended_fix(x, dx, K, fix):
    """The INS's state and the error state after a fix, with feedback."""
    dx = dx + K @ (fix - x[:2] - dx[:2])
    return x + dx, 0 * dx
