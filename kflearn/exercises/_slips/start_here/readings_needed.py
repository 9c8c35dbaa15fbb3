"""Lesson 0, `readings_needed`: wrong answers, each with the sentence that it gets."""

import math


def sigma_of(counts):
    """What σ so many readings bring."""
    words = "{} readings bring σ down to {:.3g} m. Solve 2/√n = 0.25 for n."
    more = {
        3: " Three halvings lead from 2 m to 0.25 m, and each takes four times as many readings. (3 is also √8, rounded up. The square of 8 is wanted, not its root.)",
        100: " Fewer are enough: 100 belongs to another σ.",
    }
    return {str(n): (n, words.format(f"{n:,}", 2 / math.sqrt(n)) + more.get(n, "")) for n in counts}


WRONG = (
    {
        "σ/n": (8, "Eight readings give 2/√8 = 0.71 m: the standard deviation falls with √n, not with n."),
        "σ = 1 m": (
            16,
            "Sixteen readings give 2/√16 = 0.5 m. Two mistakes lead to 16: (1/0.25)² leaves out that each reading has σ = 2 m, "
            "and 2²/0.25 takes the 0.25 m for a variance.",
        ),
        "±2σ": (
            256,
            "256 readings bring 2σ down to 0.25 m, but σ itself was asked for. 256 is also (4/0.25)², with the variance, 2² = 4, where σ = 2 m belongs.",
        ),
        "root of eight": (
            lambda: math.sqrt(8),
            "2.83 is √8, a root where a square is needed: from √n = 8 follows n = 8², not n = √8.",
        ),
        "the variance": (
            lambda: 0.25**2,
            "0.0625 m² is the variance the mean must have. How many readings bring 4 m² down to it?",
        ),
        "σ for its square": (
            32,
            "32 is 2/0.25², or 2 · 4²: one of the two numbers is squared, the other is not. Divide variance by variance, or σ by σ and then square.",
        ),
        "squared twice": (
            4096,
            "4,096 readings give 2/√4096 = 0.03 m: more than was asked for. 4,096 is 8⁴, and 8² is enough.",
        ),
        "one too many": (
            65,
            "65 is more than needed: 64 bring σ to 0.25 m exactly, and that is allowed. Below the root stands n itself; n − 1 belongs to a variance that is estimated from readings.",
        ),
        "one too few": (
            63,
            "With 63 readings σ is 0.252 m: one is missing. Or is 63 the place in an array that begins with n = 1? Places are counted from 0.",
        ),
        "what is wanted": (0.25, "0.25 m is the σ that is wanted. How many readings bring it about?"),
        "ratio upside down": (
            0.125,
            "0.125 is 0.25/2, the ratio the wrong way round. 2/0.25 = 8 says how many times smaller σ must become.",
        ),
        "1/0.25": (
            4,
            "Four readings only halve σ, from 2 m to 1 m. In 1/0.25 the 2 m are left out, and so is the square: σ must become eight times smaller.",
        ),
        "three halvings": (
            12,
            "Four readings halve σ, and it must be halved three times. The factors multiply, they do not add up to 12.",
        ),
        "eight halvings": (
            24,
            "24 readings give 2/√24 = 0.41 m. Eight times smaller is three halvings, and each of them takes four times as many readings.",
        ),
    }
    | sigma_of((2, 3, 5, 10, 20, 25, 36, 40, 48, 49, 50, 60, 80, 81, 100, 128, 200, 400, 512, 640, 1000))
    | {
        "one": (1, "One reading has σ = 2 m. The mean of n readings has 2/√n m."),
    }
)
