"""Lesson 8, `offset`: wrong answers, each with the sentence that it gets."""

import itertools


def summed(steps):
    """The offset after so many steps."""
    return lambda x1, K, dt: dt * x1 * sum((1 - K) ** j for j in range(1, steps + 1))


def grown(steps):
    """The offset after so many steps, of which the correction reduces only what is added."""
    return lambda x1, K, dt: steps * (1 - K) * dt * x1


RAMP = (
    "You take dt·x₁ away from x₁, as if the speaker walked by x₁ in each step. Here the speaker stays where they are, and "
    "each step pushes by dt·x₁ alone."
)


WRONG = (
    {
        "one push": (
            lambda x1, K, dt: dt * x1,
            "One step adds dt·x₁. The correction takes a part away, and what it leaves piles up.",
        ),
        "one push, corrected once": (
            lambda x1, K, dt: (1 - K) * dt * x1,
            "That is the offset after the first step. What is left of it is there when the next push comes: let it pile up until it rests.",
        ),
        "before the correction": (
            lambda x1, K, dt: dt * x1 / K,
            "That is the offset of the prediction; the correction leaves the part 1 − K of it.",
        ),
        "dt forgotten": (
            lambda x1, K, dt: x1 * (1 - K) / K,
            "dt is missing: one step adds dt·x₁, not x₁.",
        ),
        "K and 1 − K swapped": (
            lambda x1, K, dt: dt * x1 * K / (1 - K),
            "K and 1 − K have changed places: with K near 1 the correction takes nearly all of the push away, so the offset is small.",
        ),
        "negative": (
            lambda x1, K, dt: -dt * x1 * (1 - K) / K,
            "The sign: a rate that is stuck at a positive value pushes the estimate above the readings. Offset means estimate minus truth.",
        ),
        "divided by dt": (
            lambda x1, K, dt: x1 * (1 - K) / (K * dt),
            "You divided by dt; degrees per second times seconds give degrees.",
        ),
        "sum of pushes": (
            lambda x1, K, dt: dt * x1 / (1 - K),
            "That is for pushes of which the part K survives a correction; it is the part 1 − K.",
        ),
        "what is taken away": (
            lambda x1, K, dt: K * dt * x1,
            "K·dt·x₁ is what the first correction takes away; 1 − K is left of each push, and the pushes pile up.",
        ),
        "dt forgotten, before the correction": (
            lambda x1, K, dt: x1 / K,
            "Two things are missing: dt, and the factor 1 − K that the correction leaves.",
        ),
        "none": (
            lambda x1, K, dt: 0.0,
            "A zero offset would need a rate of zero, or a gain of 1. Here each step pushes by dt·x₁.",
        ),
        "1/K − K": (
            lambda x1, K, dt: dt * x1 * (1 / K - K),
            "(1 − K)/K is 1/K − 1, not 1/K − K.",
        ),
        "bracket": (
            lambda x1, K, dt: dt * x1 / K - 1,
            "A bracket is missing: dt·x₁ multiplies all of 1/K − 1.",
        ),
        "bracket above": (
            lambda x1, K, dt: dt * x1 * 1 - K / K,
            "A bracket is missing around 1 − K.",
        ),
        "plus below": (
            lambda x1, K, dt: dt * x1 * (1 - K) / (1 + K),
            "Below the line stands 1 + K. At rest offset = (1 − K)·(offset + dt·x₁): on the left offset·(1 − (1 − K)) is left, "
            "which is K times the offset.",
        ),
        "plus": (
            lambda x1, K, dt: dt * x1 * (1 + K) / K,
            "There is 1 + K above the line. The correction takes the part K away: 1 − K is left.",
        ),
        "K squared below": (
            lambda x1, K, dt: dt * x1 * (1 - K) / K**2,
            "You divided by K twice. Write down when the offset stays the same: what does one step add, what does the correction leave?",
        ),
        "squared above": (
            lambda x1, K, dt: dt * x1 * (1 - K) ** 2 / K,
            "You have the factor 1 − K twice. At rest each step adds one push, and one correction follows.",
        ),
        "half a push": (
            lambda x1, K, dt: dt * x1 * (1 - K) / (2 * K),
            "That is half of the offset: each step pushes by the whole dt·x₁.",
        ),
    }
    | {
        f"{steps} steps": (
            summed(steps),
            f"That is the offset after {steps} steps, when it is not yet at rest. Where does it end, after however many?",
        )
        for steps in (2, 3, 5, 10, 20, 30, 50, 100)
    }
    | {
        f"old offset kept, {steps} steps": (
            grown(steps),
            "The correction reduces the old offset too: off = (1 − K)·(off + dt·x₁). Else it grows for ever.",
        )
        for steps in itertools.chain(
            range(2, 21), (30, 40, 50, 80, 100, 150, 200, 250, 300, 400, 500, 1000, 2000, 5000, 10000)
        )
    }
    | {
        "2 − K": (
            lambda x1, K, dt: dt * x1 / (2 - K),
            "At rest offset = (1 − K)(offset + dt·x₁). On the left side 1 − (1 − K) remains, and that is K; on the right 1 − K.",
        ),
        "one step": (
            lambda x1, K, dt: dt * x1 - K * dt * x1 * K,
            "The old offset is missing. It is still there when dt·x₁ is added, and the correction leaves 1 − K of both.",
        ),
        "as on a ramp": (lambda x1, K, dt: (x1 - dt * x1) * (1 - K) / K, RAMP),
        "as on a ramp, the other sign": (lambda x1, K, dt: (dt * x1 - x1) * (1 - K) / K, RAMP),
        "as on a ramp, before the correction": (lambda x1, K, dt: (x1 - dt * x1) / K, RAMP),
    }
)
