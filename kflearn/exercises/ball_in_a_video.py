"""Lesson 17: a ball in a video."""

import numpy as np
from scipy import ndimage

from kflearn.exercises._ball_in_a_video import WRONG
from kflearn.exercises.engine import exercise


def a_picture(rng):
    """A ball, something smaller, a long thin cable and stray pixels, (60, 80)."""
    rows, columns = np.mgrid[:60, :80]
    row, column, radius = rng.uniform(14, 30), rng.uniform(15, 45), rng.uniform(7, 9.5)
    ball = np.hypot(rows - row, columns - column) < radius
    other = np.hypot(rows - rng.uniform(12, 30), columns - rng.uniform(66, 72)) < rng.uniform(4, 5)
    stray = rng.random(rows.shape) < 0.01
    return (ball | other | (abs(rows - 50.5) < 2) | stray,)


@exercise(
    hints=[
        "Two questions, two pictures: *which* region is the ball is answered after the erosions, *how large* it is before them.",
        "Find the eroded ball as in the lesson. Then label `differs` itself: the eroded ball's pixels all carry one label there.",
        "`ndimage.binary_propagation(ball, mask=differs)` grows a region until it fills what it hangs together with in the mask.",
        "`whole, _ = ndimage.label(differs)`, then count `whole == whole[ball][0]`, where `ball` is the eroded ball.",
    ],
    inputs=a_picture,
    wrong=WRONG["true_radius"],
)
def true_radius(differs):
    """The radius of the ball from all pixels that hang together with it in `differs`, True where a pixel differs."""
    eroded = ndimage.binary_erosion(differs, np.ones((3, 3)), iterations=2)
    labels, _ = ndimage.label(eroded)
    ball = labels == 1 + np.bincount(labels.ravel())[1:].argmax()
    whole, _ = ndimage.label(differs)
    return np.sqrt((whole == whole[ball][0]).sum() / np.pi)


def a_gap(rng):
    """A state, its covariance, F, what pushes, and Q."""
    root = rng.integers(-3, 4, (4, 4)) / 2
    F = np.kron([[1, 1], [0, 1]], np.eye(2))
    return (
        rng.integers(-9, 200, 4).astype(float),
        root @ root.T + np.eye(4),
        F,
        np.array([0, rng.integers(1, 7) / 2, 0, rng.integers(1, 7)]),
        np.diag(rng.integers(1, 5, 4) / 10),
    )


@exercise(
    hints=[
        "Nothing is seen. What does the filter do in every frame *before* it looks?",
        "The state moves with F and is pushed, eq (5). The covariance moves with F on both sides and grows by Q, eq (6).",
        "`return F @ x + push, F @ P @ F.T + Q`",
    ],
    inputs=a_gap,
    wrong={
        "as published": (
            lambda x, P, F, push, Q: (np.zeros(4), P),
            "That is the published fault again: a state of zeros, which nobody believes, and a P that says otherwise.",
        ),
        "zeros, P predicted": (
            lambda x, P, F, push, Q: (np.zeros(4), F @ P @ F.T + Q),
            "P is right now. The state is still thrown away: a hidden ball flies on.",
        ),
        "push on zeros": (
            lambda x, P, F, push, Q: (push, F @ P @ F.T + Q),
            "P is right. The state still starts from zeros and is pushed from there: begin with x.",
        ),
        "P left": (
            lambda x, P, F, push, Q: (F @ x + push, P),
            "The state is right. P is left as it was: after each unseen frame the filter must be less sure.",
        ),
        "only Q added": (
            lambda x, P, F, push, Q: (F @ x + push, P + Q),
            "The state is right. P needs F as well: an uncertain velocity makes the place more uncertain in every frame.",
        ),
        "Q forgotten": (
            lambda x, P, F, push, Q: (F @ x + push, F @ P @ F.T),
            "The state is right. In P you forgot Q: F alone claims that nothing unforeseen can happen behind the wall.",
        ),
        "gravity forgotten": (
            lambda x, P, F, push, Q: (F @ x, F @ P @ F.T + Q),
            "P is right. The state is not pushed: gravity does not stop while nobody looks.",
        ),
        "frozen": (
            lambda x, P, F, push, Q: (x, P),
            "You hold the old belief. That is the last detection held: the ball moves on.",
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
            "P is right. You pushed before you moved, so the push is carried through F a second time: F x + push.",
        ),
        "push subtracted": (
            lambda x, P, F, push, Q: (F @ x - push, F @ P @ F.T + Q),
            "P is right. The sign of the push: rows count downwards, so gravity is added.",
        ),
    },
)
def coast(x, P, F, push, Q):
    """State and covariance after a frame without a detection; push is B u."""
    return F @ x + push, F @ P @ F.T + Q


