"""Lesson 23, `real_gap`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

GAP = heard(
    {
        r"^-?0?\.03": "That is the difference in ppm. Divide the two errors: which letter says how large their ratio is?",
        r"^0?\.9": "The ratio is right. Which of A, B and C says so? Hand in the letter.",
        r"^none|neither": "One of the three is right. About two standard errors are a weak sign; but asked is what the two printed errors say. Divide them, and hand in A, B or C.",
        r"^-?7": "About 7 % is the difference. Which of A, B and C says so? Hand in the letter.",
    }
)


WRONG = {
    "half": (
        "A",
        "That was the train. Divide the two errors that are printed here: the smoother's is not half of the line's.",
    ),
    "larger": (
        "C",
        "The difference has a minus: the smoother's error is the smaller one, by about two standard errors.",
    ),
    "A, B": (
        {"A", "B"},
        "Choose one, please. Divide the two printed errors, 0.39/0.43: is that nearer to a half or to nine tenths?",
    ),
    "B, C": (
        {"B", "C"},
        "Choose one, please. The printed difference is −0.032: with the minus, which of the two errors is the smaller one?",
    ),
    "A, C": ({"A", "C"}, "The right one is none of these: 0.39/0.43 is neither a half nor more than 1."),
    "all": ({"A", "B", "C"}, "Choose one, please: the three exclude one another. Divide the two printed errors."),
}
