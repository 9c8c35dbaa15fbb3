"""Lesson 19: ignore, inflate, estimate or consider a bias."""

import math

import numpy as np

from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "R is a variance. Which of the numbers you were given are standard deviations?",
        "The noise and the bias are independent, so their variances add.",
        "0.3² + 0.5² m².",
    ],
    wrong={
        "standard deviations added": (0.8, "You added the standard deviations; R is a variance, so square each first."),
        "sum squared": (
            0.64,
            "(0.3 + 0.5)² would be right if noise and bias always pushed the same way; they are independent.",
        ),
        "variance plus σ": (
            0.59,
            "You added the bias by its standard deviation, 0.09 + 0.5: metres to square metres. With σ = 1 m nobody notices.",
        ),
        "root": (math.sqrt(0.34), "That is the standard deviation of a reading. R is its square."),
        "bias alone": (0.25, "That is the bias alone; the white noise has not gone away."),
        "noise alone": (0.09, "That is R without any inflation: the bias is ignored."),
        "difference": (0.16, "Variances of independent errors add, whatever the sign of the errors."),
    },
    unit="m²",
)
def inflated():
    """R of the inflated filter for white noise with σ = 0.3 m and a bias with σ = 0.5 m."""
    return 0.3**2 + 0.5**2


@exercise(
    hints=[
        "First the gain: which variances does the innovation z − x̂ hold? Three of them.",
        "With P⁻ = diag(4, 1), H = [1, 1] and K = [K₁, 0], form (I − KH)P⁻(I − KH)ᵀ; KRKᵀ has nothing off the diagonal.",
        "C = −K₁ · 1, with K₁ = 4 / (4 + 1 + 0.25).",
    ],
    wrong={
        "sign": (
            4 / 5.25,
            "Mind the sign. A positive bias pulls the estimate up, so position *minus* estimate goes down.",
        ),
        "bias not in S": (
            -4 / 4.25,
            "Your innovation variance lacks the bias: S = 4 + 1 + 0.25. Then the filter would be deaf to what it considers.",
        ),
        "no covariance": (
            0.0,
            "It was zero before the reading. The reading brought the bias into the estimate, and so they hang together now.",
        ),
        "K times P": (
            -16 / 5.25,
            "You multiplied K by the variance of the position; what leaks into the estimate is the bias, variance 1.",
        ),
        "gain of the bias": (
            -1 / 5.25,
            "−1/5.25 holds the gain that the bias is not given. Multiply K₁ by the bias' variance.",
        ),
        "kept share": (
            1 - 4 / 5.25,
            "That is 1 − K₁, the part of the old position error that is kept. The question is what K₁ lets in.",
        ),
    },
    unit="m²",
)
def first_covariance():
    """The covariance of position and bias after the first consider correction: P⁻ = diag(4, 1), H = [1, 1], R = 0.25."""
    K = 4 / (4 + 1 + 0.25)
    return -K * 1


def averages(rng):
    """A number of readings, and the variances of noise and bias."""
    return int(rng.integers(2, 200)), float(rng.integers(1, 9) / 4), float(rng.integers(1, 9) / 2)


@exercise(
    hints=[
        "Write the average's error: the mean of N noises, plus the mean of N times the same bias.",
        "The mean of N equal numbers is that number. Only the noise becomes smaller.",
        "`return np.sqrt(R / N + B)`",
    ],
    inputs=averages,
    wrong={
        "inflated": (
            lambda N, R, B: math.sqrt((R + B) / N),
            "You divided the bias by N as well. That is the inflated filter: it takes N readings for N different biases.",
        ),
        "ignored": (lambda N, R, B: math.sqrt(R / N), "You left the bias out: that is the naive filter's claim."),
        "variance": (lambda N, R, B: R / N + B, "That is the variance; the standard deviation is its root."),
        "standard deviations added": (
            lambda N, R, B: math.sqrt(R / N) + math.sqrt(B),
            "Standard deviations of independent errors do not add; their variances do.",
        ),
        "nothing averaged": (
            lambda N, R, B: math.sqrt(R + B),
            "That is a single reading. The noise differs from reading to reading, so averaging does help against it.",
        ),
        "noise as N": (
            lambda N, R, B: math.sqrt(R / math.sqrt(N) + B),
            "A variance falls with N; it is the standard deviation that falls with √N.",
        ),
    },
)
def honest_average(N, R, B):
    """The standard deviation of the average of N readings that share one constant bias: noise variance R, bias B."""
    return math.sqrt(R / N + B)


def beliefs(rng):
    """A state of two numbers and a bias, its P, a reading, H, R, and which state is considered."""
    root = rng.integers(-3, 4, (3, 3)) / 2 + 2 * np.eye(3)
    x = rng.integers(-9, 10, 3).astype(float)
    H = np.array([[1.0, rng.integers(0, 3) / 2, 1.0]])
    considered = int(rng.choice([0, 2]))
    return x, root @ root.T, rng.integers(-9, 10, 1).astype(float), H, np.array([[rng.integers(1, 9) / 4]]), considered


def gain_of(P, H, R):
    """The ordinary gain."""
    return P @ H.T / (H @ P @ H.T + R)


def zeroed(K, considered):
    """The gain with its row of zeros."""
    K = K.copy()
    K[considered] = 0
    return K


