"""Lesson 6, `which_knob`: wrong answers, each with the sentence that it gets."""

from itertools import combinations

from kflearn.exercises._words import heard

KNOBS = {
    frozenset("AC"): "C is enough. A on top of it would change the ratio, and so the estimate.",
    frozenset("BC"): "C is enough. B on top of it would change the ratio, and so the estimate.",
    frozenset("CE"): "C is enough. E has no lasting effect: P₀ is forgotten after a few readings.",
    frozenset(
        "CD"
    ): "C and D are opposites: one makes the claim larger, the other smaller. Which does a claim that is too small need?",
    frozenset("ABC"): "C is enough. A and B say something else: each of them by itself changes the ratio.",
}

ALL_KNOBS = "Is the estimate bad, or the claim? 0.27 V is nearly the best possible, so only the claim is to be mended: choose one."

KNOWN = [*map(tuple, ("AB", "AC", "BC", "CD", "CE", "ABC", "ABCD"))]

LETTERS = {
    "A": "A changes the ratio, and so the estimate.",
    "B": "B changes the ratio, and so the estimate.",
    "D": "D makes the band narrower, and it is too narrow already.",
    "E": "E has no lasting effect: P₀ is forgotten after a few readings.",
}


def too_many(letters):
    """What is said of several letters where C alone is right."""
    first = "C is enough." if "C" in letters else "One letter is enough, and it is none of these."
    return " ".join([first, *(LETTERS[letter] for letter in letters if letter != "C")])


KNOB = heard(
    {
        r"^9(\.0)?\b": "9 is by how much. Asked is what is to be multiplied by it: answer with a letter.",
        r"^none": "One of the five is right. The estimate is nearly the best: which letter changes only the band?",
    }
)

WRONG = (
    {
        "Q up": (
            "A",
            "A larger Q changes the ratio, and so the estimate, which is nearly the best already. Only the band needs mending.",
        ),
        "R up": (
            "B",
            "A larger R widens the band, but it changes the ratio too: the estimate becomes late. Keep Q/R.",
        ),
        "both down": ("D", "That makes the band narrower still. The claim, 0.09 V, is too small already."),
        "A and B": (
            {"A", "B"},
            "Both up, but by which factors? If you mean the same factor, one letter says it; different ones change the ratio.",
        ),
        "P₀ up": ("E", "P₀ is forgotten after a few readings; the claim settles at √(K·R) whatever the start was."),
    }
    | {", ".join(sorted(letters)): (set(letters), words) for letters, words in KNOBS.items()}
    | {
        "all": (set("ABCDE"), ALL_KNOBS),
        "all but P₀": (set("ABCD"), ALL_KNOBS),
    }
    | {
        ", ".join(letters): (set(letters), too_many(letters))
        for size in (2, 3, 4)
        for letters in combinations("ABCDE", size)
        if letters not in KNOWN
    }
)
