"""Lesson 20, `mended_fix`: wrong answers, each with the sentence that it gets."""

import numpy as np


def updated(x, dx, K, fix):
    """The error state after the fix."""
    return dx + K @ (fix - x[:2] - dx[:2])


PARTLY = (
    "You fed back a part of the states. The sum x + dx is the same, but here all of dx is fed back: return "
    "x + dx and zeros."
)


def partly(which):
    """The feedback of some states only: `which` says of the indices which go back."""

    def fed_back(x, dx, K, fix):
        dx, back = dx + K @ (fix - x[:2] - dx[:2]), which(np.arange(len(x)))
        return x + back * dx, (1 - back) * dx

    return fed_back


def new_error(x, dx, K, fix):
    return dx + K @ (fix - x[:2] - dx[:2])


def told_before_the_fix(x, dx, K, fix):
    return x + dx, new_error(x + dx, dx, K, fix)


def told_twice(x, dx, K, fix):
    return x + 2 * new_error(x, dx, K, fix), 0 * dx


def position_zero(x, dx, K, fix):
    dx = new_error(x, dx, K, fix)
    return x + dx, np.append(np.zeros(2), dx[2:])


def twice(x, dx, K, fix):
    x = x + dx
    return x + K @ (fix - x[:2] - dx[:2]), 0 * dx


def position_alone(x, dx, K, fix):
    """The position goes to x, the rest stays in dx."""
    dx = dx + K @ (fix - x[:2] - dx[:2])
    told = np.append(dx[:2], 0 * dx[2:])
    return x + told, dx - told


WRONG = {
    "as published": (
        lambda x, dx, K, fix: (x, updated(x, dx, K, fix)),
        "That is the open loop again: dx is never added to x, so the tangents are taken further and further from the road.",
    ),
    "told twice": (
        lambda x, dx, K, fix: (x + updated(x, dx, K, fix), updated(x, dx, K, fix)),
        "The INS is right now. But dx still holds what x has been told already: the next fix would be corrected twice. Set it to zero.",
    ),
    "the old error fed back": (
        lambda x, dx, K, fix: (x + dx, 0 * dx),
        "You fed back the error state from before the fix: correct dx first, then add it.",
    ),
    "the old error forgotten": (
        lambda x, dx, K, fix: (x + K @ (fix - x[:2] - dx[:2]), 0 * dx),
        "You fed back only what this fix brought, and threw away what dx held before. Add the whole dx.",
    ),
    "innovation without dx": (
        lambda x, dx, K, fix: (x + dx + K @ (fix - x[:2]), 0 * dx),
        "The innovation compares the fix with x alone. A part of that difference is explained by dx already: subtract dx[:2] as well.",
    ),
    "fed back before the gain, and again": (
        lambda x, dx, K, fix: (x + dx + updated(x, dx, K, fix), 0 * dx),
        "In your x the old dx is added twice: the corrected dx holds it already.",
    ),
    "wrong sign": (
        lambda x, dx, K, fix: (x - updated(x, dx, K, fix), 0 * dx),
        "The sign: here dx is truth minus INS, so it is added to the INS.",
    ),
    "reset without telling": (
        lambda x, dx, K, fix: (x, 0 * dx),
        "The error state is zero, but it has not been added to x: the fix is lost.",
    ),
    "only the position": (
        lambda x, dx, K, fix: (x + np.append(updated(x, dx, K, fix)[:2], 0 * x[2:]), 0 * dx),
        "The position was told and the rest thrown away. Add the whole of dx: heading and faults are what bends.",
    ),
    "the output only": (
        lambda x, dx, K, fix: x + updated(x, dx, K, fix),
        "That is the output, and it is right. But the filter goes on with two states: return the INS's state and the error state.",
    ),
    "told the old, kept the new": (
        lambda x, dx, K, fix: (x + dx, updated(x, dx, K, fix)),
        "You told x the error state from before the fix and kept the corrected one. First correct dx, then "
        "add it to x, and what x has been told is zero in dx.",
    ),
    "dx left out": (
        lambda x, dx, K, fix: (x + K @ (fix - x[:2]), 0 * dx),
        "What dx held before the fix is lost, and the fix is compared with x alone. Correct dx first, as "
        "published; then add it to x.",
    ),
    "not reset": (
        lambda x, dx, K, fix: (x + updated(x, dx, K, fix), dx),
        "The INS is right now. But dx still holds the old error, which x has been told: set it to zero.",
    ),
    "only the news kept": (
        lambda x, dx, K, fix: (x + dx, K @ (fix - x[:2] - dx[:2])),
        "You split the correction in two and told x only the older part. Tell it all; then dx is zero.",
    ),
    "nothing subtracted": (
        lambda x, dx, K, fix: (x + dx + K @ (fix - x[:2] - dx[:2]), dx + K @ (fix - x[:2] - dx[:2]))[:1] * 2,
        "You returned the INS's state twice. The second result is the error state, which is zero after feeding back.",
    ),
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
    "told before the fix": (
        told_before_the_fix,
        "You added the old dx to x first, and kept dx all the same. So the old error is in both, and what the fix brought has not been told. Correct dx first, add it to x, and set it to zero.",
    ),
    "x corrected, dx kept": (
        lambda x, dx, K, fix: (x + K @ (fix - x[:2]), dx),
        "You corrected x as if there were no error state, and kept the old dx. Correct dx with the fix, as published; then add it to x and set it to zero.",
    ),
    "dx added in the innovation": (
        lambda x, dx, K, fix: (x + dx + K @ (fix - x[:2] + dx[:2]), 0 * dx),
        "The sign of dx in the innovation: the truth is believed at x + dx, so the fix is compared with that, fix − x[:2] − dx[:2].",
    ),
    "fix less dx alone": (
        lambda x, dx, K, fix: (x + dx + K @ (fix - dx[:2]), 0 * dx),
        "x is missing in the innovation: the fix is a position, and is compared with x[:2] + dx[:2].",
    ),
    "added twice": (
        told_twice,
        "You added dx to x twice. Once is enough; after that nothing is left in dx.",
    ),
    "the position's error alone is zero": (
        position_zero,
        "x is right now. But it has been told all of dx, not the position's part alone: all of dx is zero.",
    ),
    "dx kept": (
        lambda x, dx, K, fix: (x + K @ (fix - x[:2] - dx[:2]), dx),
        "You gave x what this fix brings, and left the old dx beside it. Add all of dx, then set dx to zero.",
    ),
    "dx off twice": (
        twice,
        "Your x holds dx already, and you subtract dx[:2] from the fix once more: compare the fix with x + dx once.",
    ),
    "position alone": (
        position_alone,
        "Only the position is fed back here. The sum x + dx is the same, but all of dx is wanted in x: return x + dx and zeros.",
    ),
}
