"""Wrong answers to exercises of lesson 26 that a fifth group of strangers gave, and more of their kind."""

import numpy as np

AREA = np.pi * 9.21 * 30  # of the gate, in m²
WHOLE_B = "λ √(2πS) (1 − 0.99 P_D)/P_D"


def weighed(z, expected, S, detection, clutter, b=None, e=None, gate=None, first=None):
    """PDA weights with one part of them exchanged; each part is made from what is given."""
    given = z, expected, S, detection, clutter
    nis = (z - expected) ** 2 / S
    inside = nis <= 6.635 if gate is None else gate(*given)
    score = np.where(inside, np.exp(-nis / 2) if e is None else e(nis, *given), 0)
    right = clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * detection) / detection
    none = right if b is None else b(right, *given)
    return np.append(none, score) / (none + score.sum())


def with_b(b):
    return lambda *given: weighed(*given, b=b)


def with_e(e):
    return lambda *given: weighed(*given, e=e)


def numbers(z, expected, S, detection, clutter):
    """b, and e of each reading, 0 outside the gate."""
    nis = (z - expected) ** 2 / S
    b = clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * detection) / detection
    return b, np.where(nis <= 6.635, np.exp(-nis / 2), 0)


def by_largest(*given):
    b, e = numbers(*given)
    return np.append(b, e) / np.append(b, e).max()


def by_what_is_left(share):
    """The readings share a fixed probability; the first weight is what is left."""

    def weights(*given):
        _, e = numbers(*given)
        w = e / max(e.sum(), 1e-300) * share(given[3])
        return np.append(1 - w.sum(), w)

    return weights


def rest(*given):
    _, e = numbers(*given)
    return np.append(1 - e.sum(), e)


def empty_forgotten(*given):
    b, e = numbers(*given)
    return np.append(b, e) / (b + e.sum()) if e.any() else 0 * np.append(b, e)


def first_missing(*given):
    b, e = numbers(*given)
    return e / (b + e.sum())


def first_alone(*given):
    b, e = numbers(*given)
    return b / (b + e.sum())


