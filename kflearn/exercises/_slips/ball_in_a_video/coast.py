"""Lesson 19, `coast`: wrong answers, each with the sentence that it gets."""

import numpy as np

BORN_AGAIN = "That is born again, only with a wide P. The ball is not forgotten: go on from x and P."


WRONG = (
    {
        "as published": (
            lambda x, P, F, push, Q: (0 * x, P),
            "That is the published fault again: the state becomes zero, which is far from the ball, and P still claims a small error.",
        ),
        "zeros, P predicted": (
            lambda x, P, F, push, Q: (0 * x, F @ P @ F.T + Q),
            "P is right now. The state is still thrown away: a hidden ball flies on.",
        ),
        "push on zeros": (
            lambda x, P, F, push, Q: (push, F @ P @ F.T + Q),
            "P is right. The state is the push alone, as if it still started from zeros: begin with x.",
        ),
        "P left": (
            lambda x, P, F, push, Q: (F @ x + push, P),
            "The state is right. P is left as it was: after each unseen frame the filter must be less sure.",
        ),
        "only Q added": (
            lambda x, P, F, push, Q: (F @ x + push, P + Q),
            "The state is right. P needs F as well: an uncertain velocity makes the place more uncertain in every frame.",
        ),
        "Q carried on": (
            lambda x, P, F, push, Q: (F @ x + push, F @ (P + Q) @ F.T),
            "The state is right. Your P is F (P + Q) Fᵀ. Q is what happens *in* this step, so it is added after P has been moved, F P Fᵀ + Q.",
        ),
        "Q forgotten": (
            lambda x, P, F, push, Q: (F @ x + push, F @ P @ F.T),
            "The state is right. P lacks Q: F alone claims that nothing unforeseen can happen behind the wall.",
        ),
        "gravity forgotten": (
            lambda x, P, F, push, Q: (F @ x, F @ P @ F.T + Q),
            "P is right. The state is not pushed: gravity does not stop while nobody looks.",
        ),
        "frozen": (
            lambda x, P, F, push, Q: (x, P),
            "You kept the old state and the old P. But the ball moves on while it is hidden.",
        ),
        "frozen, P predicted": (
            lambda x, P, F, push, Q: (x, F @ P @ F.T + Q),
            "P is right. The state stands still: it must move with F and be pushed.",
        ),
        "transposed": (
            lambda x, P, F, push, Q: (F @ x + push, F.T @ P @ F + Q),
            "The state is right. In P the transposed F belongs on the right: F P Fᵀ.",
        ),
        "F only once": (
            lambda x, P, F, push, Q: (F @ x + push, F @ P + Q),
            "The state is right. P needs F on both sides, F P Fᵀ, or it is not even symmetric.",
        ),
        "pushed before": (
            lambda x, P, F, push, Q: (F @ (x + push), F @ P @ F.T + Q),
            "P is right. Your state is F (x + push), with the push carried through F. It is F x + push.",
        ),
        "push subtracted": (
            lambda x, P, F, push, Q: (F @ x - push, F @ P @ F.T + Q),
            "P is right. The sign of the push: rows count downwards, so gravity is added.",
        ),
        "no push, no Q": (
            lambda x, P, F, push, Q: (F @ x, F @ P @ F.T),
            "Both are moved with F. The state must be pushed as well, and P must grow by Q.",
        ),
        "F for its transpose": (
            lambda x, P, F, push, Q: (F @ x + push, F @ P @ F + Q),
            "The state is right. In P the second F is transposed: F P Fᵀ.",
        ),
        "nothing but Q": (
            lambda x, P, F, push, Q: (x, P + Q),
            "The state must move with F and be pushed, and P needs F on both sides before Q is added.",
        ),
        "pushed, not moved": (
            lambda x, P, F, push, Q: (x + push, F @ P @ F.T + Q),
            "P is right. The state was pushed but not moved: its velocity carries it on, F x + push.",
        ),
        "the state alone": (
            lambda x, P, F, push, Q: F @ x + push,
            "The state is right. Return two things: the state, and then its covariance.",
        ),
        "zeros, no push, P grown": (
            lambda x, P, F, push, Q: (0 * x, P + Q),
            "The state is still thrown away: a hidden ball flies on, F x + push. And P needs F on both sides.",
        ),
        "push twice": (
            lambda x, P, F, push, Q: (F @ x + 2 * push, F @ P @ F.T + Q),
            "P is right. You pushed twice: once a frame is enough.",
        ),
        "four zeros": (
            lambda x, P, F, push, Q: (np.zeros(4), F @ P @ F.T + Q),
            "P is right. The state becomes zero, as published, though the ball flies on: it is F x + push. (And the trials have several sizes, not four states.)",
        ),
        "four zeros, P kept": (
            lambda x, P, F, push, Q: (np.zeros(4), P),
            "That is the published fault again: the state becomes zero, and P still claims a small error. (And the trials have several sizes, not four states.)",
        ),
        "P given up": (
            lambda x, P, F, push, Q: (F @ x + push, 1e4 * np.eye(len(x))),
            "The state is right. But you threw P away: the filter knows more than that. P grows from what it was, F P Fᵀ + Q.",
        ),
    }
    | {
        f"born again, {wide:g}": (
            lambda x, P, F, push, Q, wide=wide: (np.zeros(len(x)), wide * np.eye(len(x))),
            BORN_AGAIN,
        )
        for wide in (10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e8)
    }
    | {
        "push squared": (
            lambda x, P, F, push, Q: (F @ x + push, F @ P @ F.T + Q + np.outer(push, push)),
            "The state is right. The push is known, so it moves the state and adds no uncertainty to P.",
        ),
    }
)
