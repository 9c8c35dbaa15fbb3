"""More wrong answers to exercises of lesson 20, each with the sentence that it gets."""

import numpy as np

from kflearn.exercises._slips_tracking import SLIPS, chosen_but


def partly(which):
    """The feedback of some states only: `which` says of the indices which go back."""

    def fed_back(x, dx, K, fix):
        dx, back = dx + K @ (fix - x[:2] - dx[:2]), which(np.arange(len(x)))
        return x + back * dx, (1 - back) * dx

    return fed_back


PARTLY = (
    "You fed back a part of the states. The sum x + dx is the same, but here all of dx is fed back: return "
    "x + dx and zeros."
)
GOES_BACK = {
    "everything": (
        [1, 1, 1, 1, 1],
        "That gives the closed loop's answer. But some of the five stand nowhere in F, so they need not go back.",
    ),
    "nothing": (
        [0, 0, 0, 0, 0],
        "That is the open loop: here a product and a sine and cosine bend the motion, so it gives another answer.",
    ),
    "the bias too": (
        [0, 0, 1, 1, 1],
        "Enough, but one too many: b enters only by ψ + w − b, a straight line whose slope is −1 wherever it is drawn.",
    ),
    "heading alone": (
        [0, 0, 1, 0, 0],
        "ψ bends, yes. But it is multiplied by 1 + s: the slope with respect to ψ is −(1 + s)·d·sin ψ, and needs the right s too.",
    ),
    "scale alone": (
        [0, 0, 0, 0, 1],
        "The scale stands in F, yes. But so does ψ, inside the sine and cosine.",
    ),
    "the sensors' faults": (
        [0, 0, 0, 1, 1],
        "Not enough: the heading itself stays wrong in the INS, and F is taken at the state of the INS.",
    ),
    "the position": (
        [1, 1, 0, 0, 0],
        "The other way round: F does not depend on east and north, so F moves a metre in the same way whether it is in the INS or in the error state.",
    ),
    "position and heading": (
        [1, 1, 1, 0, 0],
        "ψ must, east and north need not: they are only added to. And one more stands in F: look at what multiplies d.",
    ),
    "all but the bias": (
        [1, 1, 1, 0, 1],
        "Enough, but two too many: east and north are only added to, and stand nowhere in F.",
    ),
    "the other ones": (
        [1, 1, 0, 1, 0],
        "You marked those that need not go back. The question asks for those that must go back: the states that stand in F.",
    ),
    "the bias alone": (
        [0, 0, 0, 1, 0],
        "b enters only by ψ + w − b, along a straight line, and stands nowhere in F. Which two of the five stand there?",
    ),
    "heading and bias": (
        [0, 0, 1, 1, 0],
        "ψ is one of them. b enters along a straight line and may stay; but look at what multiplies d.",
    ),
    "halves": (
        [0, 0, 0.5, 0, 0.5],
        "The two are right. Mark them with 1: each goes back or not.",
    ),
} | SLIPS["goes_back"]
MORE = {
    "goes_back": GOES_BACK | chosen_but(GOES_BACK),
    "all_bias": SLIPS["all_bias"],
    "dark_time": SLIPS["dark_time"],
    "mended_fix": {
        "from index 4 on": (partly(lambda i: i >= 4), PARTLY),
        "after index 4": (partly(lambda i: i > 4), PARTLY),
        "before index 4": (partly(lambda i: i < 4), PARTLY),
        "index 4 alone": (partly(lambda i: i == 4), PARTLY),
        "from index 2 on": (partly(lambda i: i >= 2), PARTLY),
        "half of it": (
            partly(lambda i: 0.5),
            "You fed back a half. What x has been told is zero in dx only if all of dx was added.",
        ),
        "dx turned round": (
            lambda x, dx, K, fix: (
                x + dx + K @ (fix - x[:2] - dx[:2]),
                -dx - K @ (fix - x[:2] - dx[:2]),
            ),
            "The INS is right now. In dx nothing is left of what x has been told: it is zero, not minus dx.",
        ),
        "the fix itself": (
            lambda x, dx, K, fix: (np.append(fix, (x + dx)[2:]), 0 * dx),
            "You set the position to the fix. The fix has an error of its own: correct dx with the gain K, then add it to x.",
        ),
    },
}
