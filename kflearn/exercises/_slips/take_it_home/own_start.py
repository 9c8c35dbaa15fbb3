"""Lesson 29, `own_start`: wrong answers, each with the sentence that it gets."""

import itertools

FINE = {
    "A": "A has 1 on its diagonal, so its own start has the variance 25: large or small, but a variance.",
    "C": "C has 1 and 1 on its diagonal, so its own start has the variance 50, as in the lesson.",
}

UNUSABLE = {
    "B": "B is missing: it is the sensor of the experiment above, whose estimate begins at 0.00 and stays near it.",
    "D": "D is missing: a sensor with the opposite sign has −1 on its diagonal. What is 25 times that?",
    "E": "E is missing: it sees both states, but in the other order. Which numbers are on its diagonal?",
}


def wrong_sensors():
    """Every choice of sensors but the right one, with what to say: first what is too much, then what is missing."""
    for letters in (set(c) for size in range(1, 6) for c in itertools.combinations("ABCDE", size)):
        too_many = [text for letter, text in FINE.items() if letter in letters]
        missing = [text for letter, text in UNUSABLE.items() if letter not in letters]
        if too_many or missing:
            yield letters, " ".join(too_many) or missing[0]


WRONG = {", ".join(sorted(picked)): (picked, sentence) for picked, sentence in wrong_sensors()}
