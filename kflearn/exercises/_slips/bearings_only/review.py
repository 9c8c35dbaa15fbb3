"""Lesson 15, `review`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

REVIEW = heard(
    {
        r"root|sqrt|line 2": "That is reviewer (a): answer with the letter. But look whether a bearing's slope needs the distance or its square.",
        r"sign|minus|line 3": "That is reviewer (b), or (c) for the zeros: answer with the letter. But try a target due east that moves north.",
        r"^(none|nobody|no one|neither)": "One of the four is right: A, B and C criticise, D says that nothing is wrong. Hand in the letter.",
    }
)


WRONG = {
    "a": (
        "a",
        "With the root, line 3 would divide metres by metres, and a step of a target ten times as far away would change the bearing as much. Look at what the divisor is, not at its name.",
    ),
    "b": (
        "b",
        "Try a target due east. One metre further north makes its bearing larger: the entry for north is +east/…, as in line 3.",
    ),
    "c": (
        "c",
        "How fast a target moves does not change where it is seen now. The zeros are right.",
    ),
}
