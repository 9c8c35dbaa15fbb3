"""Lesson 22, `moved_or_noisy`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

NOISY = heard(
    {
        r"^0?\.8\d*$|corr|neighb": "You read the right number. What makes neighbours alike by 0.85, white noise or a board that turns? Hand in the letter.",
        r"^d$|none|neither": "One of the three is right: hand in A, B or C, and look at the correlation of neighbours.",
        r"turn|mov|board": "The motion of the board: which letter is that?",
        r"^\d{3}": "That is R̂ of the stretch. What made it so large, a noisier sensor or a board that was turned? Hand in the letter.",
        r"^(true|yes|no|false)$": "Three answers are offered, A, B and C. What makes neighbours alike by 0.85, white noise or a board that turns? Hand in the letter.",
    }
)


WRONG = {
    "noise": (
        "A",
        "White noise has neighbours near 0, as they are from 4.6 s on. Here they are strongly correlated.",
    ),
    "cannot be told": (
        "C",
        "R̂ and the NIS cannot tell it. But a third number is printed, and it differs between the two stretches.",
    ),
    "A, B": (
        {"A", "B"},
        "Choose one, please. White noise would leave the neighbours near 0: only one of A and B can make 0.85.",
    ),
    "B, C": (
        {"B", "C"},
        "Choose one, please. If B can be told from A, then C is wrong: does the third printed number tell it?",
    ),
    "A, C": (
        {"A", "C"},
        "The right one is none of these. Neighbours that correlate by 0.85 are not white, so not A; and this tells the two apart.",
    ),
    "all": ({"A", "B", "C"}, "Choose one, please: the three exclude one another. The third printed number decides."),
}
