"""Wrong answers to exercises of lesson 21, each with the sentence that it gets."""

import math

import numpy as np


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
    keep = np.eye(len(P)) - K @ H
    return keep @ P @ keep.T + K @ R @ K.T


def correct_with(form, mean_gain=None):
    """A correction as it should be, but for its covariance: form(K with its zero row, the ordinary K, P, H, R, c)."""

    def wrong(x, P, z, H, R, considered):
        full = gain_of(P, H, R)
        K = zeroed(full, considered)
        return x + (full if mean_gain == "full" else K) @ (z - H @ x), form(K, full, P, H, R, considered)

    return wrong


def correct_always_third(x, P, z, H, R, considered):
    """A consider correction that does not ask which state is considered."""
    return correct_with(lambda K, full, P, H, R, c: joseph(K, P, H, R))(x, P, z, H, R, 2)


def without_row(P, considered):
    """Row and column of the considered state are zero."""
    P = P.copy()
    P[considered], P[:, considered] = 0, 0
    return P


def without_cross(K, full, P, H, R, considered):
    """(9J), and then the covariances with the considered state are thrown away."""
    P = joseph(K, P, H, R)
    variance = P[considered, considered]
    P[considered], P[:, considered] = 0, 0
    P[considered, considered] = variance
    return P


def half_symmetric(K, full, P, H, R, considered):
    """(9) with the zero row, made symmetric."""
    P = (np.eye(len(P)) - K @ H) @ P
    return (P + P.T) / 2


def moved(cross):
    """A prediction in blocks that is wrong in C only."""
    return lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, cross(C, F, fading), fading**2 * B + q)


WRONG = {}

WRONG["honest_average"] = {
    "inflated": (
        lambda N, R, B: math.sqrt((R + B) / N),
        "That is √((R + B)/N), with the bias divided by N as well. It is the inflated filter: it takes N readings for N different biases.",
    ),
    "ignored": (lambda N, R, B: math.sqrt(R / N), "That is √(R/N), the naive filter's claim, without the bias."),
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
    "all over N": (
        lambda N, R, B: math.sqrt(R + B) / N,
        "That is √(R + B)/N, with the bias divided by N as well. The noise's variance falls as R / N; the bias does not fall.",
    ),
    "bias falls faster": (
        lambda N, R, B: math.sqrt(R / N + B / N**2),
        "Here the bias falls with N. All N readings share one bias: its mean is the bias itself.",
    ),
    "noise over N squared": (
        lambda N, R, B: math.sqrt(R / N**2 + B),
        "The bias is right. The variance of a mean of N independent noises is R / N, not R / N²: N variances add,"
        " and the sum is divided by N².",
    ),
    "σ of the noise over N": (
        lambda N, R, B: math.sqrt(R) / N + math.sqrt(B),
        "Two things: the noise's σ falls with √N, and standard deviations do not add. Add R / N and B, then take "
        "the root.",
    ),
    "bias squared": (
        lambda N, R, B: math.sqrt(R / N + B**2),
        "B is a variance already: do not square it.",
    ),
    "both squared": (
        lambda N, R, B: math.sqrt(R**2 / N + B**2),
        "R and B are variances already: do not square them.",
    ),
    "bias alone": (
        lambda N, R, B: math.sqrt(B),
        "That is what remains when N is very large. The noise still counts: R / N.",
    ),
    "bias averaged": (
        lambda N, R, B: math.sqrt(R + B / N),
        "The other way round: the noise differs from reading to reading and is averaged; the bias is the same in "
        "all of them.",
    ),
    "mixed": (
        lambda N, R, B: math.sqrt(R / N) + B,
        "A standard deviation and a variance are added here. Add the variances R / N and B, then take the root over the whole sum.",
    ),
}

