"""Lesson 21: smoothing."""

import numpy as np

from kflearn.exercises.engine import exercise


@exercise(
    hints=[
        "First the gain: which part of what the prediction got wrong was wrong at step k already? G = P F / P⁻, with F = 1.",
        "G = 3/4. The mean moves by G times (known in the end − predicted); the variance changes by G² times a difference.",
        "`(4 + 3/4 * (6 - 4), 3 + (3/4)**2 * (2 - 4))`",
    ],
    wrong={
        "Q forgotten": (
            (6.0, 2.0),
            "You carried the knowledge about step k+1 over unchanged, G = 1. That holds for Q = 0 only; here G = 3/4.",
        ),
        "only Q added": (
            (6.0, 3.0),
            "You walked back from step k+1 and added Q. That forgets what the filter knew about step k, N(4, 3).",
        ),
        "fused with it": (
            (5.2, 1.2),
            "You fused N(4, 3) with N(6, 2). But they are not two separate opinions: N(6, 2) already contains what the "
            "filter knew about step k. Compare N(6, 2) with the prediction N(4, 4).",
        ),
        "fused, with Q": (
            (5.0, 1.5),
            "You fused N(4, 3) with N(6, 2 + 1). Q is in its place, but N(6, 2) already contains the filter's N(4, 3), "
            "which now counts twice. Use the gain G = 3/4 on the differences.",
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
    },
)
def one_step_back():
    """Filtered N(4, 3), Q = 1, predicted N(4, 4), known in the end about the next step N(6, 2): (mean, variance)?"""
    gain = 3 / 4
    return 4 + gain * (6 - 4), 3 + gain**2 * (2 - 4)


def covariance(rng, n):
    factor = rng.integers(-2, 3, (n, n)) / 2 + 1.5 * np.eye(n)
    return factor @ factor.T + np.eye(n) / 2


def steps_back(rng):
    """A belief, a model with a lopsided F, and a smoothed belief about the next step that is surer than predicted."""
    n = int(rng.integers(2, 4))
    P, Q, F = covariance(rng, n), covariance(rng, n) / 2, np.eye(n) + np.triu(rng.integers(1, 4, (n, n)) / 4, 1)
    x, x_next = rng.integers(-9, 10, (2, n)) / 2
    return x, P, F, Q, x_next, 0.4 * (F @ P @ F.T + Q)


def rts(x, P, F, Q, x_next, P_next, gain=None, sign=-1):
    """The step back, with a gain that may be wrong."""
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred) if gain is None else gain(P, F, P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next + sign * P_pred) @ G.T


def without_Q(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ np.linalg.inv(F @ P @ F.T)
    return x + G @ (x_next - F @ x), P + G @ (P_next - F @ P @ F.T) @ G.T


def one_sided(x, P, F, Q, x_next, P_next):
    P_pred = F @ P @ F.T + Q
    G = P @ F.T @ np.linalg.inv(P_pred)
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred)


def filtered_not_predicted(x, P, F, Q, x_next, P_next):
    G = P @ F.T @ np.linalg.inv(F @ P @ F.T + Q)
    return x + G @ (x_next - x), P + G @ (P_next - P) @ G.T


@exercise(
    hints=[
        "Three steps: predict step k+1 again from x and P; the gain; then mean and covariance, as in the five lines above.",
        "The prediction is F x with P⁻ = F P Fᵀ + Q. The gain G = P Fᵀ (P⁻)⁻¹ is `np.linalg.solve(P_pred, F @ P).T`.",
        "`return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred) @ G.T`",
    ],
    inputs=steps_back,
    wrong={
        "Q forgotten": (
            without_Q,
            "You left Q out of the prediction. Then all that was wrong at k+1 was wrong at k already, and the filter's "
            "own knowledge of step k is thrown away. P⁻ = F P Fᵀ + Q.",
        ),
        "F for its transpose": (
            lambda *given: rts(*given, gain=lambda P, F, P_pred: P @ F @ np.linalg.inv(P_pred)),
            "Your gain begins with P F. The covariance of now and next is P Fᵀ.",
        ),
        "gain transposed": (
            lambda *given: rts(*given, gain=lambda P, F, P_pred: np.linalg.solve(P_pred, F @ P)),
            "Your gain is transposed: `solve(P_pred, F @ P)` is Gᵀ. Put `.T` behind it.",
        ),
        "without F": (
            lambda *given: rts(*given, gain=lambda P, F, P_pred: P @ np.linalg.inv(P_pred)),
            "Your gain has no F. It is the covariance of now and next, P Fᵀ, that stands before (P⁻)⁻¹.",
        ),
        "sign": (
            lambda *given: rts(*given, sign=1),
            "The mean is right. In the covariance it is P_next minus P⁻: more knowledge makes it smaller.",
        ),
        "one side only": (
            one_sided,
            "The mean is right. In the covariance G stands on both sides: G (P_next − P⁻) Gᵀ. Yours is not symmetric.",
        ),
        "filtered, not predicted": (
            filtered_not_predicted,
            "You compared x_next with x. They belong to different moments: compare it with the prediction F x, P⁻.",
        ),
    },
)
def step_back(x, P, F, Q, x_next, P_next):
    """One step of the RTS smoother: the smoothed mean (n,) and covariance (n, n) at step k."""
    P_pred = F @ P @ F.T + Q
    G = np.linalg.solve(P_pred, F @ P).T
    return x + G @ (x_next - F @ x), P + G @ (P_next - P_pred) @ G.T


