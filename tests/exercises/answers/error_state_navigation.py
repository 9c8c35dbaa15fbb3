"""Lesson 20: answers that were handed in by strangers, and what each must get (see test_answers.py)."""

import numpy as np

RIGHT = [
    ("goes_back", [False, False, True, False, True]),
    ("all_bias", -27),
]


TOLD = [  # exercise, answer, words of the reply; some: words that are not in it
    ("dark_time", lambda dv, b, far: (-dv + np.sqrt(dv**2 - 2 * b * far)) / b, "Under the root it is plus"),
    ("all_bias", 20, "an acceleration of 0.0444 m/s²"),
    ("all_bias", (1 / 0.94 - 1) * 450, "what the sensor shows"),
    ("goes_back", [2, 4], "places of two states"),
    ("goes_back", [1, 0, 1, 0, 1], "F does not depend on them"),
    ("goes_back", [True, False, False, False, False], "Two are missing"),
    (
        "dark_time",
        lambda dv, b, allowed: abs((-dv - np.sqrt(dv**2 + 2 * b * allowed)) / b),
        "or is it the other root, with its sign dropped? Take (−dv + √…)/b",
    ),
    ("dark_time", lambda dv, b, allowed: (dv + np.sqrt(dv**2 + 2 * b * allowed)) / b, "Has dv the wrong sign, or"),
    ("dark_time", lambda dv, b, allowed: (allowed - dv) / b, "the *speed* is wrong by `allowed`"),
    ("dark_time", lambda dv, b, allowed: np.sqrt(2 * allowed / (b + dv)), "as if dv were an acceleration too"),
    ("all_bias", (0.13 + 0.07) * 450, "0.13 and 0.07 m/s² make together"),
    ("goes_back", "00101", "write numbers in brackets", "leave out"),
]
