"""Lesson 26, `zeros`: wrong answers, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._shown import show


def readings_of(pair):
    """What a number would mean that is in no row."""
    strange = [each for each in np.ravel(pair) if each not in (1, 2, 3)]
    return (
        f"There is no reading {show(strange[0])}: the table has the readings 1 to 3, and each track gets one."
        if strange
        else None
    )


WRONG = {
    "right program": (
        [3, 1],
        "That is what a right program does, in which pairs outside the gate are forbidden: 3.0 + 1.5. In this one they cost 0.",
    ),
    "greedy": (
        [1, 2],
        "That is the greedy way in a right program: the 0.4 first. This program looks for the smallest sum, and has a 0 for each dash. (Or did you count from 0? In the table the readings count from 1.)",
    ),
    "both the same": ([1, 1], "A reading goes to one track at most. And in this program a dash costs 0."),
    "A alone": ([2, 1], "Half of it: A gets its dash. B has a dash too, which costs 0, and 1.5 is more."),
    "B alone": ([1, 3], "Half of it: B gets its dash. A has a dash too, which costs 0, and 0.4 is more."),
    "exchanged": (
        [3, 2],
        "You have the two in the other order, or took the largest costs: first the reading of A, then that of B.",
    ),
    "both 2": ([2, 2], "A reading goes to one track at most. Look at the dash of B."),
    "both 3": ([3, 3], "A reading goes to one track at most. Look at the dash of A."),
    "all for both": (
        [[1, 2, 3], [1, 2, 3]],
        "Each track gets one reading: two numbers in all, first that of A, then that of B.",
    ),
    "costs": (
        [0, 0],
        "0 is what each chosen pair costs. Asked are the numbers of the readings, 1 to 3: first that of A, then that of B.",
    ),
    "smallest NIS": (
        [0.4, 1.5],
        "Those are NIS values from the table, the smallest of each row. Asked are the numbers of the readings, 1 to 3.",
    ),
    "costs of a right program": (
        [3.0, 1.5],
        "Those are the costs in a right program. Asked are the numbers of the readings in this one, in which a dash costs 0.",
    ),
    "smallest sum": (
        0,
        "0 is the smallest sum, and it is right. Which two pairs make it? Hand in the readings, first that of A, then that of B.",
    ),
    "sum of a right program": (
        4.5,
        "That is the smallest sum of a right program. In this one a dash costs 0: which two readings make a smaller sum?",
    ),
    "smallest NIS, exchanged": (
        [1.5, 0.4],
        "Those are NIS values from the table. Asked are the numbers of the readings, 1 to 3.",
    ),
    "NIS of the greedy way": (
        [0.4, 6.0],
        "Those are NIS values from the table. Asked are the numbers of the readings, 1 to 3.",
    ),
    "none": (
        [0, 3],
        "There is no reading 0, and this program gives each track one. Look at the dash of track A: what does it cost?",
    ),
    "none for B": (
        [2, 0],
        "There is no reading 0, and this program gives each track one. Look at the dash of track B: what does it cost?",
    ),
    "chosen pairs": (
        [[0, 1, 0], [0, 0, 1]],
        "Those pairs are right. Hand in the numbers of the readings: first that of A, then that of B.",
    ),
}