def joseph(K, P, H, R):
    """(9J)."""
    keep = np.eye(3) - K @ H
    return keep @ P @ keep.T + K @ R @ K.T


def correct_with(form, mean_gain=None):
    """A correction as it should be, but for its covariance: form(K with its zero row, the ordinary K, P, H, R, c)."""

    def wrong(x, P, z, H, R, considered):
        full = gain_of(P, H, R)
        K = zeroed(full, considered)
        return x + (full if mean_gain == "full" else K) @ (z - H @ x), form(K, full, P, H, R, considered)

    return wrong


def without_cross(K, full, P, H, R, considered):
    """(9J), and then the covariances with the considered state are thrown away."""
    P = joseph(K, P, H, R)
    variance = P[considered, considered]
    P[considered], P[:, considered] = 0, 0
    P[considered, considered] = variance
    return P


def half_symmetric(K, full, P, H, R, considered):
    """(9) with the zero row, made symmetric."""
    P = (np.eye(3) - K @ H) @ P
    return (P + P.T) / 2


@exercise(
    hints=[
        "Which gain moves x, and which gain shrinks P? They must be the same one.",
        "So zero the row first. But then K is not the best gain any more, and (9) holds for the best gain only.",
        "Zero the row; then `keep = np.eye(3) - K @ H` and `P = keep @ P @ keep.T + K @ R @ K.T`.",
    ],
    inputs=beliefs,
    wrong={
        "as shown": (
            correct_with(lambda K, full, P, H, R, c: (np.eye(3) - full @ H) @ P),
            "P still shrinks by the full gain, as if the row had never been zeroed; x and P must use the same K.",
        ),
        "row first, plain form": (
            correct_with(lambda K, full, P, H, R, c: (np.eye(3) - K @ H) @ P),
            "The row is zeroed in time, but (9) holds for the best gain only. Your P is not even symmetric: use (9J).",
        ),
        "row first, symmetrised": (
            correct_with(half_symmetric),
            "Symmetrising hides that (9) is the wrong formula for this gain; half of the mistake stays in. Use (9J).",
        ),
        "never zeroed": (
            correct_with(lambda K, full, P, H, R, c: joseph(full, P, H, R), mean_gain="full"),
            "No row is zeroed: this estimates the state that should only be considered.",
        ),
        "KRKᵀ forgotten": (
            correct_with(lambda K, full, P, H, R, c: (np.eye(3) - K @ H) @ P @ (np.eye(3) - K @ H).T),
            "The term KRKᵀ is missing: the noise of the reading came in through K as well.",
        ),
        "cross-covariance dropped": (
            correct_with(without_cross),
            "You dropped the covariance of the considered state with the others. It is all that a consider filter is about.",
        ),
    },
)
def late_row(x, P, z, H, R, considered):
    """One consider correction: the state and its covariance after the reading z, with no gain for one state."""
    K = P @ H.T / (H @ P @ H.T + R)
    K[considered] = 0
    keep = np.eye(3) - K @ H
    return x + K @ (z - H @ x), keep @ P @ keep.T + K @ R @ K.T


def blocks(rng):
    """P of two states, their covariance C with a bias of variance B, and how both move."""
    root = rng.integers(-3, 4, (3, 3)) / 2 + 2 * np.eye(3)
    whole = root @ root.T
    F = np.array([[1.0, rng.integers(1, 9) / 8], [0.0, 1.0]])
    fading = float(rng.integers(1, 8) / 8)
    return whole[:2, :2], whole[:2, 2:], whole[2:, 2:], F, fading, np.eye(2) / 4, np.eye(1) / 2


def moved(cross):
    """A prediction in blocks that errs in C only."""
    return lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, cross(C, F, fading), fading**2 * B + q)


@exercise(
    hints=[
        "Lay out the whole F, with F at the upper left, `fading` at the lower right and zeros elsewhere. What is FPFᵀ?",
        "The error of the states is multiplied by F, that of the bias by `fading`. C is the mean of their product.",
        "`return F @ P @ F.T + Q, fading * F @ C, fading**2 * B + q`",
    ],
    inputs=blocks,
    wrong={
        "as shown": (
            moved(lambda C, F, fading: np.zeros_like(C)),
            "That is the program above: C is lost at every step, and the filter becomes the inflated one.",
        ),
        "unchanged": (
            moved(lambda C, F, fading: C),
            "C is kept, but it does not stand still: the states move with F, and the bias fades.",
        ),
        "not faded": (
            moved(lambda C, F, fading: F @ C),
            "The bias fades from step to step, and its covariance with the states fades with it: one factor is missing.",
        ),
        "only faded": (
            moved(lambda C, F, fading: fading * C),
            "The states have moved, too: an error in speed has become one in position. F is missing.",
        ),
        "faded twice": (
            moved(lambda C, F, fading: fading**2 * F @ C),
            "The bias stands once in C and twice in B: one factor `fading` for C.",
        ),
        "F twice": (
            moved(lambda C, F, fading: fading * F @ F @ C),
            "The states stand once in C: one F, on its left.",
        ),
        "transposed": (
            moved(lambda C, F, fading: fading * F.T @ C),
            "F without its transpose: the error of the states is Fe.",
        ),
    },
)
def economical(P, C, B, F, fading, Q, q):
    """The prediction in blocks: P of the states, C of states and bias, B of the bias."""
    return F @ P @ F.T + Q, fading * F @ C, fading**2 * B + q
