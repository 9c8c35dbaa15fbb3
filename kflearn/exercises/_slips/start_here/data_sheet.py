"""Lesson 0, `data_sheet`: wrong answers, each with the sentence that it gets."""

import math

WRONG = {
    "σ": (3, "3 m is the standard deviation. R is a variance: square it."),
    "6² without halving": (
        36,
        "36 is the square of the ±6 m of the data sheet. 6 m is 2σ: halve it first, then square. This R is four times too large.",
    ),
    "as printed": (
        6,
        "6 m is the bound of the data sheet, 2σ, and in metres. R is σ², in square metres.",
    ),
    "halved after squaring": (
        18,
        "18 is twice σ²: 6² is (2σ)² = 4σ², and half of it is still 2σ². Halve the 6 m first, then square.",
    ),
    "doubled": (144, "144 is 12², or 4 · 6². The 6 m already contain the 2 of ±2σ: halve them, then square."),
    "±3σ": (
        4,
        "4 is (6/3)², which holds if ±6 m were ±3σ. Within ±3σ lie 99.7 %; the data sheet says 95 %, which is ±2σ.",
    ),
    "root": (
        lambda: math.sqrt(3),
        "1.73 is √3, the root of σ, or 6/√12, which is for an error that is never beyond ±3 m. From a standard deviation to a variance you square.",
    ),
    "12": (
        12,
        "12 is 6²/3, which is for an error that is never beyond its bound, or 2 · 6. Here 5 % of the readings lie outside: 6 m is 2σ. Halve it, then square.",
    ),
    "root of 6": (lambda: math.sqrt(6), "2.45 is the root of 6. R is a square: that of σ, and 6 m is 2σ."),
    "half of half": (
        2.25,
        "2.25 is (6/4)², which holds if 6 m were the whole width. It is ±6 m, so the width is 12 m, and 6 m is 2σ.",
    ),
    "6 by 2² the wrong way": (1.5, "1.5 is 6/4, half of σ. Halve the 6 m once, which gives σ = 3 m; then square."),
    "95 % of it": (
        34.2,
        "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ.",
    ),
    "95 % of σ": (5.7, "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ."),
    "95 % of it, squared": (
        32.49,
        "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ.",
    ),
    "95 % of the half, squared": (
        8.1225,
        "The 95 % is no factor: it says that 95 of 100 readings lie within ±6 m, and that is ±2σ.",
    ),
    "σ with 1.96": (
        3.061224489795918,
        "That is σ, with 1.96 where this lesson says 2. R is a variance: square it.",
    ),
    "twice the square": (72, "72 is 2 · 6². The 6 m are 2σ: halve them first, then square."),
}
