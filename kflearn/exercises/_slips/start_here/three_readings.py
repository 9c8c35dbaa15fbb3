"""Lesson 0, `three_readings`: wrong answers, each with the sentence that it gets."""

import numpy as np

SCATTER = "That is how far the readings scatter. Asked is their mean."


WRONG = {
    "the middle one": (
        62,
        "62 is the middle reading, the median. The mean uses the size of every reading, so the 66 makes it larger than the median.",
    ),
    "the sum": (189, "189 is the sum of the readings; divide it by how many there are."),
    "divided by two": (94.5, "94.5 is 189/2. There are three readings."),
    "between the ends": (
        63.5,
        "63.5 is halfway between the smallest and the largest reading. The mean uses all three.",
    ),
    "the last two": (64, "64 is the mean of the last two readings. The first counts as much as they do."),
    "the first two": (61.5, "61.5 is the mean of the first two readings. The third counts as much as they do."),
    "the largest": (66, "66 is the largest reading. The mean uses all three."),
    "the smallest": (61, "61 is the smallest reading. The mean uses all three."),
    "no brackets": (
        145,
        "145 is 61 + 62 + 66/3: only the 66 is divided by 3. Put brackets around the sum: (61 + 62 + 66) / 3.",
    ),
    "from 60": (3, "If you counted from 60 m, 3 m is the mean of 1, 2 and 6 m: add the 60 m again."),
    "scatter, n − 1": (lambda: np.std([61, 62, 66], ddof=1), SCATTER),
    "scatter": (lambda: np.std([61, 62, 66]), SCATTER),
    "variance": (lambda: np.var([61, 62, 66]), SCATTER),
    "variance, n − 1": (7, SCATTER),
    "range": (5, "5 m is the distance from the smallest reading to the largest. Asked is the mean of all three."),
    "in pairs": (
        63.75,
        "That is the mean of 61.5, the mean of the first two, and 66. The 66 then counts as much as the other two together.",
    ),
    "in pairs, the last two first": (
        62.5,
        "That is the mean of 61 and 64, the mean of the last two. The 61 then counts as much as the other two together.",
    ),
    "by four": (47.25, "47.25 is 189/4. There are three readings."),
    "by ten": (18.9, "18.9 is 189/10. Here there are three readings."),
    "of the ten": (40.186, "That is the mean of the ten readings above. Here take 61, 62 and 66 m."),
    "root mean square": (
        lambda: np.sqrt((61**2 + 62**2 + 66**2) / 3),
        "63.04 is the root of the mean square. The mean takes the readings as they are: their sum, divided by three.",
    ),
    "geometric": (
        lambda: (61 * 62 * 66) ** (1 / 3),
        "62.96 is the cube root of 61 · 62 · 66, the geometric mean. For the mean the readings are added, not "
        "multiplied.",
    ),
}
