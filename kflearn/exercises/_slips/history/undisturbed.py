"""Lesson 28, `undisturbed`: wrong answers, each with the sentence that it gets."""

import itertools

CALM = {
    "A": "One of the others belongs to it as well: in which row do the weights fall by equal steps, as on a ruler?",
    "D": "One of the others belongs to it as well: in which row does the age of a reading make no difference at all?",
}

DISTURBED = {
    "B": "B was told a large Q: the newest night has nearly all the weight, because the clock may wander far in a night.",
    "C": "C was told a small Q, but not 0: its weights become a little smaller with every night, as the clock may have wandered since.",
}


def wrong_letters():
    """Every choice of up to three letters but the right one, with what to say: first what is too much, then what is missing."""
    for letters in (set(c) for size in (1, 2, 3, 4) for c in itertools.combinations("ABCD", size)):
        too_many = [text for letter, text in DISTURBED.items() if letter in letters]
        missing = [text for letter, text in CALM.items() if letter not in letters]
        if too_many:
            yield letters, " ".join(too_many)
        elif missing:
            yield letters, f"{min(letters)} is right. {missing[0]}"


WRONG = {", ".join(sorted(picked)): (picked, sentence) for picked, sentence in wrong_letters()}
