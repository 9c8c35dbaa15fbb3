"""Lesson 17, `declared_kappa`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show

FIRST = {
    -1: "Right for α = 1.",
    3: "α = 1: 3 is n + κ; take off n = 4.",
    1: "α = 1: the sign is turned round, κ = 3/α² − n.",
    0: "α = 1: with κ = 0 the declaration gives 4, and the program works with 3.",
    -3: "α = 1: −3 would be right for n = 6. The program has four states.",
    7: "α = 1: n is taken off, not added.",
    8: "8 belongs to α = ½. The first number is for α = 1.",
}

PAIRS = [(-1, two) for two in (-4, -0.25, 6, 16, 13, 11, -8, 0, 0.75, -1.75)]

PAIRS += [(one, 8) for one in (3, 1, 0, -3, 7, 8)]

PAIRS += [(-3, 6), (0, 12), (7, 16), (0, -1), (3, -1), (3, 0.75)]

SECOND = {
    8: "Right for α = ½.",
    -1: "α = ½: α² multiplies n + κ, so another κ is needed than for α = 1.",
    2: "α = ½: 2 is 3/α − 4; the scale holds α², a quarter.",
    12: "α = ½: 12 is n + κ; take off n = 4.",
    -4: "α = ½: −4 is λ/α², with λ = −1. It is n + κ, not κ alone, that α² multiplies.",
    -0.25: "α = ½: −0.25 is λα², with λ = −1. Solve α²(4 + κ) = 3 for κ.",
    -3.25: "α = ½: −3.25 is 3α² − 4; 3 must be divided by α².",
    -2.5: "α = ½: −2.5 is 3α − 4; 3 must be divided by α².",
    44: "α = ½: 44 is 3/α⁴ − 4; the declaration holds α².",
    6: "α = ½: 6 would be right for n = 6. The program has four states.",
    16: "α = ½: 16 is 3/α² + 4. n is taken off, not added.",
    13: "α = ½: from 3/α² = 12 the number of states comes off, 4, not κ = −1.",
    11: "α = ½: from 3/α² = 12 the number of states comes off, 4.",
    -8: "α = ½: the sign is turned round, κ = 3/α² − n.",
    0: "α = ½: with κ = 0 the declaration gives 1, and the program works with 3.",
    0.75: "α = ½: 0.75 is α² · 3. Solve α²(4 + κ) = 3 for κ.",
    -1.75: "α = ½: α² stands before 4 as well. Solve α²(4 + κ) = 3 for κ.",
}

KAPPAS = {f"{one} and {two}": ((one, two), f"{FIRST[one]} {SECOND[two]}") for one, two in dict.fromkeys(PAIRS)}


def declared(kappas):
    """What a number would mean that is in no row."""
    one, half = kappas
    if 3 - one == 12 - half:
        return f"3 − {show(3 - one)} and 12 − {show(3 - one)}: that would be right for n = {show(3 - one)}. The program has four states."
    if (one, half) == (-5, -8):
        return "Here α²(n + κ) is −1, which is λ itself. It equals n + λ, which is 3."
    found = [show(a * (4 + kappa), 3) for a, kappa in ((1, one), (0.25, half))]
    return f"With your κ the scale α²(4 + κ) is {found[0]} for α = 1 and {found[1]} for α = ½. The program works with 3 both times."


WRONG = (
    {
        "alpha forgotten": (
            (-1, -1),
            "Right for α = 1. But α² multiplies n + κ: with α = ½ a larger κ must make up for it.",
        ),
        "alpha not squared": (
            (-1, 2),
            "Right for α = 1. For α = ½ your number is 3/α − 4; the scale holds α², a quarter.",
        ),
        "n forgotten": ((3, 12), "Those are the values of n + κ. Take off n = 4."),
        "sign": ((1, -8), "Both signs are turned round: κ = 3/α² − n."),
        "lambda": (
            (-1, -3.25),
            "Right for α = 1. For α = ½ your number is 3α² − 4; the declaration must be larger, 3/α² − n.",
        ),
        "as declared": (
            (0, 0),
            "κ = 0 is what the program declares. Then n + λ would be 4, or 1, and it works with 3.",
        ),
        "swapped": ((8, -1), "The two values have changed places: first for α = 1, then for α = ½."),
        "lambda for alpha one half": (
            (-1, -2.5),
            "Right for α = 1. For α = ½ your number is 3α − 4; 3 must be divided by α², because α²(n + κ) has to be 3.",
        ),
        "alpha twice": (
            (-1, 12),
            "Right for α = 1. For α = ½ 12 is n + κ; take off n = 4.",
        ),
        "alpha squared once more": (
            (-1, 44),
            "Right for α = 1. For α = ½ your number is 3/α⁴ − 4; the declaration holds α².",
        ),
    }
    | KAPPAS
    | {
        "s − 1": (
            (2, 11),
            "That would be right for n = 1, 3 − 1 and 12 − 1. The program has n = 4 states, so take 4 off 3/α².",
        ),
    }
)
