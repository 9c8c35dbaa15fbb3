"""Lesson 1, `impossible`: wrong answers, each with the sentence that it gets."""

import itertools

IMPOSSIBLE = {"A": "Which two units does A add?", "C": "In which unit is a variance?", "E": "What is (m/s²)·s?"}

POSSIBLE = {
    "B": "B is possible: the corner of Q is the mean of a disturbance of the position times one of the velocity, m · m/s = m²/s.",
    "D": "D is possible: B₂ is in (m/s)/N, and 1 N is 1 kg·m/s², which leaves s/kg.",
}


def wrong_choices():
    """Every set of letters but the right one, with what to say about it: first what is too much, then what is missing."""
    letters = "ABCDE"
    for picked in (set(c) for size in range(1, 6) for c in itertools.combinations(letters, size)):
        too_many = [POSSIBLE[letter] for letter in letters if letter in picked and letter in POSSIBLE]
        missing = [IMPOSSIBLE[letter] for letter in letters if letter in IMPOSSIBLE and letter not in picked]
        if picked == set(POSSIBLE):
            yield (
                picked,
                f"B and D are the two that can be right. The question asks which cannot be right. {' '.join(too_many)}",
            )
        elif too_many:
            yield picked, f"Not all five. {too_many[0]}" if len(picked) == 5 else " ".join(too_many)
        elif missing:
            yield picked, f"Right so far, but {len(missing)} more cannot be right. {missing[0]}"


WRONG = {", ".join(sorted(picked)): (picked, sentence) for picked, sentence in wrong_choices()}