@exercise(
    hints=[
        "Two separate opinions about the same thing. What adds up when opinions are fused: covariances, or something else?",
        "Information adds up, and information is the inverse of a covariance. Or lesson 4: K = P (P + P_back)⁻¹.",
        "`return np.linalg.inv(np.linalg.inv(P) + np.linalg.inv(P_back))`",
    ],
    inputs=lambda rng: (covariance(rng, 2), covariance(rng, 2) + np.eye(2)),
    wrong={
        "as published": (
            lambda P, P_back: P / 2,
            "That is still the published idea: half, wherever in the record. P_back decides how much comes from behind.",
        ),
        "sum": (
            lambda P, P_back: P + P_back,
            "You added the covariances: two opinions would be worse than one. It is their inverses that add.",
        ),
        "mean": (
            lambda P, P_back: (P + P_back) / 2,
            "You averaged the covariances. The result must be smaller than either: add their inverses.",
        ),
        "outer inverse forgotten": (
            lambda P, P_back: np.linalg.inv(P) + np.linalg.inv(P_back),
            "That is the information, in 1/m². Invert it once more to have a covariance.",
        ),
        "inverse of the sum": (
            lambda P, P_back: np.linalg.inv(P + P_back),
            "You inverted the sum. It is the other way round: sum the inverses, then invert.",
        ),
        "entry by entry": (
            lambda P, P_back: P * P_back / (P + P_back),
            "Right for a single number. Entry by entry it forgets the tilt, which brought more than half of the gain.",
        ),
        "the smaller": (
            lambda P, P_back: P if np.trace(P) < np.trace(P_back) else P_back,
            "You took the better of the two. Both know something: fuse them.",
        ),
        "difference": (
            lambda P, P_back: np.linalg.inv(np.linalg.inv(P) - np.linalg.inv(P_back)),
            "You took information away. The readings behind add theirs.",
        ),
    },
)
def smoothed_cov(P, P_back):
    """The smoother's covariance, from the forward filter's after zₖ and the backward filter's before zₖ, (2, 2)."""
    gain = np.linalg.solve(P + P_back, P).T
    return gain @ P_back


def corrected_beliefs(rng):
    """Two beliefs about a number, both corrected with the same reading z of variance R."""
    R, z = rng.integers(2, 9) / 2, rng.integers(-8, 9) / 2
    before, back = rng.integers(2, 12, 2) / 2
    x, x_back = rng.integers(-8, 9, 2) / 2
    return x, before * R / (before + R), x_back, back * R / (back + R), z, R


def meet(x, P, x_back, P_back, z, R, taken=1.0):
    """Both beliefs, and z with its weight taken out `taken` times."""
    information = 1 / P + 1 / P_back - taken / R
    return (x / P + x_back / P_back - taken * z / R) / information, 1 / information


@exercise(
    hints=[
        "Think in information: 1/P is how much a belief knows. 1/P + 1/P_back counts z twice. How much did z bring each time?",
        "A reading with variance R brings 1/R. Take it out once. The mean is a sum weighted in the same way: x/P + x_back/P_back − …",
        "`information = 1/P + 1/P_back - 1/R`, then `return (x/P + x_back/P_back - z/R) / information, 1 / information`",
    ],
    inputs=corrected_beliefs,
    wrong={
        "as published": (
            lambda *given: meet(*given, taken=0),
            "Still as published: z sits in both beliefs and counts twice. Take 1/R out of the information, once.",
        ),
        "taken out twice": (
            lambda *given: meet(*given, taken=2),
            "Now z does not count at all: it is in there twice, and you took it out twice. Once is enough.",
        ),
        "added once more": (
            lambda *given: meet(*given, taken=-1),
            "You added z a third time. It is too often in there: subtract 1/R and z/R.",
        ),
        "variance only": (
            lambda *given: (meet(*given, taken=0)[0], meet(*given)[1]),
            "The variance is right. The mean still leans towards z: take z/R out of the weighted sum too.",
        ),
        "mean not renewed": (
            lambda x, P, x_back, P_back, z, R: (
                (x / P + x_back / P_back - z / R) / (1 / P + 1 / P_back),
                1 / (1 / P + 1 / P_back - 1 / R),
            ),
            "The variance is right. Divide the weighted sum by the new information, with 1/R taken out.",
        ),
        "z not weighted": (
            lambda x, P, x_back, P_back, z, R: (
                (x / P + x_back / P_back - z) / (1 / P + 1 / P_back - 1 / R),
                1 / (1 / P + 1 / P_back - 1 / R),
            ),
            "The variance is right. In the sum of the mean z carries the weight 1/R, like the others theirs: take out z/R.",
        ),
        "information": (
            lambda *given: (meet(*given)[0], 1 / meet(*given)[1]),
            "The mean is right. The second number is the information; its inverse is the variance.",
        ),
        "P + R": (
            lambda x, P, x_back, P_back, z, R: meet(x, P, x_back, P_back + R, z, R, taken=0),
            "Adding R to P_back does not undo a reading: it makes the belief vaguer, but its mean still leans on z.",
        ),
    },
)
def count_once(x, P, x_back, P_back, z, R):
    """Mean and variance of two beliefs that have both used z, with z counted once."""
    information = 1 / P + 1 / P_back - 1 / R
    return (x / P + x_back / P_back - z / R) / information, 1 / information
