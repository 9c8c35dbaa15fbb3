"""Wrong answers to the exercises of lesson 19 about the tracker, each with the sentence that it gets."""

import numpy as np


def near(rows):
    return abs(rows - 210) < 1


WRONG = {}

WRONG["coast"] = {
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
}

WRONG["first_velocity"] = {
    "half": (
        lambda p, s, R, y: y / 2,
        "Half of the innovation is what p = s and R = 0 give. In general all three variances decide.",
    ),
    "position share": (
        lambda p, s, R, y: p / (p + s + R) * y,
        "You have p on top. The corner of F P Fᵀ is s: the velocity is corrected only as far as its own variance s allows.",
    ),
    "position gain": (
        lambda p, s, R, y: (p + s) / (p + s + R) * y,
        "That is the gain of the *place*. For the velocity take the corner of F P Fᵀ, which is s, over the same S.",
    ),
    "not predicted": (
        lambda p, s, R, y: s / (p + R) * y,
        "S is too small. After the prediction with F the variance of the place is p + s, because an uncertain velocity makes the place uncertain.",
    ),
    "no correlation": (
        lambda p, s, R, y: 0.0,
        "Zero would be right if P were not predicted first. F makes place and velocity correlated: the covariance in the corner becomes s.",
    ),
    "R forgotten": (
        lambda p, s, R, y: s / (p + s) * y,
        "That is right for R = 0: S = H P Hᵀ + R.",
    ),
    "all of it": (
        lambda p, s, R, y: y,
        "That takes the whole innovation for velocity, as if the starting place had been exact and R zero.",
    ),
    "deviations": (
        lambda p, s, R, y: np.sqrt(s) / np.sqrt(p + s + R) * y,
        "That is the root of the gain, times y, as if standard deviations were weighed. Gains are ratios of variances.",
    ),
    "sign": (
        lambda p, s, R, y: -s / (p + s + R) * y,
        "The sign: the ball is further left than expected (y < 0), so it is believed to move left.",
    ),
    "the gain alone": (
        lambda p, s, R, y: s / (p + s + R),
        "That is the gain. The velocity is the gain times the innovation y.",
    ),
    "own share": (
        lambda p, s, R, y: s / (s + R) * y,
        "That is right for p = 0. The variance of the place belongs in S: it keeps the velocity's gain small.",
    ),
    "place alone": (
        lambda p, s, R, y: p / (p + R) * y,
        "That is the gain of the place without any prediction. The velocity's share is the corner of F P Fᵀ, "
        "which is s, over S = p + s + R.",
    ),
    "twice s in S": (
        lambda p, s, R, y: s / (p + 2 * s + R) * y,
        "One s too many: the place's variance after the prediction is p + s, so S = p + s + R.",
    ),
    "R for s": (
        lambda p, s, R, y: R / (p + s + R) * y,
        "You have R on top. The corner of F P Fᵀ belongs there, which is s, the variance of the velocity.",
    ),
    "Q there": (
        lambda p, s, R, y: s / (p + s + R) * y / 2,
        "That is half of it. Nothing is shared between place and velocity: both get their own gain times y.",
    ),
}

WRONG["gravity"] = {
    "as published": (
        lambda rows: 6.0,
        "You return 6 in every trial, as published: gravity never sleeps, and a ball at rest is pushed into the floor.",
    ),
    "never": (
        lambda rows: 0.0,
        "You return 0 in every trial. Without gravity the ball flies straight: only a ball at rest is free of it.",
    ),
    "last row only": (
        lambda rows: 0.0 if near(rows)[-1] else 6.0,
        "You looked at the last frame only: a bouncing ball is near the floor for a frame as well.",
    ),
    "any": (
        lambda rows: 0.0 if near(rows).any() else 6.0,
        "One frame near the floor is enough for you: that is a bounce. All three must be near.",
    ),
    "NaN counts as near": (
        lambda rows: 6.0 if np.any(abs(rows - 210) >= 1) else 0.0,
        "A frame without a detection counts as near the floor with you: where nothing was seen, nothing is known to rest. Ask whether *all* three are near.",
    ),
    "mean": (
        lambda rows: 0.0 if near(np.mean(rows)) else 6.0,
        "A mean row near the floor may come from one above and one below: each of the three must be near.",
    ),
    "no change": (
        lambda rows: 0.0 if np.ptp(rows) < 1 else 6.0,
        "You ask whether the ball stays on its row, and not on which: only the floor was asked for.",
    ),
    "switched": (
        lambda rows: 6.0 if near(rows).all() else 0.0,
        "The two answers are exchanged: at rest 0, else 6.",
    ),
    "one side": (
        lambda rows: 0.0 if np.all(rows - 210 < 1) else 6.0,
        "Every ball above the floor counts as resting, as without the absolute value: rows count downwards.",
    ),
    "below the floor counts": (
        lambda rows: 0.0 if np.all(rows > 209) else 6.0,
        "A row of 211.5 counts as near with you. Within 1 px means on both sides: 209 < row < 211.",
    ),
    "mean of those seen": (
        lambda rows: 0.0 if near(np.nanmean(rows)) else 6.0,
        "A mean row near the floor may come from one above and one below, and it says nothing about a hidden "
        "frame: each of the three must be near.",
    ),
    "two pixels": (
        lambda rows: 0.0 if np.all(abs(rows - 210) < 2) else 6.0,
        "You return 0 also where one of the rows is 1.5 px off. Each must be less than 1 px from the floor.",
    ),
    "median": (
        lambda rows: 0.0 if near(np.median(rows)) else 6.0,
        "A median near the floor says that two of the rows may be near, or one above and one below. Each of the three must be near.",
    ),
    "first and last": (
        lambda rows: 0.0 if near(rows)[[0, -1]].all() else 6.0,
        "You looked at the first and the last frame. The one between must be near as well.",
    ),
    "last two": (
        lambda rows: 0.0 if near(rows)[1:].all() else 6.0,
        "You looked at the last two frames. All three must be near.",
    ),
    "rounded": (
        lambda rows: 0.0 if np.all(np.round(rows) == 210) else 6.0,
        "That is within half a pixel. One pixel was asked for: the absolute difference from 210, below 1.",
    ),
    "exactly": (
        lambda rows: 0.0 if np.all(rows == 210) else 6.0,
        "Of all trials only 210, 210, 210 gives 0. Within 1 px means: the absolute difference of each is below 1.",
    ),
    "three numbers": (
        lambda rows: np.where(near(rows), 0.0, 6.0),
        "You return one number for each frame. One push is wanted: 0 only if all three are near.",
    ),
    "two of three": (
        lambda rows: 0.0 if near(rows).sum() >= 2 else 6.0,
        "Two of three are enough for you. All three must be near: in a bounce two may be as well.",
    ),
}
