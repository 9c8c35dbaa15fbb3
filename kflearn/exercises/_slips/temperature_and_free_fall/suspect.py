"""Lesson 10, `suspect`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

R_EVEN = "R cannot push the mean to one side."

G_SMALL = "With g too small the filter expects the stone too high; the readings would lie below, with a minus sign."

SUSPECT = heard(
    {
        r"(grav|\bg\b).*(small|low|weak)": f"Read as “g too small”: {G_SMALL[0].lower()}{G_SMALL[1:]}",
        r"^q\b|process": "A wrong Q changes the NIS, and leaves the innovations even on both sides. Here they are not: which of the four pushes them to one side?",
        r"nothing|none|chance": "One of the four is right. By chance the innovations would lie on both sides and average nearly zero. Here they average +1.5 m.",
        r"^(g|the gravity|gravity)$": "It is g, one of the two halves of the answer. Where does a filter expect the stone if its g is too small, too high or too low?",
        r"^(too )?(large|small)$": "What is too large, or too small, g or R? The innovations lie on one side of zero: which of the two can push them there?",
        r"sign": "With the sign of g wrong the filter would expect the stone far too high, and the readings would lie below, with a minus sign. Something is too large or too small: which?",
    }
)


WRONG = {
    "g too small": (
        "g too small",
        "With g too small the filter expects the stone too high; the readings would lie below, with a minus sign.",
    ),
    "R too small": (
        "R too small",
        "That would explain a NIS above 1. But the innovations would fall evenly on both sides and average zero.",
    ),
    "R too large": (
        "R too large",
        "With R too large the NIS would lie below 1, and the innovations would average zero.",
    ),
    "g and R too small": (
        {"g too small", "R too small"},
        f"Only one setting is wrong, and neither of these fits. {R_EVEN} And with g too small the mean would be negative.",
    ),
    "g too small, R too large": (
        {"g too small", "R too large"},
        f"Only one setting is wrong, and neither of these fits. {R_EVEN} And with g too small the mean would be negative.",
    ),
    "R both ways": (
        {"R too small", "R too large"},
        f"Only one setting is wrong, and neither of these fits. {R_EVEN}",
    ),
    "g both ways": (
        {"g too small", "g too large"},
        "It is g, but in one direction. Where does a filter with too small a g expect the stone, too high or too low?",
    ),
    "all": (
        {"g too small", "g too large", "R too small", "R too large"},
        f"{R_EVEN} So it is g: where does the filter expect the stone, too high or too low?",
    ),
    "g and R": (
        {"g too large", "R too small"},
        f"One of them explains both clues. {R_EVEN} A wrong g moves it, and makes the NIS larger too.",
    ),
}
