"""Lesson 23, `one_step_back`: wrong answers, each with the sentence that it gets."""

from kflearn.exercises._shown import show


def gain_of(belief):
    """What a number would mean that is in no row."""
    mean, variance = belief
    if abs(mean - 5.5) < 1e-6:
        return f"The mean is right. Your variance is 3 and {show(variance - 3, 3)} more: added to 3 is G² (2 − 4), with G = 3/4."
    return f"Your mean has moved by {show((mean - 4) / 2, 3)} times 6 − 4. The gain is G = P/P⁻ = 3/4; the variance is 3 + G² (2 − 4)."


WRONG = {
    "Q forgotten": (
        (6.0, 2.0),
        "That is the belief about step k+1, unchanged, as with G = 1. That holds for Q = 0 only; here G = 3/4.",
    ),
    "G = 1": (
        (6.0, 1.0),
        "That is right for G = 1: all of what was wrong at step k+1 would have been wrong at step k. Here Q = 1, and G = P/P⁻ = 3/4.",
    ),
    "G once in the variance, turned": (
        (5.5, 2.25),
        "The mean is right. 2.25 is G times the filter's 3. The variance is 3 + G² (2 − 4).",
    ),
    "gain upside down": (
        (4 + 8 / 3, 3 - 32 / 9),
        "Your gain is P⁻/P, and so the variance has become negative. It is P/P⁻ = 3/4.",
    ),
    "compared with the filter": (
        (5.5, 3 - 9 / 16),
        "The mean is right. Your variance is 3 + G² (2 − 3), with the filter's 3; compare 2 with the predicted 4.",
    ),
    "only Q added": (
        (6.0, 3.0),
        "That is N(6, 2) with Q added, as if walked back from step k+1. It forgets what the filter knew about step k, N(4, 3).",
    ),
    "fused with it": (
        (5.2, 1.2),
        "That is N(4, 3) fused with N(6, 2). But they are not two separate opinions: N(6, 2) already contains what the filter knew about step k. Compare N(6, 2) with the prediction N(4, 4).",
    ),
    "fused, with Q": (
        (5.0, 1.5),
        "That is N(4, 3) fused with N(6, 2 + 1). Q is in its place, but N(6, 2) already contains the filter's N(4, 3), which now counts twice. Use the gain G = 3/4 on the differences.",
    ),
    "G not squared": (
        (5.5, 1.5),
        "The mean is right. In the variance G stands on both sides, G (Pˢ − P⁻) Gᵀ: for a number that is G².",
    ),
    "variance added": (
        (5.5, 4.125),
        "The mean is right. In the variance it is Pˢ − P⁻ = 2 − 4: knowing more makes it smaller, not larger.",
    ),
    "filter's variance": (
        (5.5, 3.0),
        "The mean is right. The variance must fall too, for the end of the record tells something about step k.",
    ),
    "σ for the variance": (
        (5.5, 1.875**0.5),
        "Right up to the last step: that is the standard deviation, and the variance was asked for.",
    ),
    "swapped": (
        (1.875, 5.5),
        "The two numbers are right, in the wrong order: first the mean, then the variance.",
    ),
    "nothing learnt": (
        (4.0, 3.0),
        "That is the filter's belief about step k. The end of the record tells more: move it by G times what "
        "the prediction got wrong.",
    ),
    "variance of the next": (
        (5.5, 2.0),
        "The mean is right. 2 is the variance of step k+1; at step k it is 3 + G² (2 − 4).",
    ),
    "half way": (
        (5.0, 2.5),
        "That is the middle of N(4, 3) and N(6, 2). The gain says how far to go: G = P/P⁻ = 3/4.",
    ),
    "half way, variance of the next": (
        (5.0, 2.0),
        "5 is half way from 4 to 6. The gain says how far: G = P/P⁻ = 3/4; and the variance becomes 3 + G² (2 − 4).",
    ),
    "gain of Q": (
        (4.5, 2.875),
        "Your gain is Q/P⁻ = 1/4. It is the filter's own share, G = P/P⁻ = 3/4.",
    ),
    "sign": (
        (2.5, 1.875),
        "The variance is right. The mean moves towards what is known in the end: 6 − 4 is positive.",
    ),
    "only the change of the variance": (
        (5.5, 1.125),
        "The mean is right. 1.125 is what the variance loses, G² times 2; take it off 3.",
    ),
    "the mean alone": (
        5.5,
        "The mean is right. Hand in two numbers, `(mean, variance)`.",
    ),
    "gain with the next variance": (
        (4 + 3 / 5 * 2, 3 + (3 / 5) ** 2 * -2),
        "That is right for a gain of 3/(3 + 2), with the variance of the next step. The gain is P divided by the *predicted* variance, 3/4.",
    ),
    "gain of two thirds": (
        (4 + 2 / 3 * 2, 3 - 4 / 9 * 2),
        "Your gain is 2/3. It is the filter's variance by the predicted one: 3/4.",
    ),
    "next known exactly": (
        (5.5, 0.75),
        "The mean is right. Your variance is that for a step k+1 which is known exactly. It is known with variance 2: 3 + G² (2 − 4).",
    ),
    "from the prediction's variance": (
        (5.5, 2.875),
        "The mean is right. The variance begins with the filter's 3, not with the predicted 4: 3 + G² (2 − 4).",
    ),
    "from the next": (
        (7.5, 1.875),
        "The variance is right. The mean begins with the filter's 4, and moves by G times (6 − 4).",
    ),
    "gain of the roots": (
        (4 + 3**0.5, 3 - 1.5),
        "Your gain is √3/2. G is a ratio of variances, P/P⁻ = 3/4.",
    ),
    "variance not moved back": (
        (6.0, 1.875),
        "The variance is right. The mean moves by a part of 6 − 4 only: by G times.",
    ),
    "mean left alone": (
        (4, 1.875),
        "The variance is right. The mean moves too: add G times what the prediction missed, 6 − 4.",
    ),
    "plus P⁻": (
        (5.5, 3 + 0.75**2 * 6),
        "The mean is right. In the variance the predicted 4 is subtracted: G² (2 − 4).",
    ),
    "a reading": (
        (16 / 3, 4 / 3),
        "That is N(4, 4) fused with N(6, 2), so step k+1 again, and N(6, 2) holds N(4, 4) already. Step k is asked for: G = 3/4.",
    ),
    "from the next, towards the filter": (
        (4.5, 1.4375),
        "That begins with N(6, 2) and moves it towards N(4, 3). Step k is asked for: begin with the filter's "
        "N(4, 3), and compare N(6, 2) with the prediction N(4, 4).",
    ),
}
