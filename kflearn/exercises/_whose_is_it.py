"""Wrong answers to exercises of lesson 26, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._combined import combined

AREA = np.pi * 9.21 * 30


def made(height, gate, missed, sides, density, nis, order):
    """Weights that err in the places that are named."""

    def weights(z, expected, S, detection, clutter):
        y = z - expected
        size = {"√2πS": np.sqrt(2 * np.pi * S), "2π√S": 2 * np.pi * np.sqrt(S), "√S": np.sqrt(S), "2πS": 2 * np.pi * S,
                "√2π S": np.sqrt(2 * np.pi) * S, "√2π": np.sqrt(2 * np.pi)}[height]  # fmt: skip
        gone = {"P_G": 1 - 0.99 * detection, "P_D": 1 - detection, "gate": 0.01, "1": 1.0, "×": (1 - detection) * 0.99}[
            missed
        ]
        b = clutter * size * gone / {"P_D": detection, "1": 1.0, "P_D P_G": 0.99 * detection}[sides]
        b = {"λ": b, "1/λ": b / clutter**2, "no λ": b / clutter}[density]
        scores = {"NIS": y**2 / S, "σ": y**2 / np.sqrt(S), "S²": y**2 / S**2, "root": abs(y) / np.sqrt(S)}[
            nis.split()[0]
        ]
        e = np.exp(-scores / 2 if "whole" not in nis else -scores)
        inside = {"NIS": y**2 / S <= 6.635, "none": y**2 >= 0, "|y|": abs(y) <= 6.635, "σ": abs(y) <= 6.635 * np.sqrt(S),
                  "out": y**2 / S > 6.635, "3": abs(y) <= 3 * np.sqrt(S), "plane": y**2 / S <= 9.21}[gate]  # fmt: skip
        e = np.where(inside, e, 0)
        e = np.append(e, b) if order == "last" else np.append(b, e)
        return e if order == "not divided" else e / e.sum()

    return weights


def right(z, expected, S, detection, clutter):
    nis = (z - expected) ** 2 / S
    b = clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * detection) / detection
    return b, nis, np.where(nis <= 6.635, np.exp(-nis / 2), 0)


def without_none(*given):
    _, _, e = right(*given)
    return e / max(e.sum(), 1e-300)


def nearest_only(*given):
    _, nis, e = right(*given)
    return (np.arange(-1, len(e)) == (nis.argmin() if e.any() else -1)).astype(float)


def two_sums(*given):
    b, _, e = right(*given)
    return np.append(b / (b + e.sum()), e / max(e.sum(), 1e-300))


def left_out(*given):
    b, _, e = right(*given)
    return np.append(b, e[e > 0]) / (b + e.sum())


WRONG = {
    "false_in_gate": {
        "the sum of the variances": (np.pi * 9.21 * 61 * 5e-4, "That is π · 9.21 · 61 · 0.0005, with the trace of S. The area goes with the root of the determinant, √(36 · 25) = 30."),
        "the determinant": (np.pi * 9.21 * 900 * 5e-4, "That is π · 9.21 · 900 · 0.0005, with the determinant itself, 900 m⁴. An area in m² needs its square root, 30."),
        "the limit squared": (np.pi * 9.21**2 * 30 * 5e-4, "The limit is that of a square, the NIS, so the half axes are √9.21 σ long. In the area the limit stands once, not squared."),
        "the root of the limit": (np.pi * np.sqrt(9.21) * 30 * 5e-4, "An area has two half axes, each √9.21 σ long: their product has 9.21 in it, not its root."),
        "no π": (9.21 * 30 * 5e-4, "The π of the ellipse is missing: its area is π times the product of the half axes."),
        "a box": (4 * 9.21 * 30 * 5e-4, "That is the box around the ellipse, with sides 2√9.21 σ. The gate is the ellipse: π in place of 4."),
        "one standard deviation": (np.pi * 30 * 5e-4, "That is the ellipse of one standard deviation. The gate is larger: its limit is a NIS of 9.21."),
        "3 sigma": (np.pi * 9 * 30 * 5e-4, "That is right for a limit of 9 = 3²; the limit is said to be 9.21."),
        "2π": (2 * np.pi * 9.21 * 30 * 5e-4, "The area of an ellipse is π times its half axes, not 2π."),
        "not times λ": (AREA, "That is the area of the gate, in m². How many false readings are in it, at 0.0005 for each m²?"),
        "P_G": (0.99 * AREA * 5e-4, "0.43 is 0.99 times the right number. P_G is about the boat's own reading; false ones are anywhere, and the area alone counts."),
        "the chance of none": (float(np.exp(-AREA * 5e-4)), "That is the probability that no false reading is in the gate. Their mean number was asked for."),
        "the chance of one at least": (1 - float(np.exp(-AREA * 5e-4)), "That is the probability of one false reading at least. Their mean number was asked for; it is larger, as two and three count more."),
        "with the boat": (AREA * 5e-4 + 0.9, "That is larger by 0.9 than it should be: the boat's own reading. Only the false ones were asked for."),
        "one axis": (np.pi * 9.21 * 36 * 5e-4, "That is right for 36 m² on both axes. The half axes go with 6 and 5 m: √(36 · 25) = 30."),
        "the other axis": (np.pi * 9.21 * 25 * 5e-4, "That is right for 25 m² on both axes. The half axes go with 6 and 5 m: √(36 · 25) = 30."),
        "quartered": (AREA * 5e-4 / 4, "That is a quarter of the right number, as if the axes were diameters. √9.21 σ is half an axis already."),
    },
    "weights": {
        "none is forgotten": (without_none, "The readings alone share the whole. The first weight, that none of them is the target's, is missing."),
        "the nearest": (nearest_only, "You give the whole weight to the nearest reading. That is the nearest neighbour; here each reading gets its share."),
        "two sums": (two_sums, "The first weight is right, and the others sum to 1 by themselves. All of them together sum to 1: divide each by the same sum, b included."),
        "left out": (left_out, "You leave out the readings outside the gate. They keep their places, with the weight 0."),
    }
    | combined(
        made,
        most=2,
        height={
            "√2πS": "",
            "2π√S": "2π√S belongs to readings in the plane. On a line the Gaussian's height is 1/√(2πS), so b has √(2πS).",
            "√S": "2π is missing: the Gaussian's height is 1/√(2πS), so b has √(2πS).",
            "2πS": "Beside e^(−NIS/2) your b has 2πS, the square of √(2πS): a root is missing, or the Gaussian's height 1/√(2πS) counts twice.",
            "√2π S": "S is a variance: it belongs under the root too, √(2πS).",
            "√2π": "S is missing: the Gaussian's height is 1/√(2πS), so b has √(2πS).",
        },
        gate={
            "NIS": "",
            "none": "A reading outside the gate gets the weight 0: its NIS is larger than 6.635.",
            "|y|": "You compare the innovation itself with 6.635. That is the limit of the NIS, (z − expected)²/S.",
            "σ": "6.635 is the limit of a square: the gate reaches to √6.635 = 2.58 standard deviations, not 6.635.",
            "out": "Your gate is turned round: it keeps the readings outside.",
            "3": "Your gate reaches to 3 standard deviations. P_G = 0.99 has the limit 6.635, which is 2.58².",
            "plane": "9.21 is the limit for readings in the plane. On a line 99 % have a NIS up to 6.635.",
        },
        missed={
            "P_G": "",
            "P_D": "Your b has 1 − P_D. The target's reading can also be outside the gate: 1 − 0.99 P_D.",
            "gate": "Your b has 1 − 0.99 alone. The target can also give no reading: 1 − 0.99 P_D.",
            "1": "The probability that no reading in the gate is the target's is missing: 1 − 0.99 P_D.",
            "×": "That is a target that gives no reading, inside the gate. Wanted is one without a reading in the gate: 1 − 0.99 P_D.",
        },
        sides={
            "P_D": "",
            "1": "P_D, the probability of a reading of the target, is missing beside e^(−NIS/2): b is divided by it.",
            "P_D P_G": "b is divided by P_D alone: the Gaussian that is cut off at the gate is higher by 1/P_G, so P_G drops out there.",
        },
        density={
            "λ": "",
            "1/λ": "Your b falls with λ. It grows with λ: the more false readings there are, the less is any reading worth.",
            "no λ": "λ is missing in b. Without it b has a unit, and a sum with e^(−NIS/2), which has none, means nothing.",
        },
        nis={
            "NIS": "",
            "NIS whole": "The ½ is missing in e^(−NIS/2).",
            "root": "The NIS is a square: (z − expected)²/S.",
            "σ": "The NIS has S in its denominator, not √S: S is a variance.",
            "S²": "The NIS has S in its denominator, not S²: S is a variance already.",
        },
        order={
            "first": "",
            "last": "The weight of none of them comes first.",
            "not divided": "These are the numbers before the division: divide all by their sum, so that they sum to 1.",
        },
    ),
    "zeros": {
        "right program": ([3, 1], "That is what a right program does, in which pairs outside the gate are forbidden: 3.0 + 1.5. In this one they cost 0."),
        "greedy": ([1, 2], "That is the greedy way in a right program: the 0.4 first. This program looks for the smallest sum, and has a 0 for each dash. (Or did you count from 0? In the table the readings count from 1.)"),
        "both the same": ([1, 1], "A reading goes to one track at most. And in this program a dash costs 0."),
        "A alone": ([2, 1], "Half of it: A gets its dash. B has a dash too, which costs 0, and 1.5 is more."),
        "B alone": ([1, 3], "Half of it: B gets its dash. A has a dash too, which costs 0, and 0.4 is more."),
        "exchanged": ([3, 2], "You have the two in the other order, or took the largest costs: first the reading of A, then that of B."),
        "both 2": ([2, 2], "A reading goes to one track at most. Look at the dash of B."),
        "both 3": ([3, 3], "A reading goes to one track at most. Look at the dash of A."),
    },
}  # fmt: skip
