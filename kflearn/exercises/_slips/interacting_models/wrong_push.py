"""Lesson 18, `wrong_push`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

PUSHED = "G enters only by Q = G q Gᵀ. Which q has the straight model?"

PUSH = heard(
    {
        r"(little|bit|slight|somewhat)": f"Not even a little: {PUSHED}",
        r"twice|double|half|times": f"By no factor: {PUSHED}",
        r"turn|straight|depends|both": f"It does not depend on turns: {PUSHED}",
        r"small|less": "One might expect a smaller error. But G enters only by Q = G q Gᵀ, and for this model q = 0: Q is zero with any G.",
    }
)


WRONG = {
    "smaller": (
        "smaller",
        "One might expect that. But G enters only by Q = G q Gᵀ, and for this model q = 0: Q is zero with any G.",
    ),
    "larger": (
        "larger",
        "Mending does no harm here either: G enters only by Q = G q Gᵀ, and for this model q = 0.",
    ),
}
