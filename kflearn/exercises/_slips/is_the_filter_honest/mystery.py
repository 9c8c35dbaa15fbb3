"""Lesson 7, `mystery`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._words import heard

MYSTERIES = {
    (
        "Q too large",
        "R too small",
    ): "Both agree with the minus sign. Look at NIS: one of them makes it larger than 2, the other smaller.",
    (
        "Q too small",
        "R too large",
    ): "Both make the gain too small, and neighbours alike: a plus sign. Here the sign is minus.",
    (
        "Q too large",
        "R too large",
    ): "Both agree with NIS below 2. Look at the sign: one makes the gain too large, the other too small.",
    ("Q too small", "R too small"): "Both make NIS larger than 2. Here it is 1.85.",
    (
        "Q too large",
        "Q too small",
    ): "You chose both directions for Q. NIS below 2 decides: is the claimed error too large or too small?",
    (
        "R too large",
        "R too small",
    ): "With R alone sign and NIS do not agree: too large explains the NIS, too small the sign. Which choice explains both?",
}

SUSPECTS = ["Q too large", "Q too small", "R too large", "R too small"]

MYSTERY = heard(
    {
        r"\br */ *q\b": "R/Q is one number for two. Name one of the four faults: Q or R, too small or too large.",
        r"(gain|ratio|\bk\b|\bq */ *r\b)[^,;]*(small|low)": "With a gain (a ratio Q/R) too small, neighbours would be alike, with a "
        "plus sign; here it is −0.078, so the gain is too large. And name one of the four faults.",
        r"(gain|ratio|\bk\b|\bq */ *r\b)[^,;]*(large|high|big)": "The minus sign says that the gain (the ratio Q/R) is too large. "
        "Which makes it so, Q or R? Whether NIS is below or above 2 decides.",
        r"^(?!.*small.*large|.*large.*small).*\bboth\b": "With Q and R wrong by the same factor the gain is right, and neighbours are white. "
        "−0.078 is far outside ±0.005.",
        r"^(right|ok|honest|nothing|none|neither|correct)$": "1.85 is not near 2 here: with so many readings chance allows "
        "1.986 to 2.014 only.",
        r"modest|cautious|careful": "Too modest, yes: NIS is below 2. Which of the four faults makes it so? The sign of the neighbours decides.",
        r"too sure|confident|optimistic": "NIS below 2 says the opposite: the claimed error is too large. Which of the four faults makes it so?",
        r"^q\b": "Is Q too large or too small? Look whether NIS is above or below 2.",
        r"^r\b": "Is R too large or too small? And do both numbers agree with it, the sign of the neighbours and NIS?",
    }
)

WRONG = (
    {
        "Q too small": (
            "Q too small",
            "With Q too small the gain is too small: neighbours would be alike, with a plus sign, and NIS above 2.",
        ),
        "R too large": (
            "R too large",
            "R too large agrees with NIS below 2. But it makes the gain too small, and neighbours alike: look at the sign.",
        ),
        "R too small": (
            "R too small",
            "R too small agrees with the minus sign. But then the filter would be far too sure, with NIS well above 2.",
        ),
    }
    | {" or ".join(pair): (set(pair), words) for pair, words in MYSTERIES.items()}
    | {
        "all four": (
            set(SUSPECTS),
            "The sign of the neighbours rules out two of the four, and NIS one of the other two.",
        ),
    }
)
