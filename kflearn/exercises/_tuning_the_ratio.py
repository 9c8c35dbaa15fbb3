"""Wrong answers to exercises of lesson 6, each with the sentence that it gets."""

SHEETS = [
    (2.5**2, "In (a) the sheet gives σ itself: R is its square."),
    (0.3**2, "In (b), 95 % of the readings lie within ±2σ: halve the 0.6 °C first, then square."),
    (0.25**2 / 3, "In (c) a reading is rounded by a quarter of a volt at most: R is the square of this limit, over 3."),
]


KNOWN = [  # for each sheet: what a number would mean
    {
        56.25: "In (a), 56.2 is (3 · 2.5)². The sheet gives one sigma: R is the square of 2.5 m, without the 3.",
        1.5625: "In (a), 1.56 is (2.5/2)², as if 2.5 m were 2σ. The sheet says one sigma.",
        0.6944: "In (a), 0.694 is (2.5/3)², as if 2.5 m were 3σ. The sheet says one sigma.",
        2.0833: "In (a), 2.08 is 2.5²/3, as for hard limits. The sheet gives σ itself: R is its square.",
    },
    {
        0.36: "In (b), 0.36 is 0.6², as if 0.6 °C were σ. It holds 95 % of the readings, which is 2σ: halve it first, then square.",
        0.3: "In (b), 0.3 °C is σ. R is its square.",
        0.12: "In (b), 0.12 is 0.6²/3, as if ±0.6 °C were hard limits. 5 % of the readings lie beyond: 0.6 °C is 2σ.",
        0.04: "In (b), 0.04 is (0.6/3)², as if 0.6 °C were 3σ. It holds 95 % of the readings, which is 2σ.",
        0.03: "In (b), 0.3 °C is σ already. The 3 below the line belongs to hard limits.",
    },
    {},
]


def sheet_by_sheet(answer):
    """Which of three variances are right, and what to look at in the others."""
    faults, good = [], []
    for letter, value, (right, words), known in zip("abc", answer, SHEETS, KNOWN, strict=True):
        if abs(value / right - 1) > 0.05:
            faults.append(next((told for number, told in known.items() if abs(value / number - 1) < 0.005), words))
        else:
            good.append(letter)
    right = f"({') and ('.join(good)}) {'is' if len(good) == 1 else 'are'} right. " if good else ""
    return f"{right}{' '.join(faults)}" if faults else None


def of_sigma(sigma):
    """What a σ would mean; one that is nearly √(P + Q) is that, with rounded numbers."""
    if abs(sigma - 0.23505) < 5e-4:
        return "That is σ before a reading, √(P + Q). After the reading P = K·R is left: take its root."
    return (
        f"σ = {sigma:.3g} °C is a variance of {sigma**2:.3g} °C², and as P = K·R it would need K = {4 * sigma**2:.3g}. "
        "Which K solves K² + qK − q = 0?"
    )