WRONG = {
    "false_in_gate": {
        "root of the trace": (
            np.pi * 9.21 * 61**0.5 * 5e-4,
            "That is what √(36 + 25) makes, the root of the trace. The area goes with the root of the determinant, √(36 · 25) = 30.",
        ),
        "the lesson's λ": (AREA * 4e-4, "That is right for the lesson's 4 · 10⁻⁴ per m². Here λ is 5 · 10⁻⁴ per m²."),
        "rounded to none": (0, "A mean number need not be a whole one: 0 would say that there is never one. Give three digits."),
        "rounded to one": (1, "A mean number need not be a whole one. Give three digits."),
        "half": (0.5, "That is too coarse: give three digits."),
        "P_D": (AREA * 5e-4 * 0.9, "That is 0.9 times the right number. P_D is about the boat's own reading; false ones are anywhere."),
        "λ = 0.005": (AREA * 5e-3, "That is right for 0.005 per m². Here λ is 0.0005 per m²."),
        "λ = 0.00005": (AREA * 5e-5, "That is right for 0.00005 per m². Here λ is 0.0005 per m²."),
        "mean radius": (
            np.pi * 9.21 * 5.5**2 * 5e-4,
            "That is a circle with the mean of 6 m and 5 m for both axes. The product of the half axes counts: 6 · 5 = 30.",
        ),
        "mean variance": (
            np.pi * 9.21 * 30.5 * 5e-4,
            "That is a circle with the mean of the two variances. The product of the half axes counts: √(36 · 25) = 30.",
        ),
        "a circle of 9.21 m": (
            np.pi * 9.21**2 * 5e-4,
            "That is a circle with the radius 9.21 m. 9.21 is the limit of the NIS, which has no unit: the half axes are √9.21 · 6 m and √9.21 · 5 m.",
        ),
        "900 alone": (0.45, "0.45 is 900 · 0.0005. The area of the gate is π · 9.21 · √900."),
        "30 alone": (0.015, "0.015 is 30 · 0.0005. The area of the gate is π · 9.21 · 30."),
        "900 and the limit": (9.21 * 900 * 5e-4, "That is 9.21 · 900 · 0.0005. The area of the gate is π · 9.21 · √900."),
        "diameters": (
            AREA * 4 * 5e-4,
            "That is four times the right number, as from whole axes. In the area stand the half axes, √9.21 · 6 m and √9.21 · 5 m.",
        ),
    },
    "weights": {
        "no height": (
            with_b(lambda b, z, expected, S, *rest: b / np.sqrt(2 * np.pi * S)),
            "Your b lacks √(2πS). The Gaussian's height is 1/√(2πS): it belongs to e^(−NIS/2), or its inverse to b.",
        ),
        "height in b": (
            with_b(lambda b, z, expected, S, *rest: b / (2 * np.pi * S)),
            f"Beside e^(−NIS/2) your b is divided by √(2πS). It is multiplied by it: b = {WHOLE_B}.",
        ),
        "volume of the gate": (
            with_b(lambda b, z, expected, S, *rest: b * 2 * np.sqrt(6.635) / np.sqrt(2 * np.pi)),
            f"Your b holds the length of the gate, 2 √(6.635 S). It holds the inverse of the Gaussian's height, √(2πS): b = {WHOLE_B}.",
        ),
        "by the largest": (by_largest, "Those are divided by the largest of them. Divide all by their sum, so that they sum to 1."),
        "P_D to share": (by_what_is_left(lambda d: d), "The readings share P_D here, whatever λ is and however far away they are. The first weight is b divided by the sum of all."),
        "P_D P_G to share": (by_what_is_left(lambda d: 0.99 * d), "The readings share 0.99 P_D here, whatever λ is and however far away they are. The first weight is b divided by the sum of all."),
        "the rest to one": (rest, f"Your first weight is what is missing to 1, and λ and P_D stand nowhere. It is b = {WHOLE_B}; then divide all by their sum."),
        "λ forgotten, height forgotten": (
            with_b(lambda b, z, expected, S, d, clutter: 1 - 0.99 * d),
            f"Your b is 1 − 0.99 P_D alone. It has three more parts: b = {WHOLE_B}.",
        ),
        "λ and height forgotten": (
            with_b(lambda b, z, expected, S, d, clutter: (1 - 0.99 * d) / d),
            f"Your b lacks λ √(2πS): b = {WHOLE_B}.",
        ),
        "√6.635 without S": (
            lambda *given: weighed(*given, gate=lambda z, expected, *rest: abs(z - expected) <= np.sqrt(6.635)),
            "Your gate is √6.635 m wide to each side, whatever S is. 6.635 is the limit of the NIS, (z − expected)²/S.",
        ),
        "plus": (with_e(lambda nis, *given: np.exp(nis / 2)), "The sign of the exponent: a reading farther away gets a smaller weight, e^(−NIS/2)."),
        "1/NIS": (with_e(lambda nis, *given: 1 / nis), "Your weights go with 1/NIS. The Gaussian has e^(−NIS/2)."),
        "P_D twice": (
            with_e(lambda nis, z, expected, S, d, clutter: d * np.exp(-nis / 2)),
            "Beside e^(−NIS/2) your b is divided by P_D twice: either b is divided by it, or e^(−NIS/2) is multiplied by it.",
        ),
        "P_G twice": (
            with_e(lambda nis, *given: np.exp(-nis / 2) / 0.99),
            "Beside e^(−NIS/2) your b is too small by P_G = 0.99. P_G stands in 1 − 0.99 P_D alone; the 1/P_G of a Gaussian that is cut off at the gate drops out.",
        ),
        "the lesson's P_D": (
            with_b(lambda b, z, expected, S, d, clutter: clutter * np.sqrt(2 * np.pi * S) * (1 - 0.99 * 0.9) / 0.9),
            "Your P_D is 0.9 in every trial, as in the lesson. It is handed in as `detection`.",
        ),
        "P_G of 0.9": (
            with_b(lambda b, z, expected, S, d, clutter: clutter * np.sqrt(2 * np.pi * S) * (1 - 0.9 * d) / d),
            "Your P_G is 0.9. The limit 6.635 belongs to P_G = 0.99.",
        ),
        "P_D upside down": (
            with_b(lambda b, z, expected, S, d, clutter: clutter * np.sqrt(2 * np.pi * S) * d / (1 - 0.99 * d)),
            "The quotient in b is upside down: (1 − 0.99 P_D)/P_D. The better the sensor, the less likely is “none of them”.",
        ),
        "times N": (with_b(lambda b, z, *rest: len(z) * b), "Your b is N times too large, for N readings. λ is the density of false readings already."),
        "by N": (with_b(lambda b, z, *rest: b / len(z)), "Your b is N times too small, for N readings. λ is the density of false readings already."),
        "empty forgotten": (
            empty_forgotten,
            "Right where a reading is in the gate. Where none is, your weights are all 0: the first one, “none of them”, is 1 then.",
        ),
        "first missing": (first_missing, "The weights of the readings are right. The first one, of “none of them”, is missing: put it before them."),
        "first alone": (first_alone, "That is the first weight, and it is right. Return those of the readings as well, (N + 1,) in all."),
    },
    "zeros": {
        "costs": ([0, 0], "0 is what each chosen pair costs. Asked are the numbers of the readings, 1 to 3: first that of A, then that of B."),
        "smallest NIS": ([0.4, 1.5], "Those are NIS values from the table, the smallest of each row. Asked are the numbers of the readings, 1 to 3."),
        "costs of a right program": ([3.0, 1.5], "Those are the costs in a right program. Asked are the numbers of the readings in this one, in which a dash costs 0."),
        "smallest sum": (0, "0 is the smallest sum, and it is right. Which two pairs make it? Hand in the readings, first that of A, then that of B."),
        "sum of a right program": (4.5, "That is the smallest sum of a right program. In this one a dash costs 0: which two readings make a smaller sum?"),
        "smallest NIS, exchanged": ([1.5, 0.4], "Those are NIS values from the table. Asked are the numbers of the readings, 1 to 3."),
        "NIS of the greedy way": ([0.4, 6.0], "Those are NIS values from the table. Asked are the numbers of the readings, 1 to 3."),
        "none": ([0, 3], "There is no reading 0, and this program gives each track one. Look at the dash of track A: what does it cost?"),
        "none for B": ([2, 0], "There is no reading 0, and this program gives each track one. Look at the dash of track B: what does it cost?"),
        "chosen pairs": (
            [[0, 1, 0], [0, 0, 1]],
            "Those pairs are right. Hand in the numbers of the readings: first that of A, then that of B.",
        ),
    },
}  # fmt: skip