WRONG["late_row"] = {
    "as shown": (
        correct_with(lambda K, full, P, H, R, c: (np.eye(len(P)) - full @ H) @ P),
        "P still shrinks by the full gain, as if the row had never been zeroed; x and P must use the same K.",
    ),
    "row first, plain form": (
        correct_with(lambda K, full, P, H, R, c: (np.eye(len(P)) - K @ H) @ P),
        "The row is zeroed in time, but (9) holds for the best gain only. Your P is not even symmetric: use (9J).",
    ),
    "row first, symmetrised": (
        correct_with(half_symmetric),
        "Symmetrising hides that (9) is the wrong formula for this gain; half of the mistake stays in. Use (9J).",
    ),
    "never zeroed": (
        correct_with(lambda K, full, P, H, R, c: joseph(full, P, H, R), mean_gain="full"),
        "x and P are those of the full gain, as if no row were zeroed. Zero it first: the state is not to be estimated.",
    ),
    "KRKᵀ forgotten": (
        correct_with(lambda K, full, P, H, R, c: (np.eye(len(P)) - K @ H) @ P @ (np.eye(len(P)) - K @ H).T),
        "The term KRKᵀ is missing: the noise of the reading came in through K as well.",
    ),
    "cross-covariance dropped": (
        correct_with(without_cross),
        "In your P the covariance of the considered state with the others is zero. A consider filter works through this covariance.",
    ),
    "always the third": (
        correct_always_third,
        "In your code the same state is considered each time. The argument `considered` says which state it is.",
    ),
    "P left": (
        correct_with(lambda K, full, P, H, R, c: P),
        "The state is right. P must change as well: the other states have learnt something from the reading.",
    ),
    "K S Kᵀ": (
        correct_with(lambda K, full, P, H, R, c: P - K @ (H @ P @ H.T + R) @ K.T),
        "That is P − K S Kᵀ, with the row and the column of the considered state as they were before the reading. It holds for the best gain only, like (9): after the row is zeroed use (9J).",
    ),
    "x with the full gain": (
        correct_with(lambda K, full, P, H, R, c: joseph(K, P, H, R), mean_gain="full"),
        "P is right. The state still moves by the full gain, with the considered state: zero the row before you use K.",
    ),
    "column zeroed in P": (
        correct_with(lambda K, full, P, H, R, c: without_row((np.eye(len(P)) - full @ H) @ P, c)),
        "Row and column of the considered state are zero in your P. It keeps its variance, and the filter needs "
        "its covariances.",
    ),
}

WRONG["economical"] = {
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
    "q in C": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C + q.sum(), fading**2 * B + q),
        "P and B are right. C gets no noise: what pushes the states and what renews the bias are independent.",
    ),
    "C transposed": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * C.T @ F.T, fading**2 * B + q),
        "P and B are right. C is transposed: it has one row for each state and one column for each bias.",
    ),
    "what is lost": (
        moved(lambda C, F, fading: (1 - fading) * F @ C),
        "P and B are right. 1 − fading is what fades in a step; what stays is fading · F C.",
    ),
    "root of fading": (
        moved(lambda C, F, fading: fading**0.5 * F @ C),
        "P and B are right. The bias is multiplied by `fading`, not by its root, and stands once in C.",
    ),
    "the largest q in C": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C + q.max(), fading**2 * B + q),
        "P and B are right. C gets no noise: what pushes the states and what renews the bias are independent.",
    ),
    "Q twice": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + 2 * Q, fading * F @ C, fading**2 * B + q),
        "C and B are right. Your P is F P Fᵀ + 2Q: Q is added once.",
    ),
    "C in P": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q + C @ C.T, fading * F @ C, fading**2 * B + q),
        "C and B are right. P does not hold C: the bias moves no state in this prediction.",
    ),
    "C first": (
        lambda P, C, B, F, fading, Q, q: (fading * F @ C, F @ P @ F.T + Q, fading**2 * B + q),
        "All three are right, in the wrong order: P, C, B.",
    ),
    "B faded once": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C, fading * B + q),
        "P and C are right. The bias stands twice in its own variance: fading² B.",
    ),
    "B not faded": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C, B + q),
        "P and C are right. The bias fades, and its variance with it: fading² B + q.",
    ),
    "P not moved": (
        lambda P, C, B, F, fading, Q, q: (P + Q, fading * F @ C, fading**2 * B + q),
        "C and B are right. The states move, and their covariance with them: F P Fᵀ + Q.",
    ),
    "C alone": (
        lambda P, C, B, F, fading, Q, q: fading * F @ C,
        "C is right. Return all three blocks, P, C and B, in this order.",
    ),
    "Q forgotten": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T, fading * F @ C, fading**2 * B + q),
        "C and B are right. P lacks Q.",
    ),
    "q forgotten": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C, fading**2 * B),
        "P and C are right. B lacks q, its fresh variance.",
    ),
    "divided": (
        lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, F @ C / fading, fading**2 * B + q),
        "Your C is F C/fading. The bias becomes smaller with each step, and its covariance with the states too: multiply.",
    ),
}
