"""Lesson 3, `printed_position`: wrong answers, each with the sentence that it gets."""

import itertools

import numpy as np

from kflearn.exercises._slips.predict_correct.shared import gain_of

REMARKS = {
    "A": "The tape was expected to read 60 + 10 = 70. For 60.5 m gain and innovation must both be others: it takes more mistakes.",
    "B": "That is one of the readers' answers. The gain is 1/2, but the innovation is still 2 m.",
    "C": "A wrong velocity alone does no harm, as H = [1, 0] does not ask for it: the step is right.",
    "D": "The correction goes away from the tape.",
    "AB": "That is the other answer of the readers: the tape was expected to read 60 + 10 = 70. One more mistake is needed.",
    "AC": "The innovation is right for 60.5 m, but with Q the gain is 5/6. Which gain is needed?",
    "AD": "With A alone the innovation is 62 − 70 = −8 m. The wrong sign turns that into a step upwards, but of 8 m times the gain: only 0.5 m is wanted.",
    "ABD": "The gain is 1/2, as for 60.5 m. But the innovation is 62 − 70 = −8 m, and the wrong sign turns it into a step of 4 m: only 0.5 m is wanted.",
    "BC": "H = [1, 0] never looks at the velocity, so the wrong velocity changes nothing.",
}


def ends_at(letters):
    """Where the step ends with these mistakes, in metres."""
    H = np.array([[1.0, 1.0 if "A" in letters else 0.0]])
    P = np.diag([1.0 if "B" in letters else 5.0, 0.0])
    x, sign = np.array([60.0, 1.0 if "C" in letters else 10.0]), -1.0 if "D" in letters else 1.0
    return float(x[0] + sign * (gain_of(P, H, np.eye(1)) @ (62 - H @ x))[0])


def other_letters():
    """Every set of letters but the right one, with where it ends."""
    for letters in ("".join(c) for size in (1, 2, 3, 4) for c in itertools.combinations("ABCD", size)):
        remark = REMARKS.get(letters, "With the wrong sign the correction goes down from 60 m, and 60.5 m is above it.")
        if letters != "ABC":
            alone = "alone ends" if len(letters) == 1 else "together end"
            yield letters, f"{' and '.join(letters)} {alone} at {ends_at(letters):.2f} m. {remark}"


WRONG = {letters: (set(letters), sentence) for letters, sentence in other_letters()}