def a_start(rng):
    """Variances of place and velocity, R, and the first innovation."""
    p, s = rng.integers(1, 50, 2) * 4.0
    return p, s, float(rng.integers(1, 9)), float(rng.integers(-99, -9))


@exercise(
    hints=[
        "One step by hand: P = diag(p, s), predict it with F, then the second number of the gain.",
        "F P Fᵀ = [[p + s, s], [s, s]]: an uncertain velocity makes the place uncertain, and ties the two together.",
        "The gain on the velocity is the corner of that matrix over S = p + s + R.",
        "`return s / (p + s + R) * y`",
    ],
    inputs=a_start,
    wrong={
        "half": (
            lambda p, s, R, y: y / 2,
            "Half of the innovation is what p = s gives, whatever both are. In general it is their ratio that decides.",
        ),
        "position share": (
            lambda p, s, R, y: p / (p + s + R) * y,
            "You have p on top. The corner of F P Fᵀ is s: only the doubt about the velocity can move the velocity.",
        ),
        "position gain": (
            lambda p, s, R, y: (p + s) / (p + s + R) * y,
            "That is the gain of the *place*. For the velocity take the corner of F P Fᵀ, which is s, over the same S.",
        ),
        "not predicted": (
            lambda p, s, R, y: s / (p + R) * y,
            "S is too small: predicted with F, the place's variance is p + s, for the velocity's doubt has become a doubt about the place.",
        ),
        "no correlation": (
            lambda p, s, R, y: 0.0,
            "Zero would be true if P were not predicted first: F ties place and velocity together, the corner becomes s.",
        ),
        "R forgotten": (
            lambda p, s, R, y: s / (p + s) * y,
            "You forgot R: S = H P Hᵀ + R.",
        ),
        "all of it": (
            lambda p, s, R, y: y,
            "That takes the whole innovation for velocity, as if the starting place had been exact and R zero.",
        ),
        "deviations": (
            lambda p, s, R, y: np.sqrt(s) / np.sqrt(p + s + R) * y,
            "You weighed with standard deviations. Gains are ratios of variances.",
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
            "You left the place's own doubt p out of S; it is the larger part, and what protects the velocity.",
        ),
    },
)
def first_velocity(p, s, R, y):
    """The velocity believed after the first innovation y: start with 0, variances p (place) and s (velocity), no Q."""
    return s / (p + s + R) * y


def three_rows(rng):
    """Rows of the last three frames: at rest, bouncing, about the floor, hidden for a frame, high up."""
    kind = rng.integers(0, 6)
    rows = 210 + rng.integers(-9, 10, 3) / 20
    if kind == 1:
        rows[rng.integers(0, 3)] -= rng.integers(2, 40)
    elif kind == 2:
        rows[[0, 2]] += [-3.0, 3.0]
    elif kind == 3:
        rows[rng.integers(0, 3)] = np.nan
    elif kind == 4:
        rows -= rng.integers(20, 150)
    elif kind == 5:
        rows[:2] -= rng.integers(2, 40, 2)
    return (rows,)


def near(rows):
    return abs(rows - 210) < 1


@exercise(
    hints=[
        "Three conditions that must hold together, and a NaN must not count as near the floor.",
        "`abs(rows - 210) < 1` gives three truth values; a comparison with NaN is always False. Which function wants them all?",
        "`return 0.0 if np.all(abs(rows - 210) < 1) else 6.0`",
    ],
    inputs=three_rows,
    wrong={
        "as published": (
            lambda rows: 6.0,
            "That is the published gravity, which never sleeps: a ball at rest is pushed into the floor.",
        ),
        "never": (
            lambda rows: 0.0,
            "Without any gravity the ball flies straight: only a ball at rest is free of it.",
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
            "Without the absolute value every ball above the floor counts as resting: rows count downwards.",
        ),
    },
)
def gravity(rows):
    """The push on the row's velocity: 0 if the last three rows (NaN: not seen) were within 1 px of 210, else 6."""
    return 0.0 if np.all(abs(rows - 210) < 1) else 6.0
