"""Lesson 26, `weights`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._combined import combined


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


def after_the_sum(z, expected, S, detection, clutter):
    nis = (z - expected) ** 2 / S
    e, b = np.exp(-nis / 2), clutter * np.sqrt(2 * np.pi * S) * (1 - detection * 0.99) / detection
    w = np.append(b, e) / (b + e.sum())
    w[1:][nis > 6.635] = 0
    return w


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


WHOLE_B = "λ √(2πS) (1 − 0.99 P_D)/P_D"


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


def with_e(e):
    return lambda *given: weighed(*given, e=e)


def empty_forgotten(*given):
    b, e = numbers(*given)
    return np.append(b, e) / (b + e.sum()) if e.any() else 0 * np.append(b, e)


def first_missing(*given):
    b, e = numbers(*given)
    return e / (b + e.sum())


def first_alone(*given):
    b, e = numbers(*given)
    return b / (b + e.sum())


WRONG = (
    {
        "none is forgotten": (
            without_none,
            "The readings alone share the whole. The first weight, that none of them is the target's, is missing.",
        ),
        "the nearest": (
            nearest_only,
            "You give the whole weight to the nearest reading. That is the nearest neighbour; here each reading gets its share.",
        ),
        "two sums": (
            two_sums,
            "The first weight is right, and the others sum to 1 by themselves. All of them together sum to 1: divide each by the same sum, b included.",
        ),
        "left out": (
            left_out,
            "You leave out the readings outside the gate. They keep their places, with the weight 0.",
        ),
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
            "plane": "Your gate lets readings in whose NIS is above 6.635. On a line 99 % have a NIS up to 6.635; 9.21 is the limit in the plane.",
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
    )
    | {
        "gate after the sum": (
            after_the_sum,
            "Your weights no longer sum to 1 where a reading is refused: set those to 0 before you divide by the sum.",
        ),
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
        "by the largest": (
            by_largest,
            "Those are divided by the largest of them. Divide all by their sum, so that they sum to 1.",
        ),
        "P_D to share": (
            by_what_is_left(lambda d: d),
            "The readings share P_D here, whatever λ is and however far away they are. The first weight is b divided by the sum of all.",
        ),
        "P_D P_G to share": (
            by_what_is_left(lambda d: 0.99 * d),
            "The readings share 0.99 P_D here, whatever λ is and however far away they are. The first weight is b divided by the sum of all.",
        ),
        "the rest to one": (
            rest,
            f"Your first weight is what is missing to 1, and λ and P_D stand nowhere. It is b = {WHOLE_B}; then divide all by their sum.",
        ),
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
        "plus": (
            with_e(lambda nis, *given: np.exp(nis / 2)),
            "The sign of the exponent: a reading farther away gets a smaller weight, e^(−NIS/2).",
        ),
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
        "times N": (
            with_b(lambda b, z, *rest: len(z) * b),
            "Your b is N times too large, for N readings. λ is the density of false readings already.",
        ),
        "by N": (
            with_b(lambda b, z, *rest: b / len(z)),
            "Your b is N times too small, for N readings. λ is the density of false readings already.",
        ),
        "empty forgotten": (
            empty_forgotten,
            "Right where a reading is in the gate. Where none is, your weights are all 0: the first one, “none of them”, is 1 then.",
        ),
        "first missing": (
            first_missing,
            "The weights of the readings are right. The first one, of “none of them”, is missing: put it before them.",
        ),
        "first alone": (
            first_alone,
            "That is the first weight, and it is right. Return those of the readings as well, (N + 1,) in all.",
        ),
        "nothing in the gate": (
            lambda *given: weighed(
                *given,
                e=lambda nis, z, expected, S, *others: np.exp(-((z - expected) ** 2) * S / 2),
                gate=lambda z, expected, S, *others: (z - expected) ** 2 * S <= 6.635,
            ),
            "You give all weight to none of them, as if no reading were in the gate. Is the NIS (z − expected)²/S, with a minus, and divided by S?",
        ),
    }
)
