"""Lesson 21, `economical`: wrong answers, each with the sentence that it gets."""

import numpy as np


def moved(cross):
    """A prediction in blocks that is wrong in C only."""
    return lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, cross(C, F, fading), fading**2 * B + q)


def in_blocks(cross):
    return lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, cross(C, F, fading, q), fading**2 * B + q)


def typed_step(dt):
    """C moved by an F that is typed in."""
    return lambda P, C, B, F, fading, Q, q: (
        F @ P @ F.T + Q,
        fading * np.array([C[0] + dt * C[1], *C[1:]]),
        fading**2 * B + q,
    )


def whole(P, C, B, F, fading, Q, q):
    """The prediction as one matrix."""
    return np.block([[F @ P @ F.T + Q, fading * F @ C], [fading * C.T @ F.T, fading**2 * B + q]])


WRONG = (
    {
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
        "F on both sides": (
            in_blocks(lambda C, F, fading, q: fading * F @ C @ F.T),
            "F stands in C once, on its left. On the right of C are the biases, which F does not move.",
        ),
        "q added": (
            in_blocks(lambda C, F, fading, q: fading * F @ C + q),
            "C gets no noise: what pushes the states and what renews the bias are independent.",
        ),
        "F on the right": (
            in_blocks(lambda C, F, fading, q: fading * C @ F.T),
            "F stands on the left of C, whose rows are the states.",
        ),
        "F on the right, not transposed": (
            in_blocks(lambda C, F, fading, q: fading * C @ F),
            "F stands on the left of C, whose rows are the states.",
        ),
        "first bias only": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C[:, :1], fading**2 * B + q),
            "P and B are right. C holds the first bias only: there may be more of them, one column for each.",
        ),
        "q faded": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C, fading**2 * (B + q)),
            "P and C are right. q is added after the fading: fading² B + q.",
        ),
        "P not transposed": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F + Q, fading * F @ C, fading**2 * B + q),
            "C and B are right. In P the second F is transposed: F P Fᵀ + Q.",
        ),
        "star": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F * C, fading**2 * B + q),
            "In C you multiply entry by entry, by `*`. The product of matrices is `@`: `fading * F @ C`.",
        ),
    }
    | {
        f"dt = {dt:g} typed in": (
            typed_step(dt),
            f"P and B are right. In C stands {dt:g} where F[0, 1] belongs, and no other entry of F: `fading * F @ C` holds for every F.",
        )
        for dt in (0.1, 1.0, 0.5, 0.05, 0.01, 2.0)
    }
    | {
        "the whole": (
            whole,
            "Your whole matrix is right. Cut it into its blocks and return these: with n = len(P) they are `big[:n, :n]`, `big[:n, n:]` and `big[n:, n:]`.",
        ),
        "B kept": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C, B),
            "P and C are right. B is kept as it was. A considered bias is not *estimated*, but it fades and is renewed: fading² · B + q.",
        ),
        "B before C": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading**2 * B + q, fading * F @ C),
            "All three are right. Return them in the order P, C, B.",
        ),
        "first bias alone": (
            lambda P, C, B, F, fading, Q, q: (F @ P @ F.T + Q, fading * F @ C[:, 0], fading**2 * B + q),
            "P and B are right. C has one column for each bias: take all of them.",
        ),
    }
)
